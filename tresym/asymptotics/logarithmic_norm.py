"""Bound the error of an approximate solution for all times, by the logarithmic norm.

Let A be an approximate solution of u' = f(t, u, e) with the residual r = A' - f(t, A, e), and T a
constant matrix. If the symmetric part of T⁻¹ (∂f/∂u) T has eigenvalues at most L wherever
|T⁻¹(u - A)| <= w, and |T⁻¹ r| <= K eᵐ, |T⁻¹(u - A)| <= K₀ eᵐ at the start, then

    |T⁻¹(u - A)| <= eᵐ (K₀ e^{Lt} + K (e^{Lt} - 1)/L)    as long as this is below w,

and for L < 0 at most eᵐ max(K₀, K/|L|) for all t >= 0. T is close to the matrix of eigenvectors of
∂f/∂u for large t, so that the damped oscillator x'' + 2x' + 2x = 0 has L = -1 and not more.

Sums of c tᵏ e^{at} cos(bt) are bounded in balls, term by term; what remains is asked of the prover
of inequalities. Source: G. Dahlquist, *Stability and error bounds in the numerical integration of
ordinary differential equations*, 1958; E. Hairer, S. P. Nørsett and G. Wanner, *Solving Ordinary
Differential Equations I*, 1993, theorem I.10.6.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import NamedTuple

from flint import arb, fmpq, fmpq_mat

from tresym.asymptotics.differential_problem import Problem, residuals
from tresym.asymptotics.exponential_polynomials import Polynomial, Term, expression, polynomial
from tresym.reals.decisions.answer import Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof

WIDTHS = (fmpq(1, 20), fmpq(1, 5), fmpq(1, 2))
SAMPLES = 60
LATE = fmpq(30)
"""The time at which the matrix of derivatives is looked at, if the interval is unbounded."""
MOST_PROVED = 3
"""Systems with fewer variables are left to the prover of inequalities where balls do not do."""
FEW = 40
PIECES, REFINED, LONG = 240, 14, 24
"""The pieces of the interval on which a function is bounded in balls, how often a piece is halved,
and the length of the interval beyond which its terms are bounded one by one."""


class Range(NamedTuple):
    """Where an error is bounded.

    Attributes:
        time: the independent variable, which begins at 0.
        length: the end of its interval, or None if it is unbounded.
        name: the small parameter.
        low, high: its range.
    """

    time: str
    length: arb | None
    name: str
    low: arb
    high: arb

    def box(self) -> dict[str, arb]:
        """Return the range of the parameter as a ball."""
        return {self.name: self.low.union(self.high)}

    def reach(self) -> arb:
        """Return the largest size of the parameter."""
        return arb(abs(self.low).max(abs(self.high)).upper())

    def links(self) -> tuple[Compared, ...]:
        """Return the conditions for the prover of inequalities."""
        e, t = symbol(self.name), symbol(self.time)
        ends = [
            (e, relation, number(exact(x))) for relation, x in ((">=", self.low), ("<=", self.high))
        ]
        more = [] if self.length is None else [(t, "<=", number(exact(self.length)))]
        return (*ends, (e, "!=", ZERO), (t, ">=", ZERO), *more)


def exact(x: arb) -> fmpq:
    """Return the midpoint of a ball."""
    man, exp = x.mid().man_exp()
    return fmpq(int(man)) * fmpq(2) ** int(exp)


# Sums of exponential polynomials in balls


def largest(e: Expr, where: Range, box: Mapping[str, arb]) -> arb | None:
    """Return a bound of |e|, term by term, or None if a term is unbounded or no such sum.

    Args:
        box: balls for the other variables.
    """
    p = polynomial(tidied(e), where.time)
    if p is None:
        return None
    total = arb(0)
    for group in _waves(p, box):
        size = _envelope(group[0], where.length)
        if size is None or not group[1].is_finite():
            return None
        total += group[1] * size
    return arb(total.upper())


def _waves(p: Polynomial, box: Mapping[str, arb]) -> Iterator[tuple[Term, arb]]:
    """Yield terms with amplitudes: those of cosine and sine of the same frequency together."""
    for even in dict.fromkeys(term._replace(odd=False) for term in p):
        both = (even, even._replace(odd=True))
        parts = [arb(abs(evaluate(p[x], box)).upper()) for x in both if x in p]
        yield even, _norm(parts)


def _envelope(term: Term, length: arb | None) -> arb | None:
    """Return a bound of tᵏ e^{at} for 0 <= t <= length."""
    a = arb(term.rate)
    if a < 0:
        top = (arb(term.k) / (-a * arb(1).exp())) ** term.k if term.k else arb(1)
        return top
    if length is None:
        return arb(1) if term.k == 0 and term.rate == 0 else None
    return length**term.k * (a * length).exp()


def supremum(
    p: Polynomial,
    time: str,
    length: arb | None,
    box: Mapping[str, arb] | None = None,
    number_of_pieces: int = PIECES,
) -> arb | None:
    """Return a ball around the supremum of |p| for 0 <= t <= length, or None if it is unbounded.

    Its upper end is a bound; its lower end is attained if there are no other variables.

    Args:
        box: balls for the other variables.
        number_of_pieces: of the interval, before they are halved.
    """
    box = box or {}
    end = arb(LONG) if length is None else length
    beyond = arb(0)
    if length is None:
        for term, size in _waves(p, box):
            if term.rate > 0 or (term.rate == 0 and term.k):
                return None
            a = arb(term.rate)
            late = end if term.k == 0 or end > term.k / -a else arb(term.k) / -a
            beyond += size * (late**term.k * (a * late).exp() if term.rate != 0 else arb(1))
    e = expression(p, time)
    parts = number_of_pieces
    pieces = [(end * k / parts, end * (k + 1) / parts) for k in range(parts)]
    low = arb(0)
    for a, _ in (*pieces, (end, end)):
        x = abs(evaluate(e, {**box, time: arb(a.mid())}))
        low = x if x.lower() > low.lower() else low
    low = arb(low.lower())
    high = arb(0)
    for _ in range(REFINED if parts == PIECES else 6):
        wide = []
        for a, b in pieces:
            x = abs(evaluate(e, {**box, time: a.union(b)}))
            if x.is_finite() and not x.upper() > low * arb("1.01") + arb("1e-30"):
                high = high.max(arb(x.upper()))
            else:
                middle = (a + b) / 2
                wide += [(a, middle), (middle, b)]
        pieces = wide
        if len(pieces) > 2 * parts or not pieces:
            break
    for a, b in pieces:
        x = abs(evaluate(e, {**box, time: a.union(b)}))
        high = high.max(arb(x.upper()))
    if not high.is_finite():
        return None
    return low.union(arb(high.max(arb(beyond.upper())).upper()))


# The bound


class Bound(NamedTuple):
    """|u_i - A_i| <= rows[i] * constant * eᵐ.

    Attributes:
        constant: for the norm.
        rows: norms of the rows of T.
        slope: L.
        width: of the tube.
    """

    constant: arb
    rows: dict[str, arb]
    slope: arb
    width: fmpq


def error_bound(
    problem: Problem, curve: Mapping[str, Expr], order: int, where: Range, decided: Decide | None
) -> Bound | None:
    """Return a bound of the error of a curve, of the given order in the small parameter, or None.

    Args:
        problem: starts at time 0.
        curve: analytic in the small parameter at 0, with a residual of this order.
        decided: the prover of inequalities, or None if balls alone are to be used.
    """
    names = list(problem.right)
    sources = [_divided(x, where, order) for x in residuals(problem, dict(curve))]
    start = {where.time: ZERO}
    gaps = [_divided(problem.values[n] - substitute(curve[n], start), where, order) for n in names]
    if any(x is None for x in (*sources, *gaps)):
        return None
    jacobian = [[tidied(differentiate(f, n)) for n in names] for f in problem.right.values()]
    for basis in _bases(jacobian, curve, where):
        found = _with_basis(problem, curve, order, where, jacobian, sources, gaps, basis, decided)
        if found is not None:
            return found
    return None


def _divided(e: Expr, where: Range, order: int) -> Expr | None:
    """Return e divided by a power of the parameter, without the parameter in a denominator."""
    power = symbol(where.name) ** order if order else ONE
    p = polynomial(tidied(e), where.time)
    if p is None:
        p = {Term(0, fmpq(0), fmpq(0), False): e}
    parts = {}
    for term, c in p.items():
        quotient = normal_form(c, Given())
        quotient = normal_form(quotient / power, Given()) if quotient != ZERO else ZERO
        at_zero = substitute(quotient, {where.name: ZERO, **_some(quotient, where.name)})
        if not evaluate(at_zero, {}).is_finite():
            return None
        if quotient != ZERO:
            parts[term] = quotient
    return expression(parts, where.time)


def _some(e: Expr, name: str) -> dict[str, Expr]:
    return {n: number(fmpq(3, 7)) for n in symbols(e) - {name}}


def _bases(
    jacobian: Sequence[Sequence[Expr]], curve: Mapping[str, Expr], where: Range
) -> Iterator[fmpq_mat]:
    """Yield matrices T: eigenvectors of the matrix of derivatives at a late time, the identity."""
    n = len(jacobian)
    unit = fmpq_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    if n == 1:
        yield unit
        return
    import numpy as np

    late = where.length / 2 if where.length is not None else arb(LATE)
    at = {where.time: late, where.name: arb(0)}
    point = at | {name: evaluate(e, at) for name, e in curve.items()}
    rows = [[float(evaluate(e, point).mid()) for e in row] for row in jacobian]
    matrix = np.array(rows)
    if np.isfinite(matrix).all():
        for shift in (0.0, 0.05):
            moved = matrix + shift * np.diag(np.arange(n) - (n - 1) / 2) * (1 + abs(matrix).max())
            values, vectors = np.linalg.eig(moved)
            columns = []
            for value, vector in zip(values, vectors.T, strict=True):
                if value.imag > 1e-9:
                    columns += [vector.real, vector.imag]
                elif abs(value.imag) <= 1e-9:
                    columns.append(vector.real)
            basis = np.array(columns).T
            if basis.shape == (n, n) and np.linalg.cond(basis) < 100:
                scale = abs(basis).max()
                yield fmpq_mat(n, n, [fmpq(round(1000 * x / scale), 1000) for x in basis.flatten()])
    yield unit


def _with_basis(
    problem: Problem,
    curve: Mapping[str, Expr],
    order: int,
    where: Range,
    jacobian: Sequence[Sequence[Expr]],
    sources: Sequence[Expr | None],
    gaps: Sequence[Expr | None],
    basis: fmpq_mat,
    decided: Decide | None,
) -> Bound | None:
    names, n = list(problem.right), len(problem.right)
    try:
        inverse = basis.inv()
    except ZeroDivisionError:
        return None

    def moved(vector: Sequence[Expr | None], i: int) -> Expr:
        return tidied(
            add(*(number(inverse[i, j]) * x for j, x in enumerate(vector) if x is not None), ZERO)
        )

    def measured(vector: Sequence[Expr | None]) -> arb | None:
        sizes = [_size(moved(vector, i), where, decided) for i in range(n)]
        return None if None in sizes else _norm([x for x in sizes if x is not None])

    begin: arb | None = None
    size: arb | None = None
    for width in WIDTHS:
        tube = {
            name: curve[name]
            + add(*(number(width * basis[k, j]) * symbol(f"s_{j}") for j in range(n)))
            for k, name in enumerate(names)
        }
        there = [[substitute(e, tube) for e in row] for row in jacobian]
        rotated = [
            [
                add(
                    *(
                        number(inverse[i, k] * basis[m, j]) * there[k][m]
                        for k in range(n)
                        for m in range(n)
                        if inverse[i, k] * basis[m, j] != 0
                    ),
                    ZERO,
                )
                for j in range(n)
            ]
            for i in range(n)
        ]
        slope = _slope(rotated, where, decided)
        if slope is None:
            continue
        if not _is_smooth(
            (*problem.right.values(), *(e for row in jacobian for e in row)), tube, where
        ):
            continue
        if size is None:
            begin, size = (measured(x) for x in (gaps, sources))
        if size is None or begin is None:
            return None
        if slope < 0 or (where.length is None and begin.is_zero() and size.is_zero()):
            bound = begin.max(size / -slope) if slope < 0 else arb(0)
        elif where.length is None:
            continue
        else:
            growth = (slope * where.length).exp()
            spread = where.length if slope.is_zero() else (growth - 1) / slope
            bound = begin * growth + size * spread
        bound = arb(bound.upper())
        if bound * where.reach() ** order < arb(width):
            rows = {
                name: _norm([arb(basis[k, j]) for j in range(n)]) for k, name in enumerate(names)
            }
            return Bound(bound, rows, slope, width)
    return None


def _is_smooth(trees: Sequence[Expr], tube: Mapping[str, Expr], where: Range) -> bool:
    """Whether expressions are continuous at all points of the tube."""
    links = list(where.links())
    links = [link for link in links if link[1] != "!="]
    names = {n for e in tube.values() for n in symbols(e) if n.startswith("s_")}
    for name in sorted(names):
        links += [(symbol(name), ">=", -ONE), (symbol(name), "<=", ONE)]
    given = Given(tuple(links))
    return all(continuous_on(substitute(e, tube), given, proof) is None for e in trees)


def _norm(parts: Sequence[arb]) -> arb:
    if len(parts) == 1:
        return abs(parts[0])
    return sum((x**2 for x in parts), arb(0)).sqrt()


def _size(e: Expr, where: Range, decided: Decide | None) -> arb | None:
    """Return a bound of |e| on the range."""
    if e == ZERO:
        return arb(0)
    sampled = _sampled(e, where)
    crude = largest(e, where, where.box())
    if sampled is None:
        return crude
    top = max(abs(sampled[0]), abs(sampled[1]))
    if crude is not None and crude < arb(top) * arb("1.3"):
        return crude
    p = polynomial(tidied(e), where.time)
    finer = None if p is None else supremum(p, where.time, where.length, where.box(), FEW)
    if finer is not None:
        return arb(finer.upper())
    if decided is None:
        return crude
    bound = number(fmpq(int(top * 10200) + 1, 10000))
    plain = Statement((), Given(where.links()), None, "")
    if decided(Comparison(apply("abs", e), "<=", bound), plain):
        return arb(bound.args[0])
    return crude


def _slope(matrix: Sequence[Sequence[Expr]], where: Range, decided: Decide | None) -> arb | None:
    """Return a bound of the largest eigenvalue of the symmetric part, by Gershgorin's circles."""
    n = len(matrix)
    box = where.box() | {f"s_{j}": arb(0, 1) for j in range(n)}
    half = number(fmpq(1, 2))
    found = []
    for i in range(n):
        middle = matrix[i][i]
        beside = [half * (matrix[i][j] + matrix[j][i]) for j in range(n) if j != i]
        crude = _upper(middle, where, box)
        parts = [largest(e, where, box) for e in beside]
        total = None
        if crude is not None and all(x is not None for x in parts):
            total = arb((crude + sum((x for x in parts if x is not None), arb(0))).upper())
        if (total is None or not total < 0) and decided is not None and n < MOST_PROVED:
            total = _slope_by_prover(middle, beside, where, decided, n) or total
        if total is None:
            return None
        found.append(total)
    top = found[0]
    for x in found[1:]:
        top = top.max(x)
    return arb(top.upper())


