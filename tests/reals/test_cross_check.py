"""The advocate: with the prover broken, it stops what would pass falsely, and nothing that is true.

Each test breaks the prover at one place and asks for a claim that then passes but for the advocate.
"""

import ast
import importlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from flint import arb
from sympy import Derivative, Eq, Equivalent, Ge, Gt, Integral, Symbol, Tuple, cos, sin
from sympy_statements import equal

import tresym
from tresym.checking.claim_cross_check import attack
from tresym.commands import main
from tresym.dev.corpus.lists import known, pairs
from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.decided import Decided
from tresym.reals import cross_check
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import FUNCTIONS, ZERO, Expr, apply, substitute
from tresym.reals.language.parsing import parse
from tresym.reals.normal import locally_constant
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict

# The modules: their packages export functions of the same name.
check_judge: Any = importlib.import_module("tresym.checking.dispatch")
claims_judge: Any = importlib.import_module("tresym.ledger.judge")
inequalities: Any = importlib.import_module("tresym.reals.decisions.inequalities")
orders: Any = importlib.import_module("tresym.asymptotics.order_claims")

PROVED, UNDECIDED = Verdict.PROVED, Verdict.UNDECIDED
x, y, t = (Symbol(name, real=True) for name in "xyt")

Patch = pytest.MonkeyPatch


def stopped(answer: Answer) -> bool:
    """By the advocate, who shows a point and asks for a report."""
    return answer.verdict is UNDECIDED and "report" in answer.why and " at " in answer.why


@pytest.fixture
def gullible(monkeypatch: Patch) -> None:
    """A prover that believes everything."""
    monkeypatch.setattr(check_judge, "_decide", lambda *_: Answer(PROVED, "it looks right"))


BEYOND_THE_WALL = [
    ("atan2(sin(t), cos(t)) == t", ""),
    ("2*atan(sin(t)/(1+cos(t))) == t", "0 < t < 33/10"),
    ("atan(sin(2*t)/(1+cos(2*t))) == t", "0 < t < 2"),
    ("2*atan(sin(x+y)/(1+cos(x+y))) == x + y", "x > 0, y > 0, x < 2, y < 2"),
]


@pytest.mark.slow
@pytest.mark.parametrize(("claim", "given"), BEYOND_THE_WALL)
def test_a_lost_wall(claim: str, given: str, monkeypatch: Patch) -> None:
    monkeypatch.setattr(locally_constant, "_walls", lambda *_: [])
    assert not tresym.check(claim, given=given)
    assert not tresym.check(claim, given=given, limit=60)


FALSE = [
    *(f"{claim} given {given}" if given else claim for claim, given in BEYOND_THE_WALL),
    # beyond the first period, far out, beside an end
    "atan(tan(t)) == t",
    "asin(sin(t)) == t given -3.1416 < t < 3",
    "2*atan(sin(x**2)/(1 + cos(x**2))) == x**2",
    "x**2 < 10**12",
    "abs(x + 10**6) == x + 10**6",
    "x <= 3.1415926 given 0 < x < pi",
    "x*y <= 0.24 given x + y <= 1, x > 0, y > 0",
    # at single points, and equal there
    "sign(x)**2 == 1",
    "x**2 != x",
    "x**2 + y**2 > 2*x*y",
    # narrow, downhill
    "log(x) <= x/2.7183",
    "x*log(x) >= -0.36787",
    # negative ones, several variables, several scales
    "sqrt(x**2) == x",
    "(a + b)**3 == a**3 + b**3",
    "x**2/y >= 0",
    "cbrt(x) >= 0",
    "log(x*y) == log(x) + log(y) + 10**(-12)",
    "diff(x**x, x) == x*x**(x-1)",
    "2 + 2 == 5",
    # nothing that takes forever to write
    "exp(x**9) < 1 given x > 10",
    "x < (10**981)**5 given x > (10**980)**5",
]


@pytest.mark.parametrize("claim", FALSE)
@pytest.mark.usefixtures("gullible")
def test_a_prover_that_believes_everything(claim: str) -> None:
    assert stopped(tresym.check(claim))


@pytest.mark.usefixtures("gullible")
def test_most_of_the_false_claims_of_the_lists_fall_to_the_advocate_alone() -> None:
    """What is left touches its bound at points that no ball can show."""
    false = [pair.claim for pair in known("inequalities") if not pair.truth]
    assert sum(stopped(tresym.check(claim)) for claim in false) >= 0.7 * len(false)


