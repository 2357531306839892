"""Motions in elementary functions: Kepler's ellipse, the sleigh, the coin, the ball, the springs in a turning plate."""

from __future__ import annotations

import numpy as np
from mpmath import mp, mpf

from eigenmotion import Model

from .elliptic import integral
from .state import State, initial_state, parameters_of


def kepler(model: Model, time: float) -> State:
    """An ellipse that starts at its pericentre: Kepler's equation n t = E - e sin E."""
    p, start = parameters_of(model), initial_state(model)
    mu, r0, momentum = mpf(p["mu"]), mpf(start.x[0]), mpf(start.x[0]) ** 2 * mpf(start.v[1])
    a = 1 / (2 / r0 - (momentum / r0) ** 2 / mu)
    e = 1 - r0 / a
    n = mp.sqrt(mu / a**3)
    E = mp.findroot(lambda E: E - e * mp.sin(E) - n * time, (n * time, n * time + e), solver="anderson")
    r = a * (1 - e * mp.cos(E))
    # theta / 2 and E / 2 agree at multiples of pi / 2
    b = e / (1 + mp.sqrt(1 - e**2))
    theta = E + 2 * mp.atan(b * mp.sin(E) / (1 - b * mp.cos(E)))
    v = [a * e * mp.sin(E) * n * a / r, momentum / r**2]
    return State(np.array([r, start.x[1] + theta], dtype=float), np.array(v, dtype=float))


def chaplygin_sleigh(model: Model, time: float) -> State:
    """Speed u along the blade and turning rate w of the sleigh, I = J + m a^2.

    m udot = m a w^2, I wdot = -m a u w: u = sqrt(I / m) W tanh(k s), w = W / cosh(k s), k = a W sqrt(m / I).
    The direction is a Gudermann function, the position a quadrature.
    """
    p, start = parameters_of(model), initial_state(model)
    m, J, a = (mpf(p[name]) for name in ("m", "J", "a"))
    inertia, theta0, w0 = J + m * a**2, mpf(start.x[2]), mpf(start.v[2])
    u0 = start.v[0] * mp.cos(theta0) + start.v[1] * mp.sin(theta0)
    W = mp.sqrt(w0**2 + m / inertia * u0**2)
    k, shift = a * W * mp.sqrt(m / inertia), mp.atanh(u0 / W * mp.sqrt(m / inertia))

    def speed(at: mpf) -> mpf:
        return mp.sqrt(inertia / m) * W * mp.tanh(k * at + shift)

    def direction(at: mpf) -> mpf:
        change = mp.atan(mp.sinh(k * at + shift)) - mp.atan(mp.sinh(shift))
        return theta0 + mp.sign(w0) * W / k * change

    x = start.x[0] + integral(lambda at: speed(at) * mp.cos(direction(at)), time)
    y = start.x[1] + integral(lambda at: speed(at) * mp.sin(direction(at)), time)
    theta, u = direction(mpf(time)), speed(mpf(time))
    v = [u * mp.cos(theta), u * mp.sin(theta), mp.sign(w0) * W / mp.cosh(k * time + shift)]
    return State(np.array([x, y, theta], dtype=float), np.array(v, dtype=float))


def steady_spin(model: Model, lean: float, turn: float) -> float:
    """Rolling rate psidot of a disk that leans and turns steadily, by balance of moments about its centre."""
    p = parameters_of(model)
    m, r, g = p["m"], p["r"], p["g"]
    across, along = m * r**2 / 4, m * r**2 / 2
    about_axle = (m * g * r * np.tan(lean) / turn - across * turn * np.sin(lean)) / (along + m * r**2)
    return float(about_axle + turn * np.sin(lean))


def rolling_disk(model: Model, time: float) -> State:
    """The steady circle of a disk that starts on it; ValueError where it does not."""
    p, start = parameters_of(model), initial_state(model)
    x0, y0, phi0, lean, psi0 = start.x
    turn, lean_rate, roll = start.v[2:]
    if lean_rate != 0 or abs(roll - steady_spin(model, lean, turn)) > 1e-12 * abs(roll):
        raise ValueError("the disk does not start on a steady motion")
    phi, radius = phi0 + turn * time, p["r"] * roll / turn
    speed = p["r"] * roll
    x = [x0 + radius * (np.sin(phi) - np.sin(phi0)), y0 - radius * (np.cos(phi) - np.cos(phi0)), phi, lean]
    v = [speed * np.cos(phi), speed * np.sin(phi), turn, 0.0, roll]
    return State(np.array([*x, psi0 + roll * time]), np.array(v))


def sphere(model: Model, time: float) -> State:
    """A ball rolls as a particle slides, at 5/7 of its acceleration. The attitude is left open."""
    p, start = parameters_of(model), initial_state(model)
    acceleration = np.array([5 / 7 * p["g"] * np.sin(p["alpha"]), 0.0])
    open_ends = np.full(3, np.nan)
    v = start.v[:2] + acceleration * time
    x = start.x[:2] + start.v[:2] * time + acceleration * time**2 / 2
    return State(np.concatenate([x, open_ends]), np.concatenate([v, open_ends]))


def ball_rates(model: Model, state: State) -> np.ndarray:
    """Angular velocity (3,) in the axes of the plane, from Rodrigues parameters p and their rates."""
    p, rate = state.x[2:], state.v[2:]
    return 2 * (rate + np.cross(p, rate)) / (1 + p @ p)


def rotating_spring(model: Model, time: float) -> State:
    """x'' = 2 W y' + (W^2 - k_x / m) x, y'' = -2 W x' + (W^2 - k_y / m) y by the matrix exponential."""
    p, start = parameters_of(model), initial_state(model)
    W, m, k_x, k_y = (mpf(p[name]) for name in ("Omega", "m", "k_x", "k_y"))
    system = mp.matrix([[0, 0, 1, 0], [0, 0, 0, 1], [W**2 - k_x / m, 0, 0, 2 * W], [0, W**2 - k_y / m, -2 * W, 0]])
    end = mp.expm(system * time) * mp.matrix([*start.x, *start.v])
    y = np.array(list(end), dtype=float)
    return State(y[:2], y[2:])
