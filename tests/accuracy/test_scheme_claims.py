"""Claims from the coefficients of methods: known orders, wrong ones, and what is refused."""

from __future__ import annotations

from typing import Any

import pytest

import tresym
from tresym.accuracy.scheme_claims import rooted_trees
from tresym.checking.dispatch import decide_claim

HEUN3 = ([[], ["1/3"], [0, "2/3"]], ["1/4", 0, "3/4"])
RADAU = ([["5/12", "-1/12"], ["3/4", "1/4"]], ["3/4", "1/4"])
ADAMS = ([0, -1, 1], ["-1/2", "3/2"])
SCALAR = ([[], ["1/3"], [1, "-1/3"], [-7, 11, -3]], ["1/8", "3/8", "3/8", "1/8"])


@pytest.mark.parametrize(
    ("method", "order"),
    [
        ({"tableau": HEUN3}, 3),
        ({"tableau": RADAU}, 3),
        ({"tableau": SCALAR, "autonomous": True}, 3),
        ({"multistep": ADAMS}, 2),
        ({"stencil": {-2: "1/12", -1: "-2/3", 1: "2/3", 2: "-1/12"}}, 4),
        ({"stencil": {0: -1, 1: 1}}, 1),
    ],
)
def test_true_and_false_orders(method: dict[str, Any], order: int) -> None:
    assert all(map(decide_claim, tresym.scheme_claims(**method, order=order)))
    verdicts = {decide_claim(c).verdict for c in tresym.scheme_claims(**method, order=order + 1)}
    assert tresym.Verdict.REFUTED in verdicts
    assert verdicts <= {tresym.Verdict.REFUTED, tresym.Verdict.PROVED}


def test_scalar_equations_may_have_a_higher_order() -> None:
    first, *conditions = tresym.scheme_claims(tableau=SCALAR, order=4, autonomous=True)
    assert decide_claim(first)
    assert sum(not decide_claim(claim) for claim in conditions) == 2


def test_rooted_trees() -> None:
    assert [len(list(rooted_trees(n))) for n in range(1, 8)] == [1, 1, 2, 4, 9, 20, 48]


@pytest.mark.parametrize(
    "method",
    [
        {"tableau": ([[], [0.5]], [0, 1])},
        {"tableau": ([[], ["a"]], [0, 1])},
        {"tableau": ([[]], [0, 1])},
        {"tableau": ([[], [1, 2, 3]], [0, 1])},
        {"stencil": {0: 1}, "multistep": ADAMS},
        {},
    ],
)
def test_refused(method: dict[str, Any]) -> None:
    with pytest.raises(tresym.InputError):
        tresym.scheme_claims(**method, order=2)
