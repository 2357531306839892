"""Numbers of a report as JSON and CSV."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from ...presentation.tables import as_csv, as_json
from ..examine import Findings
from ..formulations import Built
from ..measure import Measurement
from ..recommend import LEVELS, Curve, Recommendation

_COLUMNS = tuple(field.name for field in fields(Measurement))


def record(reports: Sequence[Findings], known: Mapping[str, str]) -> str:
    """Return all results as JSON; `known` describes the machine."""
    return as_json({"machine": known, "models": [_model(findings) for findings in reports]})


def one_a_line(reports: Sequence[Findings]) -> str:
    """Return the measurements as CSV, one line each."""
    rows = (
        [findings.name, *(getattr(m, name) for name in _COLUMNS), m.ns_per_rhs]
        for findings in reports for m in findings.measurements
    )  # fmt: skip
    return as_csv(["model", *_COLUMNS, "ns_per_rhs"], rows)


def _model(findings: Findings) -> dict[str, Any]:
    system, reference = findings.subject.systems[0], findings.reference
    n, states = system.n, system.states
    return {
        "name": findings.name, "n": system.n, "m": system.m, "h": system.h, "t_end": findings.options.t_end,
        "settings": {name: dict(numbers) for name, numbers in findings.options.settings.items()},
        "units": dict(findings.subject.model.units),
        "x_start": findings.start[:n].tolist(), "v_start": findings.start[n : 2 * n].tolist(),
        "states_start": dict(zip(states, findings.start[2 * n :].tolist(), strict=True)),
        "rows": len(reference.t),
        "norm": "max over coordinates and states of |x - x_ref| / (1 + |x_ref|)",
        "reference": {"how": reference.how, "error_end": float(reference.errors[-1]),
                      "error_max": float(reference.errors.max()), "x_end": reference.x[-1, :n].tolist(),
                      "v_end": reference.v[-1].tolist(),
                      "states_end": dict(zip(states, reference.x[-1, n:].tolist(), strict=True))},
        "derivation_seconds": findings.subject.derivation,
        "formulations": [_built(built) for built in findings.subject.built],
        "left_out": dict(findings.absent), "tolerances_left_out": dict(findings.skipped),
        "measurements": [asdict(m) | {"ns_per_rhs": m.ns_per_rhs} for m in findings.measurements],
        "curves": [_curve(curve, findings) for curve in findings.curves],
        "recommendation": _recommendation(findings.recommendation),
    }  # fmt: skip


def _built(built: Built) -> dict[str, Any]:
    system = built.system
    return {
        "formulation": built.formulation,
        "refused": built.refused or None,
        "n_state": None if system is None else system.n_state,
        "left_out": [] if system is None else list(system.left_out),
        "generation_seconds": built.generation,
        "compilation_seconds": built.compilation,
    }


def _curve(curve: Curve, findings: Findings) -> dict[str, Any]:
    cost = curve.cost()
    return {
        "family": curve.family, "formulation": curve.formulation, "method": curve.method, "label": curve.label,
        "order": curve.order(findings.floor),
        "seconds_per_call": cost and cost[0], "seconds_per_rhs": cost and cost[1],
        "seconds_to_reach": {f"{level:.0e}": curve.seconds_at(level) for level in LEVELS},
    }  # fmt: skip


def _recommendation(advice: Recommendation) -> dict[str, Any]:
    return {
        "asked": advice.requested,
        "chosen": advice.chosen and asdict(advice.chosen),
        "as_fast": [asdict(m) for m in advice.as_fast],
        "closest": advice.closest and asdict(advice.closest),
    }
