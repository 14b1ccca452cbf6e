"""Sums of hypergeometric terms that hold the upper end: the method of Wilf and Zeilberger.

To prove Σ_(k=0..n) F(n, k) = S(n), put f = F/S. Gosper's algorithm (by SymPy) finds a rational R
with

    f(n + 1, k) − f(n, k) = G(n, k + 1) − G(n, k),   G = R f.

This identity is checked exactly, as one between rational functions after division by f(n, k).
With it T(n) = Σ_(k=0..n) f(n, k) satisfies

    T(n + 1) − T(n) = G(n, n) − G(n, 0) + f(n + 1, n) − f(n, n) + f(n + 1, n + 1),

which must be 0, and T must be 1 at the first n. False equations are refuted at small integers.

Example: ``sum(binomial(n, k), k, 0, n) == 2**n`` has R = −k/(2(n + 1 − k)).

Source: M. Petkovšek, H. S. Wilf, D. Zeilberger, *A = B* (1996), ch. 5 and 7.
"""

from __future__ import annotations

from math import factorial
from typing import Any

from tresym.asymptotics.lemma import Obligations
from tresym.asymptotics.rational_functions import over
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    integer,
    multiply,
    number,
    opened,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.sympy import from_sympy
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp, time_limit
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

LEMMA = "the method of Wilf and Zeilberger (Petkovšek, Wilf and Zeilberger 1996, ch. 7)"
SECONDS = 4.0
"""Of processor time for Gosper's algorithm."""
MOST_STEPS, LARGEST = 6, 100


def decide_by_telescoping(
    claim: Comparison, statement: Statement, decided: Decide
) -> Answer | None:
    """Prove an equation of a sum from 0 to n with a closed form; None if there is no proof."""
    nodes = [node for node in outermost(claim.left, claim.right) if node.op == "sum"]
    if claim.relation != "==" or len(set(nodes)) != 1 or claim.derivatives:
        return None
    if statement.path is not None or statement.equations:
        return None
    node = nodes[0]
    solved = claim.solved(node)
    if solved is None or solved[1].op != "number":
        return None
    closed = solved[0]
    (k,), body = opened(node, symbols(claim.left) | symbols(claim.right) | statement.given.names)
    if integer(node.args[1]) != 0 or node.args[2].op != "symbol":
        return None
    n = str(node.args[2])
    if n not in symbols(body) or symbols(body) - {n, k} or symbols(closed) - {n}:
        return None
    try:
        with time_limit(SECONDS):
            certificate = _certificate(body / closed, n, k)
    except TimeUp:
        return None
    if certificate is None:
        return None
    try:
        return _proved(body, closed, certificate, n, k, statement, decided)
    except (InputError, ZeroDivisionError, OverflowError):
        return None


def _proved(
    body: Expr, closed: Expr, r: Expr, n: str, k: str, statement: Statement, decided: Decide
) -> Answer | None:
    m, j = symbol(n), symbol(k)
    low = statement.given.box.get(n)
    first = 0 if low is None or low.low is None else max(0, int(low.low.ceil()))
    if low is not None and (low.high is not None or (low.low_open and low.low == first)):
        return None
    if any(n in symbols(a) | symbols(b) and not _plain(a, b, n) for a, _, b in _links(statement)):
        return None
    ask = Obligations(statement, decided)
    beyond = Given(((m, ">=", number(first)),))
    inside = beyond & Given(((j, ">=", ZERO), (j, "<=", m)))
    by_n = ratio(body, n, 1) * ratio(closed, n, -1)
    by_k = ratio(body, k, 1)
    moved = substitute(r, {k: j + 1})
    gap = in_lowest_terms(moved * by_k - r - by_n + 1)
    if gap != ZERO:
        return None
    for part in (over(in_lowest_terms(r))[1], over(in_lowest_terms(by_n))[1]):
        if sign(part, inside, "!=") not in PROVING["!="]:
            return None
    ask.keep(
        f"R = {r} satisfies f(n + 1, k) - f(n, k) = G(n, k + 1) - G(n, k)", Given(), Verdict.PROVED
    )
    f = body / closed
    later = substitute(f, {n: m + 1})
    ends = [
        substitute(r * f, {k: m}),
        -substitute(r * f, {k: ZERO}),
        substitute(later, {k: m}),
        -substitute(f, {k: m}),
        substitute(later, {k: m + 1}),
    ]
    total = add(ZERO, *map(_tidy, ends))
    if not ask.ask(total, "==", ZERO, beyond, None, (n,)):
        return None
    at_first = substitute(body, {n: number(first)})
    start = [substitute(at_first, {k: number(i)}) for i in range(first + 1)]
    at_closed = _tidy(substitute(closed, {n: number(first)}))
    if not ask.ask(add(ZERO, *map(_tidy, start)), "==", at_closed):
        return None
    why = f"by {LEMMA}: with R = {r}, and it holds at {n} = {first}"
    return Answer(ask.verdict, why, lemma=LEMMA, obligations=tuple(ask.found))


