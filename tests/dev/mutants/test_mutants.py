"""The verifier is itself verified: no false variant of any claim comes out PROVED or ENCLOSED."""

import json

import pytest
from flint import arb, fmpq
from sympy import Function, Ge, Integral, Symbol, Tuple, cos, exp, sin, sqrt, tan

from tresym.commands import main
from tresym.dev.mutants.mutants import mutants, why_few
from tresym.dev.mutants.mutations import mutations
from tresym.dev.mutants.report import MutantReport, verify_mutants
from tresym.ledger.ball_evaluation import value
from tresym.ledger.claim import (
    AllOf,
    Claim,
    Counterexample,
    Definition,
    Printed,
    by,
    equal,
)
from tresym.ledger.counterexamples import violation
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.reasons import roots, substituting, trigonometry
from tresym.ledger.statements import Rounds, order
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.slow

x, y, t, a, b = (Symbol(name, real=True) for name in "xytab")


SAMPLE = ("eq_gamma", "range_of_gamma", "d12", "unique_root", "contraction", "d54")
SAMPLE += ("table_str_order", "d11", "flat_from_above", "implicit_defect")


def check(score: MutantReport, share: float = 0.98) -> None:
    """No mutant holds, and nearly all are refuted with a witness."""
    assert [*score.survivors] == []
    assert score.counts["REFUTED"] >= share * sum(score.counts.values())


def test_no_mutant_of_a_few_claims_holds() -> None:
    score = verify_mutants(SAMPLE, wanted=1)
    assert all(row.total for row in score.rows)
    check(score)


PARTS = [0, *(pytest.param(part, marks=pytest.mark.night) for part in range(1, 8))]


@pytest.mark.filterwarnings("default::pytest.PytestUnraisableExceptionWarning")  # see time_limit
@pytest.mark.parametrize("part", PARTS)
def test_no_mutant_holds(part: int) -> None:
    """Every sixth claim, in eight parts; `tresym verify --mutants` takes them all.

    Of changed definitions by an integral not all are shown violated; they are UNDECIDED.
    """
    labels = [claim.label for claim in all_claims()][part * 6 :: 48]
    check(verify_mutants(labels, wanted=1), 0.95)


@pytest.mark.parametrize("label", ["eq_gamma", "range_of_gamma", "d54", "table_str_a"])
def test_a_claim_has_five_mutants_or_more(label: str) -> None:
    claim = next(c for c in all_claims() if c.label == label)
    assert len({(m.place, m.change) for m in mutants(claim, 5)}) >= 5


def test_mutants_are_the_same_in_every_run() -> None:
    claim = next(c for c in all_claims() if c.label == "eq_gamma")
    first, second = ([(m.place, m.change) for m in mutants(claim, 3)] for _ in range(2))
    assert first == second


def test_what_can_be_changed_is_changed() -> None:
    found = set(mutations(a * sin(x) ** 2 + 3 * b, (a, b)))
    assert {
        3 * b,
        a * sin(x) ** 2,
        a * sin(x) ** 2 - 3 * b,
        a * sin(x) ** 2 + 4 * b,
        a * sin(x) ** 3 + 3 * b,
        a * sin(x) + 3 * b,
        a * sin(x) ** 4 + 3 * b,
        a * cos(x) ** 2 + 3 * b,
        sin(x) ** 2 + 3 * b,
        b * sin(x) ** 2 + 3 * a,
    } <= found
    assert a * sin(x) ** 2 + 3 * b not in found


def test_bound_variables_stay() -> None:
    for changed in mutations(Integral(x * t, (t, 0, x)), (a, b)):
        assert all(list(integral.variables) == [t] for integral in changed.atoms(Integral))


def test_a_true_variant_does_not_count() -> None:
    bound = Claim("bound", Ge(x**2 + 1, 0, evaluate=False), by())
    assert all(m.claim.says != Ge(x**2 + 2, 0, evaluate=False) for m in mutants(bound, 50))


def test_a_definition_is_changed_where_others_prove_something_by_it() -> None:
    new = Claim("new", equal(x, a + b), Definition())
    assert list(mutants(new, 5)) == []
    square = Claim("square", equal(x**2, a**2 + 2 * a * b + b**2), by(substituting(new)))
    found = list(mutants(new, 5, (square,)))
    assert len(found) >= 5
    held = {"new": judge(new, {})}
    assert judge(square, held).verdict is Verdict.PROVED
    for mutant in found:
        assert mutant.place == "in square"
        assert judge(mutant.claim, held).verdict is Verdict.UNDECIDED  # it names another "new"
        changed = {"new": Finding(Premise.DEFINED, "changed")}
        assert judge(mutant.claim, changed).verdict is Verdict.REFUTED


