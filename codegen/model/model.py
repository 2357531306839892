"""The `Model` of a mechanism: the user's description, normalised and checked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import sympy

from .canonical_text import canonical_text
from .check import checks
from .normalise import (
    MULTIPLIER,
    ModelError,
    expression,
    name_of,
    nearest_symbol,
    number,
    pairs_of,
    sequence_of,
    shown,
    t,
)
from .prescribed_inputs import PrescribedInput, with_prescribed_inputs
from .recursion_depth import expressions_in, with_room
from .statement.as_stated import as_stated, keeping, without_contacts
from .statement.constraint_rows import KINDS, NamedRows, check_names, numbered, rows_of
from .statement.contacts import contacts_of, normals_of, with_contacts
from .statement.drawing import drawing_of
from .statement.event import Event
from .statement.mechanism import Mechanism, in_rates
from .statement.states import states_of
from .statement.units import units_of
from .symbolic.equations import Equations, equations_of
from .table import Table, TableHandle, tables_in

__all__ = ["MULTIPLIER", "Event", "Model", "ModelError", "multiplier", "t"]

_MOST_ROWS = 1_000_000
Pairs = Mapping[Any, Any] | Sequence[tuple[Any, Any]]
Value = TypeVar("Value")


def multiplier(row: int | str, place: int | None = None) -> sympy.Expr:
    """Return the symbol of the multiplier of a constraint row, for `outputs`; the force of the row is -A^T lambda (7).

    Parameters
    ----------
    row
        0, 1, ...: holonomic constraints first, then nonholonomic ones, in the order of the model. Or the name of
        constraints, where the model has a mapping of constraints. Or the name of a `Contact`: its force is -multiplier.
    place
        Index among the rows of that name, counted from 0. None if the name has a single row.

    Examples
    --------
    Outputs for the force of the first row, and for a torque that is twice the second multiplier:

    >>> from eigenmotion import multiplier
    >>> outputs = {"force": -multiplier(0), "torque": 2 * multiplier(1)}
    """
    given = shown(row) if place is None else f"{shown(row)}, {shown(place)}"
    counted = row if place is None and not isinstance(row, str) else 0 if place is None else place
    if not isinstance(counted, int) or isinstance(counted, bool) or not 0 <= counted <= _MOST_ROWS:
        raise ModelError(f"multiplier({given}): the row of a constraint is counted 0, 1, 2, ...")
    if isinstance(row, str) and row.isidentifier():
        return MULTIPLIER(sympy.Symbol(row), sympy.Integer(-1 if place is None else place))
    if place is not None or isinstance(row, str):
        raise ModelError(
            f"multiplier({given}): give the number of a row, or the name of constraints and which of them."
        )
    return MULTIPLIER(sympy.Integer(row))


@dataclass(frozen=True, slots=True, init=False)
class Model(Mechanism):
    """Description of a mechanism by energies, forces and constraints. Mappings are stored as tuples of pairs.

    With n coordinates x_i [u_i], h holonomic constraint rows and m constraint rows in all:

    name : C and Python identifier, prefix of files and symbols
    coordinates : (n) x, functions of `t`
    kinetic_energy : T(x, xdot, t), or T(x, y, t) in the quasi-velocities: T2 + T1 + T0 (4) [J]
    potential_energy : V(x, t) [J]
    forces : (n) Q(x, xdot, t, inputs) [J / u_i]
    holonomic_constraints : (h) phi(x, t) = 0; their rows come first. A mapping gives them names
    nonholonomic_constraints : (m - h) rows A xdot + b = 0 (8). A mapping gives them names
    quasi_velocities : (n) or () pairs y_i, expression linear in xdot: y = P(x) xdot (3)
    parameters, inputs, initial : pairs symbol, default [float]; a missing initial value is 0
    outputs, events : pairs name, expression or Event
    scales : (n) unit of each coordinate inside the eigenproblem [u_i]
    drawing : shapes of `eigenmotion.draw`, in the plane or in space
    contacts : pairs name, Contact or Friction. Each appends a constraint row to those of its kind, and adds a
    parameter NAME_held or NAME_stuck, which is 1 while the row is active, and an event NAME
    constraint_names : the names of constraint rows, taken from mappings of constraints
    states : pairs z, zdot: first-order states, functions of `t`, and their rates, which may depend on whatever forces
    may depend on
    notes : texts about what the model leaves out, which `eigenmotion explain` prints
    units : pairs name, unit: words that pictures, pages, tables and other tools show, and nothing checks. Names are
    those of coordinates, states, parameters, inputs and outputs; "time" ("s" if others have units), "length" of the
    drawing, "energy". Units of rates follow

    Raises
    ------
    ModelError
        The model has a mistake; see `codegen.model.check.checks`.

    Examples
    --------
    >>> from sympy import cos, symbols
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from eigenmotion import Model
    >>> theta = dynamicsymbols("theta")
    >>> m, l, g = symbols("m l g", positive=True)
    >>> model = Model(
    ...     name="pendulum",
    ...     coordinates=[theta],
    ...     kinetic_energy=m * (l * theta.diff()) ** 2 / 2,
    ...     potential_energy=-m * g * l * cos(theta),
    ...     parameters={m: 1.0, l: 1.0, g: 9.81},
    ...     initial={theta: 2.0},
    ... )
    >>> model.equations().M
    Matrix([[l**2*m]])
    """

    def __init__(
        self,
        *,
        name: str,
        coordinates: Iterable[sympy.Expr],
        kinetic_energy: Any,
        potential_energy: Any = 0,
        forces: Pairs | Sequence[Any] = (),
        holonomic_constraints: Iterable[Any] | Mapping[str, Any] = (),
        nonholonomic_constraints: Iterable[Any] | Mapping[str, Any] = (),
        quasi_velocities: Pairs = (),
        parameters: Pairs = (),
        inputs: Pairs = (),
        outputs: Pairs = (),
        events: Pairs = (),
        initial: Pairs = (),
        scales: Pairs | Sequence[float] = (),
        drawing: Iterable[Any] = (),
        contacts: Pairs = (),
        constraint_names: Iterable[NamedRows] = (),
        states: Pairs = (),
        notes: Iterable[str] = (),
        units: Pairs = (),
    ) -> None:
        arguments = dict(locals())
        del arguments["self"]
        try:
            checks.check_name(name)
            with_room(arguments, lambda: self._take(arguments))
        except ModelError as error:
            if str(error).startswith(f"Model {shown(name)}"):
                raise
            raise ModelError(f"Model {shown(name)}: {error}") from error.__cause__

    def _take(self, arguments: dict[str, Any]) -> None:
        for field, value in _normalised(as_stated(arguments)).items():
            object.__setattr__(self, field, value)
        checks.check(self)

    @property
    def initial_v(self) -> tuple[float, ...]:
        """(n) [u_i / s] initial rates; P^-1 y where `initial` has quasi-velocities."""
        if self.initial_y:
            return checks.solve_rates(self, self.initial_x, self.initial_y)
        known = dict(self.initial)
        return tuple(known.get(v, 0.0) for v in self.rates)

    def equations(self) -> Equations:
        """Return M, bias, A, b, gamma as SymPy matrices in the user's symbols: M xddot + A^T lambda = bias (11).

        Expressions are simplified only where that is fast. Generated code does not use these matrices: it is derived
        independently, and checked against the energies.
        """
        return with_room(self, lambda: equations_of(self))

    def _repr_latex_(self) -> str:
        return self.equations()._repr_latex_()

    def canonical(self) -> str:
        """Return a text of all fields: models with equal texts have equal generated files."""
        text = with_room(self, lambda: canonical_text(self))
        kinds = dict.fromkeys(self.prescribed, "input")
        return text + "".join(
            f"{kinds.get(table.name, 'table')} {table.name} = {table.digest}\n" for table in self.tables
        )

    @property
    def prescribed(self) -> tuple[str, ...]:
        """Names of the inputs that prescribe a motion: those in constraints, which are tables of the time."""
        return tuple(table.name for table in self.tables if isinstance(table, PrescribedInput))

    @property
    def tables(self) -> tuple[Table, ...]:
        """The tables that the model's expressions call, sorted by name."""
        return tables_in(expressions_in(self)) if any(isinstance(p, TableHandle) for p, _ in self.parameters) else ()


