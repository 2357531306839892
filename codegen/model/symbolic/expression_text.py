"""Printers of a model's expressions: LaTeX and Python."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Mapping

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.vector import vlatex
from sympy.printing.str import StrPrinter

from ..normalise import name_of, t

_PREAMBLE = ("from sympy import *", "", f"{t.name} = {sympy.srepr(t)}")


def latex(expression: sympy.Basic) -> str:
    """Return LaTeX with dots for time derivatives."""
    return str(vlatex(expression))


def as_python(parts: Mapping[str, sympy.MatrixBase]) -> str:
    """Return Python source that defines the symbols of matrices, sorted by name, then each matrix by its name."""
    parts = {name: part.applyfunc(_without_tables) for name, part in parts.items()}
    atoms = {atom for part in parts.values() for atom in part.atoms(sympy.Symbol, AppliedUndef)} - {t}
    symbols = sorted(atoms, key=lambda atom: (isinstance(atom, AppliedUndef), name_of(atom)))
    names = _identifiers(symbols, parts)
    printer = _Python(names)
    declared = [f"{names[symbol]} = {sympy.srepr(symbol)}" for symbol in symbols]
    made = [
        f"{name} = Matrix({part.rows}, {part.cols}, {printer.doprint(part.flat())})" for name, part in parts.items()
    ]
    return "\n".join([*_PREAMBLE, *declared, "", *made])


def _without_tables(expression: sympy.Expr) -> sympy.Expr:
    """Replace calls of tables by calls of undefined functions, which need no numbers in the Python source."""
    return expression.replace(lambda part: hasattr(part, "as_undefined"), lambda part: part.as_undefined())


def _identifiers(symbols: Iterable[sympy.Basic], taken: Iterable[str]) -> dict[sympy.Basic, str]:
    """Return an identifier for each symbol: the user's name, changed where Python or SymPy already uses it."""
    known, identifiers = {*taken, t.name, *keyword.kwlist, *dir(sympy)}, {}
    for symbol in symbols:
        name = re.sub(r"\W", "_", name_of(symbol))
        name = name if name.isidentifier() else f"_{name}"
        while name in known:
            name += "_"
        known.add(name)
        identifiers[symbol] = name
    return identifiers


class _Python(StrPrinter):  # type: ignore[misc]
    """SymPy's printer, with the declared names of symbols and functions."""

    def __init__(self, names: Mapping[sympy.Basic, str]) -> None:
        super().__init__()
        self.names = names

    def _print_Symbol(self, symbol: sympy.Symbol) -> str:
        return self.names.get(symbol, t.name)

    def _print_Function(self, function: sympy.Function) -> str:
        return self.names.get(function) or str(super()._print_Function(function))

    def _print_Rational(self, number: sympy.Rational) -> str:
        return f"Rational({number.p}, {number.q})"

    def _print_Float(self, number: sympy.Float) -> str:
        return repr(float(number))
