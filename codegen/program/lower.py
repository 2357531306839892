"""Lowering of a scene to the `Program` record that the templates print."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate

from ..choices import OF_TREES, Choices
from ..equations.specialise import Kind, Scene
from ..equations.tree.link_table import numbers_of
from ..kernel.identifiers import c_identifier
from ..kernel.printer import table_function
from ..model.prescribed_inputs import PrescribedInput
from ..model.statement.contacts import Switch
from ..model.statement.event import Event
from ..model.table import Table
from .kernel_roles import Kernels, Stages
from .kernels import kernels_of
from .memory_layout import Layout, laid_out
from .program import (
    BlockView,
    BodyView,
    Declared,
    EventView,
    LinksView,
    Named,
    Program,
    ShapeView,
    SwitchView,
    TableView,
)


@dataclass(frozen=True, slots=True)
class Defaults:
    """Default values and other data of a model that the generated file contains.

    parameters, inputs : name -> value
    declared : (parameters, x, inputs) or (), the allowed values of each as bits and as text
    x, v : (n); y : (n) or ()
    events : name -> Event; switches : those of contacts and frictions
    rows : names of constraint rows, () if none has one; tables : those that are called
    """

    parameters: tuple[tuple[str, float], ...]
    declared: tuple[tuple[int, str], ...]
    inputs: tuple[tuple[str, float], ...]
    x: tuple[float, ...]
    v: tuple[float, ...]
    y: tuple[float, ...]
    events: tuple[tuple[str, Event], ...]
    switches: tuple[Switch, ...]
    rows: tuple[str, ...]
    tables: tuple[Table, ...]


def lower(scene: Scene, defaults: Defaults, choices: Choices, differentiated: Scene | None) -> Program:
    """Lay out state and memory, and write the kernels.

    `differentiated` is the scene with all terms, of which derivatives are included; None: they are left out, unless
    Omega is extrapolated, which needs them.
    """
    layout, mechanics, eigen = laid_out(scene, choices), scene.mechanics, choices.eigenfactor
    blocks, groups = layout.blocks, layout.row_groups
    turning = [block for block in blocks if block.turning and eigen]
    coupled = [group for group in groups if group.size > 1]
    extrapolates = layout.couples and choices.extrapolate
    kernels, n_constants = kernels_of(scene, choices, layout, differentiated or (scene if extrapolates else None))
    return Program(
        name=mechanics.name, formulation=choices.formulation, close_eigenvalues=choices.close_eigenvalues,
        schur=choices.schur, eigenfactor=eigen, cholesky=choices.formulation == "cholesky",
        carries_v=choices.carries_v, bounded=layout.couples and choices.bounded,
        extrapolate=layout.couples and choices.extrapolate, extrapolated=layout.extrapolated,
        on_lanes=not (layout.couples and choices.extrapolate or mechanics.norms),
        in_lanes=_in_lanes(scene, layout, choices),
        needs_mass=_needs_mass(blocks, choices), settles=_settles(scene, choices),
        settling=_settling(scene, layout, bool(turning), choices),
        augmented=mechanics.augmented, n=scene.n, m=scene.m, h=scene.h, n_state=layout.n_state,
        n_memory=layout.n_memory, n_C=sum(block.size**2 for block in turning), n_s=sum(block.size for block in turning),
        coordinates=_named(zip(mechanics.coordinate_names, defaults.x, strict=True)), n_states=mechanics.n_states,
        velocities=tuple(map(repr, defaults.v)), parameters=_named(defaults.parameters),
        inputs=_named(defaults.inputs), declared=tuple(Declared(*one) for one in defaults.declared),
        outputs=tuple(name for name, _ in mechanics.outputs),
        events=_events(scene, defaults), n_impacts=len(mechanics.impacts), pushes=mechanics.pushes, rows=defaults.rows,
        normals=tuple(tuple(int(row in rows) for row in range(scene.m)) for rows in mechanics.norms),
        reaction_rates=tuple(k for k, _ in mechanics.reaction_rates),
        resets=tuple(int(reset.quasi) for reset in mechanics.resets), switches=_switches(scene, defaults),
        shapes=_shapes(scene), dimension=next((shape.dimension for shape in mechanics.drawing), 0),
        quasi_velocities=tuple(name for name, _ in mechanics.quasi_velocities), initial_y=tuple(map(repr, defaults.y)),
        blocks=blocks, block_of=_block_of(scene), carried=_carried(scene, eigen), scales=tuple(map(repr, scene.scales)),
        delta_eigenfactors=bool(groups), row_groups=groups,
        n_C_delta=sum(group.size**2 for group in coupled), n_s_delta=sum(group.size for group in coupled),
        layout=layout.slices, left_out=scene.left_out, conserves_energy=scene.conserves_energy,
        n_prepared=layout.first_constant + n_constants, costs=_costs(kernels, choices.formulation),
        tables=_tables(defaults), bodies=_bodies(scene), links=_links(scene, layout, choices),
        rotations=mechanics.trees.rotations if mechanics.trees else (), kernels=kernels,
    )  # fmt: skip


def _in_lanes(scene: Scene, layout: Layout, choices: Choices) -> bool:
    """Whether a run can make most of its steps on lanes."""
    remembers_omega = layout.couples and choices.extrapolate
    carries_delta = any(group.size > 1 for group in layout.row_groups)
    return not (_acts(scene) or remembers_omega or carries_delta)


def _acts(scene: Scene) -> bool:
    mechanics = scene.mechanics
    return bool(mechanics.impacts or mechanics.resets or mechanics.levels)


def _events(scene: Scene, defaults: Defaults) -> tuple[EventView, ...]:
    """Return each event with the numbers of its actions."""
    impacts = {impact.event: k for k, impact in enumerate(scene.mechanics.impacts)}
    resets = {reset.event: k for k, reset in enumerate(scene.mechanics.resets)}
    switched = {switch.name for switch in defaults.switches}
    held = {switch.name: k for k, switch in enumerate(defaults.switches) if not switch.slides}
    return tuple(
        EventView(name, event.direction, int(event.terminal), impacts.get(k, -1), resets.get(k, -1), held.get(name, -1),
                  -event.direction if event.keeps_apart or name in switched else 0, int(event.acts or name in switched))
        for k, (name, event) in enumerate(defaults.events)
    )  # fmt: skip


def _switches(scene: Scene, defaults: Defaults) -> tuple[SwitchView, ...]:
    """Return the numbers of the parameters and rows of each switch."""
    place = {name: k for k, (name, _) in enumerate(defaults.parameters)}
    events = {name: k for k, (name, _) in enumerate(defaults.events)}
    number = {one.name: k for k, one in enumerate(defaults.switches)}
    return tuple(
        SwitchView(events[one.name], place[one.holds.name], place[one.slides.name] if one.slides else -1,
                   _over(scene, one, number), one.row + (scene.h if one.slides else 0),
                   place[one.idles.name], int(one.law == "poisson"), place[one.shift[0].name] if one.cone else -1)
        for one in defaults.switches
    )  # fmt: skip


def _tables(defaults: Defaults) -> tuple[TableView, ...]:
    place = {name: k for k, (name, _) in enumerate(defaults.parameters)}
    return tuple(
        TableView(table.name, c_identifier(table.name), table_function(table.name), table.arguments, place[table.name],
                  tuple(map(repr, table.pieces.numbers())), isinstance(table, PrescribedInput))
        for table in defaults.tables
    )  # fmt: skip


def _bodies(scene: Scene) -> tuple[BodyView, ...]:
    trees = scene.mechanics.trees
    return tuple(BodyView(b.name, b.parent, b.joint, b.coordinates) for b in trees.placements) if trees else ()


def _links(scene: Scene, layout: Layout, choices: Choices) -> LinksView | None:
    """Return the table of moving bodies over which C loops."""
    trees = scene.mechanics.trees
    if not (trees and trees.table):
        return None
    rows = trees.table.rows
    return LinksView(
        bodies=tuple(BodyView("", row.parent, row.joint, row.coordinates) for row in rows),
        slots=sum(len(row.coordinates) for row in rows), start=layout.first_link,
        solves=trees.table.solves and choices.formulation in OF_TREES,
        yields=trees.table.yields and choices.formulation in OF_TREES,
        numbers=tuple(repr(number) for row in rows for number in numbers_of(trees.graph, row.numbers)),
    )  # fmt: skip


def _over(scene: Scene, switch: Switch, number: Mapping[str, int]) -> int:
    """Return the switch whose multiplier is the normal force of a friction; -2 - k for norm k; -1 if there is none."""
    if switch.presses:
        return -2 - scene.mechanics.norms.index(switch.presses)
    return number[switch.over] if switch.over else -1


def _needs_mass(blocks: Sequence[BlockView], choices: Choices) -> bool:
    """Whether velocities follow from the state only with M(x): some varying block does not carry C and s."""
    carried = choices.eigenfactor
    return any(block.single or block.turning and (not carried or block.size > 1) for block in blocks)


def _settles(scene: Scene, choices: Choices) -> bool:
    """Whether accepted states must be settled."""
    return scene.m > 0 or not choices.carries_v and any(b.kind is not Kind.FIXED for b in scene.blocks)


def _settling(scene: Scene, layout: Layout, turning: bool, choices: Choices) -> tuple[str, ...]:
    steps = (
        (scene.h, "constraints on positions"),
        (turning, "C and s"),
        (layout.n_memory and not turning and not choices.carries_v, "the root of M is kept"),
        (scene.m, "constraints on velocities"),
    )
    return tuple(words for needed, words in steps if needed)


def _named(defaults: Iterable[tuple[str, float]]) -> tuple[Named, ...]:
    return tuple(Named(name, repr(value)) for name, value in defaults)


def _shapes(scene: Scene) -> tuple[ShapeView, ...]:
    counts = [len(shape.numbers) for shape in scene.mechanics.drawing]
    firsts = accumulate(counts, initial=0)
    return tuple(
        ShapeView(shape.kind, first, len(shape.numbers), tuple(f"{x:.6g}" for corner in shape.corners for x in corner))
        for shape, first in zip(scene.mechanics.drawing, firsts, strict=False)
    )


def _block_of(scene: Scene) -> tuple[int, ...]:
    by_coordinate = {k: block.number - 1 for block in scene.blocks for k in block.coordinates}
    return tuple(by_coordinate[k] for k in range(scene.n))


def _carried(scene: Scene, eigen: bool) -> tuple[int, ...]:
    turning = {k for block in scene.turning for k in block.coordinates} if eigen else set()
    return tuple(int(k in turning) for k in range(scene.n))


def _costs(kernels: Kernels, formulation: str) -> tuple[str, ...]:
    named = ((formulation, kernels.published), ("triangular root", kernels.triangular), ("projection", kernels.settled))
    return tuple(f"{name}: {_count(stages)}" for name, stages in named if stages.masses or stages.motion)


def _count(stages: Stages) -> str:
    words = ("additions", "multiplications", "divisions", "roots", "function calls")
    counts = zip(stages.cost.counts(), words, strict=True)
    return ", ".join(f"{count} {word}" for count, word in counts if count) or "none"
