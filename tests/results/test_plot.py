"""Pictures: what they say about a run, read back from the figure."""

from xml.etree import ElementTree

import numpy as np
import pytest
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.presentation.figures import save
from eigenmotion.results.output import ensemble_plot

from ..support.generation import system_for, system_of

pytest.importorskip("matplotlib")
x, y = dynamicsymbols("x y")


def ball(names: str = "x y") -> em.System:
    x, y = dynamicsymbols(names)
    return system_for(
        em.Model(
            name="thrown_ball",
            coordinates=[x, y],
            kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
            potential_energy=10 * y**2,
            initial={x.diff(): 1, y: 1},
            events={"floor": y, "gone": em.Event(x - 3, terminal=True), "never": y - 2},
        )
    )


def springs(count: int) -> em.System:
    """Masses that do not know of each other; all end close together."""
    x = dynamicsymbols(f"theta_1:{count + 1}")
    rates = sum(q.diff() ** 2 for q in x) / 2
    V = sum(k * q**2 for k, q in enumerate(x)) / 2
    initial = dict.fromkeys(x, 1)
    return system_for(
        em.Model(name="springs", coordinates=x, kinetic_energy=rates, potential_energy=V, initial=initial), "lagrange"
    )


def lines(axes):
    return [line for line in axes.get_lines() if not line.get_label().startswith("_")]


@pytest.mark.parametrize("count", [2, 9, 20])
def test_no_two_lines_look_alike_without_colour(count):
    system = springs(count)
    axes = system.simulate((0, 0.1)).plot().axes[0]
    assert [line.get_label() for line in lines(axes)] == list(system.coordinates)
    looks = [(line.get_linestyle(), line.get_marker()) for line in lines(axes)]
    assert len(set(looks)) == count


def test_each_name_stands_at_the_end_of_its_line_and_on_no_other():
    system = springs(9)
    run = system.simulate((0, 0.1))
    axes = run.plot().axes[0]
    places = [text.get_position()[1] for text in axes.texts]
    assert [text.get_text() for text in axes.texts] == [f"$\\theta_{{{k}}}$" for k in range(1, 10)]
    assert np.array_equal(np.argsort(places), np.argsort(run.x[:, -1]))
    assert np.diff(np.sort(places)).min() > 0.03
    assert 0 <= min(places) <= max(places) <= 1


def test_events_are_marked_when_they_happened():
    run = ball().simulate((0, 10), dense_output=True)
    axes, strip = run.plot().axes
    assert [label.get_text() for label in strip.get_yticklabels()] == ["floor", "gone", "never"]
    assert [list(row.get_positions()) for row in strip.collections] == [list(times) for times in run.t_events]
    assert len(run.t_events[0]) > 3
    assert axes.get_xlim() == (0.0, pytest.approx(3.0))


def test_axes_of_a_model_without_units_name_none():
    first, last = ball().simulate((0, 1)).plot().axes
    assert last.get_xlabel() == "time $t$"
    assert first.get_ylabel() == "coordinates"


def test_outputs_have_axes_of_their_own_and_names_choose():
    q = dynamicsymbols("q")
    model = em.Model(
        name="swing", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=q**2 / 2, initial={q: 1},
        outputs={"square": q**2, "tenfold": 10 * q},
    )  # fmt: skip
    run = system_for(model).simulate((0, 3), dense_output=True)
    axes = run.plot().axes
    assert [one.get_ylabel() for one in axes] == ["coordinates", "square", "tenfold"]
    t, square = axes[1].get_lines()[0].get_data()
    np.testing.assert_allclose(square, np.cos(t) ** 2, atol=1e-5)
    rates, energy = run.plot("q'", "energy").axes
    assert rates.get_ylabel() == "$\\dot{q}$"
    np.testing.assert_allclose(rates.get_lines()[0].get_ydata(), -np.sin(t), atol=1e-5)
    np.testing.assert_allclose(energy.get_lines()[0].get_ydata(), 0.5, atol=1e-5)
    with pytest.raises(em.ModelError, match=r"unknown column 'squares'.*square"):
        run.plot("squares")
    with pytest.raises(em.ModelError, match="unknown column 't'"):
        run.plot("t")


