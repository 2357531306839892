"""The snippets of a page, run as a reader would run them: from top to bottom, in one folder, with one Python.

What becomes of a code block follows from its language and its first line:

    python      `# NAME.py`: written to that file; with `>>>`: compared as doctests are; else executed
    sh          commands, each of which must succeed
    console     commands after `$`, with what they print below them
    text        what the block before it printed
    c           `// NAME.c`: written to that file; else an excerpt of a file in `generated`, `...` between its parts
    yaml, toml  read, as their own kind

In printed text `...` stands for anything. A comment above a block changes what becomes of it, and readers do not see
it: `<!-- nightly -->` for what takes long (not above a block: the whole page), `<!-- not run: why -->` for what needs
what is not here (syntax and options are looked at all the same). `<!-- python` ... `-->` is executed and not shown.
"""

from __future__ import annotations

import doctest
import io
import os
import re
import runpy
import shlex
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import click
import yaml

from eigenmotion.cli import main, program

ROOT = Path(__file__).parents[2]
LENIENT = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
SETS_UP = {"make", "pip", "source"}
"""Commands that a reader types once, and that are not for a test."""

_FENCE = re.compile(
    r"^(?P<hidden><!-- )?(?P<indent> *)(?(hidden)|(?P<fence>```+))(?P<language>[a-z]+)(?(hidden)|[^\n]*)\n"
    r"(?P<text>.*?)^(?(hidden)-->|(?P=indent)(?P=fence)) *$",
    re.MULTILINE | re.DOTALL,
)
_MARK = re.compile(r"<!-- (nightly|not run)\b[^\n]*-->\s*\Z")


class SnippetError(AssertionError):
    """A snippet does not do what its page says; names the page and the line."""


@dataclass(frozen=True, slots=True)
class Block:
    """A code block: where its text begins, its language, and the mark above it, if any."""

    page: Path
    line: int
    language: str
    text: str
    mark: str = ""

    @property
    def first(self) -> str:
        """Its first line."""
        return self.text.split("\n", 1)[0]


def blocks(page: Path) -> list[Block]:
    """Return the code blocks of a page, in order."""
    text, found, last = page.read_text(encoding="utf-8"), [], 0
    everywhere = "nightly" if re.search(r"\A<!-- nightly -->\n\n?(?!```)", text) else ""
    for match in _FENCE.finditer(text):
        above = _MARK.search(text[last : match.start()])
        lines = match["text"].split("\n")
        indent = len(match["indent"])
        number = text.count("\n", 0, match.start("text")) + 1
        mark = above[1] if above else everywhere
        found.append(Block(page, number, match["language"], "\n".join(line[indent:] for line in lines), mark))
        last = match.end()
    return found


