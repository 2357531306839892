"""Drawings: what they may hold, that they are compiled as stated, and that dynamics do not know of them."""

import re
from pathlib import Path

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.compiler import generate
from scipy.spatial.transform import Rotation
from sympy import Matrix, Symbol, cos, lambdify, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import draw
from eigenmotion.cli import main
from eigenmotion.results.pictures.animation import save_animation
from eigenmotion.results.pictures.moving_shapes import Drawing
from eigenmotion.results.pictures.outlines import nodes, outlines

from ..support.generation import system_of

MODELS = sorted(path for path in (Path(__file__).parents[2] / "models").glob("*.py") if path.stem != "__init__")
ABSTRACT = ("veering",)
q, u = dynamicsymbols("q u")
l = Symbol("l", positive=True)


def swinging(drawing, **more):
    T = (l * q.diff()) ** 2 / 2
    return em.Model(name="swinging", coordinates=[q], kinetic_energy=T, parameters={l: 2.0}, drawing=drawing, **more)


REFUSED = [
    ([1], "drawing[0] is 1, which is no shape", "eigenmotion.draw.Line"),
    ([draw.Line((0, 0), (q,))], "drawing[0] (line): q has 1 numbers", "(x, y) in the plane"),
    ([draw.Line((0, 0), (q, 0, 0))], "drawing[0] (line) has positions of 2 and of 3 numbers", "alike"),
    ([draw.Trace((0, 0)), draw.Trace((0, 0, q))], "drawing[1] (trace) has 3 numbers a position", "plane"),
    ([draw.Trace((q.diff(), 0))], "drawing[0] (trace) contains the velocity q'", "made of positions"),
    ([draw.Trace((u, 0))], "drawing[0] (trace) contains the input 'u'", "as a coordinate"),
    ([draw.Trace((Symbol("k"), 0))], "drawing[0] (trace) contains 'k', which is not declared", "Add it to parameters"),
    ([draw.Trace(("a", 0))], "drawing[0] (trace): p[x] is 'a'", "not a SymPy expression"),
    ([draw.Body([(0, 0), (1, 0)])], "drawing[0] (body) has 2 points and needs at least 3", "Add"),
    ([draw.Ground()], "drawing[0] (ground) has 0 points", "at least 1"),
    ([draw.Disk((0, 0), 1, axis=(0, 0, 1))], "drawing[0] (disk) has an axis", "Leave it out"),
    ([draw.Disk((0, 0, 0), 1, angle=q)], "drawing[0] (disk) has an angle in space", "axle"),
    (draw.Trace((0, 0)), "drawing must be a list or tuple", "Trace"),
]


@pytest.mark.parametrize(("drawing", "mistake", "remedy"), REFUSED, ids=[row[1] for row in REFUSED])
def test_mistakes_name_model_shape_and_remedy(drawing, mistake, remedy):
    with pytest.raises(em.ModelError) as error:
        swinging(drawing, inputs={u: 0.0})
    assert str(error.value).startswith(f"Model 'swinging': {mistake}")
    assert remedy in str(error.value)


def test_shapes_of_one_place_are_told_apart():
    """The hash of a model sees the kind."""
    line, spring = (swinging([kind((0, 0), (l, 0))]).canonical() for kind in (draw.Line, draw.Spring))
    assert line != spring


def test_dynamics_do_not_know_of_a_drawing():
    """But for its kernel and tables, C is the same text with and without it."""
    shapes = [draw.Line((0, 0), (l * sin(q), -l * cos(q))), draw.Disk((l * sin(q), 0), l / 7)]
    plain, drawn = (code(swinging(drawing)) for drawing in ([], shapes))
    assert "draw" not in plain.replace("withdraw", "")
    assert "em_shape" not in plain
    lost = [line for line in plain.splitlines() if line not in drawn.splitlines()]
    assert not [line for line in lost if "sha256" not in line and "N_PREPARED" not in line]
    rhs = re.compile(r"(?s)int model_rhs.*?\n}\n")
    assert rhs.search(plain)[0] == rhs.search(drawn)[0]


def code(model):
    return next(file.text for file in generate(model).files if file.name.endswith(".c"))


