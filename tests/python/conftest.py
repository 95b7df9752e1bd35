"""Objects that several tests need."""

import lapilli as lp
import pytest


@pytest.fixture
def steel() -> lp.Thermal:
    """Round numbers near those of a carbon steel."""
    return lp.Thermal(density=7800, specific_heat=460, conductivity=50)
