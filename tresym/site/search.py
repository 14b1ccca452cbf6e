"""Order the results of the site's search by what a reader most likely looks for.

Sphinx finds the pages that contain the words and orders them by where the words stand. This module
adds two things. A word or phrase of ``FIRST``, a name or a place of a claim leads to its page
first: ``Theorem 6.1`` to the main theorem, ``eps0`` to the definition of ε₀. And pages that list
everything, such as the corrections, stand after pages about one thing.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

FIRST = {
    "remainder": "claims/d24",
    "error term": "claims/d24",
    "main theorem": "claims/prop1",
    "theorem": "claims/prop1",
    "theorem 6.1": "claims/prop1",
    "eps0": "claims/flip_defect",
    "epsilon0": "claims/flip_defect",
    "flip defect": "claims/flip_defect",
    "defect": "claims/flip_defect",
    "exponentially small": "claims/remark1",
    "tennis racket": "pages/theory",
    "stirling": "pages/integrals-and-sums",
    "laplace": "pages/integrals-and-sums",
    "watson": "pages/integrals-and-sums",
    "factorial": "pages/integrals-and-sums",
    "integral": "pages/integrals-and-sums",
    "sum": "pages/integrals-and-sums",
    "series": "pages/integrals-and-sums",
    "root": "pages/asymptotics",
    "differential equation": "pages/asymptotics",
    "boundary layer": "pages/layers",
    "averaging": "pages/layers",
    "secular term": "pages/layers",
    "expansion": "pages/asymptotics",
    "error table": "pages/how-good-is-my-formula",
    "table": "pages/how-good-is-my-formula",
    "constant": "pages/how-good-is-my-formula",
    "check": "pages/deciding",
    "limit": "pages/deciding",
    "identity": "pages/deciding",
    "inequality": "pages/deciding",
    "latex": "pages/your-manuscript",
    "manuscript": "pages/your-manuscript",
    "misprint": "pages/your-manuscript",
    "bibtex": "pages/tutorial-cite",
    "cite": "pages/tutorial-cite",
    "mcp": "pages/editors-and-ci",
    "editor": "pages/editors-and-ci",
    "install": "pages/tutorial",
    "coq": "pages/coq",
    "function": "pages/functions",
    "syntax": "pages/claim-grammar",
    "grammar": "pages/claim-grammar",
    "verdict": "pages/verdicts",
    "proved": "pages/verdicts",
    "undecided": "pages/verdicts",
    "python": "pages/api",
    "racket": "pages/tutorial",
}
"""The page that a reader most likely wants, by what is typed in small letters."""

LISTS = (
    "generated/corrections",
    "pages/coq",
    "pages/symbols",
    "pages/trust",
    "pages/api-check",
    "pages/api-ledger",
    "pages/api-racket",
    "pages/api-formulas",
    "reference/commands",
    "claims/index",
    "claims/the-paper",
    "claims/quoted-theorems",
)
"""Pages that contain nearly every word."""

_SCRIPT = """\
// Written by tresym.site.search when the site is built.
const FIRST = %s;
const LISTS = new Set(%s);
const asked = (new URLSearchParams(location.search).get("q") ?? "").toLowerCase().trim();
const wanted = FIRST[asked.replaceAll(/\\s+/g, " ")] ?? FIRST[asked.replaceAll(" ", "_")];
var Scorer = {
  score: ([page, title, anchor, description, score]) => {
    const words = asked.split(/\\s+/).filter(Boolean);
    const named = words.length && words.every((word) => title.toLowerCase().includes(word));
    return score + (page === wanted && !anchor ? 1000 : 0) + (named ? 20 : 0)
      + (page.startsWith("pages/") ? 5 : 0) - (LISTS.has(page) ? 30 : 0);
  },
  objNameMatch: 11, objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 }, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
"""


def wanted_pages(claims: dict[str, Any]) -> dict[str, str]:
    """Return the page that is shown first, by what is typed: names and places of claims, and FIRST.

    Args:
        claims: the claims of the ledger by label, with their ``alias`` and ``place``.
    """
    found: dict[str, str] = {}
    for label, claim in claims.items():
        for name in (label, claim["alias"], claim["place"]):
            if name:
                found.setdefault(name.lower(), f"claims/{label}")
    return found | FIRST


def words_that_lead_to(page: str) -> list[str]:
    """Return the words of ``FIRST`` that lead to a page, which must contain them to be found."""
    return [words for words, wanted in FIRST.items() if wanted == page]


def write_scorer(path: Path, claims: dict[str, Any]) -> None:
    """Write the script by which the site's search orders its results."""
    text = _SCRIPT % (json.dumps(wanted_pages(claims), ensure_ascii=False), json.dumps(LISTS))
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")
