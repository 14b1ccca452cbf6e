"""Quoted theorems: a claim lists its own and those of all that it rests on, each once."""

from derivations import by
from sympy import Symbol
from sympy_statements import equal

from tresym.ledger.axioms import RULES, Axiom
from tresym.ledger.claim import (
    Claim,
    Definition,
    all_of,
)
from tresym.ledger.finding import Finding
from tresym.ledger.reasons import citing
from tresym.ledger.verification import Report, Row
from tresym.reals.verdict import Verdict

x, y = (Symbol(name, real=True) for name in "xy")
ROOT = Axiom("a root", "It has a root.", "A book, Theorem 1")
BOUND = Axiom("a bound", "It has a bound.", "A book, Theorem 2", "x < 1")


def named(label: str, *rests_on: Claim, quotes: tuple[Axiom, ...] = ()) -> Claim:
    return Claim(label, equal(x, y), by(citing(*rests_on)), quotes=quotes)


BOTTOM = named("bottom", quotes=(ROOT,))
TOP = named("top", named("second", named("first", BOTTOM)))


def test_a_claim_lists_what_it_rests_on_through_three_others() -> None:
    assert BOTTOM.axioms == TOP.axioms == (ROOT,)
    assert TOP.quotes == ()
    assert named("apart").axioms == ()


def test_each_is_listed_once_and_foundations_first() -> None:
    both = Claim("both", "A sentence.", all_of(TOP, BOTTOM), quotes=(BOUND, ROOT))
    assert both.axioms == (ROOT, BOUND)


def test_what_stands_in_place_of_a_claim_is_not_what_it_rests_on() -> None:
    assert Claim("amended", equal(x, y), Definition(), amended_by=(TOP,)).axioms == ()


def test_a_report_knows_what_rests_on_each() -> None:
    found = Finding(Verdict.PROVED, "")
    report = Report(tuple(Row(claim, found) for claim in (BOTTOM, named("apart"), TOP)))
    assert report.axioms == {ROOT: (BOTTOM, TOP)}


def test_the_theorems_of_the_rules_say_which_rule_applies_them() -> None:
    assert len({axiom.name for axiom in RULES}) == len(RULES)
    assert all(axiom.rule and "Theorem" in axiom.source for axiom in RULES)
