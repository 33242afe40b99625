"""What `make docs` looks for when all pages are written."""

from pathlib import Path

from docs.links import inner_links


def test_a_link_that_leads_nowhere_is_found(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "b.html").write_text('<h1 id="there">b</h1><a href="../a.html#here">a</a>', "utf-8")
    (tmp_path / "a.html").write_text(
        '<p id="here"><a href="in/b.html#there">b</a><a href="#here">here</a><a href="#">up</a>'
        '<a href="https://example.org/x.html">away</a><a href="in/b.html#gone">b</a><img src="c%20d.png">'
        '<a href="#nowhere">c</a><a href="in">folder</a>',
        "utf-8",
    )
    found = list(inner_links(tmp_path))
    assert len(found) == 7
    assert [link for _, link, alive in found if not alive] == ["in/b.html#gone", "c%20d.png", "#nowhere"]
