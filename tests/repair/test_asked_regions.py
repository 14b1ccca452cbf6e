"""Suggestions keep the region that a refuted order asks for."""

import tresym


def test_a_suggestion_holds_on_the_region_that_is_asked_for() -> None:
    claim = "exp(x) == 1 + O(x**2*(1-x)) as x -> 0+ on 0 < x <= %s"
    near, far = ([one.claim for one in tresym.check(claim % end).instead] for end in ("1/2", "2"))
    assert any("1 - x" in one for one in near)
    assert not any("1 - x" in one for one in far)  # the comparison function vanishes at x = 1
