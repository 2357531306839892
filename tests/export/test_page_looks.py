"""Looks of pages in Chromium: of models, reports and stability, at 1400 and 400 pixels, light and dark."""

from pathlib import Path

import pytest

from eigenmotion.building.errors import BuildError
from eigenmotion.building.request import request
from eigenmotion.report.output import write_report
from eigenmotion.webpage import wasm
from eigenmotion.webpage.page import ALONE, Place, Run, page

from ..study.made_up import OURS, findings
from ..support.browser import Browser
from ..support.crane import measured_crane
from ..support.generation import NAMES
from ..support.looks import critical, faults, look_at

MODELS = Path(__file__).parents[2] / "models"


SOUND = """<!doctype html><html lang="en"><meta charset="utf-8"><title>sound</title><style>
:root { color-scheme: light dark; }
body { font: 16px/1.5 sans-serif; color: light-dark(#222, #ddd); background: light-dark(#fff, #111); }
pre { overflow-x: auto; width: 9rem; }
</style><body><p>One line of text.</p><pre>a line that is longer than its box</pre>
<canvas id="plot" width="200" height="60"></canvas>%s<script>
const brush = document.getElementById("plot").getContext("2d"); brush.fillStyle = "#888";
for (const [text, x] of [%s]) brush.fillText(text, x, 30);</script></body></html>"""
BROKEN = {
    "wider than the window": '<div style="width: 3000px; height: 1px"></div>',
    "outside the window": '<p style="position: relative; left: -30px">a line begins beyond the window</p>',
    "overlap": '<p>above</p><p style="margin-top: -30px">below</p>',
    "cut off": '<div style="width: 3rem; overflow: hidden; white-space: nowrap">a long name</div>',
    'in the field "length"': '<input type="number" aria-label="length" value="1234567890123" style="width: 3rem">',
    "faint": '<p style="opacity: 0.4">pale words</p>',
    "no picture": '<img src="nowhere.png" alt="" style="width: 30px">',
    "is missing": "<script>console.error('a part is missing')</script>",
}
WRITTEN = {"overlap": '["12.5", 20], ["13.0", 30]', "cut off": '["1000000", 180]'}


@pytest.fixture(scope="module")
def critic(browser):
    with critical(browser):
        yield browser


@pytest.fixture
def folder(tmp_path, request):
    """Where photographs go."""
    return request.config.getoption("--screenshots") or tmp_path


def complaints(browser: Browser, folder: Path, text: str) -> list[str]:
    (folder / "broken.html").write_text(text, encoding="utf-8")
    return look_at(browser, folder / "broken.html", "broken", folder)


def test_a_sound_page_has_no_faults_and_each_look_a_photograph(critic, tmp_path):
    assert complaints(critic, tmp_path, SOUND % ("", '["12.5", 20], ["13.0", 90]')) == [
        f"{look}: faint: \"{text}\" (3.5 to 1)" for look in ("1400 light", "400 light") for text in ("12.5", "13.0")
    ]  # fmt: skip
    assert {path.name for path in tmp_path.glob("*.png")} == {
        "broken_1400_light.png", "broken_1400_dark.png", "broken_400_light.png", "broken_400_dark.png"
    }  # fmt: skip


@pytest.mark.parametrize("fault", BROKEN)
def test_each_fault_is_found_in_each_look(critic, tmp_path, fault):
    found = complaints(critic, tmp_path, SOUND % (BROKEN[fault], ""))
    assert {one.partition(":")[0] for one in found if fault in one} == {
        "1400 light", "1400 dark", "400 light", "400 dark"
    }  # fmt: skip


@pytest.mark.parametrize("fault", WRITTEN)
def test_faults_on_a_canvas_are_found(critic, tmp_path, fault):
    (tmp_path / "plot.html").write_text(SOUND % ("", WRITTEN[fault]), encoding="utf-8")
    critic.look(400, 800, "dark")
    critic.visit(tmp_path / "plot.html")
    assert [one.partition(":")[0] for one in faults(critic)] == [fault]


def check_page(critic, model, folder, name, place=ALONE):
    try:
        wasm.wasm_compiler()
    except BuildError as error:
        pytest.skip(str(error))
    text = page(request(model), "", Run(5.0), None, place)
    (folder / f"{name}.html").write_text(text, encoding="utf-8")
    assert not look_at(critic, folder / f"{name}.html", name, folder), f"photographs are in {folder}"


@pytest.mark.parametrize("place", [ALONE, Place(embed=True)], ids=["alone", "embedded"])
def test_a_page_with_units(critic, folder, place):
    check_page(critic, measured_crane(), folder, f"page_with_units{'_embedded' * place.embed}", place)


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_the_page_of_a_model(critic, folder, name):
    check_page(critic, MODELS / f"{name}.py", folder, f"page_{name}")


@pytest.mark.parametrize(
    "found",
    [
        findings(solvers=OURS[:1], units=(("theta", "rad"), ("r", "mm"), ("energy", "kg m^2/s^2"))),
        pytest.param(findings(seed=3, name="crowded", spread=1.2), marks=pytest.mark.nightly),
    ],
    ids=["small", "crowded"],
)
def test_a_report(critic, folder, found):
    name = f"report_{found.subject.model.name}"
    write_report([found], folder / name)
    assert not look_at(critic, folder / name / "report.html", name, folder), f"photographs are in {folder}"
