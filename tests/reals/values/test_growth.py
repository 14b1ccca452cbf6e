"""The bounds of growth hold at every point that is tried, on the real axis and on discs."""

import pytest
from cases import cases
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.evaluation import UndefinedError, evaluate
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.values.growth import DivergesError, FartherError, Growth, Scale, Sum

STARTS = (4, 16, 64, 1024)
AT_INFINITY = tuple(cases(__file__, "AT_INFINITY"))
AT_ZERO = tuple(cases(__file__, "AT_ZERO"))
ON_DISCS = tuple(cases(__file__, "ON_DISCS"))


def no_values(e: Expr) -> arb:
    return evaluate(e, {})


def vanishes(e: Expr) -> bool:
    return str(e) == "cos(2 - 0) - cos(2)" or evaluate(e, {}).is_zero() or "cos(2)" in str(e)


def found(text: str, **more: bool) -> tuple[Growth, Sum]:
    for start in STARTS:
        growth = Growth("t", fmpq(start), no_values, vanishes=vanishes, **more)
        try:
            return growth, growth.terms(parse(text))
        except FartherError:
            continue
    raise AssertionError(text)


def bound(growth: Growth, terms: Sum, t: arb) -> arb:
    """The enclosure at a point: each coefficient times its scale."""
    total: arb = arb(0)
    for c, m, _ in terms:
        total += c * growth.at_start(m, t)
    return total


@pytest.mark.parametrize(("text", "at_zero"), [(x, False) for x in AT_INFINITY]
                         + [(x, True) for x in AT_ZERO])  # fmt: skip
@given(st.fractions(0, 1, max_denominator=1000))
@pytest.mark.slow
def test_the_enclosure_contains_the_value(text: str, at_zero: bool, far: object) -> None:
    with ball_precision(200):
        growth, terms = found(text, at_zero=at_zero)
        share = fmpq(far.numerator, far.denominator)  # type: ignore[attr-defined]
        t = growth.top * (1 + 30 * arb(share) ** 3)
        x = 1 / t if at_zero else t
        value = evaluate(parse(text), {"t": x})
        assert value.is_finite()
        assert value.overlaps(bound(growth, terms, t)), (value, terms)
        lead, scale = growth.lead(terms)
        assert value.overlaps(lead * growth.at_start(scale, t))


@pytest.mark.parametrize("text", ON_DISCS)
@given(st.fractions(0, 1, max_denominator=500), st.fractions(-1, 1, max_denominator=500))
@pytest.mark.slow
def test_on_a_disc_it_contains_complex_values(text: str, size: object, turn: object) -> None:
    with ball_precision(200):
        growth, terms = found(text, at_zero=True, disc=True)
        radius = arb(fmpq(size.numerator, size.denominator)) / growth.top  # type: ignore[attr-defined]
        angle = arb(fmpq(turn.numerator, turn.denominator)) * arb.pi() / 2  # type: ignore[attr-defined]
        z = acb(radius * angle.cos(), radius * angle.sin())
        value = Compiled(parse(text), "t", no_values).holomorphic(z)
        if value.is_finite():
            assert growth.range(terms).overlaps(value)


@pytest.mark.parametrize(
    ("text", "at_zero"),
    [
        ("1/t", False), ("1/(t*log(t))", False), ("exp(t)/t**9", False), ("t*sin(1/t)", False),
        ("1/sqrt(t) - 1/sqrt(t + 1) + 1/t", False),
    ],
)  # fmt: skip
def test_what_diverges_is_told(text: str, at_zero: bool) -> None:
    with ball_precision(200):
        growth, terms = found(text, at_zero=at_zero)
        with pytest.raises(DivergesError):
            growth.tail(terms, growth.top)


@pytest.mark.parametrize(
    "text",
    [
        "sin(t)/t",  # not absolutely
        "1/(t*log(t)**2)",  # by a logarithm
        "1/(exp(t) - exp(t))",
        "log(sin(t))",
        "sqrt(1 - t)",
    ],
)
def test_what_is_not_bounded_gets_no_tail(text: str) -> None:
    with ball_precision(200):
        try:
            growth, terms = found(text)
        except (UndefinedError, AssertionError):
            return
        with pytest.raises(UndefinedError):
            growth.tail(terms, growth.top)


@pytest.mark.parametrize(
    ("text", "start"),
    [("exp(-t)*t**3", 8), ("exp(-sqrt(t))", 64), ("log(t)**2/t**3", 16), ("t**(-3/2)", 4)],
)
def test_a_tail_is_an_upper_bound(text: str, start: int) -> None:
    import mpmath

    with ball_precision(200):
        growth, terms = found(text)
        rest = growth.tail(terms, arb(start))
    code = text.replace("exp", "mpmath.exp").replace("sqrt", "mpmath.sqrt")
    code = code.replace("log", "mpmath.log").replace("(-3/2)", "mpmath.mpf(-1.5)")
    true = mpmath.quad(lambda t: eval(code, {"t": t, "mpmath": mpmath}), [start, mpmath.inf])
    assert float(rest.mid()) >= float(true) * 0.999999


def test_scales_are_ordered() -> None:
    exponential = Scale(((fmpq(1), fmpq(-1)),), fmpq(9), fmpq(0))
    power = Scale((), fmpq(-1, 2), fmpq(3))
    logarithm = Scale((), fmpq(0), fmpq(-1))
    assert exponential.growth() == power.growth() == logarithm.growth() == -1
    assert (exponential * power**-1).growth() == -1
    assert (power * logarithm**-1).growth() == -1
    assert (power * power**-1).growth() == 0
