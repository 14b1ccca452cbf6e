"""Evidence that is about something else than the claim proves nothing, and refutes nothing."""

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from cases import cases
from derivations import by
from flint import arb, fmpq
from sympy import (
    Abs,
    Basic,
    Function,
    Gt,
    Integer,
    Rational,
    Symbol,
    Tuple,
    cos,
    exp,
    oo,
    pi,
    sin,
    sqrt,
)
from sympy_statements import Rounds, equal, order
from tresym.proofs import NOT_MATHEMATICS

from tresym.dev.mutants.report import _planted_row, verify_mutants
from tresym.dev.mutants.seeded_faults import planted
from tresym.ledger import definitions, refutations
from tresym.ledger import judge as judging
from tresym.ledger.claim import (
    AllOf,
    Claim,
    Counterexample,
    Definition,
    Printed,
    all_of,
)
from tresym.ledger.evidence import box_bounds as bounds
from tresym.ledger.evidence.allowed_evidence import is_formal, unfit
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import Rounded, in_trees
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.reasons import algebra, citing, roots, substituting
from tresym.ledger.verification import Report
from tresym.reals.balls.branch_and_bound import Bound, BoxProof, box
from tresym.reals.balls.gradient import Gradient
from tresym.reals.language.formula import Relation
from tresym.reals.verdict import Verdict
from tresym.report.pages.ledger_rows import report_json

x, y, a, b = (Symbol(name, real=True) for name in "xyab")
epsilon0 = Symbol("epsilon0", real=True)
O, o = Function("O"), Function("o")  # noqa: E741
FALSE = equal(Integer(0), Integer(1))
TRUE = Claim("true", equal(x + x, 2 * x), by())
HELD = {"true": judge(TRUE, {})}
SQUARE = Bound(lambda x, m: x * x, box(("1", "2")))
CLAIMS = {claim.label: claim for claim in all_claims()}


def verdict(says: Basic | str, proof: Any, *given: Basic) -> Verdict:
    return judge(Claim("planted", says, proof, given=given), HELD).verdict


class Believer:
    """No kind of evidence: it says yes."""

    def judge(self) -> Finding:
        return Finding(Verdict.PROVED, "so it is")


class BelievingBoxes(Boxes):
    def judge(self) -> Finding:
        return Finding(Verdict.ENCLOSED, "so it is")


@pytest.mark.parametrize(
    "proof",
    [Believer(), BelievingBoxes((SQUARE,), ("x",), "1 <= x <= 2"), None, "so it is", 1],
    ids=lambda proof: type(proof).__name__,
)
def test_the_kinds_of_evidence_are_closed(proof: Any) -> None:
    for says in (FALSE, "0 = 1"):
        assert verdict(says, proof) is Verdict.UNDECIDED


FOR_SENTENCES = {
    "a conjunction": all_of(TRUE),
    "a number": Printed(),
    "a denial": Denied((TRUE,), {"x": fmpq(1)}),
    "bounds": Boxes((SQUARE,), ("x",), "1 <= x <= 2"),
    "an order": Asymptotics(),
}


@pytest.mark.parametrize("name", FOR_SENTENCES)
def test_no_formula_is_decided_by_evidence_that_does_not_mention_it(name: str) -> None:
    proof = FOR_SENTENCES[name]
    for says in (FALSE, Gt(epsilon0, 100, evaluate=False), Tuple(FALSE, FALSE)):
        assert verdict(says, proof) is Verdict.UNDECIDED


def test_a_formula_is_proved_by_all_of_its_own_relations() -> None:
    above, below = Gt(x**2 + 1, 0, evaluate=False), Gt(x, 0, evaluate=False)
    assert verdict(above, Decided()) is Verdict.PROVED
    assert verdict(Tuple(above, below), Decided()) is Verdict.REFUTED
    assert verdict(Tuple(above, below), Decided(), x > 1) is Verdict.PROVED


@pytest.mark.parametrize("name", ["a conjunction", "a denial", "bounds"])
def test_conditions_that_decide_nothing_are_refused(name: str) -> None:
    proof = FOR_SENTENCES[name]
    assert verdict("so it is", proof) is not Verdict.UNDECIDED
    assert verdict("so it is", proof, x > 0) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "says",
    cases(__file__, "one_point_tells_nothing_of_smoothness_or_a_limit"),
)
def test_one_point_tells_nothing_of_smoothness_or_a_limit(says: str) -> None:
    point = Counterexample({"x": fmpq(1, 10)})
    local = Claim("local", says, point, given=(x**2 <= 1,), means=400 * x**2 <= 1)
    assert judge(local, {}).verdict is Verdict.UNDECIDED
    assert verdict(says, Denied((TRUE,), {"x": fmpq(1, 10)})) is Verdict.UNDECIDED
    stays = replace(local, says="400x² stays below 1.")
    assert judge(stays, {}).verdict is Verdict.REFUTED


