"""The page that flies, beside the pages of the documentation."""

from pathlib import Path
from typing import Any

from sailnet.report.playground.page import write_playground


def setup(app: Any) -> dict[str, object]:
    """Take part in the build."""

    def write(app: Any, exception: Exception | None) -> None:
        if exception is None and app.builder.format == "html":
            write_playground(Path(app.outdir) / "playground.html", "make docs", "index.html")

    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "version": "1"}
