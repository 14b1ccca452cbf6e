"""The site: ``sphinx-build -W -j 2 docs build/site`` judges the ledger first if it has changed."""

import json
from pathlib import Path

import tresym
from tresym.report.pages.documents import build_pages

_pages = build_pages()

project = "tresym"
author = "the tresym contributors"
copyright = "the tresym contributors"
version = release = tresym.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "tresym.site.extension",
]
root_doc = "index"
include_patterns = ["index.md", "pages/*", "claims/*", "atlas/*", "reference/*"]
include_patterns += ["generated/corrections.md"]
smartquotes = False
toc_object_entries = False
suppress_warnings = ["toc.empty_glob"]

myst_enable_extensions = [
    "attrs_inline",
    "colon_fence",
    "deflist",
    "dollarmath",
    "substitution",
]
myst_substitutions = json.loads((_pages / "numbers.json").read_text(encoding="utf-8"))
for _name in ("sweep", "errors_found"):
    _saved = Path(__file__).parent / "measurements" / f"{_name}.json"
    myst_substitutions |= json.loads(_saved.read_text(encoding="utf-8"))["notes"]["numbers"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {name: name for name in ("Angle", "ArrayLike", "Exact", "Floats")}
autodoc_default_options = {"members": True, "no-value": True}
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = "tresym"
html_static_path = ["_static", "_built"]
html_css_files = ["site.css"]
html_js_files = ["ledger.js", "atlas.js"]
html_math_renderer = "mathml"
html_search_scorer = str(Path(__file__).parent / "_built" / "scorer.js")
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
