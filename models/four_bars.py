"""Chain of n four-bar linkages: parallelograms of equal bars, side by side, that share their cranks.

::

    o     o     o       ...     fixed pins, l apart
    |q1   |q2   |q3             cranks, of length l like the couplers      | g
    |     |     |                                                          v
    o-----o-----o----- ...      couplers

Coordinates: q1 ... q_(n+1) [rad], directions of the cranks; p1 ... p_n [rad], those of the couplers. Bars: slender,
of mass m.
Holonomic constraints: two rows for each loop. It hangs and swings. The position with all bars in one line is singular,
since two motions are possible from there. A start with more speed, such as that of the benchmark (upright, 1 m/s at the
pins), passes through it, and at looser tolerances the run continues.

Source: the benchmark "N four-bar mechanism" of the IFToMM Technical Committee for Multibody Dynamics
(M. Gonzalez, D. Dopico, U. Lugris and J. Cuadrado, A benchmarking system for MBS simulation software, Multibody System
Dynamics 16, 2006).
Oracle: the cranks remain parallel; the energy of this motion with one coordinate is known.
"""

from sympy import Expr, Matrix, Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

m, l = symbols("m l", positive=True)
g = symbols("g", real=True)


def bar(angle: Expr) -> Matrix:
    """Return the vector along a bar."""
    return l * Matrix([cos(angle), sin(angle)])


def kinetic_energy(foot: Matrix, angle: Expr) -> Expr:
    """Return the kinetic energy of a slender bar that begins at `foot`."""
    velocity = (foot + bar(angle) / 2).diff(t)
    return Rational(1, 2) * m * (velocity.dot(velocity) + l**2 / 12 * angle.diff() ** 2)


def model(n: int = 2) -> Model:
    """Return the chain of n linkages with n + 1 cranks."""
    cranks, couplers = dynamicsymbols(f"q1:{n + 2}"), dynamicsymbols(f"p1:{n + 1}")
    pins = [Matrix([k * l, 0]) for k in range(n + 1)]
    tips = [pin + bar(q) for pin, q in zip(pins, cranks, strict=True)]
    heights = [tip[1] / 2 for tip in tips] + [(tip + bar(p) / 2)[1] for tip, p in zip(tips, couplers, strict=False)]
    loops = [tip + bar(p) - after for tip, p, after in zip(tips, couplers, tips[1:], strict=False)]
    return Model(
        name=f"four_bars_{n}",
        coordinates=[*cranks, *couplers],
        kinetic_energy=sum(kinetic_energy(pin, q) for pin, q in zip(pins, cranks, strict=True))
        + sum(kinetic_energy(tip, p) for tip, p in zip(tips, couplers, strict=False)),
        potential_energy=m * g * sum(heights),
        holonomic_constraints=[entry for loop in loops for entry in loop],
        parameters={m: 1.0, l: 1.0, g: 9.81},
        initial=dict.fromkeys(cranks, 1 - pi / 2),
        drawing=[
            *(draw.Ground(pin) for pin in pins),
            *(draw.Line(pin, tip) for pin, tip in zip(pins, tips, strict=True)),
            *(draw.Line(tip, tip + bar(p)) for tip, p in zip(tips, couplers, strict=False)),
            *(draw.Disk(tip, l / 30) for tip in tips),
            draw.Trace(tips[-1]),
        ],
    )
