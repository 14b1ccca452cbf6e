"""The verifier is itself verified: no false variant of any claim comes out PROVED or ENCLOSED."""

import json
from collections.abc import Callable

import pytest

from tresym.commands import main
from tresym.dev.mutants.mutants import Mutant, line_of, places_of, why_few
from tresym.dev.mutants.report import MutantReport, verify_mutants
from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.judge import judge
from tresym.ledger.paper import Paper, all_claims
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.slow
Stated = Callable[[str], Paper]


SAMPLE = ("eq_gamma", "range_of_gamma", "d12", "unique_root", "contraction", "d54")
SAMPLE += ("table_str_order", "d11", "flat_from_above", "implicit_defect")


def check(score: MutantReport, share: float = 0.95) -> None:
    """No mutant holds, and nearly all are refuted with a witness."""
    assert [*score.survivors, *score.stopped] == []
    assert score.counts["REFUTED"] >= share * sum(score.counts.values())


def test_no_mutant_of_a_few_claims_holds() -> None:
    score = verify_mutants(SAMPLE, wanted=1)
    assert all(row.total for row in score.rows)
    check(score, 0.9)


PARTS = [pytest.param(part, marks=pytest.mark.night) for part in range(8)]


@pytest.mark.filterwarnings("default::pytest.PytestUnraisableExceptionWarning")  # see time_limit
@pytest.mark.parametrize("part", PARTS)
def test_no_mutant_holds(part: int) -> None:
    """Every sixth claim, in eight parts; `tresym verify --mutants` takes them all."""
    labels = [claim.label for claim in all_claims()][part * 6 :: 48]
    check(verify_mutants(labels, wanted=1), 0.9)


def claims(of: Paper) -> dict[str, Claim]:
    return {claim.label: claim for claim in of.all_claims()}


def found(claim: Claim, *users: Claim, place: str = "") -> list[Mutant]:
    """Every variant of a claim at the places whose names begin so."""
    places = [p for p in places_of(claim, users) if p.name.startswith(place)]
    return [mutant for p in places for changed in p.mutants for mutant in changed]


def test_mutants_are_the_same_in_every_run(stated: Stated) -> None:
    (claim,) = stated("x real\nc: sin(x)**2 == 1 - cos(x)**2 given x > 0").all_claims()
    first, second = ([(m.place, m.change) for m in found(claim)] for _ in range(2))
    assert first == second
    assert len(first) > 20
    assert all(str(m.claim.says) != str(claim.says) for m in found(claim, place="side"))


def test_only_what_is_seen_to_be_false_counts(stated: Stated) -> None:
    stated("x real\nbound: x**2 + 1 >= 0")
    report = verify_mutants(["bound"], 40)
    (row,) = report.rows
    assert report.counts["REFUTED"] == row.total > 0
    aside = {slip.change for verdict, slip in row.aside if verdict == "PROVED"}
    assert "> in place of >=" in aside
    assert report.aside["PROVED"] >= len(aside)


DEFINED = """a, b, x, y real
let new: x := a + b
square: x**2 == a**2 + 2*a*b + b**2 using new
let unused: y := a
"""


def test_a_definition_is_changed_where_others_prove_something_by_it(stated: Stated) -> None:
    by_label = claims(stated(DEFINED))
    new, square, unused = (by_label[label] for label in ("new", "square", "unused"))
    assert found(new) == []
    assert why_few(unused).startswith("nothing is proved")
    held = {"new": judge(new, {})}
    assert judge(square, held).verdict is Verdict.PROVED
    mutants = found(new, square)
    assert len(mutants) >= 5
    for mutant in mutants[:8]:
        assert mutant.place == "in square"
        assert judge(mutant.claim, held).verdict is Verdict.UNDECIDED  # it names another "new"
        changed = {"new": Finding(Premise.DEFINED, "changed")}
        assert judge(mutant.claim, changed).verdict is Verdict.REFUTED
    report = verify_mutants(["new", "unused"], 5)
    check(report, 1)
    assert [row.label for row in report.few] == ["unused"]
    assert report.as_json()["few"][0]["why"].startswith("nothing is proved")


ROOT = """x, y real
one_root: exactly one x in (0, 1): x == 1/2
let middle: y := root of one_root
below: y < 2/3 and y > 1/3 using middle
"""


def test_a_root_is_another_one_if_its_equation_is_changed(stated: Stated) -> None:
    stated(ROOT)
    report = verify_mutants(["middle"], 5)
    assert report.counts["REFUTED"] > 0
    assert report.survivors == report.stopped == ()


BOTH = "x, y real\none: x - x/2 == x/2\ntwo: y - y/2 == y/2\nboth: one and two\n"


def test_a_conjunction_has_its_parts_changed(stated: Stated) -> None:
    both = claims(stated(BOTH))["both"]
    mutants = found(both)
    assert {m.place for m in mutants} == {"part one", "part two"}
    assert all(m.part is not None for m in mutants)
    (row,) = verify_mutants(["both"], 6).rows
    assert row.counts["REFUTED"] == row.total >= 6


