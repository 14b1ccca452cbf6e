"""Power series written with an ellipsis: ``f == t0 + t1 + t2 + ...``.

Such a claim means: the expansion of f in powers of u, the expression whose powers the terms are,
begins with exactly these terms, and it converges to f under the conditions. The coefficients are
compared exactly. Convergence is proved in one of two ways. If the ratios of further coefficients
are a rational function of the index, the series is one of
:mod:`tresym.reals.decisions.power_series`. Otherwise f must be composed of functions with known
complex singularities; its series converges inside the circle through the nearest one.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import pairwise
from math import factorial

from flint import fmpq, fmpq_mat, fmpq_poly

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.exceptional_values import also_at_zeros
from tresym.reals.decisions.hypergeometric import (
    HIGHEST,
    OpenError,
    Series,
    folded,
    polynomial,
    size_of,
    whole_roots,
)
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.power_series import by_equation, functions_of, need_range, without
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.laurent import Germ, germ_of
from tresym.reals.functions.table import TABLE, names
from tresym.reals.language.binders import elementary, is_infinite
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    LEAVES,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    multiply,
    number,
    opened,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST_TERMS = 8
LEAST, MOST, FIT = -3, 30, 3
"""Exponents that are looked for, and the degree of ratios of coefficients."""
DIFFERENTIATED = 6
"""Up to which order coefficients with parameters are had by derivatives."""
_OPEN = Verdict.UNDECIDED


def decide_dotted(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an equation with dots in a sum, such as ``1 + x + x**2 + ... == 1/(1 - x)``.

    Args:
        decided: the procedure for the claim where the coefficient of the sum vanishes.
    """
    node = next(filter(None, map(_sum_with_dots, (claim.left, claim.right))), None)
    if claim.relation != "==" or node is None or claim.derivatives or statement.equations:
        return Answer(
            _OPEN, ("dots are supported only in a sum of powers on one side of an equation")
        )
    solution = claim.solved(node)
    if solution is None:
        return Answer(_OPEN, "the equation could not be solved for the sum with dots")
    side, slope = solution
    answer = _dotted(node, side, statement)
    return also_at_zeros(answer, [slope], claim, statement, decided, node) if answer else answer


def _dotted(node: Expr, side: Expr, statement: Statement) -> Answer:
    """Decide whether the series in ``node``, written with dots, is the expansion of ``side``."""
    terms = [term for term in node.args if term not in (DOTS, -DOTS)]
    if is_infinite(side) and not statement.path:
        return _first_of(side, add(*terms), statement.given)
    if statement.path or DOTS.args[0] in symbols(side) or not elementary(side):
        return Answer(
            _OPEN,
            "the series with dots must be compared with an elementary "
            "function or a series without dots",
        )
    given, why = (
        statement.given,
        "the terms before the dots are not increasing powers of one expression",
    )
    for u in _raised(terms):
        powers = _powers(terms, u)
        if powers is None:
            continue
        rest = side
        if powers.get(0, ZERO).op != "number":  # pi/2 - x - ...: of what is left without it
            rest, powers = side - powers[0], powers | {0: ZERO}
        y = fresh("y", symbols(side) | symbols(node) | given.names)
        for x in sorted(symbols(u)):
            fixed = without(x, given)
            for moved in functions_of(rest, u, x, y, given):
                answer = _decided(moved, y, u, powers, given, fixed)
                if answer.verdict is not _OPEN:
                    return answer
                why = answer.why
    return Answer(_OPEN, why)


def _first_of(series: Expr, terms: Expr, given: Given) -> Answer:
    """Decide whether the terms before the dots are the first terms of ``series``."""
    (k,), body = opened(series, given.names)
    low, first = series.args[1], ZERO
    if series.op == "sum" and low.op == "number":
        for n in range(MOST_TERMS):
            term = folded(substitute(body, {k: low + n}))
            if term is None:
                break
            first = first + term
            answer = decide(first, terms, given)
            if n and answer.verdict is Verdict.PROVED:
                why = (
                    f"the terms before the dots are the first {n + 1} terms of "
                    f"the series: {answer.why}"
                )
                return Answer(Verdict.PROVED, why)
    return Answer(
        _OPEN, "the terms before the dots could not be shown to be the first terms of the series"
    )


