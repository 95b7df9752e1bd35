"""What the fields of frames and results mean."""

from __future__ import annotations

from typing import NamedTuple


class PointField(NamedTuple):
    """A field: one value, vector or tensor for each point."""

    name: str
    unit: str
    form: str  # "scalar", "vector", "tensor", "index"
    given_by: str  # the section of the scene that has it
    meaning: str


HEAT, DYNAMICS, STATIC = "[heat]", "[dynamics]", "[quasi_static]"
PD_HEAT, PD_FLOW = "[peridynamics.heat]", "[peridynamics.flow]"
SOLIDS = f"{DYNAMICS}, {STATIC}"

FIELDS = (
    PointField("position", "m", "vector", "always", "place of the point now"),
    PointField("id", "", "index", "always", "number of the point, the same in every frame"),
    PointField(
        "body", "", "index", "always", "number of the body, from 0; walls come after the bodies"
    ),
    PointField("volume", "m^3", "scalar", "always", "volume now; m^2 in two dimensions, m in one"),
    PointField("temperature", "K", "scalar", f"{HEAT}, {PD_HEAT}", "temperature at the point"),
    PointField(
        "temperature_carried",
        "K",
        "scalar",
        HEAT,
        "temperature that the point carries from step to step, where the transfer has one",
    ),
    PointField("heat_flux", "W/m^2", "vector", HEAT, "heat flux density by conduction"),
    PointField(
        "liquid_fraction",
        "",
        "scalar",
        HEAT,
        "share that has melted, with latent heat",
    ),
    PointField(
        "velocity",
        "m/s",
        "vector",
        f"{DYNAMICS}, {PD_FLOW}",
        "velocity of the point; of points in a fluid's walls that which the wall shows",
    ),
    PointField("displacement", "m", "vector", STATIC, "displacement since the start of the run"),
    PointField(
        "stress", "Pa", "tensor", SOLIDS, "Cauchy stress, tension positive: xx, yy, zz, xy, yz, xz"
    ),
    PointField("density", "kg/m^3", "scalar", f"{DYNAMICS}, {PD_FLOW}", "density now"),
    PointField(
        "plastic_strain",
        "1",
        "scalar",
        SOLIDS,
        "equivalent plastic strain so far; of drucker_prager, von_mises and tabulated_mohr_coulomb",
    ),
    PointField(
        "plastic_compaction",
        "1",
        "scalar",
        SOLIDS,
        "plastic volume strain so far, positive in compaction; of modified_cam_clay",
    ),
    PointField("pressure", "Pa", "scalar", PD_FLOW, "pressure of the fluid, compression positive"),
    PointField(
        "wall_heat_flux",
        "W/m^2",
        "scalar",
        PD_HEAT,
        "heat from walls into the point, over the area that it shares with them",
    ),
    PointField(
        "wall_area",
        "m^2",
        "scalar",
        PD_HEAT,
        "area that the point shares with walls; m in two dimensions, a number in one",
    ),
)


def fields_as_markdown() -> str:
    """The fields as a Markdown table."""
    rows = ["| field | unit | form | given by | meaning |", "|---|---|---|---|---|"]
    rows += [
        f"| `{one.name}` | {one.unit} | {one.form} | {one.given_by} | {one.meaning} |"
        for one in FIELDS
    ]
    return "# Fields of points\n\n" + "\n".join(rows) + "\n"
