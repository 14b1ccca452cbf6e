"""Suggest the expansion or the limit that is true instead of a refuted one.

For ``sin(x) == x - x**3/5 + O(x**5) as x -> 0`` the terms of the left side are computed up to the
order of the claim; for ``f -> L`` it is the limit, and for ``f ~ g`` the leading terms. The
suggestion is decided like any claim.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import fmpq

from tresym.asymptotics.expansion import terms_of
from tresym.asymptotics.explicit_terms import Terms
from tresym.asymptotics.schemes import true_order
from tresym.checking.dispatch import decide_within_limits
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import (
    ONE,
    ORDERS,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    opened,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import is_zero
from tresym.repair.agreement import Claim
from tresym.repair.like_terms import collected, over_one_bar

LARGEST_DENOMINATOR = 24
"""Of a rational multiple of what the author wrote."""
MORE = 3
"""How many terms more than those of the claim are looked for."""


def true_expansions(claim: Claim) -> Iterator[tuple[Claim, str]]:
    """Yield the claim with the true expansion or limit of its left side, and the edit in words."""
    if claim.path is None or claim.path.together or len(claim.terms) != 2:
        return
    try:
        statement = read(claim.text(""))
    except InputError:
        return
    (compared,) = statement.comparisons
    f, relation = claim.terms[0], claim.relations[0]
    if statement.path is None or compared.derivatives:
        return
    if relation == LIMIT:
        value = _limit(f, statement)
        if value is not None:
            yield claim._replace(terms=(f, value)), f"the limit is {value}"
        return
    right = claim.terms[1]
    factored = _factored(right)
    if relation == "==" and factored is not None:
        yield from _in_product(claim, *factored)
        return
    parts = right.args if right.op == "+" else (right,)
    orders = [part for part in parts if part.op in ORDERS]
    count = len(parts) - len(orders)
    if relation == "~" and not orders:
        found = _terms(f, statement, count)
        if found is not None and found.terms:
            why = _wrong_coefficient(right, found, statement) or "the leading terms are these"
            yield claim._replace(terms=(f, add(*map(over_one_bar, found.terms)))), why
        return
    if relation != "==" or len(orders) != 1 or orders[0].op not in ("O", "o"):
        return
    order = orders[0]
    weaker_by_one = true_order(compared, statement)
    if weaker_by_one is not None:
        edited = tuple(Expr("O", (weaker_by_one,)) if part == order else part for part in parts)
        yield claim._replace(terms=(f, add(*edited))), f"the error is O({weaker_by_one})"
        return
    stated = add(ZERO, *(part for part in parts if part.op not in ORDERS))
    known, under = _root_by_equation(f, claim, statement)
    same = _terms(known, under, count) if count else None
    if same is not None and same.gauge and is_zero(add(*same.terms) - stated, Given()):
        weaker = rebuild(order, (same.gauge,))
        edited = tuple(weaker if part == order else part for part in parts)
        yield claim._replace(terms=(f, add(*edited))), f"the error is of the order {same.gauge}"
    for more in range(count + MORE):
        found = _terms(known, under, more) if more or count else None
        if found is None:
            continue
        gauge = found.gauge
        if gauge is None or _is_small(gauge, order, statement):
            found = found._replace(terms=_in_the_words_of(stated, found.terms, statement))
            shown = [over_one_bar(term) for term in found.terms]
            terms = add(*shown, order) if shown else order
            wrong = _wrong_coefficient(stated, found, statement)
            why = wrong or f"the expansion is {add(*shown)}"
            yield claim._replace(terms=(f, terms)), why
            return


def _factored(right: Expr) -> tuple[Expr, Expr] | None:
    """Return g and h of ``g*h`` where h is a sum with O; None if there is no such sum."""
    factors = right.args if right.op == "*" else ()
    sums = [e for e in factors if e.op == "+" and any(term.op in ORDERS for term in e.args)]
    if len(sums) != 1:
        return None
    return multiply(ONE, *(e for e in factors if e is not sums[0])), sums[0]


def _in_product(claim: Claim, factor: Expr, inner: Expr) -> Iterator[tuple[Claim, str]]:
    """Yield the same for ``f == g*(1 + … + O(h))``: the expansion of f/g, or of f with another g.

    If the first term of the expansion is not the one that is written, the factor is wrong, and
    takes up the quotient of both.
    """
    f = claim.terms[0]
    first = next((term for term in inner.args if term == ONE), None)
    for found, why in true_expansions(claim._replace(terms=(f / factor, inner))):
        terms = found.terms[1].args if found.terms[1].op == "+" else (found.terms[1],)
        main = [term for term in terms if term.op not in ORDERS]
        if not main:
            continue
        orders = [term for term in terms if term.op in ORDERS]
        leading = ONE if first in main or first is None else main[0]
        edited = add(
            *(over_one_bar(collected(normal_form(term / leading, Given()))) for term in main),
            *orders,
        )
        better = factor
        if leading != ONE and not is_zero(leading - ONE, Given()):
            better = over_one_bar(collected(multiply(factor, leading)))
            why = f"the factor is {better}"
        yield claim._replace(terms=(f, multiply(better, edited))), why


def _root_by_equation(f: Expr, claim: Claim, statement: Statement) -> tuple[Expr, Statement]:
    """Return ``root(F, x, a, b)`` as x, with a claim about it under the equation F == 0."""
    if f.op != "root":
        return f, statement
    (name,), equation = opened(f, sorted(frozenset().union(*map(symbols, claim.terms))))
    low, high = f.args[1:3]
    given = [(equation, "==", ZERO)]
    given += [(low, "<", symbol(name))] if low != -INFINITY else []
    given += [(symbol(name), "<", high)] if high != INFINITY else []
    other = claim._replace(terms=(symbol(name), *claim.terms[1:]), given=(*given, *claim.given))
    try:
        return symbol(name), read(other.text(""))
    except InputError:
        return f, statement


def _wrong_coefficient(stated: Expr, found: Terms, statement: Statement) -> str:
    """Name the first coefficient that is not the true one; nothing if the terms differ otherwise.

    Of ``x - x**3/4`` for the sine it is said that the coefficient of ``x**3`` is -1/6, not -1/4.
    """
    assert statement.path is not None
    name = statement.path.name
    terms = stated.args if stated.op == "+" else (stated,)
    written = [_split(collected(t), name) for t in terms]
    for coefficient, power in (_split(collected(t), name) for t in found.terms):
        said = add(ZERO, *(c for c, p in written if p == power))
        if said != coefficient and not is_zero(said - coefficient, Given()):
            if power == ONE or (said == ZERO and len(found.terms) != len(written)):
                return ""
            if said == ZERO:
                return f"the term {coefficient * power} is missing"
            return f"the coefficient of {power} is {coefficient}, not {said}"
    return ""


def _in_the_words_of(stated: Expr, terms: Sequence[Expr], statement: Statement) -> tuple[Expr, ...]:
    """Return terms with coefficients as multiples of the stated ones, where they are such.

    The true coefficient ``2*tan(1)/(tan(1)**2 + 1)`` beside a stated ``sin(2)`` is ``sin(2)``.
    """
    assert statement.path is not None
    name = statement.path.name
    parts = stated.args if stated.op == "+" else (stated,)
    written = [_split(collected(t), name) for t in parts]
    shown = []
    for term in terms:
        coefficient, power = _split(collected(term), name)
        said = add(ZERO, *(c for c, p in written if p == power))
        multiple = _multiple(coefficient, said)
        shorter = multiple is not None and len(str(multiple)) < len(str(coefficient))
        shown.append(multiple * power if multiple is not None and shorter else term)
    return tuple(shown)


def _multiple(coefficient: Expr, said: Expr) -> Expr | None:
    """Return a simple rational multiple of a constant that equals another, or None."""
    if said == ZERO or symbols(said) | symbols(coefficient):
        return None
    try:
        with ball_precision():
            ratio = certified_evaluation().value(coefficient / said)
    except (UndefinedError, InputError):
        return None
    if not ratio.is_finite():
        return None
    near = Fraction(float(ratio.mid())).limit_denominator(LARGEST_DENOMINATOR)
    found = number(fmpq(near.numerator, near.denominator)) * said
    return found if is_zero(coefficient - found, Given()) else None


def _split(term: Expr, name: str) -> tuple[Expr, Expr]:
    """Split a term into its factors without the variable and those with it."""
    factors = term.args if term.op == "*" else (term,)
    inside = [f for f in factors if name in symbols(f)]
    return multiply(ONE, *(f for f in factors if f not in inside)), multiply(ONE, *inside)


def _is_small(gauge: Expr, order: Expr, statement: Statement) -> bool:
    """Return whether the error of the terms is of the order of the claim."""
    claim = Comparison(gauge, order.op, order.args[0])
    plain = Statement((), statement.given, statement.path, "")
    return bool(decide_within_limits(claim, plain))


def _limit(f: Expr, statement: Statement) -> Expr | None:
    path = statement.path
    assert path is not None
    if statement.equations or not elementary(f):
        terms = _terms(f, statement, 1)
        if terms is None or len(path.sides) > 1:
            return None
        place = path.name, path.point, path.sides[0], statement.given
        small = terms.gauge is None or limit_of(terms.gauge, *place) == ZERO
        return limit_of(add(ZERO, *terms.terms), *place) if small else None
    ends = (path.name, path.point)
    found = [limit_of(f, *ends, side, statement.given) for side in path.sides]
    return found[0] if None not in found and len({*found}) == 1 else None


def _terms(f: Expr, statement: Statement, count: int) -> Terms | None:
    try:
        return terms_of(f, statement, count, decide_within_limits)
    except InputError:
        return None
