"""Infinite sums and products whose values are quoted theorems, with sources.

The table holds the power series of elementary functions, the partial fractions and infinite
products of the trigonometric and hyperbolic functions, and the zeta function at even integers. A
term matches an entry if one exact identity proves it; candidates for the parameter are the
arguments of the functions in the claim. Equation numbers refer to the *NIST Digital Library of
Mathematical Functions* (DLMF).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import factorial
from typing import NamedTuple

from flint import fmpq, fmpz

from tresym.reals.decisions.hypergeometric import (
    Series,
    folded,
    out_of_range,
    polynomial,
    root,
    series_of,
)
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import preorder
from tresym.reals.language.binders import elementary, total
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    opened,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict


class Quoted(NamedTuple):
    """The value of a sum or product, and the theorem that states it."""

    value: Expr
    source: str


class _Fraction(NamedTuple):
    """``Σ sign^n above/below``, from n = 1 on, or ``Π below`` with ``above`` 1, is ``value``."""

    alternating: bool
    above: str
    below: str
    value: str
    source: str


_N = "n"
FRACTIONS = (
    _Fraction(False, "1", "n**2 - a**2", "(1 - pi*a*cot(pi*a))/(2*a**2)", "DLMF 4.22.3"),
    _Fraction(True, "1", "n**2 - a**2", "(1 - pi*a*csc(pi*a))/(2*a**2)", "DLMF 4.22.5"),
    _Fraction(False, "1", "n**2 + a**2", "(pi*a*coth(pi*a) - 1)/(2*a**2)", "DLMF 4.36.3"),
    _Fraction(True, "1", "n**2 + a**2", "(pi*a*csch(pi*a) - 1)/(2*a**2)", "DLMF 4.36.5"),
    _Fraction(False, "1", "(2*n-1)**2 - a**2", "pi*tan(pi*a/2)/(4*a)", "DLMF 4.22.3 and 4.21.27"),
    _Fraction(False, "1", "(2*n-1)**2 + a**2", "pi*tanh(pi*a/2)/(4*a)", "DLMF 4.36.3 and 4.35.26"),
    _Fraction(True, "2*n-1", "(2*n-1)**2 - a**2", "-pi*sec(pi*a/2)/4", "DLMF 4.22.5 at pi/2 - z"),
    _Fraction(
        True, "2*n-1", "(2*n-1)**2 + a**2", "-pi*sech(pi*a/2)/4", "DLMF 4.22.5 at pi/2 - i z"
    ),
)
"""Partial fractions; the sums converge locally uniformly, so at a = 0 the value is the limit."""
PRODUCTS = (
    _Fraction(False, "1", "1 - a**2/n**2", "sin(pi*a)/(pi*a)", "DLMF 4.22.1"),
    _Fraction(False, "1", "1 - a**2/(2*n-1)**2", "cos(pi*a/2)", "DLMF 4.22.2"),
    _Fraction(False, "1", "1 + a**2/n**2", "sinh(pi*a)/(pi*a)", "DLMF 4.36.1"),
    _Fraction(False, "1", "1 + a**2/(2*n-1)**2", "cosh(pi*a/2)", "DLMF 4.36.2"),
)


class Template(NamedTuple):
    """``y^q Σ f(k) y^(p k)``, with f(0) = 1 and the ratio of terms ``above/below`` in k."""

    function: str
    step: int
    start: int
    above: str
    below: str


TEMPLATES = (
    Template("exp(y)", 1, 0, "1", "k + 1"),
    Template("sin(y)", 2, 1, "-1", "(2*k + 2)*(2*k + 3)"),
    Template("cos(y)", 2, 0, "-1", "(2*k + 1)*(2*k + 2)"),
    Template("sinh(y)", 2, 1, "1", "(2*k + 2)*(2*k + 3)"),
    Template("cosh(y)", 2, 0, "1", "(2*k + 1)*(2*k + 2)"),
    Template("-log(1 - y)", 1, 1, "k + 1", "k + 2"),
    Template("atan(y)", 2, 1, "-(2*k + 1)", "2*k + 3"),
    Template("atanh(y)", 2, 1, "2*k + 1", "2*k + 3"),
    Template("asin(y)", 2, 1, "(2*k + 1)**2", "(2*k + 2)*(2*k + 3)"),
    Template("asinh(y)", 2, 1, "-(2*k + 1)**2", "(2*k + 2)*(2*k + 3)"),
    Template("asin(y)**2", 2, 2, "4*(k + 1)**2", "(2*k + 3)*(2*k + 4)"),
    Template("1/(1 - y)", 1, 0, "1", "1"),
    Template("1/(1 - y)**2", 1, 0, "k + 2", "k + 1"),
    Template("(1 + y)/(1 - y)**3", 1, 0, "(k + 2)**2", "(k + 1)**2"),
    Template("1/sqrt(1 - y)", 1, 0, "2*k + 1", "2*k + 2"),
)
"""Power series; the tests show each by its differential equation."""


def quoted_total(node: Expr, others: Iterable[Expr], given: Given) -> Quoted | None:
    """Return the value of an infinite sum or product, or None if it is not in the table.

    Args:
        others: expressions in which candidates for the parameters are sought.
    """
    (n,), body = opened(node, given.names)
    low, high = node.args[1:]
    try:
        if low == -INFINITY and high == INFINITY and node.op == "sum":
            return _on_both_sides(body, n, [*others, body], given)
        if high != INFINITY or low.op != "number" or low.args[0].q != 1:
            return None
        for more in (0, 1, 2, -1, -2):
            start = number(low.args[0] - more)
            found = _value(total(node.op, body, n, start, high), [*others, body], given)
            if found is not None and _is_number(found.value):
                return _with_terms(found, node.op, body, n, int(low.args[0].p), more)
    except InputError:
        return None
    return None


def quoted_product(node: Expr, given: Given) -> Quoted | None:
    """Return the value of a finite product whose factors depend on n, or None."""
    (k,), body = opened(node, given.names)
    low, count = node.args[1], node.args[2] + 1
    if node.op != "product" or body.op != "sin" or count.op != "symbol":
        return None
    if sign(count - 1, given, ">=") not in PROVING[">="]:
        return None
    start = substitute(body.args[0], {k: ZERO})
    step = symbol(k) * PI / count
    if low == ZERO and _same(body.args[0], start + step, given):
        value = apply("sin", count * start) / number(2) ** (count - 1)
        return Quoted(value, "DLMF 4.21.35") if start != ZERO else None
    if low == ONE and _same(body.args[0], step, given):
        return Quoted(count / number(2) ** (count - 1), "DLMF 4.21.35 at z = 0")
    return None


def _value(node: Expr, others: list[Expr], given: Given) -> Quoted | None:
    """What a theorem says of it as it stands, its index counted from 1 on."""
    (n,), body = opened(node, given.names)
    if node.op == "sum":
        series = series_of(node, given.names)
        found = None if series is None else _power_series(series, given)
        if found or not elementary(body):  # with factorials there is nothing else
            return found
    body = substitute(body, {n: symbol(n) + (node.args[1] - 1)})
    if node.op == "product":
        return _product(body, n, others, given)
    return _zeta(body, n, given) or _fraction(body, n, others, given)


def _with_terms(found: Quoted, kind: str, body: Expr, n: str, low: int, more: int) -> Quoted | None:
    """What is left of a value without the terms that it has more, or with those that it lacks."""
    numbers = range(low - more, low) if more > 0 else range(low, low - more)
    terms = [folded(substitute(body, {n: number(k)})) for k in numbers]
    known = [term for term in terms if term is not None]
    if len(known) < len(terms):
        return None
    up = -1 if more > 0 else 1
    if kind == "product":
        return found._replace(value=found.value * multiply(*known) ** number(up))
    return found._replace(value=found.value + up * add(*known) if known else found.value)


def _is_number(e: Expr) -> bool:
    """Whether a constant is one: of theorems with parameters some have none where it is a limit."""
    with ball_precision():
        return bool(symbols(e)) or bool(evaluate(e, {}).is_finite())


def _same(left: Expr, right: Expr, given: Given = Given()) -> bool:  # noqa: B008 - frozen
    return left == right or decide(left, right, given).verdict is Verdict.PROVED


# Power series


def _power_series(s: Series, given: Given) -> Quoted | None:
    if out_of_range(s, given):
        return None
    for t in TEMPLATES:
        above, below = (polynomial(parse(text), "k") for text in (t.above, t.below))
        one, other = s.above * below, s.below * above
        scale = one[one.degree()] / other[other.degree()]
        whole = t.step == s.step or s.u == ONE
        if one != scale * other or not whole or (scale < 0 and t.step == 2):
            continue
        y = root(abs(scale), t.step) * s.u
        y = -y if scale < 0 else y
        value = substitute(parse(t.function), {"y": y})
        head = s.head * s.u ** number(s.start) / y ** number(t.start)
        return Quoted(in_lowest_terms(head * value), f"the power series of {t.function}")
    return None


# The zeta function and its like


def _zeta(body: Expr, n: str, given: Given) -> Quoted | None:
    """``Σ c/n^m`` from 1 on with m even, alternating or not, and of odd n."""
    alternating, rest = _stripped(body, n)
    for m in range(1, 9):
        for odd, base in ((False, symbol(n)), (True, 2 * symbol(n) - 1)):
            c = in_lowest_terms(rest * base ** number(m))
            if n in symbols(c) or not _same(rest, c * base ** number(-m), given):
                continue
            value = _value_of_zeta(m, alternating, odd)
            return None if value is None else Quoted(c * value, "DLMF 24.8 and 25.6")
    return None


def _value_of_zeta(m: int, alternating: bool, odd: bool) -> Expr | None:
    """``Σ (±1)^n/n^m`` or ``Σ (±1)^n/(2n − 1)^m`` from n = 1 on."""
    if odd and alternating:
        if m % 2 == 0:
            return None
        euler = abs(int(fmpz.euler_number(m - 1)))
        return -number(fmpq(euler, 2 * factorial(m - 1))) * (PI / 2) ** number(m)
    if m % 2:
        return None
    zeta = abs(fmpq.bernoulli(m)) * fmpq(2) ** (m - 1) / factorial(m)
    factor = fmpq(2) ** (1 - m) - 1 if alternating else fmpq(1)
    factor = 1 - fmpq(2) ** -m if odd else factor
    return number(zeta * factor) * PI ** number(m)


def _stripped(body: Expr, n: str) -> tuple[bool, Expr]:
    """Whether (−1)^n is a factor, and the rest."""
    factors = list(body.args) if body.op == "*" else [body]
    rest, alternating = [], False
    for f in factors:
        if f.op == "^" and f.args[0] == MINUS_ONE and differentiate(f.args[1], n) in (ONE, -ONE):
            alternating = not alternating
            f = MINUS_ONE ** substitute(f.args[1], {n: ZERO})
        rest.append(f)
    return alternating, multiply(*rest)


# Partial fractions and products


def _fraction(body: Expr, n: str, others: list[Expr], given: Given) -> Quoted | None:
    alternating, rest = _stripped(body, n)
    for theorem in FRACTIONS:
        if theorem.alternating != alternating:
            continue
        for a in _parameters(others, n):
            above, below = (_put(text, n, a) for text in (theorem.above, theorem.below))
            c = in_lowest_terms(rest * below / above)
            if n not in symbols(c) and _same(rest, c * above / below, given):
                return Quoted(c * _put(theorem.value, n, a), theorem.source)
    return None


def _product(body: Expr, n: str, others: list[Expr], given: Given) -> Quoted | None:
    if body.op == "cos":
        a = in_lowest_terms(body.args[0] * 2 ** symbol(n))
        if n not in symbols(a):
            return Quoted(_put("sin(a)/a", n, a), "Vieta's product, DLMF 4.21.27 again and again")
    for theorem in PRODUCTS:
        for a in _parameters(others, n):
            below = _put(theorem.below, n, a)
            for up, factor in ((1, body), (-1, 1 / body)):
                if _same(factor, below, given):
                    return Quoted(_put(theorem.value, n, a) ** number(up), theorem.source)
    return None


def _on_both_sides(body: Expr, n: str, others: Iterable[Expr], given: Given) -> Quoted | None:
    """A sum over all integers."""
    for a in _parameters(list(others), n):
        c = in_lowest_terms(body * (a - symbol(n)) ** 2)
        if n not in symbols(c) and _same(body, c / (a - symbol(n)) ** 2, given):
            return Quoted(c * _put("pi**2*csc(pi*a)**2", n, a), "DLMF 4.22.4")
    mirrored = substitute(body, {n: -symbol(n)})
    if not _same(body, mirrored, given):
        return None
    half = _fraction(body, n, list(others), given) or _zeta(body, n, given)
    if half is None:
        return None
    return Quoted(substitute(body, {n: ZERO}) + 2 * half.value, half.source)


def _put(text: str, n: str, a: Expr) -> Expr:
    return substitute(parse(text), {"n": symbol(n), "a": a})


_TRIGONOMETRIC = ("sin", "cos", "tan", "cot", "sec", "csc")
_PERIODIC = frozenset((*_TRIGONOMETRIC, *(f"{name}h" for name in _TRIGONOMETRIC)))
NUMBERS = tuple(number(fmpq(p, q)) for p, q in ((1, 2), (1, 1), (1, 3), (1, 4), (2, 3), (2, 1)))


def _parameters(trees: Iterable[Expr], n: str) -> Iterator[Expr]:
    """What a may be: of each function of z in the claim z/π and 2z/π, and what is squared."""
    found: dict[Expr, None] = {}
    numbers = True
    for e in trees:
        for node in preorder(e):
            if node.op in _PERIODIC and not node.loose:
                z = node.args[0]
                found |= {in_lowest_terms(z / PI): None, in_lowest_terms(2 * z / PI): None}
            elif node.op == "^" and not node.loose and n in symbols(node.args[0]):
                found |= dict.fromkeys(map(in_lowest_terms, _roots(node.args[0], n)))
            elif node.op == "^" and not node.loose:
                found |= {node.args[0]: None}
        numbers = numbers and not symbols(e) - {n, "oo"}
    for e in trees:
        names = sorted(symbols(e) - {n, "oo"})
        found |= {symbol(name): None for name in names}
        found |= {symbol(name) / PI: None for name in names}
        found |= {2 * symbol(name) / PI: None for name in names}
    yield from found
    if numbers:
        yield from NUMBERS


def _roots(e: Expr, n: str) -> Iterator[Expr]:
    """Where a sum of terms in n, or n², is 0, or where it would be with another sign."""
    square = differentiate(differentiate(e, n), n) / 2
    if n in symbols(square):
        return
    yield from solutions(e, n)
    if square != ZERO:
        yield from solutions(2 * square * symbol(n) ** 2 - e, n)
