"""What every described key changes: for each a scene, two values and the number that must differ.

An effect that has a closed form says by how much. A key that cannot be shown so is in `elsewhere`,
with the test that shows it or the reason why nothing can.
"""

from __future__ import annotations

import of_flow
import of_heat
import of_materials
import of_mechanics
import of_scene
from effect import Effect

PARTS = (of_scene, of_materials, of_heat, of_mechanics, of_flow)
EFFECTS: dict[str, Effect] = {}
for part in PARTS:
    assert not EFFECTS.keys() & part.EFFECTS.keys(), "a key with two effects"
    EFFECTS |= part.EFFECTS
