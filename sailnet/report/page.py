"""Templates of this package, filled."""

from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape
from markupsafe import Markup, escape

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
    environment.filters["with_code"] = with_code
    return environment.get_template(template).render(**content)


def with_code(text: str) -> Markup:
    """A campaign's text for a page: escaped, and what stands between backticks as code."""
    parts = text.split("`")
    if len(parts) % 2 == 0:  # a backtick without its second
        return escape(text)
    code = Markup("<code>{}</code>")
    return Markup("").join(code.format(part) if n % 2 else escape(part) for n, part in enumerate(parts))