ALIKE = [
    pytest.param(label, marks=pytest.mark.night) for label in ("unturned_turn", "rotating_turn")
]


@pytest.mark.parametrize("label", ["half_a_turn_before", *ALIKE])
def test_an_equation_is_changed_where_it_defines_a_function_with_a_slope(label: str) -> None:
    """What `decrease_of_bodies` rests on: with another equation the slope is another."""
    score = verify_mutants([label], 5)
    assert score.survivors == score.few == ()
    (row,) = score.rows
    assert row.changes == 5
    assert {name: n for name, n in row.counts.items() if n} == {"REFUTED": 5}


def test_a_conjunction_has_its_parts_changed() -> None:
    assert list(mutants(Claim("all", "all", AllOf(())), 5)) == []
    parts = tuple(Claim(str(e), equal(e - e / 2, e / 2), by()) for e in (x, y))
    both = Claim("both", "both", AllOf(parts))
    found = list(mutants(both, 6))
    assert {m.place.split(":")[0] for m in found} == {"part x", "part y"}
    for mutant in found:
        changed = {part.label: judge(part, {}) for part in (*parts, *mutant.beneath)}
        assert judge(mutant.claim, changed).verdict is Verdict.REFUTED


def test_a_refuted_sentence_is_changed_and_stays_refuted() -> None:
    point = Counterexample({"x": fmpq(1, 2)})
    false = Claim("false", "sin x ≤ x/2", point, given=(x > 0,), means=sin(x) <= x / 2)
    found = list(mutants(false, 4))
    assert found
    assert all(judge(m.claim, {}).verdict is not Verdict.PROVED for m in found)


def test_a_sentence_denied_at_a_point_has_its_conditions_changed() -> None:
    point = Counterexample({"x": fmpq(1, 2)})
    false = Claim("false", sin(x) <= x / 2, point, given=(x > 0, x < 3))
    found = [m for m in mutants(false, 9) if m.place.startswith("condition")]
    assert {m.place for m in found} == {"condition 1", "condition 2"}
    assert all(judge(m.claim, {}).verdict is Verdict.REFUTED for m in found)


def test_a_denial_by_what_is_false_denies_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    ground = Claim("ground", equal(x + x, 2 * x + 0 * y), by())
    denied = Claim("denied", "no", Denied((ground,), {"x": fmpq(0)}), expect=Verdict.REFUTED)
    found = list(mutants(denied, 2))
    assert found
    for mutant in found:
        held = {c.label: judge(c, {}) for c in mutant.beneath}
        assert judge(mutant.claim, held).verdict is Verdict.UNDECIDED
    monkeypatch.setattr("tresym.ledger.paper.all_claims", lambda *_: (ground, denied))
    monkeypatch.setattr("tresym.dev.mutants.report.choose", lambda *_: (ground, denied))
    assert verify_mutants(["denied"], 2).survivors == ()
    believing = Finding(Verdict.REFUTED, "so it is said")
    monkeypatch.setattr("tresym.dev.mutants.report._judge_mutant", lambda mutant, found: believing)
    assert verify_mutants(["denied"], 2).survivors


def test_the_region_of_a_claim_is_changed() -> None:
    root = Claim("root", equal(sqrt(x**2), x), by(roots), given=(x > 0, a > 0))
    found = [m for m in mutants(root, 9) if m.place == "region"]
    assert "without x > 0" in {m.change for m in found}
    assert len(found) >= 2
    assert not any(judge(m.claim, {}).verdict.holds for m in found)
    assert not any("a > 0" in m.change for m in found)


def test_claims_with_few_mutants_are_listed_with_the_reason() -> None:
    report = verify_mutants(["chart", "eq_gamma"], 5)
    assert [(row.label, row.changes) for row in report.few] == [("chart", 0)]
    assert report.as_json()["few"][0]["why"].startswith("nothing is proved")
    assert why_few(Claim("new", equal(x, a), Definition())).startswith("nothing is proved")


@pytest.mark.parametrize(("kind", "power"), [("O", 1), ("O", 3), ("o", 2)])
def test_orders_are_changed_only_to_false_ones(kind: str, power: int) -> None:
    left = sin(x) - x if power > 1 else sin(x)
    says = order(equal(left, Function(kind)(x**power)), x)
    claim = Claim("order", "…", Decided(), means=says)
    assert judge(claim, {}).verdict.holds
    found = list(mutants(claim, 20))
    assert len(found) >= 5
    assert not any(judge(m.claim, {}).verdict.holds for m in found)


