"""Text of accelerations and their derivatives in one piece, for mechanisms of a few coordinates.

Values that the equations and their derivatives share are computed once, and structural zeros of M and A take no part in
the solution. Loops over all columns, which need no text of their own, serve larger mechanisms.
"""

from dataclasses import dataclass

from ..codegen.compiler import motion_in_one_piece
from ..codegen.kernel.kernel import Kernel
from ..codegen.model import Model
from ..codegen.program.motion_kernels import MotionKernels
from ..codegen.program.program import Program
from ..codegen.render.emit import environment
from .elimination import elimination
from .single_file import beside

LARGEST = 14
"""The largest number of coordinates and constraint rows for which this is compiled: the text grows with its cube."""


@dataclass(frozen=True, slots=True)
class _Piece:
    """What one_piece.c.jinja prints."""

    motion: MotionKernels
    kernels: tuple[Kernel, ...]
    size: int
    widths: tuple[int, ...]
    factors: tuple[str, ...]
    vector: tuple[str, ...]
    columns: tuple[tuple[str, ...], ...]
    places: tuple[int, ...]


def one_piece(model: Model, program: Program, chosen: tuple[int, ...], dependent: bool) -> str:
    """Return the C text, or "" for a mechanism that loops serve."""
    if program.n + program.m > LARGEST or program.links or dependent or program.augmented or program.reaction_rates:
        return ""
    motion = motion_in_one_piece(model, _groups(program, chosen))
    solution = elimination(program.n, program.m, motion.entries)
    piece = _Piece(
        motion=motion,
        kernels=(
            motion.values,
            motion.terms,
            *(k for k, one in zip(motion.slopes, motion.groups, strict=True) if one.width),
        ),
        size=len(motion.entries),
        widths=tuple(group.width for group in motion.groups),
        factors=tuple(solution.factors()),
        vector=tuple(solution.vector()),
        columns=tuple(
            tuple(solution.columns(f"W{k}", group.width, {row for row, _ in group.nonzero}))
            for k, group in enumerate(motion.groups)
        ),
        places=_places(program, motion),
    )
    return environment().from_string(beside("one_piece.c.jinja")).render(piece=piece)


def _groups(program: Program, chosen: tuple[int, ...]) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Return the numbers of x, v, states and inputs, and those of chosen parameters and the time."""
    n, own, inputs = program.n, program.n - program.n_states, len(program.inputs)
    parameters = 2 * n + inputs
    usual = (*range(own), *range(n, 2 * n), *range(2 * n, parameters))
    return usual, (*(parameters + k for k in chosen), parameters + len(program.parameters))


def _places(program: Program, motion: MotionKernels) -> tuple[int, ...]:
    places = [-1] * (2 * program.n + len(program.inputs) + len(program.parameters) + 1)
    for first, group in zip((0, motion.groups[0].width), motion.groups, strict=True):
        for k, argument in enumerate(group.arguments):
            places[argument] = first + k
    return tuple(places)
