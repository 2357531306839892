"""Sparsity of the Jacobians: which entries can differ from zero, found from the structure of the equations.

M da + A^T dlambda = -dr and A da = -ds: coordinates and rows that M and A couple, directly or through others, form
components. An acceleration or a multiplier has a derivative by an argument if r or s of some coordinate or row of its
component has one.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ..codegen.kernel.kernel import Kernel
from ..codegen.program.kernel_roles import PartialKernels
from ..codegen.program.program import Program

Places = frozenset[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class Sparsity:
    """Places of derivatives that are not structurally zero.

    Columns are those of em_casadi.h: x, v, inputs, parameters, time; then a and multipliers.

    motion : rows n of a, m of multipliers
    outputs : rows of the outputs
    inverse : rows n of forces, m of residuals
    accelerated : whether outputs contain a or multipliers
    """

    motion: Places
    outputs: Places
    inverse: Places
    accelerated: bool


def sparsity_of(program: Program) -> Sparsity:
    """Return the sparsity of a program with derivatives."""
    residual = frozenset(_residual(program))
    motion = frozenset(_motion(program, residual))
    direct = set(_places(_partials(program).outputs, _reactions(program) + _arguments(program)))
    return Sparsity(
        motion=motion,
        outputs=frozenset(_outputs(program, direct, motion)),
        inverse=residual | frozenset(_by_forces(program)),
        accelerated=any(column < _reactions(program) for _, column in direct),
    )


def _partials(program: Program) -> PartialKernels:
    partials = program.kernels.partials
    if partials is None:
        raise ValueError(f"the program of {program.name} has no derivatives")
    return partials


def _reactions(program: Program) -> int:
    return program.n + program.m


def _arguments(program: Program) -> int:
    return 2 * program.n + len(program.inputs) + len(program.parameters) + 1


def _places(kernel: Kernel | None, width: int) -> Iterator[tuple[int, int]]:
    """Yield (row, column) of the entries that a kernel of a dense matrix assigns."""
    return (divmod(int(place[1:-1]), width) for place in (kernel.assigned if kernel else ()))


def _residual(program: Program) -> Iterator[tuple[int, int]]:
    """Yield the places of the derivatives of r and s at fixed a and multipliers, by the arguments."""
    partials, n = _partials(program), program.n
    if partials.equations:
        yield from _places(partials.equations, _arguments(program))
    else:
        yield from _places(partials.state, 2 * n)
        for row, column in _places(partials.forcing, _arguments(program) - 2 * n):
            yield row, 2 * n + column
    for i, j in partials.structure.chained:
        yield i, j
        yield i, n + j


def _by_forces(program: Program) -> Iterator[tuple[int, int]]:
    """Yield the places of M, A^T and A: the derivatives by a and multipliers."""
    structure, n, first = _partials(program).structure, program.n, _arguments(program)
    for i, j in structure.masses:
        yield i, first + j
    for row, k in structure.rows:
        yield k, first + n + row
        yield n + row, first + k


def _motion(program: Program, residual: Iterable[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    columns: dict[int, set[int]] = {}
    component = _components(program)
    for row, column in residual:
        columns.setdefault(component[row], set()).add(column)
    for row in range(_reactions(program)):
        for column in columns.get(component[row], ()):
            yield row, column
    reactions = {column for row in range(program.n, _reactions(program)) for column in columns.get(component[row], ())}
    yield from ((state, column) for state in program.reaction_rates for column in reactions)


def _components(program: Program) -> list[int]:
    """Return the component of each coordinate and row."""
    structure, n = _partials(program).structure, program.n
    number = list(range(_reactions(program)))
    for i, j in (*structure.masses, *((n + row, k) for row, k in structure.rows)):
        old, new = number[i], number[j]
        number = [new if one == old else one for one in number]
    return number


def _outputs(program: Program, direct: Iterable[tuple[int, int]], motion: Places) -> Iterator[tuple[int, int]]:
    reactions = _reactions(program)
    by_row: dict[int, list[int]] = {}
    for row, column in motion:
        by_row.setdefault(row, []).append(column)
    for row, column in direct:
        if column >= reactions:
            yield row, column - reactions
        else:
            yield from ((row, argument) for argument in by_row.get(column, ()))
