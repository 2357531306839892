"""All cases, by name."""

from . import charts, degenerate, kinks, places, scenes, spans

CASES = {
    case.name: case
    for case in (*scenes.CASES, *charts.CASES, *kinks.CASES, *places.CASES, *degenerate.CASES, *spans.CASES)
}
