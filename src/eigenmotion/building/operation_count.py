"""Operations that one right-hand side executes, counted by compiling its C with a number type that counts."""

from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from ..codegen.render.emit import Sources
from .errors import BuildError
from .processes import run
from .toolchain import INCLUDE

_COUNTER = Path(__file__).with_name("operations.cpp")
_COMPILER = "clang++"  # g++ refuses designated initialisers in another order than the members', which is valid C


def operations(sources: Sources) -> int:
    """Return the operations of one right-hand side as it is executed, loops included, at the model's initial state.

    They are additions, multiplications, divisions, roots and function calls, each counted as one.

    Raises
    ------
    BuildError
        There is no clang++, or the right-hand side cannot be evaluated there.
    """
    with TemporaryDirectory(prefix="eigenmotion-count-") as place:
        for file in sources.files:
            (Path(place) / file.name).write_text(file.text, encoding="utf-8")
        return operations_in(sources.name, Path(place))


def operations_in(name: str, folder: Path) -> int:
    """Return the operations as `operations`, of NAME.c in a folder.

    Raises
    ------
    BuildError
        As `operations`.
    """
    if which(_COMPILER) is None:
        raise BuildError(f"operations are counted by {_COMPILER}, which is not installed (apt-get install clang)")
    model = (f'-DSOURCE="{name}.c"', f"-DMODEL={name}_model", f"-I{INCLUDE}", "-I.")
    unresolved = ("-no-pie", "-Wl,--unresolved-symbols=ignore-all")  # functions that no right-hand side calls
    run((_COMPILER, "-std=c++20", "-w", *model, str(_COUNTER), *unresolved, "-o", "counter"), folder)
    return sum(map(int, run((str(folder / "counter"),), folder).split()))
