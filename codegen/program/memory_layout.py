"""Memory layout: offsets in the state, in the memory of a run and in the prepared parameters."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..choices import Choices
from ..equations.derive import Mechanics
from ..equations.specialise import Block, Kind, Scene
from ..equations.tree.triangular_root import has_recursive_root, root_order
from .program import BlockCoordinate, BlockView, RowGroup, Slice


class _Store:
    """Allocates consecutive places of one array."""

    def __init__(self, first: int) -> None:
        self.length = first

    def take(self, count: int) -> int:
        """Return the first of `count` places."""
        self.length += count
        return self.length - count


@dataclass(frozen=True, slots=True)
class Layout:
    """The offsets of all quantities.

    blocks, row_groups : with their offsets; there are no row groups if Delta is factored numerically
    from_tips : whether the triangular root is that of articulated bodies, in whose order blocks are then
    slices : the parts of the state
    extrapolated : offset in the memory of whether, and since when, Omega is extrapolated; None if it never is
    first_link : offset in the prepared parameters of the table of moving bodies, if there is one
    first_constant : offset in the prepared parameters of the constants that are functions of parameters
    """

    blocks: tuple[BlockView, ...]
    from_tips: bool
    row_groups: tuple[RowGroup, ...]
    slices: tuple[Slice, ...]
    n_state: int
    n_memory: int
    first_link: int
    first_constant: int
    extrapolated: int | None

    @property
    def couples(self) -> bool:
        """Whether eigenvalues in the state can coincide: those of a block of M, or of Delta."""
        return bool(self.row_groups) or any(block.turning and block.size > 1 for block in self.blocks)


def places_of(mechanics: Mechanics) -> dict[str, tuple[str, int | None]]:
    """Return symbol -> the array of a kernel that has it, and where."""
    arrays = {"c": mechanics.parameters, "x": mechanics.x, "v": mechanics.v, "u": mechanics.inputs,
              "a": mechanics.accelerations, "lambda": mechanics.multipliers}  # fmt: skip
    return {symbol.name: (array, k) for array, symbols in arrays.items() for k, symbol in enumerate(symbols)} | {
        mechanics.time.name: ("t", None)
    }


def laid_out(scene: Scene, choices: Choices) -> Layout:
    """Assign offsets to every block, row group and constant."""
    state, memory, prepared = _Store(2 * scene.n), _Store(0), _Store(len(scene.mechanics.parameters))
    turning = [block for block in scene.blocks if block.kind is Kind.TURNING and choices.eigenfactor]
    C = {block.number: state.take(block.size**2) for block in turning}
    s = {block.number: state.take(block.size) for block in turning}
    from_tips = choices.formulation == "cholesky" and has_recursive_root(scene.mechanics)
    blocks = tuple(
        _view(scene, block, choices, (C.get(block.number, 0), s.get(block.number, 0)), memory, prepared)
        for block in (_from_tips(scene) if from_tips else scene.blocks)
    )
    extrapolated = memory.take(2) if choices.extrapolate else None
    groups = _row_groups(scene, choices, state, memory)
    trees = scene.mechanics.trees
    first_link = prepared.take(sum(len(row.numbers) for row in trees.table.rows) if trees and trees.table else 0)
    return Layout(
        blocks=blocks, from_tips=from_tips, row_groups=groups, slices=_slices(scene, blocks, groups, choices),
        n_state=state.length, n_memory=memory.length, first_link=first_link, first_constant=prepared.length,
        extrapolated=extrapolated,
    )  # fmt: skip


def _from_tips(scene: Scene) -> tuple[Block, ...]:
    """Return the blocks with their coordinates in the order of the recursive root."""
    trees = scene.mechanics.trees
    order = root_order(scene.mechanics, trees) if trees else ()
    return tuple(
        replace(block, coordinates=tuple(sorted(block.coordinates, key=order.index))) for block in scene.blocks
    )


def _view(scene: Scene, block: Block, choices: Choices, carried: tuple[int, int], memory: _Store, prepared: _Store
          ) -> BlockView:  # fmt: skip
    """Assign offsets to a block: in the prepared parameters if it is fixed, otherwise in the memory."""
    square, size, fixed = block.size**2, block.size, block.kind is Kind.FIXED
    C, s = (prepared.take(square), prepared.take(size)) if fixed else carried
    L, r = (prepared.take(square), prepared.take(size)) if fixed else _in_memory(block, choices, memory)
    return BlockView(
        number=block.number, size=size, coordinates=block.coordinates,
        block_coordinates=tuple(
            BlockCoordinate(k, local, _scale(scene, choices, k)) for local, k in enumerate(block.coordinates)
        ),
        names=", ".join(scene.mechanics.coordinate_names[k] for k in block.coordinates),
        turning=block.kind is Kind.TURNING, single=block.kind is Kind.SINGLE, fixed=fixed,
        constrained=block.constrained, home=_home(block, choices), C=C, s=s, L=L, r=r,
    )  # fmt: skip


def _home(block: Block, choices: Choices) -> str:
    """Return where the root of a block is stored, as an em_root_location (em_blocks.h)."""
    if block.kind is Kind.FIXED:
        return "EM_PREPARED_FACTORS" if choices.eigenfactor else "EM_PREPARED_ROOT"
    return "EM_IN_STATE" if block.kind is Kind.TURNING and choices.eigenfactor else "EM_IN_MEMORY"


def _in_memory(block: Block, choices: Choices, memory: _Store) -> tuple[int, int]:
    """Return the offsets of L and r in the memory, or of Omega and its rate if Omega is extrapolated."""
    return memory.take(block.size**2), memory.take(block.size**2 if choices.extrapolate else block.size)


def _scale(scene: Scene, choices: Choices, k: int) -> str:
    return f"{scene.scales[k]!r}*" if choices.eigenfactor and scene.scales[k] != 1 else ""


def _row_groups(scene: Scene, choices: Choices, state: _Store, memory: _Store) -> tuple[RowGroup, ...]:
    """Return the row groups with the offsets of their eigenfactors of Delta; a group of a single row needs none."""
    coupled = scene.row_groups if choices.eigenfactor and choices.schur == "eigenfactor" else ()
    if all(len(rows) < 2 for rows in coupled):
        return ()
    squares = [len(rows) ** 2 * (len(rows) > 1) for rows in coupled]
    C = [state.take(square) for square in squares]
    s = [state.take(len(rows) * (len(rows) > 1)) for rows in coupled]
    kept = [memory.take(2 * square * choices.extrapolate) for square in squares]
    return tuple(RowGroup(k + 1, len(rows), rows, C[k], s[k], kept[k]) for k, rows in enumerate(coupled))


def _slices(scene: Scene, blocks: tuple[BlockView, ...], groups: tuple[RowGroup, ...], choices: Choices
            ) -> tuple[Slice, ...]:  # fmt: skip
    n, states = scene.n, scene.mechanics.n_states
    slices = [Slice("x", 0, n - states), Slice("v" if choices.carries_v else "eta", n, n - states)]
    if states:
        slices += [Slice("z", 2 * n - states, states), Slice("integral of z", n - states, states)]
    turning = [block for block in blocks if block.turning and choices.eigenfactor]
    coupled = [group for group in groups if group.size > 1]
    for names, holders in ((("C", "s"), turning), (("C_delta", "s_delta"), coupled)):
        if holders:
            slices.append(Slice(names[0], holders[0].C, sum(one.size**2 for one in holders)))
            slices.append(Slice(names[1], holders[0].s, sum(one.size for one in holders)))
    return tuple(slices)
