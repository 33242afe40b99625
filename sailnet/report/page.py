"""The HTML page: one self-contained file with its pictures inside."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from sailnet.artefacts.files import write_whole


@dataclass(frozen=True)
class Picture:
    """One figure of the page."""

    name: str
    title: str
    caption: str
    svg: str


def render(template: str, **content: object) -> str:
    """Fill one of the templates of this package."""
    environment = Environment(
        loader=PackageLoader("sailnet", "report"),
        autoescape=select_autoescape(["jinja"], default=True),
        undefined=StrictUndefined,
        trim_blocks=False,
    )
    return environment.get_template(template).render(**content)


def write_page(path: Path, figures: Sequence[Picture], **content: object) -> None:
    """Render the report to ``path``; ``content`` fills the template ``page.html.jinja``."""
    text = render("page.html.jinja", figures=figures, **content)
    write_whole(path, lambda beside: beside.write_text(text, encoding="utf-8"))
