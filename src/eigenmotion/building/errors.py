"""Errors of a build."""

from ..codegen.model import ModelError


class BuildError(RuntimeError):
    """Generated code could not be compiled or loaded; contains the output of the tool and the command.

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
    """There is no C compiler. Also a ModelError, like all errors before the first run of a model.

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
    """A folder for results of a build cannot be used: the cache, or `output`."""
