"""Delta factored numerically against Delta's eigenfactors as states, for chains whose hands are held: m = 2, 4, 6, 8.

Each row: time of a simulation and error at its end, `schur="eigenfactor"` over `schur="factor"`; medians of
interleaved repeats. Then a right-hand side with one row twice and `dependent_constraints="least_norm"`, over one with
m rows that are independent.
"""

import time

import numpy as np
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

REPEATS = 15


def held_chain(m, doubled=False):
    """Return a planar chain of 2 m links of which every second joint moves on a horizontal line; perhaps twice."""
    q = dynamicsymbols(f"theta1:{2 * m + 1}")
    g = symbols("g", positive=True)
    x = y = T = V = 0
    rows = []
    for k, angle in enumerate(q):
        x, y = x + sin(angle), y - cos(angle)
        T += (x.diff(em.t) ** 2 + y.diff(em.t) ** 2) / 2
        V += g * y
        if k % 2:
            rows.append(y.diff(em.t))
    if doubled:
        rows[-1] = 2 * rows[0]
    initial = {angle: 0.4 + 0.1 * k for k, angle in enumerate(q)}
    name = f"held_{m}_doubled" if doubled else f"held_{m}"
    return em.Model(name=name, coordinates=q, kinetic_energy=T, potential_energy=V, parameters={g: 9.81},
                    nonholonomic_constraints=rows, initial=initial)  # fmt: skip


def timed(system):
    start = time.perf_counter()
    system.simulate((0.0, 1.0), rtol=1e-8, atol=1e-8, t_eval=[1.0])
    return time.perf_counter() - start


def rhs_seconds(system, **options):
    """Return the time of a run, over its right-hand sides."""
    start = time.perf_counter()
    run = system.simulate((0.0, 1.0), rtol=1e-8, atol=1e-8, t_eval=[1.0], **options)
    return (time.perf_counter() - start) / run.nfev


def print_dependent_rows():
    print(f"\n{'m':>3} {'time':>6}   a row twice, least norm, over independent rows; lagrange")
    for m in (2, 4, 6, 8):
        single, doubled = (em.build(held_chain(m, twice), formulation="lagrange") for twice in (False, True))
        ratios = [
            rhs_seconds(doubled, dependent_constraints="least_norm") / rhs_seconds(single) for _ in range(REPEATS)
        ]
        print(f"{m:3d} {np.median(ratios):6.2f}", flush=True)


def main():
    print(f"{'m':>3} {'time':>6} {'error':>7}   eigenfactor over factor")
    for m in (2, 4, 6, 8):
        model = held_chain(m)
        systems = [em.build(model, schur=schur) for schur in ("eigenfactor", "factor")]
        truth = em.build(model, formulation="cholesky").simulate((0.0, 1.0), rtol=1e-12, atol=1e-12).x[:, -1]
        runs = [system.simulate((0.0, 1.0), rtol=1e-8, atol=1e-8) for system in systems]
        errors = [np.abs(sol.x[:, -1] - truth).max() for sol in runs]
        ratios = [timed(systems[0]) / timed(systems[1]) for _ in range(REPEATS)]
        print(f"{m:3d} {np.median(ratios):6.2f} {errors[0] / errors[1]:7.2f}   {runs[0].stop}", flush=True)
    print_dependent_rows()


if __name__ == "__main__":
    main()
