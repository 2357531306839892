"""Check of the consistency of an initial state."""

from enum import IntEnum
from itertools import combinations

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...compiled.projection import Projection
from ...runtime import CompiledModel, EvaluationError, Prepared

_CLOSE = 1e-6  # EM_EPSILON: relative gap of eigenvalues below which Omega is extrapolated
_STILL = 1e-9  # relative part of dM/dx below which equal eigenvalues remain equal
_COMMAND = "On the command line, `run --assemble` closes it."


def start_state(
    model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, rtol: float, atol: Vector
) -> Vector:
    """Return y (n_state,) at x, v (n,). Checks M > 0, phi = 0, A v + b = 0, and that Omega is defined.

    The projection removes small residuals: up to ten times rtol of the terms that cancel in a row, plus what a change
    of every x_k and v_k by ten times atol_k would cause.

    Raises
    ------
    ModelError
        A check fails; names the coordinate or row, the residual, and the nearest consistent start. Or x penetrates a
        contact.
    EvaluationError
        A coordinate has a value that contradicts its declaration.
    """
    refusal, y, at, off = model.start(t, x, v, prepared, rtol, atol)
    if refusal:
        raise _refused(model, prepared, (t, x, v), (rtol, atol), (refusal, at, off))
    if model.extrapolates:
        _check_turning(model, prepared, t, x)
    return y


def check_direction(model: CompiledModel, start: float, end: float) -> None:
    """Raise ModelError for a run backwards in time with event actions: impacts and resets cannot be inverted.

    Raises
    ------
    ModelError
        The model has event actions, and `end` is before `start`.
    """
    if model.acts and end < start:
        acting = [name for name, acts in zip(model.events, model.acting, strict=True) if acts]
        raise ModelError(
            f"{model.name}: t_span runs backwards, but events that act ({', '.join(map(repr, acting))}) do so forwards "
            "only: what was before an impact or a reset does not follow from what is after it. Run forwards."
        )


def check_consistent(model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector) -> None:
    """Raise ModelError, as `start_state`, for a state that violates the constraints by more than rounding errors."""
    exactly = (0.0, np.zeros(model.n))
    refusal, _, at, off = model.start(t, x, v, prepared, *exactly)
    if refusal:
        raise _refused(model, prepared, (t, x, v), exactly, (refusal, at, off))


def _check_turning(model: CompiledModel, prepared: Prepared, t: float, x: Vector) -> None:
    """Raise ModelError if Omega (32) is extrapolated and eigenvalues that separate coincide at the start."""
    C, s = (part[0] for part in model.eigenfactor_rows(np.array([t]), x[None], prepared))
    close = [
        (i, j)
        for i, j in combinations(range(model.n), 2)
        if model.block[i] == model.block[j] and abs(s[i] ** 2 - s[j] ** 2) < _CLOSE * max(s[i], s[j]) ** 2
    ]
    if not close:
        return
    mu = C @ (model.scales[:, None] * model.factored_gradient(t, x, prepared) * model.scales) @ C.T
    size = np.abs(mu).max(initial=0.0)
    for i, j in close:
        if max(np.abs(mu[:, i, j]).max(), np.abs(mu[:, i, i] - mu[:, j, j]).max()) > _STILL * size:
            names = ", ".join(repr(name) for name, block in zip(model.coordinates, model.block, strict=True)
                              if block == model.block[i])  # fmt: skip
            raise ModelError(
                f"{model.name}: eigenvalues of the mass matrix coincide at x0, among {names}, and "
                'close_eigenvalues="extrapolate" has nothing yet to extrapolate from. Start elsewhere, or build with '
                'close_eigenvalues="bounded", which runs through.'
            )


class _Refusal(IntEnum):
    """Reasons why no motion can start at a state: em_refusal of em_start_check.h."""

    UNDECLARED = 1
    WITHOUT_INERTIA = 2
    OFF_POSITION = 3
    OFF_VELOCITY = 4
    WITHIN_CONTACT = 5
    WITHOUT_STATE = 6


