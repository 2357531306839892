"""Ball that rolls without slipping on an inclined plane: two eigenvalues of M are always equal.

::

         z
          \\   .--.
           \\ /    \\  R              x: down the slope
            |   o  |               y: across it
             \\    /
       ` - .  `--'                 | g
             ` - .                 v
       alpha       ` - .  x

Coordinates: x, y [m] of the centre; p_1, p_2, p_3, Rodrigues parameters of the attitude, axis times tan(angle / 2)
(infinite at a rotation by pi). The block of M for p has the eigenvalues 4 J / (1 + p^2) twice, 4 J / (1 + p^2)^2 once.
Quasi-velocities: vx, vy [m/s] and omega_x, omega_y, omega_z [rad/s] in the axes of the plane.
Nonholonomic constraints: no slip, vx = R omega_y, vy = -R omega_x.

Oracle: closed form, constant acceleration 5/7 g sin(alpha) down the slope and a constant spin omega_z.
"""

from sympy import Matrix, Rational, cos, eye, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y = dynamicsymbols("x y")
p = Matrix(dynamicsymbols("p_1:4"))
vx, vy = dynamicsymbols("vx vy")
omega = Matrix(dynamicsymbols("omega_x omega_y omega_z"))
m, R = symbols("m R", positive=True)
g, alpha = symbols("g alpha", real=True)

p_rate = p.diff(t)
turning = 2 * (p_rate + p.cross(p_rate)) / (1 + p.dot(p))
J = Rational(2, 5) * m * R**2

# in fixed axes, z upwards: the axes of the plane, and those of the ball
down, side, normal = Matrix([cos(alpha), 0, -sin(alpha)]), Matrix([0, 1, 0]), Matrix([sin(alpha), 0, cos(alpha)])
plane = Matrix.hstack(down, side, normal)
turned = [plane * (e + 2 * (p.cross(e) + p.cross(p.cross(e))) / (1 + p.dot(p))) for e in map(eye(3).col, range(3))]
touching = x * down + y * side
centre = touching + R * normal

speed_down, speed_across, spin, radius = 0.3, 0.5, 0.4, 0.5

model = Model(
    name="sphere",
    coordinates=[x, y, *p],
    quasi_velocities={vx: x.diff(), vy: y.diff(), **dict(zip(omega, turning, strict=True))},
    kinetic_energy=Rational(1, 2) * (m * (vx**2 + vy**2) + J * omega.dot(omega)),
    potential_energy=-m * g * sin(alpha) * x,
    nonholonomic_constraints=[vx - R * omega[1], vy + R * omega[0]],
    parameters={m: 1.0, R: radius, g: 9.81, alpha: pi / 36},
    initial={
        p[0]: 0.1,
        p[1]: -0.2,
        p[2]: 0.3,
        vx: speed_down,
        vy: speed_across,
        omega[0]: -speed_across / radius,
        omega[1]: speed_down / radius,
        omega[2]: spin,
    },
    drawing=[
        draw.Trace(touching),
        draw.Ground(*(R * (down * i + side * j) for i, j in ((-4, -4), (24, -4), (24, 12), (-4, 12)))),
        draw.Disk(centre, R),
        *(draw.Disk(centre, R, axis=axis) for axis in turned),
    ],
)
