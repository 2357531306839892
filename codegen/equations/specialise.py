"""Specialisation of a mechanism to a scene: blocks of the mass matrix, constant and absent terms."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

import sympy

from ..model.tree.body import ROTATED
from .derive import Mechanics


class Saving(Enum):
    """Simplifications of a program. Each can be switched off, to compare with the general program."""

    UNCOUPLED = "groups of coordinates that M does not couple get eigenfactors of their own"
    FIXED = "factors of a constant block are computed once per parameter set"
    SINGLE = "a block of one coordinate needs no C, and s = sqrt(M_kk(x)) in closed form"


ALL_SAVINGS = frozenset(Saving)


class Kind(Enum):
    """How the eigenfactors of a block are computed."""

    TURNING = "turning"  # C and s are states
    SINGLE = "single"  # s = sqrt(M_kk(x)), C = 1
    FIXED = "fixed"  # computed once per parameter set


@dataclass(frozen=True, slots=True)
class Block:
    """Coordinates that M couples with each other but with no others.

    number : 1, 2, ... as in names of the generated code
    coordinates : their indices, increasing
    constrained : whether one of them occurs in a constraint row, or in a force that contains multipliers
    """

    number: int
    coordinates: tuple[int, ...]
    kind: Kind
    constrained: bool

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)


@dataclass(frozen=True, slots=True)
class Scene:
    """A mechanism with the terms that its equations do not need left out.

    scales : (n) units of the coordinates in the eigenproblem
    left_out : sentences that name the terms left out, with reasons
    conserves_energy : whether the form of the equations shows that T2 - T0 + V is constant along the motion
    """

    mechanics: Mechanics
    scales: tuple[float, ...]
    blocks: tuple[Block, ...]
    left_out: tuple[str, ...]
    conserves_energy: bool

    @property
    def n(self) -> int:
        """Number of coordinates."""
        return len(self.mechanics.x)

    @property
    def m(self) -> int:
        """Number of constraint rows."""
        return len(self.mechanics.b)

    @property
    def h(self) -> int:
        """Number of holonomic rows."""
        return len(self.mechanics.phi)

    @property
    def in_loops(self) -> bool:
        """Whether M and the energies leave out trees of bodies, which C adds in loops."""
        return self.mechanics.trees is not None and self.mechanics.trees.table is not None

    @property
    def row_groups(self) -> tuple[tuple[int, ...], ...]:
        """The constraint rows in groups that Delta = B B^T couples: rows on coordinates of the same block."""
        A = self.mechanics.A
        of_row = [
            {b.number for b in self.blocks if any(A[row, k] != 0 for k in b.coordinates)} for row in range(self.m)
        ]
        pattern = sympy.ImmutableDenseMatrix(self.m, self.m, lambda i, j: int(i == j or bool(of_row[i] & of_row[j])))
        return tuple(_coupled(pattern))

    @property
    def turning(self) -> tuple[Block, ...]:
        """The blocks that carry C and s as states."""
        return tuple(block for block in self.blocks if block.kind is Kind.TURNING)


def specialise(
    mechanics: Mechanics, scales: tuple[float, ...] | None = None, savings: frozenset[Saving] = ALL_SAVINGS
) -> Scene:
    """Return the scene of a mechanism, from the structural zeros of its terms."""
    n = len(mechanics.x)
    groups = _coupled(mechanics.factored, _in_trees(mechanics)) if Saving.UNCOUPLED in savings else [tuple(range(n))]
    blocks = tuple(_block(mechanics, number, group, savings) for number, group in enumerate(groups, 1))
    return Scene(
        mechanics=mechanics,
        scales=scales or (1.0,) * len(mechanics.x),
        blocks=blocks,
        left_out=tuple(_left_out(mechanics, blocks)),
        conserves_energy=_conserves_energy(mechanics),
    )


def _in_trees(mechanics: Mechanics) -> list[set[int]]:
    """Return the coordinates of each branch on the ground, if M leaves out the trees of bodies."""
    table = mechanics.trees.table if mechanics.trees else None
    branches: list[set[int]] = []
    of_row: list[set[int]] = []
    for row in table.rows if table else ():
        if row.parent < 0:
            branches.append(set())
        of_row.append(branches[-1] if row.parent < 0 else of_row[row.parent])
        of_row[-1].update(row.coordinates)
    return branches


def _coupled(M: sympy.ImmutableDenseMatrix, together: Iterable[set[int]] = ()) -> list[tuple[int, ...]]:
    """Return the connected components of the graph whose edges are the nonzeros of M, sorted by coordinate.

    `together` : groups of coordinates that are coupled besides.
    """
    of_rows = [{i} for i in range(M.rows)]
    for i, j in M.todok():
        of_rows[i].add(j)
    return sorted(tuple(sorted(group)) for group in _united([*together, *of_rows]))


def _united(groups: Iterable[set[int]]) -> list[set[int]]:
    """Return the unions of sets that have elements in common."""
    united: list[set[int]] = []
    for group in groups:
        joined = set(group)
        for one in [one for one in united if one & joined]:
            united.remove(one)
            joined |= one
        united.append(joined)
    return united


def _block(mechanics: Mechanics, number: int, group: tuple[int, ...], savings: frozenset[Saving]) -> Block:
    varying = {*mechanics.x, mechanics.time}
    M = [entry for (row, _), entry in mechanics.factored.todok().items() if row in set(group)]
    kind = Kind.TURNING
    if Saving.FIXED in savings and not (_symbols(M) & varying or set(group) & set().union(*_in_trees(mechanics))):
        kind = Kind.FIXED
    elif Saving.SINGLE in savings and len(group) == 1:
        kind = Kind.SINGLE
    rows = range(mechanics.A.rows)
    constrained = any(mechanics.A[row, k] != 0 or mechanics.P[row, k] != 0 for row in rows for k in group)
    return Block(number, group, kind, constrained)


def _symbols(expressions: Iterable[sympy.Basic]) -> set[sympy.Basic]:
    """Return the symbols in expressions."""
    return {part for part in _parts(expressions) if part.is_Symbol}


def _parts(expressions: Iterable[sympy.Basic]) -> set[sympy.Basic]:
    """Return the expressions and their subexpressions; shared ones are visited once, unlike in SymPy's traversals."""
    seen: set[sympy.Basic] = set()
    new = set(expressions)
    while new:
        seen |= new
        new = {part for expression in new for part in expression.args} - seen
    return seen


