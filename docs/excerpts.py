"""Parts of the repository's texts in the pages of the documentation: no sentence is written twice.

A page has

    ```{excerpt} c_runtime/README.md
    sections: Constraints; Guidance: the law alone
    ```

for whole sections, under their own headings; without ``sections`` the whole text but for its title.
``bare: yes`` leaves the headings of the sections out, ``level: 2`` gives them that level, and ``intro: yes``
takes what stands before the first heading below. Links lead to the page that shows the file they lead to, if
there is one, or else to a copy of that file beside the pages.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
DOCS = Path(__file__).parent

EXCERPT = re.compile(r"^```\{excerpt\} (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^(#+) (.*)$")
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\((?!https?:|mailto:)([^)#\s]*)(#[^)\s]*)?\)")


@dataclass(frozen=True)
class Excerpt:
    """What a page asks for; ``sections`` empty: everything."""

    file: str
    sections: list[str]
    bare: bool
    intro: bool
    level: int | None

    @staticmethod
    def read(file: str, options: str) -> "Excerpt":
        """From the text between the fences."""
        given = dict(re.findall(r"^(\w+): (.*)$", options, re.MULTILINE))
        wanted = [name.strip() for name in given.get("sections", "").split(";") if name.strip()]
        level = int(given["level"]) if "level" in given else None
        return Excerpt(file, wanted, given.get("bare") == "yes", given.get("intro") == "yes", level)


def pages() -> dict[str, list[tuple[str, list[str]]]]:
    """The pages that show a file, and which of its sections, by the file."""
    shown: dict[str, list[tuple[str, list[str]]]] = {}
    for page in sorted(DOCS.rglob("*.md")):
        for file, options in EXCERPT.findall(page.read_text("utf-8")):
            name = page.relative_to(DOCS).as_posix()
            shown.setdefault(file, []).append((name, Excerpt.read(file, options).sections))
    return shown


def slug(heading: str) -> str:
    """Of a heading, as its anchor is named."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def sections_of(text: str) -> list[tuple[int, str, list[str]]]:
    """Level, heading and lines of each section up to the next heading of any level."""
    found: list[tuple[int, str, list[str]]] = [(0, "", [])]
    fenced = False
    for line in text.splitlines():
        fenced ^= line.startswith("```")
        heading = None if fenced else HEADING.match(line)
        if heading:
            found.append((len(heading[1]), heading[2], []))
        else:
            found[-1][2].append(line)
    return found


def cut(text: str, excerpt: Excerpt) -> str:
    """The wanted sections of a text, each with all below it.

    Raises:
        KeyError: there is no such section.
    """
    found = sections_of(text)
    if not excerpt.sections:
        found = [part if part[0] != 1 else (0, "", part[2]) for part in found]
        return "\n".join(map(_section, found))
    lines = []
    for name in excerpt.sections:
        starts = [place for place, part in enumerate(found) if part[1] == name]
        if not starts:
            raise KeyError(f"{excerpt.file} has no section {name!r}")
        level = found[starts[0]][0]
        shift = 0 if excerpt.level is None else excerpt.level - level
        for place, (depth, heading, body) in enumerate(found[starts[0] :]):
            if place and (excerpt.intro or depth <= level):
                break
            hidden = excerpt.bare and not place
            lines.append(_section((0 if hidden else depth + shift, heading, body)))
    return "\n".join(lines)


def _section(part: tuple[int, str, list[str]]) -> str:
    depth, heading, body = part
    return "\n".join(([f"{'#' * depth} {heading}"] if depth else []) + body)


def relink(text: str, file: str, page: Path, shown: dict[str, list[tuple[str, list[str]]]]) -> str:
    """Links of a file's text as a page needs them."""
    up = "../" * (len(page.relative_to(DOCS).parts))

    def lead(match: re.Match[str]) -> str:
        image, label, target, anchor = match[1], match[2], match[3], match[4] or ""
        path = ((ROOT / file).parent / target).resolve() if target else ROOT / file
        name = path.relative_to(ROOT).as_posix()
        if image:
            return f"![{label}]({up}{name})"
        for candidate, sections in shown.get(name, []):
            if not anchor or not sections or anchor[1:] in map(slug, sections):
                return f"[{label}](<{'/' + candidate}{anchor}>)"
        if not path.is_file():
            return label
        return f"{{download}}`{label.replace('`', '')} <{up}{name}>`"

    kept = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if part.startswith("```") else LINK.sub(lead, part) for part in kept)


def expand(app: Any, docname: str, source: list[str]) -> None:
    """Put the excerpts into a page before it is read."""
    page = Path(app.env.doc2path(docname))
    if page.suffix != ".md":
        return

    def excerpt(match: re.Match[str]) -> str:
        asked = Excerpt.read(match[1], match[2])
        for source_file in (ROOT / asked.file, Path(__file__)):
            app.env.note_dependency(str(source_file))
        text = cut((ROOT / asked.file).read_text("utf-8"), asked)
        return relink(text, asked.file, page, app.env.excerpts)

    source[0] = EXCERPT.sub(excerpt, source[0])


def setup(app: Any) -> dict[str, object]:
    """Take part in the build."""

    def know_pages(app: Any, env: Any, docnames: list[str]) -> None:
        env.excerpts = pages()

    app.connect("env-before-read-docs", know_pages)
    app.connect("source-read", expand)
    return {"parallel_read_safe": True, "version": "1"}
