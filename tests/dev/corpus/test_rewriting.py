"""Random identities: true by construction, and the same with a defect. Never a wrong verdict."""

from collections.abc import Callable
from fractions import Fraction
from random import Random

import pytest
from hypothesis import given as over
from hypothesis import strategies as st

from tresym.dev.corpus.rewriting import false_identity, true_identity
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    sqrt,
    substitute,
    symbol,
)
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

X, Y, A = symbol("x"), symbol("y"), symbol("a")

numbers = st.fractions(Fraction(-4), Fraction(4), max_denominator=3).map(number)
leaves = st.one_of(numbers, st.sampled_from([X, X, Y, A]))


def grow(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    """One more operation over the expressions of ``inner``."""
    functions = ["sin", "cos", "exp", "log", "atan", "sinh", "tanh", "abs", "asin", "asinh"]
    return st.one_of(
        st.tuples(inner, inner).map(lambda pair: add(*pair)),
        st.tuples(inner, inner).map(lambda pair: multiply(*pair)),
        inner.map(lambda e: power(e, number(2))),
        inner.map(sqrt),
        st.tuples(st.sampled_from(functions), inner).map(lambda pair: apply(*pair)),
        inner.map(lambda e: multiply(X, power(add(power(e, number(2)), number(1)), number(-1)))),
    )


expressions = st.recursive(leaves, grow, max_leaves=5)


def rule(left: str, right: str) -> Callable[[Expr, Expr], tuple[Expr, Expr]]:
    """A true identity in u and v as a function of what stands for them."""
    sides = parse(left), parse(right)

    def apply_rule(u: Expr, v: Expr) -> tuple[Expr, Expr]:
        both = {"u": u, "v": v}
        return substitute(sides[0], both), substitute(sides[1], both)

    return apply_rule


RULES = [
    rule("(u + v)**2", "u**2 + 2*u*v + v**2"),
    rule("sin(u + v)", "sin(u)*cos(v) + cos(u)*sin(v)"),
    rule("cos(2*u)", "1 - 2*sin(u)**2"),
    rule("exp(u)*exp(v)", "exp(u + v)"),
    rule("sqrt(u**2)", "abs(u)"),
    rule("log(u*v)", "log(abs(u)) + log(abs(v))"),
    rule("1/(1 + tan(u)**2)", "cos(u)**2"),
    rule("sqrt(u)*sqrt(v)", "sqrt(u*v)"),
    rule("sin(asin(u))", "u"),
    rule("tan(atan(u))", "u"),
    rule("cosh(u)**2 - sinh(u)**2", "1"),
    rule("asinh(-u)", "-asinh(u)"),
    rule("atan(u) + atan(1/u)", "pi/2*u/abs(u)"),
    rule("cos(asin(u))", "sqrt(1 - u**2)"),
    rule("exp(log(u) + v)", "u*exp(v)"),
    rule("1/u - 1/v", "(v - u)/(u*v)"),
    rule("(u**3 - v**3)/(u - v)", "u**2 + u*v + v**2"),
    rule("tanh(u)", "(exp(2*u) - 1)/(exp(2*u) + 1)"),
    rule("abs(u*v)", "abs(u)*abs(v)"),
    rule("sqrt(u + 1)", "(u + 1)**(3/2)/(u + 1)"),
]

CONDITIONS = [Given(), Given.parse("x > 0"), Given.parse("x > 0, a > 0, 0 < y <= 1")]


@st.composite
def true_identities(draw: st.DrawFn) -> tuple[Expr, Expr]:
    """Two sides of a rule, perhaps inside a common context."""
    left, right = draw(st.sampled_from(RULES))(draw(expressions), draw(expressions))
    context = draw(st.sampled_from(["z", "z*x + y", "exp(z)", "sin(z)", "sqrt(z**2 + 1)", "z**2"]))
    whole = parse(context)
    return substitute(whole, {"z": left}), substitute(whole, {"z": right})


@over(true_identities(), st.sampled_from(CONDITIONS))
@pytest.mark.slow
def test_true_is_never_refuted(sides: tuple[Expr, Expr], given: Given) -> None:
    decision = decide(*sides, given)
    assert decision.verdict is not Verdict.REFUTED, (str(sides[0]), str(sides[1]), decision)


@over(
    true_identities(),
    st.sampled_from(["1/10^60", "x/10^30", "1", "-1/1000", "sin(x)/10^20", "pi/10^9"]),
    st.sampled_from(CONDITIONS),
)
def test_false_is_never_proved(sides: tuple[Expr, Expr], defect: str, given: Given) -> None:
    left, right = sides
    decision = decide(left, right + parse(defect), given)
    assert decision.verdict is not Verdict.PROVED, (str(left), str(right), defect)


@over(expressions, expressions, st.sampled_from(CONDITIONS))
def test_unrelated_expressions_are_proved_only_when_equal(
    left: Expr, right: Expr, given: Given
) -> None:
    """A proof is contradicted by no point: balls of 300 bits overlap wherever both are defined."""
    from flint import arb

    from tresym.reals.domain.evaluation import evaluate
    from tresym.reals.language.expression import symbols
    from tresym.reals.numbers.arithmetic import ball_precision

    if decide(left, right, given).verdict is Verdict.PROVED:
        for point in given.points(symbols(left) | symbols(right), 40, start=200):
            with ball_precision(300):
                at = {name: arb(value) for name, value in point.items()}
                values = evaluate(left, at), evaluate(right, at)
            finite = all(value.is_finite() for value in values)
            assert not finite or values[0].overlaps(values[1])


@over(expressions)
def test_derivatives_agree_with_a_difference_quotient(e: Expr) -> None:
    """The formal derivative lies where the mean value theorem's quotient over a ball says."""
    from flint import arb, fmpq

    from tresym.reals.domain.evaluation import evaluate
    from tresym.reals.language.expression import symbols
    from tresym.reals.numbers.arithmetic import ball_precision

    slope = differentiate(e, "x")
    for point in Given().points(symbols(e) | {"x"}, 2):
        step = fmpq(1, 10**30)
        with ball_precision(400):
            at = {name: arb(value) for name, value in point.items()}
            ahead = at | {"x": arb(point["x"] + step)}
            between = at | {"x": at["x"].union(ahead["x"])}
            quotient = (evaluate(e, ahead) - evaluate(e, at)) / arb(step)
            enclosure = evaluate(slope, between)
        if quotient.is_finite() and enclosure.is_finite():
            assert enclosure.overlaps(quotient)


@over(expressions)
def test_text_round_trip(e: Expr) -> None:
    assert decide(parse(str(e)), e).verdict is not Verdict.REFUTED


# Rewritten on both sides, as the benchmark does at length: `tresym bench check`.


@over(st.randoms(use_true_random=False))
def test_rewritten_is_never_refuted(random: Random) -> None:
    left, right = true_identity(random)
    decision = decide(left, right)
    assert decision.verdict is not Verdict.REFUTED, (str(left), str(right), decision)


@over(st.randoms(use_true_random=False))
def test_rewritten_and_changed_is_never_proved(random: Random) -> None:
    left, right = false_identity(random)
    assert decide(left, right).verdict is not Verdict.PROVED, (str(left), str(right))
