"""Heat and large deformation with particles, on boundaries that do not fit the grid."""

import os

# Threads that wait for the next loop sleep instead of spinning: other programs on the machine, and
# NumPy's own threads, keep their processors. Read once, when the compiled module loads.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

from lapilli._core import (  # noqa: E402
    RunError,
    Table,
    Thermal,
    __version__,
    set_thread_count,
    thread_count,
)

__all__ = [
    "RunError",
    "Table",
    "Thermal",
    "__version__",
    "set_thread_count",
    "thread_count",
]