def _sum_with_dots(e: Expr) -> Expr | None:
    if e.op == "+" and (DOTS in e.args or -DOTS in e.args):
        return e
    parts = () if e.op in LEAVES else e.args
    return next(filter(None, map(_sum_with_dots, parts)), None)


def _raised(terms: list[Expr]) -> Iterator[Expr]:
    """Yield the expressions that the terms may be powers of."""
    names = frozenset().union(*map(symbols, terms))
    spoken = {name: sum(name in symbols(t) for t in terms) for name in sorted(names)}
    common = [name for name, times in spoken.items() if times > len(terms) - 2]
    for name in common:
        yield symbol(name)
        yield 1 / symbol(name)
    last = next((term for term in reversed(terms) if symbols(term)), ZERO)
    factors = list(_factors_with_exponents(last, 1))
    above = [(base, m) for base, m in factors if symbols(base)]
    if len(above) > 1 and len({abs(m) for _, m in above}) == 1:  # (x/a)**3
        yield multiply(*(base if m > 0 else 1 / base for base, m in above))
    yield from (base for base, m in above if base.op != "symbol" and abs(m) > 1)


def _factors_with_exponents(e: Expr, times: int) -> Iterator[tuple[Expr, int]]:
    """The factors of a term, with their exponents."""
    if e.op == "*":
        for arg in e.args:
            yield from _factors_with_exponents(arg, times)
    elif e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        yield from _factors_with_exponents(e.args[0], times * int(e.args[1].args[0].p))
    else:
        yield e, times


def _powers(terms: list[Expr], u: Expr) -> dict[int, Expr] | None:
    """Return the coefficients of the terms by their power of ``u``; None if not increasing."""
    coefficients: dict[int, Expr] = {}
    rising: list[int] = []
    if u.op == "+":  # x - 1 is a power of it, as a sum
        lone = [t for t in terms if t.op == "number" or _power(t, u) is None]
        if lone and (whole := _power(add(*lone), u)) and whole[0] > 0:
            terms = [add(*lone), *(t for t in terms if t not in lone)]
    for term in terms:
        power = _power(term, u)
        if power is None:
            return None
        m, c = power
        if m in coefficients or (term.op != "number" and any(k >= m for k in rising)):
            return None
        rising += [] if term.op == "number" else [m]
        coefficients[m] = c
    return coefficients if len(coefficients) > 1 and rising[-1] > 0 else None


def _power(term: Expr, u: Expr) -> tuple[int, Expr] | None:
    """Return m and c if the term is c u^m, else None."""
    for m in range(LEAST, MOST):
        c = in_lowest_terms(term * u ** number(-m))
        if symbols(c).isdisjoint(symbols(u)):
            return m, c
    return None


def _decided(
    f: Expr, y: str, u: Expr, powers: dict[int, Expr], given: Given, fixed: Given
) -> Answer:
    """Decide the claim for the function f of y = u."""
    last = max(powers)
    try:
        germ = germ_of(f, y)
        coefficients = {m: number(germ[m]) for m in range(min(germ.order, LEAST), last + 1)}
    except OpenError:
        germ = None
        if last > DIFFERENTIATED:
            return Answer(_OPEN, "the Taylor coefficients of the other side could not be computed")
        coefficients = _by_derivatives(f, y, last)
    for m in range(min(*powers, *coefficients), last + 1):
        one, other = coefficients.get(m, ZERO), powers.get(m, ZERO)
        answer = decide(one, other, fixed)
        if answer.verdict is Verdict.REFUTED and germ is not None and _is_near(u, given):
            why = f"the coefficient of order {m} in {u} is {one}, not {other}"
            return Answer(Verdict.REFUTED, why, witness={f"coefficient of {u}**{m}": str(one)})
        if answer.verdict is not Verdict.PROVED:
            return Answer(
                _OPEN, f"the coefficient of order {m} in {u} could not be shown to be {other}"
            )
    if next(given.points(symbols(f) - {y} | symbols(u), 1), None) is None:
        return Answer(
            _OPEN,
            "no point was found that satisfies the conditions, so there "
            "is nothing to prove; check the conditions",
        )
    agree = f"the expansion in {u} begins with these terms"
    series = None if germ is None else _fitted(germ, u)
    if series is not None:
        with suppress(OpenError, InputError):
            how = by_equation(f, (series.head, 0), series, y, fixed)
            need_range(f, series, given)
            if how:
                return Answer(Verdict.PROVED, f"{agree}; {how}")
    return _inside_circle(f, y, u, agree, given, fixed)


