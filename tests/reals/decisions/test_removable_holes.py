"""Derivatives where their formula has a removable hole: each false claim holds beside the hole."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import removable_holes
from tresym.reals.verdict import Verdict

FALSE = (
    *("diff(abs(x)**2, x) != 0", "diff(sqrt(x**4), x) != 0", "diff(x*abs(x), x) > 0"),
    *("diff(x**2*sign(x), x) > 0", "diff(abs(x - a)**3, x) != 0", "diff(abs(x)**3, x, 2) > 0"),
    *("diff(abs(x)*x, x) == 2*abs(x) + 1 - sign(x)**2", "diff(abs(x)**2, x)**2 > 0"),
    *("diff(abs(2*x - 3)**2, x) != 0", "diff(exp(-abs(x)**3), x) != 0"),
    "diff(abs(sin(x))*sin(x), x) != 0 given -1 < x < 1",
)


@pytest.mark.parametrize("claim", FALSE)
def test_what_fails_at_the_hole_is_refuted_there(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = tresym.check(claim)
    assert found.verdict is Verdict.REFUTED
    assert found.why.startswith("where x = ")
    monkeypatch.setattr(removable_holes, "at_removable_holes", lambda found, *_: found)
    alone = tresym.check(claim)
    assert not alone or "x, 2)" in claim  # the cross-check looks at first derivatives alone
    monkeypatch.setattr(dispatch, "attack", lambda *_: None)
    assert tresym.check(claim)


@pytest.mark.parametrize(
    "claim",
    [
        *("diff(x*abs(x), x) >= 0", "diff(abs(x)**2, x) == 2*x", "diff(abs(x)**3, x, 2) >= 0"),
        *("diff(abs(x), x) != 0", "diff(cbrt(x), x) > 0", "diff(sqrt(x), x) > 0"),
        "diff(abs(x), x)**2 == 1",  # there is no derivative at 0
    ],
)
def test_what_holds_at_the_hole_or_is_not_claimed_there_stays_proved(claim: str) -> None:
    found = tresym.check(claim)
    assert found
    assert "where" not in (found.region or "")


def test_what_is_left_out_is_named() -> None:
    found = tresym.check("diff(sqrt(x**2 + a**2), x) < 2")
    assert found.region == "where x**2 + a**2 != 0"
    assert found.region[6:] in found.why
