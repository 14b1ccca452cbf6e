"""The ledger: one test per claim, one per reason, and the second opinion of SymPy."""

import ast
import importlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy
from hangs import HANGS

from tresym import proofs
from tresym.ledger.claim import (
    Chain,
    Claim,
    Root,
    Step,
    equal,
)
from tresym.ledger.conversion import Conditions, formula
from tresym.ledger.conversion import conditions as relations
from tresym.ledger.counterexamples import put_in, rules_of
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.paper import all_claims, racket
from tresym.ledger.statements import ForSome
from tresym.ledger.verification import Report, graph, verify
from tresym.reals.domain.conditions import Given
from tresym.reals.language.formula import relations as comparisons
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.pages.ledger_rows import report_json

CLAIMS = all_claims()


@pytest.fixture(scope="session")
def ledger(whole: Report) -> Report:
    return whole


@pytest.mark.slow
@pytest.mark.parametrize("claim", CLAIMS, ids=lambda c: c.label)
def test_verdict(claim: Claim, ledger: Report) -> None:
    row = ledger[claim.label]
    assert row.as_expected, f"{row.finding.verdict.value}: {row.finding.why}"


def test_a_claim_is_listed_where_it_is_stated() -> None:
    """By the file that assigns it: one that only imports it does not state it."""
    stated = dict(zip(proofs.PARTS, (claims for _, claims in proofs.parts()), strict=True))
    for part, claims in stated.items():
        if racket().source_of(part).suffix != ".py":
            continue
        source = Path(str(importlib.import_module(f"tresym.proofs.{part}").__file__))
        tree = ast.parse(source.read_text(encoding="utf-8"))
        froms = [node for node in tree.body if isinstance(node, ast.ImportFrom)]
        taken = {alias.asname or alias.name for node in froms for alias in node.names}
        here = [
            v for name, v in vars(sys.modules[f"tresym.proofs.{part}"]).items() if name not in taken
        ]
        several = {
            c for v in here for c in (v if isinstance(v, tuple) else (v,)) if isinstance(c, Claim)
        }
        assert set(claims) <= several, part
    assert "turn_to_the_middle" in {c.label for c in stated["on_the_separatrix"]}
    assert sum(map(len, stated.values())) == len(CLAIMS)


def parts(claim: Claim) -> list[tuple[sympy.Basic, Chain]]:
    """The chains of a claim with what each must show."""
    steps = claim.proof.steps if isinstance(claim.proof, Decided) else ()
    return list(zip(claim.parts, steps, strict=True)) if steps else []


def conditions(claim: Claim) -> Conditions:
    return relations(claim.given)


@pytest.mark.slow
def test_refuted_claims_are_amended_by_claims_that_hold(ledger: Report) -> None:
    for claim in CLAIMS:
        if claim.expect is Verdict.REFUTED:
            assert claim.amended_by, claim.label
            found = ledger[claim.label].finding
            without = (
                found.why == "violated at the constants themselves"  # no variable is free
                or isinstance(claim.means, ForSome)  # it fails everywhere
            )
            assert found.witness or without, claim.label
            for amendment in claim.amended_by:
                assert ledger[amendment.label].finding.verdict.holds


@pytest.mark.slow
def test_a_label_loads_the_files_in_which_it_is_written_and_no_others() -> None:
    code = """if True:
        import sys
        from tresym import verify
        print(*(row.claim.label for row in verify("eq_gamma").rows))
        print(*(name for name in sys.modules if name.startswith("tresym.proofs.")))
    """
    said = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True
    )
    labels, loaded = said.stdout.splitlines()
    assert labels.split() == [row.claim.label for row in verify(["eq_gamma"]).rows]
    assert "tresym.proofs.conditions" in loaded
    assert "tresym.proofs.turning" not in loaded