def _conserves_energy(mechanics: Mechanics) -> bool:
    """Whether no force does work and nothing depends on time: then T2 - T0 + V is constant (Jacobi integral)."""
    terms = [*mechanics.M.todok().values(), *mechanics.G, mechanics.T0, mechanics.V, *mechanics.A, *mechanics.phi]
    timeless = mechanics.time not in _symbols(terms)
    workless = (
        not mechanics.pushes and all(force == 0 for force in mechanics.Q) and all(rate == 0 for rate in mechanics.b)
    )
    return timeless and workless


def _left_out(mechanics: Mechanics, blocks: tuple[Block, ...]) -> list[str]:
    return [*_absent_terms(mechanics), *_absent_coordinates(mechanics), *_absent_factors(mechanics, blocks),
            *_absent_shadows(mechanics)]  # fmt: skip


def _absent_terms(mechanics: Mechanics) -> list[str]:
    t, M = mechanics.time, mechanics.M
    terms = [*M.todok().values(), *mechanics.A, mechanics.V]
    m = len(mechanics.b)
    reasons = [
        (all(g == 0 for g in mechanics.G), "G, Gdot, dG/dx: T has no part linear in the velocities"),
        (mechanics.T0 == 0, "dT0/dx: T has no part free of velocities"),
        (mechanics.V == 0 and not _in_trees(mechanics), "dV/dx: there is no potential energy"),
        (not mechanics.pushes and all(q == 0 for q in mechanics.Q), "Q: there are no other forces"),
        (t not in _symbols(terms), "dM/dt, dA/dt, dV/dt: the time does not occur"),
        (m == 0, "A, B, Bdot, Delta, lambda: there are no constraints"),
        (m == 1, "a factor of Delta: one constraint, Delta is a number"),
        (m > 0 and all(b == 0 for b in mechanics.b), "b, bdot: the constraints are homogeneous in the velocities"),
    ]
    reasons.append((mechanics.augmented, _singular(mechanics)))
    return [reason for absent, reason in reasons if absent]


def _singular(mechanics: Mechanics) -> str:
    rows = [str(row) for row, weight in enumerate(mechanics.W) if weight != 0]
    return (
        f"M^-1: M is singular; M + A^T W A is factored, with weights W of row{'s' * (len(rows) > 1)} {', '.join(rows)}"
    )


def _absent_coordinates(mechanics: Mechanics) -> list[str]:
    if _in_trees(mechanics):
        return []
    symbols = _symbols(mechanics.factored.todok().values())
    coordinates = mechanics.x[: len(mechanics.x) - mechanics.n_states]
    absent = [f"dM/d{x}" for x in coordinates if x not in symbols]
    return [f"{', '.join(absent)}: M does not depend on {'it' if len(absent) == 1 else 'them'}"] if absent else []


def _absent_factors(mechanics: Mechanics, blocks: tuple[Block, ...]) -> list[str]:
    lines = []
    if len(blocks) > 1:
        names = ", ".join(_names(mechanics, block) for block in blocks)
        lines.append(f"C, mu, Omega across blocks: {names} do not couple")
    for block in blocks:
        names = _names(mechanics, block)
        if block.kind is Kind.FIXED:
            lines.append(f"C, s, mu, Omega of {names}: this block is constant, factored once per parameter set")
        elif block.kind is Kind.SINGLE:
            lines.append(f"C, Omega of {names}: one coordinate, s = sqrt(M) in closed form")
    return lines


def _absent_shadows(mechanics: Mechanics) -> list[str]:
    trees = mechanics.trees
    rotated = [one.coordinates[-3:] for one in trees.placements if one.joint in ROTATED] if trees else []
    return [
        f"the shadow set of {', '.join(mechanics.coordinate_names[k] for k in s)}: the equations contain these "
        "parameters themselves. The rotation stays below a full turn"
        for s in rotated
        if trees and s not in trees.rotations
    ]


def _names(mechanics: Mechanics, block: Block) -> str:
    return "{" + ", ".join(mechanics.coordinate_names[k] for k in block.coordinates) + "}"
