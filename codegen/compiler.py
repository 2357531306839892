"""Compiler: turns a model into the text of its files, in four calls (derive, specialise, lower, emit)."""

from __future__ import annotations

import hashlib
import logging
from collections.abc import Iterator, Sequence
from dataclasses import asdict, astuple, dataclass, replace

from .anatomy import Anatomy, anatomy_of
from .choices import OF_TREES, STANDARD, Choices
from .equations.derive import derive
from .equations.forms import saves_by_nesting
from .equations.specialise import ALL_SAVINGS, Saving, Scene, specialise
from .equations.tree.link_table import is_parametric
from .equations.tree.separation import masses_in_trees
from .equations.tree.tree_terms import terms_of
from .equations.tree.triangular_root import has_recursive_root
from .model import Model, ModelError
from .model.check.assumptions import ANY, allowed, declared
from .model.normalise import name_of
from .model.recursion_depth import with_room
from .model.statement.states import as_mechanism
from .program.lower import Defaults, lower
from .program.motion_kernels import MotionKernels, motion_kernels
from .program.program import Program
from .render.emit import Sources, emit

_log = logging.getLogger("eigenmotion")


@dataclass(frozen=True, slots=True)
class Variant:
    """A program with some of the savings: the lengths of its state's parts, and its text."""

    name: str
    states: tuple[tuple[str, int], ...]
    sources: Sources


def generate(
    model: Model, choices: Choices = STANDARD, *, origin: str = "", savings: frozenset[Saving] = ALL_SAVINGS,
    whole: bool = True,
) -> Sources:  # fmt: skip
    """Derive, specialise, lower and print a model.

    Parameters
    ----------
    origin
        The command that the head of each file names.
    savings
        The simplifications allowed; tests switch some off to compare with the general program.
    whole
        Whether to generate derivatives too. Runs do not need them, and they take as long to generate as everything
        else. The text of the other functions does not depend on them.

    Raises
    ------
    ModelError
        The model has a mistake, or one of the choices does not work with it.
    """
    made = program(model, choices, savings, whole=whole)
    _log.info("printing %s", model.name)
    return emit(made, origin or _origin(model, choices), input_hash(model, choices))


def suited(model: Model, choices: Choices) -> Choices:
    """Return the choices with the formulation for masses in trees of bodies, if this is such a model."""
    return replace(choices, formulation="articulated_body") if masses_in_trees(model) else choices


def program(model: Model, choices: Choices, savings: frozenset[Saving] = ALL_SAVINGS, *, whole: bool = True) -> Program:
    """Return the record that the templates print."""
    if model.switches and choices.schur == "eigenfactor":
        raise ModelError(
            f'Model {model.name!r}: contacts change the rows of Delta within a run, of which schur="eigenfactor" '
            'carries eigenfactors. Build with schur="factor".'
        )
    return with_room(model, lambda: _program(model, choices, savings, whole))


def motion_in_one_piece(model: Model, groups: Sequence[Sequence[int]]) -> MotionKernels:
    """Return kernels of accelerations and their derivatives by groups of arguments, as `motion_kernels`."""
    mechanism = as_mechanism(model)

    def kernels() -> MotionKernels:
        scene = specialise(derive(mechanism, False, saves_by_nesting(mechanism)), mechanism.scales, ALL_SAVINGS)
        return motion_kernels(terms_of(scene), groups)

    return with_room(model, kernels)


def _program(model: Model, choices: Choices, savings: frozenset[Saving], whole: bool) -> Program:
    mechanism = as_mechanism(model)
    nested = saves_by_nesting(mechanism)

    def scene(may_loop: bool) -> Scene:
        _log.info("deriving %s", model.name)
        mechanics = derive(mechanism, may_loop, nested)
        _log.info("specialising %s", model.name)
        return specialise(mechanics, mechanism.scales, savings)

    made = scene(choices.formulation in (*OF_TREES, "cholesky"))
    if made.in_loops and choices.formulation == "cholesky" and not has_recursive_root(made.mechanics):
        made = scene(False)
    differentiated = scene(False) if whole and made.in_loops and not loops_differentiate(made) else made
    _log.info("assigning %s to functions", model.name)
    return lower(made, _defaults(model), choices, differentiated if whole else None)


def anatomy(model: Model) -> Anatomy:
    """Return the structure of the terms of a model, trees of bodies included."""

    def made() -> Anatomy:
        mechanism = as_mechanism(model)
        return anatomy_of(specialise(derive(mechanism, False, saves_by_nesting(mechanism)), mechanism.scales))

    return with_room(model, made)


def variants(model: Model, choices: Choices) -> tuple[Variant, ...]:
    """Return programs for runs with all savings, without each of them, and without any."""

    def made(name: str, savings: frozenset[Saving]) -> Variant:
        written = program(model, choices, savings, whole=False)
        states = tuple((part.name, part.length) for part in written.layout)
        return Variant(name, states, emit(written, _origin(model, choices), input_hash(model, choices)))

    each = [made(f"without {saving.name.lower()}", ALL_SAVINGS - {saving}) for saving in Saving]
    return (made("as generated", ALL_SAVINGS), *each, made("without all three", frozenset()))