def test_claims_are_the_same_however_many_files_are_loaded() -> None:
    for claim in CLAIMS[:: len(CLAIMS) // 40]:
        some = all_claims([claim.label])
        assert claim in some
        assert set(claim.rests_on) < set(some) <= set(CLAIMS)


def test_twins_in_two_files_are_both_loaded_and_an_unknown_label_loads_all() -> None:
    # ``eq_gamma`` is taken by name in several files, and written in one.
    assert proofs.written_in(["eq_gamma"]) == ("euler_angles",)
    assert set(proofs.written_in(["eq_gamma", "eps0"])) > {"euler_angles"}
    assert all_claims(["eq_gamma", "no_such_label"]) == CLAIMS
    assert all_claims(["sqrt"]) == CLAIMS


@pytest.mark.slow
def test_a_claim_is_verified_with_all_it_rests_on(ledger: Report) -> None:
    report = verify(["eq_gamma"])
    labels = [row.claim.label for row in report.rows]
    assert labels[-1] == "eq_gamma"
    assert "eq_Mi" in labels
    assert [row.claim.label for row in report.rows if row.requested] == ["eq_gamma"]


def test_an_unknown_label_is_answered_with_the_nearest() -> None:
    with pytest.raises(InputError, match="did you mean eq_gamma"):
        verify(["eq_gama"])


def test_the_graph_names_every_claim() -> None:
    text = graph()
    assert text.startswith("flowchart")
    assert all(f'["{claim.label}"]' in text for claim in CLAIMS)


@pytest.mark.slow
def test_a_claim_resting_on_a_refuted_one_is_undecided(ledger: Report) -> None:
    from tresym.ledger.judge import judge, judge_evidence

    a, b = sympy.symbols("a b", real=True)
    wrong = Claim("wrong", equal(a, b), Decided())
    heir = Claim("heir", equal(a + 1, b + 1), Decided((wrong,)))
    found = {"wrong": judge(wrong, {})}
    assert found["wrong"].verdict is Verdict.REFUTED
    assert judge(heir, found).verdict is Verdict.UNDECIDED
    # Evidence that was looked at in another process changes nothing in this.
    evidence = judge_evidence(heir)
    assert evidence is not None
    assert evidence.stopped  # the chain follows, and the advocate believes nothing that it cites
    assert judge(heir, found, evidence).verdict is Verdict.UNDECIDED


def links(says: sympy.Eq, chain: Chain) -> list[tuple[sympy.Basic, sympy.Basic, Step]]:
    """Every step with the expressions before and after it."""
    reached = [says.lhs, *(says.rhs if x.expression is None else x.expression for x in chain)]
    return list(zip(reached, reached[1:], chain, strict=False))


LARGEST_SIMPLIFIED = 60
"""Differences of more operations are left to the points: simplify would take minutes."""

EVERY = 5
"""SymPy, which is slow, gets each fifth step in every run, and all of them every night."""

ALL_STEPS = [
    (f"{claim.label}-{part}-{s}", claim, before, after, link)
    for claim in CLAIMS
    for part, (says, chain) in enumerate(parts(claim))
    if isinstance(says, sympy.Eq)
    for s, (before, after, link) in enumerate(links(says, chain))
    if not before.has(sympy.Integral) and not after.has(sympy.Integral)
]
STEPS = [
    pytest.param(*step, id=name, marks=pytest.mark.night if n % EVERY else ())
    for n, (name, *step) in enumerate(ALL_STEPS)
]


@pytest.mark.slow
@pytest.mark.parametrize(("claim", "before", "after", "link"), STEPS)
def test_sympy_does_not_disagree(
    claim: Claim, before: sympy.Basic, after: sympy.Basic, link: Step
) -> None:
    """SymPy alone, without our decision procedure: its simplifier, and both sides at a few points.

    Half of the differences it cannot simplify to 0; none may come out as another number.
    """
    named = [c for reason in link.reasons for c in reason.claims]
    rules = rules_of(named if link.reasons else claim.proof.put)
    pairs = zip(sympy.flatten([before]), sympy.flatten([after]), strict=True)
    between = (end for c in claim.rests_on if isinstance(c.proof, Root) for end in c.says.args[1:])
    conditions = [put_in(condition, rules) for condition in (*claim.given, *between)]
    given = [c for c in conditions if not c.has(sympy.Derivative, sympy.Integral)]
    for left, right in pairs:
        stated = put_in(left, rules) - put_in(right, rules)
        if stated.has(sympy.Integral):  # brought in by a definition; SymPy may look for ever
            continue
        difference = stated.doit()
        if difference.count_ops() <= LARGEST_SIMPLIFIED:
            simplified = sympy.simplify(difference)
            assert simplified == 0 or not simplified.is_number
        names = sorted({s.name for s in difference.free_symbols})
        for point in list(Given.from_sympy(*given).points(names, 3)):
            values = {
                sympy.Symbol(n, real=True): sympy.Rational(int(v.p), int(v.q))
                for n, v in point.items()
            }
            assert abs(sympy.N(difference.subs(values), 40)) < sympy.Float("1e-30")


def test_no_statement_says_the_same_twice() -> None:
    """SymPy works out what it can: `at` and `product` leave something to decide, in each entry."""
    same = set()
    for claim in CLAIMS:
        for part in claim.parts:
            if isinstance(part, sympy.core.relational.Relational):
                entries = (r for r in comparisons(formula(part)) if r.sign == "==")
                same |= {claim.label for r in entries if r.left == r.right}
    assert same == set()


def test_replacing_evidence_keeps_the_label() -> None:
    assert replace(CLAIMS[0], note="x").label == CLAIMS[0].label


SEEDED = (
    *("eq_gamma", "jacobi_solutions", "eq_borne_theta", "eq_depsdgamma_form", "table_racket_3_a"),
    *("three_equilibria", "symmetric_maximum", "tangent_below"),
)
"""Claims of many kinds of evidence, with all that they rest on."""


@pytest.mark.slow
def test_verdicts_do_not_hang_on_the_order_of_sets(judged: Callable[..., Report]) -> None:
    """Bit for bit the same with any PYTHONHASHSEED and any number of processes, times apart."""
    command = [sys.executable, "-m", "tresym", "verify", "--json", "--workers", "3", *SEEDED]
    environment = {**os.environ, "PYTHONHASHSEED": "271828"}
    run = subprocess.run(command, env=environment, capture_output=True, timeout=HANGS, check=False)
    here = json.loads(json.dumps(report_json(judged(*SEEDED))))
    assert _without_times(json.loads(run.stdout)) == _without_times(here)
    assert len(here["claims"]) > 30


def _without_times(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: _without_times(v) for k, v in value.items() if k != "seconds"}
    return [_without_times(v) for v in value] if isinstance(value, list) else value
