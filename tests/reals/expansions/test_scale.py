"""The scale: its order, and signs and zeros of constants that are shown and not guessed."""

import pytest

from tresym.reals.expansions.scale import CHAIN, Leading, Scale, UnresolvedError
from tresym.reals.language.expression import ONE, number, sqrt, symbol
from tresym.reals.language.parsing import parse

pytestmark = pytest.mark.quick


@pytest.fixture
def scale() -> Scale:
    return Scale()


@pytest.mark.parametrize(
    ("constant", "sign"),
    [
        ("0", 0),
        ("-3/7", -1),
        ("sqrt(2)*sqrt(3) - sqrt(6)", 0),
        ("sqrt(2)*sqrt(3) - sqrt(6) - 1/10**60", -1),
        ("log(6) - log(2) - log(3)", 0),
        ("log(6) - log(2) - log(3) + 1/10**200", 1),
        ("sin(pi/5)**2 - (5 - sqrt(5))/8", 0),
        ("2 + sin(_u0)", 1),
        ("cos(_u0)**2 + sin(_u0)**2 - 1", 0),
    ],
)
def test_signs_of_constants(scale: Scale, constant: str, sign: int) -> None:
    scale.wave(ONE)
    assert scale.sign(parse(constant)) == sign


@pytest.mark.parametrize("constant", ["1 + sin(_u0)", "sin(_u0)", "1/sin(_u0)", "log(-1)"])
def test_no_sign_is_given_to_what_may_vanish_or_is_no_number(scale: Scale, constant: str) -> None:
    scale.wave(ONE)
    with pytest.raises(UnresolvedError):
        scale.sign(parse(constant))


@pytest.mark.parametrize(
    ("text", "zero"),
    [
        ("exp(_t)*exp(_l1) - exp(_t + _l1)", True),
        ("sqrt(_t**2) - _t", True),
        ("_t**100 - 1/10**300", False),
        ("abs(_t - 1) - (1 - _t)", False),  # 0 at both places where it is looked at
        ("log(-1)", False),  # its normal form is 0, but it is no number
    ],
)
def test_what_vanishes_does_so_for_all_positive_elements(
    scale: Scale, text: str, zero: bool
) -> None:
    assert scale.is_zero(parse(text)) is zero


def test_elements_are_in_the_order_of_their_growth(scale: Scale) -> None:
    t, l1 = (number(-1), number(-1))
    assert scale.growth({"_t": t, "_l1": number(1000)}) == 1
    assert scale.growth({"_t": number(1), "_l1": number(-1000)}) == -1
    assert scale.growth({"_l1": l1, "_l2": number(5)}) == 1
    assert scale.growth({}) == 0
    assert scale.compare({"_t": t}, {"_t": t}) == 0
    fast = scale.insert(1 / symbol("_t"), Leading(ONE, {"_t": number(-1)}))
    between = scale.insert(1 / sqrt(symbol("_l1")), Leading(ONE, {"_l1": parse("-1/2")}))
    faster = scale.insert(1 / symbol(fast), Leading(ONE, {fast: number(-1)}))
    assert scale.order == [faster, fast, "_t", between, *CHAIN[1:]]
    assert scale.growth({fast: number(1), "_t": number(-(10**6))}) == -1


def test_the_exponents_of_a_quotient_cancel_exactly(scale: Scale) -> None:
    p, q = {"_t": parse("log(6)")}, {"_t": parse("log(2) + log(3)")}
    assert scale.times(p, q, -1) == {}
    assert scale.times(p, {"_t": parse("log(2) + log(3) + 1/10**50")}, -1)


def test_a_height_of_the_same_order_is_found(scale: Scale) -> None:
    assert scale.like(Leading(number(3), {"_l1": number(-1)})) == "_t"
    assert scale.like(Leading(ONE, {"_l1": number(-2)})) is None
