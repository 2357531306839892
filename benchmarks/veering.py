"""Benchmark of eigenvalue veering: cost and errors of passages through an avoided crossing (docs/theory.md).

For each gap from 0 to 1e-1 and each tolerance: the right-hand sides of `eigenfactor` over those of `lagrange`, its
largest error along the run over lagrange's, and the part of its steps that did not use the published equations. Each
run has ten passages.
"""

import numpy as np

import eigenmotion as em

GAPS = (0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1)
TOLERANCES = (1e-6, 1e-10)
PASSAGES = 10
MODEL = "models/veering.py"


def ten_passages(system, gap):
    """Return the time at which x passes the crossing for the tenth time."""
    sol = system.simulate((0.0, 100.0), parameters={"gap": gap}, rtol=1e-10, atol=1e-10)
    signs = np.flatnonzero(np.diff(np.sign(sol.x[0])))
    return float(sol.t[signs[PASSAGES - 1] + 1])


def exactly(systems, gap):
    """Return the end of ten passages, and the motion until then by a formulation without eigenvalues."""
    t_end = ten_passages(systems["lagrange"], gap)
    tight = {"rtol": 1e-13, "atol": 1e-13, "max_step": 0.05, "dense_output": True}
    return t_end, systems["cholesky"].simulate((0.0, t_end), parameters={"gap": gap}, **tight)


def row(systems, gap, rtol):
    """Return (nfev, largest error at the accepted steps, bounded part) of each system."""
    t_end, exact = exactly(systems, gap)
    results = {}
    for name, system in systems.items():
        sol = system.simulate((0.0, t_end), parameters={"gap": gap}, rtol=rtol, atol=rtol)
        error = np.abs(sol.x - exact.sol(sol.t)[:2]).max()
        results[name] = (sol.nfev, error, sol.n_bounded / sol.nsteps) if sol.success else None
    return results


def choices():
    """Return name -> system."""
    named = {name: em.build(MODEL, formulation=name) for name in ("lagrange", "cholesky", "eigenfactor")}
    return named | {"extrapolate": em.build(MODEL, close_eigenvalues="extrapolate")}


def cell(result, base):
    if result is None:
        return "       stopped        "
    nfev, error, bounded = result
    return f"{nfev / base[0]:6.2f} {error / base[1]:9.2g} {bounded:5.0%}"


def main():
    systems = choices()
    others = [name for name in systems if name != "lagrange"]
    print(f"{PASSAGES} passages; each cell: right-hand sides / lagrange's, largest error / lagrange's, bounded steps")
    print(f"{'rtol':>6} {'gap':>6} {'lagrange':>8} {'error':>8}   " + "   ".join(f"{name:^22}" for name in others))
    for rtol in TOLERANCES:
        for gap in GAPS:
            results = row(systems, gap, rtol)
            base = results["lagrange"]
            cells = "   ".join(cell(results[name], base) for name in others)
            print(f"{rtol:6.0e} {gap:6.0e} {base[0]:8d} {base[1]:8.1e}   {cells}", flush=True)


if __name__ == "__main__":
    main()
