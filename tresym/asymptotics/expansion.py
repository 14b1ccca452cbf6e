"""Find the asymptotic expansion of an explicit function or of a root along a path.

The terms of an explicit function are found one after another: the leading term of what the terms
found so far leave (Gruntz's algorithm, :mod:`tresym.reals.expansions`). For a root of F(y, e) = 0,
the elimination of :mod:`tresym.asymptotics.roots` gives its leading behaviour A; Newton's method
then gives term after term, the leading term of −F(A, e)/F_y(A, e). Example: for y⁵ + e y = 1 and
e → 0 the terms are 1, −e/5, −e²/25, and the error is O(e⁴).

What is found here is a guess of the expansion; it is decided afterwards like any claim.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from tresym.asymptotics.explicit_terms import Terms, explicit_terms, first_term, simple_term
from tresym.asymptotics.lemma import End
from tresym.asymptotics.lemma_claims import approximations
from tresym.asymptotics.recurrences import sequence_approximations
from tresym.asymptotics.roots import roots_near, start_of_root
from tresym.asymptotics.tubes import STEPS
from tresym.reals.decisions.answer import Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ZERO,
    Expr,
    add,
    apply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import is_zero

MOST = 12
"""The most terms of an expansion."""


def terms_of(f: Expr, statement: Statement, count: int, decided: Decide) -> Terms | None:
    """Return the first terms of a function along the first side of a path.

    Args:
        f: an explicit expression, integrals, sums or factorials, or an unknown or a sequence that
            the conditions determine.
        statement: the conditions and the path.
        count: the number of terms.
        decided: decides explicit claims.

    Returns:
        The terms, or None if they are not found.

    Raises:
        InputError: nothing is to be found; the text says why.
    """
    path = statement.path
    assert path is not None
    statement = replace(statement, path=replace(path, sides=path.sides[:1]))
    given = statement.given
    if statement.has_initial_values:
        raise InputError(
            "solutions of differential equations are not expanded; check decides an expansion of "
            "them that is written down"
        )
    if statement.premises:
        raise InputError("a function of which only an order is known has no expansion")
    if statement.recurrences:
        known = sequence_approximations(f, statement, decided)
        return approximated_terms(known, path, given, count)
    if statement.equations:
        return _of_unknown(f, statement, count, decided)
    if path.name in given.names:
        raise InputError(f"leave out the conditions on {path.name}")
    if f.op == "lambertw":
        w = symbol("[w]")
        lowest = ZERO if path.point is None else MINUS_ONE
        inside = given & Given(((w, ">", lowest),))
        equations = ((w * apply("exp", w), f.args[0]),)
        whole = replace(statement, given=inside, equations=equations)
        found = corrected_terms(whole, count, decided)
        if found is not None:
            return found
    if elementary(f):
        return explicit_terms(f, path, given, count)
    return approximated_terms(approximations(f, statement, decided), path, given, count)


def _of_unknown(f: Expr, statement: Statement, count: int, decided: Decide) -> Terms | None:
    """Return the first terms of a root."""
    try:
        found = root_terms(statement, count, decided)
    except InputError:
        other = corrected_terms(statement, count, decided)
        if other is None:
            raise
        return other
    if found is None:
        return corrected_terms(statement, count, decided)
    if f != symbol(found[0]):
        raise InputError(f"write {found[0]}, which the equation determines, to be expanded")
    return found[1]


def approximated_terms(
    known: Iterable[tuple[Expr, Expr]], path: Path, given: Given, count: int
) -> Terms | None:
    """Return the first terms of a function from explicit approximations with their errors.

    Args:
        known: approximations, each better than the one before, with the sizes of the errors.
        path: where the variable tends, from its first side.
        given: the conditions on parameters.
        count: the number of terms.
    """
    for main, error in known:
        found = explicit_terms(main, path, given, count)
        if found is None:
            continue
        if error == ZERO:
            return found
        end = End(path.name, path.point, path.sides[0], given)
        if len(found.terms) < count or any(end.limit(error / t) != ZERO for t in found.terms):
            continue
        rest = found.gauge
        if rest is None or end.limit(rest / error) == ZERO:
            first = first_term(error, path, given)
            rest = error if first is None else first[1]
        return Terms(found.terms, rest)
    return None


def corrected_terms(statement: Statement, count: int, decided: Decide) -> Terms | None:
    """Return the first terms of a root by Newton's corrections of its limit, or of log x or x."""
    path = statement.path
    assert path is not None
    for root in roots_near(statement, decided):
        known = (root.terms(order) for order in range(1, STEPS + 1))
        pairs = (pair for pair in known if pair is not None)
        terms = approximated_terms(pairs, path, Given(), count)
        if terms is not None:
            return terms
    return None


def root_terms(statement: Statement, count: int, decided: Decide) -> tuple[str, Terms] | None:
    """Return the unknown of a statement and the first terms of it along its path.

    Raises:
        InputError: the conditions select no root, or its leading behaviour is no power.
    """
    path = statement.path
    assert path is not None
    name, f, start = start_of_root(statement, decided)
    slope = differentiate(f, name)
    parts = start.args if start.op == "+" else (start,)
    found = [simple_term(part) for part in sorted(parts, key=lambda e: path.name in symbols(e))]
    found = [part for part in found if part != ZERO]
    first: tuple[Expr, Expr] | None = None
    for _ in range(count + 1):
        a = {name: add(ZERO, *found)}
        residual = substitute(f, a)
        if is_zero(residual, Given()):
            return name, Terms(tuple(found[:count]), None)
        first = first_term(-residual / substitute(slope, a), path, Given())
        if first is None:
            return None
        if len(found) >= count:
            break
        found = _joined(found, first[0], path)
    if len(found) > count:
        cut = first_term(add(ZERO, *found[count:]), path, Given())
        return None if cut is None else (name, Terms(tuple(found[:count]), cut[1]))
    return None if first is None else (name, Terms(tuple(found), first[1]))


def _joined(found: list[Expr], term: Expr, path: Path) -> list[Expr]:
    """Return the terms with one more; a correction of a term is added to it."""
    for k, old in enumerate(found):
        ratio = tidied(normal_form(term / old, _beside(path)))
        if path.name not in symbols(ratio):
            total = simple_term(tidied(old * (1 + ratio)))
            return [*found[:k], *([] if is_zero(total, Given()) else [total]), *found[k + 1 :]]
    return [*found, term]


def _beside(path: Path) -> Given:
    from tresym.asymptotics.path_claims import neighbourhood

    return neighbourhood(path, path.sides[0], number(10))
