"""All cases, by name."""

from . import places, scenes, spans

CASES = {case.name: case for case in (*scenes.CASES, *places.CASES, *spans.CASES)}
