"""Public names: `import eigenmotion` and `from eigenmotion import *` give those of docs/api.md."""

import re
from pathlib import Path

import eigenmotion as em

API = Path(__file__).parents[2] / "docs" / "api.md"


def test_all_public_names_are_in_the_documentation():
    said = set(
        re.findall(r"^\.\. (?:auto\w+|py:data):: eigenmotion\.(\w+)$", API.read_text(encoding="utf-8"), re.MULTILINE)
    )
    drawing = {"draw"}  # a module, documented as that: eigenmotion.codegen.model.statement.draw
    assert "automodule:: eigenmotion.codegen.model.statement.draw" in API.read_text(encoding="utf-8")
    assert said | drawing == set(em.__all__)


def test_a_star_gives_them_all():
    found = {}
    exec("from eigenmotion import *", found)
    assert found["Model"] is em.Model
    assert set(em.__all__) <= set(found)
    assert set(em.__all__) <= set(dir(em))
