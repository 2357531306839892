"""Delta factored numerically against Delta's eigenfactors as states, for chains whose hands are held: m = 2, 4, 6, 8.

Each row: time of a simulation and error at its end, `schur="eigenfactor"` over `schur="factor"`; medians of
interleaved repeats.
"""

import time

import numpy as np
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

REPEATS = 15


def held_chain(m):
    """Return a planar chain of 2 m links of which every second joint moves on a horizontal line."""
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
    initial = {angle: 0.4 + 0.1 * k for k, angle in enumerate(q)}
    return em.Model(name=f"held_{m}", coordinates=q, kinetic_energy=T, potential_energy=V, parameters={g: 9.81},
                    nonholonomic_constraints=rows, initial=initial)  # fmt: skip


def timed(system):
    start = time.perf_counter()
    system.simulate((0.0, 1.0), rtol=1e-8, atol=1e-8, t_eval=[1.0])
    return time.perf_counter() - start


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


if __name__ == "__main__":
    main()
