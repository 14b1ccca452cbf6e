"""Decide order claims, and signs near a point, by leading terms.

All statements are for t → 0+. f = O(g), f = o(g) and f ~ g follow from the leading terms of f and
g. The range, and the constant of O, come from the same expansions with error bounds near the end
and from balls over short intervals elsewhere. If a leading coefficient oscillates, the claim is
tested on sequences t → 0 on which a phase is 0, π/2, π, −π/2 or 1 modulo 2π; a phase u → ±∞ takes
these values infinitely often, so a claim that fails there is false.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import product
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.balls.taylor import taylor_value
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.expansions import Expansions
from tresym.reals.expansions.gruntz import Rewritten
from tresym.reals.expansions.scale import Leading, T, UnresolvedError
from tresym.reals.expansions.suprema import SHORTER, Near, Supremum, supremum
from tresym.reals.expansions.truncated_series import quotient, raised
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    apply,
    factors_in,
    integer,
    multiply,
    number,
    power,
    replaced,
    substitute,
    symbol,
)
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

HALVINGS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 2048, 8192)
PHASES = (ZERO, PI / 2, PI, -PI / 2, ONE)
MOST_PHASES = 96

OCTAVES, PIECES = 8, 8
"""How far towards the end balls bound a ratio, and over how many intervals from 2t to t."""

_FAILS = (UnresolvedError, InputError, ZeroDivisionError, OverflowError)


class Judgement(NamedTuple):
    """The result for an order statement about f and g.

    Attributes:
        verdict: ENCLOSED, REFUTED or UNDECIDED.
        ratio: leading term of f/g, where it is known and no wave is in it.
        true_order: likewise, of f.
        constant: for O, a ball around the supremum of |f/g| on the range.
        upto: the range 0 < t ≤ upto on which it holds.
        real: whether f and g are shown to be real on the range, by no point of it.
    """

    verdict: Verdict
    ratio: Expr | None = None
    true_order: Expr | None = None
    constant: arb | None = None
    upto: fmpq | None = None
    real: bool = False

    def root(self) -> Judgement:
        """What was found of squares, of the functions themselves."""
        if self.constant is None:
            return self._replace(ratio=None)
        low, high = self.constant.abs_lower(), self.constant.abs_upper()
        return self._replace(constant=arb(low).sqrt().union(arb(high).sqrt()), ratio=None)


_OPEN = Judgement(Verdict.UNDECIDED)


def judge_order(
    kind: str,
    left: Expr,
    right: Expr,
    upto: fmpq = fmpq(1),  # noqa: B008
    shown: tuple[Expr, Expr] = (symbol(T), 1 / symbol(T)),
    shorter: int = SHORTER,
) -> Judgement:
    """Decide an order statement for t → 0+ (the variable ``T``) on a range of at most ``upto``.

    Args:
        shown: the expressions for t and 1/t with which leading terms are written.
        shorter: how often the range is halved in search of a sharp constant.
    """
    found = Rewritten(T)
    try:
        with ball_precision():
            f, g = found.all_of(left, right)
            truth = _told(kind, f, g, found)
            leading = _leading_terms(f, g, found, shown)
            ways = [(kind, f, g, left / right, False), *_reduced(kind, f, g, found, left / right)]
            for relation, above, below, ratio, squared in ways if truth is not False else []:
                if _told(relation, above, below, found):
                    order = _order_at_end(g, found) if kind == "O" else None
                    asked = left, right, order
                    sharp = None if order is None else supremum(*asked, None, upto, shorter)
                    if sharp is not None:
                        constant = sharp.low.union(sharp.high)
                        return Judgement(Verdict.ENCLOSED, *leading, constant, sharp.upto, True)
                    judged = _on_a_range(relation, above, below, found, upto, ratio, leading)
                    if judged.constant is not None and not squared:
                        near = _near(above, below, found)
                        sharp = supremum(*asked, near, upto, shorter)
                    if sharp is not None:
                        constant = sharp.low.union(sharp.high)
                        return judged._replace(constant=constant, upto=sharp.upto)
                    if judged.verdict is Verdict.ENCLOSED:
                        return judged.root() if squared else judged
                elif not squared and _fails_at_a_phase(relation, above, below, found):
                    truth = False
                    break
    except _FAILS:
        return _OPEN
    return _OPEN if truth is not False else Judgement(Verdict.REFUTED, *leading)


def _order_at_end(g: Expr, found: Rewritten) -> int | None:
    """The order to which g vanishes at t = 0, if its leading term is a natural power of t."""
    with suppress(*_FAILS):
        first = found.expansions.leading(g)
        if first is not None and {*first.powers} <= {T} and not found.scale.waves:
            order = integer(first.powers.get(T, ZERO))
            return order if order is not None and order >= 0 else None
    return None


def _near(f: Expr, g: Expr, found: Rewritten) -> Near:
    """Bounds of the supremum of |f/g| near the end by leading terms, where f = O(g)."""

    def bounds(reach: fmpq) -> tuple[arb, arb] | None:
        with ball_precision(), suppress(*_FAILS):
            expansions = Expansions(found.scale, reach)
            if all(expansions.enclosure(u).low > 0 for u in found.signed):
                whole = _largest(f, g, found, expansions)
                return whole.lower(), whole.upper()
        return None

    return bounds


def near_end(left: Expr, right: Expr, name: str, point: Expr | None, side: int) -> Near | None:
    """Return bounds of |left/right| beside a point, or beyond a large value, by leading terms.

    None unless left = O(right) there is shown and nothing oscillates, or if there are integrals.

    Args:
        point: where; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.
    """
    if not elementary(left, right):
        return None
    t = symbol(T)
    put = {name: side / t if point is None else point + side * t}
    found = Rewritten(T)
    try:
        with ball_precision():
            f, g = found.all_of(*(substitute(e, put) for e in (left, right)))
            if found.scale.waves or not _told("O", f, g, found):
                return None
            return _near(f, g, found) if found.expansions.leading(f) is not None else None
    except _FAILS:
        return None


def is_unbounded(left: Expr, right: Expr, name: str, point: Expr | None, side: int) -> bool:
    """Return whether |left/right| -> oo beside a point, or beyond large values, is shown."""
    if not elementary(left, right):
        return False
    t = symbol(T)
    put = {name: side / t if point is None else point + side * t}
    found = Rewritten(T)
    try:
        with ball_precision():
            f, g = found.all_of(*(substitute(e, put) for e in (left, right)))
            first = found.expansions.leading(f)
            if found.scale.waves or first is None:
                return False
            return found.expansions.leading(g) is not None and bool(_told("o", g, f, found))
    except _FAILS:
        return False


def sharp_constant(left: Expr, right: Expr, upto: fmpq, shorter: int = SHORTER) -> Supremum | None:
    """The supremum of |left/right| on a range 0 < t ≤ r, if left = O(right) is shown.

    Args:
        upto: the longest range.
        shorter: how often it may be halved.
    """
    found = Rewritten(T)
    try:
        with ball_precision():
            f, g = found.all_of(left, right)
            if found.scale.waves or not _told("O", f, g, found):
                return None
            order = _order_at_end(g, found)
            if found.expansions.leading(f) is None:
                return None
            return supremum(left, right, order, _near(f, g, found), upto, shorter)
    except _FAILS:
        return None


def _leading_terms(
    f: Expr, g: Expr, found: Rewritten, shown: tuple[Expr, Expr]
) -> tuple[Expr | None, Expr | None]:
    """Those of f/g and of f."""
    scale = found.scale
    first, second = map(found.expansions.leading, (f, g))
    if first is None or second is None or scale.waves:
        return None, None
    with suppress(*_FAILS):
        powers = scale.times(first.powers, second.powers, -1)
        ratio = Leading(quotient(first.coefficient, second.coefficient), powers)
        return scale.written(ratio, *shown), scale.written(first, *shown)
    return None, None


def sign_towards(e: Expr, name: str, point: Expr | None, side: int) -> tuple[int, fmpq] | None:
    """Return the sign of ``e`` on a one-sided neighbourhood of a point.

    Args:
        point: where; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.

    Returns:
        The sign (0 where ``e`` vanishes identically) and r: it holds for 0 < |x − point| ≤ r, or
        for |x| ≥ 1/r; None where growth does not settle it.
    """
    t = symbol(T)
    return sign_near(substitute(e, {name: side / t if point is None else point + side * t}))


def leading_sign(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> int | None:
    """Return the sign of ``e`` near the end of a path for fixed parameters, or None."""
    t = symbol(T)
    along = substitute(e, {name: side / t if point is None else point + side * t})
    found = Rewritten(T, given)
    try:
        with ball_precision():
            (f,) = found.all_of(along)
            first = found.expansions.leading(f)
            return 0 if first is None else found.scale.sign(first.coefficient)
    except _FAILS:
        return None


def leading_term(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> Leading | None:
    """Return the leading term of ``e`` near the end of a path in the small parameter ``T``.

    None for a function that vanishes, oscillates or has no such expansion.
    """
    t = symbol(T)
    along = substitute(e, {name: side / t if point is None else point + side * t})
    found = Rewritten(T, given)
    try:
        with ball_precision():
            (f,) = found.all_of(along)
            return None if found.scale.waves else found.expansions.leading(f)
    except _FAILS:
        return None


def written_term(
    e: Expr, name: str, point: Expr | None, side: int, given: Given
) -> tuple[Expr, Expr] | None:
    """Return the leading term of ``e`` in its variable, and the same without its coefficient.

    None for a function that vanishes, oscillates or has no such expansion.
    """
    t, x = symbol(T), symbol(name)
    along = substitute(e, {name: side / t if point is None else point + side * t})
    found = Rewritten(T, given)
    small = 1 / (side * x) if point is None else side * (x - point)
    large = side * x if point is None else 1 / small
    try:
        with ball_precision():
            (f,) = found.all_of(along)
            first = None if found.scale.waves else found.expansions.leading(f)
            if first is None:
                return None
            found.scale.sign(first.coefficient)
            whole = found.scale.written(first, small, large)
            return whole, found.scale.written(Leading(ONE, first.powers), small, large)
    except _FAILS:
        return None


def sign_near(e: Expr) -> tuple[int, fmpq] | None:
    """The sign of ``e`` for 0 < t ≤ r, and r."""
    found = Rewritten(T)
    with ball_precision():
        try:
            (f,) = found.all_of(e)
            first = found.expansions.leading(f)
            sign = 0 if first is None else found.scale.sign(first.coefficient)
        except _FAILS:
            return None
        for expansions, reach in _ranges(found, fmpq(1)):
            with suppress(*_FAILS):
                if first is None or expansions.enclosure(f).low > 0:
                    return sign, reach
    return None


def _told(kind: str, f: Expr, g: Expr, found: Rewritten) -> bool | None:
    """As :func:`_truth`; None also where a sign on the way is not found."""
    try:
        return _truth(kind, f, g, found)
    except _FAILS:
        return None


def _truth(kind: str, f: Expr, g: Expr, found: Rewritten) -> bool | None:
    """Whether the statement holds as t → 0; None where waves leave that open."""
    scale, leading = found.scale, found.expansions.leading
    first, second = leading(f), leading(g)
    if kind == "~":
        phases = first and second and scale.phases(first.coefficient + second.coefficient)
        if first is None or second is None or phases:
            return _truth("o", f - g, g, found)
        same = scale.compare(first.powers, second.powers) == 0
        return same and scale.sign(first.coefficient - second.coefficient) == 0
    if first is None:
        return True
    if second is None:  # it fails if the left side vanishes at no phase
        with suppress(UnresolvedError):
            return False if scale.sign(first.coefficient) else None
        return None
    growth = scale.compare(first.powers, second.powers)
    if not scale.ball(first.coefficient).is_finite():
        return None
    try:
        scale.sign(second.coefficient)
        if growth < 0 or (growth == 0 and kind == "O"):
            return True
        scale.sign(first.coefficient)
    except UnresolvedError:
        return None
    return False


def _reduced(
    kind: str, f: Expr, g: Expr, found: Rewritten, ratio: Expr
) -> Iterator[tuple[str, Expr, Expr, Expr, bool]]:
    """The statement of numerator and denominator of f/g, which have no zero in common, or of f²/g².

    Given are they, the ratio, and whether it is squared. Where nothing oscillates there is none.
    """
    if not found.scale.phases(f + g) or g == ZERO:
        return
    for squared in (False, True) if kind in ("O", "o") else (False,):
        if squared:
            yield kind, raised(f, fmpq(2)), raised(g, fmpq(2)), ratio**2, True
        above, below = _polynomials_in_waves(f**2 / g**2 if squared else f / g, found)
        if any(found.scale.elements(node) for e in (above, below) for node in _nodes(e, "tan")):
            continue  # it is expanded as sine and cosine alone
        yield kind, above, below, ratio**2 if squared else ratio, squared


def _polynomials_in_waves(e: Expr, found: Rewritten) -> tuple[Expr, Expr]:
    """Numerator and denominator of the normal form, as polynomials in sines and cosines.

    In the normal form sine and cosine of an angle are rational functions of the tangent of its
    half. In lowest terms as a function of s/c, a numerator and a denominator are homogeneous in s
    and c, so that they have no zero in common; (s² + c²)^k is 1.
    """
    scale = found.scale
    given = scale.given & Given(tuple((symbol(w), ">", ZERO) for w in scale.elements(e)))
    form = normal_form(e, given)
    tangents = [node for node in _nodes(form, "tan") if scale.phases(node)]
    pairs = {node: (symbol(f"[s{k}]"), symbol(f"[c{k}]")) for k, node in enumerate(tangents)}
    ratio = in_lowest_terms(replaced(form, {node: s / c for node, (s, c) in pairs.items()}))
    back: dict[str, Expr] = {}
    for node, (s, c) in pairs.items():
        back |= {str(s): apply("sin", node.args[0]), str(c): apply("cos", node.args[0])}
    above, below = (substitute(part, back) for part in _over(ratio))
    whole = normal_form(below, given)
    return above, below if scale.phases(whole) else whole


def _nodes(e: Expr, op: str) -> list[Expr]:
    """The nodes of an operation, each once."""
    if e.op in LEAVES:
        return []
    inner = [node for arg in e.args for node in _nodes(arg, op)]
    return list(dict.fromkeys([*([e] if e.op == op else []), *inner]))


def _fails_at_a_phase(kind: str, f: Expr, g: Expr, found: Rewritten) -> bool:
    """Whether the statement fails on a sequence on which one of the phases is known.

    The others are not: two need not be what one likes at once. Both sides are multiplied by their
    denominators: what is bounded beside a point is so there.
    """
    (f, above), (g, below) = _over(f), _over(g)
    f, g = multiply(f, below), multiply(g, above)
    for name, phase in product(found.scale.phases(f + g), _phases(found.turns)):
        x, y = (substitute(e, {name: phase}) for e in (f, g))
        with suppress(*_FAILS):
            if _truth(kind, x, y, found) is False:
                return True
    return False


def _phases(turns: int) -> list[Expr]:
    """Values of a phase that are tried: 24ths of a turn of each wave, and 1."""
    parts = [number(fmpq(k, 12 * turns)) * PI for k in range(min(24 * turns, MOST_PHASES))]
    return [*(part / turns for part in PHASES), *parts]


def _over(e: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator of a product."""
    parts = factors_in(e)
    negative = [
        x for x in parts if x.op == "^" and x.args[1].op == "number" and x.args[1].args[0] < 0
    ]
    denominators = (power(x.args[0], -x.args[1]) for x in negative)
    return multiply(*(x for x in parts if x not in negative)), multiply(*denominators)


