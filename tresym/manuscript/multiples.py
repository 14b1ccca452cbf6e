r"""Recognise an equation that is an earlier one, multiplied or divided by a factor.

``x^4 (S'' + S'^2) - 1 = 0`` and, "after division", ``S'' + S'^2 - x^{-4} = 0`` say the same. The
factor that is sought is a product c · x^j · y^k … of powers of the symbols. Its exponents are read
off numerically: at points p the logarithms of the ratio of both differences are linear in log p, so
that one more point than there are symbols determines c, j, k, …. The candidate is then proved like
any other claim: the one difference is the factor times the other.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, arb_mat, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import ONE, Expr, multiply, number, power, symbol, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

MOST_SYMBOLS = 8


class Multiple(NamedTuple):
    """A candidate: the claim that proves it, and the factor."""

    claim: str
    factor: Expr


def multiple_of(first: Compared, second: Compared) -> Multiple | None:
    """Return the claim that the second equation is the first one times a factor, if it may be."""
    try:
        one, other = (left - right for left, _, right in (first, second))
        names = sorted(symbols(one) | symbols(other))
        if not (elementary(one, other) and 0 < len(names) <= MOST_SYMBOLS and one != other):
            return None
        if _factor(ONE, one, names) is not None:
            return None  # any product of powers is another one times a factor: x = 0 and y = 0
        factor = _factor(one, other, names)
        return None if factor is None else Multiple(f"{other} == {multiply(factor, one)}", factor)
    except (InputError, ZeroDivisionError):
        return None


def _factor(one: Expr, other: Expr, names: Sequence[str]) -> Expr | None:
    """Return the factor whose logarithm fits at some points, or None."""
    r = random.Random(0)
    rows, values, signs = [], [], set()
    with ball_precision(200):
        for _ in names, *names:
            at = {name: fmpq(r.randint(1009, 4001), 1013) for name in names}
            below, above = evaluate(one, at), evaluate(other, at)
            if below.contains(0) or above.contains(0):
                return None
            ratio = above / below
            signs.add(bool(ratio > 0))
            rows.append([arb(1), *(arb(at[name]).log() for name in names)])
            values.append([abs(ratio).log()])
        if len(signs) > 1:
            return None
        try:
            found = arb_mat(rows).solve(arb_mat(values))
        except ZeroDivisionError:
            return None
        size = _rational(found[0, 0].exp())
        exponents = [_rational(found[n + 1, 0] + 100) for n in range(len(names))]
    if size is None or None in exponents:
        return None
    powers = [
        power(symbol(name), number(exponent - 100))
        for name, exponent in zip(names, exponents, strict=True)
        if exponent is not None and exponent != 100
    ]
    return multiply(number(size if True in signs else -size), *powers)


def _rational(x: arb) -> fmpq | None:
    """Return the simple rational number in a ball, or None."""
    for below in range(1, 13):
        scaled = x * below
        whole = (scaled.mid() + 0.5).floor().unique_fmpz()
        if whole is not None and scaled.rad() < 1e-9 and (scaled - whole).contains(0):
            return fmpq(int(whole), below)
    return None
