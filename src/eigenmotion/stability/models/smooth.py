"""Mechanisms without contacts; each has a parameter that drives it to its limits."""

from functools import cache
from typing import Any

from sympy import Abs, Expr, Integer, Matrix, Max, Rational, cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from ...codegen.model import Model, t
from ...models import slider_crank

_HALF = Rational(1, 2)


@cache
def elastic_link() -> Model:
    """Return an arm and an elastic, damped link on a turntable, with T2, T1 and T0; M is coupled and varies.

    ::

              phi   ,O m_2
               .  ,z  L + q: stiffness k, damper d
              : ,z
        m_1  O'  - - -
            /
         l / theta      turntable, at the rate Omega
          o ------      torsional springs K_1, K_2 at the joints

    theta, phi [rad] from the table's axis; q [m] elongation.
    """
    theta, phi, q = dynamicsymbols("theta phi q")
    m_1, m_2, l, L = symbols("m_1 m_2 l L", positive=True)
    k, d, K_1, K_2, Omega = symbols("k d K_1 K_2 Omega", nonnegative=True)
    elbow = l * Matrix([cos(theta), sin(theta)])
    tip = elbow + (L + q) * Matrix([cos(phi), sin(phi)])
    T = _HALF * (m_1 * _square(elbow, Omega) + m_2 * _square(tip, Omega))
    return Model(
        name="elastic_link",
        coordinates=[theta, phi, q],
        kinetic_energy=T,
        potential_energy=_HALF * (K_1 * theta**2 + K_2 * (phi - theta) ** 2 + k * q**2),
        forces={q: -d * q.diff()},
        parameters={m_1: 1.0, m_2: 1.0, l: 1.0, L: 1.0, k: 1.0, d: 0.0, K_1: 20.0, K_2: 10.0, Omega: 0.7},
        initial={theta: 0.4, phi: 1.3, theta.diff(): 0.5, phi.diff(): -0.8},
    )


def _square(position: Matrix, Omega: Expr) -> Expr:
    """Return the square of the velocity of a point given in axes that rotate at Omega."""
    x, y = position
    velocity = position.diff(t) + Omega * Matrix([-y, x])
    return velocity.dot(velocity)


@cache
def triple_veering() -> Model:
    """Return three coupled masses; at x = 0 all eigenvalues of M coincide if `gap` is 0."""
    coordinates = dynamicsymbols("x y z")
    gap = symbols("gap", real=True)
    stiffness = symbols("k_1:4", positive=True)
    offset = Matrix([[1, _HALF, Rational(1, 4)], [_HALF, -1, Rational(1, 4)], [Rational(1, 4), Rational(1, 4), -_HALF]])
    M = 2 * Matrix.eye(3) + coordinates[0] / 2 * offset + gap * Matrix([[0, 2, 1], [2, 0, -1], [1, -1, 0]]) / 2
    return _springs("triple_veering", coordinates, M, stiffness, {gap: 0.1}, (4.0, 1.0, 2.0))


@cache
def parallel_eigenvalues() -> Model:
    """Return two masses with eigenvalues 2 + x/2 +- gap, which vary at a constant distance."""
    coordinates = dynamicsymbols("x y")
    gap = symbols("gap", real=True)
    both = 2 + coordinates[0] / 2
    M = Matrix([[both, gap], [gap, both]])
    return _springs("parallel_eigenvalues", coordinates, M, symbols("k_1:3", positive=True), {gap: 0.1}, (4.0, 1.0))


def _springs(
    name: str, x: list[Expr], M: Matrix, stiffness: tuple[Expr, ...], more: dict[Expr, float], values: tuple[float, ...]
) -> Model:
    v = Matrix(x).diff(t)
    return Model(
        name=name,
        coordinates=x,
        kinetic_energy=_HALF * (v.T * M * v)[0],
        potential_energy=sum((_HALF * k * q**2 for k, q in zip(stiffness, x, strict=True)), Integer(0)),
        parameters=more | dict(zip(stiffness, values, strict=True)),
        initial=dict(zip(x, (1.0, 0.5, -0.4), strict=False)) | {x[-1].diff(): 0.3},
    )


