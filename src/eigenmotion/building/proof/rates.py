"""The right-hand side that is integrated, held against the acceleration: identities of what stands for xdot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...arguments.names import Vector
from ...system.system import System
from .found import Found
from .identities import Identity, flat, geometric, inverse
from .stated import Stated


@dataclass(frozen=True, slots=True)
class Factors:
    """Eigenfactors of symmetric matrices W = C^T S^2 C and their rates: C, C_rate (k, n, n), s, s_rate (k, n)."""

    C: Vector
    s: Vector
    C_rate: Vector
    s_rate: Vector


def rates(system: System, v: Vector, found: Found, stated: Stated) -> Iterator[Identity]:
    """Identities of y and dy, for v (k, n)."""
    n, layout, names = system.n, system.layout, system.coordinates
    W = inverse(stated.M)
    each = np.sqrt(np.abs(np.einsum("kii->ki", W)))
    fast, pushed = _length(stated.M, v), _length(stated.M, found.a)
    pushed = pushed + _length(stated.A @ W @ stated.A.transpose(0, 2, 1), found.multipliers)
    yield Identity([f"{name}' of the right-hand side" for name in names], [found.dy[:, :n], -v], each * fast)
    yield Identity([f"{name}' of the state" for name in names], [found.velocity, -v], each * fast)
    if "v" in layout:
        what = [f"the rate of {name}'" for name in names]
        yield Identity(what, [found.dy[:, layout["v"]], -found.a], each * pushed)
    elif system.formulation == "cholesky":
        pace = _pace(found, stated, each * fast)
        yield _of_root(names, found.dy[:, layout["eta"]], v, pushed + pace * fast, found.a, stated)
    else:
        yield from _of_eigenfactors(system, v, pushed, _pace(found, stated, each * fast), found, stated)
    if "s_delta" in layout:
        yield from _of_delta(system, found, stated)


def _length(M: Vector, v: Vector) -> Vector:
    """sqrt(v^T M v), (k, 1)."""
    return np.asarray(np.sqrt(np.abs(np.einsum("ki,kij,kj->k", v, M, v)))[:, None])


def _pace(found: Found, stated: Stated, v: Vector) -> Vector:
    """How fast M changes relative to itself, (k, 1) [1 / s], where the velocities are known to rounding of v (k, n)."""
    rates = np.abs(stated.M_rate) + np.einsum("klij,kl->kij", np.abs(found.dM), np.abs(v))
    return _largest(rates / geometric(stated.M))


def _largest(W: Vector) -> Vector:
    """The largest entry of each matrix, (k, 1)."""
    return np.asarray(np.nan_to_num(W).max(axis=(1, 2), initial=0.0)[:, None])


def _of_root(names: Sequence[str], eta_rate: Vector, v: Vector, pushed: Vector, a: Vector, stated: Stated) -> Identity:
    """eta = L^T v, M = L L^T: the rate of L by that of M."""
    sound = _positive(stated.M)
    L = np.linalg.cholesky(np.where(sound, stated.M, np.eye(v.shape[1])))
    W = np.linalg.inv(L)
    inner = np.tril(W @ stated.M_rate @ W.transpose(0, 2, 1))
    inner -= 0.5 * inner * np.eye(v.shape[1])
    turning = np.einsum("kji,kj->ki", L @ inner, v)
    terms = [eta_rate, -turning, -np.einsum("kji,kj->ki", L, a)]
    size = np.einsum("kji,kj->ki", np.abs(L), np.abs(a)) + np.einsum("kji,kj->ki", np.abs(L) @ np.abs(inner), np.abs(v))
    unsound = np.where(sound, 0.0, np.nan)[:, 0]
    return Identity([f"the rate of eta for {name}'" for name in names], terms, size + pushed + unsound)


def _of_eigenfactors(
    system: System, v: Vector, pushed: Vector, pace: Vector, found: Found, stated: Stated
) -> Iterator[Identity]:
    """eta = S C v (17), M = C^T S^2 C, in units of `scales`."""
    units, names = system.scales, system.coordinates
    both = units[:, None] * units
    M, M_rate = np.where(_positive(stated.M), stated.M, np.nan) * both, stated.M_rate * both
    factors = _factors_of(system, found, M_rate)
    yield from _factored([f"M of {one}, {two}" for one in names for two in names], factors, M, M_rate, pace)
    C, s, eta_rate = factors.C, factors.s, found.dy[:, system.layout["eta"]]
    Cv, Ca, turn = (np.einsum("kij,kj->ki", *pair) for pair in ((C, v / units), (C, found.a / units),
                                                                  (factors.C_rate, v / units)))  # fmt: skip
    sizes = [np.einsum("kij,kj->ki", np.abs(W), np.abs(w / units)) for W, w in ((C, found.a), (factors.C_rate, v))]
    terms = [eta_rate, -factors.s_rate * Cv, -s * turn, -s * Ca]
    yield Identity(
        [f"the rate of eta number {k}" for k in range(system.n)],
        terms,
        (s * (sizes[0] + sizes[1])).max(axis=1, keepdims=True) + pushed,
    )


def _factors_of(system: System, found: Found, M_rate: Vector) -> Factors:
    """Those the state carries; of the other blocks, which do not turn, those of M."""
    C, s, C_rate = found.C.copy(), found.s.copy(), np.zeros_like(found.C)
    s_rate = np.einsum("kij,kjl,kil->ki", C, M_rate, C) / (2.0 * s)
    if "s" in system.layout:
        carried = [block for block in system.blocks if block[0] in system.compiled.carried]
        for block, (at, root) in zip(carried, _places(system, "C", "s", carried), strict=True):
            square = np.ix_(range(len(C)), block, block)
            shape = (len(C), len(block), len(block))
            C[square], C_rate[square] = found.y[:, at].reshape(shape), found.dy[:, at].reshape(shape)
            s[:, block], s_rate[:, block] = found.y[:, root], found.dy[:, root]
    return Factors(C, s, C_rate, s_rate)


def _places(system: System, C: str, s: str, blocks: Sequence[Sequence[int]]) -> Iterator[tuple[slice, slice]]:
    """Where in y the C and s of each block are."""
    at, root = system.layout[C].start, system.layout[s].start
    for size in map(len, blocks):
        yield slice(at, at + size**2), slice(root, root + size)
        at, root = at + size**2, root + size


def _factored(names: Sequence[str], factors: Factors, W: Vector, W_rate: Vector, pace: Vector) -> Iterator[Identity]:
    """W = C^T S^2 C with C orthonormal, and the same differentiated (30), (35); pace (k, 1) of W."""
    C, s, C_rate, s_rate = factors.C, factors.s, factors.C_rate, factors.s_rate
    turned, squares = C.transpose(0, 2, 1), s[:, :, None] ** 2
    largest = np.broadcast_to(squares.max(axis=(1, 2), initial=0.0)[:, None, None], C.shape)
    yield Identity([f"C^T S^2 C = {name}" for name in names], [flat(turned @ (squares * C)), -flat(W)], flat(largest))
    unit = np.broadcast_to(np.eye(C.shape[1]), C.shape)
    yield Identity([f"C C^T = 1, beside {name}" for name in names], [flat(C @ turned), -flat(unit)], 1.0)
    along = C_rate.transpose(0, 2, 1) @ (squares * C)
    stretch = turned @ (2.0 * (s * s_rate)[:, :, None] * C)
    fast = (np.abs(C_rate).max(axis=(1, 2), initial=0.0)[:, None] + pace)[:, :, None] * largest
    terms = [flat(along), flat(along.transpose(0, 2, 1)), flat(stretch), -flat(W_rate)]
    yield Identity([f"the rate of C, s, beside {name}" for name in names], terms, flat(fast))
    gauge = C @ C_rate.transpose(0, 2, 1)
    yield Identity([f"the rate of C C^T, beside {name}" for name in names],
                   [flat(gauge), flat(gauge.transpose(0, 2, 1))], flat(fast / largest))  # fmt: skip


def _of_delta(system: System, found: Found, stated: Stated) -> Iterator[Identity]:
    """Delta = A M^-1 A^T (47) and the eigenfactors of its parts."""
    A, W = stated.A, inverse(np.where(_positive(stated.M), stated.M, np.nan))
    P = A @ W
    half = stated.A_rate @ P.transpose(0, 2, 1)
    delta = P @ A.transpose(0, 2, 1)
    delta_rate = half + half.transpose(0, 2, 1) - P @ stated.M_rate @ P.transpose(0, 2, 1)
    pace = _largest(np.abs(delta_rate) / geometric(delta)) + _pace(found, stated, found.velocity)
    groups = [group for group in _coupled(delta) if len(group) > 1]
    if sum(map(len, groups)) != system.layout["s_delta"].stop - system.layout["s_delta"].start:
        return  # rows coupled in form only
    for group, (at, root) in zip(groups, _places(system, "C_delta", "s_delta", groups), strict=True):
        shape, square = (len(delta), len(group), len(group)), np.ix_(range(len(delta)), group, group)
        factors = Factors(found.y[:, at].reshape(shape), found.y[:, root],
                          found.dy[:, at].reshape(shape), found.dy[:, root])  # fmt: skip
        names = [f"Delta of rows {one}, {two}" for one in group for two in group]
        yield from _factored(names, factors, delta[square], delta_rate[square], pace)


def _coupled(delta: Vector) -> list[list[int]]:
    """Groups of rows of Delta between which there is something other than zero."""
    coupled = np.asarray((np.nan_to_num(np.abs(delta)) > 1e-13 * np.nan_to_num(geometric(delta))).any(axis=0))
    groups: list[list[int]] = []
    for row in range(len(coupled)):
        joined = [group for group in groups if coupled[row, group].any()]
        groups = [group for group in groups if group not in joined] + [
            sorted([row, *(other for group in joined for other in group)])
        ]
    return sorted(groups)


def _positive(M: Vector) -> Vector:
    """(k, 1, 1) whether M is positive definite, with a margin: elsewhere its factors are no evidence."""
    size = geometric(M)
    scaled = np.where(np.isfinite(M / size), M / size, 0.0)
    return np.asarray(np.linalg.eigvalsh(scaled)[:, :1, None] > 1e-12)