def test_a_refuted_claim_is_changed_with_its_point_and_without(stated: Stated) -> None:
    (false,) = stated(
        "x real\nc: sin(x) <= x/2 given x > 0 expect refuted at x == 1/2"
    ).all_claims()
    places = places_of(false)
    assert all(len(changed) == 2 for place in places[:2] for changed in place.mutants)
    report = verify_mutants(["c"], 4)
    assert report.counts["REFUTED"] >= 4
    assert report.survivors == report.stopped == ()


STEPS = "x real\nc: x == x + x - x == x given x > 0\n"


def test_a_false_step_proves_nothing_true(stated: Stated) -> None:
    (claim,) = stated(STEPS).all_claims()
    steps = found(claim, place="step")
    assert steps
    for mutant in steps[:6]:
        assert mutant.step is not None
        if judge(mutant.step, {}).verdict is Verdict.REFUTED:
            assert not judge(mutant.claim, {}).verdict.holds


DENIED = """x real
ground: x + x == 2*x given x > 0
denied: in words, from ground expect refuted at x == 1
> says: Nothing is twice as large as another thing.
"""


def test_a_denial_by_what_is_false_denies_nothing(
    monkeypatch: pytest.MonkeyPatch, stated: Stated
) -> None:
    denied = claims(stated(DENIED))["denied"]
    mutants = found(denied)
    assert mutants
    for mutant in mutants[:3]:
        assert mutant.part is not None
        held = {"ground": judge(mutant.part.claim, {})}
        if held["ground"].verdict is Verdict.REFUTED:
            assert judge(mutant.claim, held).verdict is Verdict.UNDECIDED
    assert verify_mutants(["denied"], 2).survivors == ()


def test_the_conditions_of_a_claim_are_changed(stated: Stated) -> None:
    (root,) = stated("x, a real\nroot: sqrt(x**2) == x given x > 0, a > 0").all_claims()
    assert {m.change for m in found(root, place="conditions")} == {
        "nothing in place of x > 0",
        "nothing in place of a > 0",
    }
    (row,) = verify_mutants(["root"], 9).rows
    assert row.counts["REFUTED"] == row.total
    assert ("PROVED", "nothing in place of a > 0") in {(v, s.change) for v, s in row.aside}


def test_moved_digits_count_only_where_no_inputs_give_them(stated: Stated) -> None:
    stated("p real\nn: p/3 ~= 0.33 given p ~= 1.0")
    (row,) = verify_mutants(["n"], 20).rows
    assert row.counts["REFUTED"] == row.total > 5
    assert "0.34 in place of 0.33" in {slip.change for _, slip in row.aside}


@pytest.mark.parametrize("order", ["O(x)", "O(x**3)", "o(x**2)"])
def test_orders_are_changed_only_to_false_ones(order: str, stated: Stated) -> None:
    stated(f"x real\nc: sin(x) - x == {order} as x -> 0+")
    report = verify_mutants(["c"], 6)
    assert report.counts["REFUTED"] > 0
    check(report)


@pytest.mark.parametrize("label", ["eps0_smooth", "no_single_constant", "one_turn"])
def test_refuted_orders_instances_and_slopes_are_changed(label: str) -> None:
    report = verify_mutants([label], 2)
    assert report.survivors == report.stopped == ()
    assert sum(report.counts.values()) >= 2


def test_evidence_that_takes_too_long_is_not_believed(
    monkeypatch: pytest.MonkeyPatch, stated: Stated
) -> None:
    def slow(claim: Claim, found: object, evidence: object = None) -> Finding:
        while True:
            pass

    stated("x real\nc: x**2 == x*x given x > 0")
    monkeypatch.setattr("tresym.dev.mutants.report.SECONDS", 0.02)
    monkeypatch.setattr("tresym.dev.mutants.report._once", {})
    monkeypatch.setattr("tresym.dev.mutants.report.judge", slow)
    (row,) = verify_mutants(["c"], 1).rows
    assert row.total == row.counts["REFUTED"] > 0


def test_a_verifier_that_believes_everything_is_caught(
    monkeypatch: pytest.MonkeyPatch, stated: Stated
) -> None:
    def gullible(claim: Claim, found: object, evidence: object = None) -> Finding:
        return Finding(Verdict.PROVED, "it looks right")

    stated("x real\nc: x**2 == x*x given x > 0")
    monkeypatch.setattr("tresym.dev.mutants.report.judge", gullible)
    monkeypatch.setattr("tresym.dev.mutants.report._once", {})
    assert len(verify_mutants(["c"], 4).survivors) > 3
    assert main(["verify", "--mutants", "c"]) == 1


def test_the_command_prints_the_score(capsys: pytest.CaptureFixture[str], stated: Stated) -> None:
    stated("x real\nc: x**2 == x*x given x > 0")
    assert main(["verify", "--mutants", "c"]) == 0
    shown = capsys.readouterr().out
    assert "none passed" in shown
    assert "more changes are false" in shown
    assert main(["verify", "--mutants", "c", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["survivors"] == []
    assert printed["counts"]["REFUTED"] >= 5


def test_a_line_is_read_as_it_stands() -> None:
    by_label = {claim.label: claim for claim in all_claims()}
    for label in ("d12", "flip_defect", "repaired", "table_str_a", "d24"):
        again, claim = line_of(label).read(), by_label[label]
        assert (again.says, again.given, again.expect) == (claim.says, claim.given, claim.expect)