@pytest.mark.slow
@pytest.mark.usefixtures("gullible")
def test_every_door_leads_past_the_advocate(tmp_path: Path, capsys: Any) -> None:
    claim = "atan(tan(t)) == t"
    assert main(["check", claim]) == 3
    assert "t = 13/4" in capsys.readouterr().out
    assert stopped(tresym.check(claim, limit=60))
    file = tmp_path / "claims.txt"
    file.write_text(f"{claim}\nx == x\n", encoding="utf-8")
    assert main(["check", "-f", str(file), "--json"]) == 3
    first, second = map(json.loads, capsys.readouterr().out.splitlines())
    assert (first["verdict"], second["verdict"]) == ("UNDECIDED", "PROVED")
    assert "please report" in first["why"]
    assert stopped(tresym.check(Ge(x, 0)))


@pytest.mark.parametrize(
    ("name", "slope", "claim"),
    [
        ("cosh", "-sinh(x)", "diff(cosh(x), x) == -sinh(x)"),
        ("cosh", "-sinh(x)", "diff(cosh(a*x)/a, x) <= -sinh(a*x)"),
        ("atan", "2/(1 + x**2)", "diff(atan(x), x) == 2/(1 + x**2)"),
        ("cos", "sin(x)", "diff(sin(x), x, 2) == sin(x)"),
        ("cos", "sin(x)", "diff(sin(x), x, 3) == cos(x)"),
    ],
)
def test_a_wrong_rule_of_differentiation(
    name: str, slope: str, claim: str, monkeypatch: Patch
) -> None:
    def wrong(at: Expr, _: object) -> Expr:
        return substitute(parse(slope), {"x": at})

    monkeypatch.setitem(TABLE, name, replace(TABLE[name], derivatives=(wrong,)))
    assert not tresym.check(claim)
    monkeypatch.setattr(check_judge, "_decide", lambda *_: Answer(PROVED, "it looks right"))
    assert stopped(tresym.check(claim))


def test_a_wrong_rule_of_differentiation_before_sympy(monkeypatch: Patch) -> None:
    for name, row in TABLE.items():
        own = lambda *args, name=name: getattr(args[-1], name)(*args[:-1])  # noqa: E731
        monkeypatch.setitem(TABLE, name, replace(row, derivatives=(own,) * row.arity))
    slope = Derivative(cos(x), x)
    assert stopped(tresym.check(Eq(slope, cos(x), evaluate=False)))


@pytest.mark.parametrize(
    "claim",
    ["x - x**2 >= 2", "exp(x) <= x given x > 0", "sin(x) > 2*x given -1 <= x <= 1", "x*y > x**2"],
)
def test_a_dropped_sign(claim: str, monkeypatch: Patch) -> None:
    proof = inequalities.proof
    monkeypatch.setattr(inequalities, "_sampled", lambda *_: ({}, None))
    monkeypatch.setattr(
        inequalities, "proof", lambda e, *rest: proof(-e, *rest) or "a sign was dropped"
    )
    assert stopped(tresym.check(claim))


ORDERS = [
    ("sin(x) == O(x)", "x -> 0"),
    ("3*x + 1 == O(x)", "x -> oo"),
    ("cos(x) == O(1)", "x -> pi"),
]


@pytest.mark.parametrize(("claim", "path"), ORDERS)
def test_a_constant_that_is_too_small(claim: str, path: str, monkeypatch: Patch) -> None:
    assert tresym.check(claim, path=path).verdict is Verdict.ENCLOSED
    monkeypatch.setattr(orders, "constant_ball", lambda _: Decimal("0.5", "0"))
    assert stopped(tresym.check(claim, path=path))


def test_a_range_that_is_too_large(monkeypatch: Patch) -> None:
    claim = "1/(1 - x) == 1 + x + O(x**2)"
    assert tresym.check(claim, path="x -> 0").verdict is Verdict.ENCLOSED
    monkeypatch.setattr(orders, "region", lambda *_: "0 < |x| <= 9999/10000")
    assert stopped(tresym.check(claim, path="x -> 0"))


# The ledger


@pytest.fixture
def careless(monkeypatch: Patch) -> None:
    """A judge to whom whatever the engine is asked is right."""
    believing = claims_judge.Finding(PROVED, "it looks right")
    monkeypatch.setattr(claims_judge, "judge_decided", lambda *_: believing)