def _is_near(u: Expr, given: Given) -> bool:
    """Return whether the conditions allow arbitrarily small u."""
    small = given & Given(((apply("abs", u), "<", number(fmpq(1, 1000))),))
    return next(small.points(symbols(u), 1), None) is not None


def _by_derivatives(f: Expr, y: str, last: int) -> dict[int, Expr]:
    derivatives = {}
    for m in range(last + 1):
        derivatives[m] = substitute(f, {y: ZERO}) / factorial(m)
        f = in_lowest_terms(differentiate(f, y))
    return derivatives


def _fitted(germ: Germ, u: Expr) -> Series | None:
    """Return the hypergeometric series that fits the first coefficients, or None."""
    places = [m for m in range(germ.order, germ.order + len(germ.series)) if germ[m]]
    if len(places) < 2:
        return None
    start, step = places[0], places[1] - places[0]
    if places != list(range(start, start + step * len(places), step)):
        return None
    values = [germ[m] for m in places]
    for degree in range(FIT + 1):
        if len(values) < 2 * degree + 6:
            break
        rows = []
        for k, (one, other) in enumerate(pairwise(values)):
            powers = [fmpq(k) ** i for i in range(degree + 1)]
            rows.append([*(one * power for power in powers), *(-other * power for power in powers)])
        solutions, count = fmpq_mat(rows).numer_denom()[0].nullspace()
        if count != 1:
            continue
        solution = [solutions[i, 0] for i in range(2 * degree + 2)]
        above, below = fmpq_poly(solution[: degree + 1]), fmpq_poly(solution[degree + 1 :])
        if above == 0 or below == 0 or any(k >= 0 for p in (above, below) for k in whole_roots(p)):
            return None
        first = number(values[0])
        return Series(above, below, u, step, start, first, first * u ** number(start))
    return None


# By the circle of convergence


def _inside_circle(f: Expr, y: str, u: Expr, agree: str, given: Given, fixed: Given) -> Answer:
    try:
        radii = list(dict.fromkeys(_singular(f, y, fixed)))
    except OpenError as error:
        return Answer(
            _OPEN, f"{agree}, but its radius of convergence could not be determined: {error}"
        )
    for radius in radii:
        if sign(radius - size_of(u), given, ">") != "+":
            return Answer(
                _OPEN,
                f"{agree}, but it converges only where abs({u}) < {radius}: "
                "add this as a condition",
            )
    below = f"abs({u}) < {', '.join(map(str, radii))}, the distance of the nearest singularity"
    why = f"{agree}, and the series converges to it {f'where {below}' if radii else 'everywhere'}"
    return Answer(Verdict.PROVED, why)


_ENTIRE = names(lambda row: row.entire)
_ZEROS = {row.name: number(row.zeros_apart) * PI for row in TABLE.values() if row.zeros_apart}
"""How far from 0 the nearest other zero is."""
_POLES = {row.name: number(row.poles_apart) * PI for row in TABLE.values() if row.poles_apart}
_BRANCHED = names(lambda row: row.branched)
"""Functions with their singularities on the circle of radius 1."""