@pytest.mark.parametrize("path", MODELS, ids=lambda path: path.stem)
def test_every_model_has_a_drawing_or_says_why_not(path):
    drawn = em.load_model(path).drawing
    assert bool(drawn) != (path.stem in ABSTRACT)
    if not drawn:
        assert "No drawing" in path.read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["dual_link", "rolling_disk", "slider_crank"])
def test_what_is_compiled_is_what_was_stated(name):
    system = system_of(name)
    run = system.simulate((0, 0.4))
    model = em.load_model(Path(__file__).parents[2] / "models" / f"{name}.py")
    numbers = [number for shape in model.drawing for number in shape.numbers]
    symbols = [em.t, *model.coordinates, *(symbol for symbol, _ in model.parameters)]
    plain = sympy.symbols(f"s:{len(symbols)}")
    stated = lambdify(plain, [number.xreplace(dict(zip(symbols, plain, strict=True))) for number in numbers])
    for row in (0, len(run.t) - 1):
        values = stated(run.t[row], *run.x[:, row], *system.parameters.values())
        assert run.drawing.numbers[row] == pytest.approx(values, abs=1e-14)
    assert [shape.kind for shape in run.drawing.shapes] == [shape.kind for shape in model.drawing]


def test_a_mark_on_a_wheel_is_counted_from_the_line_of_nodes():
    """Euler's angles: z by phi, the line of nodes by theta, the axle by psi."""
    phi, theta = 0.7, 1.1
    axle = np.array([np.sin(theta) * np.sin(phi), -np.sin(theta) * np.cos(phi), np.cos(theta)])
    first, second = nodes(3.0 * axle)
    assert first == pytest.approx([np.cos(phi), np.sin(phi), 0.0])
    assert np.cross(first, second) == pytest.approx(axle)
    assert nodes(np.array([0.0, 0.0, 2.0]))[0] == pytest.approx([1.0, 0.0, 0.0])


def test_outlines_reach_from_point_to_point():
    numbers = np.array([[0.0, 0.0, 3.0, 4.0, 1.0, 1.0, 0.5, np.pi / 2]])
    found = outlines(Drawing("made_up", np.zeros(1), 2, (("spring", 0, 4, None), ("disk", 4, 4, None)), numbers), 0)
    spring, mark = found.lines
    assert spring[[0, -1]] == pytest.approx(np.array([[0.0, 0.0], [3.0, 4.0]]))
    assert mark == pytest.approx(np.array([[1.0, 1.0], [1.0, 1.5]]))
    assert np.hypot(*(found.wheels[0] - 1.0).T) == pytest.approx(np.full(len(found.wheels[0]), 0.5))


CORNERS = ((0.3, 0, 0), (0, 0.2, 0), (0, 0, -1), (0.1, 0.1, 0.1))


def solid(corners=CORNERS, rotation=None):
    """A solid that turns about the y axis and moves along it."""
    turned = Matrix([[cos(q), 0, sin(q)], [0, 1, 0], [-sin(q), 0, cos(q)]]) if rotation is None else rotation
    return em.Model(name="solid", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=-cos(q),
                    initial={q: 1.0}, drawing=[draw.Solid((0, 2 * q, 1), turned, corners)])  # fmt: skip


def test_corners_of_a_solid_move_with_its_frame():
    run = em.build(solid()).simulate((0, 1), t_eval=[0, 1])
    shape, angles = run.drawing.shapes[0], run.x[0]
    for row, turned in enumerate(Rotation.from_euler("y", angles[:, None])):
        assert shape.points[row] == pytest.approx(turned.apply(CORNERS) + np.array([0, 2 * angles[row], 1]), abs=1e-7)
    assert len(outlines(run.drawing, 0).faces) == 4  # of a tetrahedron


def test_a_solid_names_what_it_needs():
    with pytest.raises(em.ModelError, match=r"drawing\[0\] \(solid\) has 2 corners and needs at least 3"):
        solid(CORNERS[:2])
    with pytest.raises(em.ModelError, match=r"its rotation is 2 by 2. Give a matrix 3 by 3"):
        solid(rotation=Matrix([[1, 0], [0, 1]]))
    with pytest.raises(em.ModelError, match=r"positions of 3 and of 2 numbers|positions of 2 and of 3"):
        solid(((0, 1), (1, 0), (1, 1)))


