"""Command line: `eigenmotion COMMAND ...`, and its exit codes."""

import os
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import click

import eigenmotion as em

COMMANDS = {
    "generate": "Write the C, header and Cython sources of models, or check them.",
    "build": "Generate the sources, and compile an importable module beside them.",
    "explain": "Show the states and blocks of the generated code, and which terms it leaves out and why.",
    "run": "Simulate a model; print a summary, plot, animate or save the motion.",
    "sweep": "Simulate a model for many values of parameters and initial values; store every run.",
    "linearize": "Show the eigenvalues and modes of a model at a state.",
    "drive": "Find the forces that drive a model along a prescribed motion.",
    "equilibrium": "Find an equilibrium of a model.",
    "cycle": "Find a periodic motion of a model, and follow it along a parameter.",
    "new": "Write a model file to start from.",
    "export": "Export a model as a Functional Mock-up Unit (FMI) for other tools.",
    "page": "Write an interactive web page that simulates a model in the browser.",
    "report": "Measure error against run time, and recommend a method.",
    "stability": "Run extreme cases with every formulation and method.",
    "cache": "Show or clear the cache of compiled models.",
}
_SIMULATION = ("run", "sweep", "linearize", "equilibrium", "cycle", "drive", "report", "stability")
DONE, MISTAKE, FAILURE, INTERRUPTED = 0, 2, 3, 130

EPILOG = """\b
Exit codes:
  0    done, or nothing differs
  1    --check found a difference
  2    an error in the call or the model, or a run that ended early (the message says why)
  3    the compiler or the program itself failed
  130  interrupted

EIGENMOTION_CACHE sets the folder of the cache, EIGENMOTION_CFLAGS adds compiler flags, and CC sets the compiler;
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
    """Compile mechanisms, described by their energies in SymPy, to C, and simulate them."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    try:
        code: object = program.main(arguments, prog_name="eigenmotion", standalone_mode=False)
        if sys.stdout is not None:  # None: it was closed by the caller (>&-), and nobody reads it
            sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except (click.Abort, KeyboardInterrupt) as error:
        click.echo(f"interrupted {error.__cause__ or error}".rstrip(), err=True)  # click raises Abort in its place
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
