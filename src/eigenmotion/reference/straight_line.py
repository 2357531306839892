"""Straight-line code: records the arithmetic of an algorithm as a Python function without loops or branches."""

from collections.abc import Callable, Sequence
from typing import Any, Self

Algorithm = Callable[[Sequence[Any]], Sequence[Any]]


class Unknown:
    """A symbolic number that records each operation on it as one line of text."""

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
        self.text.append(f"{result.name} = {_text(left)} {sign} {_text(right)}")
        return result


def _text(number: Any) -> str:
    return number.name if isinstance(number, Unknown) else f"({number!r})"


def straight_line_function(algorithm: Algorithm, zeros: Sequence[bool]) -> Callable[[Sequence[Any]], Sequence[Any]]:
    """Return a function that does the same operations as `algorithm` on (k,) numbers, in the same order.

    Parameters
    ----------
    algorithm
        A function of (k,) numbers; its branches may depend only on whether a number is Python's 0.
    zeros
        (k,) whether each number is 0.
    """
    text: list[str] = []
    arguments = [0 if is_zero else Unknown(f"g{k}", text) for k, is_zero in enumerate(zeros)]
    results = [_text(one) for one in algorithm(arguments)]
    head = f"def function(numbers):\n    {''.join(f'g{k}, ' for k in range(len(zeros)))}= numbers"
    lines = [head, *text, f"return [{', '.join(results)}]\n"]
    scope: dict[str, Any] = {}
    exec("\n    ".join(lines), scope)
    function: Callable[[Sequence[Any]], Sequence[Any]] = scope["function"]
    return function
