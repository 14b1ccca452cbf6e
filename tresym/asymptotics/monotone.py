"""Inequalities for integrals and sums with a variable end, and for factorials, by monotony.

To prove L ≤ R for all x of an interval, let D = R − L. If D′ ≤ 0 there, and D ≥ 0 as x tends to the
upper end, then D ≥ 0 throughout; if D′ ≥ 0, it is enough that D ≥ 0 as x tends to the lower end.
The derivative is explicit when L and R are divided by the factor of the integral. For sums up to n
the difference D(n + 1) − D(n) takes the place of D′. For positive sides with factorials it is the
quotient of consecutive terms: if (L/R)(n + 1) ≥ (L/R)(n) and L ≤ R as n → ∞, then L ≤ R for all n;
if the quotient is at most 1, the first n is enough. All parts are ordinary statements; what holds
near an end is decided by expansions.

Example: ``integral(exp(-t**2), t, x, oo) <= exp(-x**2)/(2*x) given x > 0``: the derivative of the
right minus the left side is −e^(−x²)/(2x²), and the right side is larger as x → ∞.

Source: G. H. Hardy, J. E. Littlewood, G. Pólya, *Inequalities* (1934), §§2.1 and 4.1.
"""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from tresym.asymptotics.lemma import End, Obligations
from tresym.asymptotics.variable_end import change_of, change_of_sum
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import decided_at
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    number,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

LEMMA = "monotony of the difference (Hardy, Littlewood and Pólya 1934, §4.1)"
QUOTIENTS = "the ratio of consecutive terms (Hardy, Littlewood and Pólya 1934, §2.1)"
MIRRORED = {">": "<", ">=": "<="}
LOWEST, FIRST_TRIED = -3, 6


