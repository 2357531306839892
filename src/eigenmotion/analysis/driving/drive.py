"""Forces that drive a mechanism along a prescribed motion."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, vector
from ...arguments.options import is_system, no_system
from ...arguments.signals import Inputs
from ...arguments.states import split_states, whole_v
from ...codegen.model.normalise import ModelError, shown
from ...compiled.compiled_system import CompiledSystem
from ...results.drive import Drive
from ...runtime import Actuators, CompiledModel, Prepared
from ..equilibrium.assemble import assemble
from ..inverse.actuators import actuators_of
from ..inverse.contact_modes import by_mode
from ..inverse.inverse_dynamics import required
from ..inverse.motion_arguments import Motion
from ..state.tangent_space import null_space
from .path_following import Follower
from .prescribed_paths import Path, paths_of

_AGREES = 1e-6
"""Relative difference of two rates of a state that counts as none."""
_TRIED = 8
"""Positions of a motion at which rates of states are tried."""


def drive(
    system: CompiledSystem,
    times: ArrayLike,
    motion: Mapping[Any, Any],
    *,
    actuators: Any = None,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
) -> Drive:
    """Return the forces of actuators along a prescribed motion, with the motion of the whole mechanism.

    The coordinates without a path follow from the constraints (11), exactly at each time: positions from phi = 0, rates
    from A v + b = 0. Positions that nonholonomic constraints leave open, and first-order states, are integrated.

    Parameters
    ----------
    times
        (k,) increasing [s].
    motion
        Coordinate -> path, for as many coordinates as there are degrees of freedom. A path is a number, an expression
        in `em.t`, a Table of the time, or an interpolant of SciPy. Its velocity is continuous.
    actuators
        As in `System.inverse_dynamics`; None: the coordinates of `motion`.
    x0
        A guess of the other coordinates at the first time, and the states there; over the model's `initial`.
    inputs
        As in `simulate`, without controllers. Those that are actuators are not read.

    Raises
    ------
    ModelError
        A path has a jump; too many or too few coordinates are prescribed; a dead centre is reached, where they do not
        determine the others; or actuators cannot drive the motion. Names the coordinates and the time.

    Examples
    --------
    >>> import eigenmotion as em
    >>> linkage = em.build("models/four_bar.py", formulation="lagrange")
    >>> turn = em.drive(linkage, [0.0, 0.1, 0.2], {"q1": 0.5 + 2 * em.t})
    >>> turn.actuators, turn.x.shape, turn.forces.shape
    (('q1',), (3, 3), (1, 3))
    """
    if not is_system(system):
        raise no_system("drive", system)
    c, at = system.compiled, _times(times)
    paths = paths_of(c, motion, at)
    of = actuators_of(c, tuple(path.name for path in paths) if actuators is None else actuators)
    prepared, inputs = system.prepare_both(parameters, inputs)
    signals = _signals(system, inputs, at)
    x, z = split_states(c, x0)
    start = _start(system, prepared, paths, x, float(at[0]))
    _check_count(c, prepared, paths, start, float(at[0]))
    follower = Follower(c, prepared, paths, signals, start, float(at[0]))
    rows = follower.follow(at, whole_v(c, c.initial_v, z)[c.n_coordinates :])
    return _driven(Motion(c, prepared, at, *rows, u=signals.at(at), many=True), of)


def _times(times: ArrayLike) -> Vector:
    at = np.ascontiguousarray(vector(times, "times"))
    if at.ndim != 1 or not at.size or not np.isfinite(at).all() or not (np.diff(at) > 0.0).all():
        raise ModelError(f"times is {shown(times)}. Give (k,) finite numbers that increase.")
    return at


def _signals(system: CompiledSystem, inputs: Any, at: Vector) -> Inputs:
    bound: Inputs = system.bind(inputs)
    if bound.sampled:
        raise ModelError(f"{system.name}: a controller has no values outside a run. Give numbers or signals as inputs.")
    if gap := bound.uncovered(float(at[0]), float(at[-1])):
        raise ModelError(f"{system.name}: input {system.compiled.inputs[gap[0]]!r} {gap[1]}, and times reach beyond")
    return bound


def _start(system: CompiledSystem, prepared: Prepared, paths: list[Path], x0: Any, t: float) -> Vector:
    """Return x (n + p,) at the first time, closed near the guess, with the prescribed coordinates on their paths."""
    c = system.compiled
    guess = np.array(system.begin(x0, None, t, prepared)[0][: c.n_coordinates])
    for path in paths:
        guess[path.index] = path(t)[0]
    if not c.h:
        return np.concatenate([guess, np.zeros(c.n_states)])
    try:
        closed = assemble(system, guess, t=t, parameters=prepared, keep=[path.name for path in paths])
    except ModelError as error:
        _check_count(c, prepared, paths, c.initial_x, t)
        at = ", ".join(f"{path.name} = {path(t)[0]:g}" for path in paths)
        raise ModelError(f"the paths begin at t = {t:g} with {at}, where the mechanism cannot be. {error}") from None
    if x0 is None and closed.branch and not closed.same_branch:
        raise ModelError(
            f"{c.name}: with {', '.join(f'{path.name} = {path(t)[0]:g}' for path in paths)} at t = {t:g}, the loops "
            "close another way than at the model's start. Give the other coordinates there, roughly, as x0."
        )
    return np.concatenate([closed.x, np.zeros(c.n_states)])


def _check_count(c: CompiledModel, prepared: Prepared, paths: list[Path], x: Vector, t: float) -> None:
    """Raise ModelError unless as many coordinates are prescribed as there are degrees of freedom, at x or the start."""
    freedoms = [_freedoms(c, prepared, where, t) for where in (x, c.initial_x)]
    if len(paths) in freedoms:
        return
    names = ", ".join(path.name for path in paths)
    remedy = (
        "Prescribe more, or let the others move freely: a constraint with an input prescribes a motion in `simulate`."
        if len(paths) < freedoms[0]
        else "Prescribe fewer: the constraints determine the others."
    )
    raise ModelError(
        f"{c.name} has {freedoms[0]} degree{'s' * (freedoms[0] != 1)} of freedom, and {len(paths)} "
        f"coordinate{'s are' if len(paths) > 1 else ' is'} prescribed ({names}). {remedy}"
    )


def _freedoms(c: CompiledModel, prepared: Prepared, x: Vector, t: float) -> int:
    """Return the number of independent velocities."""
    n = c.n_coordinates
    unit = 1.0 / np.sqrt(np.diag(c.factored_matrix(t, x, prepared))[:n])
    return len(null_space(c.pfaffian(t, x, prepared)[0][:, :n], unit)[0])


def _driven(motion: Motion, of: Actuators) -> Drive:
    c, n = motion.model, motion.model.n_coordinates
    forces, multipliers, _ = required(motion, of)
    u = motion.u.copy()
    for column, name in enumerate(of.names):
        if name in c.inputs:
            u[:, c.inputs.index(name)] = forces[:, column]
    motion = Motion(c, motion.prepared, motion.t, motion.x, motion.v, motion.a, u, True)
    _check_states(motion, of)
    names = of.names or c.coordinates[:n]
    return Drive(
        model=c,
        prepared=motion.prepared,
        t=motion.t,
        actuators=tuple(names),
        rows=(motion.x, motion.v, motion.a, u),
        forces=forces.T,
        multipliers=multipliers.T,
        power=_power(motion, names, forces),
        outputs=_outputs(motion, multipliers, of),
    )


def _check_states(motion: Motion, of: Actuators) -> None:
    """Raise ModelError if the rates of states depend on reactions, or on inputs that are actuators.

    They are tried at random velocities and inputs beside the motion.
    """
    c, n = motion.model, motion.model.n_coordinates
    if not c.n_states:
        return
    draws, some = np.random.default_rng(0), motion.rows(slice(None, None, max(1, len(motion.t) // _TRIED)))
    t, x, v, a, u, prepared = some.arguments
    v = v + draws.normal(size=v.shape) * (1.0 + np.abs(v))
    rates = -c.required_rows(t, x, v, 0.0 * a, u, prepared)[0][:, n:]
    free = c.acceleration_rows(t, x, v, u, prepared, 1)[0][:, n:]
    differs = np.abs(free - rates) > _AGREES * (np.abs(free) + np.abs(rates))
    for name in (name for name in of.names if name in c.inputs):
        other = u.copy()
        other[:, c.inputs.index(name)] += 1.0 + draws.random(len(t))
        differs |= c.required_rows(t, x, v, 0.0 * a, other, prepared)[0][:, n:] != -rates
    if (differs & np.isfinite(free)).any():
        name = c.coordinates[n + int(np.flatnonzero(differs.any(axis=0))[0])]
        raise ModelError(
            f"{c.name}: the rate of state {name!r} depends on a reaction or on an actuator, so that it is not "
            "known before the forces are. Drive a model without this state, and give its value by an input."
        )


def _power(motion: Motion, names: tuple[str, ...], forces: Vector) -> Vector:
    """Return the power (count, k) of each actuator."""
    c, n = motion.model, motion.model.n_coordinates
    t, x, v, a, u, prepared = motion.arguments
    made = np.empty((len(names), len(t)))
    whole = c.required_rows(t, x, v, a, u, prepared)[0][:, :n]
    for row, name in enumerate(names):
        if name in c.coordinates[:n]:
            made[row] = forces[:, row] * v[:, c.coordinates.index(name)]
            continue
        without = u.copy()
        without[:, c.inputs.index(name)] = 0.0
        made[row] = ((c.required_rows(t, x, v, a, without, prepared)[0][:, :n] - whole) * v[:, :n]).sum(axis=1)
    return made


def _outputs(motion: Motion, multipliers: Vector, of: Actuators) -> dict[str, Vector]:
    """Return name -> (k,), with the accelerations and multipliers of the driven motion."""
    c = motion.model
    made = np.empty((len(motion.t), len(c.outputs)))
    parts = by_mode(motion, of) if c.switches else [(np.arange(len(motion.t)), motion)]
    for rows, part in parts:
        t, x, v, a, u, prepared = part.arguments
        made[rows] = c.observed_rows(t, x, v, a, np.ascontiguousarray(multipliers[rows]), u, prepared)
    return {name: made[:, k] for k, name in enumerate(c.outputs)}
