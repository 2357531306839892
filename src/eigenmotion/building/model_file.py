"""Model files: execution of a file that defines a `model`, and the models of files of robots."""

import inspect
import os
import re
import stat
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from threading import RLock
from types import ModuleType
from typing import Any, TypeVar

from ..codegen.model import Model, ModelError

T = TypeVar("T")
_loading = RLock()
"""Lock around changes of sys.path, with which a model file finds its imports: it belongs to the whole process."""
_TRUTH = {"1": True, "true": True, "yes": True, "on": True, "0": False, "false": False, "no": False, "off": False}
ROBOTS = (".urdf", ".xml")
_TEXTS = ("base", "locked", "name", "meshes")
"""Arguments of `load_urdf` and `load_mjcf` that can be given as texts"""


def load_model(path: str | PathLike[str], **keywords: object) -> Model:
    """Run the Python file at `path` and return the `model` it defines.

    Parameters
    ----------
    path
        A file that defines `model`: a Model, or a function returning one whose arguments all have defaults. Or a file
        of a robot: .urdf, or .xml, which is MJCF or URDF.
    **keywords
        Arguments of that function, parsed from text to the type of the default, as for `-D` on the command line. For a
        robot: `base`, `locked` (joints with commas between them), `name` or `meshes` of `load_urdf` and `load_mjcf`.

    Raises
    ------
    ModelError
        The file does not exist, raises an exception (names the line), defines no `model`, or has no such keyword.

    Examples
    --------
    >>> import eigenmotion as em
    >>> em.load_model("models/chain.py", n=3).name
    'chain_3'
    """
    file = _file(path)
    if file.suffix.lower() in ROBOTS:
        return _robot(file, keywords)
    with _loading, _importable(file.parent):
        defined = _guarded(file, lambda: _run(file)).get("model")
        if isinstance(defined, Model):
            return _without(file, defined, keywords)
        if defined is None:
            raise ModelError(f"{file}: defines no `model` (a Model, or a function that returns one)")
        if not callable(defined):
            raise ModelError(f"{file}: `model` is {_article(defined)}, not a Model or a function that returns one")
        arguments = _arguments(file, defined, keywords)
        built = _guarded(file, lambda: defined(**arguments))
    if not isinstance(built, Model):
        raise ModelError(f"{file}: model() returned {_article(built)}, not a Model")
    return built


def _robot(file: Path, keywords: Mapping[str, object]) -> Model:
    """Return the model of a file of a robot."""
    from ..robots.load import load_mjcf, load_urdf  # noqa: PLC0415, loads SciPy

    load = load_mjcf if re.search(rb"<mujoco[\s/>]", file.read_bytes()) else load_urdf
    known = [name for name in inspect.signature(load).parameters if name in _TEXTS]
    if unknown := [name for name in keywords if name not in known]:
        raise ModelError(f"{file}: a robot has no argument {_quoted(unknown)} for texts; it has {_quoted(known)}")
    given: dict[str, Any] = dict(keywords)
    if isinstance(given.get("locked"), str):
        given["locked"] = given["locked"].split(",")
    if isinstance(given.get("meshes"), str):
        given["meshes"] = _truth(file, given["meshes"])
    return load(file, **given)


def _truth(file: Path, text: str) -> bool:
    if text.lower() not in _TRUTH:
        raise ModelError(f"{file}: meshes={text!r} is neither yes nor no")
    return _TRUTH[text.lower()]


def _file(path: object) -> Path:
    """Return the path of an existing file."""
    try:
        file = Path(path)  # type: ignore[arg-type]
        if stat.S_ISREG(file.stat().st_mode):
            return file
    except TypeError as error:
        raise ModelError(f"{path!r} is neither a Model nor the path of a file that defines one") from error
    except FileNotFoundError as error:
        raise ModelError(f"{file}: no such file") from error
    except (OSError, ValueError) as error:
        raise ModelError(f"{str(file)!r}: {getattr(error, 'strerror', None) or error}") from error
    raise ModelError(f"{file}: not a file")


