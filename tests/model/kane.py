"""SymPy's own documented examples of `sympy.physics.mechanics`, with Kane's equations that SymPy forms of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from sympy import lambdify, symbols
from sympy.physics.mechanics import (
    Force,
    KanesMethod,
    LinearDamper,
    LinearPathway,
    LinearSpring,
    Particle,
    PinJoint,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    System,
    TorqueActuator,
    cross,
    dot,
    dynamicsymbols,
    inertia,
)
from sympy.physics.mechanics.models import multi_mass_spring_damper, n_link_pendulum_on_cart

import eigenmotion as em
from eigenmotion import Model, t


@dataclass(frozen=True)
class Example:
    """A model, and Kane's equations of the same bodies."""

    model: Model
    kane: KanesMethod

    def speed_rates(self, q: np.ndarray, v: np.ndarray, inputs: Iterable[float] = ()) -> np.ndarray:
        """Return u' by Kane's equations, at coordinates and rates of the model."""
        kane, arguments = self.kane, self._arguments()
        u = lambdify(arguments, [kane.u.xreplace(dict(self.model.quasi_velocities))])(q, v, *self._numbers(inputs))
        function = lambdify(
            [list(kane.q), list(kane.u), *arguments[2:]], [kane.mass_matrix_full, kane.forcing_full], cse=True
        )
        at = [list(self.model.coordinates).index(x) for x in kane.q]
        M, f = function(q[at], np.ravel(u), *self._numbers(inputs))
        return np.linalg.solve(M, f).ravel()[len(at) :]

    def found(self, q: np.ndarray, v: np.ndarray, a: np.ndarray, inputs: Iterable[float] = ()) -> np.ndarray:
        """Return u' that follows from accelerations of the model."""
        second = [x.diff(t, 2) for x in self.model.coordinates]
        rates = [self.model.in_rates(u).diff(t) for u in self.kane.u]
        return np.array(lambdify([second, *self._arguments()], rates)(a, q, v, *self._numbers(inputs)), dtype=float)

    def _arguments(self) -> list[list[sympy.Expr]]:
        model = self.model
        return [
            list(model.coordinates),
            list(model.rates),
            [p for p, _ in model.parameters],
            [u for u, _ in model.inputs],
        ]

    def _numbers(self, inputs: Iterable[float]) -> tuple[list[float], list[float]]:
        return [value for _, value in self.model.parameters], list(inputs)


def of_kane(kane: KanesMethod, **given: Any) -> Example:
    """Return the model of the bodies and loads that SymPy's function made Kane's equations of."""
    kinematic = [rate - expression for rate, expression in kane.kindiffdict().items()]
    model = em.from_mechanics(kane.bodies, loads=kane.loads, coordinates=kane.q, speeds=kane.u,
                              kinematic_equations=kinematic, **given)  # fmt: skip
    return Example(model, kane)


def pendulum_on_cart() -> Example:
    """Two links on a cart, with a force on it and torques in the joints (`sympy.physics.mechanics.models`)."""
    kane = n_link_pendulum_on_cart(2, cart_force=True, joint_torques=True)
    names = symbols("g l:2 m:3")
    return of_kane(kane, name="links", frame=_frame_of(kane), inputs=dict.fromkeys(dynamicsymbols("F T1:3"), 0.0),
                   parameters={p: 1.0 + 0.1 * k for k, p in enumerate(names)})  # fmt: skip


def masses_and_springs() -> Example:
    """Three masses on springs and dampers, with weights and forces (`sympy.physics.mechanics.models`)."""
    kane = multi_mass_spring_damper(3, apply_gravity=True, apply_external_forces=True)
    names = symbols("g m:3 k:3 c:3")
    return of_kane(kane, name="masses", frame=_frame_of(kane), inputs=dict.fromkeys(dynamicsymbols("f:3"), 0.0),
                   parameters={p: 1.0 + 0.1 * k for k, p in enumerate(names)})  # fmt: skip


def _frame_of(kane: KanesMethod) -> ReferenceFrame:
    """Return the fixed frame, along which the first load of SymPy's models acts."""
    _, vector = kane.loads[0]
    return vector.args[0][1]


def rolling_disc() -> Example:
    """SymPy's rolling disc: speeds along the disc's axes, of which no coordinates are the integrals.

    The velocity of its centre takes for granted that it rolls.
    """
    q1, q2, q3, u1, u2, u3 = dynamicsymbols("q1:4 u1:4")
    r, m, g = symbols("r m g")
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q1, N.z])
    L = Y.orientnew("L", "Axis", [q2, Y.x])
    R = L.orientnew("R", "Axis", [q3, L.y])
    by_rates = R.ang_vel_in(N)
    R.set_ang_vel(N, u1 * L.x + u2 * L.y + u3 * L.z)
    contact = Point("C")
    contact.set_vel(N, 0)
    centre = contact.locatenew("Dmc", r * L.z)
    centre.v2pt_theory(contact, N, R)
    disc = RigidBody("disc", centre, R, m, (inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4), centre))
    kinematic = [dot(R.ang_vel_in(N) - by_rates, axis) for axis in L]
    loads = [(centre, -m * g * Y.z)]
    kane = KanesMethod(N, q_ind=[q1, q2, q3], u_ind=[u1, u2, u3], kd_eqs=kinematic)
    kane.kanes_equations([disc], loads)
    model = em.from_mechanics([disc], name="disc", frame=N, fixed_point=contact, loads=loads, coordinates=[q1, q2, q3],
                              speeds=[u1, u2, u3], kinematic_equations=kinematic,
                              parameters={r: 0.5, m: 2.0, g: 9.81})  # fmt: skip
    return Example(model, kane)


