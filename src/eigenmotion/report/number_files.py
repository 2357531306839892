"""The numbers as JSON and CSV."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from ..presentation.tables import as_csv, as_json
from .examine import Findings
from .formulations import Built
from .measure import Measurement
from .recommend import LEVELS, Curve, Recommendation

_COLUMNS = tuple(field.name for field in fields(Measurement))


def record(reports: Sequence[Findings], known: Mapping[str, str]) -> str:
    """Write everything that was found as JSON; `known` of the machine."""
    return as_json({"machine": known, "models": [_model(found) for found in reports]})


def one_a_line(reports: Sequence[Findings]) -> str:
    """Write one line a measurement as CSV."""
    rows = (
        [found.name, *(getattr(m, name) for name in _COLUMNS), m.ns_per_rhs]
        for found in reports for m in found.measurements
    )  # fmt: skip
    return as_csv(["model", *_COLUMNS, "ns_per_rhs"], rows)


def _model(found: Findings) -> dict[str, Any]:
    system, reference = found.subject.systems[0], found.reference
    return {
        "name": found.name, "n": system.n, "m": system.m, "h": system.h, "t_end": found.ask.t_end,
        "settings": {name: dict(numbers) for name, numbers in found.ask.settings.items()},
        "x_start": found.start[: system.n].tolist(), "v_start": found.start[system.n :].tolist(),
        "rows": len(reference.t),
        "norm": "max over coordinates of |x - x_ref| / (1 + |x_ref|)",
        "reference": {"how": reference.how, "error_end": float(reference.errors[-1]),
                      "error_max": float(reference.errors.max()), "x_end": reference.x[-1].tolist(),
                      "v_end": reference.v[-1].tolist()},
        "derivation_seconds": found.subject.derivation,
        "formulations": [_built(built) for built in found.subject.built],
        "left_out": dict(found.absent), "tolerances_left_out": dict(found.skipped),
        "measurements": [asdict(m) | {"ns_per_rhs": m.ns_per_rhs} for m in found.measurements],
        "curves": [_curve(curve, found) for curve in found.curves],
        "recommendation": _recommendation(found.recommendation),
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


def _curve(curve: Curve, found: Findings) -> dict[str, Any]:
    cost = curve.cost()
    return {
        "family": curve.family, "formulation": curve.formulation, "method": curve.method, "label": curve.label,
        "order": curve.order(found.floor),
        "seconds_per_call": cost and cost[0], "seconds_per_rhs": cost and cost[1],
        "seconds_to_reach": {f"{level:.0e}": curve.seconds_at(level) for level in LEVELS},
    }  # fmt: skip


def _recommendation(advice: Recommendation) -> dict[str, Any]:
    return {
        "asked": advice.asked,
        "chosen": advice.chosen and asdict(advice.chosen),
        "as_fast": [asdict(m) for m in advice.as_fast],
        "closest": advice.closest and asdict(advice.closest),
    }
