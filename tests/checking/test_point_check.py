"""A refutation at a point leaves only if the point satisfies the complete statement."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions.answer import Answer
from tresym.reals.verdict import Verdict


def said(monkeypatch: pytest.MonkeyPatch, claim: str, witness: dict[str, str]) -> str:
    """The verdict where a decider refutes the claim at this point."""
    found = Answer(Verdict.REFUTED, "so it is said", witness=witness)
    monkeypatch.setattr(dispatch, "_decide", lambda *_: found)
    return tresym.check(claim).verdict.value


FALSE_AT = [
    ("x**2 == 4 given x > 0", {"x": "3"}, {"x": "-3"}),
    ("x >= 1 given x >= 0", {"x": "1/2"}, {"x": "1"}),
    ("n**2 == n given n integer", {"n": "2"}, {"n": "1/2"}),
    ("n**2 == n given n integer", {"n": "2"}, {"n": "1"}),
    ("x == 2 given x**2 == 9", {"x": "3"}, {"x": "1"}),
    ("sqrt(x)**2 == -x", {"x": "1"}, {"x": "-1"}),
    ("x**2 != 2", {"x": "sqrt(2)"}, {"x": "3/2"}),
    ("sum(k, k, 1, n) == n", {"n": "2"}, {"n": "3/2"}),
    ("product(sin(k*pi/n), k, 1, n - 1) < 1", {"n": "1"}, {"n": "303/220"}),
    ("factorial(n) == n", {"n": "3"}, {"n": "-1"}),
    ("integral(x, x, 0, a) == a", {"a": "1"}, {"a": "2"}),
    (
        "f(n) == f(1) given n integer",
        {"n": "2", "f(n)": "3", "f(1)": "4"},
        {"n": "1/2", "f(n)": "3"},
    ),
    ("f(x) == f(y)", {"x": "1", "y": "2", "f(x)": "3"}, {"x": "1", "y": "1", "f(x)": "3"}),
    ("f(x) == 1 given f(x) > 0", {"x": "1", "f(x)": "3"}, {"x": "1", "f(x)": "-3"}),
    ("f(f(x)) == x", {"x": "1", "f(x)": "2", "f(f(x))": "3"}, {"x": "0", "f(x)": "0"}),
    ("(x**a)**b == x**(a*b)", {"x": "-1", "a": "2", "b": "1/2"}, {"x": "1", "a": "2", "b": "1/2"}),
    ("diff(x**2, x, n) == 2*x", {"n": "0", "x": "3"}, {"n": "1", "x": "3"}),
    ("a*x == x given b > 0", {"a": "2", "x": "1"}, {"a": "2", "x": "0"}),
    ("x**2 - 2 != 0 given x > 0", {"x": "[1, 2]"}, {"x": "[2, 3]"}),
    ("(x**2 - 2)**2 > 0 given x > 0", {"x": "[1, 2]"}, {"x": "[2, 3]"}),
    ("x**2 - 2 != 0 given x > 0", {"x": "[1, 2]"}, {"x": "[-2, -1]"}),
    ("(x**2 - y)**2 > 0 given x > 0", {"x": "[1, 2]", "y": "2"}, {"x": "[1, 2]", "y": "5"}),
    ("(x**2 - y)**2 > 0", {"x": "[1, 2]", "y": "2"}, {"x": "[1, 2]", "y": "[1, 2]"}),
    ("sign(x - 1/3) != 0 given x > 0", {"x": "1/3"}, {"x": "[1/4, 1/2]"}),
]


@pytest.mark.parametrize(("claim", "witness", "other"), FALSE_AT)
def test_a_point_and_one_that_does_not_do(
    monkeypatch: pytest.MonkeyPatch, claim: str, witness: dict[str, str], other: dict[str, str]
) -> None:
    assert said(monkeypatch, claim, witness) == "REFUTED"
    assert said(monkeypatch, claim, other) == "UNDECIDED"


def test_a_series_is_computed_nearer_and_nearer(monkeypatch: pytest.MonkeyPatch) -> None:
    assert said(monkeypatch, "sum(1/2**k, k, 0, oo) == 2", {}) == "UNDECIDED"
    assert said(monkeypatch, "sum(1/2**k, k, 0, oo) == 3", {}) == "REFUTED"
    assert said(monkeypatch, "integral(exp(-x), x, 0, oo) == 1", {}) == "UNDECIDED"
    assert said(monkeypatch, "integral(exp(-x), x, 0, oo) == 2", {}) == "REFUTED"