def _singular(e: Expr, y: str, given: Given) -> Iterator[Expr]:
    """Yield the possible distances from 0 of the nonzero singularities of ``e``.

    Raises:
        OpenError: that is not known.
    """
    if y not in symbols(e) or e.op == "symbol":
        return
    if e.op in ("+", "*"):
        for arg in e.args:
            yield from _singular(arg, y, given)
    elif e.op == "^" and y not in symbols(e.args[1]):
        base, exponent = e.args
        yield from _singular(base, y, given)
        whole = exponent.op == "number" and exponent.args[0].q == 1
        if not (whole and exponent.args[0] > 0):
            yield from _zeros(base, y)
        if not whole:
            _need_positive(base, y, given)
    elif e.op == "^" and y not in symbols(e.args[0]):
        yield from _singular(e.args[1], y, given)
    elif e.op in _ENTIRE:
        yield from _singular(e.args[0], y, given)
    elif e.op in _POLES or e.op in _BRANCHED:
        yield _scaled(_POLES.get(e.op, number(1)), e.args[0], y)
    elif e.op == "log":
        yield from _singular(e.args[0], y, given)
        yield from _zeros(e.args[0], y)
        _need_positive(e.args[0], y, given)
    else:
        raise OpenError(f"the singularities of {e} are not known")


def _scaled(distance: Expr, inner: Expr, y: str) -> Expr:
    """How far y is from 0 where c y^m is as far as that."""
    for m in range(1, HIGHEST):
        c = in_lowest_terms(inner * symbol(y) ** number(-m))
        if y not in symbols(c):
            scaled_distance = (
                distance / apply("abs", c) if c.op != "number" else distance / abs(c.args[0])
            )
            return scaled_distance if m == 1 else scaled_distance ** number(fmpq(1, m))
    raise OpenError(f"the singularities of a function of {inner} are not known")


def _zeros(e: Expr, y: str) -> Iterator[Expr]:
    """Yield the possible distances from 0 of the nonzero zeros of ``e``."""
    if y not in symbols(e) or e.op in ("exp", "symbol", *_BRANCHED) or e.op in ("sec", "csc"):
        return
    if e.op == "*":
        for arg in e.args:
            yield from _zeros(arg, y)
    elif e.op == "^" and e.args[1].op == "number":
        yield from _zeros(e.args[0], y)
    elif e.op in _ZEROS:
        yield _scaled(_ZEROS[e.op], e.args[0], y)
    elif e.op == "+" and (found := _exponential_and_one(e)) is not None:
        inner, one = found
        yield _scaled(2 * PI if one < 0 else PI, inner, y)
    else:
        yield from _roots(e, y)


def _exponential_and_one(e: Expr) -> tuple[Expr, int] | None:
    """``exp(u) ± 1`` as u and the sign, also where both have the other sign."""
    if len(e.args) != 2 or e.args[1].op != "number" or abs(e.args[1].args[0]) != 1:
        return None
    other, one = e.args[0], int(e.args[1].args[0].p)
    if other.op == "exp":
        return other.args[0], one
    flipped = -other
    return (flipped.args[0], -one) if flipped.op == "exp" else None


def _roots(e: Expr, y: str) -> Iterator[Expr]:
    """The moduli of the roots of a polynomial with rational coefficients, or of c + d y."""
    slope = differentiate(e, y)
    start = substitute(e, {y: ZERO})
    if y not in symbols(in_lowest_terms(slope)) and symbols(e) != {y}:
        yield apply("abs", start / slope)
        return
    p = polynomial(e, y)
    whole = p.numer()
    for factor, _ in whole.factor()[1]:
        if factor.degree() == 1:
            if factor[0]:
                yield number(fmpq(abs(int(factor[0])), abs(int(factor[1]))))
        elif factor.degree() == 2 and factor[1] ** 2 < 4 * factor[0] * factor[2]:
            yield sqrt(number(fmpq(int(factor[0]), int(factor[2]))))
        else:
            raise OpenError(f"the zeros of {e} are not known")


def _need_positive(e: Expr, y: str, given: Given) -> None:
    """That ``e`` is positive at y = 0, where it may have a value as a limit alone."""
    try:
        germ = germ_of(e, y)
        if germ.order == 0 and germ[0] > 0:
            return
    except OpenError:
        with ball_precision():
            at = substitute(e, {y: ZERO})
            if symbols(at):
                if sign(at, given, ">") == "+":
                    return
            elif evaluate(at, {}) > 0:
                return
    raise OpenError(f"{e} could not be shown to be positive at {y} = 0")
