"""The HTML page: one self-contained file with its pictures inside."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape

from sailnet.artefacts.files import write_whole

FOLDER = Path(__file__).parent
"""Where the templates of this package are."""


@dataclass(frozen=True)
class Picture:
    """One figure of the page."""

    name: str
    title: str
    caption: str
    svg: str


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


def write_page(path: Path, figures: Sequence[Picture], **content: object) -> None:
    """Render the report to ``path``; ``content`` fills the template ``page.html.jinja``."""
    text = render("page.html.jinja", figures=figures, **content)
    write_whole(path, lambda beside: beside.write_text(text, encoding="utf-8"))
