"""Motions in elliptic functions: pendulum, free rigid body, heavy top, bead on a turning hoop."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
from mpmath import mp, mpf

from eigenmotion import Model, load_model

from .state import State, initial_state, parameters_of

MODELS = Path(__file__).parents[2] / "models"

mp.dps = 25

NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)


def integral(function: Callable[[mpf], mpf], end: float, panels: int = 40) -> mpf:
    """Integral from 0 to end by composite Gauss rules of 20 nodes: good to rounding where panels resolve the motion."""
    half = mpf(end) / panels / 2
    middles = [(2 * k + 1) * half for k in range(panels)]
    pairs = list(zip(map(float, NODES), map(float, WEIGHTS), strict=True))
    return half * mp.fsum(weight * function(middle + half * node) for middle in middles for node, weight in pairs)


def pendulum(model: Model, time: float) -> State:
    """sin(theta / 2) = k sn(w t + u0, k) for a pendulum that does not turn over."""
    p, start = parameters_of(model), initial_state(model)
    theta0, rate0 = mpf(start.x[0]), mpf(start.v[0])
    w = mp.sqrt(mpf(p["g"]) / mpf(p["l"]))
    k = mp.sqrt(mp.sin(theta0 / 2) ** 2 + (rate0 / (2 * w)) ** 2)
    u0 = mp.ellipf(mp.asin(mp.sin(theta0 / 2) / k), k**2)
    u = w * time + (u0 if rate0 >= 0 else 2 * mp.ellipk(k**2) - u0)
    theta = 2 * mp.asin(k * mp.ellipfun("sn", u, k=k))
    rate = 2 * k * w * mp.ellipfun("cn", u, k=k)
    return State(np.array([float(theta)]), np.array([float(rate)]))


def body_rates(J: list[mpf], omega: list[mpf], time: mpf) -> list[mpf]:
    """Euler's equations, J1 < J2 < J3, turning about axis 1: Landau and Lifshitz, Mechanics, section 37."""
    J1, J2, J3 = J
    momentum2 = mp.fsum((Jk * wk) ** 2 for Jk, wk in zip(J, omega, strict=True))
    energy2 = mp.fsum(Jk * wk**2 for Jk, wk in zip(J, omega, strict=True))
    if energy2 * J2 <= momentum2:
        raise ValueError("this closed form holds for turning about the axis of least inertia")
    across, along = momentum2 - energy2 * J1, energy2 * J3 - momentum2
    sign = mp.sign(omega[0])
    w1, w2, w3 = (
        sign * mp.sqrt(along / (J1 * (J3 - J1))),
        sign * mp.sqrt(across / (J2 * (J2 - J1))),
        mp.sqrt(across / (J3 * (J3 - J1))),
    )
    m = (J3 - J2) * across / ((J2 - J1) * along)
    tau0 = mp.ellipf(mp.atan2(omega[1] / w2, omega[2] / w3), m)
    tau = tau0 + time * mp.sqrt(along * (J2 - J1) / (J1 * J2 * J3))
    return [w * mp.ellipfun(kind, tau, m=m) for w, kind in ((w1, "dn"), (w2, "sn"), (w3, "cn"))]


def rigid_body(model: Model, time: float) -> State:
    """Body rates, and the angles of a body whose angular momentum L lies along z:

    J omega = L (sin theta sin phi, sin theta cos phi, cos theta).
    """
    p, start = parameters_of(model), initial_state(model)
    J = [mpf(p[f"J{k}"]) for k in (1, 2, 3)]
    omega0 = [mpf(entry) for entry in model.initial_y]
    L = mp.norm([Jk * wk for Jk, wk in zip(J, omega0, strict=True)])

    def turning(at: mpf) -> mpf:
        w1, w2, _ = body_rates(J, omega0, at)
        return L * (J[0] * w1**2 + J[1] * w2**2) / ((J[0] * w1) ** 2 + (J[1] * w2) ** 2)

    w1, w2, w3 = body_rates(J, omega0, mpf(time))
    psi, theta = start.x[0] + integral(turning, time), mp.acos(J[2] * w3 / L)
    phi, psi_rate = mp.atan2(J[0] * w1, J[1] * w2), turning(mpf(time))
    theta_rate = w1 * mp.cos(phi) - w2 * mp.sin(phi)
    x, v = [psi, theta, phi], [psi_rate, theta_rate, w3 - psi_rate * mp.cos(theta)]
    return State(np.array(x, dtype=float), np.array(v, dtype=float))


def from_turning_point(quartic: list[mpf], u0: mpf) -> Callable[[mpf], tuple[mpf, mpf]]:
    """u(t) and udot(t) of udot^2 = quartic(u), u(0) = u0 a simple root: Whittaker and Watson, section 20.6.

    u = u0 + f'(u0) / 4 / (P(t) - f''(u0) / 24), P Weierstrass' function of the invariants of the quartic; t > 0.
    """
    a0, a1, a2, a3, a4 = quartic[0], quartic[1] / 4, quartic[2] / 6, quartic[3] / 4, quartic[4]
    g2 = a0 * a4 - 4 * a1 * a3 + 3 * a2**2
    g3 = a0 * a2 * a4 + 2 * a1 * a2 * a3 - a2**3 - a0 * a3**2 - a1**2 * a4
    _, slope, curvature = (mp.polyval(_derivative(quartic, order), u0) for order in range(3))
    weierstrass = _weierstrass(g2, g3)

    def motion(time: mpf) -> tuple[mpf, mpf]:
        P, P_rate = weierstrass(time)
        gap = P - curvature / 24
        return u0 + slope / 4 / gap, -slope / 4 * P_rate / gap**2

    return cache(motion)


