"""Arithmetic written out: what an algorithm does to its numbers, as a Python function without loops and questions."""

from collections.abc import Callable, Sequence
from typing import Any, Self

Algorithm = Callable[[Sequence[Any]], Sequence[Any]]


class Line:
    """A number that is not known yet: what is done to it is written down, in its order, a line an operation."""

    def __init__(self, name: str, text: list[str]) -> None:
        self.name, self.text = name, text

    def __add__(self, other: Any) -> Self:
        return self._of(self, "+", other)

    def __sub__(self, other: Any) -> Self:
        return self._of(self, "-", other)

    def __rsub__(self, other: Any) -> Self:
        return self._of(other, "-", self)

    def __mul__(self, other: Any) -> Self:
        return self._of(self, "*", other)

    def __truediv__(self, other: Any) -> Self:
        return self._of(self, "/", other)

    def _of(self, left: Any, sign: str, right: Any) -> Self:
        result = type(self)(f"r{len(self.text)}", self.text)
        self.text.append(f"{result.name} = {_named(left)} {sign} {_named(right)}")
        return result


def _named(number: Any) -> str:
    return number.name if isinstance(number, Line) else f"({number!r})"


def written(algorithm: Algorithm, zeros: Sequence[bool]) -> Callable[[Sequence[Any]], Sequence[Any]]:
    """Return a function that does what `algorithm` does to (k,) numbers: the same operations in the same order.

    Parameters
    ----------
    algorithm
        Asks no number for anything but whether it is the 0 of Python.
    zeros
        Of each number, whether it is.
    """
    text: list[str] = []
    given = [0 if is_zero else Line(f"g{k}", text) for k, is_zero in enumerate(zeros)]
    results = [_named(one) for one in algorithm(given)]
    head = f"def function(numbers):\n    {''.join(f'g{k}, ' for k in range(len(zeros)))}= numbers"
    lines = [head, *text, f"return [{', '.join(results)}]\n"]
    scope: dict[str, Any] = {}
    exec("\n    ".join(lines), scope)
    function: Callable[[Sequence[Any]], Sequence[Any]] = scope["function"]
    return function
