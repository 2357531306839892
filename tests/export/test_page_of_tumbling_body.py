"""A page of a tumbling body: its rotation changes to the shadow parameters in WebAssembly, too."""

import numpy as np
import pytest

import eigenmotion as em

from ..support.browser import opened_page

CORNERS = np.array([(0.3, 0, 0), (0, 0.2, 0), (0, 0, -1), (0.1, 0.1, 0.1)])


def tumbling() -> em.Model:
    """A free body that turns four times in two seconds."""
    tree = em.Tree(gravity=(0, 0, 0))
    body = tree.body("body", joint="free", mass=1.0, inertia=(1.0, 2.0, 2.5))
    rates = dict(zip((q.diff() for q in tree.coordinates), (0.1, 0, 0.2, 0.2, 3.0, 0.3), strict=True))
    return em.Model(name="tumbling", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, initial=rates,
                    drawing=[em.draw.Line(body.position(), body.position((1, 0, 0))),
                             em.draw.Solid(body.position(), body.rotation, CORNERS)])  # fmt: skip


@pytest.mark.nightly
def test_it_turns_as_in_python(tmp_path):
    system = em.build(tumbling())
    run = system.simulate((0.0, 2.0), rtol=1e-11, atol=1e-12)
    assert (np.abs(np.diff(run.x[3:])).max(axis=0) > 0.5).sum() >= 3  # as many changes of the parameters
    with opened_page(tumbling(), tmp_path / "tumbling.html", 2.0) as browser:
        end = browser.ask("Array.from(eigenmotion.motion.table.slice(-eigenmotion.motion.width))")
        last = "eigenmotion.motion.about.shapes[1], eigenmotion.motion.rows - 1"
        corners = np.reshape(browser.ask(f"eigenmotion.motion.extremes({last})"), CORNERS.shape)
    (here, at), (there, place) = (system.pose("body", x) for x in (np.array(end[1:7]), run.x[:, -1]))
    assert np.abs(here - there).max() < 1e-6
    assert np.abs(at - place).max() < 1e-6
    assert np.abs(corners - (CORNERS @ there.T + place)).max() < 1e-6
    assert np.abs(corners - run.drawing.shapes[1].points[-1]).max() < 1e-6
