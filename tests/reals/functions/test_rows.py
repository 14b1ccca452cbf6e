"""The rows of the table of functions: every fact against mpmath or balls at random points."""

from __future__ import annotations

import random
from typing import Any

import pytest
from flint import arb, arb_series, ctx, fmpq
from in_mpmath import IN_MPMATH

import tresym
from tresym.reals.domain.evaluation import UndefinedError, evaluate
from tresym.reals.domain.operation_domains import needs_of
from tresym.reals.functions.enclosures import literal
from tresym.reals.functions.table import SPECIAL, TABLE, upright
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, as_expr, number, substitute, symbol, trees
from tresym.reals.language.parsing import parse
from tresym.reals.normal.special_forms import reduced
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.verdict import Verdict

BITS, DIGITS, POINTS, MANY = 160, 60, 12, 200
PUBLIC = sorted(name for name in SPECIAL if not TABLE[name].internal)


PARAMETERS = {
    "polygamma": (1, 2, 4),
    "zetaderiv": (1, 2),
    "expint": (1, 2, fmpq(1, 2), 0),
    "uppergamma": (2, fmpq(1, 3), fmpq(-1, 2), 0),
    "lowergamma": (2, fmpq(1, 3)),
    "besselj": (0, 1, 3, fmpq(1, 3), fmpq(5, 2)),
    "bessely": (0, 1, 2, fmpq(1, 3)),
    "besseli": (0, 1, 2, fmpq(1, 3), fmpq(-1, 3)),
    "besselk": (0, 1, 2, fmpq(1, 3)),
    "elliptic_f": (fmpq(1, 5), fmpq(-3, 2)),
    "elliptic_e_inc": (fmpq(1, 5), fmpq(-3, 2)),
    "elliptic_pi": (fmpq(1, 3), fmpq(-2)),
    "polylog": (2, 3, fmpq(3, 2), -1),
}
"""Values of the first argument."""
ENDS = {
    "elliptic_k": (1, -1), "elliptic_e": (1, -1), "elliptic_pi": (1, -1), "polylog": (1, -1),
    "zeta": (1, 1), "zetaderiv": (1, 1), "li": (1, 1),
}  # fmt: skip
"""An end of the domain and the side from which points approach it."""


def points(name: str, count: int) -> list[tuple[fmpq, ...]]:
    """Points of the domain: moderate ones, small and large ones, and near an end."""
    chance = random.Random(name)
    found: list[tuple[fmpq, ...]] = []
    while len(found) < count:
        size = chance.choice((fmpq(1), fmpq(1), fmpq(4), fmpq(12), fmpq(1, 1000), fmpq(1, 10**9)))
        x = size * fmpq(chance.randrange(-(10**6), 10**6), 10**6)
        if name in ENDS and chance.random() < 0.4:
            end, side = ENDS[name]
            x = end + side * abs(x) / 3
        if TABLE[name].constant:
            x = fmpq(1)
        if name.startswith("lambertw") and x < 0:
            x = x / 40
        args = (fmpq(chance.choice(PARAMETERS[name])), x) if name in PARAMETERS else (x,)
        node = Expr(name, tuple(map(number, args)))
        with ball_precision(BITS):
            inside = all(
                (evaluate(part, {}) > 0) or (relation == "!=" and evaluate(part, {}) < 0)
                for part, relation in needs_of(node)
            )
        if inside and x != 0:
            found.append(args)
    return found


def contains(name: str, args: tuple[fmpq, ...], ball: arb) -> bool:
    """Whether a ball contains mpmath's value, to its last digits but few."""
    with mp_precision(DIGITS) as m:
        value = IN_MPMATH[name](m, *(m.mpf(int(x.p)) / int(x.q) for x in args))
        text = m.nstr(m.re(value), DIGITS)
    with ball_precision(400):
        exact = arb(text)
        slack = abs(exact) * arb(10) ** (12 - DIGITS) + arb(10) ** (6 - 2 * DIGITS)
        return bool((exact + arb(0, 1) * slack).overlaps(ball))


def look(name: str, count: int) -> None:
    row, tight = TABLE[name], 0
    places = points(name, count)
    for args in places:
        with ball_precision(BITS):
            value = row.ball(*map(arb, args))
            wide = row.ball(*map(arb, args[:-1]), arb(args[-1]) + arb(0, abs(arb(args[-1])) / 100))
        assert value.is_finite(), (name, args)
        assert contains(name, args, value), (name, args, value)
        assert not wide.is_finite() or contains(name, args, wide), (name, args, wide)
        if row.range.low is not None:
            assert not value < arb(row.range.low)
        if row.range.high is not None:
            assert not value > arb(row.range.high)
        tight += value.rel_accuracy_bits() > 60
    assert tight > len(places) * 2 // 3, f"{name}: {tight} of {len(places)}"


@pytest.mark.parametrize("name", PUBLIC)
def test_balls_contain_the_values_of_mpmath(name: str) -> None:
    look(name, POINTS)


@pytest.mark.night
@pytest.mark.parametrize("name", PUBLIC)
def test_balls_contain_the_values_of_mpmath_at_many_points(name: str) -> None:
    look(name, MANY)