def decide_by_monotony(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Prove an inequality with integrals, sums or factorials by monotony in one variable.

    Returns:
        The proof, or None if there is none.
    """
    if claim.derivatives or statement.path is not None or statement.equations:
        return None
    if claim.relation in MIRRORED:
        claim = replace(
            claim, left=claim.right, right=claim.left, relation=MIRRORED[claim.relation]
        )
    if claim.relation not in ("<", "<="):
        return None
    names = symbols(claim.left) | symbols(claim.right)
    free = [name for name in names if _has_interval(name, statement.given)]
    ops = {node.op for node in outermost(claim.left, claim.right)}
    try:
        if ops == {"integral"}:
            for name in sorted(_ends(claim) & {*free}):
                found = _continuous(claim, name, statement, decided, names)
                if found is not None:
                    return found
        elif ops == {"sum"}:
            for name in sorted(_ends(claim) & {*statement.integers} & {*free}):
                found = _discrete(claim, name, statement, decided, names)
                if found is not None:
                    return found
        elif ops == {"unknown"}:
            for name in sorted({*statement.integers} & {*free}):
                found = _quotient(claim, name, statement, decided)
                if found is not None:
                    return found
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    return None


def _has_interval(name: str, given: Given) -> bool:
    """Return whether all that is said of a variable is that it lies between constants."""
    for left, relation, right in given.comparisons:
        sides = {str(left): right, str(right): left}
        if name not in symbols(left) | symbols(right):
            continue
        if relation == "!=" or name not in sides or symbols(sides[name]):
            return False
    return True


def _ends(claim: Comparison) -> frozenset[str]:
    """Return the variables in the ends of the integrals or sums."""
    ends = (e for node in outermost(claim.left, claim.right) for e in node.args[1:])
    return frozenset().union(*map(symbols, ends)) - {"oo"}


def _continuous(
    claim: Comparison, name: str, statement: Statement, decided: Decide, names: frozenset[str]
) -> Answer | None:
    given = statement.given
    where = given.box.get(name)
    low = None if where is None or where.low is None else number(where.low)
    high = None if where is None or where.high is None else number(where.high)
    for path, relation in ((_towards(name, high, -1), "<="), (_towards(name, low, 1), ">=")):
        point = path.point
        end = End(name, point, path.sides[0], _without(given, name), names)
        slope, plain = _slope(claim, end, given)
        if slope is None:
            return None
        ask = Obligations(statement, decided)
        strict = claim.relation == "<"
        if not ask.continuous(plain, given):
            return None
        falls = relation[0] if strict else relation
        if not ask.holds(slope, falls, ZERO, given):
            continue
        near = ask.ask(claim.left, "<=", claim.right, end.given, path)
        if not near:
            continue
        why = f"by {LEMMA}: the derivative of right - left, divided by the factor of the integral, "
        why += f"is {slope}, {falls} 0, and the inequality holds as {path}"
        return Answer(ask.verdict, why, lemma=LEMMA, obligations=tuple(ask.found))
    return None


def _towards(name: str, bound: Expr | None, side: int) -> Path:
    """Return the path to an end of the range; ``side`` is where the range lies from it."""
    return Path(name, bound, (side if bound is not None else -side,))


def _without(given: Given, name: str) -> Given:
    """Return the conditions that do not hold the variable."""
    links = (c for c in given.comparisons if name not in symbols(c[0]) | symbols(c[2]))
    return Given(tuple(links))


def _linear(claim: Comparison) -> tuple[dict[Expr, Expr], Expr] | None:
    """Return the coefficients of the nodes in right − left, and the rest; None if not linear."""
    gap = claim.right - claim.left
    nodes = list(dict.fromkeys(outermost(gap)))
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    marked = replaced(gap, marks)
    inner = {str(mark.args[0]) for mark in marks.values()}
    slopes = {node: differentiate(marked, str(mark.args[0])) for node, mark in marks.items()}
    rest = substitute(marked, dict.fromkeys(inner, ZERO))
    if not elementary(rest) or any(
        symbols(slope) & inner or slope.hidden for slope in slopes.values()
    ):
        return None
    return slopes, rest


def _slope(claim: Comparison, end: End, given: Given) -> tuple[Expr | None, Expr]:
    """Return the derivative of D/|c|, with c the factor of the first integral, and its rest."""
    found = _linear(claim)
    if found is None:
        return None, ZERO
    slopes, rest = found
    moving = {node: c for node, c in slopes.items() if end.name in symbols(node)}
    if not moving or len(moving) < len(slopes):
        return None, ZERO
    factor = next(iter(moving.values()))
    side = sign(factor, given, "!=")
    if side not in ("+", "-"):
        return None, ZERO
    direction = ONE if side == "+" else -ONE
    plain = rest / (direction * factor)
    slope = differentiate(plain, end.name)
    for node, c in moving.items():
        share = direction if c == factor else normal_form(c / (direction * factor), given)
        change = change_of(node, end, given)
        if change is None or end.name in symbols(share):
            return None, ZERO
        slope = slope + share * change
    return slope, plain


def _discrete(
    claim: Comparison, name: str, statement: Statement, decided: Decide, names: frozenset[str]
) -> Answer | None:
    found = _linear(claim)
    if found is None:
        return None
    slopes, rest = found
    if any(name in symbols(c) for c in slopes.values()):
        return None
    end = End(name, None, 1, _without(statement.given, name), names)
    step = substitute(rest, {name: symbol(name) + 1}) - rest
    for node, c in slopes.items():
        change = change_of_sum(node, end) if name in symbols(node) else ZERO
        if change is None:
            return None
        step = step + c * change
    first = _first(claim, name, statement, decided)
    if first is None:
        return None
    ask = Obligations(statement, decided)
    beyond = end.given & Given(((symbol(name), ">=", number(first)),))
    if not ask.continuous(rest, beyond):
        return None
    strict = claim.relation == "<"
    if not ask.holds(step, "<" if strict else "<=", ZERO, beyond):
        return None
    integers = (name,)
    near = ask.ask(claim.left, "<=", claim.right, end.given, end.path, integers)
    if not near:
        return None
    why = f"by {LEMMA}: right - left changes by {step} from n to n + 1, which is not positive, "
    why += f"and the inequality holds as {end.path}"
    return Answer(ask.verdict, why, lemma=LEMMA, obligations=tuple(ask.found))


def _quotient(claim: Comparison, name: str, statement: Statement, decided: Decide) -> Answer | None:
    """Prove L ≤ R for positive sides by the quotients of consecutive values."""
    given = _without(statement.given, name)
    first = _first(claim, name, statement, decided)
    if first is None:
        return None
    n = symbol(name)
    beyond = given & Given(((n, ">=", number(first)),))
    ask = Obligations(statement, decided)
    if not all(_is_positive(e, beyond, ask) for e in (claim.left, claim.right)):
        return None
    up = {name: n + 1}
    grown = substitute(claim.left, up) / claim.left
    allowed = substitute(claim.right, up) / claim.right
    end = End(name, None, 1, given)
    for relation in (">=", "<="):
        ask = Obligations(statement, decided)
        strict = relation[0] if claim.relation == "<" and relation == ">=" else relation
        if not ask.ask(grown, strict, allowed, beyond, None, (name,)):
            continue
        if relation == "<=":
            found, proved = decided_at([{name: number(first)}], claim, statement, decided)
            if found is not None or not proved:
                continue
            ask.keep(f"it holds at {name} = {first}", Given(), Verdict.PROVED)
        elif not ask.ask(claim.left, "<=", claim.right, given, end.path, (name,)):
            continue
        why = f"by {QUOTIENTS}: that of the left side, {grown}, is {strict} that of the right "
        where = f"{name} = {first}" if relation == "<=" else str(end.path)
        why += f"side, {allowed}, and the inequality holds {'at' if relation == '<=' else 'as'} "
        return Answer(ask.verdict, why + where, lemma=QUOTIENTS, obligations=tuple(ask.found))
    return None


def _first(claim: Comparison, name: str, statement: Statement, decided: Decide) -> int | None:
    """Return an integer from which on the claim is to be proved; before, it has no meaning.

    Values below are left out where the conditions exclude them, where a sum or a factorial is
    undefined, or where a side is 1/0.
    """
    where = statement.given.box.get(name)
    low = None if where is None else where.low
    least = LOWEST if low is None else -int(-low.p // low.q)
    if where is not None and low is not None and where.low_open and low.q == 1:
        least += 1
    bound = least if low is not None else None
    for node in outermost(claim.left, claim.right):
        start = _domain(node, name, name in statement.given.names)
        if start is None:
            return None
        bound = start if bound is None else max(bound, start)
    if bound is None:
        return None
    for value in range(bound, bound + FIRST_TRIED):
        at = {name: number(value)}
        sides = [substitute(e, at) for e in (claim.left, claim.right)]
        if not any(map(_is_undefined, sides)):
            return value
    return None


def _domain(node: Expr, name: str, empty: bool) -> int | None:
    """Return from which integer on a sum or a factorial is defined; LOWEST if always.

    Args:
        empty: whether sums may be empty.
    """
    if name not in symbols(node):
        return LOWEST
    if node.op == "unknown" and node.args[0].args[0] == FACTORIAL:
        gap = node.args[1]
    elif node.op == "sum":
        gap = node.args[2] - node.args[1] + int(empty)
    else:
        return None
    slope, start = differentiate(gap, name), substitute(gap, {name: ZERO})
    if slope.op != "number" or start.op != "number" or not slope.args[0] > 0:
        return None
    least: fmpq = -start.args[0] / slope.args[0]
    return int(least.ceil())


def _is_undefined(e: Expr) -> bool:
    """Return whether a constant visibly divides by 0."""
    return _folded(e) is None


def _folded(e: Expr) -> Expr | None:
    """Return a constant with products with 0 and powers of 0 worked out; None where 1/0 is."""
    if e.op in LEAVES or e.names or e.op == "unknown":
        return e
    args = []
    for arg in e.args:
        found = _folded(arg)
        if found is None:
            return None
        args.append(found)
    if e.op == "*" and ZERO in args:
        return ZERO
    if e.op == "^" and args[0] == ZERO and args[1].op == "number" and args[1].args[0] != 0:
        return ZERO if args[1].args[0] > 0 else None
    return rebuild(e, tuple(args))


def _is_positive(e: Expr, given: Given, ask: Obligations) -> bool:
    """Return whether an expression with factorials is continuous in them, and positive."""
    marks: dict[Expr, Expr] = {}
    for node in outermost(e):
        if node.op != "unknown":
            return False
        marks[node] = symbol(f"F_{len(marks)}")
    known = Given(tuple((mark, ">=", ONE) for mark in marks.values()))
    plain = replaced(e, marks)
    return ask.continuous(plain, given & known) and sign(plain, given & known) == "+"
