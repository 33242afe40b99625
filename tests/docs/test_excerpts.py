"""Excerpts of the repository's texts: what is asked for, with links that fit the page."""

import importlib.util
import re
from pathlib import Path
from types import ModuleType

import pytest

from tests.paths import ROOT

TEXT = """# Title
Above [all](data/README.md#units).
## One
one `a` [the data](data/README.md)
### Within
```sh
# no heading
```
## Two
two
"""


@pytest.fixture(scope="module")
def excerpts() -> ModuleType:
    place = importlib.util.spec_from_file_location("excerpts", ROOT / "docs" / "excerpts.py")
    assert place is not None
    assert place.loader is not None
    made = importlib.util.module_from_spec(place)
    import sys

    sys.modules["excerpts"] = made  # dataclasses look there
    place.loader.exec_module(made)
    return made


def cut(excerpts: ModuleType, options: str) -> str:
    text: str = excerpts.cut(TEXT, excerpts.Excerpt.read("a.md", options))
    return text


def test_a_section_comes_with_all_below_it(excerpts: ModuleType) -> None:
    found = cut(excerpts, "sections: One\n")
    assert found.startswith("## One\n")
    assert "### Within" not in cut(excerpts, "sections: One\nintro: yes\n")
    assert "### Within" in found
    assert "# no heading" in found
    assert "Two" not in found


def test_headings_can_be_left_out_and_set(excerpts: ModuleType) -> None:
    assert cut(excerpts, "sections: Two\nbare: yes\n").strip() == "two"
    assert cut(excerpts, "sections: One\nlevel: 3\n").startswith("### One")
    assert "#### Within" in cut(excerpts, "sections: One\nlevel: 3\n")


def test_the_whole_text_comes_without_its_title(excerpts: ModuleType) -> None:
    found = cut(excerpts, "")
    assert "Title" not in found
    assert "## One" in found


def test_a_section_that_is_not_there_is_an_error(excerpts: ModuleType) -> None:
    with pytest.raises(KeyError, match="no section 'Three'"):
        cut(excerpts, "sections: Three\n")


def test_links_lead_to_the_page_that_shows_the_file_or_to_a_copy(excerpts: ModuleType) -> None:
    shown = {"data/README.md": [("part.md", ["Verify it"]), ("data-set.md", [])]}
    page = ROOT / "docs" / "results" / "c.md"
    relink = excerpts.relink
    assert relink("[a](data/README.md#units)", "README.md", page, shown) == "[a](</data-set.md#units>)"
    assert relink("[`a`](LICENSE)", "README.md", page, shown) == "{download}`a <../../LICENSE>`"
    assert relink("[`tests/`](tests)", "README.md", page, shown) == "`tests/`"
    assert relink("![a](docs/flight.png)", "README.md", page, shown) == "![a](../../docs/flight.png)"
    assert relink("[a](https://b.c)", "README.md", page, shown) == "[a](https://b.c)"
    assert relink("```\n[a](LICENSE)\n```", "README.md", page, shown) == "```\n[a](LICENSE)\n```"


def test_no_page_asks_for_a_section_that_is_not_there(excerpts: ModuleType) -> None:
    asked = 0
    for page in sorted((ROOT / "docs").rglob("*.md")):
        for file, options in excerpts.EXCERPT.findall(page.read_text("utf-8")):
            assert excerpts.cut(
                (ROOT / file).read_text("utf-8"), excerpts.Excerpt.read(file, options)
            ).strip()
            asked += 1
    assert asked > 25


def test_every_page_is_in_a_table_of_contents() -> None:
    pages = sorted((ROOT / "docs").rglob("*.md"))
    listed = {
        page.parent / f"{line}.md"
        for page in pages
        for tree in re.findall(r"```{toctree}\n(.*?)```", page.read_text("utf-8"), re.S)
        for line in tree.splitlines()
    }
    assert set(pages) - listed == {ROOT / "docs" / "index.md"}
    assert Path(ROOT / "docs" / "flight.png").exists()
