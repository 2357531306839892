"""Build of one model in every formulation, without the cache, so that build times can be measured."""

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..building.errors import BuildError, CompilerNotFoundError
from ..building.request import request
from ..building.shared_library import compile_in, load
from ..building.toolchain import EXTENSION_SUFFIX, toolchain
from ..codegen.choices import FORMULATIONS
from ..codegen.equations.derive import derive
from ..codegen.model import Model, ModelError
from ..codegen.model.statement.states import as_mechanism
from ..system.system import System


@dataclass(frozen=True, slots=True)
class Built:
    """The model in one formulation; times in s, generation includes derivation. `refused`: why it cannot be built."""

    formulation: str
    system: System | None
    generation: float = 0.0
    compilation: float = 0.0
    refused: str = ""


@dataclass(frozen=True, slots=True)
class Subject:
    """A model and its builds."""

    model: Model
    derivation: float
    built: tuple[Built, ...]

    @property
    def systems(self) -> tuple[System, ...]:
        """The systems of the formulations that could be built."""
        return tuple(built.system for built in self.built if built.system is not None)


def subject(model: Model, progress: Callable[[float, str], None]) -> Subject:
    """Derive, generate and compile a model in every formulation.

    Raises
    ------
    ModelError, BuildError
        No formulation can be built.
    """
    start = time.perf_counter()
    derive(as_mechanism(model))
    derivation = time.perf_counter() - start
    built = []
    names = tuple(dict.fromkeys((request(model).choices.formulation, *FORMULATIONS)))  # the one that `build` takes, too
    for k, formulation in enumerate(names):
        progress(k / len(names), f"building {formulation}")
        built.append(_built(model, formulation))
    builds = Subject(model, derivation, tuple(built))
    if not builds.systems:
        raise BuildError(f"{model.name}: no formulation can be built. {built[0].refused}")
    return builds


def _built(model: Model, formulation: str) -> Built:
    start = time.perf_counter()
    try:
        sources = request(model, formulation=formulation).sources()
        generated = time.perf_counter()
        with tempfile.TemporaryDirectory(prefix="eigenmotion-report-") as place:
            compile_in(sources, toolchain(), Path(place))
            compiled = time.perf_counter()
            system = load(Path(place) / f"{sources.name}{EXTENSION_SUFFIX}")
    except CompilerNotFoundError:
        raise
    except (BuildError, ModelError) as error:
        return Built(formulation, None, refused=str(error))
    return Built(formulation, system, generated - start, compiled - generated)
