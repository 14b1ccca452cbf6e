"""Definite integrals: by a checked antiderivative, or enclosed by quadrature.

∫ f from a to b, a < b, equals F(b−) − F(a+) if F and f are analytic on the open interval, F′ = f
there by the normal form, and F has these limits at the ends. The integral, proper or improper, then
converges; if one of the limits is infinite, it diverges. The interval is cut where a part of f or F
may be singular, and each piece is treated separately. If it is unknown which end is larger, both
cases are checked. Where F comes from does not matter for the proof: it may be given in the claim as
``at(F, x, b) - at(F, x, a)``, and otherwise SymPy suggests candidates.

Some integrals are quoted from tables (:mod:`tresym.reals.decisions.theorems`). An integral
without a known antiderivative is enclosed by rigorous quadrature
(:mod:`tresym.reals.domain.binder_values`), which can refute equations and prove bounds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide, failing, refuted, worst
from tresym.reals.decisions.equations import is_empty
from tresym.reals.decisions.exceptional_values import also_at_holes, also_at_zeros
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.integral_rules import Antiderivatives
from tresym.reals.decisions.integrand_bounds import decide_by_integrand
from tresym.reals.decisions.integration_pieces import (
    MINUS_INFINITY,
    pieces_of,
    roots_of_squares,
    without_corners,
)
from tresym.reals.decisions.known_values import known_value
from tresym.reals.decisions.readable_witnesses import constants_hold, decided_at, simple_points
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.decisions.waves import has_no_limit
from tresym.reals.domain import binder_values
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    add,
    apply,
    instantiate,
    multiply,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.language.like_terms import collected
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on, undefined
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Cause, Verdict

BITS = (64, 128)
PARAMETERS = 3
_OPEN = "no antiderivative could be found and verified on the whole interval"


class _Work(NamedTuple):
    """Sentences for the reason, and antiderivatives that the claim itself contains."""

    notes: list[str]
    primitives: tuple[Expr, ...]


class _OpenError(Exception):
    """An integral could not be evaluated; the text is the reason."""


class _DivergentError(_OpenError):
    """An integral is proved to have no value, finite or infinite, wherever ``given`` holds."""

    def __init__(self, f: Expr, why: str, given: Given) -> None:
        super().__init__(f"the integral of {f} has no value: it {why}")
        self.given = given


def decide_integrals(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with definite integrals.

    Args:
        claim: the comparison to decide.
        statement: its conditions.
        decided: the procedure for claims without integrals.

    Returns:
        PROVED, ENCLOSED or REFUTED, or UNDECIDED with the obstacle as the reason.
    """
    if any(next(functions(side), None) for side in (claim.left, claim.right)):
        return Answer(Verdict.UNDECIDED, "integrals of arbitrary functions cannot be evaluated")
    result = _by_quadrature(claim, statement)
    if result is None:
        result = decide_by_integrand(claim, statement, decided)
    if result is not None:
        return result
    work = _Work([], claim.primitives)
    given = _where_defined(claim, statement.given)
    try:
        sides = [_without(side, given, work) for side in (claim.left, claim.right)]
    except _OpenError as error:
        result = _without_value(claim, error)
        result = _by_identity(claim, statement, decided) if result is None else result
        result = _at_parameters(claim, statement, decided) if result is None else result
        result = _for_each_sign(claim, statement, decided) if result is None else result
        if result is not None:
            return result
        return Answer(Verdict.UNDECIDED, str(error), cause=Cause.NO_VALUE)
    except InputError as error:
        why = f"an intermediate expression exceeds the size limit: {error}"
        return Answer(Verdict.UNDECIDED, why, cause=Cause.TOO_LARGE)
    said = "; ".join(dict.fromkeys(work.notes))
    if any(side in (INFINITY, MINUS_INFINITY) for side in sides):
        points = simple_points(_parameters(claim), given, PARAMETERS, statement.integers)
        return _infinite(claim.relation, sides, said, points)
    if any(INFINITY.args[0] in symbols(side) for side in sides):
        return Answer(
            Verdict.UNDECIDED,
            f"an integral is infinite and part of a sum or product, which is not supported; {said}",
        )
    plain = replace(statement, given=given)
    answer = decided(replace(claim, left=sides[0], right=sides[1]), plain)
    answer = replace(answer, why=f"{said}; {answer.why}")
    known = dict(zip((claim.left, claim.right), sides, strict=True))
    return also_at_holes(answer, known, claim, statement, decided)


