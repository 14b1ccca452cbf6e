"""What is quoted is named: no docstring and no note leans on a theorem that no claim lists."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from cases import cases

from tresym.ledger.axioms import RULES, Axiom
from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.paper import all_claims

ROOT = Path(__file__).resolve().parent.parent.parent
FILES = (
    *(path for path in ROOT.glob("proofs/*.py") if path.name != "axioms.py"),
    *ROOT.glob("tresym/racket/bounds/*.py"),
    *ROOT.glob("tresym/racket/flip/*.py"),
)
CLAIMS = {claim.label: claim for claim in all_claims()}
QUOTED = tuple(dict.fromkeys(axiom for claim in CLAIMS.values() for axiom in claim.axioms))

NAMES = re.compile(
    r"theorem|lemma\b|concav|convex|lineari[sz]|double root|Grönwall|Picard|Lindelöf|Rouch|"
    r"Lagrange|Cauchy|Chebyshev|Taylor|Bessel|Liouville|Lyapunov|Jensen|Hölder|Weierstra|Hartman|Grobman|"
    r"Poincar|Noether|Sturm|Descartes|Darboux|Fubini|Banach|Brouwer|Kantorovich|Morse|Leibniz",
    re.IGNORECASE,
)
"""What theorems are called, and what they are about."""

THE_PAPERS = re.compile(
    r"[Tt]he theorem(?: of Section 6|: both|'s| as printed| repaired)|repaired theorem|"
    r"(?:up to|of|is|so is) the theorem\b"
)
"""The paper's own theorem, which is a claim and judged."""

SHOWN: dict[str, frozenset[str]] = {
    "convex": frozenset({"newton_from_below", "newton_side"}),
    "concav": frozenset({"arctangent_concave", "arsinh_concave"}),
    "chebyshev": frozenset({"mean_of_the_product"}),
    "lagrange": frozenset({"lagrange_step"}),
    "lineari": frozenset({"leaves_e2", "linear_at_e2"}),
    "lyapunov": frozenset({"energy_near_e1"}),
}
"""What a claim shows itself, by its word: who says the word is such a claim or rests on one."""


def unnamed(text: str, axioms: tuple[Axiom, ...], behind: frozenset[str]) -> list[str]:
    """The theorems that a text speaks of and that neither ``axioms`` nor claims ``behind`` give."""
    text = THE_PAPERS.sub("", text)
    words = (found.group().lower() for found in NAMES.finditer(text))
    known = " ".join(axiom.name for axiom in axioms if axiom.name.lower() in text.lower())
    named = " ".join(axiom.name.lower() for axiom in axioms)
    return [
        word
        for word in words
        if (word not in named if word not in ("theorem", "lemma") else word not in known)
        and not any(word.startswith(w) and labels & behind for w, labels in SHOWN.items())
    ]


def behind(claim: Claim) -> frozenset[str]:
    return frozenset(c.label for c in (claim, *claim.rests_on))


def sentences(claim: Claim) -> Iterator[str]:
    yield claim.note
    if isinstance(claim.says, str):
        yield claim.says


def test_a_note_names_no_theorem_that_its_claim_does_not_list() -> None:
    for label, claim in CLAIMS.items():
        allowed = (*claim.axioms, *RULES) if "implicit function" not in claim.note else claim.axioms
        if label not in SAY_THAT_IT_APPLIES:
            found = [w for text in sentences(claim) for w in unnamed(text, allowed, behind(claim))]
            assert found == [], label


SAY_THAT_IT_APPLIES = {
    "G_u_at_origin": "that it applies, which is all that is said",
    "dudlam": "how the paper has what is shown otherwise",
}
"""Claims that speak of a theorem and apply none."""


def test_a_docstring_names_no_theorem_that_no_claim_lists() -> None:
    for path in FILES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Expr(value=ast.Constant(value=str() as text)):
                    assert unnamed(text, (*QUOTED, *RULES), frozenset(CLAIMS)) == [], (path, text)


def test_the_prose_of_a_file_names_no_theorem_that_no_claim_lists() -> None:
    for path in ROOT.glob("proofs/*.tresym"):
        text = re.sub("^> fault: .*", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
        assert unnamed(text, (*QUOTED, *RULES), frozenset(CLAIMS)) == [], path


@pytest.mark.parametrize(
    "note",
    cases(__file__, "a_theorem_that_is_not_listed_is_found"),
)
def test_a_theorem_that_is_not_listed_is_found(note: str) -> None:
    claim = Claim("planted", "A sentence.", Definition(), note=note)
    assert unnamed(note, claim.axioms, behind(claim))


def test_no_identity_no_number_and_no_order_rests_on_a_quoted_theorem() -> None:
    assert {claim.kind for claim in CLAIMS.values() if claim.axioms} <= {"bound", "statement"}


def test_what_is_shown_is_shown_by_claims_of_the_ledger() -> None:
    assert frozenset().union(*SHOWN.values()) <= CLAIMS.keys()
    assert SAY_THAT_IT_APPLIES.keys() <= CLAIMS.keys()
