"""Benchmark of web pages: size in bytes, frames per second in Chromium, and the time of a run in the page and natively.

Chromium runs headless, with software rendering, as on a machine without a graphics card. The run is 10 s by dop853 with
a hundred rows per second, by WebAssembly in the page and by `simulate` natively, at the same tolerances; the shortest
of many. Models in space are drawn by three.js, which npm installs. If the machine is shared with others, the processor
time per frame of the browser's busiest process is more reliable: up to 16.7 ms allow 60 frames per second.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

import numpy as np

import eigenmotion as em
from eigenmotion.building.errors import BuildError
from eigenmotion.building.request import request
from eigenmotion.webpage.page import Run, page
from eigenmotion.webpage.three import three

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT))
from tests.support.browser import Browser, chromium  # noqa: E402

CASES = (("dual_link", False), ("four_bar", False), ("heavy_top", True))
T_END, TOLERANCE, ROWS = 10.0, 1e-9, 1001
SECONDS, TIMES = 3, 30

COUNT = """new Promise((done) => {
    let frames = 0; const began = performance.now();
    const tick = (now) => { frames += 1;
        if (now - began < 1000 * %d) requestAnimationFrame(tick); else done(1000 * frames / (now - began)); };
    requestAnimationFrame(tick); })"""
LEAST = """(() => { let least = Infinity;
    for (let k = 0; k < %d; ++k) {
        const began = performance.now(); %s; least = Math.min(least, performance.now() - began); }
    return least; })()"""


def native(path: Path) -> float:
    """Return the milliseconds of a native run."""
    system, least = em.build(path), np.inf
    for _ in range(TIMES):
        began = time.perf_counter()
        system.simulate((0.0, T_END), rtol=TOLERANCE, atol=TOLERANCE, t_eval=np.linspace(0.0, T_END, ROWS))
        least = min(least, time.perf_counter() - began)
    return 1e3 * least


def processor_times(pid: int) -> dict[int, float]:
    """Return the processor seconds of a process and each of its descendants, from /proc."""
    used, parents = dict[int, float](), dict[int, int]()
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            fields = stat.read_text().rpartition(")")[2].split()
            each = int(stat.parent.name)
            parents[each] = int(fields[1])
            used[each] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    below = {pid}
    while more := {each for each, parent in parents.items() if parent in below} - below:
        below |= more
    return {each: used.get(each, 0.0) for each in below}


def frames(browser: Browser) -> tuple[float, float]:
    """Return frames per second, and the processor time of the busiest process per frame in milliseconds."""
    browser.ask(COUNT % 1)
    pid, first, before = browser._process.pid, browser.ask("eigenmotion.frames"), processor_times(browser._process.pid)
    rate = browser.ask(COUNT % SECONDS)
    after, count = processor_times(pid), browser.ask("eigenmotion.frames") - first
    return rate, 1e3 * max((used - before.get(each, 0.0) for each, used in after.items()), default=0.0) / count


def measure(name: str, space: bool, browser: Browser, folder: Path) -> None:
    """Print the size and the cost of a model's page."""
    path, library = ROOT / "models" / f"{name}.py", three() if space else None
    texts = [
        page(request(path), path.read_text(encoding="utf-8"), Run(T_END, TOLERANCE, TOLERANCE), one)
        for one in (None, library)
    ]
    file = folder / f"{name}.html"
    file.write_text(texts[1], encoding="utf-8")
    browser.open(file)
    rate, busiest = frames(browser)
    browser.ask("eigenmotion.player.pause()")
    here, there = native(path), browser.ask(LEAST % (TIMES, f"eigenmotion.engine.run({T_END})"))
    sizes = ", with three.js ".join(f"{len(text) / 1e3:.0f} kB" for text in texts[: 1 + space])
    print(f"{name}: {sizes}; {rate:.1f} frames a second, {busiest:.1f} ms of the busiest process for each")
    print(f"    run {there:.2f} ms, native {here:.2f} ms: {there / here:.1f} times")


def main() -> None:
    if chromium() is None:
        print("skipped: pages in a browser, for Chromium is not here")
        return
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        for name, space in CASES:
            try:
                measure(name, space, browser, Path(folder))
            except BuildError as error:
                print(f"{name}: {error}")


if __name__ == "__main__":
    main()
