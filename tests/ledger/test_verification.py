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
from sympy_statements import equal

from tresym import proofs
from tresym.ledger.claim import (
    Chain,
    Claim,
    Root,
    Step,
)
from tresym.ledger.conversion import put_in
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import binders_in, is_equation, mapped, relations_of, sides_of
from tresym.ledger.paper import all_claims, racket
from tresym.ledger.verification import Report, Row, graph, verify
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.compound import Somewhere
from tresym.reals.language.to_sympy import to_sympy
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


def parts(claim: Claim) -> list[tuple[Any, Chain]]:
    """The chains of a claim with what each must show."""
    steps = claim.proof.steps if isinstance(claim.proof, Decided) else ()
    return list(zip(claim.parts, steps, strict=True)) if steps else []


@pytest.mark.slow
def test_refuted_claims_are_amended_by_claims_that_hold(ledger: Report) -> None:
    for claim in CLAIMS:
        if claim.expect is Verdict.REFUTED:
            assert claim.amended_by, claim.label
            found = ledger[claim.label].finding
            without = (
                found.why == "violated at the constants themselves"  # no variable is free
                or isinstance(claim.means, Somewhere)  # it fails everywhere
            )
            assert found.witness or without, claim.label
            for amendment in claim.amended_by:
                assert ledger[amendment.label].finding.verdict.holds


@pytest.mark.slow
def test_a_label_loads_the_files_in_which_it_is_written_and_no_others() -> None:
    code = """if True:
        import sys
        from tresym import verify
        from tresym.papers import ledger_claims
        read, loaded = ledger_claims.read_part, []
        def noted(path, *others):
            loaded.append(path.stem)
            return read(path, *others)
        ledger_claims.read_part = noted
        print(*(row.claim.label for row in verify("eq_gamma").rows))
        print(*loaded, *(name for name in sys.modules if name.startswith("tresym.proofs.")))
    """
    said = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True
    )
    labels, loaded = said.stdout.splitlines()
    assert labels.split() == [row.claim.label for row in verify(["eq_gamma"]).rows]
    assert {"euler_angles", "conditions", "tresym.proofs.axioms"} <= {*loaded.split()}
    assert "turning" not in loaded
    assert "figures" not in loaded


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


def links(says: Any, chain: Chain) -> list[tuple[Any, Any, Step]]:
    """Every step with the expressions before and after it."""
    reached = [says.left, *(says.right if x.expression is None else x.expression for x in chain)]
    return list(zip(reached, reached[1:], chain, strict=False))


def beyond_sympy(*sides: Any) -> bool:
    """Whether there is an integral, at which SymPy may look for ever, or a root of an equation."""
    return any(node.op in ("integral", "root") for node in binders_in(*sides_of(sides)))


LARGEST_SIMPLIFIED = 60
"""Differences of more operations are left to the points: simplify would take minutes."""

EVERY = 5
"""SymPy, which is slow, gets each fifth step in every run, and all of them every night."""

ALL_STEPS = [
    (f"{claim.label}-{part}-{s}", claim, before, after, link)
    for claim in CLAIMS
    for part, (says, chain) in enumerate(parts(claim))
    if is_equation(says)
    for s, (before, after, link) in enumerate(links(says, chain))
    if not beyond_sympy(before, after)
]
STEPS = [
    pytest.param(*step, id=name, marks=pytest.mark.night if n % EVERY else ())
    for n, (name, *step) in enumerate(ALL_STEPS)
]


@pytest.mark.slow
@pytest.mark.parametrize(("claim", "before", "after", "link"), STEPS)
def test_sympy_does_not_disagree(claim: Claim, before: Any, after: Any, link: Step) -> None:
    """SymPy alone, without our decision procedure: its simplifier, and both sides at a few points.

    Half of the differences it cannot simplify to 0; none may come out as another number.
    """
    named = [c for reason in link.reasons for c in reason.claims]
    used = named if link.reasons else claim.proof.put
    equations = (part for c in used for part in filter(is_equation, c.parts))
    rules = {r.left: r.right for part in equations for r in relations_of(part)}
    pairs = zip(sides_of(before), sides_of(after), strict=True)
    between = (end for c in claim.rests_on if isinstance(c.proof, Root) for end in c.parts[1:])
    conditions = [mapped(c, lambda e: put_in(e, rules)) for c in (*claim.given, *between)]
    given = Given(
        tuple((c.left, c.sign, c.right) for c in conditions if elementary(c.left, c.right))
    )
    for pair in pairs:
        left, right = (put_in(side, rules) for side in pair)
        if beyond_sympy(left, right):  # brought in by a definition
            continue
        stated = to_sympy(left) - to_sympy(right)
        difference = stated.doit()
        if difference.count_ops() <= LARGEST_SIMPLIFIED:
            simplified = sympy.simplify(difference)
            assert simplified == 0 or not simplified.is_number
        names = sorted({s.name for s in difference.free_symbols})
        for point in list(given.points(names, 3)):
            values = {
                sympy.Symbol(n, real=True): sympy.Rational(int(v.p), int(v.q))
                for n, v in point.items()
            }
            assert abs(sympy.N(difference.subs(values), 40)) < sympy.Float("1e-30")


def test_no_statement_says_the_same_twice() -> None:
    """Both sides of no equation are the same expression, in each entry of a matrix."""
    same = set()
    for claim in CLAIMS:
        for part in filter(is_equation, claim.parts):
            same |= {claim.label for r in relations_of(part) if r.left == r.right}
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


def test_a_claim_that_should_hold_is_no_check_of_sharpness() -> None:
    """Only what is false on purpose is counted as one."""
    false = next(c for c in CLAIMS if c.expect is Verdict.REFUTED and not c.where)
    found = Finding(Verdict.REFUTED, "")
    for expected, count in ((Verdict.REFUTED, 1), (Verdict.PROVED, 0)):
        report = Report((Row(replace(false, expect=expected), found),))
        assert sum(report.refuted.values()) == count