@pytest.mark.parametrize("label", ["flip_defect", "leading_term", "first_coefficient"])
def test_definitions_are_changed_where_charts_and_roots_rest_on_them(label: str) -> None:
    score = verify_mutants([label], 5)
    assert score.survivors == score.few == ()
    check(score)


@pytest.mark.parametrize("label", ["eps0_smooth", "no_single_constant", "turns_from_pi"])
def test_refuted_orders_and_instances_are_changed(label: str) -> None:
    """A smaller order than one that is refuted is refuted too; an instance says one thing."""
    score = verify_mutants([label], 5)
    assert score.survivors == score.few == ()
    check(score, 1)


def test_evidence_that_takes_too_long_is_not_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(claim: Claim, found: object, evidence: object = None) -> Finding:
        while True:
            pass

    monkeypatch.setattr("tresym.dev.mutants.report.SECONDS", 0.02)
    monkeypatch.setattr("tresym.dev.mutants.report._once", {})
    monkeypatch.setattr("tresym.dev.mutants.report.judge", slow)
    (row,) = verify_mutants(["energy_by_gamma"], 1).rows
    assert row.total == row.counts["REFUTED"] > 0


def test_moved_digits_count_only_where_no_inputs_give_them() -> None:
    p = Symbol("p", real=True)
    number = Claim("n", "n", Printed(), given=(Rounds(p, "1.0"),), means=Rounds(p / 3, "0.33"))
    changes = {m.change for m in mutants(number, 40) if m.place == "printed number"}
    assert "0.34" not in changes
    assert {"0.43", "1.33", "-0.33", "0.31"} & changes


def test_a_verifier_that_believes_everything_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    def gullible(claim: Claim, found: object, evidence: object = None) -> Finding:
        return Finding(Verdict.PROVED, "it looks right")

    for module in ("ledger.verification", "dev.mutants.report"):
        monkeypatch.setattr(f"tresym.{module}.judge", gullible)
    monkeypatch.setattr("tresym.dev.mutants.report._once", {})
    assert len(verify_mutants(["eq_gamma"], 1).survivors) > 5
    assert main(["verify", "--mutants", "eq_gamma"]) == 1


def test_the_command_prints_the_score(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", "--mutants", "sign_squared"]) == 0
    assert "none passed" in capsys.readouterr().out
    assert main(["verify", "--mutants", "sign_squared", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["survivors"] == []
    assert printed["counts"]["REFUTED"] >= 5


# Violations


def test_no_violation_of_what_is_true() -> None:
    assert violation(equal(sin(x) ** 2 + cos(x) ** 2, 1), ()) is None
    assert violation(Ge(x**2, 0, evaluate=False), ()) is None
    assert violation(Ge(x, 0, evaluate=False), (x > 1,)) is None


def test_violations_respect_everything_known() -> None:
    assert violation(equal(x + y, 1), ()) is not None
    assert violation(equal(x + y, 1), (), (equal(y, 1 - x),)) is None
    assert violation(equal(x**2 + 2 * x * y + y**2, 1), (), (equal(x + y, 1),)) is None
    assert violation(equal(x, 2), (x > 0,), (equal(exp(x) + x, exp(2) + 2),)) is None
    found = violation(equal(x, 1), (x > 0,), (equal(exp(x) + x, exp(2) + 2),))
    assert found is not None
    assert abs(found.point["x"] - 2) < fmpq(1, 10**6)


def test_a_pole_is_not_taken_for_a_root() -> None:
    given = (x > 1, x < 2)
    assert violation(equal(y, 0), given, (equal(tan(x) * exp(tan(x) ** 2), 0),)) is None


def test_systems_fall_with_one_part() -> None:
    assert violation(Tuple(equal(x, x + 0 * y), equal(x, x + 1)), ()) is not None


def test_integrals_are_enclosed() -> None:
    area = value(Integral(sqrt(1 - t**2), (t, 0, x)), {x: arb("0.5")})
    known = (arb(3).sqrt() / 4 + arb.pi() / 6) / 2
    assert area.overlaps(known)
    assert area.rad() < arb("1e-9")
    assert not value(Integral(1 / t, (t, -1, x)), {x: arb(1)}).is_finite()


def test_a_chain_follows_what_it_must_show() -> None:
    double = Claim("double", equal(sin(2 * x), 2 * sin(x) * cos(x)), by(trigonometry))
    for mutant in mutants(double, 5):
        assert violation(mutant.claim.says, ()) is not None
