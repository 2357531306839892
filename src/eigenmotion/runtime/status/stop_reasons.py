"""Stop reasons of calls and runs, and the messages about them."""

from collections.abc import Sequence
from enum import IntEnum, StrEnum
from math import isfinite


class StopReason(StrEnum):
    """Why a simulation ended. In the order of `em_status` (em_run.h); all but the first two are failures.

    Examples
    --------
    >>> import eigenmotion as em
    >>> em.StopReason.TERMINAL_EVENT.success, em.StopReason("too many steps").success
    (True, False)
    """

    FINISHED = "finished"
    TERMINAL_EVENT = "terminal event"
    STEP_SIZE_UNDERFLOW = "step size underflow"
    TOO_MANY_STEPS = "too many steps"
    NON_FINITE_STATE = "non-finite state"
    SINGULAR_MASS_MATRIX = "singular mass matrix"
    DEPENDENT_CONSTRAINTS = "dependent constraints"
    COINCIDENT_EIGENVALUES = "coincident eigenvalues"
    POSITION_NOT_REACHED = "position not reached"
    INTERRUPTED = "interrupted"
    OUT_OF_MEMORY = "out of memory"
    FACTORS_DRIFTED = "eigenfactors drifted"
    EVENT_UNDEFINED = "event undefined"
    ENERGY_DRIFTED = "energy drifted"
    CONSTRAINTS_DRIFTED = "constraints drifted"
    START_REFUSED = "start refused"
    EVENTS_PILE_UP = "events pile up"
    IMPACT_UNDEFINED = "impact undefined"
    RESET_OFF = "reset off the constraints"
    MODEL_JUMPS = "model jumps"
    RESET_INSIDE = "reset inside an impact"
    CONTACTS_CLASH = "contacts clash"
    VALUE_REFUSED = "value refused"
    OUTSIDE_TABLE = "outside of a table"

    @property
    def success(self) -> bool:
        """Whether the run ended without a failure."""
        return self in (StopReason.FINISHED, StopReason.TERMINAL_EVENT)


class Detail(IntEnum):
    """More specific reason of a failure: em_detail of em_run.h."""

    NEARLY_SINGULAR = -2
    SINGULAR_START = -3
    CONTRADICTION = -4
    SHARED_LOAD = -5
    BAD_RESTITUTION = -6
    RESTITUTION_LOWERED = -7
    LAW_NOT_DERIVED = -8
    NO_RATES = -9
    POSITION_JUMPS = -10
    CONTACT_JUMPS = -11
    JAMMED = -12
    TOO_MANY_MODES = -13
    NORMALS_NOT_FOUND = -14
    INSIDE_CONTACT = -15
    MASS_NOT_FINITE = -16
    ROW_NOT_FINITE = -17


class EvaluationError(ArithmeticError, ValueError):
    """A compiled function has no value at its arguments.

    Attributes
    ----------
    stop
        The kind of failure, as a run would report it.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> try:
    ...     em.build(model).energy([0.0], [1.0], parameters={"l": -1.0})
    ... except em.EvaluationError as error:
    ...     print(error.stop)
    value refused
    """

    def __init__(self, message: str, stop: StopReason) -> None:
        super().__init__(message)
        self.stop = stop

    def __reduce__(self) -> tuple[type["EvaluationError"], tuple[str, StopReason]]:
        return type(self), (str(self), self.stop)


MAYBE_UNDEFINED = (StopReason.NON_FINITE_STATE, StopReason.STEP_SIZE_UNDERFLOW, StopReason.ENERGY_DRIFTED)
"""Reasons of which a term without a finite value may be the cause."""

