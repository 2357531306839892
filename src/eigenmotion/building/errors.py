"""Errors between a model and a compiled module."""

from ..codegen.model import ModelError


class BuildError(RuntimeError):
    """Generated code did not become a module; carries the tool's own words and the command.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.build(model, flags="-include nowhere.h")
    Traceback (most recent call last):
        ...
    eigenmotion.building.errors.BuildError: ...
    """


class CompilerNotFoundError(BuildError, ModelError):
    """There is no C compiler. Also a ModelError, as everything is that stops a model before its first run.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.build(model, compiler="nowhere-cc")
    Traceback (most recent call last):
        ...
    eigenmotion.building.errors.CompilerNotFoundError: no C compiler: nowhere-cc not found...
    """


class FolderError(BuildError, OSError):
    """A folder that is to hold what is built cannot be used: the cache's, or the one asked for."""
