"""What notebooks show: HTML of scenes and results, one bar of progress."""

import sys
from html.parser import HTMLParser
from types import SimpleNamespace

import pytest

import lapilli as lp
from lapilli.progress import progress_bar


class Balanced(HTMLParser):
    """Keeps the tags that are open, and the texts."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.texts: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def read(shown: object) -> str:
    page = Balanced(shown._repr_html_())  # type: ignore[attr-defined]
    assert page.open == []
    return " ".join(page.texts)


def test_scene_result_and_frames_have_html(falling: lp.Result, heated: lp.Result) -> None:
    assert "finished at 0.05 s" in read(falling)
    assert "residual" in read(heated)
    assert "velocity m/s" in read(falling.frames)
    scene = lp.Scene.parse(falling.record["scene"]).set("title", "<b>two & more")
    text = read(scene)
    assert "<b>two & more" in text
    assert "cells of 0.1 m" in text
    assert "as TOML" in text
    with_function = scene.set("bodies[0].velocity", (0, 0))
    with_function.bodies[0].temperature = lambda x, s, t: 1.0
    assert "as Python" in read(with_function)


def test_a_table_in_time_and_a_study_have_html() -> None:
    from lapilli.study.settings import Setting
    from lapilli.study.table import Row, Table

    text = read(lp.Table([0, 1], [2, 3]))
    assert "0.0 2.0 1.0 3.0" in text
    setting = Setting((("grid.cell", "0.1"),))
    row = Row(setting, 0.01, 0.02, 1.0, 0.1, 10, 100, 1, 1, True, "")
    failed = Row(setting, None, None, None, None, None, None, None, 1, False, "refused <x>")
    text = read(Table([row, failed], "temperature", "K"))
    assert "RMS error (K)" in text
    assert "refused <x>" in text


def test_progress_in_a_notebook_is_one_output(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[str] = []
    handle = SimpleNamespace(update=shown.append)

    def display(first: str, display_id: bool) -> SimpleNamespace:
        assert display_id
        shown.append(first)
        return handle

    shell = SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setitem(sys.modules, "IPython.display", SimpleNamespace(HTML=str, display=display))
    now = SimpleNamespace(fraction=0.5)
    monkeypatch.setattr("lapilli.progress.progress_text", lambda now: "t = 1 s < 2 s")
    with progress_bar() as show:
        assert show is not None
        show(now)
    assert shown[0] == "building the scene"
    assert 'value="0.5000"' in shown[1]
    assert "50 % t = 1 s &lt; 2 s" in shown[1]
