"""lapilli study: which cases, what is gathered, failures, resuming, tables, pictures."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest

import lapilli as lp
from lapilli.cli import main
from lapilli.study import (
    InProcess,
    LocalPool,
    Range,
    cases_in,
    minimize,
    parse_values,
    study,
)
from lapilli.study.quantity import Quantity, reduced
from lapilli.study.sampling import cases_of

AMBIENT, COEFFICIENT = "heat.boundaries.0.ambient", "heat.boundaries.0.coefficient"


@pytest.fixture
def quick(ring: lp.Scene) -> lp.Scene:
    """Milliseconds a case."""
    return ring.set("grid.cell=1")


def test_values_are_lists_or_ranges() -> None:
    assert parse_values("a.b=1,2") == ("a.b", ["1", "2"])
    assert parse_values("a=20..40") == ("a", Range(20, 40))
    assert parse_values("a=1e-3..1 log") == ("a", Range(1e-3, 1, True))
    assert Range(1, 100, True).even(3) == [1, 10, 100]
    for wrong in ("a=2..1", "a=1..x", "=1..2", "a=-1..1 log", "a=1..2 lin", "a=1..inf"):
        with pytest.raises(ValueError, match=r"range|path=low\.\.high"):
            parse_values(wrong)


def test_samples_fill_the_ranges_and_repeat_for_a_seed() -> None:
    vary = {"a": Range(10, 20), "b": Range(1e-3, 1, True), "c": ["x", "y"]}
    for sample in ("latin-hypercube", "sobol"):
        cases = cases_of(vary, sample, 64, seed=3)
        assert cases == cases_of(vary, sample, 64, seed=3)
        assert cases != cases_of(vary, sample, 64, seed=4)
        a, b, c = zip(*(dict(one.changes).values() for one in cases), strict=True)
        # one in each 64th of the range, evenly or by its logarithm; both words as often
        assert len({int((float(x) - 10) / 10 * 64 - 1e-9) for x in a}) == 64
        assert len({int((math.log10(float(x)) + 3) / 3 * 64 - 1e-9) for x in b}) >= 63
        assert c.count("x") == 32
    assert len(cases_of(vary, "grid", 5)) == 50
    assert len(cases_of(vary, "sobol", 50)) == 50  # no power of two
    with pytest.raises(ValueError, match="did you mean 'sobol'"):
        cases_of(vary, "sobel", 8)


def test_quantities_reduce_over_time_and_space() -> None:
    series = [1.0, 5.0, math.nan, 3.0]
    found = {name: reduced(name, series) for name in ("last", "max", "min", "mean", "range")}
    assert found == {"last": 3, "max": 5, "min": 1, "mean": 3, "range": 4}
    assert Quantity.parse("-max(a/b)") == Quantity("a/b", "max", -1)
    assert str(Quantity.parse("-max(a/b)")) == "-max(a/b)"
    with pytest.raises(ValueError, match="did you mean 'mean'"):
        Quantity.parse("meen(a)")


def test_every_combination_with_what_is_asked(quick: lp.Scene) -> None:
    names = ["temperature", "temperature/largest", "mean(temperature/largest)"]
    found = study(quick, {AMBIENT: [1, 2], COEFFICIENT: [1, 4]}, names, runner=InProcess())
    assert len(found) == 4
    assert found.quantities == names
    first, *_, last = found.outcomes
    alone = lp.run(quick.set(f"{AMBIENT}=2").set(f"{COEFFICIENT}=4"), progress=False)
    mean = np.average(alone["temperature"], weights=alone["volume"])
    assert last.numbers["temperature"] == pytest.approx(mean, rel=1e-12)
    assert last.numbers["temperature/largest"] == alone.history["temperature/largest"][-1]
    middle = last.numbers["mean(temperature/largest)"]
    assert 0 < middle < last.numbers["temperature/largest"]
    # heat conduction is linear in the surroundings
    twice = found.outcomes[2].numbers["temperature"] / first.numbers["temperature"]
    assert twice == pytest.approx(2, rel=1e-12)


def test_one_case_of_many_that_fails_keeps_its_reason(quick: lp.Scene, tmp_path: Path) -> None:
    cases = tmp_path / "cases.csv"
    rows = [["grid.cell", AMBIENT, "time.step"]] + [["1", str(k), ""] for k in range(20)]
    rows[7] = ["-1", "7", ""]  # out of its range
    rows[9] = ["1", "9", "1e3"]  # beyond the stability limit
    with cases.open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    found = study(quick, cases=cases_in(cases), runner=InProcess())
    assert len(found.failed) == 2
    assert [k for k, one in enumerate(found.outcomes) if one.reason] == [6, 8]
    assert "above 0" in found.outcomes[6].reason
    assert "limit" in found.outcomes[8].reason
    assert found.outcomes[8].status == "refused"
    assert all(one.numbers["temperature/largest"] >= 0 for one in found.finished)


def test_mistakes_of_the_whole_study_are_errors(quick: lp.Scene, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="did you mean 'cell'"):
        study(quick, {"grid.cel": [1, 2]}, runner=InProcess())
    with pytest.raises(ValueError, match="did you mean 'temperature'"):
        study(quick, {"grid.cell": [1]}, ["temperatura"], runner=InProcess())
    with pytest.raises(ValueError, match="nothing to vary"):
        study(quick, {}, runner=InProcess())
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("grid.cell,time.end\n1\n")
    with pytest.raises(ValueError, match="line 2: 1 values for 2 names"):
        cases_in(wrong)
    wrong.write_text("grid.cell\n")
    with pytest.raises(ValueError, match="first line must name members"):
        cases_in(wrong)


def test_a_stopped_study_goes_on(quick: lp.Scene, tmp_path: Path) -> None:
    store, ran = tmp_path / "s.jsonl", []

    class Stop(Exception):
        pass

    def stop_after_two(outcome: object, done: int, all_of_them: int) -> None:
        ran.append(outcome)
        if done == 2:
            raise Stop

    vary = {AMBIENT: [1, 2, 3, 4]}
    with pytest.raises(Stop):
        study(quick, vary, store=store, runner=InProcess(), report=stop_after_two)
    rest = study(quick, vary, store=store, runner=InProcess(), report=lambda *a: ran.append(a[0]))
    assert len(ran) == 4
    assert len(rest.finished) == 4
    # more values later: only those are run; another scene shares nothing
    study(quick, {AMBIENT: [1, 2, 3, 4, 5]}, store=store, runner=InProcess(),
          report=lambda *a: ran.append(a[0]))  # fmt: skip
    assert len(ran) == 5
    study(quick.set("time.end=0.5"), {AMBIENT: [1]}, store=store, runner=InProcess(),
          report=lambda *a: ran.append(a[0]))  # fmt: skip
    assert len(ran) == 6


def test_results_do_not_depend_on_workers_or_threads(quick: lp.Scene) -> None:
    vary = {AMBIENT: Range(1, 2), "grid.cell": Range(0.5, 1)}
    study_of = {"sample": "latin-hypercube", "samples": 6, "seed": 1}
    one = study(quick, vary, **study_of, runner=LocalPool(1))
    two = study(quick, vary, **study_of, runner=LocalPool(2), threads=2)
    assert [case.setting for case in one.outcomes] == [case.setting for case in two.outcomes]
    assert [case.numbers for case in one.outcomes] == [case.numbers for case in two.outcomes]
    assert one.notes == two.notes != []  # cells were made to fit


def test_tables(quick: lp.Scene, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    pytest.importorskip("pyarrow")
    vary = {AMBIENT: [1, 2, 3], "heat.transfer": ["nodal", "flip"]}
    found = study(quick, vary, ["temperature", "temperature/largest"], runner=InProcess())
    frame = found.to_pandas()
    assert list(frame.columns[:4]) == [*vary, "temperature", "temperature/largest"]
    assert frame[AMBIENT].tolist() == [1, 1, 2, 2, 3, 3]
    found.to_parquet(tmp_path / "x.parquet")
    again = pandas.read_parquet(tmp_path / "x.parquet")
    assert again["temperature"].tolist() == frame["temperature"].tolist()
    found.to_csv(tmp_path / "x.csv")
    with (tmp_path / "x.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["temperature"]) for row in rows] == frame["temperature"].tolist()
    data = found.to_xarray()
    assert dict(data.sizes) == {AMBIENT: 3, "heat.transfer": 2}
    assert data["temperature"].attrs["units"] == "K"
    at = data["temperature"].sel({AMBIENT: 2, "heat.transfer": "flip"}).item()
    assert at == found.outcomes[3].numbers["temperature"]
    # cases that are no grid are numbered
    some = study(quick, {AMBIENT: Range(1, 2), COEFFICIENT: Range(1, 2)}, ["temperature"],
                 sample="sobol", samples=4, runner=InProcess())  # fmt: skip
    assert dict(some.to_xarray().sizes) == {"case": 4}


def test_the_command_writes_tables_and_pictures(
    quick: lp.Scene, capsys: pytest.CaptureFixture[str]
) -> None:
    quick.save("ring.toml")
    words = ["study", "ring.toml", "--vary", f"{AMBIENT}=1..2", "--vary", f"{COEFFICIENT}=1,2"]
    assert main([*words, "--quantity", "temperature", "--samples", "3", "--parquet"]) == 0
    shown = capsys.readouterr()
    assert "[6/6]" in shown.err
    for kind in ("-effects.png", "-pairs.png", "-response.png", ".csv", ".parquet", ".jsonl"):
        assert Path(f"ring-study{kind}").stat().st_size > 100, kind
    assert main([*words, "--samples", "3", "--quantity", "temperature", "--json", "-q"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row[AMBIENT] for row in rows] == [1, 1, 1.5, 1.5, 2, 2]
    assert {row["status"] for row in rows} == {"finished"}


@pytest.mark.parametrize(
    ("words", "code", "says"),
    [
        (["--vary", "grid.cel=1,2"], 2, "did you mean 'cell'"),
        (["--vary", "time.step=1e3,1e4"], 1, "no case finished: refused:"),
        (["--vary", "grid.cell=1", "--vary", "grid.cell=2"], 2, "twice"),
        ([], 2, "either --vary or --cases"),
        (["--cases", "nosuch.csv"], 2, "nosuch.csv"),
        (["--vary", "grid.cell=1", "--data", "x.csv"], 2, "--minimize"),
    ],
)
def test_mistakes_of_the_command(
    quick: lp.Scene, words: list[str], code: int, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    quick.save("ring.toml")
    assert main(["study", "ring.toml", *words]) == code
    assert says in capsys.readouterr().err


def test_minimize_finds_what_made_the_data(quick: lp.Scene, tmp_path: Path) -> None:
    """Calibration: the largest temperature in time tells the coefficient it was made with, 2.5,
    within 5 % after 30 cases (2 % measured), the same for any number of workers."""
    pytest.importorskip("optuna")
    made = quick.set(f"{COEFFICIENT}=2.5")
    made.output.history_every = 0.1
    history = lp.run(made, progress=False).history
    data = tmp_path / "data.csv"
    lines = zip(history["time"], history["temperature/largest"], strict=True)
    data.write_text("time,measured\n" + "".join(f"{t},{v}\n" for t, v in lines))
    vary = {COEFFICIENT: Range(0.1, 10, True)}
    search = {"quantity": "temperature/largest", "data": data, "samples": 30, "seed": 2}
    found = minimize(quick, vary, **search, runner=InProcess(), store=tmp_path / "s.jsonl")
    best = found.best("misfit(temperature/largest)")
    assert float(dict(best.setting.changes)[COEFFICIENT]) == pytest.approx(2.5, rel=0.05)
    ran = []
    again = minimize(quick, vary, **search, runner=LocalPool(2), store=tmp_path / "s.jsonl",
                     report=lambda *a: ran.append(a))  # fmt: skip
    assert ran == []  # all of it was kept, and the same cases were asked for
    data.write_text("time,measured\n1,0.5\n")  # other data, another study
    minimize(quick, vary, **{**search, "samples": 1}, runner=InProcess(),
             store=tmp_path / "s.jsonl", report=lambda *a: ran.append(a))  # fmt: skip
    assert len(ran) == 1
    assert again.best("misfit(temperature/largest)") == best


def test_minimize_a_quantity_of_words_and_failures(quick: lp.Scene) -> None:
    pytest.importorskip("optuna")
    vary = {AMBIENT: [1, 3, 2], "time.step": ["auto", "1e3"]}
    found = minimize(quick, vary, "-temperature", samples=12, runner=InProcess())
    assert dict(found.best("-temperature").setting.changes)[AMBIENT] == "3"
    assert found.failed  # steps beyond the limit were tried, and stayed away from
    with pytest.raises(ValueError, match="nothing to vary"):
        minimize(quick, {}, "temperature", runner=InProcess())
