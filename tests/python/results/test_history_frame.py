"""The history as a DataFrame, and without pandas as a dict."""

import pickle
import subprocess
import sys

import numpy as np
import pytest

import lapilli as lp

pandas = pytest.importorskip("pandas")


def test_the_history_is_a_data_frame_over_time(heated: lp.Result) -> None:
    history = heated.history
    assert isinstance(history, pandas.DataFrame)
    assert history.index.name == "time (s)"
    np.testing.assert_array_equal(history.index, heated.summary.history["time"])
    for name, values in heated.summary.history.items():
        np.testing.assert_array_equal(history[name], values)
    assert history.unit("middle") == "K"
    assert history["middle"].loc[0.0] == history["middle"][0]
    assert history["middle"][-1] == heated.summary.history["middle"][-1]


def test_parts_and_copies_keep_units(heated: lp.Result) -> None:
    late = heated.history[heated.history["time"] > 0.01]
    assert 0 < len(late) < len(heated.history)
    assert late.unit("middle") == "K"
    assert pickle.loads(pickle.dumps(heated.history)).unit("middle") == "K"
    assert (heated.history["middle"] * 2)[-1] == 2 * heated.history["middle"][-1]


def test_without_pandas_it_is_a_dict_of_arrays() -> None:
    code = (
        "import sys; sys.modules['pandas'] = None\n"
        "from lapilli.history import history_of\n"
        "import numpy as np\n"
        "made = history_of({'time': np.arange(2.0)}, {'time': ('s', 'time')})\n"
        "assert type(made).__name__ == 'History' and made['time'][-1] == 1.0\n"
        "try: made.to_pandas()\n"
        "except ValueError as error: print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "pip install pandas" in done.stdout


def test_a_run_does_not_import_pandas() -> None:
    code = (
        "import sys, lapilli as lp\n"
        "assert 'pandas' not in sys.modules and 'pint' not in sys.modules\n"
        "scene = lp.Scene(grid=lp.Grid(lower=(0, 0), upper=(1, 1), cell=0.25),\n"
        "  bodies=[lp.Body(shape=lp.Box(lower=(0, 0), upper=(1, 1)),\n"
        "    material=lp.Thermal(density=1, specific_heat=1, conductivity=1))],\n"
        "  heat=lp.Heat(), time=lp.Time(end=0.01))\n"
        "lp.run(scene, progress=False)\n"
        "assert not {'pandas', 'xarray', 'matplotlib', 'IPython'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