def _run(file: Path) -> dict[str, object]:
    """Execute the text of the file (never cached byte code) and return its global names."""
    module = ModuleType(f"_eigenmotion_model_{file.stem}")
    module.__file__ = str(file)
    exec(compile(file.read_bytes(), str(file), "exec", dont_inherit=True), module.__dict__)
    return module.__dict__


@contextmanager
def _importable(folder: Path) -> Iterator[None]:
    """Let a model file import modules beside it, with lower priority than installed ones.

    Afterwards the folder and these modules are removed again: another model may have another `geometry` beside it.
    """
    place = str(folder.resolve())
    before = set(sys.modules)
    sys.path.append(place)
    try:
        yield
    finally:
        if place in sys.path:
            del sys.path[len(sys.path) - 1 - sys.path[::-1].index(place)]
        if place not in sys.path:
            for name in [name for name in set(sys.modules) - before if _lies_in(sys.modules[name], place)]:
                del sys.modules[name]


def _lies_in(module: ModuleType, place: str) -> bool:
    return (getattr(module, "__file__", None) or "").startswith(os.path.join(place, ""))  # noqa: PTH118


def _guarded(file: Path, action: Callable[[], T]) -> T:
    """Return action(); turn exceptions into a ModelError that names the line of the user's file."""
    try:
        return action()
    except Exception as error:
        raise ModelError(f"{_place(file, error)}: {_words(error)}") from error
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        words = f"the file ended the program ({type(error).__name__}) instead of defining `model`"
        raise ModelError(f"{file}: {words}") from error


def _place(file: Path, error: Exception) -> str:
    """Return FILE:LINE of the innermost line of the user's file in the traceback."""
    if isinstance(error, SyntaxError) and error.filename == str(file):
        return f"{file}:{error.lineno}"
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(file)]
    return f"{file}:{lines[-1]}" if lines else str(file)


def _words(error: Exception) -> str:
    if isinstance(error, ModelError):
        return str(error)
    words = f"{type(error).__name__}: {error}"
    if isinstance(error, TypeError) and "truth value" in str(error):
        words += "\na Python `if`, `and` or `min` would decide now what depends on the motion: use sympy.Piecewise, Min"
    return words


def _without(file: Path, model: Model, keywords: Mapping[str, object]) -> Model:
    if keywords:
        raise ModelError(f"{file}: `model` is a Model and takes no keywords; {_quoted(keywords)} given")
    return model


def _arguments(file: Path, function: Callable[..., object], keywords: Mapping[str, object]) -> dict[str, object]:
    parameters = inspect.signature(function).parameters
    needed = [name for name, parameter in parameters.items() if _is_needed(parameter)]
    if needed:
        raise ModelError(f"{file}: every argument of model() must have a default; {_quoted(needed)} has none")
    unknown = [name for name in keywords if name not in parameters]
    if unknown:
        raise ModelError(f"{file}: model() has no argument {_quoted(unknown)}; it has {_quoted(parameters) or 'none'}")
    return {name: _parsed(file, name, value, parameters[name].default) for name, value in keywords.items()}


def _is_needed(parameter: inspect.Parameter) -> bool:
    free = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
    return parameter.default is inspect.Parameter.empty and parameter.kind not in free


def _parsed(file: Path, name: str, value: object, default: object) -> object:
    """Return text converted to the type of the default; other values unchanged."""
    if not isinstance(value, str) or isinstance(default, str):
        return value
    try:
        return _TRUTH[value.lower()] if isinstance(default, bool) else type(default)(value)  # type: ignore[call-arg]
    except (KeyError, TypeError, ValueError, OverflowError) as error:
        raise ModelError(f"{file}: {name}={value} is not {_article(default)} as the default {default!r} is") from error


def _quoted(names: object) -> str:
    return ", ".join(f"`{name}`" for name in names)  # type: ignore[attr-defined]


def _article(value: object) -> str:
    name = type(value).__name__
    return f"{'an' if name[0].lower() in 'aeiou' else 'a'} {name}"