def disc_on_coordinates() -> Example:
    """SymPy's disc with the place of contact among its coordinates, rows of rolling and body-fixed speeds."""
    q1, q2, q3, q4, q5, *u = dynamicsymbols("q1:6 u1:6")
    g, r, m = symbols("g r m")
    ground, disc, between = RigidBody("ground"), RigidBody("disk", mass=m), ReferenceFrame("between")
    disc.inertia = (m * r**2 / 4 * inertia(disc.frame, 1, 2, 1), disc.masscenter)
    ground.masscenter.set_vel(ground.frame, 0)
    between.orient_body_fixed(ground.frame, (q1, q2, 0), "zxy")
    disc.frame.orient_axis(between, between.y, q3)
    by_rates = disc.frame.ang_vel_in(ground.frame)
    disc.frame.set_ang_vel(ground.frame, u[0] * disc.x + u[1] * disc.y + u[2] * disc.z)
    contact = ground.masscenter.locatenew("contact", q4 * ground.x + q5 * ground.y)
    contact.set_vel(ground.frame, u[3] * ground.x + u[4] * ground.y)
    disc.masscenter.set_pos(contact, r * between.z)
    disc.masscenter.set_vel(ground.frame, cross(disc.frame.ang_vel_in(ground.frame), disc.masscenter.pos_from(contact)))
    slip = contact.vel(ground.frame) + cross(disc.frame.ang_vel_in(between), contact.pos_from(disc.masscenter))
    system = System(ground.frame, ground.masscenter)
    system.add_bodies(disc)
    system.add_loads((disc.masscenter, -m * g * ground.z))
    system.add_coordinates(q1, q2, q3, q4, q5)
    system.add_speeds(*u, independent=[True, True, True, False, False])
    system.add_kdes(*(by_rates.dot(axis) - speed for axis, speed in zip(disc.frame, u[:3], strict=True)),
                    q4.diff() - u[3], q5.diff() - u[4])  # fmt: skip
    system.add_nonholonomic_constraints(slip.dot(ground.x), slip.dot(ground.y))
    return of_system(system, name="disk", parameters={g: 9.81, r: 0.26, m: 3.43})


def of_system(system: System, **given: Any) -> Example:
    """Return the model of a system, and Kane's equations by `System.form_eoms`."""
    system.form_eoms()
    return Example(em.from_mechanics(system, **given), system.eom_method)


def four_bar() -> Example:
    """SymPy's four-bar linkage: bodies, pin joints, and a loop that closes."""
    q1, q2, q3, u1, u2, u3 = dynamicsymbols("q1:4, u1:4")
    lengths, rho = symbols("l1:5"), symbols("rho")
    N = ReferenceFrame("N")
    links = [
        RigidBody(f"link{k}", frame=N if k == 1 else None, mass=rho * length) for k, length in enumerate(lengths, 1)
    ]
    for link, length in zip(links, lengths, strict=True):
        link.central_inertia = inertia(link.frame, 0, 0, rho * length**3 / 12)
    system = System.from_newtonian(links[0])
    for k, (parent, child, q, u) in enumerate(zip(links, links[1:], (q1, q2, q3), (u1, u2, u3), strict=False)):
        system.add_joints(PinJoint(f"J{k}", parent, child, coordinates=q, speeds=u, joint_axis=parent.z,
                                   parent_point=lengths[k] / 2 * parent.x,
                                   child_point=-lengths[k + 1] / 2 * child.x))  # fmt: skip
    ends = lengths[0] / 2 * links[0].x + lengths[3] / 2 * links[3].x
    loop = links[3].masscenter.pos_from(links[0].masscenter) + ends
    system.add_holonomic_constraints(loop.dot(links[0].x), loop.dot(links[0].y))
    system.q_ind, system.q_dep, system.u_ind, system.u_dep = [q1], [q2, q3], [u1], [u2, u3]
    values = dict(zip([*lengths, rho], (0.13, 0.24, 0.21, 0.34, 997.0), strict=True))
    return of_system(system, name="four_bar", parameters=values,
                     initial={q1: 2.1, q2: 0.6655470375077588, q3: 2.527408138024188})  # fmt: skip


def cart_pendulum() -> Example:
    """A pendulum on a cart by joints, with a weight, a spring, a damper and a torque (the docstring of `System`)."""
    q, theta, v, omega, F = dynamicsymbols("q theta v omega F")
    g, l, k, c, l0, mc, mb, kt = symbols("g l k c l0 mc mb kt", positive=True)
    rail, cart, bob = RigidBody("rail"), RigidBody("cart", mass=mc), Particle("bob", mass=mb)
    arm = ReferenceFrame("arm")
    system = System.from_newtonian(rail)
    system.add_joints(
        PrismaticJoint("slider", rail, cart, q, v, joint_axis=rail.x),
        PinJoint("pin", cart, bob, theta, omega, joint_axis=cart.z, child_interframe=arm, child_point=l * arm.y),
    )
    post = rail.masscenter.locatenew("post", -2 * rail.x + rail.y)
    post.set_vel(rail.frame, 0)
    path = LinearPathway(post, cart.masscenter)
    system.add_actuators(LinearSpring(k, path, l0), LinearDamper(c, path),
                         TorqueActuator(-kt * theta, cart.z, arm, cart))  # fmt: skip
    system.add_loads(Force(cart, F * rail.x))
    system.apply_uniform_gravity(-g * rail.y)
    values = {g: 9.81, l: 0.7, k: 30.0, c: 0.4, l0: 1.0, mc: 2.0, mb: 0.5, kt: 1.5}
    return of_system(system, name="cart_pendulum", parameters=values, inputs={F: 0.0})
