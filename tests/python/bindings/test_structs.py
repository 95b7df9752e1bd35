"""Classes bound from described structs: keyword-only, checked, comparable, copyable."""

import copy
import math
import pickle

import pytest

import lapilli as lp


def test_arguments_become_attributes(steel: lp.Thermal) -> None:
    assert (steel.density, steel.specific_heat, steel.conductivity) == (7800.0, 460.0, 50.0)


def test_repr_reads_as_the_call_that_makes_it(steel: lp.Thermal) -> None:
    assert repr(steel) == "Thermal(density=7800.0, specific_heat=460.0, conductivity=50.0)"
    assert eval(repr(steel), {"Thermal": lp.Thermal}) == steel


@pytest.mark.parametrize(
    "duplicate", [copy.copy, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))]
)
def test_copies_are_equal_and_independent(steel: lp.Thermal, duplicate) -> None:
    other = duplicate(steel)
    assert other == steel
    other.density = 1.0
    assert other != steel
    assert steel.density == 7800.0


def test_an_unknown_keyword_names_the_nearest_one() -> None:
    with pytest.raises(TypeError, match="unknown key 'densty'; did you mean 'density'"):
        lp.Thermal(densty=1, specific_heat=1, conductivity=1)


def test_an_unknown_attribute_is_refused(steel: lp.Thermal) -> None:
    with pytest.raises(AttributeError, match="did you mean 'conductivity'"):
        steel.conductivty = 1


def test_positional_arguments_are_refused() -> None:
    with pytest.raises(TypeError, match="keyword arguments only"):
        lp.Thermal(1, 2, 3)


def test_a_missing_argument_says_what_it_is() -> None:
    with pytest.raises(TypeError, match="needs specific_heat: heat per mass and kelvin"):
        lp.Thermal(density=1, conductivity=1)


@pytest.mark.parametrize("wrong", [-1.0, 0.0, math.nan, math.inf])
def test_a_wrong_value_names_range_unit_and_value(steel: lp.Thermal, wrong: float) -> None:
    with pytest.raises(ValueError, match=r"Thermal: density must be above 0 \(kg/m\^3\), got"):
        steel.density = wrong
    assert steel.density == 7800.0


@pytest.mark.parametrize("wrong", ["7800", None, [1.0], True, 1j])
def test_a_wrong_type_is_named(steel: lp.Thermal, wrong: object) -> None:
    with pytest.raises(TypeError, match="density must be a number, got"):
        steel.density = wrong


def test_a_tensor_is_a_number_or_six(steel: lp.Thermal) -> None:
    steel.conductivity = [1, 2, 3, 0.1, 0.2, 0.3]
    assert steel.conductivity == (1.0, 2.0, 3.0, 0.1, 0.2, 0.3)
    with pytest.raises(TypeError, match="a list of 6 numbers"):
        steel.conductivity = [1, 2, 3]


def test_the_docstring_lists_units_and_ranges() -> None:
    text = lp.Thermal.__doc__
    assert text is not None
    assert "density : float, kg/m^3, required\n    mass per undeformed volume; above 0" in text


def test_a_table_is_linear_between_its_times_and_constant_outside() -> None:
    table = lp.Table(times=[0, 2], values=[10, 20])
    assert [table.at(t) for t in (-1, 0, 1, 2, 3)] == [10, 10, 15, 20, 20]
    assert pickle.loads(pickle.dumps(table)) == table


@pytest.mark.parametrize(
    ("times", "values", "says"),
    [
        ([], [], "without times"),
        ([0, 1], [1], "got 1 and 2"),
        ([1, 0], [1, 2], "times that increase"),
        ([0, 0, 0], [1, 2, 3], "two equal times, not three, are a jump"),
    ],
)
def test_a_table_that_is_none_is_refused(times, values, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        lp.Table(times=times, values=values)
