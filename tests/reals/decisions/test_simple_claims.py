"""Simple claims of many kinds with their truth; each guard has a false claim beside a true one."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import equations


@pytest.mark.parametrize(
    "claim", ["sin(x) ~ x - x**3/4 as x -> 0", "cosh(t) ~ 1 + 5*t**2 as t -> 0"]
)
def test_without_its_terms_an_expansion_would_hold(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dispatch, "_asserted", lambda claim, _: [claim])
    assert tresym.check(claim)


def test_what_is_solved_by_an_identity_keeps_its_domain() -> None:
    """``x/x == 1`` excludes 0, and nothing else."""
    assert not tresym.check("x != 0 given x == x")
    assert tresym.check("x != 0 given x/x == 1")
    assert equations.NO_POINT.why not in tresym.check("x > 3 given x/x == 1").why
