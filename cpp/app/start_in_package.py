#!python
"""Start the executable that lies in the installed package, which need not be imported for it."""

import importlib.util
import os
import sys

package = importlib.util.find_spec("lapilli").submodule_search_locations[0]
program = os.path.join(package, "bin", "lapilli-run")
os.execv(program, [program, *sys.argv[1:]])