COMPARED = tuple(
    label
    for label, claim in CLAIMS.items()
    if not isinstance(claim.says, str) and isinstance(claim.proof, Boxes)
)


def test_formulas_with_an_order_are_compared_with_their_evidence() -> None:
    assert len(COMPARED) == 1
    assert not any(unfit(CLAIMS[label]) for label in COMPARED)


@pytest.mark.parametrize("label", COMPARED)
def test_a_slip_of_a_formula_is_noticed(label: str) -> None:
    claim = CLAIMS[label]
    left, _, right = claim.says
    more = right + in_trees(epsilon0**2 / 2)
    for other in (Relation(left, "==", more), Relation(left * 2, "==", right)):
        assert unfit(replace(claim, says=other)), other


# Margins, orders and printed formulas that are not one function


def by_type_of_slopes(x: Any, m: Any) -> Any:
    return Gradient(arb(1), (arb(1),)) if isinstance(x, Gradient) else x - arb("0.9") + (x - 1) ** 2


MARGINS: dict[str, Any] = {
    "a constant": lambda x, m: arb(1),
    "a number": lambda x, m: 1,
    "a comparison": lambda x, m: arb(1) if x > 0 else arb("0.5"),
    "a comparison of floats": lambda x, m: arb(1 if float(x.mid()) > -1 else -1),
    "a midpoint": lambda x, m: arb(x.mid()) - arb("0.4"),
    "truth": lambda x, m: bool(x > 0),
}


@pytest.mark.parametrize("name", MARGINS)
def test_a_margin_is_a_function_of_its_coordinates_in_balls(name: str) -> None:
    for stored in (None, lambda: (BoxProof("b"),)):
        proof = Boxes((Bound(MARGINS[name], box(("0", "1"))),), ("x",), "…", stored=stored)
        assert verdict("x > 100 on [0, 1]", proof) is Verdict.UNDECIDED


def test_the_slopes_of_a_margin_are_those_of_its_values() -> None:
    bound = Bound(by_type_of_slopes, box(("1", "2")), slopes=True)
    assert verdict("…", Boxes((bound,), ("x",), "…")) is Verdict.UNDECIDED
    assert verdict("…", Boxes((replace(bound, slopes=False),), ("x",), "…")) is Verdict.ENCLOSED


def test_a_printed_number_stands_in_its_sentence() -> None:
    ordinary = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")
    missing = {
        claim.label
        for claim in CLAIMS.values()
        if isinstance(claim.statement, Rounded)
        and claim.statement.text not in claim.says.translate(ordinary).replace("·10", "e")
    }
    assert missing == {"accuracy", "accuracy_relative", "ethylene_plane"}


# What the ledger says of itself


@pytest.mark.slow
def test_prose_is_marked_and_listed(judged: Callable[..., Report]) -> None:
    report = report_json(judged("d26", "eq_gamma", "d52", "eq_epsilon_gen"))
    formal = {row["label"]: row["formal"] for row in report["claims"]}
    assert formal["eq_gamma"]
    assert formal["d26"]
    assert not formal["d52"]
    assert not formal["eq_epsilon_gen"]
    assert report["prose"] == [label for label, is_formal in formal.items() if not is_formal]


def test_words_without_a_formula_are_not_formal() -> None:
    words = Claim("words", "All is well.", Counterexample({"x": fmpq(1)}))
    assert words.statement is None
    assert not is_formal(words)
    meant = replace(words, means=x < 0)
    assert is_formal(meant)
    assert all(map(is_formal, (meant, all_claims()[0])))
    assert not is_formal(Claim("both", "Both.", all_of(meant, words)))
    assert is_formal(Claim("one", "One.", all_of(meant)))


def test_what_is_meant_is_what_the_evidence_must_show() -> None:
    square = equal((x + 1) ** 2, x**2 + 2 * x + 1)
    shown = Claim("shown", "The square is this.", by(algebra), means=square)
    assert judge(shown, {}).verdict is Verdict.PROVED
    assert judge(replace(shown, means=equal(x**2, x)), {}).verdict is Verdict.REFUTED
    assert judge(replace(shown, means=None), {}).verdict is Verdict.UNDECIDED
    two = Claim("two", square, by(algebra), means=equal(x, x))
    assert "must not give another" in judge(two, {}).why


