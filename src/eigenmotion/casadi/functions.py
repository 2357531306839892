"""The external functions of a model: their inputs, outputs and the sparsity of their Jacobians."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..codegen.program.program import Program
from .sparsity import Places, Sparsity


@dataclass(frozen=True, slots=True)
class Argument:
    """An input of a function: its name, its kind in em_casadi.h, and the columns of its derivatives."""

    name: str
    kind: str
    columns: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Result:
    """An output of a function: its name, the first row of its derivatives, and the number of its numbers."""

    name: str
    first_row: int
    size: int


@dataclass(frozen=True, slots=True)
class Function:
    """An external function.

    blocks : for each pair of an output and an input, its sparsity in CasADi's form: rows, columns, where each column
        begins, and the row of each entry
    """

    name: str
    kind: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Result, ...]
    blocks: tuple[tuple[int, ...], ...]

    @property
    def words(self) -> str:
        """The function with its arguments and results, as CasADi prints it."""
        given = ", ".join(f"{one.name}[{len(one.columns)}]" for one in self.inputs)
        found = ", ".join(f"{one.name}[{one.size}]" for one in self.outputs)
        return f"{self.name}: ({given}) -> ({found})"


def functions_of(
    program: Program, of: Sparsity, parameters: Sequence[int], timed: bool, prefix: str
) -> tuple[Function, ...]:
    """Return the functions of a model.

    Parameters
    ----------
    of
        The sparsity of its derivatives.
    parameters
        Numbers of the parameters that are an input.
    timed
        Whether time is an input.
    """
    n, m, states = program.n, program.m, program.n_states
    own = n - states
    arguments = {one.name: one for one in _arguments(program, parameters, timed)}
    rest = [arguments[name] for name in ("z", "u", "p", "t") if arguments[name].columns]
    motion, state = (arguments["x"], arguments["v"], *rest), (arguments["state"], *(r for r in rest if r.name != "z"))
    reactions = (Result("multipliers", own + n, m),) if m else ()
    shifted = frozenset((own + row, column) for row, column in of.motion)
    rates = shifted | {(k, n + k) for k in range(own)}
    forces = (arguments["a"], *((arguments["multipliers"],) if m else ()))
    found = [
        _function("acceleration", "EM_ACCELERATION", motion, (Result("a", own, own), *reactions), rates),
        _function("rhs", "EM_RATES", state, (Result("rate", 0, own + n),), rates),
        _function("inverse_dynamics", "EM_INVERSE", (*motion[:2], *forces, *rest),
                  (Result("tau", 0, own), *((Result("residual", n, m),) if m else ())), of.inverse),
    ]  # fmt: skip
    if program.outputs:
        found.append(_function("outputs", "EM_OUTPUTS", motion, (Result("y", 0, len(program.outputs)),), of.outputs))
    return tuple(Function(prefix + one.name, one.kind, one.inputs, one.outputs, one.blocks) for one in found)


def _arguments(program: Program, parameters: Sequence[int], timed: bool) -> Iterable[Argument]:
    """Yield all inputs that functions may have; those that this model lacks have no columns."""
    n, own, inputs = program.n, program.n - program.n_states, len(program.inputs)
    last = 2 * n + inputs + len(program.parameters)
    x, v, z = range(own), range(n, n + own), range(n + own, 2 * n)
    yield Argument("x", "EM_BY_X", tuple(x))
    yield Argument("v", "EM_BY_V", tuple(v))
    yield Argument("z", "EM_BY_Z", tuple(z))
    yield Argument("state", "EM_BY_STATE", (*x, *v, *z))
    yield Argument("u", "EM_BY_U", tuple(range(2 * n, 2 * n + inputs)))
    yield Argument("p", "EM_BY_P", tuple(2 * n + inputs + k for k in parameters))
    yield Argument("t", "EM_BY_T", (last,) if timed else ())
    yield Argument("a", "EM_BY_A", tuple(range(last + 1, last + 1 + own)))
    yield Argument("multipliers", "EM_BY_MULTIPLIERS", tuple(range(last + 1 + n, last + 1 + n + program.m)))


def _function(
    name: str, kind: str, inputs: tuple[Argument, ...], outputs: tuple[Result, ...], places: Places
) -> Function:
    blocks = tuple(_compressed(places, found, given) for found in outputs for given in inputs)
    return Function(name, kind, inputs, outputs, blocks)


def _compressed(places: Places, found: Result, given: Argument) -> tuple[int, ...]:
    """Return the sparsity of a block in CasADi's form."""
    columns = [
        [row for row in range(found.size) if (found.first_row + row, column) in places] for column in given.columns
    ]
    begins = [0]
    for column in columns:
        begins.append(begins[-1] + len(column))
    return found.size, len(columns), *begins, *(row for column in columns for row in column)