def _on_a_range(
    kind: str,
    f: Expr,
    g: Expr,
    found: Rewritten,
    upto: fmpq,
    ratio: Expr,
    leading: tuple[Expr | None, Expr | None],
) -> Judgement:
    """What holds as t → 0, with a range, and for O a constant."""
    vanishes = found.expansions.leading(f) is None
    for expansions, reach in _ranges(found, upto):
        try:
            if vanishes:
                expansions.size(f)
            sides = [expansions.enclosure(e) for e in ([g] if vanishes else [f, g])]
            if not (sides[-1].low > 0 and sides[0].high.is_finite()):
                continue
            constant = None
            if kind == "O":
                constant = arb(0) if vanishes else _largest(f, g, found, expansions)
        except _FAILS:
            continue
        if constant is not None and not vanishes:
            with suppress(ZeroDivisionError, OverflowError):
                constant, reach = _supremum(ratio, f, g, found, constant, reach, upto)
        return Judgement(Verdict.ENCLOSED, *leading, constant, reach, found.real)
    return _OPEN


def _largest(f: Expr, g: Expr, found: Rewritten, expansions: Expansions) -> arb:
    """A ball around the supremum of |f/g| on the range, where f = O(g)."""
    above, below = expansions.enclosure(f), expansions.enclosure(g)
    powers = found.scale.times(above.powers, below.powers, -1)
    low = above.k / below.k if not powers else arb(0)
    high = above.high / below.low * expansions.largest(powers)
    return arb(low.abs_lower()).union(arb(high.upper()))


