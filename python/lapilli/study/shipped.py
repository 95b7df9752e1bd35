"""The package's own references, set up from a scene with one body and constant data.

| name | body | method |
|---|---|---|
| radial | 1D box, disk, annulus, sphere or hollow sphere | Galerkin in r, exact in time |
| slab | box with the same convection all round, also turned or turning | series |
| plates | peridynamic box between two held walls, heat alone | series |
| cavity, cavity-velocity | the same with buoyant flow, once steady | finite differences |
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

import lapilli._core as lp
from lapilli._core import Body, Scene
from lapilli.study.enclosure import cavity, cavity_velocity, plates

Array = npt.NDArray[Any]


def shipped(name: str, scene: Scene) -> Any:
    """The reference of this name for this scene; a ValueError says why there is none."""
    try:
        import scipy  # noqa: F401
    except ImportError as error:
        raise ValueError("references need SciPy: pip install 'lapilli[study]'") from error
    return SHIPPED[name](scene)


@dataclass(frozen=True)
class RadialReference:
    """Temperature as a function of the distance from a centre."""

    problem: Any
    centre: Array

    def __call__(self, position: Array, time: float) -> Array:
        from lapilli.references.radial import RadialSolution

        problem = self.problem
        radius = np.linalg.norm(position - self.centre[: position.shape[1]], axis=1)
        inside = np.clip(radius, problem.inner, problem.outer)
        values: Array = RadialSolution(problem).temperature(inside, time)
        return values


@dataclass(frozen=True)
class BoxReference:
    """A box in convection, turned by `degrees` at the start and turning at a constant speed."""

    centre: Array
    half_widths: Array
    degrees: float
    turns_per_second: float
    law: dict[str, Any]

    def __call__(self, position: Array, time: float) -> Array:
        from lapilli.references.slab import convective_box

        dimension = position.shape[1]
        local = position - self.centre[:dimension]
        angle = -np.deg2rad(self.degrees + 360 * self.turns_per_second * time)
        if angle:
            c, s = np.cos(angle), np.sin(angle)
            local[:, :2] = local[:, :2] @ np.array([[c, s], [-s, c]])
        local = np.clip(local, -self.half_widths, self.half_widths)
        values: Array = convective_box(local, time, half_widths=self.half_widths, **self.law)
        return values


def radial(scene: Scene) -> RadialReference:
    """The scene's one body in its radial coordinate."""
    from lapilli.references import thermal
    from lapilli.references.radial import RadialProblem

    body = only_body(scene)
    shape = body.shape
    dimension = len(scene.grid.lower)
    centre, inner, outer = radial_extent(shape, dimension)
    return RadialReference(
        RadialProblem(
            inner=inner,
            outer=outer,
            dimension=dimension,
            at_inner=(
                thermal.INSULATED
                if inner == 0 and dimension > 1  # the centre is no surface
                else boundary_at(scene, on_axis(centre, inner))
            ),
            at_outer=boundary_at(scene, on_axis(centre, outer)),
            initial=number(body.temperature, "the body's temperature"),
            medium=medium_of(body),
        ),
        centre,
    )


def slab(scene: Scene) -> BoxReference:
    """The scene's one box, which has the same convection on every face."""
    body = only_body(scene)
    if not isinstance(body.shape, lp.Box):
        raise ValueError("reference slab: the body must be a Box")
    lower, upper = np.asarray(body.shape.lower), np.asarray(body.shape.upper)
    boundaries = scene.heat.boundaries if scene.heat else []
    if len(boundaries) != 1 or not isinstance(boundaries[0], lp.Convection) or boundaries[0].region:
        raise ValueError("reference slab: heat.boundaries must be one convection over all faces")
    centre = (lower + upper) / 2
    pivots = (body.rotation_center, getattr(body.motion, "center", ()))
    fixed = all(np.allclose(np.resize(p or (0.0,), len(centre)), centre) for p in pivots)
    if not fixed and (body.rotation or body.motion):
        raise ValueError("reference slab: the box must turn about its centre")
    law = boundaries[0]
    return BoxReference(
        centre,
        (upper - lower) / 2,
        body.rotation,
        getattr(body.motion, "revolutions_per_second", 0.0),
        {
            "coefficient": number(law.coefficient, "coefficient"),
            "ambient": number(law.ambient, "ambient"),
            "initial": number(body.temperature, "the body's temperature"),
            "medium": medium_of(body),
        },
    )


