"""The command line of what writes tables of campaigns into a text, between two marks."""

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from sailnet.artefacts.files import fill_block, split_at_block
from sailnet.errors import SailnetError


def fill_from_folder(
    module: str,
    description: str | None,
    mark: str,
    block: Callable[[Path], str],
    joined: Callable[[str, str], str] | None = None,
) -> int:
    """Run the command ``python -m MODULE FOLDER TEXT``; returns its exit status.

    Args:
        module: whose command it is.
        description: for its help.
        mark: name of the block in the text.
        block: what is written there, from the folder that campaigns were flown to; its errors are told.
        joined: what becomes of what stood there and what is written now; by default the latter alone.
    """
    parser = argparse.ArgumentParser(
        prog=f"python -m {module}",
        description=description,
        epilog=f"example: python -m {module} build/earth_mars/campaigns sailnet/campaign/RESULTS.md",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", type=Path, help="where campaigns were flown to")
    parser.add_argument("text", type=Path, help=f"file with the marks <!-- {mark} --> and <!-- /{mark} -->")
    options = parser.parse_args()
    try:
        (_, before, _), written = split_at_block(options.text, mark), block(options.folder)
        fill_block(options.text, mark, joined(before, written) if joined else written)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0
