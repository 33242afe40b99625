"""``python -m sailnet.cli``: the ``sailnet`` command where no script is installed."""

import sys

from sailnet.cli.command_line import main

sys.exit(main())
