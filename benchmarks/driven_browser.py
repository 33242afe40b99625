"""A browser that is driven as by hand: mouse, fingers and keys, by Chromium's own protocol over a pipe."""

import base64
import json
import os
import shlex
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
"""Names that it goes by."""

PATIENCE = 60.0
"""For what is waited for [s]."""


class Tab:
    """One page in one browser; complaints of its scripts fail when it closes.

    Args:
        page: to open.
        profile: folder for the browser's own files.
        width, height: of the window, in its pixels.
        phone: with fingers instead of a mouse, and twice as many dots.
        dark: where the page asks what is preferred.
    """

    def __init__(
        self,
        page: Path,
        profile: Path,
        width: int = 1280,
        height: int = 1000,
        *,
        phone: bool = False,
        dark: bool = False,
    ) -> None:
        found = next(filter(None, map(shutil.which, CHROMIUM)))
        sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []
        command = [found, "--headless", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
        command += [*sandbox, f"--user-data-dir={profile}", "--remote-debugging-pipe", "about:blank"]
        its_input, self._output = os.pipe()
        self._input, its_output = os.pipe()
        self._process = subprocess.Popen(
            ["bash", "-c", f"exec {shlex.join(command)} 3<&{its_input} 4>&{its_output}"],
            pass_fds=(its_input, its_output), stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(its_input)
        os.close(its_output)
        self._number, self._session, self._read = 0, "", b""
        self.complaints: list[str] = []
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.send("Runtime.enable")
        self.send("Page.enable")
        self.send(
            "Emulation.setDeviceMetricsOverride", width=width, height=height,
            deviceScaleFactor=2 if phone else 1, mobile=phone,
        )  # fmt: skip
        self.send("Emulation.setTouchEmulationEnabled", enabled=phone)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.send("Emulation.setEmulatedMedia", features=[scheme])
        self.send("Page.navigate", url=page.resolve().as_uri())

    def send(self, method: str, **parameters: object) -> dict[str, Any]:
        """Call the browser, and wait for its answer."""
        self._number += 1
        call: dict[str, object] = {"id": self._number, "method": method, "params": parameters}
        if self._session:
            call["sessionId"] = self._session
        os.write(self._output, json.dumps(call).encode() + b"\0")
        while True:
            message = self._next()
            if message.get("method") == "Runtime.exceptionThrown":
                self.complaints.append(json.dumps(message["params"]["exceptionDetails"]))
            if message.get("id") == self._number:
                assert "error" not in message, message
                result: dict[str, Any] = message["result"]
                return result

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._read:
            read = os.read(self._input, 1 << 16)
            assert read, "the browser has ended"
            self._read += read
        text, self._read = self._read.split(b"\0", 1)
        message: dict[str, Any] = json.loads(text)
        return message

    def evaluate(self, script: str) -> Any:
        """What an expression is in the page."""
        said = self.send("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in said, said
        return said["result"].get("value")

    def wait_for(self, script: str) -> None:
        """Until an expression is true."""
        until = time.monotonic() + PATIENCE
        while not self.evaluate(script):
            assert time.monotonic() < until, f"never true: {script}"
            time.sleep(0.02)

    def frame(self) -> None:
        """Until what was asked for before is drawn."""
        self.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def middle(self, selector: str) -> tuple[float, float]:
        """Where an element's middle is in the window, once it is scrolled to."""
        x, y = self.evaluate(
            f"(() => {{ const of = document.querySelector({json.dumps(selector)});"
            "of.scrollIntoView({ block: 'center' }); const box = of.getBoundingClientRect();"
            "return [box.x + box.width / 2, box.y + box.height / 2]; })()"
        )
        return x, y

    def drag(self, selector: str, right: float, down: float, *, finger: bool = False) -> None:
        """Take an element by its middle and drag it so many pixels, in a few steps."""
        x, y = self.middle(selector)
        steps = [(x + right * share, y + down * share) for share in (0.25, 0.5, 0.75, 1.0)]
        if finger:
            self._touch("touchStart", (x, y))
            for point in steps:
                self._touch("touchMove", point)
            self.send("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        else:
            self._mouse("mouseMoved", (x, y))
            self._mouse("mousePressed", (x, y))
            for point in steps:
                self._mouse("mouseMoved", point)
            self._mouse("mouseReleased", steps[-1])
        self.frame()

    def _mouse(self, kind: str, at: tuple[float, float]) -> None:
        self.send(
            "Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left", buttons=1, clickCount=1
        )

    def _touch(self, kind: str, at: tuple[float, float]) -> None:
        self.send("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": at[0], "y": at[1]}])

    def click(self, selector: str) -> None:
        """With the mouse."""
        self.drag(selector, 0.0, 0.0)

    def press(self, key: str, times: int = 1, *, shift: bool = False) -> None:
        """A key by its name, such as ``ArrowUp`` or ``Tab``."""
        codes = {
            "Tab": 9,
            "End": 35,
            "Home": 36,
            "ArrowLeft": 37,
            "ArrowUp": 38,
            "ArrowRight": 39,
            "ArrowDown": 40,
        }
        for _ in range(times):
            for kind in ("keyDown", "keyUp"):
                self.send(
                    "Input.dispatchKeyEvent", type=kind, key=key, code=key,
                    windowsVirtualKeyCode=codes[key], modifiers=8 if shift else 0,
                )  # fmt: skip
        self.frame()

    def picture(self, path: Path) -> None:
        """Of the whole page."""
        said = self.send("Page.captureScreenshot", captureBeyondViewport=True)
        path.write_bytes(base64.b64decode(said["data"]))

    def close(self) -> None:
        """End the browser."""
        try:
            self._session = ""
            self.send("Browser.close")
        finally:
            os.close(self._output)
            os.close(self._input)
            self._process.wait(timeout=PATIENCE)


@contextmanager
def opened(page: Path, profile: Path, **settings: Any) -> Iterator[Tab]:
    """A page, driven; no script of it may have complained."""
    tab = Tab(page, profile, **settings)
    try:
        yield tab
    finally:
        tab.close()
    assert tab.complaints == []
