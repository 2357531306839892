"""Newton-Euler equations of bodies whose places are products of homogeneous matrices, projected on the coordinates
(Kane), in 40 digits: Jacobians and accelerations are differences of the places. They share nothing with recursions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from mpmath import mp

DIGITS = 40
STEP = mp.mpf(10) ** -10
"""Of central differences: of first ones the error is 1e-20, of second ones, and of rounding in them, 1e-20."""

Values = Mapping[sympy.Expr, Any]


def skew(a: Sequence[Any]) -> Any:
    return mp.matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def axial(W: Any) -> Any:
    """Return the vector of the skew part of a matrix."""
    return mp.matrix([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]) / 2


def homogeneous(R: Any, p: Sequence[Any]) -> Any:
    """Return H (4, 4) of a rotation and a place."""
    H = mp.eye(4)
    for i in range(3):
        H[i, 3] = p[i]
        for j in range(3):
            H[i, j] = R[i, j]
    return H


def exact(expressions: Sequence[sympy.Expr], parameters: Values) -> list[Any]:
    """Return the doubles that expressions are."""
    return [mp.mpf(float(sympy.sympify(one).subs(parameters))) for one in expressions]


def turned(axis: Sequence[Any], angle: Any) -> Any:
    """Return the rotation about a unit vector, by Rodrigues' formula."""
    K = skew(axis)
    return mp.eye(3) + mp.sin(angle) * K + (1 - mp.cos(angle)) * K * K


def oriented(s: Sequence[Any]) -> Any:
    """Return the rotation of modified Rodrigues parameters s = e tan(angle / 4)."""
    size = mp.sqrt(sum(one**2 for one in s))
    return turned([one / size for one in s], 4 * mp.atan(size)) if size else mp.eye(3)


def joint(link: Any, q: Sequence[Any], parameters: Values) -> Any:
    """Return H (4, 4) of a joint at its coordinates."""
    if link.joint == "fixed":
        return mp.eye(4)
    if link.joint in ("spherical", "free"):
        return homogeneous(oriented(q[-3:]), q[:3] if link.joint == "free" else [0, 0, 0])
    axis = [mp.mpf(float(one)) for one in link.axis]
    ratio, offset = exact((link.ratio, link.offset), parameters)
    moved = ratio * q[0] + offset
    if link.joint == "prismatic":
        return homogeneous(mp.eye(3), [one * moved for one in axis])
    size = mp.sqrt(sum(one**2 for one in axis))  # 1, but for the rounding of the axis
    return homogeneous(turned([one / size for one in axis], moved), [0, 0, 0])


@dataclass
class Motion:
    """The motion of a body: R, p; its rates along each coordinate (J_w, J_v of the origin); their rates along v."""

    R: Any
    p: Any
    J_w: list[Any]
    J_v: list[Any]
    w: Any
    w_dot: Any
    p_dot_dot: Any

    def of(self, point: Sequence[Any]) -> tuple[Any, list[Any], Any]:
        """Return a point's place, its Jacobian by columns, and its acceleration while the rates are constant."""
        r = self.R * mp.matrix(point)
        columns = [v + skew(w) * r for v, w in zip(self.J_v, self.J_w, strict=True)]
        return self.p + r, columns, self.p_dot_dot + skew(self.w_dot) * r + skew(self.w) * (skew(self.w) * r)


