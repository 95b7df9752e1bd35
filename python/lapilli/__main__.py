"""python -m lapilli"""

import sys

from lapilli.cli import main

sys.exit(main())
