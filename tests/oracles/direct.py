"""The terms of the equations of motion by SymPy's own derivatives of the energies, nothing recognised or left out."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import sympy

from eigenmotion import Model, t


class Direct:
    """M, G, T0, A, b and T + V of a model, as functions of numbers."""

    def __init__(self, model: Model) -> None:
        self.model = model
        x, v = list(model.coordinates), list(model.rates)
        held = sympy.symbols(f"held_:{len(v)}", real=True)
        replaced = dict(zip(v, held, strict=True))
        T = self._in_rates(model.kinetic_energy).xreplace(replaced)
        still = dict.fromkeys(held, 0)
        rows = [self._in_rates(row).xreplace(replaced) for row in model.nonholonomic_constraints]
        self.terms = {
            "M": [T.diff(i, j) for i in held for j in held],
            "G": [T.diff(i).subs(still) for i in held],
            "T0": [T.subs(still)],
            "A": [phi.diff(c) for phi in model.holonomic_constraints for c in x]
            + [r.diff(i) for r in rows for i in held],
            "b": [self._explicit(phi) for phi in model.holonomic_constraints] + [r.subs(still) for r in rows],
            "energy": [T + model.potential_energy],
        }
        arguments = [*x, *(symbol for symbol, _ in model.parameters), t, *held]
        self._functions = {
            name: sympy.lambdify(arguments, [sympy.sympify(entry).doit() for entry in entries], cse=True)
            for name, entries in self.terms.items()
        }

    def __call__(self, name: str, point: Sequence[float]) -> np.ndarray:
        """Return the entries of one term at x, parameters, t, v."""
        return np.array(self._functions[name](*point), dtype=float)

    def _in_rates(self, expression: sympy.Expr) -> sympy.Expr:
        return expression.subs(dict(self.model.quasi_velocities)).doit()

    def _explicit(self, phi: sympy.Expr) -> sympy.Expr:
        """The derivative with respect to the time that is written out."""
        frozen = {x: sympy.Dummy(real=True) for x in self.model.coordinates}
        return phi.xreplace(frozen).diff(t).xreplace({dummy: x for x, dummy in frozen.items()})