def _normalised(arguments: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a Model from the arguments of its constructor."""
    coordinates = sequence_of(arguments["coordinates"], "coordinates")
    checks.check_functions_of_time("coordinates", coordinates)
    rows, names = _rows(arguments)
    fields = arguments | rows | {
        "coordinates": coordinates,
        "kinetic_energy": expression(arguments["kinetic_energy"], "kinetic_energy"),
        "potential_energy": expression(arguments["potential_energy"], "potential_energy"),
        "forces": _each(arguments["forces"], coordinates, "forces", 0, expression),
        "quasi_velocities": _expressions(arguments["quasi_velocities"], "quasi_velocities"),
        "outputs": _expressions(arguments["outputs"], "outputs"),
        "events": tuple((name, _event(entry, name)) for name, entry in pairs_of(arguments["events"], "events")),
        "scales": _each(arguments["scales"], coordinates, "scales", 1.0, number),
        "drawing": drawing_of(arguments["drawing"]),
        "contacts": contacts_of(arguments["contacts"]),
        "constraint_names": names,
        "states": states_of(arguments["states"]),
        "notes": tuple(str(note) for note in sequence_of(arguments["notes"], "notes")),
        "units": arguments["units"],
        **{kind: _numbers(arguments[kind], kind) for kind in ("parameters", "inputs", "initial")},
    }  # fmt: skip
    stated = without_contacts(fields)
    fields = dict(with_prescribed_inputs(stated))
    known = normals_of(fields).by_name
    fields["forces"] = tuple(numbered(Q, "forces", known) for Q in fields["forces"])
    fields["states"] = tuple((z, numbered(rate, f"states[{name_of(z)}]", known)) for z, rate in fields["states"])
    fields["outputs"] = tuple(
        (name, numbered(output, f"outputs[{name_of(name)}]", known)) for name, output in fields["outputs"]
    )
    fields = _with_tables(with_contacts(fields, lambda row: in_rates(row, fields["quasi_velocities"])))
    return keeping(fields | {"units": units_of(fields["units"], fields)}, stated)


def _with_tables(fields: dict[str, Any]) -> dict[str, Any]:
    """Add a parameter for each table that is called, through which a run can replace the table's numbers."""
    own = tuple(pair for pair in fields["parameters"] if not isinstance(pair[0], TableHandle))
    tables = tables_in(expressions_in(fields))
    taken = {name_of(symbol) for symbol, _ in own}
    for table in tables:
        if table.name in taken:
            raise ModelError(
                f"a table and a parameter are both named {table.name!r}. Rename one: Table(..., name=...)."
            )
    return fields | {"parameters": (*own, *((table.handle, 0.0) for table in tables))}


def _rows(arguments: dict[str, Any]) -> tuple[dict[str, tuple[sympy.Expr, ...]], tuple[NamedRows, ...]]:
    """Return constraint rows by kind, and the named rows.

    Names come from mappings. Where a kind is no mapping, the entries of `constraint_names` apply: they are those of
    another model, copied with its fields, and stay with their rows.
    """
    read = {kind: rows_of(arguments[kind], kind) for kind in KINDS}
    copied = (one for one in arguments["constraint_names"]
              if not isinstance(arguments[one.kind], Mapping) and one.is_in(read[one.kind][0]))  # fmt: skip
    found = (*copied, *(one for _, named in read.values() for one in named))
    names = tuple(sorted(found, key=lambda one: KINDS.index(one.kind)))
    rows = {kind: rows for kind, (rows, _) in read.items()}
    check_names(
        names, (name for name, _ in pairs_of(arguments["contacts"], "contacts")), {k: len(r) for k, r in rows.items()}
    )
    return rows, names


def _expressions(pairs: Any, what: str) -> tuple[tuple[Any, sympy.Expr], ...]:
    return tuple((key, expression(value, f"{what}[{name_of(key)}]")) for key, value in pairs_of(pairs, what))


def _numbers(pairs: Any, what: str) -> tuple[tuple[Any, float], ...]:
    return tuple((key, number(value, f"{what}[{name_of(key)}]")) for key, value in pairs_of(pairs, what))


def _event(entry: Any, name: str) -> Event:
    return entry if isinstance(entry, Event) else Event(expression(entry, f"events[{name}]"))


def _each(
    values: Any, coordinates: tuple[Any, ...], what: str, missing: Any, read: Callable[[Any, str], Value]
) -> tuple[Value, ...]:
    """Read one value for each coordinate, from a mapping (some coordinates) or a sequence (all of them)."""
    if isinstance(values, Mapping):
        by_coordinate = _by_coordinate(values, coordinates, what)
        entries = tuple(by_coordinate.get(x, missing) for x in coordinates)
    else:
        entries = sequence_of(values, what) or (missing,) * len(coordinates)
    if len(entries) != len(coordinates):
        raise ModelError(f"{what} has {len(entries)} entries for {len(coordinates)} coordinates. Give one for each.")
    return tuple(read(entry, f"{what}[{name_of(x)}]") for x, entry in zip(coordinates, entries, strict=True))


def _by_coordinate(values: Mapping[Any, Any], coordinates: tuple[Any, ...], what: str) -> Mapping[Any, Any]:
    for key in values:
        if key not in coordinates:
            hint = nearest_symbol(key, coordinates)
            raise ModelError(f"{what} has an entry for {shown(key)}, which is not a coordinate.{hint}")
    return values
