"""Order claims that no expansion settles as they stand: the ratio of their sides, rewritten.

All of it speaks of t → 0+. Where f = q g, f = O(g) says that q is bounded, f = o(g) that q → 0, and
f ~ g that q → 1. That is asked of other forms, until an expansion settles one:

- f, or f − g, is identically zero;
- hyperbolic functions are written in exponentials, and like factors of q and like terms are joined;
- f² ~ g² where q > 0, and t = kt′, by which a root such as √2 may become a rational number;
- L = log |q| tends to −∞, or is bounded above: for exponentials of exponentials;
- sin u, where u → ±∞, takes the values 0 and ±1 again and again;
- t = exp(−y), so that log t is −y: for logarithms of logarithms;
- f − g = o(g), which is f ~ g.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from flint import arb, fmpq

from tresym.reals.balls.ends import sign_beside
from tresym.reals.balls.order import Judgement, Order, judge_order
from tresym.reals.balls.run import formula
from tresym.reals.decisions.identity import decide as decide_identity
from tresym.reals.language import products
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    E,
    Expr,
    add,
    apply,
    multiply,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import positive
from tresym.reals.places.values import evaluate
from tresym.reals.signs.inside import is_zero, jumps
from tresym.reals.verdict import Verdict

SCALES = (fmpq(2), fmpq(1, 2), fmpq(3))
MAX_LEVELS = 3
SHORTEST = fmpq(1, 1000)
"""The shortest range of 1/log(1/t) that is written in t."""
SAMPLES = 60
MAX_TERMS = 6
RANGES = tuple(fmpq(1, 2**n) for n in (4, 8, 16, 32, 64, 128))

_OPEN = Judgement(Verdict.UNDECIDED)


def factors(e: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """Bases and exponents whose product is ``e``."""
    found = products.factors(e, name)
    return found if _are_equal(e, multiply(*(b**x for b, x in found)), name) else [(e, ONE)]


def joined(e: Expr, name: str) -> Expr:
    """``e`` with like factors joined."""
    found = products.joined(e, name)
    return found if _are_equal(e, found, name) else e


def in_exponentials(e: Expr, name: str) -> Expr:
    """``e`` with exponentials for hyperbolic functions."""
    found = products.in_exponentials(e, name)
    return found if _are_equal(e, found, name) else e


def collected(e: Expr, name: str) -> Expr:
    """``e`` with like terms collected."""
    found = products.collected(e)
    return found if _are_equal(e, found, name) else e


def _are_equal(e: Expr, other: Expr, name: str) -> bool:
    """Whether the normal form shows it, at every t > 0 where both are defined."""
    given = positive(name)
    return e == other or (is_zero(e - other, given) and not jumps((e, other), given))


def judged(
    kind: str,
    left: Expr,
    right: Expr,
    name: str,
    upto: fmpq = fmpq(1),  # noqa: B008
    constant: fmpq | None = None,
) -> Judgement:
    """The order statement as it stands, for the parameter ``name`` up to ``upto``."""
    f, g = formula(left, name), formula(right, name)
    try:
        return judge_order(Order(kind, f, g, constant=constant, upto=upto))
    except (ZeroDivisionError, OverflowError, InputError):
        return _OPEN


def judged_by_ratio(kind: str, left: Expr, right: Expr, name: str, level: int = 0) -> Judgement:
    """The order statement by another form of its ratio; UNDECIDED where none settles it.

    Leading terms are not given: they would be those of other functions.
    """
    found = _identically(kind, left, right, name)
    if found.verdict is Verdict.UNDECIDED:
        found = _by_ratio(kind, left, right, name, level)
    if found.verdict is Verdict.REFUTED and not _may_cancel(left, right, name):
        return _OPEN  # 0 = O(0), whatever the ratio of what is left
    return found


def _by_ratio(kind: str, left: Expr, right: Expr, name: str, level: int) -> Judgement:
    for form, reach in _forms(kind, left, right, name):
        found = judged(kind, *form, name)
        if found.verdict is not Verdict.UNDECIDED:
            return _shortened(found, reach)
    ratio = joined(left / right, name)
    for method in (_by_larger, _by_logarithm, _by_oscillation, _by_level):
        found = method(kind, ratio, name, level)
        if found.verdict is not Verdict.UNDECIDED:
            return found
    if kind != "~" or level:
        return _OPEN
    difference = in_exponentials(collected(left - right, name), name)
    found = judged("o", difference, right, name)
    if found.verdict is Verdict.UNDECIDED:
        found = judged_by_ratio("o", difference, right, name, level + 1)
    return replace(found, ratio=None, true_order=None)


def _may_cancel(left: Expr, right: Expr, name: str) -> bool:
    """Whether no factor that the two sides share may be zero near t = 0."""
    for f, g in ((left, right), (in_exponentials(left, name), in_exponentials(right, name))):
        for base in {b for b, _ in factors(f, name)} & {b for b, _ in factors(g, name)}:
            if not _is_nonzero(base, name):
                return False
    return True


def _is_nonzero(e: Expr, name: str) -> bool:
    """Whether ``e`` is shown to have no zero near t = 0."""
    beside = sign_beside(e, name, ZERO, 1)
    if beside is not None:
        return beside[0] != 0
    v = _inside(e)
    return v is not None and (_tends_to_infinity(v, name) or _tends_to_infinity(1 / v, name))


def _refuted(at: fmpq) -> Judgement:
    return Judgement(Verdict.REFUTED, points={"t": at})


def _shortened(found: Judgement, reach: fmpq) -> Judgement:
    """What was found on a range, on a part of it, without its leading terms."""
    upto = None if found.upto is None else found.upto * reach
    points = {key: value * reach for key, value in found.points.items()}
    return replace(found, ratio=None, true_order=None, upto=upto, points=points)


def _identically(kind: str, left: Expr, right: Expr, name: str) -> Judgement:
    """O and o where the left side is zero, ~ where both are the same.

    That they are defined on the whole of a range is shown by their expansions.
    """
    other = right if kind == "~" else ZERO
    if decide_identity(left, other, positive(name)).verdict is not Verdict.PROVED:
        return _OPEN
    shown = judged("O", left, right if kind == "~" else ONE, name), judged("O", right, right, name)
    if any(found.verdict is not Verdict.ENCLOSED for found in shown):
        return _OPEN
    reach = min(found.upto for found in shown if found.upto is not None)
    return Judgement(Verdict.ENCLOSED, constant=arb(0) if kind == "O" else None, upto=reach)


def _forms(
    kind: str, left: Expr, right: Expr, name: str
) -> Iterator[tuple[tuple[Expr, Expr], fmpq]]:
    """Other forms of the same claim, each with the part of its range on which it is the same."""
    whole = fmpq(1)
    exponential = in_exponentials(left, name), in_exponentials(right, name)
    if exponential != (left, right):
        yield exponential, whole
    ratio = joined(exponential[0] / exponential[1], name)
    yield (ratio, ONE), whole
    if kind != "~":
        return
    beside = sign_beside(ratio, name, ZERO, 1)
    if beside is not None and beside[0] > 0:
        yield (joined(left**2, name), joined(right**2, name)), min(beside[1], whole)
    for scale in SCALES:
        longer = {name: scale * symbol(name)}
        yield (substitute(left, longer), substitute(right, longer)), min(scale, whole)


def _by_larger(kind: str, ratio: Expr, name: str, _: int) -> Judgement:
    """q → 0 where it is bounded with |v| for log |v|, v → ±∞, or with 1/|v|, v → 0."""
    parts = dict(factors(ratio, name)) if kind == "o" else {}
    for base, exponent in parts.items():
        v = _nested(base)
        if v is None or exponent.op != "number":
            continue
        for side, claim in ((1, (ONE, v)), (-1, (v, ONE))):
            if exponent.args[0] > 0 and judged("o", *claim, name).verdict is Verdict.ENCLOSED:
                larger = power(apply("abs", v), side * exponent)
                rest = multiply(*(b**x for b, x in parts.items() if b != base))
                found = judged("O", joined(rest * larger, name), ONE, name)
                if found.verdict is Verdict.ENCLOSED:
                    return Judgement(Verdict.ENCLOSED, upto=found.upto)
    return _OPEN


def _inside(e: Expr) -> Expr | None:
    """v of log v or log |v|."""
    if e.op != "log":
        return None
    return e.args[0].args[0] if e.args[0].op == "abs" else e.args[0]


def _nested(e: Expr) -> Expr | None:
    """v of log |v| with a logarithm in v."""
    v = _inside(e)
    return v if v is not None and any(_inside(part) for part in _walked(v)) else None


def _walked(e: Expr) -> Iterator[Expr]:
    """``e`` and all its parts."""
    yield e
    if e.op not in ("number", "symbol"):
        for part in e.args:
            yield from _walked(part)


# -- logarithms ---------------------------------------------------------------------------------


def _by_logarithm(kind: str, ratio: Expr, name: str, level: int) -> Judgement:
    """By the limit of log |ratio|."""
    size = collected(add(*(_logarithm(*factor) for factor in factors(ratio, name))), name)
    if judged("o", ONE, size, name).verdict is Verdict.ENCLOSED:
        return _by_sign(kind, size, fmpq(1), name)
    bounded = judged("O", size, ONE, name)
    if bounded.constant is not None and bounded.upto is not None and kind != "~":
        if kind == "o":
            return _refuted(bounded.upto)
        with ball_precision():
            constant = arb(0).union(bounded.constant.exp().upper())
        return Judgement(Verdict.ENCLOSED, constant=constant, upto=bounded.upto)
    terms = size.args if size.op == "+" else ()
    for term in terms if len(terms) <= MAX_TERMS else ():
        if _tends_to_infinity(term, name):
            others = [other for other in terms if other is not term]
            for upto in RANGES:
                if all(_is_small(other, term, name, upto) for other in others):
                    return _by_sign(kind, term, upto, name)
    return _OPEN


def _by_sign(kind: str, size: Expr, upto: fmpq, name: str) -> Judgement:
    """By the sign of ``size`` → ±∞, which up to ``upto`` is the sign of log |ratio|."""
    beside = sign_beside(size, name, ZERO, 1)
    if beside is None:
        return _OPEN
    side, reach = beside[0], min(beside[1], upto)
    if side > 0 or kind == "~":
        return _refuted(reach)
    constant = arb(0).union(arb(1)) if kind == "O" else None
    return Judgement(Verdict.ENCLOSED, constant=constant, upto=reach)


def _tends_to_infinity(e: Expr, name: str) -> bool:
    return judged("o", ONE, e, name).verdict is Verdict.ENCLOSED


def _is_small(f: Expr, g: Expr, name: str, upto: fmpq) -> bool:
    """Whether |f| ≤ |g|/8 for 0 < t ≤ upto: as it stands, in 1/log(1/t), or by way of log t."""
    between, eighth, one = apply("log", symbol(name)), fmpq(1, 8), fmpq(1)
    if _is_below(f, g, eighth, name, upto):
        return True
    if _is_below(f, between, eighth, name, upto) and _is_below(between, g, one, name, upto):
        return True
    parts = dict(factors(f, name))
    for base, exponent in parts.items():
        v = _nested(base)
        if v is not None and exponent.op == "number" and exponent.args[0] > 0:
            # |log |v|| < |v| where |v| ≥ 1
            larger = joined(f * (v / base) ** exponent, name)
            return _is_below(ONE, v, one, name, upto) and _is_small(larger, g, name, upto)
    return False


def _is_below(f: Expr, g: Expr, constant: fmpq, name: str, upto: fmpq) -> bool:
    """Whether |f| ≤ constant |g| for 0 < t ≤ upto."""
    if _at_most(f, g, constant, name, upto):
        return True
    raised = one_level_up(joined(f / g, name), name)
    # log 2 > 1/2: t ≤ 2^(−n) has 1/log(1/t) ≤ 2/n
    own = fmpq(2, upto.q.bit_length() - 1)
    return raised is not None and _at_most(raised, ONE, constant, name, own)


def _at_most(f: Expr, g: Expr, constant: fmpq, name: str, upto: fmpq) -> bool:
    return judged("<=", f, g, name, upto, constant).verdict is Verdict.ENCLOSED


def _logarithm(base: Expr, exponent: Expr) -> Expr:
    """log |base**exponent|."""
    if base == E:
        return exponent
    if base.op == "number" and abs(base.args[0]) == 1:
        return ZERO
    return exponent * apply("log", base if base.op == "symbol" else apply("abs", base))


def _by_level(kind: str, ratio: Expr, name: str, level: int) -> Judgement:
    """With t = exp(−1/s), s → 0+."""
    raised = one_level_up(ratio, name) if level < MAX_LEVELS else None
    if raised is None:
        return _OPEN
    found = judged(kind, raised, ONE, name)
    if found.verdict is Verdict.UNDECIDED:
        found = judged_by_ratio(kind, raised, ONE, name, level + 1)
    if found.verdict is Verdict.REFUTED:
        return _refuted(fmpq(1, 2**16))  # any point will do that shows both sides to be real
    if found.upto is None or found.upto < SHORTEST:
        return _OPEN
    below = fmpq(1, 2 ** (1 + int(3 / (2 * found.upto))))  # 2^(−3/2) < exp(−1)
    return replace(found, ratio=None, true_order=None, upto=below)


def one_level_up(e: Expr, name: str) -> Expr | None:
    """``e`` at t = exp(−1/s), in s; None where it has no logarithm of a power of t."""
    t, y = symbol(name), 1 / symbol(name)
    found = False

    def walk(node: Expr) -> Expr:
        nonlocal found
        if name not in symbols(node):
            return node
        if node == t:
            return apply("exp", -y)
        inside = _inside(node)
        if inside is not None:
            parts = factors(inside, name)
            if all(
                name not in symbols(x) and (base == t or not symbols(base)) for base, x in parts
            ):
                found = True
                terms = (-x * y if base == t else _logarithm(base, x) for base, x in parts)
                return collected(add(*terms), name)
        return rebuild(node, tuple(walk(arg) for arg in node.args))

    raised = joined(walk(e), name)
    return raised if found else None


# -- oscillation --------------------------------------------------------------------------------


def _by_oscillation(kind: str, ratio: Expr, name: str, _: int) -> Judgement:
    """A refutation where the ratio is h sin u or h cos u with u → ±∞, or a power of the wave.

    Then u takes every large value: h need only be bounded below for o, tend to ∞ for O.
    """
    parts = factors(ratio, name)
    waves = [b for b, x in parts if b.op in ("sin", "cos") and x.op == "number" and x.args[0] > 0]
    for wave in waves:
        if judged("o", ONE, wave.args[0], name).verdict is not Verdict.ENCLOSED:
            continue
        rest = joined(multiply(*(base**x for base, x in parts if base != wave)), name)
        found = judged("o" if kind == "O" else "O", ONE, rest, name)
        if found.upto is not None:
            for k in range(1, SAMPLES):
                at = found.upto * fmpq(k, SAMPLES)
                with ball_precision():
                    if abs(evaluate(wave, {name: arb(at)})) > arb("0.5"):
                        return _refuted(at)
    return _OPEN
