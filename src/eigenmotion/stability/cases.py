"""All cases, by name."""

from . import charts, places, scenes, spans

CASES = {case.name: case for case in (*scenes.CASES, *charts.CASES, *places.CASES, *spans.CASES)}
