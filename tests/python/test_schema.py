"""The JSON Schema of scene files: complete, and true to what the reader takes."""

import json
from pathlib import Path
from typing import Any

import pytest

from lapilli import _core, examples

try:
    import tomllib
except ImportError:  # Python 3.10
    tomllib = None  # type: ignore[assignment]

SCHEMA: dict[str, Any] = json.loads(_core.scene_schema())


def mistakes(value: Any, schema: dict[str, Any], path: str) -> list[str]:
    """What draft 7 would say, of the words that the schema uses."""
    if "$ref" in schema:
        return mistakes(value, SCHEMA["definitions"][schema["$ref"].rpartition("/")[2]], path)
    if "anyOf" in schema:
        found = [mistakes(value, one, path) for one in schema["anyOf"]]
        return [] if not all(found) else min(found, key=len)
    wrong = [text for one in schema.get("allOf", []) for text in mistakes(value, one, path)]
    if "const" in schema and value != schema["const"]:
        wrong.append(f"{path} is not {schema['const']}")
    if "enum" in schema and value not in schema["enum"]:
        wrong.append(f"{path} is none of {schema['enum']}")
    kinds = {"object": dict, "array": list, "string": str, "boolean": bool}
    kind = schema.get("type")
    if kind in kinds and not isinstance(value, kinds[kind]):
        return [*wrong, f"{path} is no {kind}"]
    if kind in {"number", "integer"}:
        if isinstance(value, bool) or not isinstance(value, int | float):
            return [*wrong, f"{path} is no number"]
        low, open_low = schema.get("minimum"), schema.get("exclusiveMinimum")
        if (low is not None and value < low) or (open_low is not None and value <= open_low):
            wrong.append(f"{path} is too small")
        if value > schema.get("maximum", float("inf")):
            wrong.append(f"{path} is too large")
    if kind == "array":
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            wrong.append(f"{path} has {len(value)} entries")
        for k, one in enumerate(value):
            wrong += mistakes(one, schema["items"], f"{path}[{k}]")
    if kind == "object" and "properties" in schema:  # else any keys
        known = schema["properties"]
        wrong += [
            f"{path}.{name} is missing" for name in schema.get("required", []) if name not in value
        ]
        wrong += [f"{path}.{name} is unknown" for name in value if name not in known]
        for name in value.keys() & known.keys():
            wrong += mistakes(value[name], known[name], f"{path}.{name}")
    return wrong


@pytest.mark.skipif(tomllib is None, reason="reads TOML with the standard library")
@pytest.mark.parametrize("name", examples.names())
def test_every_example_fits(name: str) -> None:
    scene = tomllib.loads(examples.path(name).read_text())
    assert mistakes(scene, SCHEMA, "scene") == []


@pytest.mark.skipif(tomllib is None, reason="reads TOML with the standard library")
@pytest.mark.parametrize(
    ("before", "after", "says"),
    [
        ("cell = ", "cel = ", "cel is unknown"),
        ("cell = ", "cell = -", "too small"),
        ('kind = "annulus"', 'kind = "anulus"', "bodies"),
        ("inner = 1.0", 'inner = "1"', "bodies"),
        ("[time]", "[tim]", "time is missing"),
    ],
)
def test_a_mistake_does_not_fit(before: str, after: str, says: str) -> None:
    text = examples.path("vhfm/ring").read_text()
    assert before in text
    wrong = mistakes(tomllib.loads(text.replace(before, after, 1)), SCHEMA, "scene")
    assert any(says in one for one in wrong), wrong


def test_the_schema_speaks_of_units_and_defaults() -> None:
    grid = SCHEMA["definitions"]["grid"]
    assert grid["properties"]["cell"]["exclusiveMinimum"] == 0
    assert "m" in grid["properties"]["cell"]["description"]
    assert grid["properties"]["shape_function"]["default"] == "gimp"
    assert grid["required"] == ["lower", "upper", "cell"]
    assert "shape" in json.dumps(SCHEMA)


def test_it_can_be_written(tmp_path: Path) -> None:
    from lapilli.cli import main

    assert main(["schema", "--save", str(tmp_path / "scene.json")]) == 0
    assert json.loads((tmp_path / "scene.json").read_text()) == SCHEMA
