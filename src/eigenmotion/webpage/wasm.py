"""Compilation of a model to WebAssembly, by the `ziglang` wheel (extra `page`) or a clang with a wasm sysroot."""

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..building.build import first_sources
from ..building.cache import entry, guarded, key
from ..building.errors import BuildError, CompilerNotFoundError
from ..building.lazy_units import at_first
from ..building.processes import run
from ..building.request import Request
from ..building.toolchain import INCLUDE, STEPPER, ZIG, headers, zig_is_there
from ..codegen.render.emit import Sources

_FLAGS = ("-std=c11", "-O2", "-ffp-contract=off", "-mexec-model=reactor", "-Wl,--strip-all", "-w", "-DEM_FOR_PAGES")
_OF_PAGES = ("model", "rhs", "aside", "derivatives")
_HARNESS = Path(__file__).parent / "em_page.c"
_TRIED = "#include <math.h>\n#include <stdlib.h>\nint main(void) { return malloc(1) == 0; }\n"


@dataclass(frozen=True, slots=True)
class WasmCompiler:
    """A command that compiles C to WebAssembly; `identity` contains its version."""

    command: tuple[str, ...]
    identity: str


def module(requested: Request) -> bytes:
    """Return the WebAssembly of a request, from the cache if possible.

    Raises
    ------
    CompilerNotFoundError
        There is no compiler; says what to install.
    """
    tools, sources = wasm_compiler(), first_sources(requested)
    texts = [file.text for file in sources.files if not file.name.endswith(".pyx")]
    name = key(tools.identity, *_FLAGS, _HARNESS.read_bytes(), *texts, headers())
    folder = entry("pages", name, lambda folder: _compile(sources, tools, folder))
    with guarded():
        return (folder / f"{sources.name}.wasm").read_bytes()


def _compile(sources: Sources, tools: WasmCompiler, folder: Path) -> None:
    """Compile in a temporary folder, since compilers leave other files; copy only the module."""
    name = sources.name
    with tempfile.TemporaryDirectory() as place:
        work = Path(place)
        for file in sources.files:
            (work / file.name).write_text(file.text, encoding="utf-8")
        options = (*_FLAGS, f"-DEM_UNIT={_units(sources)}", f"-DEM_PAGE_MODEL={name}_model", f"-I{INCLUDE}", "-I.")
        run((*tools.command, *options, f"{name}.c", str(_HARNESS), _stepper(tools), "-o", f"{name}.wasm"), work)
        shutil.copyfile(work / f"{name}.wasm", folder / f"{name}.wasm")


def _units(sources: Sources) -> str:
    """Return the units that runs of a page need: explicit steps without lanes, so derivatives only where models do."""
    text = "".join(file.text for file in sources.files)
    return "|".join(f"EM_{unit.upper()}" for unit in at_first(text) if unit in _OF_PAGES)


def _stepper(tools: WasmCompiler) -> str:
    """Return the path of the stepper's object, which all pages share."""

    def fill(folder: Path) -> None:
        source = str(INCLUDE / f"{STEPPER}.c")
        run((*tools.command, *_FLAGS, f"-I{INCLUDE}", "-c", source, "-o", f"{STEPPER}.o"), folder)

    return str(entry("steppers", key(headers(), tools.identity, *_FLAGS), fill) / f"{STEPPER}.o")


@cache
def wasm_compiler() -> WasmCompiler:
    """Return a compiler for WebAssembly.

    Raises
    ------
    CompilerNotFoundError
        There is none.
    """
    for command in _candidates():
        with suppress(BuildError):
            version = run((*command, "--version")).splitlines()[0]
            if "ziglang" in command or _compiles(command):
                return WasmCompiler(command, f"{' '.join(command)} {version}")
    raise CompilerNotFoundError(
        "a page holds the model as WebAssembly, and there is no compiler for that: pip install 'eigenmotion[page]' "
        "(the ziglang wheel), or install a clang with wasm-ld and a WASI sysroot "
        "(Debian: clang lld wasi-libc libclang-rt-dev-wasm32)"
    )


def _candidates() -> Iterator[tuple[str, ...]]:
    if zig_is_there():
        yield (*ZIG, "-target", "wasm32-wasi")
    if clang := shutil.which("clang"):
        yield (clang, "--target=wasm32-wasi")


def _compiles(command: tuple[str, ...]) -> bool:
    """Return whether the command also has a library and a linker."""
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "tried.c").write_text(_TRIED, encoding="utf-8")
        run((*command, "tried.c", "-o", "tried.wasm"), Path(place))
        return (Path(place) / "tried.wasm").exists()
