"""The numerical check of claims about solutions contradicts wrong verdicts, and no right one."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import arb

from tresym.checking import solution_check
from tresym.reals.decisions.answer import Answer, constant_ball
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "initial_values.txt"
SAMPLE = 4
OUT_OF_REACH = ("== t - y(t)**2", "== t**2 - y(t)**2")
"""Equations whose numerical solution is not known at the late times of a limit: errors that the
equation damps are counted as if they added up."""


def _rows(kinds: tuple[str, ...]) -> list[str]:
    lines = (line.partition(" ") for line in DATA.read_text().splitlines())
    return [claim for kind, _, claim in lines if kind in kinds]


def _against(claim: str, verdict: Verdict) -> str | None:
    statement = read(claim)
    return solution_check.contradiction(statement.comparisons[0], statement, Answer(verdict, ""))


@pytest.mark.parametrize(
    "claim", [c for c in _rows(("FALSE",)) if not any(text in c for text in OUT_OF_REACH)]
)
def test_a_false_claim_that_passes_is_contradicted(claim: str) -> None:
    assert _against(claim, Verdict.PROVED)
    assert _against(claim, Verdict.REFUTED) is None


@pytest.mark.parametrize("claim", _rows(("HOLDS",))[::SAMPLE])
def test_a_true_claim_that_passes_is_not_contradicted(claim: str) -> None:
    assert _against(claim, Verdict.PROVED) is None


@pytest.mark.parametrize(
    "claim",
    [
        "y(t) == 3*exp(-2*t) given diff(y(t), t) == -2*y(t), y(0) == 3",
        "x(t) == cos(t) given diff(x(t), t) == y(t), diff(y(t), t) == -x(t), x(0) == 1, y(0) == 0",
        "y(x) == sinh(x)/sinh(1) given diff(y(x), x, 2) == y(x), y(0) == 0, y(1) == 1",
        "y(t) == exp(-t) + O(e) given diff(y(t), t) == -y(t) + e*y(t)**2, y(0) == 1 as e -> 0",
        "y(t) -> 1 as t -> oo given diff(y(t), t) == y(t)*(1 - y(t)), y(0) == 1/2",
    ],
)
def test_a_true_claim_that_is_refuted_is_contradicted(claim: str) -> None:
    assert _against(claim, Verdict.REFUTED)


@pytest.mark.parametrize(
    "claim",
    [
        "y(x) == sinh(x)/sinh(1) given diff(y(x), x, 2) == -y(x), y(0) == 0, y(1) == 1",
        "x(t) == sin(t) given diff(x(t), t) == y(t), diff(y(t), t) == -x(t), x(0) == 1, y(0) == 0",
        "y(1) == 2 given diff(y(t), t) == y(t), y(0) == 1",
        "y(t) <= 3/4 given diff(y(t), t) == y(t)*(1 - y(t)), y(0) == 1/2, t >= 0",
        "y(t) -> 0 as t -> oo given diff(y(t), t) == sin(y(t)), y(0) == 1",
        "y(t) ~ 2*t as t -> oo given diff(y(t), t) == 1 + exp(-y(t)), y(0) == 0",
        "y(t) == 1 + O(exp(-2*t)) as t -> oo given diff(y(t), t) == y(t)*(1 - y(t)), y(0) == 1/2",
    ],
)
def test_false_claims_of_other_kinds_are_contradicted(claim: str) -> None:
    assert _against(claim, Verdict.PROVED)


def test_a_constant_that_is_exceeded_is_contradicted() -> None:
    claim = "y(t) == exp(-t) + O(e) given diff(y(t), t) == -y(t) + e*y(t)**2, y(0) == 1 as e -> 0+"
    statement = read(claim.replace("y(0) == 1", "y(0) == 1, t >= 0"))
    high = solution_check.parse_number("0.2")
    for factor, wrong in ((1, True), (2, False)):
        constant = constant_ball(arb(high * factor))
        answer = Answer(
            Verdict.ENCLOSED, "", constant=constant, region="t >= 0, 0 < e <= 1/5", uniform=True
        )
        found = solution_check.contradiction(statement.comparisons[0], statement, answer)
        assert (found is not None) == wrong


@pytest.mark.parametrize(
    ("problem", "at", "value"),
    [
        ("diff(y(t), t) == y(t), y(0) == 1", "1", "2.71828182845904523536028747135"),
        # The pendulum, by the elliptic function sn of mpmath.
        ("diff(y(t), t, 2) == -sin(y(t)), y(0) == 1, y'(0) == 0", "1", "0.60008536612750643778"),
        ("diff(y(t), t) == y(t)**2, y(0) == 1", "0.99", "100"),
    ],
)
def test_values_of_solutions(problem: str, at: str, value: str) -> None:
    statement = read(f"y(t) == 0 given {problem}")
    with ball_precision(200), solution_check._taylor():
        system = solution_check._system(statement)
        found = solution_check._Solver(system, {}).at(arb(at))
        assert found is not None
        assert abs(found[0] - arb(value)) < arb("1e-17")


def test_no_step_leads_across_a_pole() -> None:
    statement = read("y(t) == 0 given diff(y(t), t) == y(t)**2, y(0) == 1")
    with ball_precision(200), solution_check._taylor():
        system = solution_check._system(statement)
        assert solution_check._Solver(system, {}).at(arb("1.5")) is None