def test_named_multipliers_have_axes_and_numbered_ones_none():
    p, q = dynamicsymbols("p q")
    model = em.Model(
        name="held", coordinates=[p, q, x], kinetic_energy=(p.diff() ** 2 + q.diff() ** 2 + x.diff() ** 2) / 2,
        potential_energy=2 * p + 3 * q, holonomic_constraints={"pin": [p, q]}, nonholonomic_constraints=[x.diff()],
    )  # fmt: skip
    run = system_for(model).simulate((0, 1), dense_output=True)
    _, axes = run.plot().axes
    assert axes.get_ylabel() == "multipliers of pin"
    assert [line.get_label() for line in lines(axes)] == ["pin[0]", "pin[1]"]
    ends = [line.get_ydata()[-1] for line in lines(axes)]
    np.testing.assert_allclose(ends, [-2.0, -3.0], atol=1e-9)  # -A^T lambda carries the weights


def test_multipliers_of_contacts_and_frictions_have_their_names():
    z = dynamicsymbols("z")
    model = em.Model(
        name="stone", coordinates=[x, y, z], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=10 * z, initial={x.diff(): 3.0, y.diff(): 4.0},
        contacts={"floor": em.Contact(z), "slip": em.Friction([x.diff(), y.diff()], limit=0.3, normal="floor")},
    )  # fmt: skip
    run = system_for(model, "lagrange").simulate((0, 1), dense_output=True)
    _, floor, slip, _ = run.plot().axes
    assert (floor.get_ylabel(), slip.get_ylabel()) == ("multiplier of floor", "multipliers of slip")
    np.testing.assert_allclose(lines(floor)[0].get_ydata(), -10.0, atol=1e-9)  # -A^T lambda carries the weight
    assert [line.get_label() for line in lines(slip)] == ["slip[0]", "slip[1]"]


def test_medians_join_swept_values_and_not_sampled_ones():
    swept = {"k": np.array([1.0, 1.0, 1.0, 2.0, 2.0]), "m": np.arange(5.0)}
    final = np.array([[1.0], [2.0], [9.0], [4.0], [np.nan]])
    axes = ensemble_plot.ends("", ["q"], swept, final, sampled=["m"]).axes[0]
    dots, medians = axes.get_lines()
    assert len(dots.get_xdata()) == 5
    assert [list(values) for values in medians.get_data()] == [[1.0, 2.0], [2.0, 4.0]]
    assert axes.get_xlabel() == "k, swept: circles are medians"
    axes = ensemble_plot.ends("", ["q"], dict(reversed(swept.items())), final, sampled=["m"]).axes[0]
    assert len(axes.get_lines()) == 1
    assert axes.get_xlabel() == "m, sampled"


def test_a_coordinate_takes_the_place_of_the_time():
    run = ball().simulate((0, 10), dense_output=True)
    axes, strip = run.plot(over="x").axes
    [line] = lines(axes)
    assert (line.get_label(), strip.get_xlabel()) == ("y", "$x$")
    x, y = line.get_data()
    np.testing.assert_allclose(y, np.cos(np.sqrt(20) * x), atol=1e-5)  # x = t
    assert [list(row.get_positions()) for row in strip.collections] == [list(places[:, 0]) for places in run.y_events]
    circle, _ = run.plot("y'", over="y").axes  # which turns back
    assert circle.get_xlim() == (pytest.approx(-1, abs=1e-3), pytest.approx(1, abs=1e-3))


