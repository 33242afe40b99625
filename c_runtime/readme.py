"""Blocks of a README that a command writes."""

from pathlib import Path

from sailnet.artefacts.files import write_whole
from sailnet.errors import SailnetError


def split_at_block(readme: Path, name: str) -> tuple[str, str]:
    """What stands before and after the block: to ``<!-- name:begin -->`` and from ``<!-- name:end -->``.

    Raises:
        SailnetError: the file has no such block.
    """
    opening, closing = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    before, found, rest = readme.read_text(encoding="utf-8").partition(opening)
    _, closed, after = rest.partition(closing)
    if not (found and closed):
        raise SailnetError(f"{readme} has no lines {opening} and {closing}: add them where the table goes")
    return before + opening, closing + after


def fill_block(readme: Path, name: str, content: str) -> None:
    """Replace what stands between ``<!-- name:begin -->`` and ``<!-- name:end -->``.

    Raises:
        SailnetError: the file has no such block.
    """
    before, after = split_at_block(readme, name)
    text = f"{before}\n{content}\n{after}"
    write_whole(readme, lambda beside: beside.write_text(text, encoding="utf-8"))