@cache
def polar_on_cart() -> Model:
    """Return a particle without forces, in polar coordinates about a point of a cart; singular at r = 0."""
    X, theta, r = dynamicsymbols("X theta r")
    m, m_c = symbols("m m_c", positive=True)
    velocity = (Matrix([X, 0]) + r * Matrix([cos(theta), sin(theta)])).diff(t)
    return Model(
        name="polar_on_cart",
        coordinates=[X, theta, r],
        kinetic_energy=_HALF * (m_c * X.diff() ** 2 + m * velocity.dot(velocity)),
        parameters={m: 1.0, m_c: 2.0},
        initial={r: 1.0},
    )


@cache
def blade_and_slave(rows: int = 2) -> Model:
    """Return a sleigh with a blade, and a slide z that follows its direction; the rows differ by `part`.

    ::

        row 0:  sin(theta) xdot - cos(theta) ydot = 0
        row 1:  row 0 + part (zdot - a thetadot) = 0

    For any part > 0 the motion is the same; for part = 0 the rows are dependent and z is free.
    """
    x, y, theta, z = dynamicsymbols("x y theta z")
    (m, J, m_z, b, a), part = symbols("m J m_z b a", positive=True), symbols("part", nonnegative=True)
    blade = sin(theta) * x.diff() - cos(theta) * y.diff()
    centre = (Matrix([x, y]) + b * Matrix([cos(theta), sin(theta)])).diff(t)
    carried = (Matrix([x, y]) + z * Matrix([cos(theta), sin(theta)])).diff(t)
    slave = blade + part * (z.diff() - a * theta.diff())
    T = m * centre.dot(centre) + J * theta.diff() ** 2 + m_z * carried.dot(carried)
    return Model(
        name=f"blade_and_slave_{rows}",
        coordinates=[x, y, theta, z],
        kinetic_energy=_HALF * T,
        nonholonomic_constraints=[blade, slave][:rows],
        parameters={m: 2.0, J: 1.0, m_z: 1.0, b: 0.3, a: 0.2, part: 1.0},
        initial={z: 0.5, x.diff(): 1.0, theta.diff(): 1.5, z.diff(): 0.3},
    )


@cache
def folding_crank() -> Model:
    """Return the slider-crank with rod and crank of equal length, phi = theta, in one coordinate."""
    full, (theta, phi, x) = slider_crank.model, slider_crank.model.coordinates
    folded = {phi: theta, x: 2 * slider_crank.r * cos(theta), slider_crank.l: slider_crank.r}
    return Model(
        name="folding_crank",
        coordinates=[theta],
        kinetic_energy=full.kinetic_energy.subs(folded).doit(),
        potential_energy=full.potential_energy.subs(folded),
        parameters={symbol: value for symbol, value in full.parameters if symbol != slider_crank.l},
    )


@cache
def bent_oscillators() -> Model:
    """Return two free oscillators u = x + c z^2 / 2 and z, in coordinates x, z in which M is coupled and varies."""
    z, c = dynamicsymbols("z"), symbols("c", positive=True)
    return _oscillators("bent_oscillators", c * z**2 / 2, Integer(0), {c: 0.8}, z_0=0.0)


@cache
def rooted_oscillators(wide: bool = True) -> Model:
    """Return the same with z sqrt(z^2 + w^2) / 2 in place of z^2 / 2, or z |z| / 2 for w = 0."""
    z = dynamicsymbols("z")
    c, w = symbols("c w", positive=True)
    if not wide:
        return _oscillators("folded_oscillators", c * z * Abs(z) / 2, Integer(0), {c: 0.8})
    return _oscillators("rooted_oscillators", c * z * sqrt(z**2 + w**2) / 2, Integer(0), {c: 0.8, w: 1.0})