def test_units_are_raised_in_pictures():
    model = em.Model(name="fall", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=-10 * x,
                     outputs={"g": 10 * x.diff() ** 0, "p": x.diff()},
                     units={x: "m", "g": "m/s^2", "p": "kg m s^-1", "energy": "kg m^2/s^2", "time": "s"})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0, 1), dense_output=True)
    assert [axes.get_ylabel() for axes in run.plot().axes] == ["$x$ [m]", "$g$ [m/s²]", "$p$ [kg·m·s⁻¹]"]
    assert run.plot("energy", over="x").axes[0].get_xlabel() == "$x$ [m]"
    assert run.plot("energy").axes[0].get_ylabel() == "energy [kg·m²/s²]"
    head, _, _ = run.at([0, 1]).to_csv().partition("\n")
    assert head == "t [s],x [m],x' [m/s],energy [kg m^2/s^2],g [m/s^2],p [kg m s^-1]"  # as given


def test_axes_are_named_by_what_is_on_them():
    a, b, i, j = dynamicsymbols("a b i j")
    model = em.Model(name="named", coordinates=[x, y, a, b], kinetic_energy=sum(q.diff() ** 2 for q in (x, y, a, b)),
                     states={i: x, j: a}, units={x: "m", y: "m", a: "rad", b: "rad", i: "A", j: "rad"})  # fmt: skip
    labels = [axes.get_ylabel() for axes in system_for(model, "lagrange").simulate((0, 1)).plot().axes]
    assert labels == ["coordinates [m]", "coordinates and states\n[rad]", "$i$ [A]"]


def test_many_outputs_share_axes():
    q = dynamicsymbols("q")
    outputs = {f"out_{k}": k * q for k in range(9)}
    model = em.Model(name="many", coordinates=[q], kinetic_energy=q.diff() ** 2, initial={q: 1}, outputs=outputs)
    _, shared = system_for(model).simulate((0, 1)).plot().axes
    assert shared.get_ylabel() == "outputs"
    places = np.sort([text.get_position()[1] for text in shared.texts])
    assert len(places) == 9
    assert np.diff(places).min() * shared.get_gridspec().get_height_ratios()[1] > 0.17  # inches: no two overlap


@pytest.mark.parametrize("name", ["pendulum", "sphere"])
def test_the_mechanism_claims_no_unit(name):
    """A model may be in millimetres."""
    figure = system_of(name).simulate((0, 0.1)).plot()
    labels = {axes.get_title(): (axes.get_xlabel(), axes.get_ylabel()) for axes in figure.axes}
    assert labels["$t$ = 0.1"] == ("$x$", "$y$")


@pytest.mark.parametrize("span", [(0, 0), (0, -2)])
def test_odd_spans_are_drawn(span):
    figure = system_of("pendulum").simulate(span, dense_output=True).plot()
    figure.canvas.draw()
    assert figure.axes[0].get_lines()[0].get_marker() == "o"


def test_names_that_are_no_mathematics_are_written_as_they_are():
    system = ball("x_ _y__z")
    figure = system.simulate((0, 1)).plot()
    figure.canvas.draw()
    assert all(Symbol(name).name.strip("_")[0] in text.get_text() for name, text in
               zip(system.coordinates, figure.axes[0].texts, strict=True))  # fmt: skip


@pytest.mark.filterwarnings("ignore:Glyph")
@pytest.mark.parametrize("name", ["a\x1bb", "\x0c", "$\\foo$", "a$b"])
def test_any_name_can_be_read_in_a_picture(tmp_path, name):
    """A control character made an .svg unreadable, and mathematics that is none ended a sweep after its runs."""
    values = np.array([1.0, 2.0, 3.0])
    x = np.ones((3, 1, 2))
    pictures = [
        ensemble_plot.over_time(name.replace("$", ""), [name], values[:2], x),
        ensemble_plot.ends("ends", [name], {name: values}, x[:, :, 0]),
        ensemble_plot.over_grid("grid", [name], {"b": [1.0], name: values.tolist()}, x[:, :, 0]),
    ]
    for picture in pictures:
        root = ElementTree.parse(save(picture, tmp_path / "ends.svg")).getroot()
        assert root.tag.endswith("svg")
