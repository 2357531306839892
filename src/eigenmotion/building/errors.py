"""What can go wrong on the way from a model to a compiled module."""

from ..codegen.model import ModelError


class BuildError(RuntimeError):
    """Generated code did not become a module; carries the tool's own words and the command."""


class CompilerNotFoundError(BuildError, ModelError):
    """There is no C compiler. Also a ModelError, as everything is that stops a model before its first run."""


class FolderError(BuildError, OSError):
    """A folder that is to hold what is built cannot be used: the cache's, or the one asked for."""
