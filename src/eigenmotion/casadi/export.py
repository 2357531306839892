"""Export of a model as external functions of CasADi: one C file, or the library compiled from it."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from ..arguments.named_values import spelled, unknown
from ..arguments.options import SHARED_FROM_START
from ..building.build import system_of
from ..building.processes import run
from ..building.request import Request, request
from ..building.toolchain import SHARED, STANDARD, link_flags, toolchain
from ..codegen.compiler import program as program_of
from ..codegen.kernel.kernel import Kernel
from ..codegen.model import Model, ModelError
from ..codegen.model.normalise import shown
from ..codegen.program.program import Program
from ..codegen.render.emit import emit
from ..files import write
from .functions import Function, functions_of
from .one_piece import one_piece
from .single_file import beside, single_file
from .sparsity import sparsity_of

if TYPE_CHECKING:
    from ..system.system import System

_STEPPER = "#if EM_HOLDS(EM_STEPPER)\n"
"""The line of NAME.c behind the functions of a state."""
_SUFFIXES = (".c", ".so")


@dataclass(frozen=True, slots=True)
class _Export:
    """What functions.c.jinja prints; see em_casadi.h."""

    functions: tuple[Function, ...]
    own: int
    parameters: tuple[str, ...]
    chosen: tuple[int, ...]
    dependent: int
    required: str
    equations: str
    has_outputs: bool
    accelerated: bool
    piece: str
    header: str
    words: dict[str, str]


def export_casadi(
    model: Model | str | PathLike[str],
    path: str | PathLike[str],
    *,
    parameters: Iterable[Any] | None = None,
    prefix: str = "",
    formulation: str | None = None,
    **keywords: Any,
) -> Path:
    """Write a model as external functions of CasADi with exact sparse Jacobians; return the path.

    The functions are `acceleration` (x, v -> a and multipliers), `rhs` (state -> its rate), `inverse_dynamics`
    (x, v, a and multipliers -> tau and the residual of the constraints) and, if the model has any, `outputs`. Inputs
    that the model lacks are left out: z (first-order states), u (inputs), p (parameters), t (time), multipliers.
    A state is x, v, z. Second derivatives are not available.

    Parameters
    ----------
    model
        A Model, or the file that defines one; `keywords` are arguments of the file's function.
    path
        FILE.so, compiled for this processor, or FILE.c, which needs a C11 compiler of the GCC or Clang kind and -lm.
    parameters
        Names of the parameters in p, in this order. The others have the model's values. Default: all.
    prefix
        What the names of the functions begin with, where a program links several models.
    formulation
        As in `build`; the results do not depend on it. Default: that with the shortest code.

    Raises
    ------
    ModelError
        A mistake in the model or the options; or the model has contacts, dry friction, or inputs that prescribe a
        motion: its acceleration is no function of state, inputs and parameters.
    BuildError
        There is no compiler, or it failed.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.export_casadi(model, "pendulum.c", parameters=["l"]).name
    'pendulum.c'
    """
    target = _target(path)
    if not isinstance(prefix, str) or not (prefix + "x").isidentifier() or not prefix.isascii() or prefix[:3] == "em_":
        raise ModelError(f"prefix is {prefix!r}: names of C functions begin with it, and those with em_ are ours")
    asked = request(model, keywords, formulation=formulation)
    if formulation is None and asked.choices.formulation != "articulated_body":
        asked = request(model, keywords, formulation="lagrange")
    text = external_functions(asked, None if parameters is None else list(parameters), prefix)[0]
    content = text.encode() if target.suffix == ".c" else _library(text)
    try:
        write(target, content)
    except OSError as error:
        raise ModelError(f"{target}: nothing can be written there ({error.strerror})") from error
    return target


def _target(path: object) -> Path:
    if not isinstance(path, (str, PathLike)):
        raise ModelError(f"path is {shown(path)}: give the name of a file, as {'arm.so'!r}")
    target = Path(path)
    if target.suffix not in _SUFFIXES:
        raise ModelError(f"{target}: functions of CasADi are a FILE.so, or a FILE.c to compile")
    if target.is_dir():
        raise ModelError(f"{target} is a folder: give the name of a file")
    return target


def external_functions(asked: Request, parameters: list[Any] | None, prefix: str) -> tuple[str, tuple[Function, ...]]:
    """Return the C text, and the functions that it has."""
    program = program_of(asked.model, asked.choices)
    _check_one_mode(program)
    system = system_of(asked)  # proves the equations
    export = _export(asked, program, system, _chosen(program, parameters), prefix)
    printed = _templates().get_template("functions.c.jinja").render(export=export)
    return single_file(_functions_of_a_state(asked, program) + printed), export.functions


def _functions_of_a_state(asked: Request, program: Program) -> str:
    """Return the text of NAME.c without what needs the stepper."""
    sources = emit(program, asked.origin, asked.input_hash)
    text = next(file.text for file in sources.files if file.name.endswith(".c"))
    functions, separator, _ = text.partition(_STEPPER)
    if not separator:
        raise AssertionError("the generated text has no line where the stepper begins")
    return f"#define rhs em_own_rhs /* one of CasADi's functions has this name */\n{functions}#endif\n#undef rhs\n\n"


def _check_one_mode(program: Program) -> None:
    """Raise ModelError for a model whose acceleration is no function of state, inputs and parameters alone."""
    if program.switches:
        name = program.events[program.switches[0].event].name
        raise ModelError(
            f"{program.name}: the acceleration depends on whether {name!r} holds, which a run decides. CasADi has no "
            "runs of ours. Export the model without contacts and dry friction, or use the derivatives of em.simulate."
        )
    if given := [table.name for table in program.tables if table.is_input]:
        raise ModelError(
            f"{program.name}: input {given[0]!r} prescribes a motion by its value and two derivatives, which one "
            "number in CasADi lacks. Write the motion as a function of time in the model."
        )


def _chosen(program: Program, names: list[Any] | None) -> tuple[int, ...]:
    """Return the numbers of the parameters in p."""
    tables = {table.parameter for table in program.tables}
    known = {one.name: k for k, one in enumerate(program.parameters) if k not in tables}
    if names is None:
        return tuple(known.values())
    wanted = list(map(spelled, names))
    if wrong := set(wanted) - set(known):
        raise ModelError(f"{program.name}: {unknown('parameter', wrong, tuple(known))}")
    if twice := [name for name in wanted if wanted.count(name) > 1]:
        raise ModelError(f"{program.name}: parameter {twice[0]!r} is given twice")
    return tuple(known[name] for name in wanted)


def _export(asked: Request, program: Program, system: "System", chosen: tuple[int, ...], prefix: str) -> _Export:
    recursive, of = program.kernels.required is not None, sparsity_of(program)
    x, _ = system.begin()
    dependent = program.m > 0 and bool(system.compiled.shares(0.0, x, system.prepare(), SHARED_FROM_START))
    return _Export(
        functions=functions_of(program, of, chosen, _is_timed(program), prefix),
        own=program.n - program.n_states,
        parameters=tuple(one.value for one in program.parameters),
        chosen=chosen,
        dependent=int(dependent),
        required="required_forces" if recursive else "em_required_forces",
        equations="equation_partials" if program.augmented else "em_equation_partials",
        has_outputs=bool(program.outputs),
        accelerated=of.accelerated,
        piece=one_piece(asked.model, program, chosen, dependent),
        header=beside("em_casadi.h"),
        words=_words(program, chosen),
    )


def _words(program: Program, chosen: tuple[int, ...]) -> dict[str, str]:
    """Return the names of the numbers in the inputs."""
    names = [one.name for one in program.coordinates]
    own, states = names[: program.n - program.n_states], names[program.n - program.n_states :]
    rates = [f"{name}'" for name in own]
    listed = {
        "x": own,
        "v": rates,
        "z": states,
        "state": [*own, *rates, *states],
        "a": [f"{name}''" for name in own],
        "u": [one.name for one in program.inputs],
        "p": [program.parameters[k].name for k in chosen],
    }
    return {key: ", ".join(words).replace("*/", "* /") for key, words in listed.items() if words}


def _is_timed(program: Program) -> bool:
    """Whether a function that CasADi calls depends on the time."""
    kernels = program.kernels
    of_rates = kernels.published.masses, kernels.published.motion, kernels.reaction_rates
    of_motion = kernels.mass_matrix, kernels.factored, kernels.pfaffian, kernels.bias, kernels.required
    asked = (*of_rates, *of_motion, kernels.outputs)
    return any("t" in kernel.reads for kernel in asked if isinstance(kernel, Kernel))


@cache
def _templates() -> Environment:
    return Environment(
        loader=PackageLoader(__package__, "."), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
        keep_trailing_newline=True, autoescape=False,
    )  # fmt: skip


def _library(text: str) -> bytes:
    """Return the compiled library."""
    tools = toolchain()
    with TemporaryDirectory() as place:
        work = Path(place)
        (work / "functions.c").write_text(text, encoding="utf-8")
        flags = (*STANDARD, *tools.optimised, *SHARED, *link_flags(tools.command), "-w", *tools.flags)
        run((*tools.command, *flags, "functions.c", "-lm", "-o", "functions.so"), work)
        return (work / "functions.so").read_bytes()
