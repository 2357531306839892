"""Identities of the right-hand side: rates of the state compared with the acceleration."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...compiled.description import blocks_of
from ...system.system import System
from .arithmetic.rounding_bounds import EPS, Rounded, applied, geometric, inverse, root, rounded
from .compiled_values import CompiledValues
from .identities import Identity, flat
from .solve_errors import Errors
from .symbolic_values import SymbolicValues


@dataclass(frozen=True, slots=True)
class Factors:
    """Eigenfactors of symmetric matrices W = C^T S^2 C and their rates: C, C_rate (k, n, n), s, s_rate (k, n)."""

    C: Vector
    s: Vector
    C_rate: Vector
    s_rate: Vector


def rates(
    system: System, v: Vector, compiled: CompiledValues, symbolic: SymbolicValues, errors: Errors
) -> Iterator[Identity]:
    """Yield identities of the state y and its rate dy, for v (k, n)."""
    n, layout, names = system.compiled.n, system.layout, system.compiled.coordinates
    back = rounded(v).off(EPS * recovered(system, v, compiled))
    yield Identity([f"{name}' of the right-hand side" for name in names], [rounded(compiled.dy[:, :n]), -back])
    yield Identity([f"{name}' of the state" for name in names], [rounded(compiled.velocity), -back])
    same = "v" in layout and np.array_equal(compiled.dy[:, n:], compiled.a, equal_nan=True)  # found in the same way
    a = rounded(compiled.a) if same else rounded(compiled.a).off(errors.a)
    if "v" in layout:
        yield Identity([f"the rate of {name}'" for name in names], [rounded(compiled.dy[:, n:]), -a],
                       scale=0.0 if same else speeds(compiled.a, compiled))  # fmt: skip
    elif system.formulation == "cholesky":
        yield from _of_root(names, rounded(compiled.dy[:, n : 2 * n]), back, a, compiled.root, symbolic)
    else:
        yield from _of_eigenfactors(system, back, a, compiled, symbolic)
    if "s_delta" in layout:
        yield from _of_delta(system, compiled, symbolic)


def recovered(system: System, v: Vector, compiled: CompiledValues) -> Vector:
    """Return (k, n); eps times this bounds the error of velocities from the state, e.g. from eta = (root of M) v."""
    return np.abs(v) if "v" in system.layout else speeds(v, compiled)


def speeds(v: Vector, compiled: CompiledValues) -> Vector:
    """Return (k, n): for each coordinate, the speed with which it alone has the kinetic energy of v (k, n)."""
    W = np.einsum("kii->ki", inverse(rounded(compiled.factored)).value)
    energy = np.einsum("ki,kij,kj->k", v, compiled.factored, v)
    return np.asarray(np.nan_to_num(np.sqrt(np.abs(W * energy[:, None]))))


def _of_root(
    names: Sequence[str], eta_rate: Rounded, v: Rounded, a: Rounded, R: Vector, symbolic: SymbolicValues
) -> Iterator[Identity]:
    """Yield identities of eta = R v, M = R^T R, with the rate of R from that of M; R (k, n, n) is triangular."""
    entries = [f"R^T R = M of {one}, {two}" for one in names for two in names]
    columns, size = rounded(R), geometric(symbolic.M.value)
    yield Identity(entries, [flat(columns.turned @ columns), -flat(symbolic.M)], _wide(EPS * size), _wide(size))
    order = _order(R)
    M, M_rate = (part[np.ix_(range(len(R)), order, order)] for part in (symbolic.M, symbolic.M_rate))
    L = root(M)
    back = np.linalg.inv(np.where(np.isfinite(L.value), L.value, np.eye(L.value.shape[1])))
    W = Rounded(back, np.abs(back) @ L.bound @ np.abs(back))
    inner = W @ M_rate @ W.turned
    half = np.tril(np.ones(back.shape[1:])) - 0.5 * np.eye(back.shape[1])
    turning = applied((L @ (half * inner)).turned, v[:, order])
    terms = [eta_rate[:, order], -turning, -applied(L.turned, a[:, order])]
    yield Identity([f"the rate of eta for {names[k]}'" for k in order], terms, scale=_all(terms))


def _order(R: Vector) -> list[int]:
    """Return the coordinates in an order in which R (k, n, n) is upper triangular; as they are, if there is none."""
    uses, left, order = np.asarray(np.nan_to_num(R).any(axis=0)), [*range(R.shape[1])], list[int]()
    while left:
        k = next((k for k in reversed(left) if not any(uses[k, other] for other in left if other != k)), left[-1])
        order.append(k)
        left.remove(k)
    return order[::-1]


def _all(terms: Sequence[Rounded]) -> Vector:
    """Return (k, 1): the common size of terms in the same unit."""
    return np.asarray(sum(np.abs(term.value) for term in terms).max(axis=1, keepdims=True))


def _of_eigenfactors(
    system: System, v: Rounded, a: Rounded, compiled: CompiledValues, symbolic: SymbolicValues
) -> Iterator[Identity]:
    """Yield identities of eta = S C v (17) and M = C^T S^2 C, in units of `scales`."""
    c = system.compiled
    unit, names = rounded(1.0 / c.scales), c.coordinates
    both = c.scales[:, None] * c.scales
    M, M_rate = both * symbolic.M, both * symbolic.M_rate
    factors = _factors_of(system, compiled, M_rate.value)
    size = _largest(factors, blocks_of(c, c.n))
    yield from _factored([f"M of {one}, {two}" for one in names for two in names], factors, M, M_rate, size)
    C, s, C_rate, s_rate = map(rounded, (factors.C, factors.s, factors.C_rate, factors.s_rate))
    Cv, Ca, turn = applied(C, v * unit), applied(C, a * unit), applied(C_rate, v * unit)
    terms = [rounded(compiled.dy[:, c.n : 2 * c.n]), -(s_rate * Cv), -(s * turn), -(s * Ca)]
    wide = np.abs(factors.C)
    off = wide @ M_rate.bound @ wide.swapaxes(1, 2)  # error of C Mdot C^T, which determines the rates of C and s
    off = off + EPS * size * np.abs(factors.C_rate).max(axis=2, keepdims=True, initial=0.0)
    more = np.einsum("kij,kj->ki", off, np.abs(Cv.value)) / factors.s
    yield Identity([f"the rate of eta number {k}" for k in range(c.n)], terms, more, _all(terms))


def _factors_of(system: System, compiled: CompiledValues, M_rate: Vector) -> Factors:
    """Return the eigenfactors in the state; for blocks that are not in the state, those of M."""
    C, s, C_rate = compiled.C.copy(), compiled.s.copy(), np.zeros_like(compiled.C)
    s_rate = np.einsum("kij,kjl,kil->ki", C, M_rate, C) / (2.0 * s)
    if "s" in system.layout:
        carried = [
            block for block in blocks_of(system.compiled, system.compiled.n) if block[0] in system.compiled.carried
        ]
        for block, (at, root) in zip(carried, _places(system, "C", "s", carried), strict=True):
            square = np.ix_(range(len(C)), block, block)
            shape = (len(C), len(block), len(block))
            C[square], C_rate[square] = compiled.y[:, at].reshape(shape), compiled.dy[:, at].reshape(shape)
            s[:, block], s_rate[:, block] = compiled.y[:, root], compiled.dy[:, root]
    return Factors(C, s, C_rate, s_rate)


def _places(system: System, C: str, s: str, blocks: Sequence[Sequence[int]]) -> Iterator[tuple[slice, slice]]:
    """Return the positions in y of C and s of each block."""
    at, root = system.layout[C].start, system.layout[s].start
    for size in map(len, blocks):
        yield slice(at, at + size**2), slice(root, root + size)
        at, root = at + size**2, root + size


def _largest(factors: Factors, blocks: Sequence[Sequence[int]]) -> Vector:
    """Return (k, n, n): the largest s^2 in the block of both coordinates; rounding of the factors is relative to it."""
    size = np.zeros_like(factors.C)
    for block in map(list, blocks):
        size[np.ix_(range(len(size)), block, block)] = (factors.s[:, block] ** 2).max(axis=1)[:, None, None]
    return size


def _factored(
    names: Sequence[str], factors: Factors, W: Rounded, W_rate: Rounded, size: Vector, turning: Vector | float = 0.0
) -> Iterator[Identity]:
    """Yield identities of W = C^T S^2 C with orthonormal C, and of their derivatives (30), (35)."""
    C, s, C_rate, s_rate = map(rounded, (factors.C, factors.s, factors.C_rate, factors.s_rate))
    squares, unit = (s * s)[:, :, None], Rounded(np.broadcast_to(np.eye(C.value.shape[1]), C.value.shape), 0.0 * size)
    wide = np.abs(factors.C.swapaxes(1, 2)) @ np.abs(factors.C)
    fast = np.abs(factors.C_rate).max(axis=(1, 2), keepdims=True, initial=0.0) + turning
    of_W = [flat(C.turned @ (squares * C)), -flat(W)]
    yield Identity([f"C^T S^2 C = {name}" for name in names], of_W, _wide(EPS * size),
                   _wide(geometric(W.value)))  # fmt: skip
    yield Identity([f"C C^T = 1, beside {name}" for name in names], [flat(C @ C.turned), -flat(unit)], EPS, 1.0)
    like = geometric(W.value)
    pace = fast + np.abs(W_rate.value / like).max(axis=(1, 2), keepdims=True, initial=0.0)
    along, stretch = C_rate.turned @ (squares * C), C.turned @ ((2.0 * (s * s_rate))[:, :, None] * C)
    terms = [flat(along), flat(along.turned), flat(stretch), -flat(W_rate)]
    more = wide @ W_rate.bound @ wide + EPS * fast * size
    yield Identity([f"the rate of C, s, beside {name}" for name in names], terms, _wide(more),
                   _wide(pace * like))  # fmt: skip
    gauge = C @ C_rate.turned
    yield Identity([f"the rate of C C^T, beside {name}" for name in names], [flat(gauge), flat(gauge.turned)],
                   _wide(EPS * fast + 0.0 * size), _wide(pace + 0.0 * size))  # fmt: skip


def _wide(size: Vector) -> Vector:
    return size.reshape(len(size), -1)


def _of_delta(system: System, compiled: CompiledValues, symbolic: SymbolicValues) -> Iterator[Identity]:
    """Yield identities of Delta = A M^-1 A^T (47) and of the eigenfactors of its groups."""
    A, W = symbolic.A, inverse(symbolic.M)
    P = A @ W
    half = symbolic.A_rate @ P.turned
    delta, delta_rate = P @ A.turned, half + half.turned - P @ symbolic.M_rate @ P.turned
    turning = np.abs(_factors_of(system, compiled, symbolic.M_rate.value).C_rate).max(axis=(1, 2), keepdims=True)
    groups = [group for group in _coupled(delta) if len(group) > 1]
    if sum(map(len, groups)) != system.layout["s_delta"].stop - system.layout["s_delta"].start:
        return  # some rows are coupled only formally
    for group, (at, root_at) in zip(groups, _places(system, "C_delta", "s_delta", groups), strict=True):
        shape, square = (len(compiled.y), len(group), len(group)), np.ix_(range(len(compiled.y)), group, group)
        factors = Factors(compiled.y[:, at].reshape(shape), compiled.y[:, root_at],
                          compiled.dy[:, at].reshape(shape), compiled.dy[:, root_at])  # fmt: skip
        names = [f"Delta of rows {one}, {two}" for one in group for two in group]
        size = _largest(factors, [range(len(group))])
        yield from _factored(names, factors, delta[square], delta_rate[square], size, turning)


def _coupled(delta: Rounded) -> list[list[int]]:
    """Return the groups of rows that are coupled by nonzero entries of Delta."""
    coupled = np.asarray((~delta.near() & np.isfinite(delta.value)).any(axis=0))
    groups: list[list[int]] = []
    for row in range(len(coupled)):
        joined = [group for group in groups if coupled[row, group].any()]
        groups = [group for group in groups if group not in joined] + [
            sorted([row, *(other for group in joined for other in group)])
        ]
    return sorted(groups)