@cache
def kinked_oscillators() -> Model:
    """Return the same with forces on u that have a kink (k) or a jump (f), and an acceleration as input (a)."""
    x, z, a = dynamicsymbols("x z a")
    m_1, c = symbols("m_1 c", positive=True)
    k, f = symbols("k f", nonnegative=True)
    bend = c * z**2 / 2
    u = x + bend
    V = m_1 * (k * Max(u, 0) ** 2 / 2 + f * Abs(u))
    values, forces = {c: 0.8, k: 0.0, f: 0.0}, {x: m_1 * a, z: m_1 * a * c * z}
    return _oscillators("kinked_oscillators", bend, V, values, forces=forces, inputs={a: 0.0})


def _oscillators(name: str, bend: Expr, V: Expr, more: dict[Expr, float], z_0: float = 0.1, **given: Any) -> Model:
    """Return free oscillators u = x + bend(z) and z with an additional potential V."""
    x, z = dynamicsymbols("x z")
    m_1, m_2, w_1, w_2 = symbols("m_1 m_2 w_1 w_2", positive=True)
    u = x + bend
    return Model(
        name=name,
        coordinates=[x, z],
        kinetic_energy=_HALF * (m_1 * u.diff(t) ** 2 + m_2 * z.diff() ** 2),
        potential_energy=_HALF * (m_1 * w_1**2 * u**2 + m_2 * w_2**2 * z**2) + V,
        parameters={m_1: 1.0, m_2: 3.0, w_1: 1.0, w_2: 1.4142135623730951} | more,
        initial={x: 0.5, z: z_0, z.diff(): 1.0},
        **given,
    )


@cache
def body_in_cardan_angles() -> Model:
    """Return a body with a fixed point, turned by psi about z, phi about x, theta about y; singular at phi = pi / 2."""
    psi, phi, theta = dynamicsymbols("psi phi theta")
    J = symbols("J_1:4", positive=True)
    weight = symbols("mgl", real=True)
    omega = (
        cos(theta) * phi.diff() - sin(theta) * cos(phi) * psi.diff(),
        sin(phi) * psi.diff() + theta.diff(),
        sin(theta) * phi.diff() + cos(theta) * cos(phi) * psi.diff(),
    )
    return Model(
        name="body_in_cardan_angles",
        coordinates=[psi, phi, theta],
        kinetic_energy=sum((_HALF * j * w**2 for j, w in zip(J, omega, strict=True)), Integer(0)),
        potential_energy=weight * cos(phi) * cos(theta),
        parameters=dict(zip(J, (0.05, 0.06, 0.02), strict=True)) | {weight: 0.3},
    )


@cache
def hung_pendulum() -> Model:
    """Return a pendulum in x, y [m] that hangs at (x_0, y_0)."""
    x_0, y_0 = symbols("x_0 y_0", real=True)
    return _pendulum("hung_pendulum", x_0, y_0, {x_0: 0.0, y_0: 0.0})


@cache
def cartesian_pendulum() -> Model:
    """Return a pendulum that hangs at the origin; its rod is a holonomic constraint."""
    return _pendulum("cartesian_pendulum", Integer(0), Integer(0), {})


def _pendulum(name: str, x_0: Expr, y_0: Expr, more: dict[Expr, float]) -> Model:
    x, y = dynamicsymbols("x y")
    m, l, g = symbols("m l g", positive=True)
    return Model(
        name=name,
        coordinates=[x, y],
        kinetic_energy=_HALF * m * (x.diff() ** 2 + y.diff() ** 2),
        potential_energy=m * g * (y - y_0),
        holonomic_constraints=[((x - x_0) ** 2 + (y - y_0) ** 2 - l**2) / (2 * l)],
        parameters={m: 1.0, l: 1.0, g: 1.0} | more,
        initial={x: sin(1).evalf(20), y: -cos(1).evalf(20)},
    )
