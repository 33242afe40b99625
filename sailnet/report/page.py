"""Templates of this package, filled."""

from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape

FOLDER = Path(__file__).parent
"""Where the templates of this package are."""


def render(template: str, folder: Path = FOLDER, /, **content: object) -> str:
    """Fill a template.

    Args:
        template: its name.
        folder: where it is; what it includes may be there or among the templates of this package.
        content: for the template.
    """
    environment = Environment(
        loader=FileSystemLoader([folder, FOLDER]),
        autoescape=select_autoescape(["jinja"], default=True),
        undefined=StrictUndefined,
        trim_blocks=False,
    )
    return environment.get_template(template).render(**content)