_SIGN = " Where a force holds back by the sign of a speed, no step is short enough: that is a Friction."
_MESSAGES = {
    StopReason.FINISHED: "The end of t_span was reached.",
    StopReason.TERMINAL_EVENT: "A terminal event ended the run.",
    StopReason.STEP_SIZE_UNDERFLOW: (
        "The step size fell below the spacing of numbers{at}. Look for a singularity or a jump near this time; "
        "if there is none, loosen rtol and atol, or use a stiff method (radau9)." + _SIGN
    ),
    StopReason.TOO_MANY_STEPS: (
        "The step limit was reached. Raise max_steps, or loosen rtol and atol; where steps are short though the motion "
        "is slow, the scene is stiff: use a stiff method (radau9)." + _SIGN
    ),
    StopReason.NON_FINITE_STATE: (
        "The state or its rate is not finite{at}. Look for a division by zero or a domain error in the energies, "
        "forces or inputs near this time, or lower max_step."
    ),
    StopReason.SINGULAR_MASS_MATRIX: (
        "The mass matrix is not positive definite at coordinate {first}. "
        "Give it inertia (check the parameters in its kinetic energy), leave it out, or choose coordinates "
        "that are regular there (Euler angles are not everywhere)."
    ),
    StopReason.DEPENDENT_CONSTRAINTS: (
        "Constraint {row} depends on those before it, or vanishes. Where it always does, remove it, or, if the rows "
        'are consistent, pass dependent_constraints="auto" or, where it comes to do so on the way, '
        'dependent_constraints="least_norm". Where it does so here only, the mechanism is in or near a singular '
        "position (as a dead centre), where rounding decides between branches: start beside it, and loosen rtol, atol, "
        "with which steps pass it as the smooth motion does; without stabilisation it may have drifted: tighten rtol."
    ),
    StopReason.COINCIDENT_EIGENVALUES: (
        "Two eigenvalues of the mass matrix coincide, in the block of {first} and {second}: the published right-hand "
        'side does not exist there. Use simulate(), or build with formulation="cholesky" or "lagrange".'
    ),
    StopReason.POSITION_NOT_REACHED: (
        "Newton's method did not bring holonomic constraint {row} to zero. "
        "Start closer to a consistent position, or check that the constraints can be met together."
    ),
    StopReason.INTERRUPTED: "The run was interrupted; the result holds what was computed up to there.",
    StopReason.OUT_OF_MEMORY: "Memory ran out. Use t_eval to keep fewer rows, or dense_output=False.",
    StopReason.FACTORS_DRIFTED: (
        "Without stabilisation, C and s have drifted off the eigenfactors of the mass matrix, in the block of {first}: "
        'what is computed from them is no longer the motion. Pass stabilisation="project", tighten rtol, or build with '
        'formulation="cholesky".'
    ),
    StopReason.EVENT_UNDEFINED: (
        "The expression of event {event} is not a number there, so that nothing tells whether it passes zero. Write it "
        "so that it has a value wherever the motion goes (as x - 1 in place of log(x))."
    ),
    StopReason.ENERGY_DRIFTED: (
        "T2 - T0 + V, a constant of this motion, is not finite or has changed by far more than rtol and atol allow: "
        "what was computed is no longer the motion. Look at where the coordinates or the energies are singular (Euler "
        "angles in gimbal lock, log of a negative number) or kinked, and choose coordinates that are regular there; "
        "lower max_step where a force changes within a short distance."
    ),
    StopReason.CONSTRAINTS_DRIFTED: (
        "Without stabilisation A v + b of constraint {row} has changed by far more than rtol and atol allow: rounding "
        "of the multipliers adds up, or the constraint jumps. Loosen rtol and atol, or pass "
        'stabilisation="project"; a coordinate that has next to no inertia beside the forces on it is better left out.'
    ),
    StopReason.EVENTS_PILE_UP: (
        "Event {event} happens again and again without time passing (Zeno's way to rest): no run goes beyond. State "
        "what comes to rest as a Contact with `rest`, the speed below which it stays in contact, or end the run "
        "before by a terminal event on the speed."
    ),
    StopReason.IMPACT_UNDEFINED: (
        "The impact of event {event} has no solution: the constraints leave nothing free to move along the gradient of "
        "its phi. State one that the mechanism can open, or take it out."
    ),
    StopReason.RESET_OFF: (
        "The reset of event {event} leaves the constraints: {row} is not met after it. Let it set all that the "
        "constraint joins, or state an impact, which keeps constraints."
    ),
    StopReason.MODEL_JUMPS: (
        "The kinetic energy jumps at this time, and so the momentum of {first}: T alone does not say whether its "
        "velocity does. Let T be continuous in the time (a short ramp), or end the run here and go on from the "
        "velocities that are meant."
    ),
    StopReason.RESET_INSIDE: (
        "The reset of event {event} puts the state to where phi of the impact of {other} is negative, from where it "
        "would never come to strike. Let it leave the state where phi is at least 0."
    ),
    StopReason.CONTACTS_CLASH: (
        "Contacts and frictions clash: friction jams, and no acceleration satisfies all of them (Painleve's paradox). "
        "The choice of what holds, sticks or slides that comes closest misses the condition of {event}{other_too}. "
        "Lower the friction coefficient, or let the bodies give way a little."
    ),
    StopReason.VALUE_REFUSED: "A value was given that its symbol was not declared to have.",
    StopReason.OUTSIDE_TABLE: (
        'The motion leaves the range of {table}. Give it more points, state outside="hold", "extend" or '
        '"periodic", or end the run before by a terminal event.'
    ),
    StopReason.START_REFUSED: "No motion starts from these parameters and this start.",
}


