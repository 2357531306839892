"""A compiler from energies to motion.

Names load what they need when first used, so that `eigenmotion --help` does not wait for SymPy and SciPy.
"""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .build import build as build
    from .codegen.model import Event as Event
    from .codegen.model import Model as Model
    from .codegen.model import ModelError as ModelError
    from .codegen.model import multiplier as multiplier
    from .codegen.model import t as t
    from .errors import BuildError as BuildError
    from .errors import CompilerNotFoundError as CompilerNotFoundError
    from .loading import load_model as load_model
    from .proof import ProofError as ProofError
    from .runtime import StopReason as StopReason
    from .signals import Signal as Signal
    from .simulate import simulate as simulate
    from .solution import Solution as Solution
    from .system import System as System

_HOME = {
    "BuildError": ".errors",
    "CompilerNotFoundError": ".errors",
    "Event": ".codegen.model",
    "Model": ".codegen.model",
    "ModelError": ".codegen.model",
    "ProofError": ".proof",
    "Signal": ".signals",
    "Solution": ".solution",
    "StopReason": ".runtime",
    "System": ".system",
    "build": ".build",
    "load_model": ".loading",
    "multiplier": ".codegen.model",
    "simulate": ".simulate",
    "t": ".codegen.model",
}


class _Package(ModuleType):
    """The package, whose `build` and `simulate` are functions and stay so.

    The import system binds a loaded submodule to the attribute of its name; here that would hide the function.
    """

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOME and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_HOME[name], __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