def _upper(e: Expr, where: Range, box: Mapping[str, arb]) -> arb | None:
    """Return an upper bound of e: its constant, and the sizes of all other terms."""
    p = polynomial(tidied(e), where.time)
    if p is None:
        return None
    flat = Term(0, fmpq(0), fmpq(0), False)
    rest = largest(e - p[flat], where, box) if flat in p else largest(e, where, box)
    steady = evaluate(p[flat], box) if flat in p else arb(0)
    return None if rest is None else arb((steady + rest).upper())


def _slope_by_prover(
    middle: Expr, beside: Sequence[Expr], where: Range, decided: Decide, n: int
) -> arb | None:
    tube: list[Compared] = []
    for j in range(n):
        tube += [(symbol(f"s_{j}"), ">=", -ONE), (symbol(f"s_{j}"), "<=", ONE)]
    links = (*where.links(), *tube)
    tops = []
    totals = [
        add(middle, *(sign * e for sign, e in zip(signs, beside, strict=True)))
        for signs in product((1, -1), repeat=len(beside))
    ]
    for total in totals:
        sampled = _sampled(total, where, tuple(tube))
        if sampled is None:
            return None
        tops.append(sampled[1])
    top = max(tops)
    if where.length is None and top >= 0:
        return None
    bound = fmpq(int(1000 * top * (0.9 if top < 0 else 1.1)) + (1 if top >= 0 else 0), 1000)
    if where.length is None and bound >= 0:
        return None
    plain = Statement((), Given(links), None, "")
    shown = all(decided(Comparison(total, "<=", number(bound)), plain) for total in totals)
    return arb(bound) if shown else None


def _sampled(e: Expr, where: Range, more: tuple[Compared, ...] = ()) -> tuple[float, float] | None:
    """Return the least and the largest value found at points of the range."""
    given = Given((*where.links(), *more))
    names = sorted(symbols(e))
    if not names:
        value = evaluate(e, {})
        return (float(value.mid()),) * 2 if value.is_finite() else None
    values = [evaluate(e, at) for at in given.points(names, SAMPLES)]
    floats = [float(x.mid()) for x in values if x.is_finite()]
    return (min(floats), max(floats)) if floats else None
