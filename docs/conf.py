"""Configuration of the site for Sphinx: `make docs`."""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "making"))  # the site's own extensions

project = "eigenmotion"
author = copyright = "eigenmotion developers"
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_click",
    "sphinx_copybutton",
    "docstrings",
    "gallery",
    "live",
]
exclude_patterns = ["making", "made", "_static"]

myst_enable_extensions = ["colon_fence", "attrs_inline"]
myst_heading_anchors = 3
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True

default_role = "code"
highlight_language = "none"  # drawings of mechanisms are no Python
smartquotes = False  # quotes and dashes are code more often than not
autosummary_generate = False  # tables only: api.md documents everything itself
autodoc_member_order = "bysource"
autodoc_typehints = "none"
maximum_signature_line_length = 88
python_use_unqualified_type_names = True
toc_object_entries_show_parents = "hide"

html_theme = "furo"
html_title = "eigenmotion"
html_logo = html_favicon = "_static/logo.svg"
html_static_path = ["_static"]
html_css_files = ["site.css"]

html_copy_source = False
html_show_sphinx = False
html_extra_path = [str(HERE / "made" / "extra")] if (HERE / "made" / "extra").is_dir() else []
