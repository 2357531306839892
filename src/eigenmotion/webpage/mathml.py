"""MathML of names and equations, which browsers render without a library."""

import re
from collections.abc import Iterator, Mapping
from html import escape
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.printing.mathml import MathMLPresentationPrinter

from ..codegen.model.normalise import MULTIPLIER, name_of
from ..codegen.model.symbolic.equations import Equations

_DOTS = {1: "·", 2: "··"}  # rendered in any font, unlike accents over letters
_TALL = 4000
"""Longest text of a matrix on a page."""
_TIMES = "<mo>&#x2062;</mo>"
_THIN = "<mspace width='0.1667em'/>"
_WORD = "<mi>[A-Za-z]{2,}</mi>"
_RATE_OF_WORD = rf"<mover>{_WORD}<mo>(?:·|&#183;)+</mo></mover>"
_NAMED = rf"(?:<mrow>)?(?:<msu[bp]>)?{_WORD}"
"""The beginning of a function or symbol with a name of several letters, also of a power of it"""
_WORD_LENGTH = 3
"""Letters from which the beginning of a name is a word"""
_HASH = r"__[0-9a-f]{32,}"
"""What the name of a table has behind the user's name"""


class _Printer(MathMLPresentationPrinter):  # type: ignore[misc]
    """SymPy's printer, with dots over the letters for symbols that represent rates, and what SymPy writes as text."""

    def __init__(self, rates: Mapping[sympy.Symbol, sympy.Derivative]) -> None:
        super().__init__()
        self.rates = rates

    def _print_Function(self, function: sympy.Function) -> Any:
        if function.func == MULTIPLIER:
            return self._element("msub", self._text("mi", "λ"), *map(self._print, function.args))
        if isinstance(function, AppliedUndef):
            return self._print(sympy.Symbol(name_of(function)))
        return super()._print_Function(function)

    def _print_Pow(self, power: sympy.Pow) -> Any:
        base, exponent = power.args
        of_name = isinstance(base, sympy.Function) and not isinstance(base, (AppliedUndef, sympy.Abs, sympy.exp))
        if not (of_name and exponent.is_Integer and exponent > 1):
            return super()._print_Pow(power)
        written = self._print(base)  # sin^2(x), not sin(x)^2
        written.replaceChild(raised := self.dom.createElement("msup"), name := written.firstChild)
        raised.appendChild(name)
        raised.appendChild(self._print(exponent))
        return written

    def _print_Piecewise(self, cases: sympy.Piecewise) -> Any:
        rows = []
        for value, condition in cases.args:
            words = [self._text("mtext", "otherwise")]
            if condition != sympy.true:
                words = [self._text("mtext", "if\u2002"), self._print(condition)]
            rows.append(self._element("mtr", self._element("mtd", self._print(value)), self._element("mtd", *words)))
        table = self._element("mtable", *rows)
        table.setAttribute("class", "cases")
        return self._element("mrow", self._text("mo", "{"), table)

    def _element(self, tag: str, *children: Any) -> Any:
        made = self.dom.createElement(tag)
        for child in children:
            made.appendChild(child)
        return made

    def _text(self, tag: str, text: str) -> Any:
        return self._element(tag, self.dom.createTextNode(text))

    def _print_Symbol(self, symbol: sympy.Symbol, style: str = "plain") -> Any:
        rate = self.rates.get(symbol)
        if rate is not None:
            return self._dotted(rate)
        return super()._print_Symbol(sympy.Symbol(escape(symbol.name)), style)  # SymPy does not escape names

    def _dotted(self, rate: sympy.Derivative) -> Any:
        name, dotted, mark = self._print(rate.expr), self.dom.createElement("mover"), self.dom.createElement("mo")
        mark.appendChild(self.dom.createTextNode(_DOTS[int(rate.derivative_count)]))
        letter = name.firstChild if name.tagName == "msub" else name
        if letter is not name:
            name.replaceChild(dotted, letter)
        dotted.appendChild(letter)
        dotted.appendChild(mark)
        return dotted if letter is name else name


