"""Unilateral contacts and Coulomb friction: constraint rows that are active at times only.

`with_contacts` translates each contact or friction into ordinary parts of a mechanism: constraint rows and forces with
a factor that is 1 while they are active and 0 otherwise, and an event at which this factor may change.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import ModelError, expression, name_of, pairs_of, rate_of, shown
from .constraint_rows import KINDS, Normal, Normals, normal_of
from .event import Event, restitution_of

LAWS = ("newton", "poisson")


@dataclass(frozen=True, slots=True)
class Contact:
    """Unilateral contact of two bodies: gap(x, t) >= 0.

    When the gap closes, the bodies collide as in `Event.impact`. If they would separate no faster than `rest`, they
    stay together: gap = 0 is a constraint until its multiplier changes sign.

    Parameters
    ----------
    gap
        The distance between the bodies, a function of x and t.
    restitution
        Coefficient of restitution, 0 to 1, a function of x, xdot, t and inputs.
    rest
        [unit of gap / s] The bodies stay together if the gap's rate after an impact is at most this.
    law
        "newton" (restitution of velocities, Moreau's form) or "poisson" (restitution of impulses). All contacts of a
        model have the same law.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from eigenmotion import Contact
    >>> z = dynamicsymbols("z")
    >>> contacts = {"floor": Contact(z, restitution=0.9, rest=1e-3)}
    """

    gap: Any
    restitution: Any = 0
    rest: Any = 0
    law: str = "newton"

    def __post_init__(self) -> None:
        object.__setattr__(self, "gap", expression(self.gap, "The gap of a contact"))
        object.__setattr__(self, "restitution", restitution_of(self.restitution, "The restitution of a contact"))
        object.__setattr__(self, "rest", expression(self.rest, "rest of a contact"))
        if self.rest.is_number and not self.rest >= 0:
            raise ModelError(f"rest of a contact is {self.rest}. It is a speed: give 0 or more.")
        if self.law not in LAWS:
            raise ModelError(f"law of a contact is {shown(self.law)}. Give one of {', '.join(LAWS)}.")


@dataclass(frozen=True, slots=True)
class Friction:
    """Coulomb friction: sticks while the force needed is at most `limit`, otherwise slides against a force of `limit`.

    Parameters
    ----------
    slip
        The sliding velocity, linear in the velocities. Two orthogonal ones of the same unit, (slip_1, slip_2), define a
        friction cone: the force is opposite to the slip in any direction. (Two separate frictions define a box.)
    limit
        [J / integral of slip] The friction coefficient times the normal force, a function of x, xdot, t and inputs;
        with `normal`, the coefficient alone. A negative value counts as 0.
    normal
        The rows whose multipliers are the normal force: the name of a Contact, the name of constraints, the number of a
        row as in `multiplier`, or several of these. The normal force of several rows is the norm of their multipliers,
        as in a bearing with two reactions. None: `limit` contains the normal force.
    limit_at_rest
        The static limit, like `limit`, where it exceeds the limit of sliding. None: `limit`.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from eigenmotion import Friction
    >>> theta = dynamicsymbols("theta")
    >>> contacts = {"joint": Friction(theta.diff(), limit=0.2)}
    """

    slip: Any
    limit: Any
    normal: Normal = None
    limit_at_rest: Any = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "slip", _slip(self.slip))
        object.__setattr__(self, "limit", _limit(self.limit))
        object.__setattr__(self, "normal", normal_of(self.normal))
        if self.limit_at_rest is not None:
            object.__setattr__(self, "limit_at_rest", _limit(self.limit_at_rest))

    @property
    def sticking(self) -> sympy.Expr:
        """The static limit, at least as large as the sliding limit."""
        return self.limit if self.limit_at_rest is None else sympy.Max(self.limit, self.limit_at_rest)

    @property
    def slips(self) -> tuple[sympy.Expr, ...]:
        """One slip, or the two slips of a cone."""
        return self.slip if isinstance(self.slip, tuple) else (self.slip,)


@dataclass(frozen=True, slots=True)
class Switch:
    """The parts of a mechanism that a contact or friction changes with its mode.

    name : of its event
    holds : the parameter that is 1 while its constraint row is active
    slides : the parameter that is the sign of the slip (1 or -1) while a friction slides, else 0; None for a contact
    idles : the parameter that is nonzero while its row is idle, because other rows imply it: its tolerance then
    shift : the two parameters added to the slips of a cone to determine its direction, or ()
    over : the name of the contact whose multiplier is the normal force, or None
    presses : the rows whose multipliers, by their norm, are the normal force, or ()
    row : the number of its constraint row, among the holonomic rows for a contact, else among the nonholonomic rows
    level : for a contact, the largest rate of the gap after an impact at which it holds; for a friction, the sliding
    limit
    at_rest : the static limit of a friction; 0 for a contact
    law : the impact law of a contact, "newton" or "poisson"; "" for a friction
    """

    name: str
    holds: sympy.Symbol
    slides: sympy.Symbol | None
    idles: sympy.Symbol
    shift: tuple[sympy.Symbol, ...]
    over: str | None
    presses: tuple[int, ...]
    row: int
    level: sympy.Expr
    at_rest: sympy.Expr
    law: str

    @property
    def cone(self) -> bool:
        """Whether it is a friction cone, whose second row follows the first."""
        return bool(self.shift)


def _slip(slips: Any) -> sympy.Expr | tuple[sympy.Expr, ...]:
    if not isinstance(slips, (tuple, list)):
        return expression(slips, "The slip of a friction")
    if len(slips) != len(("slip_1", "slip_2")):
        raise ModelError(f"The slip of a friction is {shown(slips)}. Give one, or the two of a cone.")
    return tuple(expression(slip, "A slip of a friction") for slip in slips)


def _limit(source: Any) -> sympy.Expr:
    limit = expression(source, "The limit of a friction")
    if limit.is_negative:
        raise ModelError(f"The limit of a friction is {shown(source)}, which is negative. Turn its sign.")
    return limit if limit.is_nonnegative else sympy.Max(limit, 0)


def contacts_of(contacts: Any) -> tuple[tuple[str, Contact | Friction], ...]:
    """Return the contacts and frictions by name.

    Raises
    ------
    ModelError
        One is neither, or has a name that makes no parameter; names it.
    """
    pairs = pairs_of(contacts, "contacts")
    for name, entry in pairs:
        if not isinstance(name, str) or not name.isidentifier():
            raise ModelError(
                f"contacts has an entry named {shown(name)}. Name it as parameters are: a Python identifier."
            )
        if not isinstance(entry, Contact | Friction):
            raise ModelError(f"contacts[{name}] is {shown(entry)}. Give a Contact or a Friction.")
    if len({entry.law for _, entry in pairs if isinstance(entry, Contact)}) > 1:
        raise ModelError("Some contacts strike by Newton's law, others by Poisson's: give all the same `law`.")
    return pairs


def switch_of(
    name: str,
    entry: Contact | Friction,
    holonomic: Sequence[sympy.Expr],
    nonholonomic: Sequence[sympy.Expr],
    normals: Normals,
) -> Switch:
    """Return the switch of a contact or friction, whose constraint row is among these rows."""
    holds, slides, idles, *shift = parameters_of(name, entry)
    rows = holonomic if slides is None else nonholonomic
    row = next(k for k, expression in enumerate(rows) if holds in expression.free_symbols)
    if isinstance(entry, Friction):
        over, presses = normals.of(name, entry.normal)
        return Switch(name, holds, slides, idles, tuple(shift), over, presses, row, entry.limit, entry.sticking, "")
    return Switch(name, holds, slides, idles, (), None, (), row, entry.rest, sympy.Integer(0), entry.law)


def normals_of(fields: Mapping[str, Any]) -> Normals:
    """Return the possible normal forces from the fields of a Model, before or after its contacts were translated."""
    known = [symbol for symbol, _ in fields["parameters"]]
    translated = [entry for name, entry in fields["contacts"] if parameters_of(name, entry)[0] in known]
    contacts = sum(isinstance(entry, Contact) for entry in translated)
    slips = sum(len(entry.slips) for entry in translated if isinstance(entry, Friction))
    others = {kind: len(fields[kind]) - count for kind, count in zip(KINDS, (contacts, slips), strict=True)}
    names = [name for name, entry in fields["contacts"] if isinstance(entry, Contact)]
    return Normals(names, others, fields["constraint_names"])


def with_contacts(fields: Mapping[str, Any], in_rates: Callable[[sympy.Expr], sympy.Expr]) -> dict[str, Any]:
    """Return the fields of a Model with the rows, forces, parameters and events of its contacts added."""
    made = dict(fields)
    normals = normals_of(fields)
    for name, entry in fields["contacts"]:
        added = [symbol for symbol in parameters_of(name, entry) if symbol is not None]
        made["parameters"] = (*made["parameters"], *((symbol, 0.0) for symbol in added))
        made |= (
            _contact(made, name, entry)
            if isinstance(entry, Contact)
            else _friction(made, name, entry, in_rates, normals)
        )
    return made


def parameters_of(name: str, entry: Contact | Friction) -> tuple[Any, ...]:
    """Return the parameters `holds`, `slides` (None for a contact) and `idles`, and for a cone those of `shift`."""
    idles = sympy.Symbol(f"{name}_idle")
    if isinstance(entry, Contact):
        return sympy.Symbol(f"{name}_held"), None, idles
    return sympy.Symbol(f"{name}_stuck"), _slides(name), idles, *_shift(name, entry)


def _slides(name: str) -> sympy.Symbol:
    return sympy.Symbol(f"{name}_slides")


def _shift(name: str, friction: Friction) -> tuple[sympy.Symbol, ...]:
    count = len(friction.slips)
    return tuple(sympy.Symbol(f"{name}_shift{k + 1}") for k in range(count if count > 1 else 0))


def _contact(made: Mapping[str, Any], name: str, contact: Contact) -> dict[str, Any]:
    holds = parameters_of(name, contact)[0]
    return {
        "holonomic_constraints": (*made["holonomic_constraints"], holds * contact.gap),
        "events": (*made["events"], (name, Event(contact.gap, -1, impact=(contact.gap, contact.restitution)))),
    }


def _friction(
    made: Mapping[str, Any],
    name: str,
    friction: Friction,
    in_rates: Callable[[sympy.Expr], sympy.Expr],
    normals: Normals,
) -> dict[str, Any]:
    holds, slides = parameters_of(name, friction)[0], _slides(name)
    slips, force = list(map(in_rates, friction.slips)), friction.limit * normals.force(name, friction.normal)
    shift = _shift(name, friction)
    shifted = [slip + by for slip, by in zip(slips, shift, strict=True)] if shift else slips
    along = [slip / _speed(shifted, slides) if shift else sympy.Integer(1) for slip in shifted]
    rows = [_along(rate_of(x), along, slips) for x in made["coordinates"]]
    pushes = [-slides * force * row for row in rows]
    passes = (
        _speed([slip + by for slip, by in zip(friction.slips, shift, strict=True)], slides) if shift else friction.slip
    )
    return {
        "nonholonomic_constraints": (
            *made["nonholonomic_constraints"],
            *(holds * slip for slip in friction.slips),
        ),
        "forces": tuple(Q + push for Q, push in zip(made["forces"], pushes, strict=True)),
        "events": (*made["events"], (name, Event(slides * passes, -1))),
    }


def _along(velocity: sympy.Expr, along: Sequence[sympy.Expr], slips: Sequence[sympy.Expr]) -> sympy.Expr:
    """Return the sum of along_i d(slip_i) / d(velocity); most slips do not contain most velocities."""
    return sympy.Add(
        *(part * slip.diff(velocity) for part, slip in zip(along, slips, strict=True) if slip.has(velocity))
    )


def _speed(slips: Sequence[sympy.Expr], slides: sympy.Symbol) -> sympy.Expr:
    """Return the magnitude of the slip of a cone while it slides; elsewhere it is unused but must not be 0.

    (1 - slides) is squared: as plain terms of the sum, the 1 and -slides would round away slips below 1e-8.
    """
    return sympy.sqrt(sympy.Add(*(slip**2 for slip in slips), (1 - slides) ** 2))


def expressions_of(name: str, entry: Contact | Friction) -> tuple[tuple[str, sympy.Expr, bool], ...]:
    """Return the expressions of a contact or friction: (name, expression, whether it may contain velocities)."""
    of = f"of contacts[{name_of(name)}]"
    if isinstance(entry, Contact):
        return tuple((f"{part} {of}", getattr(entry, part), part != "gap") for part in ("gap", "restitution", "rest"))
    slips = tuple((f"slip {of}", slip, True) for slip in entry.slips)
    return *slips, (f"limit {of}", entry.limit, True), (f"limit_at_rest {of}", entry.sticking, True)
