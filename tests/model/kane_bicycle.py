"""SymPy's bicycle, with the parameters of the benchmark."""

from __future__ import annotations

from sympy import Symbol, acos, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, dot, dynamicsymbols, inertia

import eigenmotion as em

from .kane import Example


def bicycle() -> Example:
    """SymPy's bicycle, the benchmark of Meijaard, Papadopoulos, Ruina and Schwab (2007), doi 10.1098/rspa.2007.1857.

    Wheels turn by speeds that have no coordinates, and the rear one rolls by the velocity of its centre.
    """
    q1, q2, q4, q5, *u = dynamicsymbols("q1 q2 q4 q5 u1:7")
    u1, u2, u3, u4, u5, u6 = u
    names = ("rF rR tilt fork_offset fork_length frame_length fork1 fork3 frame1 frame3 IR11 IR22 IF11 IF22 IB11 IB22 "
             "IB33 IB31 IH11 IH22 IH33 IH31 g mB mH mF mR")  # fmt: skip
    p = dict(zip(names.split(), symbols(names), strict=True))
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q1, N.z])
    R = Y.orientnew("R", "Axis", [q2, Y.x])
    B = R.orientnew("B", "Axis", [q4 + p["tilt"], R.y])
    level_B = B.orientnew("level_B", "Axis", [-p["tilt"], B.y])
    H = B.orientnew("H", "Axis", [q5, B.x])
    level_H = H.orientnew("level_H", "Axis", [-p["tilt"], H.y])
    rear, front = ReferenceFrame("rear"), ReferenceFrame("front")
    contact = Point("rear_contact")
    rear_centre = contact.locatenew("rear_centre", p["rR"] * R.z)
    steer = rear_centre.locatenew("steer", p["frame_length"] * B.z)
    B_centre = rear_centre.locatenew("B_centre", -p["frame1"] * B.x + p["frame3"] * B.z)
    H_centre = steer.locatenew("H_centre", -p["fork1"] * H.x + p["fork3"] * H.z)
    front_centre = steer.locatenew("front_centre", p["fork_length"] * H.x + p["fork_offset"] * H.z)
    lowest = (dot(H.y, Y.z) * H.y - Y.z).normalize()
    front_contact = front_centre.locatenew("front_contact", p["rF"] * lowest)
    for frame, base, rate in ((Y, N, u1 * Y.z), (R, Y, u2 * R.x), (rear, B, u3 * B.y), (B, R, u4 * B.y),
                              (H, B, u5 * H.x), (front, H, u6 * H.y)):  # fmt: skip
        frame.set_ang_vel(base, rate)
    contact.set_vel(N, 0)
    for point, base, frame in ((rear_centre, contact, rear), (steer, rear_centre, B), (B_centre, rear_centre, B),
                               (H_centre, steer, H), (front_centre, steer, H),
                               (front_contact, front_centre, front)):  # fmt: skip
        point.v2pt_theory(base, N, frame)
    bodies = [
        _body("B", B_centre, B, p["mB"], level_B, p["IB11"], p["IB22"], p["IB33"], 0, 0, p["IB31"]),
        _body("H", H_centre, H, p["mH"], level_H, p["IH11"], p["IH22"], p["IH33"], 0, 0, p["IH31"]),
        _body("R", rear_centre, rear, p["mR"], B, p["IR11"], p["IR22"], p["IR11"]),
        _body("F", front_centre, front, p["mF"], H, p["IF11"], p["IF22"], p["IF11"]),
    ]
    kinematic = [q.diff() - speed for q, speed in ((q1, u1), (q2, u2), (q4, u4), (q5, u5))]
    rolls = [front_contact.vel(N) & axis for axis in Y]
    height = [front_contact.pos_from(contact) & Y.z]
    loads = [(body.masscenter, -body.mass * p["g"] * Y.z) for body in bodies]
    kane = KanesMethod(N, q_ind=[q1, q2, q5], q_dependent=[q4], configuration_constraints=height, u_ind=[u2, u3, u5],
                       u_dependent=[u1, u4, u6], velocity_constraints=rolls, kd_eqs=kinematic)  # fmt: skip
    kane.kanes_equations(bodies, loads)
    values = {p[name]: value for name, value in benchmark().items()}
    model = em.from_mechanics(bodies, name="bicycle", frame=N, fixed_point=contact, loads=loads,
                              coordinates=[q1, q2, q4, q5], speeds=u, kinematic_equations=kinematic,
                              holonomic_constraints=height, velocity_constraints=rolls, parameters=values)  # fmt: skip
    return Example(model, kane)


def _body(
    name: str, centre: Point, frame: ReferenceFrame, mass: Symbol, axes: ReferenceFrame, *moments: object
) -> RigidBody:
    """Return a body whose moments of inertia are about its centre, along these axes."""
    return RigidBody(name, centre, frame, mass, (inertia(axes, *moments), centre))


def benchmark() -> dict[str, float]:
    """Return the parameters of the benchmark bicycle, in the lengths along and across its steering axis."""
    tilt = (pi / 2 - pi / 10).evalf()
    rR, rF, base, trail = 0.3, 0.35, 1.02, 0.08
    c, s = cos(tilt), sin(tilt)
    offset = -(trail * s - rF * c)
    a, b = 0.7 - rF, base - 0.9
    far = sqrt(a**2 + b**2)
    fork_length = base * c - (rF - rR) * s
    values = {
        "rF": rF, "rR": rR, "tilt": tilt, "fork_offset": offset, "fork_length": fork_length,
        "frame_length": base * s - (offset - (rF - rR) * c),
        "fork1": far * cos((pi / 2 - tilt) - acos(a / far)) - fork_length,
        "fork3": offset + far * sin(pi / 2 - tilt - acos(a / far)),
        "frame1": 0.3 / s + (0.9 - rR - 0.3 / s * c) * c, "frame3": (0.9 - rR - 0.3 / s * c) * s,
        "IR11": 0.0603, "IR22": 0.12, "IF11": 0.1405, "IF22": 0.28, "IB11": 9.2, "IB22": 11, "IB33": 2.8, "IB31": -2.4,
        "IH11": 0.05892, "IH22": 0.06, "IH33": 0.00708, "IH31": 0.00756, "g": 9.81, "mB": 85, "mH": 4, "mF": 3, "mR": 2,
    }  # fmt: skip
    return {name: float(value) for name, value in values.items()}
