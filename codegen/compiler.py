"""The compiler: from a model to the text of its files, in four calls."""

from __future__ import annotations

import hashlib
from dataclasses import astuple

from .c.emit import Sources, emit
from .c.lower import CLOSE_EIGENVALUES, FORMULATIONS, SCHUR, Choices, Defaults, lower
from .c.program import Program
from .model import Model, ModelError
from .model.normalise import name_of
from .physics.derive import derive
from .physics.specialise import ALL_SAVINGS, Saving, specialise


def generate(
    model: Model,
    *,
    formulation: str = "eigenfactor",
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
    origin: str = "",
    savings: frozenset[Saving] = ALL_SAVINGS,
) -> Sources:
    """Derive, specialise, lower and print a model.

    Parameters
    ----------
    formulation, close_eigenvalues, schur
        See section "Build" of the manual; unknown ones are errors.
    origin
        The command to name in the files.
    savings
        What may be left out; tests switch some off to compare with the general program.

    Raises
    ------
    ModelError
        The model, or a choice, has a mistake.
    """
    choices = _choices(formulation, close_eigenvalues, schur)
    return emit(program(model, choices, savings), origin or _origin(model, choices), _hash(model, choices))


def program(model: Model, choices: Choices, savings: frozenset[Saving] = ALL_SAVINGS) -> Program:
    """Return the record that the templates print."""
    scene = specialise(derive(model), model.scales, savings)
    return lower(scene, _defaults(model), choices)


def input_hash(model: Model, *, formulation: str = "eigenfactor", close_eigenvalues: str = "bounded",
               schur: str = "auto") -> str:  # fmt: skip
    """Return the SHA-256 of everything that the generated files depend on but this compiler itself."""
    return _hash(model, _choices(formulation, close_eigenvalues, schur))


def explain(model: Model, *, formulation: str = "eigenfactor", close_eigenvalues: str = "bounded",
            schur: str = "auto") -> str:  # fmt: skip
    """Return a text for readers: states, blocks, operations, and what was left out and why."""
    made = program(model, _choices(formulation, close_eigenvalues, schur))
    layout = [f"  {part.name:8} y[{part.start}:{part.start + part.length}]" for part in made.layout]
    blocks = [f"  {{{block.names}}}: {_kind(block.turning, block.fixed)}" for block in made.blocks]
    return "\n".join([
        f"{made.name}: {made.n} coordinates, {made.m} constraint rows ({made.h} holonomic), {made.n_state} states",
        "", f"State ({made.formulation})", *layout,
        "", "Blocks of the mass matrix", *blocks,
        "", "Operations of the model-specific straight-line part", *(f"  {line}" for line in made.costs),
        "", "Left out", *(f"  {line}" for line in made.left_out or ("nothing",)),
    ])  # fmt: skip


def _kind(turning: bool, fixed: bool) -> str:
    if turning:
        return "varies, its root changes along the motion"
    return "constant, factored once per parameter set" if fixed else "one coordinate, s = sqrt(M) in closed form"


def _choices(formulation: str, close_eigenvalues: str, schur: str) -> Choices:
    _check("formulation", formulation, FORMULATIONS)
    _check("close_eigenvalues", close_eigenvalues, CLOSE_EIGENVALUES)
    _check("schur", schur, SCHUR)
    return Choices(formulation, close_eigenvalues, schur)


def _check(what: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise ModelError(f"{what} {value!r} is not known; choose one of {', '.join(known)}")


def _origin(model: Model, choices: Choices) -> str:
    """Say how these files come about where the model is of no file."""
    chosen = zip(("formulation", "close_eigenvalues", "schur"), astuple(choices), strict=True)
    return f"eigenmotion.build(<Model {model.name}>, {', '.join(f'{name}={value!r}' for name, value in chosen)})"


def _hash(model: Model, choices: Choices) -> str:
    text = "\n".join((model.canonical(), choices.formulation, choices.close_eigenvalues, choices.schur))
    return hashlib.sha256(text.encode()).hexdigest()


def _defaults(model: Model) -> Defaults:
    return Defaults(
        parameters=tuple((symbol.name, value) for symbol, value in model.parameters),
        inputs=tuple((name_of(u), value) for u, value in model.inputs),
        x=model.initial_x,
        v=model.initial_v,
        y=model.initial_y,
        events=model.events,
    )
