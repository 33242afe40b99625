"""Whether every link within the built pages leads somewhere, anchors too.

Sphinx sees the links that Markdown makes. Raw HTML, downloads, and what the theme writes are seen here.
"""

from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """Links, images and anchors of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note what an element leads to, and what leads to it."""
        given = dict(attrs)
        if name := given.get("id"):
            self.anchors.add(name)
        if target := given.get("href") or given.get("src"):
            self.links.append(target)


class DeadLinkError(Exception):
    """The pages have links that lead nowhere."""


def inner_links(site: Path) -> Iterator[tuple[Path, str, bool]]:
    """Every link that stays within the site: its page, the link, and whether it leads somewhere."""
    read = {path: Page(path.read_text("utf-8")) for path in sorted(site.resolve().rglob("*.html"))}
    for path, page in read.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link == "#":
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            known = target in read and bool(parts.fragment)
            yield path, link, target.exists() and (not known or parts.fragment in read[target].anchors)


def setup(app: Any) -> dict[str, object]:
    """Take part in the build: a dead link ends it."""

    def check(app: Any, exception: Exception | None) -> None:
        if exception is None and app.builder.format == "html":
            site = Path(app.outdir).resolve()
            dead = [
                f"{page.relative_to(site)}: {link}" for page, link, alive in inner_links(site) if not alive
            ]
            if dead:
                raise DeadLinkError("links that lead nowhere: " + "; ".join(dead))

    app.connect("build-finished", check, priority=900)  # when all pages are written
    return {"parallel_read_safe": True, "version": "1"}
