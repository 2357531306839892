"""Spatial arm of n rigid links, with revolute joints about alternating axes, swinging under gravity.

::

      z
      |        q_2 (y) ___ link 2 ___ o q_3 (z)
      |   link 1     /                 \\  link 3
      o------------o                    \\
     /| q_1 (z)                          o ...           | g, along -z
    y  x: along each link                                v

Coordinates: q_1 ... q_n [rad]; odd joints turn about the z axis, even joints about the y axis of the previous link.
Links: cylinders of mass m_k, length l_k and common radius rho.

Oracles: Lagrange equations from positions in the fixed frame; high-precision integration.
"""

from sympy import Integer, Matrix, Rational, eye, rot_ccw_axis2, rot_ccw_axis3, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

ALONG, AXIS_Y, AXIS_Z = Matrix([1, 0, 0]), Matrix([0, 1, 0]), Matrix([0, 0, 1])


def model(n: int = 3) -> Model:
    """Return the arm of n links."""
    joints = dynamicsymbols(f"q_1:{n + 1}")
    masses, lengths = symbols(f"m_1:{n + 1}", positive=True), symbols(f"l_1:{n + 1}", positive=True)
    rho = symbols("rho", nonnegative=True)
    g = symbols("g", real=True)

    # of each joint, in the axes of its link: velocity, angular velocity, upward direction; and its height
    velocity, omega, up, height = Matrix([0, 0, 0]), Matrix([0, 0, 0]), AXIS_Z, Integer(0)
    T = V = Integer(0)
    # in fixed axes: the axes of the link, and its end
    axes, end = eye(3), Matrix([0, 0, 0])
    drawing: list[object] = [draw.Ground((0, 0, 0))]
    for k, (q, m, l) in enumerate(zip(joints, masses, lengths, strict=True)):
        axis, R = (AXIS_Y, rot_ccw_axis2(q)) if k % 2 else (AXIS_Z, rot_ccw_axis3(q))
        velocity, omega, up = R.T * velocity, R.T * omega + q.diff() * axis, R.T * up
        centre = velocity + omega.cross(l / 2 * ALONG)
        axial, transverse = m * rho**2 / 2, m * (l**2 / 12 + rho**2 / 4)
        spin = axial * omega[0] ** 2 + transverse * (omega[1] ** 2 + omega[2] ** 2)
        T += Rational(1, 2) * (m * centre.dot(centre) + spin)
        V += m * g * (height + l / 2 * up[0])
        velocity, height = velocity + omega.cross(l * ALONG), height + l * up[0]
        axes, joint = axes * R, end
        end = joint + l * axes * ALONG
        drawing += [draw.Line(joint, end), draw.Disk(joint, rho)]

    return Model(
        name=f"spatial_arm_{n}",
        coordinates=joints,
        kinetic_energy=T,
        potential_energy=V,
        parameters=dict.fromkeys(masses, 1.0) | dict.fromkeys(lengths, 0.6) | {rho: 0.05, g: 9.81},
        initial={q: Rational(1, 2) + Rational(k, 5) for k, q in enumerate(joints)} | {joints[0].diff(): 1.0},
        drawing=[*drawing, draw.Trace(end)],
    )
