"""The command line: `eigenmotion COMMAND ...`, and what its exit codes mean."""

import os
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import click

import eigenmotion as em

COMMANDS = {
    "generate": "Write the C, header and Cython sources of models, or check them.",
    "build": "Generate, then compile the importable module beside the sources.",
    "explain": "Say what the generated code carries, and what it leaves out and why.",
    "run": "Simulate a model; print a summary, draw it, save it.",
    "sweep": "Simulate a model for many values of parameters and starts; store every run.",
    "linearize": "Eigenvalues and modes of a model at a state.",
    "equilibrium": "Find where a model stays as it is.",
    "new": "Write a model file to start from.",
    "export": "Write a model as a unit that other tools import (FMI).",
    "page": "Write a page on which a model moves, alive, in any browser.",
    "report": "Measure error against run time, and recommend.",
    "stability": "Drive every formulation and method to its limits.",
    "cache": "Show where compiled models are kept, and clear it.",
}
_SIMULATION = ("run", "sweep", "linearize", "equilibrium", "report", "stability")
DONE, MISTAKE, FAILURE, INTERRUPTED = 0, 2, 3, 130

EPILOG = """\b
Exit codes:
  0    done, or nothing differs
  1    --check found a difference
  2    a mistake in the call or the model, or a run that ended early (says why)
  3    the compiler or the program itself failed
  130  interrupted

EIGENMOTION_CACHE, EIGENMOTION_CFLAGS and CC choose the cache's folder, more compiler flags and the compiler;
EIGENMOTION_DEBUG=1 shows tracebacks."""


def _folder(command: str) -> str:
    return "simulation" if command in _SIMULATION else "generation"


class Commands(click.Group):
    """Commands whose modules are imported when they are called, not when they are listed."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command: object = import_module(f".{_folder(cmd_name)}.{cmd_name}", __name__).command
        return command if isinstance(command, click.Command) else None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


@click.command(cls=Commands, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="eigenmotion")
def program() -> None:
    """Compile mechanisms, written down as energies in SymPy, to C, and simulate them."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    try:
        code: object = program.main(arguments, prog_name="eigenmotion", standalone_mode=False)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except (click.Abort, KeyboardInterrupt):
        click.echo("interrupted", err=True)
        return INTERRUPTED
    except Exception as error:
        return _failed(error)
    return code if isinstance(code, int) else DONE


def _failed(error: Exception) -> int:
    if os.environ.get("EIGENMOTION_DEBUG") == "1":
        traceback.print_exception(error)
    elif isinstance(error, click.ClickException):
        error.show()
    else:
        click.echo(f"error: {_words(error)}", err=True)
    return _exit_code(error)


def _exit_code(error: Exception) -> int:
    if isinstance(error, click.ClickException | OSError | MemoryError):
        return MISTAKE
    if isinstance(error, em.BuildError):  # before ModelError: a missing compiler is both
        return FAILURE
    return MISTAKE if isinstance(error, em.ModelError | em.EvaluationError) else FAILURE


def _words(error: Exception) -> str:
    if isinstance(error, OSError) and error.filename and error.strerror:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, MemoryError):
        return f"memory ran out ({error}). Ask for fewer rows, runs or values at a time"
    if isinstance(error, em.BuildError | em.ModelError | em.EvaluationError | OSError):
        return str(error)
    return f"{type(error).__name__}: {error} (internal; EIGENMOTION_DEBUG=1 shows where)"
