"""tools/verify.py runs the programs and nothing beside them, and goes on after a failure."""

import importlib.util
import sys
from pathlib import Path

TOOL = Path(__file__).resolve().parents[2] / "tools" / "verify.py"
spec = importlib.util.spec_from_file_location("verify_tool", TOOL)
assert spec is not None
assert spec.loader is not None
verify = importlib.util.module_from_spec(spec)
spec.loader.exec_module(verify)


def test_only_programs_are_run(tmp_path):
    folder = tmp_path / "tests" / "cpp"
    folder.mkdir(parents=True)
    for name in ("test_core", "test_scene"):
        (folder / name).write_text("#!/bin/sh\n")
        (folder / name).chmod(0o755)
    (folder / "test_core_include-b12d07c.cmake").write_text("add_test()\n")
    found = verify.commands("cpp", tmp_path, 1)
    assert list(found) == ["slow test_core", "slow test_scene"]
    assert found["slow test_core"] == [str(folder / "test_core"), "[slow]"]


def test_a_failure_does_not_hide_what_follows(tmp_path, capfd):
    mark = tmp_path / "ran"
    fails = [sys.executable, "-c", "raise SystemExit(3)"]
    writes = [sys.executable, "-c", f"open({str(mark)!r}, 'w')"]
    assert not verify.run_all({"first": fails, "second": writes})
    assert mark.exists()
    told = capfd.readouterr().out.splitlines()
    assert told[1].startswith("FAILED")
    assert told[1].endswith("first")
    assert told[2].startswith("ok")
    assert told[2].endswith("second")
