"""A variable end of an integral or a sum: compare derivatives, or differences, instead.

Let h be the left side and k the comparison function, both divided by the factor of the integral,
so that h′ is explicit. Suppose k′ ≠ 0 near the end of the path. If k → ±∞, or if h and k both tend
to 0, then

- h′ = O(k′) gives h = O(k), h′ = o(k′) gives h = o(k) (by Cauchy's mean value theorem);
- if h′/k′ tends to L, finite or infinite, then so does h/k (de l'Hôpital's rule).

Where h and k vanish at the end, the constant of h′ = O(k′) carries over to the region on which it
holds. Sums up to n use differences Δh(n) = h(n + 1) − h(n) in place of h′ (Stolz–Cesàro theorem).
What h tends to, if not 0, is a statement of its own: ``integral(exp(-t**2), t, 0, oo) == …``.

Example: ``integral(exp(-t)/t, t, x, oo) == exp(-x)/x*(1 - 1/x) + O(exp(-x)/x**3)`` holds because
the derivative −e^(−x)/x − (e^(−x)(1/x − 1/x²))′ = −2e^(−x)/x³ is O((e^(−x)/x³)′).

Sources: Olver 1974, ch. 2, §1; G. H. Hardy, *A Course of Pure Mathematics*, §126; DLMF 2.1.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.lemma import End, Obligations, smallest
from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    integer,
    number,
    opened,
    power,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

CONTINUOUS = "Cauchy's mean value theorem and de l'Hôpital's rule (Olver 1974, ch. 2, §1)"
DISCRETE = "the Stolz–Cesàro theorem"
MOST_NEW = 4
"""The most terms by which a sum changes from n to n + 1."""
FAR = (3, 10, 100)
"""How near to the end the ends of an integral must be in order."""
_INFINITE = (INFINITY, -INFINITY)


class _Quotient(NamedTuple):
    """Left side h and comparison function k, divided by the factor; h′, k′, and the last value.

    Attributes:
        value: what h tends to as an expression that may hold an integral without the variable.
    """

    h: Expr
    k: Expr
    dh: Expr
    dk: Expr
    value: Expr | None
    discrete: bool


def decide_variable_end(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide an order, a limit or an equivalence with integrals or sums of variable ends.

    Args:
        decided: decides what is left.

    Returns:
        The answer, or None where the claim has another shape.
    """
    path = statement.path
    if path is None or len(path.sides) != 1 or claim.derivatives or statement.equations:
        return None
    names = symbols(claim.left) | symbols(claim.right)
    end = End(path.name, path.point, path.sides[0], statement.given, names)
    f, relation, g = claim.left, claim.relation, claim.right
    if relation == LIMIT and g not in _INFINITE:
        f, relation, g = f - g, "o", ONE
    elif relation == "~":
        least = smallest(g, end) if elementary(g) else None
        if least is None or not elementary(g):
            return None
        f, relation, g = f - g, "o", least
    if relation not in ("O", "o") or g in _INFINITE or not elementary(g):
        return None
    try:
        found = _quotient(f, g, end)
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    return None if found is None else _compared(found, relation, end, statement, decided)


def _quotient(f: Expr, g: Expr, end: End) -> _Quotient | None:
    nodes = list(dict.fromkeys(outermost(f)))
    moving = [node for node in nodes if end.name in symbols(node)]
    if not moving or any(node.op not in ("integral", "sum") for node in moving):
        return None
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(moving)}
    marked = replaced(f, marks)
    inner = {str(mark.args[0]) for mark in marks.values()}
    slopes = {node: differentiate(marked, str(mark.args[0])) for node, mark in marks.items()}
    if any(symbols(slope) & inner or slope.hidden for slope in slopes.values()):
        return None
    factor = slopes[moving[0]]
    discrete = moving[0].op == "sum"
    if any(node.op != moving[0].op for node in moving):
        return None
    rest = substitute(marked, dict.fromkeys(inner, ZERO))
    if not elementary(rest):
        return None
    k, rest = g / factor, rest / factor
    h: Expr = rest
    dh = _difference(rest, end) if discrete else differentiate(rest, end.name)
    value: Expr | None = end.limit(rest)
    for node, slope in slopes.items():
        share = slope / factor
        if (
            end.name in symbols(share)
            and decide(differentiate(share, end.name), ZERO, end.given).verdict
            is not Verdict.PROVED
        ):
            return None
        change = change_of_sum(node, end) if discrete else change_of(node, end)
        if change is None:
            return None
        h = h + share * node
        dh = dh + share * change
        last = _last(node, end)
        value = None if value is None or last is None else value + share * last
    dk = _difference(k, end) if discrete else differentiate(k, end.name)
    return _Quotient(h, k, dh, dk, value, discrete)


