"""The report of a run: one page, complete, that works in a browser."""

import json
import re
import shutil
from pathlib import Path

import pytest

import lapilli as lp
from lapilli.report import write_report

pytest.importorskip("matplotlib")


@pytest.fixture(scope="module")
def page(falling: lp.Result, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_report(falling.output, tmp_path_factory.mktemp("report") / "block.html")


def test_the_page_needs_nothing_else(page: Path) -> None:
    text = page.read_text()
    assert not re.search(r"""(src|href)\s*=\s*["'](?!data:)""", text)
    assert "@import" not in text
    assert "url(" not in text
    named = set(re.findall(r"https?://[^\s\"'<]+", text))
    assert named == {"http://www.w3.org/2000/svg"}  # the name of a language, never loaded


def test_the_page_says_what_was_done(page: Path, falling: lp.Result) -> None:
    text = page.read_text()
    for said in (
        "two blocks",
        "finished at 0.05 s",
        "explicit dynamics",  # modelled
        "pore pressure",  # not modelled
        "residual (relative)",
        "processor time",
        falling.record["compiler"],
        falling.record["kernel_set"],
        "youngs_modulus",
    ):
        assert said in text, said
    data = json.loads(re.search(r'id="data">(.*?)</script>', text)[1])
    drawn = {one["field"]: one for one in data["pictures"]}
    assert drawn["velocity"]["times"] == falling.times.tolist()
    assert len(set(drawn["velocity"]["images"])) == len(falling.times)
    names = [curve["name"] for chart in data["charts"] for curve in chart["curves"]]
    assert "velocity/largest" in names


def test_fields_and_numbers_of_pictures_are_chosen(falling: lp.Result, tmp_path: Path) -> None:
    page = write_report(falling.frames, tmp_path / "r.html", fields=["stress.yy"], pictures=2)
    data = json.loads(re.search(r'id="data">(.*?)</script>', page.read_text())[1])
    (drawn,) = data["pictures"]
    assert drawn["field"] == "stress.yy"
    assert drawn["times"] == [falling.times[0], falling.times[-1]]


def test_a_report_without_a_record_says_what_is_missing(falling: lp.Result, tmp_path: Path) -> None:
    for file in falling.output.parent.glob("block.vtkhdf*"):
        shutil.copy(file, tmp_path)
    with pytest.raises(ValueError, match=r"block\.json is missing"):
        write_report(tmp_path / "block.vtkhdf")


def test_pages_of_others_are_not_written_over(falling: lp.Result, tmp_path: Path) -> None:
    for file in falling.output.parent.glob("block.*"):
        shutil.copy(file, tmp_path)
    page = tmp_path / "block.html"
    page.write_text("<title>notes of mine</title>")
    with pytest.raises(ValueError, match=r"block\.html is no page that lapilli wrote"):
        write_report(tmp_path / "block.vtkhdf", pictures=1)
    assert page.read_text() == "<title>notes of mine</title>"
    assert write_report(tmp_path / "block.vtkhdf", page, pictures=1) == page  # asked for by name
    assert write_report(tmp_path / "block.vtkhdf", pictures=1) == page  # its like


def test_warnings_and_hostile_titles_are_text(falling: lp.Result, tmp_path: Path) -> None:
    for file in falling.output.parent.glob("block.*"):
        shutil.copy(file, tmp_path)
    record = json.loads((tmp_path / "block.json").read_text())
    record["settings"]["title"] = "</script><b>bad"
    record["notes"] = ["<i>heat.theta</i> has no effect"]
    record["physics"][0]["warnings"] = ["strains beyond 2 %"]
    del record["note_codes"], record["physics"][0]["warning_codes"]  # as of earlier versions
    (tmp_path / "block.json").write_text(json.dumps(record))
    text = write_report(tmp_path / "block.vtkhdf", pictures=0).read_text()
    assert "</script><b>bad" not in text
    assert "note: &lt;i&gt;heat.theta" in text
    assert "warning: strains beyond 2 %" in text


@pytest.fixture(scope="module")
def browser():
    """Chromium without a window, where it and playwright are installed."""
    playwright = pytest.importorskip("playwright.sync_api")
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if program is None:
        pytest.skip("needs chromium")
    with playwright.sync_playwright() as running:
        started = running.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture(scope="module")
def staged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a run whose later stages have columns that the first has not."""
    folder = tmp_path_factory.mktemp("staged")
    soil = lp.Elastic(density=1000, youngs_modulus=1e6, poissons_ratio=0.3)
    scene = lp.Scene(
        grid=lp.Grid(lower=(0, 0), upper=(2, 1), cell=0.1),
        bodies=[
            lp.Body(name=name, shape=lp.Box(lower=(x, 0), upper=(x + 0.5, 0.5)), material=soil)
            for name, x in (("dam", 0.2), ("spoil", 1.2))
        ],
        dynamics=lp.Dynamics(gravity=(0, -10), grid_boundaries=[lp.NoSlipBoundary(face="y_lower")]),
        time=lp.Time(end=0.02),
        stages=[lp.Stage(name="dug", end=0.04, remove=["spoil"])],
    )
    lp.run(scene, folder / "dam.vtkhdf", every=0.005, progress=False)
    return write_report(folder / "dam.vtkhdf", pictures=2)


def test_columns_of_later_stages_leave_charts_whole(staged: Path) -> None:
    """What a stage does not have is empty, in the words of JSON: numbers or null."""
    data = json.loads(re.search(r'id="data">(.*?)</script>', staged.read_text())[1])
    curves = [curve for chart in data["charts"] for curve in chart["curves"]]
    late = [curve for curve in curves if "stage_dug" in curve["name"]]
    assert len(late) >= 1
    for curve in curves:
        assert all(value is None or isinstance(value, float) for value in curve["values"])
    for curve in late:
        assert curve["values"][0] is None
        assert curve["values"][-1] is not None


def test_stages_are_part_of_what_was_modelled(staged: Path) -> None:
    text = staged.read_text()
    assert "stage dug" in text
    assert "0.02 to 0.04 s; without spoil" in text


def test_units_are_set_as_they_are_printed(staged: Path) -> None:
    text = staged.read_text()
    data = json.loads(re.search(r'id="data">(.*?)</script>', text)[1])
    assert "kg/m³" in {chart["unit"] for chart in data["charts"]}
    assert not any("^" in chart["unit"] for chart in data["charts"])


@pytest.mark.slow
def test_a_browser_draws_every_chart(browser, staged: Path) -> None:
    """Each has a curve that goes from side to side, and numbers on its axis."""
    shown = browser.new_page()
    shown.set_default_timeout(120_000)
    shown.goto(staged.as_uri())
    charts = shown.locator(".chart")
    assert charts.count() > 5
    for chart in charts.all():
        drawn = [path.get_attribute("d") for path in chart.locator("path").all()]
        assert any(d.count("L") >= 3 and "NaN" not in d for d in drawn), chart.inner_text()
        ticks = chart.locator("text[text-anchor=end]").all_text_contents()
        assert sum(bool(one) for one in ticks) >= 2, chart.inner_text()


@pytest.mark.slow
def test_a_browser_steps_through_time_and_zooms(browser, page: Path, falling: lp.Result) -> None:
    shown = browser.new_page(viewport={"width": 1100, "height": 900})
    shown.set_default_timeout(120_000)  # of a busy machine
    wrong: list[str] = []
    shown.on("console", lambda m: wrong.append(m.text) if m.type in ("error", "warning") else None)
    shown.on("pageerror", lambda error: wrong.append(str(error)))
    shown.on(
        "request", lambda r: None if r.url.startswith(("file:", "data:")) else wrong.append(r.url)
    )
    shown.goto(page.as_uri())
    time = shown.locator(".time")
    assert time.inner_text() == "t = 0.05 s"
    before = shown.locator("img").get_attribute("src")
    shown.get_by_label("next frame").click()  # from the last to the first
    assert time.inner_text() == "t = 0 s"
    assert shown.locator("img").get_attribute("src") != before
    shown.get_by_label("time").fill("2")
    assert time.inner_text() == f"t = {falling.times[2]:.5g} s"
    shown.get_by_label("field").select_option("1")
    chart = shown.locator(".chart svg").first
    path = chart.locator("path").first
    whole = path.get_attribute("d")
    chart.scroll_into_view_if_needed()
    box = chart.bounding_box()
    assert box is not None
    y = box["y"] + box["height"] / 2
    shown.mouse.move(box["x"] + 0.3 * box["width"], y)
    shown.mouse.down()
    shown.mouse.move(box["x"] + 0.8 * box["width"], y)
    shown.mouse.up()
    assert path.get_attribute("d") != whole
    assert shown.locator(".readout").first.inner_text().startswith("t = ")
    chart.dblclick()
    assert path.get_attribute("d") == whole
    curves = chart.locator("path").count()
    shown.locator(".chart").first.locator("button").first.click()
    assert chart.locator("path").count() == curves - 1
    assert wrong == []
