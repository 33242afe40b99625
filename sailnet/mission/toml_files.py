"""TOML files that come with the package, by name, and one's own, by path."""

import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

from sailnet.artefacts.untrusted import read_bounded, refuse_deep
from sailnet.errors import SailnetError, did_you_mean, reason

MOST_BYTES = 1 << 20
"""Of a TOML file."""


def shipped_names(folder: str) -> list[str]:
    """Names of the files in a folder of the package."""
    files = (resources.files("sailnet") / folder).iterdir()
    return sorted(file.name.removesuffix(".toml") for file in files if file.name.endswith(".toml"))


def read_table(
    name_or_path: str | Path, kind: str, folder: str, failure: type[SailnetError]
) -> dict[str, Any]:
    """What a file holds: a path if it ends in ``.toml``, otherwise a name.

    Args:
        name_or_path: which file.
        kind: of thing, for messages.
        folder: of the package, where named files are.
        failure: what is raised.

    Raises:
        SailnetError: of the given type: there is no such file, it is not TOML, or this names no file.
    """
    if not isinstance(name_or_path, str | Path):
        raise failure(f"a {kind} is given by its name or the path of its file, not by {name_or_path!r}")
    path = Path(name_or_path)
    try:
        if path.suffix == ".toml":
            text = read_bounded(path, MOST_BYTES).decode("utf-8")
        elif str(name_or_path) in shipped_names(folder):
            text = (resources.files("sailnet") / folder / f"{name_or_path}.toml").read_text("utf-8")
        else:
            known = shipped_names(folder)
            raise failure(
                f"no {kind} named {str(name_or_path)!r}: known are {', '.join(known)}; "
                f"or give the path of a .toml file{did_you_mean(str(name_or_path), known)}"
            )
        content = tomllib.loads(text)
        refuse_deep(content)
        return content
    except (OSError, UnicodeDecodeError) as error:
        raise failure(f"cannot read {kind} file {path}: {reason(error)}") from error
    except RecursionError:
        raise failure(f"{kind} {name_or_path} is nested without end") from None
    except ValueError as error:  # TOML's own errors, and a number of thousands of digits
        raise failure(f"{kind} {name_or_path} is not valid TOML: {error}") from error