def without_integrals(
    sides: Iterable[Expr], given: Given, primitives: tuple[Expr, ...]
) -> tuple[list[Expr], str] | None:
    """Return the sides with their integrals evaluated and the reason; None if that fails."""
    work = _Work([], primitives)
    try:
        answers = [_without(side, given, work) for side in sides]
    except (_OpenError, InputError):
        return None
    return answers, "; ".join(dict.fromkeys(work.notes))


def _where_defined(claim: Comparison, given: Given) -> Given:
    """Return the conditions, and that everything outside the integrals is defined."""
    marks = {node: symbol(f"[{node}]") for node in outermost(claim.left, claim.right)}
    names = {str(mark.args[0]) for mark in marks.values()}
    parts = needs(replaced(side, marks) for side in (claim.left, claim.right))
    free = (part for part in parts if symbols(part[0]) and not symbols(part[0]) & names)
    return given & Given(tuple(bound(*part) for part in free))


def _infinite(relation: str, sides: list[Expr], said: str, points: list[dict[str, fmpq]]) -> Answer:
    """Decide an equation in which a side is infinite wherever the conditions hold."""
    ordered = {INFINITY: 1, MINUS_INFINITY: -1}
    gap = ordered.get(sides[0], 0) - ordered.get(sides[1], 0)
    if relation != "==" and points and gap:
        holds = relation == "!=" or (gap > 0) == (relation[0] == ">")
        said = f"{said}; the left side is {sides[0]} and the right side is {sides[1]}"
        finite = [side for side in sides if not _ends(side)]
        with ball_precision():
            at = next((x for x in points if all(evaluate(e, x).is_finite() for e in finite)), None)
        if at is not None:
            return Answer(Verdict.PROVED, said) if holds else refuted(said, at)
    if relation != "==" or not points:
        return Answer(
            Verdict.UNDECIDED,
            f"{said}; the value is infinite; such a claim is supported "
            "only with ==, and where some simple point satisfies the conditions",
        )
    said = f"{said}; the left side is {sides[0]} and the right side is {sides[1]}"
    if sides[0] == sides[1]:
        return Answer(Verdict.PROVED, said)
    finite = [side for side in sides if not _ends(side)]
    for at in points:
        with ball_precision():
            if all(evaluate(side, at).is_finite() for side in finite):
                return refuted(said, at)
    return Answer(Verdict.UNDECIDED, f"{said}; no point was found where the other side is defined")


