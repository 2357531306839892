"""A headless Chromium, spoken to through two pipes: enough of its protocol to open a page, ask it and photograph it."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from eigenmotion.building.errors import BuildError
from eigenmotion.building.request import request
from eigenmotion.webpage import wasm
from eigenmotion.webpage.page import Run, page

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
TALLEST = 8000  # [pixel] of a photograph
_OPTIONS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--disable-dev-shm-usage", "--no-first-run", "--disable-background-networking",
            "--remote-debugging-pipe", "--hide-scrollbars")  # fmt: skip


def chromium() -> str | None:
    """Return the command of a Chromium, None where there is none."""
    return next((found for name in NAMES if (found := shutil.which(name))), None)


class Browser:
    """One browser with one page; `errors` and `requests` gather what the page complains about and asks for."""

    def __init__(self, width: int = 1280, height: int = 900, scheme: str = "light", motion: str = "no-preference"):
        self.errors: list[str] = []
        self.requests: list[str] = []
        self._number = 0
        self._session: str | None = None
        self._rest = b""
        self._profile = tempfile.TemporaryDirectory()
        self._start(chromium())
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.look(width, height, scheme, motion)

    def _start(self, command: str | None) -> None:
        assert command
        theirs_in, self._out = os.pipe()
        self._in, theirs_out = os.pipe()
        line = f'exec "$0" "$@" 3<&{theirs_in} 4>&{theirs_out}'
        arguments = (*_OPTIONS, f"--user-data-dir={self._profile.name}", "about:blank")
        self._process = subprocess.Popen(["bash", "-c", line, command, *arguments], pass_fds=(theirs_in, theirs_out),
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # fmt: skip
        os.close(theirs_in)
        os.close(theirs_out)

    def look(self, width: int, height: int, scheme: str = "light", motion: str = "no-preference") -> None:
        """Change the size of the window, and what the reader prefers."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        features = {"prefers-color-scheme": scheme, "prefers-reduced-motion": motion}
        self.call("Emulation.setEmulatedMedia", features=[{"name": k, "value": v} for k, v in features.items()])

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Call a method of the protocol and return its answer."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._out, json.dumps(message).encode() + b"\0")
        while (answer := self._read()).get("id") != self._number:
            self._note(answer)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']}")
        return answer["result"]

    def _read(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            more = os.read(self._in, 1 << 16)
            if not more:
                raise RuntimeError("the browser is gone")
            self._rest += more
        message, _, self._rest = self._rest.partition(b"\0")
        return json.loads(message)

    def _note(self, event: dict[str, Any]) -> None:
        method, given = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = given["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and given["type"] in ("error", "warning", "assert"):
            self.errors.append(str([one.get("value", one.get("description")) for one in given["args"]]))
        elif method == "Log.entryAdded" and given["entry"]["level"] == "error":
            self.errors.append(given["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(given["request"]["url"])

    def open(self, path: Path) -> None:
        """Open a file and wait until the page is alive."""
        self.call("Page.navigate", url=path.resolve().as_uri())
        self.ask("new Promise((done) => { const wait = () => window.eigenmotion?.motion || "
                 "document.querySelector('#word.failure') ? done(true) : setTimeout(wait, 20); wait(); })")  # fmt: skip

    def visit(self, path: Path) -> None:
        """Open a file that is no page of a model, and wait until it is loaded."""
        self.call("Page.navigate", url=path.resolve().as_uri())
        self.ask("new Promise((done) => document.readyState === 'complete' ? done(1) : addEventListener('load', done))")

    def ask(self, expression: str) -> Any:
        """Return the value of an expression in the page."""
        found = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in found:
            raise RuntimeError(str(found["exceptionDetails"]))
        return found["result"].get("value")

    def photograph(self, path: Path, whole: bool = False) -> None:
        """Write what the page looks like to a .png; `whole`: what is below the window, too, down to TALLEST."""
        more: dict[str, Any] = {}
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            clip = {"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], TALLEST), "scale": 1}
            more = {"captureBeyondViewport": True, "clip": clip}
        path.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", **more)["data"]))

    def close(self) -> None:
        """End the browser."""
        self._session = None
        try:
            self.call("Browser.close")
        except (RuntimeError, OSError):
            self._process.kill()
        self._process.wait(20)
        os.close(self._out)
        os.close(self._in)
        self._profile.cleanup()

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@contextmanager
def opened_page(model: Any, file: Path, t_end: float) -> Iterator[Browser]:
    """Open the page of a model that has run to t_end, tightly; skip the test where nothing makes or shows pages."""
    try:
        wasm.wasm_compiler()
    except BuildError as error:
        pytest.skip(str(error))
    if chromium() is None:
        pytest.skip("Chromium is not here (apt-get install chromium)")
    file.write_text(page(request(model), "", Run(t_end, 1e-9, 1e-9), None), encoding="utf-8")
    with Browser() as browser:
        browser.look(width=1000, height=800)
        browser.open(file)
        yield browser