def _derivative(polynomial: list[mpf], order: int) -> list[mpf]:
    for _ in range(order):
        degree = len(polynomial) - 1
        polynomial = [(degree - k) * c for k, c in enumerate(polynomial[:-1])]
    return polynomial


def _weierstrass(g2: mpf, g3: mpf) -> Callable[[mpf], tuple[mpf, mpf]]:
    """Weierstrass' function and its derivative at real times > 0, from Jacobi's."""
    e3, e2, e1 = sorted(mp.polyroots([4, 0, -g2, -g3], maxsteps=200, extraprec=100), key=mp.re)
    root, m = mp.sqrt(e1 - e3), (e2 - e3) / (e1 - e3)

    def values(time: mpf) -> tuple[mpf, mpf]:
        sn, cn, dn = (mp.ellipfun(kind, time * root, m=m) for kind in ("sn", "cn", "dn"))
        return mp.re(e3 + (root / sn) ** 2), mp.re(-2 * root**3 * cn * dn / sn**3)

    return values


def heavy_top(model: Model, time: float) -> State:
    """The top of `top_angles`."""
    return State(*(np.array(row, dtype=float) for row in top_angles(model, time)))


def top_angles(model: Model, time: float) -> tuple[list[mpf], list[mpf]]:
    """Angles and rates of a top whose axis starts without nutation: with u = cos theta and the momenta p_phi, p_psi,

    udot^2 = (1 - u^2) 2 / J (E - m g l u) - ((p_phi - p_psi u) / J)^2; phi and psi by quadrature.
    """
    p, start = parameters_of(model), initial_state(model)
    J, J3, mgl = mpf(p["J"]), mpf(p["J3"]), mpf(p["m"]) * mpf(p["g"]) * mpf(p["l"])
    u0, (phi_rate0, theta_rate0, psi_rate0) = mp.cos(mpf(start.x[1])), map(mpf, start.v)
    if theta_rate0 != 0:
        raise ValueError("this closed form starts where theta rests")
    p_psi = J3 * (psi_rate0 + phi_rate0 * u0)
    p_phi = J * phi_rate0 * (1 - u0**2) + p_psi * u0
    E = J * phi_rate0**2 * (1 - u0**2) / 2 + mgl * u0
    cubic = [0, 2 * mgl / J, -2 * E / J - (p_psi / J) ** 2, -2 * mgl / J + 2 * p_phi * p_psi / J**2]
    motion = from_turning_point([*map(mpf, cubic), 2 * E / J - (p_phi / J) ** 2], u0)

    def u(at: mpf) -> mpf:
        return motion(at)[0]

    def precession(at: mpf) -> mpf:
        return (p_phi - p_psi * u(at)) / (J * (1 - u(at) ** 2))

    def spin(at: mpf) -> mpf:
        return p_psi / J3 - precession(at) * u(at)

    end, u_rate = motion(mpf(time))
    x = [start.x[0] + integral(precession, time, panels=20), mp.acos(end), start.x[2] + integral(spin, time, panels=20)]
    v = [precession(mpf(time)), -u_rate / mp.sqrt(1 - end**2), spin(mpf(time))]
    return x, v


def quaternion_top(model: Model, time: float) -> State:
    """The same top, q = (cos(theta / 2) e^(i (phi + psi) / 2), sin(theta / 2) e^(i (phi - psi) / 2))."""
    start = initial_state(model)
    tilt, spin = 2 * np.arctan2(start.x[1], start.x[0]), 2 * start.v[3] / start.x[0]
    _, theta, psi = (upright := load_model(MODELS / "heavy_top.py")).coordinates
    angles, rates = top_angles(replace(upright, initial={theta: tilt, psi.diff(): spin}), time)

    def quaternion(h: mpf) -> list[mpf]:
        phi, theta, psi = (angle + h * rate for angle, rate in zip(angles, rates, strict=True))
        up, across = mp.cos(theta / 2), mp.sin(theta / 2)
        real, first = up * mp.cos((phi + psi) / 2), across * mp.cos((phi - psi) / 2)
        return [real, first, across * mp.sin((phi - psi) / 2), up * mp.sin((phi + psi) / 2)]

    rates_of_q = [mp.diff(lambda h, k=k: quaternion(h)[k], 0) for k in range(4)]
    return State(np.array(quaternion(mpf(0)), dtype=float), np.array(rates_of_q, dtype=float))


def steady_precession(model: Model, theta: float, axial_rate: float) -> float:
    """The slower root of J W^2 cos(theta) - J3 w3 W + m g l = 0, w3 = psidot + W cos(theta) the axial rate."""
    p = parameters_of(model)
    a, b, c = p["J"] * np.cos(theta), -p["J3"] * axial_rate, p["m"] * p["g"] * p["l"]
    return float(2 * c / (-b + np.sqrt(b * b - 4 * a * c)))


def rotating_hoop(model: Model, time: float) -> State:
    """A bead let go at rest on one side: u = cos theta, udot^2 = (1 - u^2) (W^2 (1 - u^2) + 2 g / R u + c)."""
    p, start = parameters_of(model), initial_state(model)
    if start.v[0] != 0:
        raise ValueError("this closed form starts at rest")
    W2, weight = mpf(p["Omega"]) ** 2, 2 * mpf(p["g"]) / mpf(p["R"])
    u0 = mp.cos(mpf(start.x[0]))
    level = W2 - W2 * (1 - u0**2) - weight * u0
    u, u_rate = from_turning_point([W2, -weight, -W2 - level, weight, level], u0)(mpf(time))
    side = mpmath.sign(start.x[0])
    theta = side * mp.acos(u)
    return State(np.array([float(theta)]), np.array([float(-u_rate / mp.sin(theta))]))