def _by_identity(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a proof that holds for arbitrary values of the (existing) integrals, or None."""
    values = Antiderivatives(statement.given)
    left, right = values.put_in(claim.left), values.put_in(claim.right)
    if left is None or right is None or claim.derivatives or statement.path is not None:
        return None
    answer = decided(replace(claim, left=left, right=right), statement)
    why = f"by linearity and additivity of integrals; {answer.why}"
    return replace(answer, why=why) if answer.verdict is Verdict.PROVED else None


def _without_value(claim: Comparison, error: _OpenError) -> Answer | None:
    """Refute an equation that gives a value to a divergent integral, or return None."""
    nodes = list(outermost(claim.left, claim.right))
    if not isinstance(error, _DivergentError) or claim.relation != "==" or claim.derivatives:
        return None
    if len(nodes) != 1 or not elementary(*nodes[0].args):
        return None
    value = (claim.solved(nodes[0]) or (None,))[0]
    names = _parameters(claim)
    if (
        value is None
        or (INFINITY.args[0] in symbols(value) and not _ends(value))
        or error.given.names - {*names}
    ):
        return None
    for at in simple_points(names, error.given, PARAMETERS):
        with ball_precision():
            if _ends(value) or evaluate(value, at).is_finite():
                return refuted(str(error), at)
    return None


def _at_parameters(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a refutation at simple values of the parameters, or None."""
    names = _parameters(claim)
    if not names or claim.derivatives or claim.relation not in NEGATED:
        return None  # the variable of a path is no parameter
    points = simple_points(names, statement.given, PARAMETERS, statement.integers)
    points += [dict.fromkeys(names, fmpq(0))] + [
        {name: fmpq(2 * (name != other)) for name in names} for other in names[: len(names) > 1]
    ]
    at = ({name: number(value) for name, value in point.items()} for point in points)
    inner = partial(decide_integrals, decided=decided)
    return decided_at(at, claim, statement, inner)[0]


def _for_each_sign(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a proof for a parameter that is positive, that is negative, and that is 0, or None."""
    given, integers = statement.given, statement.integers
    for name in _parameters(claim):
        if name in integers or sign(symbol(name), given, "!=") in ("+", "-"):
            continue
        parts = []
        for relation in (">", "<"):
            there = given & Given(((symbol(name), relation, ZERO),))
            if not is_empty(there):
                parts.append(decided(claim, replace(statement, given=there)))
                if not parts[-1]:
                    return None
        answer = worst(parts) if parts else Answer(Verdict.UNDECIDED, "")
        answer = replace(answer, why=f"for each sign of {name}: {answer.why}")
        whole = (
            also_at_zeros(answer, [symbol(name)], claim, statement, decided) if answer else answer
        )
        return whole if whole else None
    return None


def _parameters(claim: Comparison) -> list[str]:
    """Return the free variables of both sides, without oo."""
    return sorted((symbols(claim.left) | symbols(claim.right)) - {str(INFINITY.args[0])})


# By an antiderivative


def _without(e: Expr, given: Given, work: _Work) -> Expr:
    """Return ``e`` with its integrals replaced by their values.

    Raises:
        _OpenError: one has no value that is shown.
    """
    if e.op in LEAVES:
        return e
    if e.op != "integral":
        return rebuild(e, tuple(_without(arg, given, work) for arg in e.args))
    (name,), body = opened(e, given.names)
    low, high = (end if _ends(end) else _without(end, given, work) for end in e.args[1:])
    return _integral(name, body, low, high, given, work)


def _is_odd(name: str, f: Expr, low: Expr, high: Expr, given: Given) -> bool:
    """Return whether f is odd and smooth on an interval symmetric about 0."""
    x = symbol(name)
    if _ends(high) or decide(low, -high, given).verdict is not Verdict.PROVED:
        return False
    closed = given & Given(((x, ">=", low), (x, "<=", high)))
    mirrored = decide(substitute(f, {name: -x}), -f, closed)
    return mirrored.verdict is Verdict.PROVED and continuous_on(f, closed) is None


def _ends(e: Expr) -> bool:
    return e in (INFINITY, MINUS_INFINITY)


def _integral(name: str, f: Expr, low: Expr, high: Expr, given: Given, work: _Work) -> Expr:
    if low == high and not _ends(low):
        high, low = low + 1, low  # shown to be defined around the point
        return multiply(ZERO, _integral(name, f, low, high, given, work))
    direction = "+" if _order(low, high) > 0 else "-" if _order(low, high) < 0 else None
    direction = direction or sign(high - low, given, "!=") or sign(high - low, given, ">=")
    direction = direction or sign(high - low, given, "<=")
    rising, falling = (given & Given(((low, r, high),)) for r in ("<", ">"))
    if direction in ("+", ">=0"):
        inside = given if direction == "+" else rising
        value = _between(name, f, low, high, inside, work)
    elif direction in ("-", "<=0"):
        inside = given if direction == "-" else falling
        value = -_between(name, f, high, low, inside, work)
    else:
        value = _between(name, f, low, high, rising, work)
        backward = _between(name, f, high, low, falling, work)
        if _ends(value) or decide(value + backward, ZERO, given).verdict is not Verdict.PROVED:
            raise _OpenError(
                f"it could not be determined which of {low} and {high} is "
                "larger; a condition may help"
            )
    if direction not in PROVING["!="] and not _vanishes_where_they_meet(value, low, high, given):
        raise _OpenError(
            f"the integral is 0 where {low} = {high}, unlike the formula: "
            f"add the condition {low} != {high}"
        )
    return value


def _vanishes_where_they_meet(value: Expr, low: Expr, high: Expr, given: Given) -> bool:
    """Whether the value is 0 wherever the ends of the integral are equal."""
    gap = low if high == ZERO else high - low
    return not _ends(value) and all(_vanishes_with(e, value, given) for e in _factors_of_zero(gap))


def _vanishes_with(e: Expr, value: Expr, given: Given) -> bool:
    """Whether the value is 0 wherever ``e`` is, which is linear in a variable."""
    for name in sorted(symbols(e)):
        slope, rest = differentiate(e, name), substitute(e, {name: ZERO})
        if name in symbols(slope) or sign(slope, given, "!=") not in PROVING["!="]:
            continue
        put_in = partial(substitute, mapping={name: -rest / slope})
        links = [
            (x, relation, y)
            for x, relation, y in given.mapped(put_in).comparisons
            if relation not in (">=", "<=") or not (x == y or is_zero(x - y, Given()))
        ]
        there = constants_hold(links)
        if there is not None and decide(put_in(value), ZERO, there).verdict is Verdict.PROVED:
            return True
    return False


def _factors_of_zero(e: Expr) -> Iterator[Expr]:
    """Yield expressions of which at least one is 0 wherever ``e`` is."""
    if e.op == "*":
        for factor in e.args:
            yield from _factors_of_zero(factor)
    elif e.op == "^" and e.args[1].op == "number":
        yield from _factors_of_zero(e.args[0])
    elif symbols(e):
        yield e


def _order(low: Expr, high: Expr) -> int:
    """1 where an end is infinite and low < high, −1 where high < low, 0 for finite ends."""
    if low == MINUS_INFINITY or high == INFINITY:
        return 1
    return -1 if high == MINUS_INFINITY or low == INFINITY else 0


def _between(name: str, f: Expr, low: Expr, high: Expr, given: Given, work: _Work) -> Expr:
    """Return ∫ f from ``low`` to ``high``, where low < high under ``given``."""
    inside = given & _inside(name, low, high)
    f = _without(f, inside, work)
    if not elementary(f):
        raise _OpenError(
            f"integral of {f}: a sum or a limit in the integrand could not be evaluated"
        )
    for root, size in roots_of_squares(f, inside):
        f = replaced(f, {root: size})
        work.notes.append(f"{root} = {size} on the interval")
    known = known_value("integral", f, name, low, high, given)
    if known is not None:
        work.notes.append(f"the integral of {f} is {known.value} by {known.source}")
        return known.value
    if _is_odd(name, f, low, high, given):
        work.notes.append(f"{f} is odd in {name}")
        return ZERO
    pieces = list(pieces_of(name, (f,), low, high))
    values = [_piece(name, f, start, end, given, work) for start, end in pieces]
    infinite = {value for value in values if _ends(value)}
    if len(infinite) > 1:
        raise _DivergentError(f, "has both parts that are oo and parts that are -oo", given)
    return infinite.pop() if infinite else add(*values)


def _inside(name: str, low: Expr, high: Expr) -> Given:
    x = symbol(name)
    bounds = [] if low == MINUS_INFINITY else [(x, ">", low)]
    bounds += [] if high == INFINITY else [(x, "<", high)]
    return Given(tuple(bounds))


def _piece(name: str, f: Expr, low: Expr, high: Expr, given: Given, work: _Work) -> Expr:
    """Return ∫ f over one piece, by the first candidate that is verified."""
    from tresym.reals.decisions.antiderivatives import suggested

    inside = given & _inside(name, low, high)
    plain = without_corners(f, inside)
    positive = {s for s in symbols(plain) if sign(symbol(s), inside) == "+"}

    def later() -> Iterator[Expr]:  # SymPy is loaded where it is needed
        yield from suggested(plain, name, frozenset(positive))

    written = (instantiate(body, (symbol(name),)) for body in work.primitives)
    for candidate in chain(written, _of_waves(plain, name), later()):
        values = []
        for start, end in pieces_of(name, (candidate,), low, high):
            here = given & _inside(name, start, end)
            function = without_corners(candidate, here)
            values.append(_difference(name, plain, function, start, end, given))
            if values[-1] is None:
                break
        else:
            shown = [value for value in values if value is not None]
            infinite = {value for value in shown if _ends(value)}
            if len(infinite) > 1:
                raise _DivergentError(f, "has both parts that are oo and parts that are -oo", given)
            where = f" for {inside}" if inside.comparisons else ""
            work.notes.append(f"{candidate} is an antiderivative of {f}{where}")
            return infinite.pop() if infinite else add(*shown)
    infinite_value = _infinite_by_an_end(name, plain, low, high, inside)
    if infinite_value is not None:
        work.notes.append(f"the integral of {f} from {low} to {high} is {infinite_value}")
        return infinite_value
    raise _OpenError(f"integral of {f}: {_OPEN}")


def _infinite_by_an_end(name: str, f: Expr, low: Expr, high: Expr, inside: Given) -> Expr | None:
    """Return oo or -oo if the integrand grows like 1/(x - c), or faster, at one of its ends c.

    Then the integral up to c is infinite. At the other end the integrand must be bounded, or grow
    in the same way with the same sign, and in between it must be continuous.
    """
    if symbols(f) - {name} or continuous_on(f, inside, proof) is not None:
        return None
    signs = []
    for end, side in ((low, 1), (high, -1)):
        infinite = _ends(end)
        point = None if infinite else end
        way = (1 if end == INFINITY else -1) if infinite else side
        x = symbol(name)
        scaled = limit_of(f * (x if infinite else x - end), name, point, way, Given())
        bounded = None if infinite else limit_of(f, name, point, way, Given())
        if scaled is None:
            return None
        if scaled == ZERO:
            if bounded is None or _ends(bounded):
                return None
            signs.append(0)
            continue
        its_sign = {INFINITY: "+", MINUS_INFINITY: "-"}.get(scaled) or sign(scaled, Given(), "!=")
        if its_sign not in ("+", "-"):
            return None
        signs.append(way if its_sign == "+" else -way)
    if not any(signs) or {1, -1} <= {*signs}:
        return None
    return INFINITY if 1 in signs else MINUS_INFINITY


def _of_waves(f: Expr, name: str) -> Iterator[Expr]:
    """An antiderivative of a product of two sines or cosines of what is linear, by their sum."""
    parts = f.args if f.op == "*" else ()
    waves = [part for part in parts if name in symbols(part)]
    if len(waves) != 2 or any(wave.op not in ("sin", "cos") for wave in waves):
        return
    if waves[0].op == "cos":
        waves.reverse()
    (u, v), kinds = (wave.args[0] for wave in waves), tuple(wave.op for wave in waves)
    below, above = (collected(differentiate(e, name)) for e in (u - v, u + v))
    if name in symbols(below) | symbols(above):
        return
    wave, signs = {
        ("sin", "sin"): ("sin", (1, -1)),
        ("cos", "cos"): ("sin", (1, 1)),
        ("sin", "cos"): ("cos", (-1, -1)),
    }[kinds]
    terms = zip(signs, (u - v, u + v), (below, above), strict=True)
    yield multiply(
        *(part for part in parts if name not in symbols(part)),
        add(*(sign * apply(wave, e) / (2 * slope) for sign, e, slope in terms)),
    )


def _difference(
    name: str, f: Expr, function: Expr, low: Expr, high: Expr, given: Given
) -> Expr | None:
    """Return F(high−) − F(low+) if F is proved to be an antiderivative of f; None otherwise."""
    inside = given & _inside(name, low, high)
    if any(continuous_on(e, inside, proof) is not None for e in (f, function)):
        return None
    if decide(differentiate(function, name), f, inside).verdict is not Verdict.PROVED:
        return None
    ends = []
    for end, side in ((high, -1), (low, 1)):
        point = None if _ends(end) else end
        toward = side if point is not None else 1 if end == INFINITY else -1
        value = None if point is None else _at_end(function, name, point, given)
        if value is None:
            value = limit_of(function, name, point, toward, given)
        if value is None and point is None and has_no_limit(function, name, toward, given):
            raise _DivergentError(
                f, f"oscillates without a limit, as {function} does towards {end}", given
            )
        if value is None:
            return None
        ends.append(value)
    above, below = ends
    if _ends(above) or _ends(below):
        if above == below:
            raise _DivergentError(f, "has both parts that are oo and parts that are -oo", given)
        return above if _ends(above) else -below
    return above - below


def _at_end(function: Expr, name: str, point: Expr, given: Given) -> Expr | None:
    """Its value there, which is its limit from where it is defined: only sign and atan2 jump."""
    value = substitute(function, {name: point})
    return None if binder_values.jumps(function) or undefined(value, given) is not None else value


# By quadrature


def _by_quadrature(claim: Comparison, statement: Statement) -> Answer | None:
    """Decide by rigorous quadrature: refute at simple parameters; prove a bound without any."""
    sides = claim.left, claim.right
    names = _parameters(claim)
    nodes = list(outermost(*sides))
    if (
        any(INFINITY.args[0] in symbols(side) for side in sides)
        or claim.derivatives
        or claim.relation not in NEGATED
        or not all(elementary(*n.args) for n in nodes)
    ):
        return None
    points = simple_points(names, statement.given, PARAMETERS, statement.integers)
    for at in points if names else [{}]:
        for bits in BITS:
            with ball_precision(bits):
                balls = {name: arb(value) for name, value in at.items()}
                left, right = (binder_values.value(e, balls, lambda *_: False) for e in sides)
                if not (left.is_finite() and right.is_finite()):
                    break
                if stands(left - right, NEGATED[claim.relation]):
                    why = f"rigorous numerical integration shows that {failing(claim.relation)}"
                    return refuted(why, at, left, right)
                if not names and claim.relation != "==" and stands(left - right, claim.relation):
                    return Answer(Verdict.ENCLOSED, "by rigorous numerical integration")
    return None
