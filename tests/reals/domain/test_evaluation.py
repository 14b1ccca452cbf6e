"""Values in balls that contain the truth, and NaN wherever none is shown."""

from fractions import Fraction

import mpmath
import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.evaluation import evaluate, stands, undefined_parts
from tresym.reals.language.expression import FUNCTIONS, apply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision

small = st.fractions(-3, 3, max_denominator=50)


def _exact(x: Fraction) -> arb:
    return arb(fmpq(x.numerator, x.denominator))


def _wide(low: str, high: str) -> arb:
    return arb(fmpq(*map(int, low.split("/")))).union(arb(fmpq(*map(int, high.split("/")))))


@given(small, small)
def test_rational_expressions_contain_the_fraction(x: Fraction, y: Fraction) -> None:
    value = (x - 2 * y) ** 3 * (x * y + Fraction(1, 7)) / (1 + x**2) - abs(x - y)
    e = parse("(x - 2*y)**3*(x*y + 1/7)/(1 + x**2) - abs(x - y)")
    found = evaluate(e, {"x": _exact(x), "y": _exact(y)})
    assert (found * value.denominator).contains(value.numerator)


WIDE = ["x**2", "x**3", "x**4 - x", "abs(x)", "cbrt(x)", "x**2*exp(x)", "cos(3*x)", "(x - 1)**5"]


@given(st.sampled_from(WIDE), small, small.filter(bool), st.fractions(0, 1, max_denominator=20))
def test_a_wide_ball_contains_every_value_in_it(
    text: str, low: Fraction, width: Fraction, part: Fraction
) -> None:
    e, high = parse(text), low + abs(width)
    whole = evaluate(e, {"x": _exact(low).union(_exact(high))})
    inside = evaluate(e, {"x": _exact(low + part * (high - low))})
    assert whole.is_finite()
    assert whole.overlaps(inside)


@pytest.mark.parametrize("name", sorted(FUNCTIONS - {"cbrt", "sign", "abs"}))
def test_functions_agree_with_mpmath(name: str) -> None:
    x = Fraction(17, 10) if name == "acosh" else Fraction(-7, 10) if name != "log" else Fraction(2)
    with mp_precision(50) as m, ball_precision(160):
        found = evaluate(apply(name, symbol("x")), {"x": _exact(x)})
        expected = getattr(m, name)(m.mpf(x.numerator) / x.denominator)
        assert abs(found - arb(mpmath.nstr(expected, 45))) < arb(10) ** -40


@pytest.mark.parametrize(
    ("text", "x", "value"),
    cases(__file__, "values_that_are_known"),
)
def test_values_that_are_known(text: str, x: str, value: str) -> None:
    at = {"x": arb(fmpq(*map(int, x.split("/"))))}
    found = evaluate(parse(text), at)
    assert abs(found - evaluate(parse(value), {})) < 1e-12


UNDEFINED = cases(__file__, "UNDEFINED")


@pytest.mark.parametrize(("text", "low", "high"), UNDEFINED)
def test_nothing_is_said_where_a_part_is_not_shown_to_be_real(
    text: str, low: str, high: str
) -> None:
    for whole in (text, f"{text} - {text}", f"0*({text})"):
        assert not evaluate(parse(whole), {"x": _wide(low, high)}).is_finite()


@pytest.mark.parametrize("text", ["sqrt(x)", "abs(x)", "x**2", "x**(3/2)", "sqrt(x)*log(x + 1)"])
def test_the_end_of_a_domain_has_its_value(text: str) -> None:
    assert evaluate(parse(text), {"x": arb(0)}) == 0


def test_a_variable_without_value_is_an_error() -> None:
    with pytest.raises(KeyError):
        evaluate(parse("x + y"), {"x": arb(1)})


def test_known_values_are_used_and_added() -> None:
    e = parse("sin(x) + 1")
    known = {parse("sin(x)"): arb(5)}
    assert evaluate(e, {"x": arb(0)}, known) == 6
    assert known[e] == 6


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("1 + log(sqrt(x) - 1)", {"sqrt(x)"}),
        ("log(x) + asin(x - 3)", {"log(x)", "asin(x - 3)"}),
        ("log(x)/log(x)", {"log(x)"}),
        ("1/(x + 2) + exp(x)", {"(x + 2)**(-1)"}),
        ("exp(x)", set()),
    ],
)
def test_the_innermost_undefined_parts(text: str, parts: set[str]) -> None:
    found = undefined_parts([parse(text)], {"x": arb(-2)})
    assert found == {parse(part) for part in parts}


def test_a_long_number_is_contained() -> None:
    third = number(Fraction(10**40 + 1, 3 * 10**40))
    with ball_precision(30):
        assert (evaluate(third, {}) * 3 * 10**40).contains(10**40 + 1)


@pytest.mark.parametrize("relation", [">", ">=", "<", "<=", "!=", "=="])
def test_what_has_no_value_or_reaches_0_stands_in_no_strict_relation(relation: str) -> None:
    assert not stands(arb.nan(), relation)
    assert not stands(arb(0, 1), relation)
    assert stands(arb(0), relation) is ("=" in relation and relation != "!=")
    assert stands(arb(1), relation) is (relation in (">", ">=", "!="))
    assert stands(arb(-1), relation) is (relation in ("<", "<=", "!="))


def test_infinity_is_no_value_that_differs_from_0() -> None:
    assert not stands(arb("inf"), "!=")


TAPES = cases(__file__, "TAPES")


@pytest.mark.parametrize("text", TAPES)
def test_a_compiled_tree_gives_what_evaluating_does(text: str) -> None:
    """At points and over boxes, at any precision, and nothing where there is nothing."""
    e = parse(text)
    compiled = Compiled(e, ["x", "y"])
    for bits in (53, 200):
        with ball_precision(bits):
            for n in range(-3, 9):
                for radius in (0, fmpq(1, 10), 2):
                    x, y = (arb(fmpq(k, 4)) + arb(0, radius) for k in (n, 2 * n + 1))
                    found, expected = compiled.real(x, y), evaluate(e, {"x": x, "y": y})
                    assert found.is_finite() == expected.is_finite()
                    if found.is_finite():
                        assert found.overlaps(expected)
                        assert found.rad() <= 2 * expected.rad() + arb((1, 9 - bits))