class NewtonEuler:
    """The bodies of a tree at q, v.

    links : all bodies; a parent before those that it carries
    coordinates : functions of time, in the order of q (n,) and v (n,)
    """

    def __init__(
        self, links: Sequence[Any], coordinates: Sequence[sympy.Expr], parameters: Values, q: Any, v: Any
    ) -> None:
        self.links, self.coordinates, self.parameters = links, coordinates, parameters
        self.fixed = {link: self._fixed(link) for link in links}
        q, v = ([mp.mpf(float(one)) for one in values] for values in (q, v))
        at = self._placed(q)
        beside = [[self._placed([x + s * (j == k) for j, x in enumerate(q)]) for s in (STEP, -STEP)]
                  for k in range(len(q))]  # fmt: skip
        along = [self._placed([x + s * w for x, w in zip(q, v, strict=True)]) for s in (STEP, -STEP)]
        self.motion = {link: _motion(at[link], [[one[link] for one in pair] for pair in beside],
                                     [one[link] for one in along]) for link in links}  # fmt: skip

    def equations(self, gravity: Sequence[Any]) -> tuple[Any, Any]:
        """Return M (n, n), and the forces (n,) that M a is while all other forces are zero."""
        n = len(self.coordinates)
        M, F = mp.matrix(n, n), mp.matrix(n, 1)
        g = mp.matrix(exact(gravity, self.parameters))
        for link in self.links:
            (m,), c, J = (exact(one, self.parameters) for one in ((link.mass,), link.center, link.inertia))
            moved, h = self.motion[link], exact(link.moment, self.parameters)
            I = moved.R * mp.matrix([[J[0], J[1], J[2]], [J[1], J[3], J[4]], [J[2], J[4], J[5]]]) * moved.R.T
            _, J_v, a = moved.of(c)
            force, torque = m * (g - a), -(I * moved.w_dot + skew(moved.w) * (I * moved.w))
            for i in range(n):
                F[i] += mp.fdot(J_v[i], force) + mp.fdot(moved.J_w[i], torque)
                for j in range(n):
                    M[i, j] += m * mp.fdot(J_v[i], J_v[j]) + mp.fdot(moved.J_w[i], I * moved.J_w[j])
            if any(h):  # first moments about the origin, where the centre is said to be
                self._add_moment(moved, moved.R * mp.matrix(h), g, M, F)
        return M, F

    def _add_moment(self, moved: Motion, h: Any, g: Any, M: Any, F: Any) -> None:
        """A first moment h takes the force w' x h + w x (w x h), and the torque h x (a - g) about the origin."""
        _, J_v, a = moved.of([0, 0, 0])
        W = skew(moved.w)
        force, torque = -(skew(moved.w_dot) * h + W * (W * h)), skew(h) * (g - a)
        for i in range(len(J_v)):
            F[i] += mp.fdot(J_v[i], force) + mp.fdot(moved.J_w[i], torque)
            for j in range(len(J_v)):
                turned, pushed = skew(moved.J_w[j]) * h, skew(h) * J_v[j]
                M[i, j] += mp.fdot(J_v[i], turned) + mp.fdot(moved.J_w[i], pushed)

    def _fixed(self, link: Any) -> Any:
        R = mp.matrix(3, 3)
        for k, entry in enumerate(exact(link.rotation, self.parameters)):
            R[k // 3, k % 3] = entry
        return homogeneous(R, exact(link.at, self.parameters))

    def _placed(self, q: Sequence[Any]) -> dict[Any, Any]:
        """Return H (4, 4) of each body: products from the ground outwards."""
        values, placed = dict(zip(self.coordinates, q, strict=True)), {None: mp.eye(4)}
        for link in self.links:
            own = [values[one] for one in link.coordinates]
            placed[link] = placed[link.parent] * self.fixed[link] * joint(link, own, self.parameters)
        return placed


def _split(H: Any) -> tuple[Any, Any]:
    return H[:3, :3], H[:3, 3]


def _motion(H: Any, beside: Sequence[Any], along: Sequence[Any]) -> Motion:
    """Return the motion of a body by differences: R' R^T has w, and the skew part of R'' R^T has w'."""
    R, p = _split(H)
    rates = [_split((ahead - behind) / (2 * STEP)) for ahead, behind in beside]
    rate, second = _split((along[0] - along[1]) / (2 * STEP)), _split((along[0] + along[1] - 2 * H) / STEP**2)
    return Motion(R, p, [axial(one * R.T) for one, _ in rates], [one for _, one in rates], axial(rate[0] * R.T),
                  axial(second[0] * R.T), second[1])  # fmt: skip


def constrained(M: Any, F: Any, A: Sequence[Any], b: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
    """Return a (n,) and lambda (m,): M a + A^T lambda = F, A a + b = 0; A is a list of rows."""
    n, m = len(F), len(A)
    K, right = mp.matrix(n + m, n + m), mp.matrix(n + m, 1)
    for i in range(n):
        right[i] = F[i]
        for j in range(n):
            K[i, j] = M[i, j]
    for k, row in enumerate(A):
        right[n + k] = -b[k]
        for i in range(n):
            K[i, n + k] = K[n + k, i] = row[i]
    answer = np.array([float(one) for one in mp.lu_solve(K, right)])
    return answer[:n], answer[n:]
