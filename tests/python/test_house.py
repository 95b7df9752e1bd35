"""The measure of the house that `make house` prints, held where it is."""

import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import house  # noqa: E402

sys.path.remove(str(ROOT / "tools"))


def test_nothing_goes_in_circles() -> None:
    assert not house.circles(house.include_graph())
    assert not house.circles(house.folder_graph())
    assert not house.circles(house.import_graph())


def test_a_circle_would_be_seen() -> None:
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}}
    assert house.circles(graph) == [["b", "c"]]
    assert len(house.include_graph()["scene/build.cpp"]) > 5
    assert "lapilli.frames" in house.import_graph()["lapilli.result"]


def test_from_scene_file_to_kernel_is_not_far() -> None:
    assert len(house.longest_chain(house.folder_graph(), "scene")) <= 6


def test_files_and_functions_stay_short() -> None:
    """Four loops of kernels and a docstring are longer; nothing more."""
    assert not house.long_files()
    assert len(house.long_functions()) <= 5


def test_functions_are_measured() -> None:
    text = """
namespace a {
struct S {
  int one() const { return 1; }
};
template <class T>
int two(T x,
        T y) {  // (
  if (x) {
    return '{';
  }
  return y;
}
}
"""
    assert list(house.cpp_functions(text)) == [(1, "one"), (8, "two")]
