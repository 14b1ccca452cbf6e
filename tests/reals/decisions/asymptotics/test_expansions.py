"""Enclosures hold at every point of their range, and none is given where it is too long."""

from itertools import pairwise

import pytest
from flint import arb, fmpq

from tresym.reals.decisions.asymptotics.expansions import Expansions, Size, plus, raised, times
from tresym.reals.decisions.asymptotics.gruntz import Rewritten
from tresym.reals.decisions.asymptotics.scale import CHAIN, UnresolvedError
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, number
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

TEXTS = [
    "exp(t)",
    "log(1 + t)",
    "sqrt(1 + t)",
    "(1 + t)**(-5/3)",
    "(1 - t)**7 - 1",
    "sin(t)",
    "cos(1 + t)",
    "tan(t/2)",
    "atan(3 + t)",
    "atan(1/t)",
    "atan(-t)/t**2",
    "asin(1 - t)",
    "sinh(t)/t - 1",
    "tanh(1/t) - 1",
    "t**t",
    "t**(1/t)",
    "exp(-1/t)*(t**(-3) + log(t))",
    "log(t)*log(-log(t))",
    "exp(1/t + log(t)**2) + exp(1/t)",
    "exp(sqrt(-log(t)))*t",
    "(3**(1/t) + 5**(1/t))**t",
    "exp(1/t)*(exp(t - exp(-1/t)) - exp(t))",
    "log(log(1/t + exp(1/t)))",
    "1/(1 - t - exp(-1/t)) - 1/(1 - t)",
    "abs(t - 1/100)",
    "cbrt(t - t**2)",
    "atan2(t, -1)",
    "(2 + sin(1/t))*t",
    "sin(1/t)*cos(2/t)/(3 + sin(1/t + t))",
    "abs(sin(1/t))",
    "exp(-exp(1/t))*exp(exp(1/t + t))",
]


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


@pytest.mark.quick
@pytest.mark.parametrize(
    ("form", "expected"),
    [
        (lambda: times(parse("sqrt(2)*x"), parse("sqrt(2)/x")), "2"),
        (lambda: times(parse("exp(x)"), parse("exp(-x)*y")), "y"),
        (lambda: plus(parse("x - y"), parse("2*y - x")), "y"),
        (lambda: raised(parse("sqrt(2)/2"), fmpq(-1)), "sqrt(2)"),
        (lambda: raised(parse("(x**2)"), fmpq(1, 2)), "sqrt(x**2)"),  # |x|, and not x
        (lambda: raised(parse("8"), fmpq(1, 2)), "sqrt(8)"),
        (lambda: raised(parse("exp(x)"), fmpq(1, 2)), "exp(x/2)"),
    ],
)
def test_coefficients_are_joined(form: object, expected: str) -> None:
    found: Expr = form()  # type: ignore[operator]
    assert found == parse(expected)


def test_a_sum_of_sizes_is_a_bound_of_the_sum() -> None:
    found = Rewritten("t")
    with ball_precision():
        expansions = Expansions(found.scale, fmpq(1, 4))
        total = expansions._total([Size(arb(2), {}), Size(arb(3), {"_t": number(1)})])
        assert not total.height < arb(2) + arb(3) / 4
        assert total.powers == {}