DEFINED = Claim("defined", equal(y, x**2), Definition())
PLANTED = [
    Claim("equation", equal(sin(x) ** 2, 1 - cos(x)), Decided()),
    Claim("far", Gt(10**6, x, evaluate=False), Decided(), given=(x > 0,)),
    Claim("system", Tuple(equal(x + x, 2 * x), equal(x * x, 2 * x)), Decided()),
    Claim("either", Equivalent(equal(x, t), equal(x**2, 4 * t)), Decided()),
    Claim("by definition", equal(y, x**3), Decided((DEFINED,))),
    Claim("integral", equal(Integral(t, (t, 0, x)), x**2), Decided(), given=(x > 0, x < 2)),
]


@pytest.mark.parametrize("claim", PLANTED, ids=lambda claim: claim.label)
@pytest.mark.usefixtures("careless")
def test_a_broken_engine(claim: Claim) -> None:
    found = {"defined": claims_judge.judge(DEFINED, {})}
    finding = claims_judge.judge(claim, found)
    assert (finding.verdict, finding.stopped) == (UNDECIDED, True)
    assert "please report" in finding.why


def test_a_sentence_is_attacked_by_what_it_states(monkeypatch: Patch) -> None:
    believing = claims_judge.Finding(PROVED, "it looks right")
    monkeypatch.setattr(claims_judge, "_judge", lambda *_: believing)
    says = "x lies below 1000"
    sentence = Claim("sentence", says, Decided(), given=(x > 0,), means=x < 1000)
    assert claims_judge.judge(sentence, {}).stopped


@pytest.mark.usefixtures("careless")
def test_verify_does_not_end_well(monkeypatch: Patch, capsys: Any) -> None:
    from tresym.ledger import verification

    claim = PLANTED[0]
    monkeypatch.setattr("tresym.ledger.paper.all_claims", lambda *_: (claim,))
    report = verification.verify()
    assert not report.as_expected
    assert report.counts["UNDECIDED"] == 1
    assert main(["verify", claim.label, "--json"]) == 1
    assert "please report" in json.loads(capsys.readouterr().out)["claims"][0]["why"]


@pytest.mark.usefixtures("careless")
def test_mutants_that_only_the_advocate_stops_are_told(capsys: Any) -> None:
    from tresym.dev.mutants.report import verify_mutants

    report = verify_mutants(["sign_squared"], 3)
    assert not report.survivors
    assert report.stopped
    assert main(["verify", "--mutants", "sign_squared"]) == 1
    assert "stopped only by the independent check" in capsys.readouterr().out
    assert main(["verify", "--mutants", "sign_squared", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["stopped"]


# What is true, and the tool itself


TRUE = [pair.claim for pair in known("inequalities") if pair.truth][::9]
TRUE += [pair.claim for pair in pairs()][::25]
TRUE += [
    "x + sqrt(x**2*(x - 1)) >= 1",  # a single point at which a side is defined is excepted
    "log(x**2) == 2*log(x)",
    "diff(log(x), x) == 1/abs(x)",
    "diff(abs(x), x)*x == abs(x)",
    "diff(x**(3/2), x, 2) == 3/(4*sqrt(x))",
    "cosh(x)**2 - sinh(x)**2 == 1",
    "x <= 1/10**30 given 0 < x <= 1/10**30",
    "atan2(sin(t), cos(t)) == t given -pi < t < pi",
]


@pytest.mark.parametrize("claim", TRUE)
def test_what_is_true_is_not_contradicted(claim: str) -> None:
    """Nor with the time of a decision that took long."""
    statement = read(claim)
    for comparison in statement.comparisons:
        assert attack(comparison, statement, Answer(PROVED, "")) is None


def test_nothing_is_shared_with_the_provers() -> None:
    tree = ast.parse(Path(cross_check.__file__).read_text(encoding="utf-8"))
    ours = {n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)}
    ours = {name for name in ours if name and name.startswith("tresym")}
    assert ours == {
        "tresym.reals.numbers.arithmetic",
        "tresym.reals.numbers.exact",
        "tresym.reals.language.expression",
    }
    taken = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and "language" in n.module]
    assert [alias.name for n in taken for alias in n.names] == [
        *("DOTS", "LEAVES", "ZERO"),
        *("Expr", "opened", "replaced", "symbols"),
    ]