_DETAILS = {
    Detail.NEARLY_SINGULAR: (
        "The mass matrix comes so near to being singular at coordinate {first} that no step is short enough to follow "
        "it, or rounding leaves fewer digits of it than rtol asks for. Choose coordinates that are regular there "
        "(Euler angles are not everywhere); where rounding is in the way, loosen rtol."
    ),
    Detail.SINGULAR_START: (
        "Constraint {row} depends on others at the start, and no longer beside it: the start is a singular position, "
        "at which the accelerations are not determined by the state. Start beside it, on the branch that is meant."
    ),
    Detail.CONTRADICTION: (
        "Constraint {row} contradicts those it depends on: no motion satisfies them all. Correct or remove one of them."
    ),
    Detail.SHARED_LOAD: (
        "Friction is in proportion to the multiplier of constraint {row}, which is not unique: rows depend on each "
        "other. Leave out redundant ones, or state the normal force in the limit."
    ),
    Detail.BAD_RESTITUTION: (
        "The restitution of event {event} is not from 0 (plastic) to 1 (elastic) there. Give it such a value."
    ),
    Detail.RESTITUTION_LOWERED: (
        "The restitution of event {event} is lowered there, for with friction it would raise the energy: its "
        "derivative is not known. Give a restitution of 0, or less friction."
    ),
    Detail.LAW_NOT_DERIVED: (
        "The derivative of an impact by Poisson's law, or in which a friction cone slips, is not known: event "
        "{event}. State Newton's law, or frictions along lines."
    ),
    Detail.NO_RATES: (
        "The reset of event {event} gives quasi-velocities where P of y = P(x) xdot (3) is singular, so that nothing "
        "follows of the rates. Give the rates."
    ),
    Detail.POSITION_JUMPS: (
        "Holonomic constraint {row} jumps at this time: no motion goes there at once. Let it be continuous in the "
        "time (a ramp)."
    ),
    Detail.CONTACT_JUMPS: (
        "The speed of a contact that holds, constraint {row}, jumps at this time: whether it kicks or lets go is not "
        "stated. Let the speed be continuous in the time (a short ramp)."
    ),
    Detail.JAMMED: (
        "Friction jams: no acceleration satisfies the contacts with it (Painleve's paradox). Lower its coefficient."
    ),
    Detail.TOO_MANY_MODES: (
        "Of so many contacts and frictions at once, {event} among them, none of the modes tried is consistent. Close "
        "fewer."
    ),
    Detail.NORMALS_NOT_FOUND: (
        "What presses on frictions is not found: Newton's method goes round in circles. Lower the friction "
        "coefficients."
    ),
    Detail.INSIDE_CONTACT: (
        "The start is inside contact {event}, whose gap is never negative. Start where it is at least 0."
    ),
    Detail.MASS_NOT_FINITE: (
        "The mass matrix is not finite at coordinate {first}. Look in the kinetic energy for a division by zero, or a "
        "root or logarithm of a negative number, at this time, these parameters and coordinates."
    ),
    Detail.ROW_NOT_FINITE: (
        "Constraint {row} is not finite. Look in it for a division by zero, or a root or logarithm of a negative "
        "number, at this time, these parameters and coordinates."
    ),
}


def named_rows(names: Sequence[str], m: int) -> tuple[str, ...]:
    """Return labels of m constraint rows for messages: the name, or the number of a row without one."""
    return tuple(next(iter(names[k : k + 1]), "") or f"row {k}" for k in range(m))


_AT_FAULT = {
    StopReason.SINGULAR_MASS_MATRIX: "pivot", StopReason.DEPENDENT_CONSTRAINTS: "pivot",
    StopReason.COINCIDENT_EIGENVALUES: "gap", StopReason.POSITION_NOT_REACHED: "residual",
    StopReason.RESET_OFF: "residual", StopReason.STEP_SIZE_UNDERFLOW: "step size",
}  # fmt: skip
"""What the size of a fault is, where it is not just a value."""


def explain(
    stop: StopReason,
    coordinates: Sequence[str],
    first: int = -1,
    second: int = -1,
    size: float = float("nan"),
    events: Sequence[str] = (),
    rows: Sequence[str] = (),
    tables: Sequence[str] = (),
) -> str:
    """Return the message of a stop: what happened, where, and what to do.

    Parameters
    ----------
    coordinates
        (n) names of the coordinates.
    first, second
        Indices of coordinates, constraint rows or events, as in `em_fault`; -1: none. `second` may be a Detail.
    size
        The pivot, gap or residual at fault.
    events, rows
        Names of the events, and labels of the constraint rows from `named_rows`.
    tables
        Names of the tables.
    """

    def name(k: int, names: Sequence[str] = coordinates) -> str:
        return f"'{names[k]}'" if 0 <= k < len(names) else "(unknown)"

    words = _MESSAGES[stop] if second >= -1 else _DETAILS[Detail(second)]
    at = f" at coordinate {name(first)}" if first >= 0 else ""
    number = second if stop is StopReason.RESET_OFF else first
    row = rows[number] if 0 <= number < len(rows) else f"row {number}" if number >= 0 else "(row unknown)"
    row += " (counted from 0)" if row == f"row {number}" else ""
    too = f", the next that of {name(second, events)}" if second >= 0 else ""
    of_events = {"event": name(first, events), "other": name(second, events), "other_too": too}
    table = f"table {name(first, tables)} at {size:.9g}" if tables else "a table"
    text = words.format(first=name(first), second=name(second), row=row, at=at, table=table, **of_events)
    if stop is StopReason.OUTSIDE_TABLE:
        return text
    return f"{text} (The {_AT_FAULT.get(stop, 'value')} is {size:.3g}.)" if first >= 0 and isfinite(size) else text