@dataclass
class Reader:
    """Somebody who works through a page in the folder they are in."""

    names: dict[str, Any] = field(default_factory=lambda: {"__name__": "__main__"})
    printed: str = ""

    def read(self, page: Path, night: bool = True) -> None:
        """Run what a page has; by day without what is for the night."""
        for block in blocks(page):
            if block.mark == "not run":
                self._look_at(block)
            elif night or block.mark != "nightly":
                self._run(block)

    def _run(self, block: Block) -> None:
        try:
            getattr(self, f"_{block.language}", self._unknown)(block)
        except Exception as error:
            raise SnippetError(f"{block.page.name}:{block.line}: {type(error).__name__}: {error}") from error

    def _unknown(self, block: Block) -> None:
        raise SnippetError(f"there is no way to run {block.language!r}")

    def _look_at(self, block: Block) -> None:
        """Check of what is not run what can be checked: Python's syntax, names and options of commands."""
        if block.language == "python":
            self._compile(block)
        elif block.language == "sh":
            for line in _commands(block.text):
                words = shlex.split(line, comments=True)
                if words[0] == "eigenmotion":
                    _parse(words[1:])

    def _compile(self, block: Block) -> Any:
        """Return code whose tracebacks show the line of the page."""
        return compile("\n" * (block.line - 1) + block.text, str(block.page), "exec")

    def _python(self, block: Block) -> None:
        if name := re.fullmatch(r"# ([\w/]+\.py)", block.first):
            _write(name[1], block.text)
        elif block.text.lstrip().startswith(">>>"):
            self._doctest(block)
        else:
            self.printed, _ = _listen(lambda: exec(self._compile(block), self.names))

    def _doctest(self, block: Block) -> None:
        test = doctest.DocTestParser().get_doctest(block.text, self.names, block.page.name, str(block.page), block.line)
        said = io.StringIO()
        runner = doctest.DocTestRunner(optionflags=LENIENT, verbose=False)
        runner.run(test, out=said.write, clear_globs=False)
        self.names.update(test.globs)
        if runner.failures:
            raise SnippetError(said.getvalue())

    def _sh(self, block: Block) -> None:
        for command in _commands(block.text):
            self.printed, code = perform(command)
            if code != 0:
                raise SnippetError(f"{command} ended with {code}:\n{self.printed}")

    def _console(self, block: Block) -> None:
        for part in re.split(r"^\$ ", block.text, flags=re.MULTILINE)[1:]:
            command, _, expected = re.sub(r"\\\n *> *", "", part).partition("\n")
            self.printed, _ = perform(command)
            _compare(expected, self.printed)

    def _text(self, block: Block) -> None:
        _compare(block.text, self.printed)

    def _c(self, block: Block) -> None:
        if name := re.fullmatch(r"// (\w+\.c)", block.first):
            _write(name[1], block.text)
        elif not any(_excerpt(block.text, path.read_text()) for path in (ROOT / "generated").glob("*.c")):
            raise SnippetError("no file in generated/ has these lines")

    def _yaml(self, block: Block) -> None:
        yaml.safe_load(block.text)

    def _toml(self, block: Block) -> None:
        tomllib.loads(block.text)


def _write(name: str, text: str) -> None:
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _compare(expected: str, found: str) -> None:
    if not doctest.OutputChecker().check_output(expected, found, LENIENT):
        raise SnippetError(f"the page says\n{expected}\nand it was\n{found}")


def _excerpt(text: str, whole: str) -> bool:
    """Whether the parts of a text, between lines of `...`, stand in another one, in order."""
    at = 0
    for part in re.split(r"^[ /*]*\.\.\.\n", text, flags=re.MULTILINE):
        at = whole.find(part.rstrip(" \n"), at)
        if at < 0:
            return False
    return True


def _commands(text: str) -> Iterator[str]:
    """Give the commands of a block: lines, with those that end in a backslash continued."""
    yield from (line for line in text.replace("\\\n", " ").splitlines() if line.strip() and not line.startswith("#"))


def perform(command: str) -> tuple[str, int]:
    """Run a command line as a shell would; return what it printed, errors included, and its exit code.

    Ours run in this process, which has imported what they need.
    """
    words = [word for given in shlex.split(command, comments=True) for word in _expanded(given)]
    named, *arguments = words
    if named in SETS_UP:
        return "", 0
    if named == "eigenmotion":
        return _listen(lambda: main(arguments))
    if named == "python" and arguments[0].endswith(".py"):
        return _listen(lambda: runpy.run_path(arguments[0], run_name="__main__") and 0)
    where = {"PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])}
    done = subprocess.run(
        ["bash", "-c", command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
        env=os.environ | where,
    )  # fmt: skip
    return done.stdout, done.returncode


def _parse(arguments: list[str]) -> None:
    """Read a command of ours without doing what it says; refuses as the command line does."""
    command = program.get_command(click.Context(program), arguments[0])
    if command is None:
        raise SnippetError(f"there is no command {arguments[0]!r}")
    command.make_context(arguments[0], arguments[1:])


def _expanded(word: str) -> list[str]:
    found = sorted(map(str, Path().glob(word))) if "*" in word and not os.path.isabs(word) else []  # noqa: PTH117
    return found or [word]


def _listen(act: Callable[[], object]) -> tuple[str, int]:
    """Return what is printed meanwhile, and a code that is returned."""
    heard = io.StringIO()
    with redirect_stdout(heard), redirect_stderr(heard):
        code = act()
    return heard.getvalue(), code if isinstance(code, int) else 0
