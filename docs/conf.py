"""How Sphinx builds the documentation: ``make docs``. Nothing here or in a page needs a network."""

import hashlib
import os
import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(Path(__file__).parent)]
# Cells run `python -m data`, which is of the checkout, in folders of their own.
os.environ["PYTHONPATH"] = str(ROOT)

import sailnet  # noqa: E402

project = "sailnet"
author = "the authors of sailnet"
release = version = sailnet.__version__
extensions = [
    "excerpts",
    "interfaces",
    "playground",
    "links",
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
]
templates_path: list[str] = []
exclude_patterns = ["_build"]
highlight_language = "none"
smartquotes = False  # they would turn --option into a dash

html_theme = "furo"
html_title = f"sailnet {release}"
html_static_path = ["static"]
html_css_files = ["wide_tables.css", "fly_here.css"]
html_show_copyright = False
html_copy_source = False

# Of a heading in a page, and in an excerpt of a text that was written for GitHub.
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence", "deflist", "attrs_inline"]
suppress_warnings = ["myst.header"]  # an excerpt begins at the level that it has in its text

# A cell that fails ends the build; cells that have run do so again where they or the library have changed.
_library = hashlib.sha256(b"".join(path.read_bytes() for path in sorted(ROOT.glob("sailnet/**/*.py"))))
nb_execution_mode = "cache"
nb_execution_cache_path = str(ROOT / "build" / "docs-cells" / _library.hexdigest()[:12])
nb_execution_in_temp = True
# Kernels talk to nobody but this build, and need not warn that they do so in the open.
_profile = ROOT / "build" / "docs-kernels" / "profile_default"
_profile.mkdir(parents=True, exist_ok=True)
(_profile / "ipython_kernel_config.py").write_text("c.IPKernelApp.log_level = 40\n", "utf-8")
os.environ["IPYTHONDIR"] = str(_profile.parent)
nb_execution_raise_on_error = True
nb_execution_timeout = 1800
nb_merge_streams = True

ARRAY_LIKE = re.compile(
    r"[\w.~]*_Buffer \| .*?_NestedSequence\[[\w.~]*complex \| [\w.~]*bytes \| [\w.~]*str\]"
)

autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
autodoc_type_aliases = {"ArrayLike": "ArrayLike", "Array": "Array"}
autodoc_class_signature = "separated"
autodoc_default_options = {"exclude-members": "__init__, __new__"}
napoleon_use_ivar = True
nitpicky = True
nitpick_ignore_regex = [
    # Types of other packages, whose pages are not here; aliases; names of the rooms below what is offered.
    (r"py:.*", r"(numpy|np|pathlib|pydantic|collections|typing|h5py|pandas|enum)\b.*"),
    (
        r"py:.*",
        r"(ArrayLike|Array|NDArray|Path|Any|Literal|Callable|Frame|Sequence|Mapping|AnyMission|optional|catalogue)",
    ),
    (r"py:.*", r"(\w+\.)*(bool_|int64|int32|uint32|float64|ndarray.*)"),
    (
        r"py:.*",
        r"(sailnet\.(physics|mission|expert|dataset|guidance|flight|campaign|artefacts|errors)\..*|[A-Z]\w+)",
    ),
]


def setup(app: Any) -> None:
    """Keep napoleon from taking what stands before a colon in a property's first line for its type."""
    written: dict[str, list[str]] = {}

    def before(app: Any, what: str, name: str, it: object, options: object, lines: list[str]) -> None:
        written[name] = list(lines)

    def after(app: Any, what: str, name: str, it: object, options: object, lines: list[str]) -> None:
        if what in ("property", "attribute"):
            lines[:] = written[name]

    def spelt(app: Any, what: str, name: str, it: object, options: object, given: str, back: str) -> Any:
        # NumPy's ArrayLike is an alias whose name is lost when annotations are read.
        return ARRAY_LIKE.sub("ArrayLike", given or "") or None, back

    app.connect("autodoc-process-signature", spelt)
    app.connect("autodoc-process-docstring", before, priority=400)
    app.connect("autodoc-process-docstring", after, priority=600)
