"""Constrained mechanisms by one coordinate: loops solved by hand, motion from energy or from one equation.

The crank of a linkage that keeps turning obeys qdot = sqrt(2 (E - V(q)) / M(q)), with M and V written by hand.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from eigenmotion import Model

from .arithmetic import array
from .state import State, initial_state, parameters_of
from .trajectory import integrate

Numbers = dict[str, Any]
TOLERANCE = 3e-17


def driven_pendulum(model: Model, time: float) -> State:
    """theta'' = -(g + pivot'') sin(theta) / l, x = l sin(theta), y = pivot - l cos(theta)."""
    p, start = _numbers(model), initial_state(model)
    a, w, l, g = (p[name] for name in ("a", "w", "l", "g"))

    def rhs(t: Any, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -(g - a * w**2 * np.cos(w * t)) * np.sin(y[0]) / l])

    theta0 = np.arctan2(start.x[0], p["a"] - start.x[1])
    rate0 = (start.v[0] * np.cos(theta0) + start.v[1] * np.sin(theta0)) / l
    theta, rate = integrate(rhs, array([theta0, rate0], "extended"), time, TOLERANCE, "extended")
    pivot, pivot_rate = a * np.cos(w * time), -a * w * np.sin(w * time)
    x = [l * np.sin(theta), pivot - l * np.cos(theta)]
    return State(np.array(x), np.array([l * rate * np.cos(theta), pivot_rate + l * rate * np.sin(theta)]))


def slider_crank(model: Model, time: float) -> State:
    """The slider-crank with a crank that keeps turning."""
    return _turned(model, time, _slider_crank_at)


def four_bar(model: Model, time: float) -> State:
    """The four-bar linkage with a crank that keeps turning, coupler above."""
    return _turned(model, time, _four_bar_at)


def four_bars(model: Model, time: float) -> State:
    """Cranks stay parallel and couplers level: J q'' = -g m l (3 n + 1) / 2 cos q, J = m l^2 (4 n + 1) / 3."""
    p, start = _numbers(model), initial_state(model)
    n = len(start.x) // 2
    pull = p["g"] * ((n + 1) / np.longdouble(2) + n) / (p["l"] * ((n + 1) / np.longdouble(3) + n))

    def rhs(_: Any, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -pull * np.cos(y[0])])

    q, rate = integrate(rhs, array([start.x[0], start.v[0]], "extended"), time, TOLERANCE, "extended")
    still = np.zeros(n, dtype=np.longdouble)
    return State(np.array([*(n + 1) * [q], *still]), np.array([*(n + 1) * [rate], *still]))


def snakeboard(model: Model, time: float) -> State:
    """Without torques: P = s (m l^2 cos^2 phi + (J + 2 J_wheels) sin^2 phi) + K sin phi along what the wheels allow.

    The board runs at s l cos phi and turns at s sin phi; phi' and the rotor's momentum K = J_rotor (theta' + psi')
    stay, and Pdot = phi' (K cos phi + s (J + 2 J_wheels - m l^2) sin phi cos phi) (Bloch, Nonholonomic Mechanics, 5.8).
    """
    p, start = _numbers(model), initial_state(model)
    m, l, J = p["m"] * p["l"] ** 2, p["l"], p["J"] + 2 * p["J_wheels"]
    steering, spin = start.v[4], p["J_rotor"] * (start.v[2] + start.v[3])

    def allowed(phi: Any, P: Any) -> Any:
        return (P - spin * np.sin(phi)) / (m * np.cos(phi) ** 2 + J * np.sin(phi) ** 2)

    def rhs(_: Any, y: np.ndarray) -> np.ndarray:
        _, _, theta, _, phi, P = y
        s, c = allowed(phi, P), np.cos(phi)
        speed, turn = s * l * c, s * np.sin(phi)
        rise = steering * (spin * c + s * (J - m) * np.sin(phi) * c)
        rotor = spin / p["J_rotor"] - turn
        return np.array([speed * np.cos(theta), speed * np.sin(theta), turn, rotor, steering, rise])

    phi0 = start.x[4]
    s0 = (start.v[0] * np.cos(start.x[2]) + start.v[1] * np.sin(start.x[2])) / (l * np.cos(phi0))
    P0 = s0 * (m * np.cos(phi0) ** 2 + J * np.sin(phi0) ** 2) + spin * np.sin(phi0)
    y = integrate(rhs, array([*start.x, P0], "extended"), time, TOLERANCE, "extended")
    return State(y[:5], rhs(time, y)[:5])


def _numbers(model: Model) -> Numbers:
    return {name: np.longdouble(value) for name, value in parameters_of(model).items()}


def _turned(model: Model, time: float, at: Callable[[Numbers, Any], tuple[np.ndarray, np.ndarray, Any, Any]]) -> State:
    p, start = _numbers(model), initial_state(model)
    q0, rate0 = np.longdouble(start.x[0]), np.longdouble(start.v[0])
    _, _, M0, V0 = at(p, q0)
    E = M0 * rate0**2 / 2 + V0

    def rate(q: Any) -> Any:
        _, _, M, V = at(p, q)
        return np.sign(rate0) * np.sqrt(2 * (E - V) / M)

    def rhs(_: Any, y: np.ndarray) -> np.ndarray:
        return np.array([rate(y[0])])

    (q,) = integrate(rhs, array([q0], "extended"), time, TOLERANCE, "extended")
    x, per_rate, _, _ = at(p, q)
    return State(x, per_rate * rate(q))


def _slider_crank_at(p: Numbers, q: Any) -> tuple[np.ndarray, np.ndarray, Any, Any]:
    """Coordinates, their rates per crank rate, reduced inertia M [kg m^2] and potential V [J] at a crank angle."""
    r, l, g = p["r"], p["l"], p["g"]
    phi = np.arcsin(r * np.sin(q) / l)
    phi_rate = r * np.cos(q) / (l * np.cos(phi))
    x, x_rate = r * np.cos(q) + l * np.cos(phi), -r * np.sin(q) - l * np.sin(phi) * phi_rate
    middle_x, middle_y = -r * np.sin(q) - l / 2 * np.sin(phi) * phi_rate, r * np.cos(q) - l / 2 * np.cos(phi) * phi_rate
    crank, slider = p["m_c"] * r**2 / 3, p["m_s"] * x_rate**2
    rod = p["m_r"] * (middle_x**2 + middle_y**2 + l**2 / 12 * phi_rate**2)
    V = g * np.sin(q) * r / 2 * (p["m_c"] + p["m_r"])  # the rod's middle is at half the height of the crank pin
    return np.array([q, phi, x]), np.array([q * 0 + 1, phi_rate, x_rate]), crank + rod + slider, V


def _four_bar_at(p: Numbers, q: Any) -> tuple[np.ndarray, np.ndarray, Any, Any]:
    """As for the slider-crank; crank and rocker turn about fixed pins."""
    a, b, c, d = (p[name] for name in "abcd")
    pin_x, pin_y = a * np.cos(q), a * np.sin(q)
    diagonal = np.hypot(d - pin_x, pin_y)
    above = np.arccos((b**2 + diagonal**2 - c**2) / (2 * b * diagonal))
    q2 = np.arctan2(-pin_y, d - pin_x) + above
    joint_x, joint_y = pin_x + b * np.cos(q2), pin_y + b * np.sin(q2)
    q3 = np.arctan2(joint_y, joint_x - d)
    q2_rate = a * np.sin(q - q3) / (b * np.sin(q3 - q2))
    q3_rate = a * np.sin(q - q2) / (c * np.sin(q3 - q2))
    middle_x = -a * np.sin(q) - b / 2 * np.sin(q2) * q2_rate
    middle_y = a * np.cos(q) + b / 2 * np.cos(q2) * q2_rate
    coupler = b * (middle_x**2 + middle_y**2 + b**2 / 12 * q2_rate**2)
    M = p["density"] * (a**3 / 3 + coupler + c**3 / 3 * q3_rate**2)
    heights = a * pin_y / 2 + b * (pin_y + joint_y) / 2 + c * joint_y / 2
    return np.array([q, q2, q3]), np.array([q * 0 + 1, q2_rate, q3_rate]), M, p["density"] * p["g"] * heights
