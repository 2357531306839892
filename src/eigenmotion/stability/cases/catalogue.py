"""All cases, by name."""

from . import bearings, charts, cones, contacts, degenerate, kinks, singular_positions, spans, stiffness

CASES = {
    case.name: case
    for case in (
        *stiffness.CASES,
        *charts.CASES,
        *kinks.CASES,
        *singular_positions.CASES,
        *degenerate.CASES,
        *spans.CASES,
        *contacts.CASES,
        *bearings.CASES,
        *cones.CASES,
    )
}
