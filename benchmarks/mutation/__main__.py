"""``python -m benchmarks.mutation``: put faults into the sources one by one, and see which the tests notice.

Writes tests/MUTATION.md. A run that was ended goes on where it was.
"""

import argparse
import sys

from benchmarks.mutation.report import PAGE, page
from benchmarks.mutation.runner import WORK, MutationError, packages, try_all


def main() -> int:
    """Try mutants and write the page."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.mutation",
        description=__doc__,
        epilog="example: python -m benchmarks.mutation physics plant --minutes 20",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("packages", nargs="*", help="of packages.toml; all by default, which writes the page")
    parser.add_argument("--jobs", type=int, default=2, help="processes (%(default)s)")
    parser.add_argument("--minutes", type=float, default=600.0, help="begin none after that (%(default)g)")
    parser.add_argument("--mutants", type=int, help="of each package, instead of what packages.toml says")
    parser.add_argument("--list", action="store_true", help="print the mutants that would be tried, and end")
    options = parser.parse_args()
    try:
        wanted = packages(options.packages, options.mutants)
        if options.list:
            for package in wanted:
                for mutant in package.mutants:
                    print(f"{package.name}: {mutant.path}:{mutant.line}: {mutant.before} -> {mutant.after}")
            return 0
        WORK.mkdir(parents=True, exist_ok=True)
        try_all(wanted, options.jobs, options.minutes)
    except MutationError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    if options.packages:
        print(page(wanted))
    else:
        PAGE.write_text(page(wanted), "utf-8")
        print(f"written: {PAGE}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