SHIPPED: dict[str, Callable[[Scene], Any]] = {
    "radial": radial,
    "slab": slab,
    "plates": plates,
    "cavity": cavity,
    "cavity-velocity": cavity_velocity,
}


def only_body(scene: Scene) -> Body:
    """The body of a scene that has one, without a source."""
    if len(scene.bodies) != 1:
        raise ValueError(f"shipped references know one body, the scene has {len(scene.bodies)}")
    if number(scene.bodies[0].source, "source") != 0:
        raise ValueError("shipped references know no source")
    return scene.bodies[0]


def radial_extent(shape: Any, dimension: int) -> tuple[Array, float, float]:
    """Centre, inner and outer radius."""
    if dimension == 1 and isinstance(shape, lp.Box):
        return np.array(shape.lower), 0.0, shape.upper[0] - shape.lower[0]
    if dimension == 2 and isinstance(shape, lp.Disk):
        return np.array(shape.center), 0.0, shape.radius
    if dimension == 2 and isinstance(shape, lp.Annulus):
        return np.array(shape.center), shape.inner, shape.outer
    if dimension == 3 and isinstance(shape, lp.Sphere):
        return np.array(shape.center), 0.0, shape.radius
    if isinstance(shape, lp.Difference):
        outer, minus = shape.shape, shape.minus
        if isinstance(outer, lp.Sphere) and isinstance(minus, lp.Sphere):
            return np.array(outer.center), minus.radius, outer.radius
    raise ValueError(f"reference radial: no radial coordinate in {dimension}D for {shape}")


def on_axis(centre: Array, radius: float) -> Array:
    """The point at this distance along x."""
    point = np.array(centre, float)
    point[0] += radius
    return point


def boundary_at(scene: Scene, point: Array) -> Any:
    """The law at a point of the surface: the first whose region covers it."""
    from lapilli.references import thermal

    for law in scene.heat.boundaries if scene.heat else []:
        slack = 1e-9 * max(1.0, float(np.abs(point).max()))
        if law.region is not None and law.region.distance(point[None, :])[0] > slack:
            continue
        if isinstance(law, lp.Flux):
            return thermal.Flux(inward=number(law.value, "flux"))
        if isinstance(law, lp.Convection):
            return thermal.Convection(
                coefficient=number(law.coefficient, "coefficient"),
                ambient=number(law.ambient, "ambient"),
            )
        if isinstance(law, lp.PrescribedTemperature):
            return thermal.Prescribed(temperature=number(law.value, "temperature"))
        raise ValueError("shipped references know no radiation")
    return thermal.INSULATED


def medium_of(body: Body) -> Any:
    """The body's thermal coefficients."""
    from lapilli.references.thermal import Medium

    materials = body.material if isinstance(body.material, list) else [body.material]
    thermal = next(material for material in materials if isinstance(material, lp.Thermal))
    if thermal.latent_heat > 0:
        raise ValueError("shipped references know no melting")
    return Medium(
        density=thermal.density,
        specific_heat=number(thermal.specific_heat, "specific_heat"),
        conductivity=number(thermal.conductivity, "conductivity"),
    )


def number(value: Any, what: str) -> float:
    """A constant; tables, functions and tensors are beyond the shipped references."""
    if not isinstance(value, float | int):
        raise ValueError(f"shipped references need one constant number for {what}, got {value}")
    return float(value)