@pytest.mark.parametrize("name", sorted(SPECIAL))
def test_derivatives_and_series_agree(name: str) -> None:
    """The derivative formula, and the power series, lie in the hull of difference quotients."""
    row = TABLE[name]
    if row.derivatives[-1] is None or row.constant:
        return
    public = name if name in PUBLIC else "rgamma"
    for args in points(public, 4) if name in PUBLIC or name == "rgamma" else [(fmpq(2, 7),)] * 1:
        args = args if len(args) == row.arity else (fmpq(4, 3), *args)
        inner = tuple(map(number, args[:-1]))
        slope = differentiate(Expr(name, (*inner, symbol("x"))), "x")
        with ball_precision(400):
            x, step = arb(args[-1]), arb((1, -90)) * abs(arb(args[-1]))
            known = [arb(value) for value in args[:-1]]
            found = evaluate(slope, {"x": x})
            before, after = row.ball(*known, (x - step).mid()), row.ball(*known, (x + step).mid())
            quotient = (after - before) / (2 * step)
            near = abs(found) * arb((1, -80)) + arb((1, -100))
            assert not found.is_finite() or abs(found - quotient) < near, (name, args)
        with ball_precision(BITS):
            if row.series is not None:
                ctx.cap = 3
                at = arb_series([arb(args[-1]), 1], 3)
                series = row.series(*(arb_series([arb(v)], 3) for v in args[:-1]), at)
                assert not series[1].is_finite() or series[1].overlaps(found), (name, args)


@pytest.mark.parametrize("name", sorted(SPECIAL))
def test_rewriting_and_formulas_near_ends_keep_the_value(name: str) -> None:
    row = TABLE[name]
    places = points(name, 6) if name in PUBLIC or name == "rgamma" else []
    for args in places:
        node = Expr(name, tuple(map(number, args)))
        forms = [reduced(node)]
        shifted = Expr(
            name, tuple(symbol("x") if n == row.shifted else number(v) for n, v in enumerate(args))
        )
        for moved in (symbol("x") + 3, symbol("x") - 2, 2 - symbol("x")):
            other = reduced(substitute(shifted, {"x": moved}))
            if other is not None:
                at = {"x": args[row.shifted]}
                with ball_precision(BITS):
                    one, two = (evaluate(e, at) for e in (substitute(shifted, {"x": moved}), other))
                assert not (one.is_finite() and two.is_finite()) or one.overlaps(two), (name, args)
        x = args[-1]
        for place, formula in row.near.items():
            above = place == "oo" or place.endswith("+")
            end = 0 if "oo" in place else int(place[:-1])
            if (x > end) is above or place == "oo":
                if "oo" in place and (x > 0) is not (place == "oo"):
                    continue
                found = formula(*node.args, trees)
                forms.append(None if found is None else as_expr(found))
        with ball_precision(BITS):
            value = evaluate(node, {})
            for form in forms:
                other = arb.nan() if form is None else evaluate(form, {})
                assert not other.is_finite() or other.overlaps(value), (name, args, form)


@pytest.mark.parametrize("name", sorted(n for n in SPECIAL if TABLE[n].remainder))
def test_the_remainder_of_an_expansion_is_bounded(name: str) -> None:
    row = TABLE[name]
    order: tuple[Any, ...] = (number(fmpq(1, 3)),) if row.arity == 2 else ()
    for k in (2, 5, 9):
        with ball_precision(600):
            v = arb(fmpq(1, 3 * 2**k))
            balls = [arb(literal(e) or 0) for e in order]
            value = row.ball(*balls, v)
            assert value.is_finite()
            for n in (1, 2, 3, 5):
                bound = row.remainder(*balls, v, n) if row.remainder else arb(0)
                if not bound.is_finite():
                    continue
                total = arb(0)
                for j in range(n):
                    term = row.taylor(*order, j, trees) if row.taylor else None
                    total += evaluate(as_expr(term), {}) * v**j
                assert abs(value - total) <= bound * v**n * (1 + arb((1, -60))), (name, k, n)


@pytest.mark.parametrize(
    ("name", "claim"), [(name, c) for name, row in TABLE.items() for c in row.falsehoods]
)
def test_falsehoods_of_rows_are_refuted(name: str, claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED, (name, claim)


def test_rows_are_complete() -> None:
    for name, row in TABLE.items():
        assert name == row.name
        assert len(row.derivatives) == row.arity
        if not row.internal:
            assert len(row.falsehoods) >= 2, name
            assert row.definition, name
            assert row.source or row.theory, name
            assert upright(row), name


def test_a_point_outside_the_domain_has_no_value() -> None:
    for text in (
        "elliptic_k(2)",
        "lambertw(-1)",
        "Ci(-1)",
        "gamma(-2)",
        "zeta(1)",
        "loggamma(-1/2)",
        "besselk(0, -1)",
        "polylog(2, 3/2)",
        "li(1)",
        "expint(1, 0)",
        "uppergamma(2, -1)",
    ):
        with ball_precision():
            try:
                value = evaluate(parse(text), {})
            except UndefinedError:
                continue
            assert not value.is_finite(), text
