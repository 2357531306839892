"""Whether a compiled model is the model: its answers at random places against the user's own expressions."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator

import numpy as np

from ...arguments.names import Vector
from ...codegen.model import Model
from ...running.methods import METHODS
from ...system.system import System
from ..errors import BuildError
from .augmented import factored
from .first_steps import first_steps
from .found import Found, ask
from .identities import Identity, expressions, motion
from .places import HAIR, Places, draw
from .rates import rates
from .stated import Stated, evaluate

TOLERANCE = 1e-6
"""A sum of terms that vanishes is off by this part of the terms at the most: rounding is far below, faults above."""
_DOUBT = 1e-3 / HAIR
"""How much of what a hair's change does to the terms counts as their size: an ill-conditioned place proves less."""
_ATTEMPTS = 3
_log = logging.getLogger("eigenmotion")


class ProofError(BuildError):
    """The compiled model is not what its energies, forces and constraints say; names the term and the state.

    Examples
    --------
    It is an error of the compiler or of this program, not of the model; `formulation` or `flags` may lead around it.

    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> try:
    ...     system = em.build(model)
    ... except em.ProofError:
    ...     system = em.build(model, flags="-O1")
    """


def prove(model: Model, system: System, methods: Iterable[str] = tuple(METHODS)) -> None:
    """Hold a compiled model against what the user stated, at random places.

    Lagrange's equations and the constraints, differentiated, hold for the accelerations and multipliers found;
    M, A, energies, quasi-velocities, outputs and events are those of the expressions; the right-hand side is the
    rate of the state; and the first steps of runs by `methods` go as the accelerations say. Derivatives are taken in
    hyper-dual numbers, so that nothing is shared with the generator.

    Raises
    ------
    ProofError
        One of these does not hold.
    """
    _prove_identities(model, system)
    prove_methods(model, system, methods)


def prove_methods(model: Model, system: System, methods: Iterable[str]) -> None:
    """Hold the first steps of runs by compiled methods, explicit ones first, against accelerations that are proved.

    Raises
    ------
    ProofError
        A method is off.
    """
    for method, what in first_steps(system, methods):
        raise ProofError(f"{model.name}: what was compiled is not the model: a run by {method} {what} {_rest(system)}")


def _prove_identities(model: Model, system: System) -> None:
    """Try places until each term had a value somewhere, and name those that had none."""
    for attempt in range(_ATTEMPTS):
        unproved, silent = _compare(model, system, draw(system, attempt))
        if not unproved:
            return
    if silent:
        _log.warning("%s: not proved: no state was found at which the model has an acceleration", model.name)
    for name in unproved:
        _log.info("%s: not proved: %s has no value at the states tried", model.name, name)


def _compare(model: Model, system: System, places: Places) -> tuple[list[str], bool]:
    """Return what the places say nothing about, by the first names, and whether nothing moves at any of them."""
    found = ask(system, places)
    stated = evaluate(model, places, found)
    if stated.unknown:
        _log.info("%s: not proved where %s stands", model.name, ", ".join(sorted(stated.unknown)))
    unproved: list[str] = []
    with np.errstate(all="ignore"):
        for identity in _identities(model, system, places, found, stated):
            error = _error(identity, places.drawn)
            _refuse(model, system, places, identity, error)
            blind = np.isnan(error).all(axis=0)
            unproved += np.array(identity.names)[blind][:1].tolist()
    return unproved, bool(np.isnan(found.a).all())


def _identities(model: Model, system: System, places: Places, found: Found, stated: Stated) -> Iterator[Identity]:
    yield from expressions(model, places.v, found, stated)
    yield from motion(model, places.v, found, stated)
    stated, added = factored(system, found, stated)
    yield from added
    yield from rates(system, places.v, found, stated)


def _error(identity: Identity, drawn: int) -> Vector:
    """(drawn, r): what is left of each sum, relative to its terms; NaN where that says nothing."""
    terms = np.array([np.array(term).reshape(3, drawn, -1) for term in identity.terms])
    noise = np.abs(terms[:, 1:] - terms[:, :1]).max(axis=1).sum(axis=0)
    size = np.abs(terms[:, 0]).sum(axis=0) + _DOUBT * noise
    size += np.broadcast_to(identity.size, (3 * drawn, size.shape[1]))[:drawn]
    left = np.abs(terms[:, 0].sum(axis=0))
    error = np.where(left == 0.0, 0.0 * size, left / size)
    if identity.always:
        answered, valued = np.isfinite(terms[0]), np.isfinite(terms[1:])
        error[(valued.all(axis=(0, 1)) & ~answered[0])] = np.inf
    return np.asarray(error)


def _refuse(model: Model, system: System, places: Places, identity: Identity, error: Vector) -> None:
    """Raise ProofError where an error is larger than rounding makes it."""
    wrong = np.argwhere(error > TOLERANCE)
    if len(wrong) == 0:
        return
    place, row = max(wrong.tolist(), key=lambda at: (-at[0], error[tuple(at)]))
    raise ProofError(
        f"{model.name}: what was compiled is not the model: {identity.names[row]} is off by {error[place, row]:.1e} of "
        f"its terms at {places.described(place, system)} {_rest(system)}"
    )


def _rest(system: System) -> str:
    return (
        f"({system.formulation}). Nothing is kept of this build. This is a fault of eigenmotion or of the C compiler, "
        'not of the model: please report it; flags="-O1" or another compiler may do until it is mended'
    )
