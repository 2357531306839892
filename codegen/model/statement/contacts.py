"""Contacts and frictions: constraints that hold at times, and the numbers that decide when.

A contact or friction is stated once; `with_contacts` makes it into what every mechanism has: constraint rows and forces
with a parameter in front that is 1 while they hold, else 0, and an event at which that may change.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import ModelError, expression, name_of, pairs_of, shown
from .constraint_rows import KINDS, Normal, Normals, normal_of
from .event import Event, restitution_of

LAWS = ("newton", "poisson")


@dataclass(frozen=True, slots=True)
class Contact:
    """What two bodies keep between them: gap(x, t) >= 0.

    Where the gap closes they strike each other by Newton's law, as `Event.impact` says; where they would part no faster
    than `rest` they stay together: gap = 0 is held as a constraint until its multiplier changes sign.

    Parameters
    ----------
    gap
        In x and t: the distance between them.
    restitution
        0 to 1, in x, xdot, t and inputs.
    rest
        [unit of gap / s] rate of the gap after an impact up to which they stay together.
    law
        "newton" (Moreau's form: restitution of rates) or "poisson" (of impulses), the same for all contacts of a model.

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
    """Coulomb's: sticks while that takes no more than `limit`, else slides and is held back by as much.

    Parameters
    ----------
    slip
        Linear in the velocities: at which rate it slides. Two of them, (slip_1, slip_2) at right angles and of one
        unit, make a cone: the force goes against the slip, whichever way that is. (Two frictions make a box.)
    limit
        In x, xdot, t and inputs [J / integral of slip]: the friction coefficient times the normal force; with `normal`
        the coefficient alone. Where it is negative nothing presses: there is no friction.
    normal
        Whose multipliers are the normal force: the name of a Contact, the name of constraints, the number of a row as
        `multiplier` counts them, or several of these. Of several rows it is the root of the sum of squares, as in a
        bearing with two reactions. None: it is in `limit`.
    limit_at_rest
        Likewise, up to which force it sticks, where that is more than what holds it back as it slides; None: `limit`.

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
        """Up to which force it sticks: no less than what holds back what slides."""
        return self.limit if self.limit_at_rest is None else sympy.Max(self.limit, self.limit_at_rest)

    @property
    def slips(self) -> tuple[sympy.Expr, ...]:
        """One, or the two of a cone."""
        return self.slip if isinstance(self.slip, tuple) else (self.slip,)


@dataclass(frozen=True, slots=True)
class Switch:
    """What of a mechanism changes with a mode.

    name : that of its event
    holds : the parameter that is 1 while its constraint row holds; slides : 1 or -1, the sign of slip, while it slides,
    else 0; None where there is no friction
    idles : the parameter that is not 0 where other rows keep it at rest: how far it may be off then
    shift : the two parameters that are added to the slips of a cone to find its direction, or ()
    over : the name of the contact whose multiplier its level is counted in, or None
    presses : the rows whose multipliers it is counted in, by the root of the sum of their squares, or ()
    row : of the constraint, counted among the holonomic ones for a contact, else among the nonholonomic ones
    level : up to which rate of the gap it holds after an impact, or the force that holds back what slides
    at_rest : up to which force a friction sticks; of a contact, 0
    law : of a contact's impacts, "newton" or "poisson"; of a friction ""
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
        """Whether it is a friction of two slips, whose second row is the next."""
        return bool(self.shift)


def _slip(given: Any) -> sympy.Expr | tuple[sympy.Expr, ...]:
    if not isinstance(given, (tuple, list)):
        return expression(given, "The slip of a friction")
    if len(given) != len(("slip_1", "slip_2")):
        raise ModelError(f"The slip of a friction is {shown(given)}. Give one, or the two of a cone.")
    return tuple(expression(slip, "A slip of a friction") for slip in given)


def _limit(given: Any) -> sympy.Expr:
    limit = expression(given, "The limit of a friction")
    if limit.is_negative:
        raise ModelError(f"The limit of a friction is {shown(given)}, which is negative. Turn its sign.")
    return limit if limit.is_nonnegative else sympy.Max(limit, 0)


def contacts_of(given: Any) -> tuple[tuple[str, Contact | Friction], ...]:
    """Return the contacts and frictions by name.

    Raises
    ------
    ModelError
        One is neither, or has a name that makes no parameter; names it.
    """
    pairs = pairs_of(given, "contacts")
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
    """Return what a contact or friction was made into, of which the rows are among these."""
    holds, slides, idles, *shift = _parameters(name, entry)
    rows = holonomic if slides is None else nonholonomic
    row = next(k for k, expression in enumerate(rows) if holds in expression.free_symbols)
    if isinstance(entry, Friction):
        over, presses = normals.of(name, entry.normal)
        return Switch(name, holds, slides, idles, tuple(shift), over, presses, row, entry.limit, entry.sticking, "")
    return Switch(name, holds, slides, idles, (), None, (), row, entry.rest, sympy.Integer(0), entry.law)


def normals_of(fields: Mapping[str, Any]) -> Normals:
    """Return which rows press, of the fields of a Model, with the rows of contacts or before they are made."""
    known = [symbol for symbol, _ in fields["parameters"]]
    made = [entry for name, entry in fields["contacts"] if _parameters(name, entry)[0] in known]
    contacts = sum(isinstance(entry, Contact) for entry in made)
    slips = sum(len(entry.slips) for entry in made if isinstance(entry, Friction))
    others = {kind: len(fields[kind]) - count for kind, count in zip(KINDS, (contacts, slips), strict=True)}
    names = [name for name, entry in fields["contacts"] if isinstance(entry, Contact)]
    return Normals(names, others, fields["constraint_names"])


def with_contacts(fields: Mapping[str, Any], in_rates: Callable[[sympy.Expr], sympy.Expr]) -> dict[str, Any]:
    """Return the fields of a Model with the rows, forces, parameters and events that its contacts are made of."""
    made = dict(fields)
    normals = normals_of(fields)
    for name, entry in fields["contacts"]:
        added = [symbol for symbol in _parameters(name, entry) if symbol is not None]
        if added[0] in dict(made["parameters"]):
            continue  # the fields of another model, as dataclasses.replace hands them over
        made["parameters"] = (*made["parameters"], *((symbol, 0.0) for symbol in added))
        made |= (
            _contact(made, name, entry)
            if isinstance(entry, Contact)
            else _friction(made, name, entry, in_rates, normals)
        )
    return made


def _parameters(name: str, entry: Contact | Friction) -> tuple[Any, ...]:
    """Return what holds, slides (None: a contact), idles; of a cone the shifts of its slips, too."""
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
    holds = _parameters(name, contact)[0]
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
    holds, slides = _parameters(name, friction)[0], _slides(name)
    slips, force = list(map(in_rates, friction.slips)), friction.limit * normals.force(name, friction.normal)
    shift = _shift(name, friction)
    shifted = [slip + by for slip, by in zip(slips, shift, strict=True)] if shift else slips
    along = [slip / _speed(shifted, slides) if shift else sympy.Integer(1) for slip in shifted]
    rows = [
        sum(part * slip.diff(x.diff()) for part, slip in zip(along, slips, strict=True)) for x in made["coordinates"]
    ]
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


def _speed(slips: Sequence[sympy.Expr], slides: sympy.Symbol) -> sympy.Expr:
    """Return the size of the slip of a cone, where it slides; elsewhere nothing asks for it, but it must not vanish.

    1 - slides stands as a square: bare it would be terms of the sum, where 1 takes the digits of a slip below 1e-8.
    """
    return sympy.sqrt(sympy.Add(*(slip**2 for slip in slips), (1 - slides) ** 2))


def expressions_of(name: str, entry: Contact | Friction) -> tuple[tuple[str, sympy.Expr, bool], ...]:
    """Return what a contact or friction is made of: names, expressions, and whether they may contain velocities."""
    of = f"of contacts[{name_of(name)}]"
    if isinstance(entry, Contact):
        return tuple((f"{part} {of}", getattr(entry, part), part != "gap") for part in ("gap", "restitution", "rest"))
    slips = tuple((f"slip {of}", slip, True) for slip in entry.slips)
    return *slips, (f"limit {of}", entry.limit, True), (f"limit_at_rest {of}", entry.sticking, True)
