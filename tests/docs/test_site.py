"""The documentation builds without a warning, its cells run, and no link in it leads nowhere."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.driven_browser import Tab
from docs.links import Page, inner_links
from tests.paths import ROOT
from tests.tools import needs_browser, needs_docs

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


def test_every_link_leads_somewhere(made: Path) -> None:
    assert len(list(made.rglob("*.html"))) > 25
    found = list(inner_links(made))
    assert len(found) > 1000
    assert not [f"{page.name}: {link}" for page, link, alive in found if not alive]


def test_types_are_named_as_they_are_written(made: Path) -> None:
    text = re.sub(r"<[^>]*>", "", (made / "python.html").read_text("utf-8"))
    assert "_NestedSequence" not in text
    assert "ArrayLike" in text


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


def test_the_first_flight_is_a_notebook_of_fifteen_lines(made: Path) -> None:
    page = Page((made / "first-flight.html").read_text("utf-8"))
    (link,) = (link for link in page.links if link.endswith(".ipynb"))
    cells = json.loads((made / link).read_text("utf-8"))["cells"]
    cells = [cell for cell in cells if cell["cell_type"] == "code"]
    lines = [line for cell in cells for line in "".join(cell["source"]).split("\n") if line]
    assert len(lines) == 15
    for step in ("sailnet.solve(", ".plot()", "torch.tensor(", "sailnet.fly("):
        assert step in "\n".join(lines)


def test_every_name_and_every_command_has_its_entry(made: Path) -> None:
    import sailnet
    from sailnet.cli.command_line import parser, sub_commands

    python = Page((made / "python.html").read_text("utf-8")).anchors
    names = {name for name in sailnet.__all__ if name not in ("__version__", "Transfer")}
    assert {f"sailnet.{name}" for name in names} - python == set()
    line = Page((made / "command-line.html").read_text("utf-8")).anchors
    for command in sub_commands(parser()):
        assert f"sailnet-{command}" in line


@needs_browser()
@pytest.mark.parametrize(("width", "phone"), [(1280, False), (390, True)])
def test_no_page_is_wider_than_the_screen(made: Path, tmp_path: Path, width: int, phone: bool) -> None:
    """What is wider, a table or a line of a program, can be scrolled by itself."""
    tab = Tab(made / "index.html", tmp_path / "profile", width, 900, phone=phone)
    wide = {}
    for page in sorted(made.rglob("*.html")):
        if page.name != "playground.html":
            tab.send("Page.navigate", url=page.resolve().as_uri())
            here = page.relative_to(made).as_posix()
            tab.wait_for(f"location.href.endsWith({here!r}) && document.readyState === 'complete'")
            # What scrolls by itself is cut off by its own box, which a table never is.
            wide[here] = tab.evaluate(
                "[...document.querySelectorAll('article table, article pre, article img')].filter((it) => {"
                "let up = it.tagName === 'TABLE' ? it.parentElement : it;"
                "for (; up.tagName !== 'ARTICLE'; up = up.parentElement)"
                " if (getComputedStyle(up).overflowX !== 'visible') return false;"
                "return it.getBoundingClientRect().right > innerWidth; }).length"
            )
    tab.close()
    assert len(wide) > 25
    assert not {page: number for page, number in wide.items() if number}