def _refused(
    model: CompiledModel,
    prepared: Prepared,
    place: tuple[float, Vector, Vector],
    tolerances: tuple[float, Vector],
    why: tuple[int, int, Vector],
) -> ModelError:
    """Return the error of a start at t, x, v that was refused with rtol, atol; `why` as `CompiledModel.start`."""
    refusal, at, off = why
    model.check_start(place[1])  # raises if a value contradicts its declaration
    _check_tables(model, prepared, *place)
    if refusal == _Refusal.WITHOUT_INERTIA:
        words = _of_masses(model, prepared, place, at)
    elif refusal == _Refusal.WITHIN_CONTACT:
        words = _of_contact(model, *(model.inside(*place, prepared, *tolerances) or ("", np.nan)))
    elif refusal == _Refusal.WITHOUT_STATE:
        words = _of_state(model, prepared, *place)
    elif not np.isfinite(off).all():
        row = model.row_names[np.flatnonzero(~np.isfinite(off))[0]]
        words = f"{_NAN[_Refusal(refusal)].format(row)}. {_undefined(model, prepared, place, 'it')}"
    else:
        words = f"{_OFF[_Refusal(refusal)]} {_rows(model, off)}. {_offer(model, prepared, *place)}"
    return ModelError(f"{model.name}: {words}")


def _check_tables(model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector) -> None:
    try:
        model.check_table_arguments(t, x, v, prepared)
    except EvaluationError as error:
        raise ModelError(str(error)) from error


_OFF = {
    _Refusal.OFF_POSITION: "x0 is off holonomic constraint",
    _Refusal.OFF_VELOCITY: "v0 does not satisfy A v + b = 0 in constraint",
}
_NAN = {
    _Refusal.OFF_POSITION: "holonomic constraint {} is not finite at x0",
    _Refusal.OFF_VELOCITY: "A v + b of constraint {} is not finite at x0, v0",
}
_OF_CONSTRAINTS = (
    ", not even along the constraints",
    " The weights of the constraints are those of the model's own initial values: give it others where x0 is far away.",
)


def _undefined(model: CompiledModel, prepared: Prepared, place: tuple[float, Vector, Vector], what: str) -> str:
    return (
        f"Look in {what} for a division by zero, or a root or logarithm of a negative number, at these parameters and "
        f"this start.{model.undefined(*place, prepared)}"
    )


def _of_masses(model: CompiledModel, prepared: Prepared, place: tuple[float, Vector, Vector], coordinate: int) -> str:
    M = model.factored_matrix(*place[:2], prepared)
    if not np.isfinite(M).all():
        i, j = (model.coordinates[k] for k in np.argwhere(~np.isfinite(M))[0])
        remedy = _undefined(model, prepared, place, "the kinetic energy")
        return f"the mass matrix at x0 is not finite in row {i!r}, column {j!r}. {remedy}"
    alone, weights = _OF_CONSTRAINTS if model.augmented else ("", "")
    return (
        f"the mass matrix at x0 is not positive definite at coordinate {model.coordinates[coordinate]!r}{alone}. "
        f"Give it inertia (check x0 and the parameters in the kinetic energy), or leave the coordinate out.{weights}"
    )


def _rows(model: CompiledModel, off: Vector) -> str:
    return ", ".join(f"{name} by {r:.6g}" for name, r in zip(model.row_names, off.tolist(), strict=True) if r != 0.0)


def _offer(model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector) -> str:
    inputs = ", inputs=inputs" if model.prescribed else ""
    remedy = f"system.project_initial_state(x0, v0, t, parameters{inputs}) returns the nearest consistent start"
    try:
        x, v = Projection(model, prepared, t, least_norm=True)(x, v)
    except (EvaluationError, ModelError):
        rough = "em.assemble(system, x0) closes loops from guesses as rough as this"
        return f"{rough}; {remedy} from a closer one. {_COMMAND}"
    return f"{remedy}: x0 = {_listed(x)}, v0 = {_listed(v)}. {_COMMAND}"


def _of_contact(model: CompiledModel, name: str, gap: float) -> str:
    """Return the message about a start inside a contact, or beyond the surface of an impact."""
    if model.events.index(name) not in {switch[0] for switch in model.switches}:
        return (
            f"x0 is where the impact of event {name!r} lets nothing come: its phi is {gap:.6g}, "
            "and never negative. Start where it is at least 0, or turn the signs of phi and of the event."
        )
    return (
        f"x0 is inside contact {name!r}: its gap is {gap:.6g} there, and never negative. Start where "
        "it is at least 0, or turn the sign of the gap."
    )


def _of_state(model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector) -> str:
    try:
        model.state(t, x, v, prepared)
    except EvaluationError as error:
        raise ModelError(str(error)) from error
    return f"the state at x0, v0 is not finite. {_undefined(model, prepared, (t, x, v), 'the energies')}"


def _listed(values: Vector) -> str:
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"
