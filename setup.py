"""Extension modules; each is built anew when a header changes that it includes.

The compiler lists these headers in NAME.d beside NAME.pyx, for make as for setuptools.
"""

from os import cpu_count
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCES = Path("src")
INCLUDE = SOURCES / "eigenmotion" / "runtime" / "include"
SUMS = {"steppers", "variations"}
"""Modules that integrate themselves, and do not only call models."""


class Build(build_ext):
    def finalize_options(self) -> None:
        super().finalize_options()
        self.parallel = self.parallel or cpu_count()

    def build_extension(self, ext: Extension) -> None:
        kept = (SOURCES / ext.name.replace(".", "/")).with_suffix(".d")
        fresh = kept.with_suffix(".d.new")
        ext.depends = _listed(kept)
        self.force = not all(Path(header).exists() for header in ext.depends)
        ext.extra_compile_args += ["-MMD", "-MF", str(fresh)]
        super().build_extension(ext)
        if fresh.exists():
            _keep(fresh, kept)


def _listed(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8").partition("\n")[0].split()[1:] if path.exists() else []


def _keep(fresh: Path, kept: Path) -> None:
    """Keep our own headers of the compiler's list: others may be those of an environment that is gone."""
    words = fresh.read_text(encoding="utf-8").replace("\\\n", " ").split()
    ours = sorted({word for word in words if Path(word).is_relative_to(INCLUDE)})
    gone = "".join(f"{header}:\n" for header in ours)  # so that make accepts one that is gone
    kept.write_text(f"$(READY): {' '.join(ours)}\n{gone}", encoding="utf-8")
    fresh.unlink()


def extension(path: Path) -> Extension:
    level = "-O3" if path.stem in SUMS else "-O2"
    name = ".".join(path.relative_to(SOURCES).with_suffix("").parts)
    return Extension(name, [str(path)], [str(INCLUDE)], extra_compile_args=[level])


setup(ext_modules=[extension(path) for path in sorted(SOURCES.rglob("*.pyx"))], cmdclass={"build_ext": Build})
