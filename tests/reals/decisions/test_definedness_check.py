"""What passes speaks of a point, and the terms of its sums are defined at every index."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import definedness_check
from tresym.reals.decisions.answer import Answer
from tresym.reals.verdict import Verdict

NOWHERE = [
    "sum(sqrt(k - 5)**2, k, 1, n) == n*(n + 1)/2 - 5*n",
    "sum(1/k, k, 0, n) >= 0",
    "product(1/k, k, 0, n) > 0",
    "sum(0/k, k, 0, n) == 0",
    "sum(1/(k - 3), k, 1, n) == sum(1/(k - 3), k, 1, n)",
    "sum(sqrt(10 - k)**2, k, 1, n) == 10*n - n*(n + 1)/2",
    "sum((k - 2)/(k - 2)/2**k, k, 0, oo) == 2",
    "f(sqrt(x)**2) == f(x) given x < 0",
    "f(acos(x)) == f(acos(x)) given x > 1",
    "integral(sqrt(t)**2, t, a, a + 1) == a + 1/2 given a < -2",
    "diff(exp(x), x, n) == exp(x) given n == 1/2",
    "sum(k, k, 1, n) == n*(n + 1)/2 given n == 7/2",
]
SOMEWHERE = [
    "sum(1/(2*k - 5), k, 1, n) == sum(1/(2*k - 5), k, 1, n)",
    "sum(1/(2 + (-1)**k), k, 0, n) > 0 given n >= 0",
    "sum(1/factorial(k), k, 0, n) > 0 given n >= 0",
    "sum(k, k, 1, n) == n*(n + 1)/2 given n >= 100",
    "f(x) > 1 given f(x) == 2",
    "integral(log(abs(x)), x, -1, 1) == -2",
]


@pytest.mark.parametrize("claim", NOWHERE)
def test_nothing_is_proved_of_what_is_defined_nowhere(
    monkeypatch: pytest.MonkeyPatch, claim: str
) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.UNDECIDED
    monkeypatch.setattr(definedness_check, "unspoken", lambda *_: None)
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.UNDECIDED)


@pytest.mark.parametrize("claim", SOMEWHERE)
def test_what_is_defined_somewhere_passes(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)