def _supremum(
    ratio: Expr, f: Expr, g: Expr, found: Rewritten, whole: arb, reach: fmpq, upto: fmpq
) -> tuple[arb, fmpq]:
    """A narrower ball around the supremum of |f/g|, and a longer range, by balls off the end."""
    low, high, beyond = whole.lower(), whole.upper(), arb(0)
    for _ in range(OCTAVES):
        further = _octave(ratio, reach) if 2 * reach <= upto else None
        if further is None:
            break
        low, beyond, reach = low.max(further[0]), beyond.max(further[1]), 2 * reach
    high = high.max(beyond)
    near = reach
    for _ in range(OCTAVES):
        near = near / 2
        octave = _octave(ratio, near)
        if octave is None or high < low * arb("1.01"):
            break
        low, beyond = low.max(octave[0]), beyond.max(octave[1])
        with suppress(*_FAILS):
            beside = _largest(f, g, found, Expansions(found.scale, near)).upper()
            high = high.min(beyond.max(beside))
            if beside <= beyond:  # and so is it nearer to the end
                break
    return low.union(high), reach


def _octave(ratio: Expr, start: fmpq) -> tuple[arb, arb] | None:
    """Bounds of the supremum of |ratio| from ``start`` to twice that; None where there is none."""
    low, high = arb(0), arb(0)
    for n in range(PIECES):
        first, last = (arb(start + start * fmpq(k, PIECES)) for k in (n, n + 1))
        x = first.union(last)
        values = evaluate(ratio, {T: x}), taylor_value(ratio, T, x)
        bounds = [abs(value).upper() for value in values if value.is_finite()]
        if not bounds:
            return None
        low = low.max(abs(evaluate(ratio, {T: last})).lower())
        high = high.max(min(bounds))
    return low, high


def _ranges(found: Rewritten, upto: fmpq) -> Iterator[tuple[Expansions, fmpq]]:
    """Shorter and shorter ranges on which the rewritten functions stand for those given."""
    for n in HALVINGS:
        reach = fmpq(1, 2**n)
        if reach > upto:
            continue
        expansions = Expansions(found.scale, reach)
        try:
            if all(expansions.enclosure(u).low > 0 for u in found.signed):
                yield expansions, reach
        except _FAILS:
            continue
