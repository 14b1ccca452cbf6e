"""Claims about the coefficients [zⁿ] f(z) for every n.

Example: ``coefficient((1 - sqrt(1 - 4*z))/(2*z), z, n) == binomial(2*n, n)/(n + 1)``.

A claim is refuted by a coefficient that is computed from the power series in rational numbers. It
is proved for an explicit function of n: f is rational, or a sum of products of powers of z with one
function g of a linear function of z each, where with a = −B/A

    [zᵐ] (A + B z)^α = A^α aᵐ C(2m, m)/4ᵐ times a rational function of m, for α = ±1/2, ±3/2, …,
    [zᵐ] exp(a z) = aᵐ/m!,  and [zᵐ] log(A + B z) = −aᵐ/m for m ≥ 1.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.coefficients import rational_coefficients
from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.readable_witnesses import decided_at, tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    integer,
    number,
    opened,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.verdict import Verdict

LEMMA = "the power series of f"
LOOKED_AT = 10
MOST_INDEX = 500
"""Values of n at which a claim is computed before it is proved."""
MOST_SHIFT, MOST_HALVES, MOST_POWER = 4, 6, 6


class _Series(NamedTuple):
    """z^valuation times a power series, of which as many coefficients are known as are listed."""

    valuation: int
    terms: list[fmpq]


def decide_coefficients(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about coefficients for every n that the conditions allow.

    Args:
        claim: the comparison.
        statement: its conditions: n integer, n >= m.
        decided: decides explicit claims.
    """

    def open_(why: str) -> Answer:
        return Answer(Verdict.UNDECIDED, why)

    nodes = [n for n in outermost(claim.left, claim.right) if n.op == "coefficient"]
    names = frozenset().union(*(symbols(node.args[1]) for node in nodes))
    if not names and not claim.derivatives:
        explicit = claim.mapped(with_values)
        left = [x for x in outermost(explicit.left, explicit.right) if x.op == "coefficient"]
        if left:
            return open_(f"{left[0]} is not computed as a rational number")
        return decided(explicit, statement)
    if len(names) != 1 or claim.derivatives or statement.equations:
        return open_("coefficients are supported whose index depends on one integer variable")
    (n,) = names
    given = statement.given
    least = given.box[n].first_integer() if n in given.box else None
    if n not in statement.integers or least is None:
        return open_(f"a claim about every coefficient needs {n} integer, and {n} >= 0")
    places = {node: _index(node.args[1], n) for node in nodes}
    if None in places.values() or any(p[0] * least + p[1] < 0 for p in places.values() if p):
        return open_(f"an index must be at least 0: raise {n} >= {least}")
    rest = replace(statement, equations=())
    forms = {node: closed_coefficient(node) for node in nodes}
    starts = [
        -(-(form[1] - p[1]) // p[0])
        for node, p in places.items()
        if (form := forms[node]) is not None and p is not None
    ]
    first = max([least, *starts])
    last = max(least + LOOKED_AT, first)
    top = max(p[0] * last + p[1] for p in places.values() if p)
    known = {node: taylor(node, top + 1) for node in nodes}
    if None in known.values() or top > MOST_INDEX:
        return open_("the coefficients are not computed as rational numbers")
    at_first = []
    for m in range(least, last):
        at = {}
        for node, p in places.items():
            values = known[node] or []
            if p is not None:
                at[node] = number(values[p[0] * m + p[1]])
        explicit = claim.mapped(partial(replaced, known=at))
        answer, _ = decided_at([{n: number(m)}], explicit, rest, decided)
        if answer is not None:
            return replace(answer, lemma=LEMMA)
        if m < first:
            here = replace(rest, integers=(), given=Given())
            there = explicit.mapped(partial(substitute, mapping={n: number(m)}))
            at_first.append(decided(there, here))
    if None in forms.values():
        return open_("no explicit function of the index is known for these coefficients")
    put = {node: form[0] for node, form in forms.items() if form is not None}
    beyond = replace(rest, given=given & Given(((symbol(n), ">=", number(first)),)))
    answer = decided(claim.mapped(partial(replaced, known=put)), beyond)
    said = "; ".join(f"{node} = {form}" for node, form in put.items())
    answer = replace(answer, why=f"{said}: {answer.why}", lemma=LEMMA)
    return worst([*at_first, answer]) if at_first else answer


def with_values(e: Expr) -> Expr:
    """Return ``e`` with the values of coefficients at given indices, as far as they are found."""
    put = {}
    for node in outermost(e):
        k = integer(tidied(node.args[1])) if node.op == "coefficient" else None
        values = None if k is None or not 0 <= k <= MOST_INDEX else taylor(node, k + 1)
        if values is not None and k is not None:
            put[node] = number(values[k])
    return replaced(e, put) if put else e


def _index(e: Expr, n: str) -> tuple[int, int] | None:
    """Return c > 0 and k of an index c n + k."""
    slope = integer(tidied(normal_form(differentiate(e, n), Given())))
    start = integer(tidied(normal_form(substitute(e, {n: ZERO}), Given())))
    return None if slope is None or start is None or slope <= 0 else (slope, start)


# Power series


def taylor(node: Expr, count: int) -> list[fmpq] | None:
    """Return the first coefficients of a power series, or None where they are not rational."""
    (z,), f = opened(node)
    if symbols(f) - {z} or f.hidden:
        return None
    try:
        found = _series(f, z, count + 2 * MOST_SHIFT)
    except (ValueError, ZeroDivisionError, TypeError):
        return None
    if found is None:
        return None
    v, terms = found
    if any(terms[: max(0, -v)]):
        return None
    values = terms[-v:] if v < 0 else [fmpq(0)] * v + terms
    return values[:count] if len(values) >= count else None


def _series(e: Expr, z: str, size: int) -> _Series | None:
    if e.op == "number":
        return _Series(0, [e.args[0], *[fmpq(0)] * (size - 1)])
    if e == symbol(z):
        return _Series(1, [fmpq(1), *[fmpq(0)] * (size - 1)])
    if e.op in LEAVES or e.op not in ("+", "*", "^", "exp", "log", "sin", "cos", "tan"):
        return None
    parts = [_series(arg, z, size) for arg in e.args]
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    (v, first), exponent = known[0], e.args[-1]
    if e.op == "+":
        low = min(part.valuation for part in known)
        rows = [[fmpq(0)] * (w - low) + terms for w, terms in known]
        return _stripped(low, [sum(column, fmpq(0)) for column in zip(*rows, strict=False)])
    if e.op == "*":
        for w, terms in known[1:]:
            v, first = v + w, _times(first, terms)
        return _Series(v, first)
    if e.op == "^" and (exponent.op != "number" or first[0] == 0):
        return None
    if e.op == "^":
        r = exponent.args[0]
        scale = tidied(normal_form(power(number(first[0]), exponent), Given()))
        if scale.op != "number" or (v and r.q != 1):
            return None
        return _Series(v * int(r.p), _raised([c / first[0] for c in first], r, scale.args[0]))
    if v < 0:
        return None
    return _stripped(0, _composed(e.op, [fmpq(0)] * v + first))


def _times(f: list[fmpq], g: list[fmpq]) -> list[fmpq]:
    size = min(len(f), len(g))
    return [sum((f[j] * g[k - j] for j in range(k + 1)), fmpq(0)) for k in range(size)]


def _raised(f: list[fmpq], r: fmpq, scale: fmpq) -> list[fmpq]:
    """Return scale f^r for f(0) = 1, from f (f^r)' = r f' f^r."""
    found = [fmpq(1)]
    for k in range(1, len(f)):
        found.append(
            sum(((r * j - k + j) * f[j] * found[k - j] for j in range(1, k + 1)), fmpq(0)) / k
        )
    return [scale * c for c in found]


def _composed(name: str, f: list[fmpq]) -> list[fmpq]:
    """Return a function of a power series, for exp, sin, cos and tan with f(0) = 0."""
    if name == "log":
        if f[0] != 1:
            raise ValueError
        slope = _times([k * f[k] for k in range(1, len(f))], _raised(f[:-1], fmpq(-1), fmpq(1)))
        return [fmpq(0), *(c / (k + 1) for k, c in enumerate(slope))]
    if f[0] != 0:
        raise ValueError
    if name == "exp":
        found = [fmpq(1)]
        for k in range(1, len(f)):
            found.append(sum((j * f[j] * found[k - j] for j in range(1, k + 1)), fmpq(0)) / k)
        return found
    sine, cosine = [fmpq(0)], [fmpq(1)]
    for k in range(1, len(f)):
        steps = [(j * f[j], k - j) for j in range(1, k + 1)]
        following = sum((c * cosine[i] for c, i in steps), fmpq(0)) / k
        cosine.append(-sum((c * sine[i] for c, i in steps), fmpq(0)) / k)
        sine.append(following)
    if name == "tan":
        return _times(sine, _raised(cosine, fmpq(-1), fmpq(1)))
    return sine if name == "sin" else cosine


def _stripped(low: int, terms: list[fmpq]) -> _Series:
    """Return a series with its first terms that vanish taken out."""
    lost = next((k for k, c in enumerate(terms[: 2 * MOST_SHIFT]) if c), 0)
    return _Series(low + lost, terms[lost:])


# Explicit functions of the index


def closed_coefficient(node: Expr) -> tuple[Expr, int] | None:
    """Return a coefficient as a function of its index, and the first index where it holds."""
    (z,), f = opened(node)
    if symbols(f) - {z} or f.hidden:
        return None
    m = "[m]"
    rational = rational_coefficients(f, z, m)
    if rational is not None:
        if rational.form is None:
            return None
        return tidied(substitute(rational.form, {m: node.args[1]})), rational.first
    marks: dict[Expr, Expr] = {}
    _mark(f, z, marks)
    marked = replaced(f, marks)
    for shift in range(MOST_SHIFT + 1):
        terms = polynomial(marked * symbol(z) ** shift)
        if terms is not None:
            break
    else:
        return None
    back = {str(mark.args[0]): e for e, mark in marks.items()}
    whole, first = [ZERO], 0
    for monomial, c in terms.items():
        powers = dict(monomial)
        d = powers.pop(z, 0) - shift
        if len(powers) > 1 or any(k != 1 for k in powers.values()):
            return None
        if not powers:
            first = max(first, d + 1)
            continue
        (name,) = powers
        found = _of_function(back[name], z, symbol(m) - d)
        if found is None:
            return None
        first = max(first, d + found[1])
        whole.append(number(c) * found[0])
    form = substitute(add(*whole), {m: node.args[1]})
    return form, first


def _mark(e: Expr, z: str, marks: dict[Expr, Expr]) -> None:
    """Find the functions of linear functions of z in ``e``."""
    if e.op in LEAVES or z not in symbols(e):
        return
    own = e.op == "^" and e.args[1].op == "number" and (_linear(e.args[0], z) or (1, 1))[0] != 0
    fractional = own and not (e.args[1].args[0].q == 1 and e.args[1].args[0] > 0)
    if fractional or e.op in ("exp", "log"):
        marks.setdefault(e, symbol(f"[{len(marks)}]"))
        return
    for arg in e.args:
        _mark(arg, z, marks)


def _linear(e: Expr, z: str) -> tuple[fmpq, fmpq] | None:
    terms = polynomial(e)
    if terms is None or any(m not in ((), ((z, 1),)) for m in terms):
        return None
    return terms.get((), fmpq(0)), terms.get(((z, 1),), fmpq(0))


def _of_function(e: Expr, z: str, m: Expr) -> tuple[Expr, int] | None:
    """Return [zᵐ] of a function of a linear function of z, and the first m where this holds."""
    inside, side = e.args[0], 1
    if e.op == "log" and inside.op == "^" and inside.args[1] == MINUS_ONE:
        inside, side = inside.args[0], -1
    alpha = e.args[1].args[0] if e.op == "^" else fmpq(0)
    while e.op == "^" and inside.op == "^" and inside.args[1].op == "number":
        alpha, inside = alpha * inside.args[1].args[0], inside.args[0]
    line = _linear(inside, z)
    if line is None or line[1] == 0:
        return None
    start, slope = line
    factorial_m = unknown(FACTORIAL, (m,))
    if e.op == "exp":
        return (power_of(slope, m) / factorial_m, 0) if start == 0 else None
    if start <= 0:
        return None
    a = -slope / start
    if e.op == "log":
        return -side * power_of(a, m) / m, 1
    scale = tidied(normal_form(power(number(start), number(alpha)), Given()))
    if alpha.q == 1 and -MOST_POWER <= alpha < 0:
        form = ONE
        for j in range(1, -int(alpha.p)):
            form = form * (m + j) / j
        return scale * power_of(a, m) * form, 0
    if alpha.q != 2 or abs(alpha) > MOST_HALVES:
        return None
    form = unknown(FACTORIAL, (2 * m,)) / factorial_m**2 * power_of(a / 4, m)
    at = fmpq(-1, 2)
    while at < alpha:
        form, at = form * number(at + 1) / (number(at + 1) - m), at + 1
    while at > alpha:
        form, at = form * (number(at) - m) / number(at), at - 1
    return scale * form, 0


def power_of(a: fmpq, m: Expr) -> Expr:
    """Return aᵐ with the sign apart."""
    whole = ONE if abs(a) == 1 else power(number(abs(a)), m)
    return power(MINUS_ONE, m) * whole if a < 0 else whole