def mathml(expression: sympy.Basic) -> str:
    """Return the MathML of an expression, without the outer element `math`."""
    rates = {sympy.Dummy(name_of(rate)): rate for rate in sorted(expression.atoms(sympy.Derivative), key=name_of)}
    plain = expression.xreplace({rate: symbol for symbol, rate in rates.items()})
    text: str = _Printer(rates).doprint(plain)
    return _spaced(text)


def _spaced(text: str) -> str:
    """Return MathML with LaTeX's spaces: a minus sign, and a thin space between a factor and a function or fraction."""
    text = text.replace("<mo>&InvisibleTimes;</mo>", _TIMES).replace("<mo>-</mo>", "<mo>&#x2212;</mo>")
    text = text.replace("<mo><</mo>", "<mo>&lt;</mo>")
    text = re.sub(rf"{_TIMES}(?={_NAMED}|<mfrac>)", f"{_TIMES}{_THIN}", text)
    text = re.sub(rf"(</mo></mrow></mrow>|{_WORD}|{_RATE_OF_WORD}){_TIMES}(?!{_THIN})", rf"\1{_TIMES}{_THIN}", text)
    text = re.sub(rf"{_TIMES}(?!{_THIN})(?=(?:<msup>)?<mover>{_WORD})", f"{_TIMES}{_THIN}", text)
    return re.sub(rf"(<mi>[^<]*?){_HASH}", r"\1", text)


def label(symbol: sympy.Basic) -> str:
    """Return the formula of a name or a rate."""
    return f"<math>{mathml(symbol)}</math>"


def in_words(name: str) -> str:
    """Return the formula of a symbol; a name of several words, such as contact_force, stays as it is."""
    first, *others = name.split("_")
    if others and len(first) >= _WORD_LENGTH and mathml(sympy.Symbol(first)) == f"<mi>{first}</mi>":  # no Greek letter
        return f"<math><mtext>{escape(name)}</mtext></math>"
    return label(sympy.Symbol(name))


def formulas(equations: Equations) -> Iterator[str]:
    """Yield formulas: the equations, then the terms in them."""
    yield from _form(bool(equations.A.rows))
    column = _matrix(sympy.Matrix(equations.x))
    yield f"<math><mrow><mi>x</mi><mo>=</mo>{column}</mrow></math>"
    names = {"M": "<mi>M</mi>", "bias": "<mi>h</mi>", "A": "<mi>A</mi>", "b": "<mi>b</mi>", "gamma": "<mi>γ</mi>"}
    for name, part in equations.parts.items():
        written = _matrix(part)
        if len(str(part)) > _TALL:
            written = f"<mtext>too long to read here: eigenmotion explain --latex shows it ({name})</mtext>"
        yield f"<math><mrow>{names[name]}<mo>=</mo>{written}</mrow></math>"


def _matrix(part: sympy.MatrixBase) -> str:
    rows = "".join(
        "<mtr>" + "".join(f"<mtd>{mathml(entry)}</mtd>" for entry in part.row(i)) + "</mtr>" for i in range(part.rows)
    )
    kind = "column" if part.cols == 1 else "matrix"
    return f"<mtable class='{kind}'>{rows}</mtable>"


def _form(constrained: bool) -> Iterator[str]:
    dot, dots = (f"<mover><mi>x</mi><mo>{_DOTS[k]}</mo></mover>" for k in (1, 2))
    push = "<mo>+</mo><msup><mi>A</mi><mi>T</mi></msup><mi>λ</mi>" if constrained else ""
    yield f"<math><mrow><mi>M</mi>{dots}{push}<mo>=</mo><mi>h</mi></mrow></math>"
    if constrained:
        yield f"<math><mrow><mi>A</mi>{dot}<mo>+</mo><mi>b</mi><mo>=</mo><mn>0</mn></mrow></math>"
        yield f"<math><mrow><mi>A</mi>{dots}<mo>+</mo><mi>γ</mi><mo>=</mo><mn>0</mn></mrow></math>"