def test_every_operation_has_a_meaning() -> None:
    with ball_precision(128):
        for name in FUNCTIONS:
            value = cross_check.program([apply(name, parse("x"))], ["x"])
            assert any(value([cross_check.arb(x)]) for x in ("0.5", "2")), name


@pytest.mark.parametrize(
    ("text", "at", "value"),
    [
        ("sign(x)", 0, 0),
        ("sign(x)", -3, -1),
        ("cbrt(x)", -8, -2),
        ("cbrt(x)", 0, 0),
        ("x**(1/3)", -8, None),
        ("sqrt(x)", 0, 0),
        ("sqrt(x)", -1, None),
        ("x**(-1/2)", 0, None),
        ("1/x", 0, None),
        ("0*log(x)", 0, None),
        ("0/x", 0, None),
        ("x**x", 0, None),
        ("x**y", -1, None),
        ("asin(x)", 2, None),
        ("acosh(x)", 1, 0),
        ("acosh(x)", 0, None),
        ("atanh(x)", 1, None),
        ("x**3", -2, -8),
        ("tan(x) + cot(x)", 0, None),
    ],
)
def test_real_meanings(text: str, at: int, value: int | None) -> None:
    with ball_precision(128):
        found = cross_check.program([parse(text)], ["x", "y"])(
            [cross_check.arb(at), cross_check.arb(1)]
        )
        assert found is None if value is None else found and found[0].contains(value)


def test_where_the_points_lie() -> None:
    """Far and near, on both sides, just inside of every end, with unlike scales, on hyperplanes."""

    def some(*names: str, given: str = "") -> list[list[Any]]:
        conditions = Given.parse(given).comparisons
        holds = cross_check.conditions(names, conditions)
        return [p for p in cross_check.points(names, conditions, holds) if p is not None]

    with ball_precision(128):
        line = [p[0] for p in some("x")]
        assert min(line) < -(10**12)
        assert max(line) > 10**12
        assert 0 < min(v for v in line if v > 0) < 1e-12
        assert {0, 1, -1} <= {int(cross_check.exact(v).p) for v in line if abs(v) <= 1}
        inside = [p[0] for p in some("x", given="-2 <= x < pi")]
        assert -2 in inside
        assert 3.141592 < max(inside) < 3.1415927
        plane = some("x", "y")
        assert any(p[0] == p[1] for p in plane)
        assert any(abs(p[0]) > 10**6 * abs(p[1]) > 0 for p in plane)
        triangle = some("x", "y", given="x + y <= 1, x > 0, y > 0")
        assert any(p[0] + p[1] > 1 - 1e-9 for p in triangle)
        assert some("x", "y") == plane


def test_a_power_with_a_half_integer_exponent_needs_a_positive_base() -> None:
    power = parse("x**(n + 1/2)")
    value = cross_check.program([power], ["n", "x"], ["n"])
    assert value([arb(1), arb(4)]) is not None
    assert value([arb(1), arb(-4)]) is None
    assert value([arb(-1), arb(0)]) is None
    assert cross_check.somewhere([power], (), ["n"])
    assert not cross_check.somewhere([power], [(parse("x"), "<", parse("0"))], ["n"])


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("x**2 + 1", True),
        ("exp(x)", True),
        ("x**4*y**2 + abs(x) + 1/2", True),
        ("pi*sqrt(x) + 3", True),
        ("x**2 + y**2", False),
        ("x**3 + 1", False),
        ("x**2 - 1", False),
        ("cbrt(x) + 1", False),
        ("abs(x) - x**2", False),
    ],
)
def test_only_what_has_no_zero_is_passed_over(text: str, never: bool) -> None:
    e = parse(text)
    assert cross_check._has_no_zero(e) is never
    with ball_precision():
        found = [c for c, _, _ in cross_check.exceptional_points([1 / e], ["x", "y"], [])]
    assert (e in found) is not never


@pytest.mark.parametrize(
    ("text", "square"), [("x**2 - 2", 2), ("x**4 - 9", 3), ("(x**2 - 5)*exp(x)", 5)]
)
def test_a_root_is_between_values_of_both_signs(text: str, square: int) -> None:
    with ball_precision():
        sides = cross_check.program([parse(text), ZERO], ["x"])
        root = cross_check._root(sides, [arb(0)], 0, False)
        assert root is not None
        assert (root**2).contains(square)
        assert root.rad() < arb((1, -60))
        assert cross_check._exceptional_root(sides, [arb(0)], 0, False, False) is not None
