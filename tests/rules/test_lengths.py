"""Files that one can hold in mind, functions that fit on a screen."""

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
WRITTEN = ("codegen", "src", "templates", "tests", "models", "benchmarks", "docs/making")


def written(*endings: str) -> Iterator[Path]:
    """Files that people wrote, with these endings."""
    kept = (ROOT / folder for folder in WRITTEN)
    yield from (
        path for folder in kept for path in sorted(folder.rglob("*")) if path.suffix in endings and path.is_file()
    )


def compiled_from(path: Path) -> bool:
    """Whether a C file is what Cython made of its neighbour."""
    return path.suffix == ".c" and path.with_suffix(".pyx").exists()


def test_no_file_is_longer_than_500_lines():
    files = written(".py", ".pyi", ".pyx", ".pxd", ".h", ".c", ".jinja", ".js", ".css")
    lengths = {file: len(file.read_text(encoding="utf-8").splitlines()) for file in files if not compiled_from(file)}
    assert len(lengths) > 500
    assert not {str(file.relative_to(ROOT)): length for file, length in lengths.items() if length > 500}


def test_generated_c_is_no_wider_than_120_columns():
    """Of the models whose text is kept; `make generated` looks at all."""
    lines = {path: path.read_text(encoding="utf-8").splitlines() for path in (ROOT / "generated").rglob("*.[ch]")}
    assert len(lines) == 2 * 8
    assert not {name: line for name, text in lines.items() for line in text if len(line) > 120}


def test_no_function_is_longer_than_a_screen():
    """50 lines, without what it takes and what its docstring says."""
    long = {}
    for file in written(".py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                body = node.body[ast.get_docstring(node) is not None :] or node.body
                long[f"{file.name} {node.name}"] = node.end_lineno - body[0].lineno + 1
    assert not {name: length for name, length in long.items() if length > 50}
