"""Cases with extreme stiffness, masses and eigenvalues."""

from collections.abc import Mapping
from math import pi, sqrt

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import Model
from ...models import chain as chain_model
from ...models import veering as veering_model
from ..expectation.closed_forms import chain
from ..expectation.truth import Collocated, lagrange
from ..models.smooth import elastic_link, parallel_eigenvalues, triple_veering
from .case import Case, Trial, integrated, power, rows, scale_of, start_of

PERIODS = 20
SPEED = 1.0  # [m/s] initial rate of the undamped stretch
STRETCH = 1e-2  # [m] initial damped stretch


def undamped(k: float) -> Trial:
    """Return an undamped spring of stiffness k, for PERIODS periods or 2 s."""
    span = min(2.0, PERIODS * 2 * pi / sqrt(k))
    parameters, units = {"k": k, "d": 0.0}, np.array([1.0, 1.0, min(1.0, SPEED / sqrt(k))])
    x0, v0 = start_of(elastic_link())
    v0[2] = SPEED
    return integrated(power(k), lagrange(elastic_link(), parameters), parameters, x0, v0, units, rows(0.0, span))


def damped(k: float) -> Trial:
    """Return a spring with five times the critical damping, for 1 s: k = 1e10 has d = 1e6."""
    parameters, units = {"k": k, "d": 10 * sqrt(k)}, np.array([1.0, 1.0, STRETCH])
    x0, v0 = start_of(elastic_link())
    x0[2] = STRETCH
    truth = Collocated(lagrange(elastic_link(), parameters), scale_of(units, x0, v0))
    return Trial(power(k), parameters, x0, v0, units, 0.0, rows(0.0, 1.0), truth, conserves=False)


def link(parameters: Mapping[str, float], x0: Vector, v0: Vector, span: float, label: str) -> Trial:
    """Return two links of given sizes."""
    masses, lengths = (np.array([parameters.get(f"{c}_{k}", 1.0) for k in (1, 2)]) for c in "ml")
    rhs = chain(masses, lengths, parameters.get("g", 9.81))
    return integrated(label, rhs, parameters, x0, v0, np.ones(2), rows(0.0, span))


def mass_ratio(ratio: float) -> Trial:
    """Return two links with a mass ratio m_2 / m_1; a heavy mass below a light one is a stiff string with a bead."""
    fast = sqrt(9.81 * 2 * (1 + ratio))
    span = min(2.0, PERIODS * 2 * pi / fast)
    parameters = {"m_1": 1.0, "m_2": ratio} if ratio <= 1 else {"m_1": 1 / ratio, "m_2": 1.0}
    return link(parameters, np.array([0.7, 0.3]), np.zeros(2), span, power(ratio))


def short_link(length: float) -> Trial:
    """Return two links with l_2 -> 0: an eigenvalue of M is proportional to its square."""
    span = min(2.0, PERIODS * 2 * pi * sqrt(max(length, 1e-300) / 9.81)) if length else 1.0
    return link({"l_2": length}, np.array([0.7, 1.5]), np.zeros(2), span, power(length))


def _crossing(model: Model, gap: float, end: float) -> Trial:
    x0, v0 = start_of(model)
    return integrated(power(gap), lagrange(model, {"gap": gap}), {"gap": gap}, x0, v0, np.ones(len(x0)), rows(0.0, end))


_GAPS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0.0)
_STIFFNESS = tuple(10.0**e for e in range(13))


def _chain_2(_: float) -> Model:
    return chain_model.model(2)


CASES = (
    Case(
        "stiff_spring", "Spring stiffness, undamped",
        "An arm and an elastic link on a turntable (T2, T1, T0; M full and varying). The stretch starts at 1 m/s; "
        f"{PERIODS} periods of it, or 2 s.",
        "stiffness k [N/m]", _STIFFNESS, lambda _: elastic_link(), undamped,
    ),
    Case(
        "damped_spring", "Spring stiffness, heavily damped",
        "The same with five times the critical damping, d = 10 sqrt(k m): k = 1e10 has d = 1e6. Stretched by 1 cm at "
        "the start; 1 s.",
        "stiffness k [N/m]", _STIFFNESS, lambda _: elastic_link(), damped, weight=3.0,
        reduced=(1e2, 1e10),
    ),
    Case(
        "mass_ratio", "Mass ratio",
        f"A double pendulum; {PERIODS} periods of its faster swing, or 2 s.",
        "m_2 / m_1", tuple(10.0**e for e in range(-9, 10, 3)), _chain_2, mass_ratio,
    ),
    Case(
        "gap", "Eigenvalue gap, to an exact crossing",
        "Eigenvalues 2 + x/2 and 2 - x/2 that approach each other to twice the gap, again and again; 0: they cross.",
        "gap", _GAPS, lambda _: veering_model.model, lambda gap: _crossing(veering_model.model, gap, 6.0),
        reduced=(1e-8, 0.0),
    ),
    Case(
        "triple", "Triple coincidence",
        "Three eigenvalues that meet at one instant, up to a coupling of the size of the gap; 0: exactly.",
        "gap", _GAPS, lambda _: triple_veering(), lambda gap: _crossing(triple_veering(), gap, 6.0),
    ),
    Case(
        "equal", "Eigenvalues equal for ever",
        "Eigenvalues 2 + x/2 +- gap at a constant distance; 0: they are equal all the time.",
        "gap", _GAPS, lambda _: parallel_eigenvalues(), lambda gap: _crossing(parallel_eigenvalues(), gap, 6.0),
    ),
    Case(
        "short_link", "Link length to zero",
        f"A double pendulum whose second link is short; {PERIODS} periods of it, or 2 s. 0: M is singular.",
        "length l_2 [m]", (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0.0), _chain_2, short_link,
    ),
)  # fmt: skip
