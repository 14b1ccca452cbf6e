"""Largest values and sizes of remainders along the range of an expansion."""

from itertools import pairwise

import pytest
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.expansions import Expansions
from tresym.reals.expansions.gruntz import Rewritten
from tresym.reals.expansions.scale import CHAIN, UnresolvedError
from tresym.reals.expansions.truncated_series import Size
from tresym.reals.language.expression import number
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def _elements(found: Rewritten, t: arb) -> dict[str, arb]:
    """The values of the elements at t."""
    at = {CHAIN[0]: t}
    for w, v in pairwise(CHAIN):
        at[v] = -1 / at[w].log()
    for w in reversed(found.scale.order):
        if w not in at:
            at[w] = (-evaluate(found.scale.heights[w], at)).exp()
    return at


@pytest.mark.quick
@pytest.mark.parametrize(
    "powers",
    [
        {"_t": "-1"},
        {"_l1": "-1", "_l2": "5"},
        {"_t": "1", "_l1": "-30"},
        {"_l1": "1", "_l2": "-20"},
    ],
)
def test_what_is_not_bounded_or_still_rises_has_no_largest_value(powers: dict[str, str]) -> None:
    found = Rewritten("t")
    with ball_precision(), pytest.raises(UnresolvedError):
        Expansions(found.scale, fmpq(1, 64)).largest({w: parse(x) for w, x in powers.items()})


def test_the_largest_value_is_one_of_the_range() -> None:
    found = Rewritten("t")
    with ball_precision():
        found.of(parse("exp(-1/t)"))
        (w,) = (w for w in found.scale.order if w not in CHAIN)
        for powers in ({"_t": "1", "_l1": "-3"}, {w: "1", "_t": "-5"}, {"_l1": "2", "_l2": "-1"}):
            for halvings in (16, 64):
                exact = {v: parse(x) for v, x in powers.items()}
                largest = Expansions(found.scale, fmpq(1, 2**halvings)).largest(exact)
                for part in range(1, 9):
                    at = _elements(found, arb(part) / 8 / 2**halvings)
                    value = arb(1)
                    for v, x in exact.items():
                        value *= at[v] ** found.scale.ball(x)
                    assert not value > largest


def test_a_sum_of_sizes_is_a_bound_of_the_sum() -> None:
    found = Rewritten("t")
    with ball_precision():
        expansions = Expansions(found.scale, fmpq(1, 4))
        total = expansions._total([Size(arb(2), {}), Size(arb(3), {"_t": number(1)})])
        assert not total.height < arb(2) + arb(3) / 4
        assert total.powers == {}