@pytest.mark.parametrize("ending", ["gif", "html"])
def test_saving_an_animation_says_how_far_it_is(tmp_path, capsys, monkeypatch, ending):
    """Hundreds of frames take half a minute, in which nothing was seen. What is done at once says nothing."""
    pytest.importorskip("matplotlib")
    run = system_of("pendulum", "lagrange").simulate((0.0, 1.0), dense_output=True)
    moving = run.animate(fps=10)
    first = save_animation(moving, tmp_path / f"a.{ending}").read_bytes()
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("eigenmotion.progress._SELDOM", 0.0)
    assert len(save_animation(moving, tmp_path / f"b.{ending}").read_bytes()) == len(first)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 11
    assert lines[5].startswith("drawing 45 %, frame 5 of 11, ")


def test_animations_show_the_motion_frame_by_frame():
    pytest.importorskip("matplotlib")
    run = system_of("dual_link").simulate((0, 0.4), rtol=1e-9)
    moving = run.animate(speed=0.5, fps=10)
    shown = run.drawn(np.linspace(0, 0.4, 9))
    assert moving._save_count == len(shown.t)
    assert shown.numbers[-1] == pytest.approx(run.drawing.numbers[-1], abs=1e-12)
    fine = system_of("dual_link").simulate((0, 0.4), rtol=1e-9, t_eval=shown.t)
    assert shown.numbers == pytest.approx(fine.drawing.numbers, abs=1e-5)
    moving._draw_was_started = True  # no warning that it was never shown
    artists = moving._func(4)
    bars = next(layer for layer in artists if getattr(layer, "get_segments", None) and layer.get_linewidth()[0] == 3.0)
    assert bars.get_segments()[0] == pytest.approx(shown.numbers[4, 14:18].reshape(2, 2), abs=1e-12)


def test_a_model_without_a_drawing_says_how_to_give_it_one():
    run = system_of("veering").simulate((0, 0.1))
    assert run.drawing is None
    with pytest.raises(em.ModelError, match=r"veering has no drawing.*Model\(drawing="):
        run.animate()


def refused(capsys, *command):
    """What the command line says of a mistake, before anything runs."""
    assert main([*command]) == 2
    found = capsys.readouterr()
    assert "finished" not in found.out
    return found.err


def test_the_command_line_refuses_pictures_before_the_run(tmp_path, capsys, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr("eigenmotion.results.pictures.animation.shutil.which", lambda _: None)
    folder = Path(__file__).parents[2] / "models"
    pendulum, veering = str(folder / "pendulum.py"), str(folder / "veering.py")
    assert "known endings are .mp4, .gif, .html" in refused(
        capsys, "run", pendulum, "--animate", str(tmp_path / "a.avi")
    )
    assert "veering has no drawing" in refused(capsys, "run", veering, "--animate", str(tmp_path / "a.gif"))
    assert ".mp4 need ffmpeg" in refused(capsys, "run", pendulum, "--animate", str(tmp_path / "a.mp4"))
    assert "there is no folder" in refused(capsys, "page", pendulum, "-o", str(tmp_path / "no" / "a.html"))
    assert "--t-end is -1; a page needs a positive number" in refused(
        capsys, "page", pendulum, "-o", str(tmp_path / "a.html"), "--t-end", "-1"
    )
    assert not list(tmp_path.iterdir())


def test_the_command_line_prints_equations(capsys):
    pendulum = str(Path(__file__).parents[2] / "models" / "pendulum.py")
    assert main(["explain", pendulum, "--latex"]) == 0
    assert r"M &= \left[\begin{matrix}l^{2} m\end{matrix}\right]" in capsys.readouterr().out
    assert main(["explain", pendulum, "--sympy"]) == 0
    assert "M = Matrix(1, 1, [l**2*m])" in capsys.readouterr().out
    assert "choose one" in refused(capsys, "explain", pendulum, "--sympy", "--latex")
