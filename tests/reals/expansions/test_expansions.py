"""Enclosures hold at every point of their range, and none is given where it is too long."""

from itertools import pairwise

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.expansions import Expansions
from tresym.reals.expansions.gruntz import Rewritten
from tresym.reals.expansions.scale import CHAIN, UnresolvedError
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

TEXTS = cases(__file__, "TEXTS")


def _elements(found: Rewritten, t: arb) -> dict[str, arb]:
    """The values of the elements at t."""
    at = {CHAIN[0]: t}
    for w, v in pairwise(CHAIN):
        at[v] = -1 / at[w].log()
    for w in reversed(found.scale.order):
        if w not in at:
            at[w] = (-evaluate(found.scale.heights[w], at)).exp()
    return at


@pytest.mark.parametrize("text", TEXTS)
def test_an_enclosure_holds_at_the_points_of_its_range(text: str) -> None:
    e, enclosed = parse(text), 0
    found = Rewritten("t")
    with ball_precision(300):
        f = found.of(e)
        for halvings in (1, 2, 3, 5, 8, 13, 40, 100):
            expansions = Expansions(found.scale, fmpq(1, 2**halvings))
            try:
                about = expansions.enclosure(f)
                largest = expansions.size(f)
                signed = [expansions.enclosure(u) for u in found.signed]
            except UnresolvedError:
                continue
            if not all(u.low > 0 for u in signed):
                continue
            enclosed += 1
            for part in ("1", "0.93", "0.51", "0.2", "0.017", "0.0003"):
                t = arb(part) / 2**halvings
                value = evaluate(e, {"t": t})
                if not value.is_finite():
                    continue
                at = _elements(found, t)
                product = arb(1)
                for w, x in about.powers.items():
                    product *= at[w] ** found.scale.ball(x)
                assert not abs(value / product - about.k) > about.error
                bound = largest.height
                for w, x in largest.powers.items():
                    bound *= at[w] ** found.scale.ball(x)
                assert not abs(value) > bound
    assert enclosed


@pytest.mark.parametrize(
    ("text", "halvings"),
    [
        ("1 - 3*t", 1),
        ("log(1 - 3*t)", 1),
        ("1/(1 - 4*t)", 2),
        ("t*log(t)**9", 3),
        ("exp(-1/t)/t**9", 2),
        ("sqrt(1 - 3*t)", 1),
        ("1 - t*log(t)**4", 4),
    ],
)
def test_no_enclosure_is_given_on_a_range_that_is_too_long(text: str, halvings: int) -> None:
    """The function, or its product with elements, changes its sign or is not near its limit."""
    found = Rewritten("t")
    with ball_precision():
        f = found.of(parse(text))
        expansions = Expansions(found.scale, fmpq(1, 2**halvings))
        with pytest.raises(UnresolvedError):
            expansions.largest(expansions.enclosure(f).powers)