def _tidy(e: Expr) -> Expr:
    """Return ``e`` with the arguments of factorials in lowest terms, and their values."""
    known = {}
    for node in outermost(e):
        if node.op == "unknown":
            u = in_lowest_terms(node.args[1])
            value = integer(u)
            fixed = value is not None and 0 <= value <= LARGEST
            known[node] = number(factorial(value or 0)) if fixed else unknown(FACTORIAL, (u,))
    return replaced(e, known) if known else e


def _links(statement: Statement) -> tuple[tuple[Expr, str, Expr], ...]:
    return statement.given.comparisons


def _plain(left: Expr, right: Expr, name: str) -> bool:
    return {str(left), str(right)} >= {name} and not symbols(left) & symbols(right)


def ratio(e: Expr, name: str, side: int) -> Expr:
    """Return e(name + 1)/e(name) of a hypergeometric term, or its inverse, as a rational function.

    Raises:
        InputError: it is no product of factorials, powers and rational functions.
    """
    x = symbol(name)
    if name not in symbols(e):
        return ONE
    if e.op == "*":
        return multiply(*(ratio(arg, name, side) for arg in e.args))
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        times = int(e.args[1].args[0].p)
        return power(ratio(e.args[0], name, side if times > 0 else -side), number(abs(times)))
    if e.op == "unknown" and e.args[0].args[0] == FACTORIAL:
        u = e.args[1]
        step = _step(u, name)
        if step is None or abs(step) > MOST_STEPS:
            raise InputError("a factorial whose argument is not linear")
        up = [u + i for i in range(1, step + 1)] if step > 0 else [u - i for i in range(-step)]
        value = multiply(*up) if up else ONE
        return power(value, number(side * (1 if step > 0 else -1)))
    if e.op == "^" and name in symbols(e.args[1]) and name not in symbols(e.args[0]):
        step = _step(e.args[1], name)
        if step is None:
            raise InputError("a power whose exponent is not linear")
        return power(e.args[0], number(side * step))
    if e.hidden or any(name in symbols(a) for a in _exponents(e)):
        raise InputError("no hypergeometric term")
    value = substitute(e, {name: x + 1}) / e
    return power(value, number(side))


def _exponents(e: Expr) -> list[Expr]:
    if e.op in LEAVES:
        return []
    own = [e.args[1]] if e.op == "^" else []
    return own + [part for arg in e.args for part in _exponents(arg)]


def _step(u: Expr, name: str) -> int | None:
    return integer(differentiate(u, name))


def _certificate(f: Expr, n: str, k: str) -> Expr | None:
    """Return R with f(n + 1, k) − f(n, k) = Δ_k(R f), by Gosper's algorithm; unverified."""
    import sympy

    try:
        d = in_lowest_terms(ratio(f, n, 1) - 1)
        term = in_lowest_terms(substitute(d, {k: symbol(k) + 1}) / d * ratio(f, k, 1))
        names = {s: sympy.Symbol(s, integer=True, positive=True) for s in (n, k)}
        quotient, whole = (_to_sympy(e, names, sympy) for e in (term, d))
        found = _gosper(quotient, names[k], sympy)
        if found is None:
            return None
        return in_lowest_terms(from_sympy(sympy.together(found * whole)))
    except Exception:  # SymPy's own faults are not ours to name
        return None


def _gosper(quotient: Any, k: Any, sympy: Any) -> Any:
    """Return y with y(k + 1) t(k + 1)/t(k) − y(k) = 1 for the ratio t(k + 1)/t(k), or None.

    Gosper's algorithm as in Petkovšek, Wilf and Zeilberger 1996, ch. 5.
    """
    from sympy.concrete.gosper import gosper_normal

    above, below = sympy.fraction(sympy.together(quotient))
    a, b, c = gosper_normal(above, below, k)
    b = b.shift(-1)
    n, m, t = sympy.S(a.degree()), sympy.S(b.degree()), sympy.S(c.degree())
    if n != m or a.LC() != b.LC():
        degrees = {t - max(n, m)}
    elif not n:
        degrees = {t - n + 1, sympy.S.Zero}
    else:
        degrees = {t - n + 1, (b.nth(n - 1) - a.nth(n - 1)) / a.LC()}
    degrees = {int(d) for d in degrees if d.is_Integer and d >= 0}
    if not degrees:
        return None
    degree = max(degrees)
    coefficients = sympy.symbols(f"c:{degree + 1}", cls=sympy.Dummy)
    domain = a.get_domain().inject(*coefficients)
    x = sympy.Poly(coefficients, k, domain=domain)
    equation = a * x.shift(1) - b * x - c
    solution = sympy.solve(equation.coeffs(), coefficients)
    if not solution:
        return None
    y = x.as_expr().subs(solution)
    for other in coefficients:
        if other not in solution:
            y = y.subs(other, 0)
    if y.is_zero:
        return None
    return b.as_expr() * y / c.as_expr()


def _to_sympy(e: Expr, names: dict[str, Any], sympy: Any) -> Any:
    if e.op == "number":
        return sympy.Rational(int(e.args[0].p), int(e.args[0].q))
    if e.op == "symbol":
        return names[e.args[0]]
    args = [_to_sympy(arg, names, sympy) for arg in e.args]
    if e.op == "+":
        return sympy.Add(*args)
    if e.op == "*":
        return sympy.Mul(*args)
    if e.op == "^":
        return args[0] ** args[1]
    raise InputError("no rational function")
