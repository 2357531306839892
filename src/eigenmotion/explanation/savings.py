"""Prices of savings: states and operations of programs with and without each of them."""

from dataclasses import dataclass

from ..building.errors import BuildError
from ..building.operation_count import operations
from ..building.request import Request
from ..codegen.anatomy import Anatomy
from ..codegen.compiler import Variant, anatomy, variants
from ..presentation.units import Units


@dataclass(frozen=True, slots=True)
class Price:
    """A program with some of the savings: the lengths of its state's parts, and its operations (None: not counted)."""

    name: str
    states: tuple[tuple[str, int], ...]
    operations: int | None

    @property
    def n_state(self) -> int:
        """Number of states."""
        return sum(length for _, length in self.states)

    @property
    def words(self) -> str:
        """The operations as text."""
        return "operations not counted" if self.operations is None else f"{self.operations:,} operations"


@dataclass(frozen=True, slots=True)
class Savings:
    """What a picture of a model shows: its structure, names of constraint rows, units, and the prices of savings.

    prices : of the program as generated, without each saving, and without all
    obstacle : why operations could not be counted, or ""
    """

    name: str
    formulation: str
    anatomy: Anatomy
    rows: tuple[str, ...]
    units: Units
    prices: tuple[Price, ...]
    obstacle: str


WORDS = {
    "without uncoupled": "M as one block",
    "without fixed": "constant blocks as others",
    "without single": "single coordinates as others",
    "without all three": "all three at once",
}
"""Name of a price -> what its program does instead, for users."""

LIMITS = (
    "Operations are those of one right-hand side at the initial state as it is executed, loops included. Absent terms "
    "have no price: no program has them."
)


def savings_of(request: Request) -> Savings:
    """Derive a model and generate its programs with and without each saving.

    Raises
    ------
    ModelError
        The model has a mistake.
    """
    model, found = request.model, anatomy(request.model)
    named = [*model.row_names, *[""] * len(found.A)][: len(found.A)]
    rows = tuple(name or f"row {k}" for k, name in enumerate(named))
    prices, obstacle = _priced(variants(model, request.choices))
    return Savings(model.name, request.choices.formulation, found, rows, dict(model.units) or None, prices, obstacle)


def _priced(programs: tuple[Variant, ...]) -> tuple[tuple[Price, ...], str]:
    """Return the prices, and why operations were not counted."""
    try:
        counts: list[int | None] = [operations(one.sources) for one in programs]
    except BuildError as error:
        return tuple(Price(one.name, one.states, None) for one in programs), str(error).splitlines()[0]
    return tuple(Price(one.name, one.states, count) for one, count in zip(programs, counts, strict=True)), ""


def table(found: Savings) -> str:
    """Return the prices as lines of text."""
    base = found.prices[0]
    lines = [f"  as generated: {base.n_state} states, {base.words}"]
    for one in found.prices[1:]:
        same = " (nothing to save here)" if (one.states, one.operations) == (base.states, base.operations) else ""
        lines.append(f"  {WORDS[one.name]}: {one.n_state} states, {one.words}{same}")
    return "\n".join(["Savings, each switched off alone", *lines, f"  {found.obstacle or LIMITS}"])
