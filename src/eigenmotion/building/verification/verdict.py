"""Proof of a build: the compiled model is compared with the user's expressions at random points."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator

import numpy as np

from ...arguments.methods import METHODS
from ...arguments.named_values import Vector
from ...codegen.model import Model
from ...codegen.model.statement.mechanism import Mechanism
from ...codegen.model.statement.states import as_mechanism
from ...codegen.model.tree.functions import BodyFunction
from ...system.system import System
from ..errors import BuildError
from .arithmetic.rounding_bounds import FACTOR
from .compiled_values import CompiledValues, evaluate_compiled
from .first_steps import first_steps
from .identities import Identity, equations, expressions, motion
from .regularised_mass import factored
from .solve_errors import errors
from .state_rates import rates, recovered
from .symbolic_values import SymbolicValues, evaluate
from .test_points import Points, draw

KNOWN = 1e-3
"""An identity whose rounding bound exceeds this part of its terms decides nothing."""
FEW = 12
"""Number of coordinates up to which every entry of M is compared; of more, M v, unless the rate of M is needed."""
_ATTEMPTS = 3
_log = logging.getLogger("eigenmotion")


class ProofError(BuildError):
    """The compiled model disagrees with its energies, forces or constraints; names the term and the state.

    Examples
    --------
    This is an error of the compiler or of this program, not of the model. Another `formulation` or `flags` may help.

    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> try:
    ...     system = em.build(model)
    ... except em.ProofError:
    ...     system = em.build(model, flags="-O1")
    """

    disproves = True
    """What was compiled is wrong, and not merely missing: a run does not go on without it."""


def prove(model: Model, system: System, methods: Iterable[str] = tuple(METHODS)) -> None:
    """Check a compiled model against the user's expressions at random points.

    The computed accelerations and multipliers satisfy Lagrange's equations and the differentiated constraints; M, A,
    energies, quasi-velocities, outputs and events equal the expressions; the right-hand side is the rate of the state;
    and the first steps of runs by `methods` agree with the accelerations. Derivatives are computed in hyper-dual
    numbers, so that nothing is shared with the generator.

    Raises
    ------
    ProofError
        One of these checks fails.
    """
    _prove_identities(as_mechanism(model), system)
    prove_methods(model, system, methods)


def prove_methods(model: Model, system: System, methods: Iterable[str]) -> None:
    """Check the first steps of runs by compiled methods, explicit ones first, against the proved accelerations.

    Raises
    ------
    ProofError
        The steps of a method are wrong.
    """
    for method, what in first_steps(system, methods):
        raise ProofError(f"{model.name}: what was compiled is not the model: a run by {method} {what} {_rest(system)}")


def _prove_identities(model: Mechanism, system: System) -> None:
    """Check the identities at new points until each of them was decided at some point; log the others."""
    for attempt in range(_ATTEMPTS):
        unproved, silent = _compare(model, system, draw(system, attempt))
        if not unproved:
            return
    if silent:
        _log.warning("%s: not proved: no state was found at which the model has an acceleration", model.name)
    for name in unproved:
        _log.info("%s: not proved: %s has no value, or is all rounding, at the states tried", model.name, name)


def _compare(model: Mechanism, system: System, points: Points) -> tuple[list[str], bool]:
    """Return the names of identities that no point decides, and whether the model has no acceleration at any point."""
    compiled = evaluate_compiled(system, points)
    trusted = system.compiled.n > FEW and "v" in system.layout and not system.compiled.augmented
    symbolic = evaluate(model, points, compiled, recovered(system, points.v, compiled), trusted)
    if symbolic.unknown:
        _log.info("%s: not proved where %s stands", model.name, ", ".join(sorted(symbolic.unknown)))
    unproved: list[str] = []
    with np.errstate(all="ignore"):
        for identity in _identities(model, system, points, compiled, symbolic, trusted):
            left, bound, size = _judged(identity)
            _refuse(model, system, points, identity, left, bound)
            blind = ~(FACTOR * bound <= KNOWN * size).any(axis=0)
            unproved += np.array(identity.names)[blind][:1].tolist()
    return unproved, bool(np.isnan(compiled.a).all())


def _identities(
    model: Mechanism, system: System, points: Points, compiled: CompiledValues, symbolic: SymbolicValues, trusted: bool
) -> Iterator[Identity]:
    yield from expressions(model, points.v, compiled, symbolic, trusted)
    whole, added = factored(system, compiled, symbolic)
    yield from added
    recursive = any(one.has(BodyFunction) for one in (model.kinetic_energy, model.potential_energy))
    off = errors(compiled, whole, equations(compiled, symbolic), recursive)
    yield from motion(model, points.v, compiled, symbolic, off)
    yield from rates(system, points.v, compiled, whole, off)


def _judged(identity: Identity) -> tuple[Vector, Vector, Vector]:
    """Return residual, rounding bound and size of the terms of each sum, (k, r) each; NaN where unknown."""
    values, bounds = (np.array([getattr(term, part) for term in identity.terms]) for part in ("value", "bound"))
    left, bound = np.abs(values.sum(axis=0)), bounds.sum(axis=0) + identity.more
    size = np.maximum(np.abs(values).sum(axis=0), identity.scale)
    if len(values) > 1:  # all terms but one are exactly zero: the other then is zero within its rounding, which decides
        size = np.where((np.count_nonzero(values, axis=0) <= 1).all(axis=0), np.inf, size)
    if identity.always:
        unanswered = ~np.isfinite(values[0]) & np.isfinite(values[1:]).all(axis=0)
        others = bounds[1:].sum(axis=0) + identity.more
        silent = unanswered & (FACTOR * others <= KNOWN * np.abs(values[1:]).sum(axis=0))
        left, bound = np.where(silent, np.inf, left), np.where(silent, others, bound)
    return left, bound, size


def _refuse(model: Mechanism, system: System, points: Points, identity: Identity, left: Vector, bound: Vector) -> None:
    """Raise ProofError with the identity and the point of a residual above its rounding bound."""
    wrong = np.argwhere(left > FACTOR * bound)
    if len(wrong) == 0:
        return
    place, row = max(wrong.tolist(), key=lambda at: (-at[0], left[tuple(at)] / bound[tuple(at)]))
    raise ProofError(
        f"{model.name}: what was compiled is not the model: {identity.names[row]} is off by {left[place, row]:.1e}, "
        f"where rounding makes {bound[place, row]:.1e}, at {points.described(place, system)} {_rest(system)}"
    )


def _rest(system: System) -> str:
    return (
        f"({system.formulation}). Nothing is kept of this build. This is a fault of eigenmotion or of the C compiler, "
        'not of the model: please report it; flags="-O1" or another compiler may do until it is mended'
    )
