"""Pages in a real browser."""

import html
import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

from benchmarks.driven_browser import CHROMIUM

GRAPHICS = ("GL Driver Message (OpenGL, Performance", "willReadFrequently", "fallback to software WebGL")
"""What a browser remarks of pictures in three dimensions where no graphics card draws them."""


def browse(profile: Path, *arguments: str) -> str:
    """The document after its scripts; complaints of the browser fail."""
    found = next(filter(None, map(shutil.which, CHROMIUM)))
    sandbox = ("--no-sandbox",) if os.geteuid() == 0 else ()
    done = subprocess.run(
        [
            found, "--headless", "--disable-gpu", "--disable-quic", "--no-first-run", *sandbox,
            "--disable-background-networking", "--disable-component-update", "--disable-sync",
            f"--user-data-dir={profile}", "--enable-logging=stderr", "--v=0", "--virtual-time-budget=20000",
            "--dump-dom", *arguments,
        ],
        capture_output=True, text=True, timeout=120, check=True,
    )  # fmt: skip
    complaints = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    assert not [line for line in complaints if not any(usual in line for usual in GRAPHICS)]
    return done.stdout


def told(page: Path, folder: Path, width: int, script: str, fragment: str = "") -> dict[str, Any]:
    """What a script in a page tells, by posting JSON to its parent.

    The page stands in a frame of that width, since a window is never as narrow as a phone.
    """
    followed = folder / "followed.html"
    text = page.read_text("utf-8").replace("</body>", f"<script>{script}</script></body>")
    followed.write_text(text, "utf-8")
    outer = folder / "outer.html"
    outer.write_text(
        f'<iframe src="followed.html{fragment}" width="{width}" height="900" style="border:0"></iframe>'
        "<pre></pre>"
        '<script>addEventListener("message", (event) => '
        'document.querySelector("pre").textContent = event.data)</script>'
    )
    text = browse(folder / "profile", f"--window-size={width + 100},1000", outer.as_uri())
    found = re.search(r"<pre>(\{.*\})</pre>", text)
    assert found is not None
    said: dict[str, Any] = json.loads(html.unescape(found[1]))
    return said
