"""What a picture shows beside its field."""

from __future__ import annotations

from dataclasses import dataclass

MOST_CONTOURS = 200  # more lie closer than a pixel, and take minutes


@dataclass(frozen=True)
class Style:
    """How pictures of points are drawn.

    Parameters
    ----------
    vectors
        A vector field, drawn as arrows ("velocity").
    contours
        How many lines of equal value.
    cut
        In space the plane that is shown, "y=0.25" (m), or "y" for the middle; unless given the half
        behind the middle, seen along y.
    limits
        Ends of the colours; those of the values unless given.
    colours
        A colour map of matplotlib; unless given one for the kind of field.
    """

    vectors: str | None = None
    contours: int = 0
    cut: str | None = None
    limits: tuple[float, float] | None = None
    colours: str | None = None

    def __post_init__(self) -> None:
        if self.limits is not None and not self.limits[0] < self.limits[1]:
            raise ValueError(f"colours go from a lower to an upper end, got {self.limits}")
        if not 0 <= self.contours <= MOST_CONTOURS:
            raise ValueError(
                f"contours is a number of lines up to {MOST_CONTOURS}, got {self.contours}"
            )
        if self.cut is not None:
            self.plane()

    def plane(self) -> tuple[int, float | None]:
        """Axis and place of the cut; the place is None for the middle."""
        axis, equals, place = (self.cut or "y").partition("=")
        if axis.strip() not in ("x", "y", "z"):
            raise ValueError(f"a cut is 'x', 'y' or 'z', or 'y=0.25' (m), got {self.cut!r}")
        try:
            return "xyz".index(axis.strip()), float(place) if equals else None
        except ValueError:
            raise ValueError(f"a cut is at a number, m, as in 'y=0.25', got {self.cut!r}") from None