def _difference(e: Expr, end: End) -> Expr:
    x = symbol(end.name)
    return substitute(e, {end.name: x + 1}) - e


def change_of(node: Expr, end: End, where: Given | None = None) -> Expr | None:
    """Return the derivative of an integral by Leibniz's rule; its body must not hold x.

    Args:
        where: conditions under which the integral must exist; near the end of the path unless told.
    """
    (t,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if body.hidden or end.name in symbols(body) or low.hidden or high.hidden:
        return None
    change = ZERO
    for place, side in ((high, 1), (low, -1)):
        if place not in _INFINITE and end.name in symbols(place):
            change = change + side * substitute(body, {t: place}) * differentiate(place, end.name)
    if not _is_integrable(node, t, body, end, where):
        return None
    return change


def _is_integrable(node: Expr, t: str, body: Expr, end: End, where: Given | None) -> bool:
    """Return whether the integral exists near the end of the path, or under conditions."""
    low, high = node.args[1:]
    for near in near_the_end(end) if where is None else (where,):
        backward = not sign_between(low, high, near)
        smaller, larger = (high, low) if backward else (low, high)
        if backward and not sign_between(smaller, larger, near):
            continue
        x = symbol(t)
        lower = () if smaller in _INFINITE else ((x, ">", smaller),)
        upper = () if larger in _INFINITE else ((x, "<", larger),)
        if continuous_on(body, near & Given((*lower, *upper)), proof) is None:
            fixed = [(e, d) for e, d in ((smaller, 1), (larger, -1)) if end.name not in symbols(e)]
            return all(_converges_at(body, t, e, d, end.given) for e, d in fixed)
    return False


def _converges_at(body: Expr, t: str, place: Expr, direction: int, given: Given) -> bool:
    """Return whether an integral converges absolutely at an end, from one side of it."""
    if place in _INFINITE:
        return _tail_converges(body, t, End(t, None, -direction, given))
    if continuous_on(substitute(body, {t: place}), given, proof) is None:
        return True
    room = direction * (symbol(t) - place)
    size = abs(body) * power(room, number(fmpq(3, 4)))
    return End(t, place, direction, given).limit(size) not in (None, *_INFINITE)


def _tail_converges(body: Expr, t: str, far: End) -> bool:
    """Return whether the integral converges absolutely at infinity."""
    x = far.side * symbol(t)
    powers = (fmpq(2), fmpq(3, 2), fmpq(11, 10))
    sizes = (abs(body) * power(x, number(r)) for r in powers)
    return any(far.limit(size) not in (None, *_INFINITE) for size in sizes)


def near_the_end(end: End) -> Iterator[Given]:
    """Yield conditions that hold near the end of the path, on smaller and smaller parts."""
    x = symbol(end.name)
    for far in FAR:
        if end.point is None:
            yield end.given & Given(((end.side * x, ">", number(far)),))
        else:
            room = end.side * (x - end.point)
            yield end.given & Given(((room, ">", ZERO), (room, "<", number(fmpq(1, far)))))


def sign_between(low: Expr, high: Expr, near: Given) -> bool:
    """Return whether low < high near the end."""
    if low == -INFINITY or high == INFINITY:
        return low != high
    if low == INFINITY or high == -INFINITY:
        return False
    return sign(high - low, near, ">") == "+"


def change_of_sum(node: Expr, end: End) -> Expr | None:
    """Return Δ of a sum to n + c or from n + c on; its terms must not hold n."""
    (k,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if body.hidden or end.name in symbols(body) or end.point is not None or end.side < 0:
        return None
    if not _has_terms(body, k, low, end):
        return None
    slopes = [integer(differentiate(e, end.name)) for e in (low, high) if e not in _INFINITE]
    if any(slope is None or not 0 <= slope <= MOST_NEW for slope in slopes):
        return None
    change = ZERO
    if high == INFINITY:
        if not _tail_converges(body, k, End(k, None, 1, end.given)):
            return None
    elif low not in _INFINITE:
        for n in range(slopes[1] or 0):
            change = change + substitute(body, {k: high + (n + 1)})
    else:
        return None
    for n in range(slopes[0] or 0):
        change = change - substitute(body, {k: low + n})
    return change


def _has_terms(body: Expr, k: str, low: Expr, end: End) -> bool:
    """Return whether all terms are defined, from the first index on."""
    start = integer(low)
    starts = FAR if start is None else (start,)
    return any(
        continuous_on(body, end.given & Given(((symbol(k), ">=", number(n)),)), proof) is None
        for n in starts
    )


def _last(node: Expr, end: End) -> Expr | None:
    """Return the integral or the sum with its ends at their limits; 0 where these are equal."""
    written = node.args[1:]
    low, high = (e if end.name not in symbols(e) else end.limit(e) for e in written)
    if low is None or high is None:
        return None
    if low == high and low not in _INFINITE:
        return ZERO
    (t,), body = opened(node, end.taken)
    for place, old, direction in ((low, written[0], 1), (high, written[1], -1)):
        moved = end.name in symbols(old)
        if moved and not _converges_at(body, t, place, direction, end.given):
            return None
    if node.op == "sum" and low in _INFINITE:
        return ZERO
    if low == high:
        return ZERO
    return rebuild(node, (node.args[0], low, high))


def _compared(
    q: _Quotient, relation: str, end: End, statement: Statement, decided: Decide
) -> Answer | None:
    ask = Obligations(statement, decided)
    lemma = DISCRETE if q.discrete else CONTINUOUS
    last = end.limit(q.k)
    if last is None or not _keeps_sign(q.dk, end):
        return None
    said = f"by {lemma}"
    if last not in _INFINITE:
        if last != ZERO and sign(last, end.given, "!=") not in PROVING["!="]:
            return None
        if q.value is None:
            return None
        answer = _at_the_end(q, relation, last, end, statement, decided, said, lemma)
        if answer is not None or last != ZERO:
            return answer
        if q.value != ZERO and not ask.holds(q.value, "==", ZERO, end.given):
            return None
    answer = ask.ask(q.dh, relation, q.dk, end.given, end.path)
    how = "difference" if q.discrete else "derivative"
    if answer:
        constant, where = None, None
        if last == ZERO and answer.region is not None and end.given == Given():
            region = Given.parse(answer.region)
            if any(ask.holds(q.dk, relation, ZERO, region) for relation in "<>"):
                constant, where = answer.constant, answer.region
        verdict = worst([answer, Answer(ask.verdict, "")]).verdict
        why = f"{said}: the {how} of the left side, {q.dh}, is {relation}({q.dk})"
        if relation != "O":  # the constant of the derivatives is none of the claim
            why += f"; {answer.why}"
        plain = not q.discrete and relation == "O"
        return Answer(
            verdict,
            why,
            constant=constant if plain else None,
            region=where if plain else None,
            lemma=lemma,
            obligations=tuple(ask.found),
        )
    ratio = end.limit(q.dh / q.dk)
    if ratio is None:
        return None
    fails = ratio in _INFINITE or (
        relation == "o" and sign(ratio, end.given, "!=") in PROVING["!="]
    )
    if not fails or answer.verdict is not Verdict.REFUTED:
        return None
    why = f"{said}: the ratio of the {how}s tends to {ratio}, and so does that of the two sides"
    found = tuple(ask.found)
    return Answer(Verdict.REFUTED, why, witness=answer.witness, lemma=lemma, obligations=found)


def _at_the_end(
    q: _Quotient,
    relation: str,
    last: Expr,
    end: End,
    statement: Statement,
    decided: Decide,
    said: str,
    lemma: str,
) -> Answer | None:
    """Decide by the limits of both sides, where that of the left side is not 0."""
    assert q.value is not None
    ask = Obligations(statement, decided)
    if q.value in _INFINITE:
        return None
    if last == ZERO:
        away = ask.ask(q.value, "==", ZERO, end.given)
        if away.verdict is not Verdict.REFUTED or symbols(q.value) - {"oo"}:
            return None
        why = f"{said}: the left side, divided by its factor, tends to {q.value}, which is not 0"
        why += f", and the right side to 0; {away.why}"
        return Answer(
            Verdict.REFUTED, why, witness=_somewhere(end), lemma=lemma, obligations=tuple(ask.found)
        )
    if relation == "O":
        why = f"{said}: both sides tend to constants, {q.value} and {last}"
        return Answer(Verdict.PROVED, why, lemma=lemma)
    zero = ask.ask(q.value, "==", ZERO, end.given)
    if zero:
        why = f"{said}: the left side tends to {q.value} = 0"
        return Answer(zero.verdict, why, lemma=lemma, obligations=tuple(ask.found))
    if zero.verdict is Verdict.REFUTED and not symbols(q.value) - {"oo"}:
        why = f"{said}: the left side tends to {q.value}, which is not 0; {zero.why}"
        return Answer(Verdict.REFUTED, why, witness=_somewhere(end), lemma=lemma)
    return None


def _keeps_sign(e: Expr, end: End) -> bool:
    """Return whether a function has no zeros near the end."""
    from tresym.reals.expansions.leading_terms import leading_sign

    return bool(leading_sign(e, end.name, end.point, end.side, end.given))


def _somewhere(end: End) -> dict[str, str]:
    """Return a point of the path, at which nothing special happens."""
    if end.point is None:
        return {end.name: str(10 * end.side)}
    return {end.name: str(end.point + number(fmpq(end.side, 10)))}