def test_numbers_fall_with_what_they_rest_on(monkeypatch: pytest.MonkeyPatch) -> None:
    broken = Finding(Verdict.UNDECIDED, "broken")
    found = {"unique_root": broken, "defect_is_one": broken}
    for label in ("table_str_epsilon0", "d27", "equation", "larger_ab_smaller_eps0"):
        claim = CLAIMS[label]
        for used in claim.rests_on:
            if used.label not in found:
                found[used.label] = judge(used, found)
        assert judge(claim, found).verdict is Verdict.UNDECIDED


# Planted falsehoods


def believed() -> set[str]:
    return {c.label for c in planted() if _planted_row(c).survivors}


def test_no_planted_falsehood_is_believed() -> None:
    assert believed() == set()


def test_planted_falsehoods_are_judged_with_the_mutants(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tresym.ledger.paper.all_claims", lambda *_: (TRUE,))
    monkeypatch.setattr(judging, "unfit", lambda claim: None)
    report = verify_mutants()
    assert {slip.label for slip in report.survivors} >= {"planted-another-claim"}
    assert json.dumps(report.as_json())


@pytest.mark.parametrize(
    ("where", "guard", "without", "survivor"),
    [
        (judging, "conflict", lambda claims: None, "planted-defined-twice"),
        (judging, "conflict", lambda claims: None, "planted-circle"),
        (refutations, "restrictions", lambda claims: (), "planted-area-twice"),
        (judging, "captured", lambda claim: None, "planted-constant-of-what-is-bound"),
        (definitions, "need_value", lambda *asked: None, "planted-without-value"),
        (refutations, "_possible", lambda claim: True, "planted-against-a-bound"),
        (judging, "unfit", lambda claim: None, "planted-another-claim"),
        (judging, "unfit", lambda claim: None, "planted-smoothness"),
    ],
)
def test_without_its_guard_a_planted_falsehood_is_believed(
    monkeypatch: pytest.MonkeyPatch, where: Any, guard: str, without: Any, survivor: str
) -> None:
    # The independent check stops two definitions of one symbol by itself.
    monkeypatch.setattr(judging, "_attacked", lambda claim, finding: finding)
    monkeypatch.setattr(where, guard, without)
    assert survivor in believed()


def test_a_bound_in_words_is_the_one_that_is_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    always = Bound(lambda x, m: arb(1), box(("1", "2")))
    claim = Claim("no bound", "x < 0 for 1 <= x <= 2", Boxes((always,), ("x",), "…"))
    assert not judge(claim, {}).verdict.holds
    monkeypatch.setattr(bounds, "inconsistent", lambda *bound: None)
    assert judge(claim, {}).verdict.holds


def test_stored_trees_that_are_no_text_leave_their_claim_undecided(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from tresym.ledger import certificates

    proof = Boxes((SQUARE,), ("x",), "…", stored=certificates.certificate("planted"))
    for trees in (5, [5], "b", {"b": 1}, [["b"]], [None]):
        monkeypatch.setattr(certificates, "_trees", lambda trees=trees: {"planted": trees})
        finding = judge(Claim("planted", "…", proof), {})
        assert finding.verdict is Verdict.UNDECIDED
        assert "stored proof" in finding.why
    odd: Any = BoxProof(5)  # type: ignore[arg-type]
    finding = judge(Claim("planted", "…", replace(proof, stored=lambda: (odd,))), {})
    assert "stored proof" in finding.why


def test_what_is_no_formula_is_not_mathematics_or_rests_on_boxes() -> None:
    assert len(NOT_MATHEMATICS) <= 10
    words = {c.label for c in CLAIMS.values() if not is_formal(c)}
    in_boxes = {c.label for c in CLAIMS.values() if isinstance(c.proof, Boxes)}
    by_parts = {c.label for c in CLAIMS.values() if isinstance(c.proof, AllOf)}
    beside = (c for c in CLAIMS.values() if not isinstance(c.says, str))
    open_orders = {c.label for c in beside if c.means is not None}
    assert open_orders == {
        *("eps0", "d24", "d38", "eqnew", "d52", "d56", "d57", "eq_pavao", "d58", "eq_epsilon_gen")
    }
    assert words - in_boxes - by_parts - open_orders <= {*NOT_MATHEMATICS}


Y = Claim("root", equal(sqrt(y**2), y), by(roots), given=(y > 0,))
HALF = Claim("half", equal(x, Rational(1, 2)), Definition())
ABOVE = Claim("above", Gt(x**2 + 1, 0, evaluate=False), by())
BAD = Claim("bad", equal(x, 3), by())
OTHERS = {claim.label: judge(claim, {}) for claim in (TRUE, Y, HALF, ABOVE, BAD)}
LARGE = Gt(x**2 - 2, 0, evaluate=False)


def on_boxes(margin: Any) -> Boxes:
    return Boxes((Bound(margin, box(("1", "2"))),), ("x",), "1 <= x <= 2")


def of(says: Any, proof: Any, *given: Basic, means: Any = None) -> Claim:
    return Claim("planted", says, proof, given=given, means=means)


@pytest.mark.parametrize(
    "claim",
    [
        # a twin of what is proved, under its label
        of(equal(sqrt(y**2), y), by(substituting(replace(Y, given=())))),
        of(equal(sqrt(y**2), y), by(substituting(replace(Y, given=(y > -1,)))), y > -1),
        of(x > Rational(1, 2), by(substituting(replace(HALF, says=equal(x, Rational(2, 3)))))),
        of(LARGE, by(citing(replace(ABOVE, says=LARGE)))),
        of("x squared is above 2", all_of(replace(ABOVE, says=LARGE))),
        # evidence about something else, or about less
        of(x**3 > 9, Boxes((SQUARE,), ("x",), "1 <= x <= 2"), x >= 1, x <= 2),
        of(LARGE, on_boxes(lambda x, m: x * x - arb("0.5")), x >= 0, x <= 2),
        of(x > 3, on_boxes(lambda x, m: arb(1)), x >= 1, x <= 2),
        of(x > 3, on_boxes(lambda x, m: arb(float(x.mid()) > 0)), x >= 1, x <= 2),
        of("pi is 4.00", Printed(), means=Rounds(pi, "4.00", 100)),
        of("pi is 3.2", Printed(), means=Rounds(pi, "3.2", -1)),
        of(Gt(epsilon0, 100, evaluate=False), Printed(), means=Rounds(pi, "3.14", 1)),
        of(equal(sin(x), x**2), Asymptotics(), means=order(equal(sin(x), x + O(x**3)), x)),
        of("cos(x) = 1 + o(x^2)", Asymptotics(), means=order(equal(cos(x) - 1, o(x**2)), x)),
        of("exp(x) = O(x)", Asymptotics(), means=order(equal(exp(x), O(x)), x, oo)),
        # evidence that rests on what does not hold, or on nothing; conditions that decide nothing
        of("x is 3.0", Printed((BAD,)), means=Rounds(x, "3.0", 1)),
        of("x is 0.5", Printed(), means=Rounds(x, "0.5", 1)),
        of("x is 7.0", Printed((TRUE,)), means=Rounds(x, "7.0", 1)),
        of("x is 3", all_of(TRUE, BAD)),
        of("x is above 2", Boxes((SQUARE,), ("x",), "1 <= x <= 2"), x > 2),
    ],
)
def test_it_does_not_hold(claim: Claim) -> None:
    assert not judge(claim, OTHERS).verdict.holds


@pytest.mark.parametrize(
    ("says", "proof", "means"),
    [
        ("sin(x) is smooth at 0", Denied((TRUE,), {"x": fmpq(1)}), None),
        ("x^2 is smooth at 0", Denied((ABOVE,), {"x": fmpq(0)}), None),
        (equal(x + y, y + x), Denied((TRUE,), {"x": fmpq(1)}), None),
        ("…", Asymptotics(), order(equal(400 * x**2, O(x**2)), x)),
        ("…", Asymptotics(), order(equal(exp(-1 / x), o(x**50)), x)),
        ("…", Asymptotics(), order(equal(x * Abs(x), O(x**2)), x, side=0)),
    ],
)
def test_one_point_refutes_nothing_that_is_true(says: Any, proof: Any, means: Any) -> None:
    assert judge(of(says, proof, means=means), OTHERS).verdict is not Verdict.REFUTED


@pytest.mark.parametrize("tree", [1, 1.5, ("1",), None, b"0", [], {"a": 1}, "012", ""])
def test_what_is_no_tree_shows_nothing(tree: Any) -> None:
    proof = replace(on_boxes(lambda x, m: x * x), stored=lambda: (BoxProof(tree),))
    assert not verdict("…", proof).holds
