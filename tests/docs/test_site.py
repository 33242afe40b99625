"""The documentation builds without a warning, its cells run, and no link in it leads nowhere."""

import re
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from tests.paths import ROOT
from tests.tools import needs_docs

pytestmark = [needs_docs(), pytest.mark.xdist_group("docs")]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The pages, built where their cells may have been executed before."""
    site = tmp_path_factory.mktemp("docs")
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-W", "-n", "--keep-going", "-q", "-b", "html", "docs", str(site)],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-6000:]
    return site


class Page(HTMLParser):
    """Links, images and anchors of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if name := given.get("id"):
            self.anchors.add(name)
        if target := given.get("href") or given.get("src"):
            self.links.append(target)


def pages(site: Path) -> Iterator[tuple[Path, Page]]:
    for path in sorted(site.rglob("*.html")):
        yield path, Page(path.read_text("utf-8"))


def test_every_link_leads_somewhere(made: Path) -> None:
    read = dict(pages(made))
    assert len(read) > 25
    dead, inner = [], 0
    for path, page in read.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link == "#":
                continue
            inner += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            known = target in read
            if not target.exists() or (
                known and parts.fragment and parts.fragment not in read[target].anchors
            ):
                dead.append(f"{path.relative_to(made)}: {link}")
    assert inner > 1000
    assert not dead


def test_nothing_is_fetched_from_elsewhere(made: Path) -> None:
    for path in made.rglob("*.html"):
        fetched = re.findall(
            r'<(?:script|img|link)[^>]*(?:src|href)="((?:https?:)?//[^"]*)"', path.read_text("utf-8")
        )
        assert not fetched, path.name


def test_cells_left_what_they_printed(made: Path) -> None:
    first = (made / "first-flight.html").read_text("utf-8")
    assert "(357.815 days)" in re.sub(r"<[^>]*>", "", first)
    assert len(re.findall(r"<img [^>]*_images/", first)) == 2


def test_every_name_and_every_command_has_its_entry(made: Path) -> None:
    import sailnet
    from sailnet.cli.command_line import parser, sub_commands

    python = Page((made / "python.html").read_text("utf-8")).anchors
    names = {name for name in sailnet.__all__ if name not in ("__version__", "Transfer")}
    assert {f"sailnet.{name}" for name in names} - python == set()
    line = Page((made / "command-line.html").read_text("utf-8")).anchors
    for command in sub_commands(parser()):
        assert f"sailnet-{command}" in line