def loops_differentiate(scene: Scene) -> bool:
    """Whether C adds the trees' part of derivatives in loops, too, which know none by parameters."""
    trees = scene.mechanics.trees
    return trees is not None and trees.table is not None and not is_parametric(trees.graph, *trees.table.nodes)


def input_hash(model: Model, choices: Choices = STANDARD) -> str:
    """Return the SHA-256 of the model and the choices: all inputs of the generated files except the compiler."""
    return hashlib.sha256("\n".join((model.canonical(), *astuple(choices))).encode()).hexdigest()


def explain(model: Model, choices: Choices = STANDARD) -> str:
    """Return a description for users: states, blocks, operation counts, and the terms left out, with reasons."""
    made = program(model, choices, whole=False)
    layout = [f"  {part.name:8} y[{part.start}:{part.start + part.length}]" for part in made.layout]
    blocks = [f"  {{{block.names}}}: {_kind(block.turning, block.fixed)}" for block in made.blocks]
    return "\n".join([
        f"{made.name}: {made.n} coordinates, {made.m} constraint rows ({made.h} holonomic), {made.n_state} states",
        "", f"State ({made.formulation})", *layout,
        *(("", "Units", *_units(model)) if model.units else ()),
        "", "Blocks of the mass matrix", *blocks,
        "", "Operations of the model-specific straight-line part", *(f"  {line}" for line in made.costs),
        "", "Lanes: right-hand sides of several states in one vector", *(f"  {line}" for line in _lanes(made)),
        *_time_events(made),
        "", "Left out", *(f"  {line}" for line in made.left_out or ("nothing",)),
        *(("", "Notes", *(f"  {note}" for note in model.notes)) if model.notes else ()),
    ])  # fmt: skip


def _lanes(made: Program) -> tuple[str, ...]:
    if made.normals:
        return ("none: friction is proportional to norms of multipliers, which are solved for one state at a time",)
    if not made.on_lanes:
        return ('none: close_eigenvalues="extrapolate" needs the memory of a run, which belongs to one state',)
    rest = f"lane by lane: {', '.join(made.lane_by_lane)}" if made.lane_by_lane else "nothing goes lane by lane"
    return ("the whole right-hand side", rest)


def _time_events(made: Program) -> tuple[str, ...]:
    """Return lines about time events, and about conditions on time alone that were not solved for time."""
    time_events, lines = made.kernels.time_events, []
    if time_events.named:
        lines += ["", "Time events: steps end where a condition on time alone changes, t =",
                  *(f"  {at}" for at in time_events.named)]  # fmt: skip
    if time_events.unsolved:
        lines += ["", "Conditions on time alone that steps may pass over, because they cannot be solved for time",
                  *(f"  {condition}" for condition in time_events.unsolved)]  # fmt: skip
    return tuple(lines)


def _units(model: Model) -> Iterator[str]:
    """Give a line for each unit, with the names that have it."""
    for unit in dict.fromkeys(unit for _, unit in model.units):
        yield f"  {unit}: {', '.join(name for name, one in model.units if one == unit)}"


def _kind(turning: bool, fixed: bool) -> str:
    if turning:
        return "varies, its root changes along the motion"
    return "constant, factored once per parameter set" if fixed else "one coordinate, s = sqrt(M) in closed form"


def _origin(model: Model, choices: Choices) -> str:
    """Return the call to `build` that generates these files; used for a model that does not come from a file."""
    chosen = ", ".join(f"{name}={value!r}" for name, value in asdict(choices).items())
    return f"eigenmotion.build(<Model {model.name}>, {chosen})"


def _defaults(model: Model) -> Defaults:
    start = dict(model.initial)
    states, none = tuple(start.get(z, 0.0) for z, _ in model.states), (0.0,) * len(model.states)
    return Defaults(
        parameters=tuple((symbol.name, value) for symbol, value in model.parameters),
        declared=_declared(model),
        inputs=tuple((name_of(u), value) for u, value in model.inputs),
        x=(*model.initial_x, *none),
        v=(*model.initial_v, *states),
        y=(*model.initial_y, *states) if model.initial_y else (),
        events=model.events,
        switches=model.switches,
        rows=model.row_names,
        tables=model.tables,
    )


def _declared(model: Model) -> tuple[tuple[int, str], ...]:
    """Return (bits, description) of the values that parameters, coordinates and inputs may take; () if all take any.

    The bits are those of `model.check.assumptions`.
    """
    coordinates = as_mechanism(model).coordinates
    symbols = (*(p for p, _ in model.parameters), *coordinates, *(u for u, _ in model.inputs))
    bits = [allowed(symbol) for symbol in symbols]
    return () if all(one == ANY for one in bits) else tuple((one, declared(one)) for one in bits)
