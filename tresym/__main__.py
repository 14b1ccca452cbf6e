"""``python -m tresym`` is the ``tresym`` command."""

import sys

from tresym.cli import main

sys.exit(main())
