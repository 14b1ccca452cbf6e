"""Decide identities between real expressions.

What a claim means: ``left`` and ``right`` are equal at every real point of ``given`` where both
are defined. More exactly: at every point that is a limit of interior points of that set, for the
normal form is silent on isolated points of the domain of the two sides; of the conditions it is
shown that they have none. This is not the convention of complex principal branches:
``log(x**2) = 2*log(x)`` is PROVED, since negative x are outside the common domain, and
``sqrt(x**2) = x`` is REFUTED.

Nothing is proved vacuously: a point inside ``given`` must be found at which both sides are shown,
in balls, to be defined.

1. Balls at a few exact rational points: disjoint values refute.
2. The exact normal form of :mod:`tresym.reals.normal.field`: a difference that is zero proves.
3. Balls again, at many points and 700 bits.
4. What the normal form leaves is tried by derivatives, see
   :mod:`tresym.reals.normal.locally_constant`.
5. Where sign and atan2 jump, which a proof at almost all points leaves out, the claim with the
   value substituted is decided by itself, see :mod:`tresym.reals.signs.discontinuities`. Where the
   conditions may have points that are not limits of interior points, the proof must do without
   those with equality, see :mod:`tresym.reals.signs.closure`.
6. An inverse function is removed where the other side is in its range, see
   :mod:`tresym.reals.decisions.inverse_branches`.
7. Where the normal form depends on the sign of a polynomial in the symbols, it is proved for either
   sign. Its zeros are limits of other points, and functions are continuous where they are defined.

No claim of the ledger needs 4, the algebraic constants of :mod:`tresym.reals.normal.constants`, the
values of 5 or the cases of 7, and its judge does without.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from flint import arb, fmpq

from tresym.reals.decisions.equal_by_limit import equal_by_limit
from tresym.reals.decisions.inverse_branches import without_inverse
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, undefined_parts, values_or_broken
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import ZERO, Expr, apply, number, symbols
from tresym.reals.normal.at_point import equal_at
from tresym.reals.normal.constants import settled, vanishes
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.locally_constant import equal_by_derivative
from tresym.reals.normal.polynomials import as_expression, terms_in_symbols
from tresym.reals.normal.ring import Fraction, UndefinedError
from tresym.reals.normal.to_expression import written
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.closure import ONLY_INSIDE, is_regular
from tresym.reals.signs.definedness import at_domain_ends
from tresym.reals.signs.discontinuities import cases_at_jumps
from tresym.reals.signs.interior import jumps
from tresym.reals.verdict import Cause, Verdict

Points = Callable[[Given], Iterable[Mapping[str, fmpq]]]
Further = Callable[..., tuple[str | None, Fraction, Expr | None]]
"""A proof of what the normal form leaves, or None; that settled; and whose sign may decide it."""

FIRST_POINTS = 2
SIGN_POINTS = 6
BLAMED_POINTS, MAX_SHOWN = 40, 60
LATER_LOOKS = ((128, 60), (700, 20), (4000, 2))
SEARCH_POINTS = 400
MAX_CASES = 2
SIZES = (8, 16, 32, 64, 128)
JUMP = (
    "undecided at points where sign or atan2 jumps; it is proved "
    "elsewhere, and a condition that excludes those points helps"
)
NOWHERE = "no real point was found where both sides are defined"


@dataclass(frozen=True)
class Decision:
    """A verdict with its reason.

    Attributes:
        verdict: PROVED, REFUTED or UNDECIDED.
        why: one sentence: the normal form and base points, or what stopped the procedure.
        witness: the exact point of a refutation.
        values: both sides there, as disjoint balls.
        at: of what is proved, a point at which both sides are defined.
        cause: what stopped the procedure, if that is none of the methods.
    """

    verdict: Verdict
    why: str
    witness: Mapping[str, fmpq] | None = None
    values: tuple[arb, arb] | None = None
    at: Mapping[str, fmpq] | None = None
    cause: Cause | None = None


def decide(
    left: Expr,
    right: Expr,
    given: Given = Given(),  # noqa: B008 - frozen
    theories: frozenset[str] = ALL_THEORIES,
    stated: Given | None = None,
) -> Decision:
    """Decide whether ``left = right`` at every real point of ``given`` where both are defined.

    Args:
        left, right: elementary expressions.
        given: inequalities that hold at the points in question.
        stated: the conditions that the user wrote, if ``given`` contains further ones.
        theories: what the proof may use beyond algebra; a function of another theory is a mere
            name whose equal arguments give equal values. Refutation is not limited by it.
    """
    if not elementary(left, right):
        return Decision(
            Verdict.UNDECIDED, "a sum, an integral or a limit in the claim could not be evaluated"
        )
    decision = _almost_everywhere(left, right, given, theories, _by_constants)
    if decision.verdict is Verdict.UNDECIDED and (moved := at_domain_ends((left, right), given)):
        (left, right), inside = moved
        decision = decide(left, right, inside, theories, given if stated is None else stated)
        return replace(decision, why=f"rewritten as {left} = {right}: {decision.why}")
    if decision.verdict is not Verdict.PROVED:
        return decision
    unproved = _at_jumps((left, right), given, theories)
    stated = given if stated is None else stated
    return unproved or _at_limits(left, right, given, theories, stated, _by_constants) or decision


def decide_continuous(
    left: Expr,
    right: Expr,
    given: Given = Given(),  # noqa: B008 - frozen
    theories: frozenset[str] = ALL_THEORIES,
) -> Decision:
    """Decide as :func:`decide`, by the normal form alone; UNDECIDED if a side may jump."""
    decision = _almost_everywhere(left, right, given, theories, None)
    if decision.verdict is not Verdict.PROVED:
        return decision
    if left != right and jumps((left, right), given):
        return Decision(Verdict.UNDECIDED, JUMP)
    return _at_limits(left, right, given, theories, given, None) or decision


def _almost_everywhere(
    left: Expr, right: Expr, given: Given, theories: frozenset[str], further: Further | None
) -> Decision:
    """The answer but for points at which a side jumps, or that are no limits from inside."""
    names = sorted(symbols(left) | symbols(right))
    sides = (left, right)

    def look(
        count: int, bits: int = WORKING, where: Given = given
    ) -> Iterator[tuple[dict[str, fmpq], tuple[arb, arb]]]:
        return sampled_values(left, right, where, names, count, bits)

    inside = look(SIGN_POINTS)
    defined: list[dict[str, fmpq]] = []
    for point, values in islice(inside, FIRST_POINTS):
        if not values[0].overlaps(values[1]):
            return _refutation(point, values)
        defined.append(point)
    if not defined:
        return Decision(Verdict.UNDECIDED, no_point(sides, given), cause=Cause.NO_POINT)

    def points(where: Given) -> Iterator[dict[str, fmpq]]:
        if where is not given:
            yield from (point for point, _ in look(SIGN_POINTS, where=where))
            return
        for n in range(
            SIGN_POINTS
        ):  # those that were found already, and more as they are asked for
            if n == len(defined):
                defined.extend(point for point, _ in islice(inside, 1))
            yield from defined[n : n + 1]

    proof, obstacle, in_doubt = _prove(sides, given, theories, points, further)
    if proof is None:
        looks = [(bits, count, given) for bits, count in LATER_LOOKS]
        for e in () if in_doubt is None else (in_doubt, -in_doubt):
            looks.append((*LATER_LOOKS[1], given & Given(((e, ">", ZERO),))))
        for bits, count, where in looks:
            for point, values in look(count, bits, where):
                if not values[0].overlaps(values[1]):
                    return _refutation(point, values)
        proof = _prove_by_branch(sides, given, theories, points, further)
    if proof is None:
        return Decision(Verdict.UNDECIDED, obstacle)
    at = defined[0]
    return Decision(Verdict.PROVED, with_point(f"{proof}; both sides are defined", at), at=at)


def _at_limits(
    left: Expr,
    right: Expr,
    given: Given,
    theories: frozenset[str],
    stated: Given,
    further: Further | None,
) -> Decision | None:
    """Return UNDECIDED if the proof may miss isolated points of the conditions, else None."""
    if left == right or is_regular(stated):
        return None
    names, fewer = sorted(symbols(left) | symbols(right)), _open(given)

    def points(where: Given) -> Iterator[dict[str, fmpq]]:
        samples = sampled_values(left, right, where, names, SIGN_POINTS)
        yield from (point for point, _ in samples)

    if is_regular(fewer) and _prove((left, right), fewer, theories, points, further)[0]:
        return None
    return Decision(Verdict.UNDECIDED, ONLY_INSIDE)


def _open(given: Given) -> Given:
    """Return the conditions without those with >= or with roots that do not bound a variable."""
    beyond = {c for c in given.beyond_box if c.relation == ">=" or needs((c.expression,))}
    pairs = zip(given.comparisons, given.conditions, strict=True)
    return Given(tuple(comparison for comparison, c in pairs if c not in beyond))


def _at_jumps(sides: tuple[Expr, ...], given: Given, theories: frozenset[str]) -> Decision | None:
    """Return a failure, or UNDECIDED, at jumps, which the proof leaves out; None if it holds."""
    left, right = sides
    if left == right:
        return None
    for case in cases_at_jumps(sides, given):
        if case is None:
            return Decision(Verdict.UNDECIDED, JUMP)
        answer = decide(case.of(left), case.of(right), case.given, theories)
        if answer.verdict is Verdict.PROVED:
            continue
        why = f"it is proved except {case}; there, {answer.why}"
        if not case.values:  # the variables are arbitrary in that claim
            why = f"it is proved except {case}, and could not be decided there"
        point = case.point(answer.witness)
        if point is not None and answer.values is not None:
            return _refutation(point, answer.values)
        return Decision(Verdict.UNDECIDED, why)
    return None


def sampled_values(
    left: Expr,
    right: Expr,
    given: Given,
    names: list[str],
    count: int,
    bits: int = WORKING,
) -> Iterator[tuple[dict[str, fmpq], tuple[arb, arb]]]:
    """Yield at most ``count`` points where both sides are defined, with their values in balls."""
    trees: tuple[Expr, ...] = (left, right)
    found = 0
    for point in given.points(names, SEARCH_POINTS):
        with ball_precision(bits):
            values = values_or_broken(trees, point)
        if isinstance(values, Expr):
            trees = (values, left, right)
        else:
            yield point, (values[-2], values[-1])
            found += 1
        if found == count or not point:
            return


def _refutation(point: dict[str, fmpq], values: tuple[arb, arb]) -> Decision:
    why = with_point("the two sides differ", point)
    return Decision(Verdict.REFUTED, why, point, values)


def shown(point: Mapping[str, Any], text: Callable[[Any], str] = fraction_text) -> str:
    """Return the coordinates of a point as ``x = 1/2, y = 3``.

    Args:
        point: the value of each variable.
        text: writes a value; by default as a fraction.
    """
    return ", ".join(f"{name} = {text(value)}" for name, value in point.items())


def with_point(
    sentence: str, point: Mapping[str, Any], text: Callable[[Any], str] = fraction_text
) -> str:
    """Return the sentence followed by the point, and alone if a claim has no variables.

    Example:
        >>> with_point("it fails", {"x": fmpq(1, 2)})
        'it fails at x = 1/2'
    """
    return f"{sentence} at {shown(point, text)}" if point else sentence


def no_point(parts: tuple[Expr, ...], given: Given) -> str:
    """Return the reason of UNDECIDED if no point is found where all ``parts`` are defined."""
    names = sorted(frozenset().union(*map(symbols, parts)))
    if not names:
        with ball_precision():
            for part in undefined_parts(parts, {}):
                if _is_undefined(part):
                    return f"{part} is undefined, so there is nothing to prove; check the claim"
        return (
            "a side could not be shown to be a real number, or is too large to be enclosed, so "
            "there may be nothing to prove"
        )
    if next(given.points(names, 1), None) is None:
        return (
            "no point was found that satisfies the conditions strictly, "
            "so there is nothing to prove; check the conditions"
        )
    missing: Counter[Expr] = Counter()
    with ball_precision():
        for point in given.points(names, BLAMED_POINTS):
            missing.update(undefined_parts(parts, point))
    ranked = sorted((-count, str(part)) for part, count in missing.items())
    blamed = " and ".join([text for _, text in ranked if len(text) <= MAX_SHOWN][:2])
    hint = "a condition that bounds the variables may help"
    if any(part.op == "log" for part in missing):
        hint += ", or log(abs(u)) for log(u)"
    return f"{NOWHERE}: {blamed or 'parts of them'} must be real; {hint}"


_POLES = {"tan": "cos", "sec": "cos", "cot": "sin", "csc": "sin"}
"""The function in the denominator of each."""


def _is_undefined(part: Expr) -> bool:
    """Return whether a constant expression is proved to be undefined."""
    inner = part.args[0]
    if part.op in _POLES:
        return equal_at(apply(_POLES[part.op], inner), ZERO, {})
    if part.op == "^" and evaluate(part.args[1], {}) < 0 and equal_at(inner, ZERO, {}):
        return True
    return part.op in ("log", "^") and bool(evaluate(inner, {}) < 0)


def _counted(field: Field) -> str:
    count = len(field.ring.generators)
    return f"{count} generator{'s' * (count != 1)}"


def _prove(
    sides: tuple[Expr, Expr],
    given: Given,
    theories: frozenset[str],
    points: Points,
    further: Further | None,
    depth: int = 0,
) -> tuple[str | None, str, Expr | None]:
    """Return the proof as a sentence or None, the obstacle, and the part whose sign is open."""
    left, right = sides
    if left == right:
        return "both sides are the same expression", "", None
    try:
        field, value = _difference(sides, given, theories, points)
    except (TooLargeError, UndefinedError) as error:
        return None, f"the exact normal form could not be computed: {error}", None
    if value.num.is_zero():
        return f"the difference has normal form 0 ({_counted(field)})", "", None
    proof = in_doubt = None
    if further is not None:
        proof, value, in_doubt = further(field, value, sides, given, theories)
        in_doubt = in_doubt if depth < MAX_CASES else None
    if in_doubt is not None:
        cases = [given & Given(((e, ">", ZERO),)) for e in (in_doubt, -in_doubt)]
        if all(_prove(sides, case, theories, points, further, depth + 1)[0] for case in cases):
            return f"it is proved in each case of the sign of {in_doubt}", "", None
    return proof, "" if proof else _obstacle(field, value), in_doubt


def _by_constants(
    field: Field,
    value: Fraction,
    sides: tuple[Expr, Expr],
    given: Given,
    theories: frozenset[str],
) -> tuple[str | None, Fraction, Expr | None]:
    """Return a proof by relations between constants or by derivatives, or None; and the rest."""
    proof = None
    with suppress(TooLargeError, UndefinedError):
        value = settled(field, value, functions=any(map(symbols, sides)))
        if vanishes(field.ring, value.num):
            why = (
                "the difference has normal form 0 after its constants are "
                f"simplified ({_counted(field)})"
            )
            return why, value, None
        proof = equal_by_derivative(*sides, given, theories, field.ring.size)
        proof = proof or equal_by_limit(*sides, given)
    return proof, value, None if proof else _sign_in_doubt(field, value)


def _prove_by_branch(
    sides: tuple[Expr, Expr],
    given: Given,
    theories: frozenset[str],
    points: Points,
    further: Further | None,
) -> str | None:
    """Return a proof of an equivalent equation without inverse functions, or None."""
    for pair in without_inverse(*sides, given, theories):
        if _prove(pair, given, theories, points, further, MAX_CASES)[0]:
            return (
                "on the range of the inverse function it is equivalent to "
                f"{pair[0]} = {pair[1]}, which is proved"
            )
    return None


def _difference(
    sides: tuple[Expr, Expr], given: Given, theories: frozenset[str], points: Points
) -> tuple[Field, Fraction]:
    """Return the normal form of the difference of the two sides, with its field."""
    fewest = _generator_count(sides)
    for size in (size for size in SIZES if size >= fewest):
        field = Field(given, theories, size, lambda: points(given))
        try:
            x, y = field.normal(*sides)
            return field, x - y
        except TooLargeError:
            if len(field.ring.generators) < size:
                raise
    raise TooLargeError("the expression has too many independent subexpressions")


def _generator_count(sides: tuple[Expr, ...]) -> int:
    """Estimate how many generators the normal forms need: the subexpressions not rational."""
    seen: set[Expr] = set()
    stack = list(sides)
    count = 0
    while stack:
        node = stack.pop()
        if node in seen or node.op == "number":
            continue
        seen.add(node)
        rational = node.op == "^" and node.args[1].op == "number" and node.args[1].args[0].q == 1
        count += not rational and node.op not in ("+", "*")
        stack.extend(arg for arg in node.args if isinstance(arg, Expr))
    return min(count, SIZES[-1])


def _sign_in_doubt(field: Field, value: Fraction) -> Expr | None:
    """Return a nonzero polynomial on whose sign the normal form depends, or None."""
    for i in field.ring.used(value.num):
        generator = field.ring.at(i)
        if generator.kind == "sign":
            terms = terms_in_symbols(field.ring, generator.data[0])
            if terms is not None:
                return sum((number(c) * as_expression(m) for m, c in terms.items()), ZERO)
    return None


def _obstacle(field: Field, value: Fraction) -> str:
    kinds = {field.ring.at(i).kind for i in field.ring.used(value.num)}
    for generator in map(field.ring.at, field.ring.used(value.num)):
        if generator.kind == "sign":
            factor = written(field, generator.data[0]) or "a subexpression"
            return (
                f"the normal form of the difference depends on the sign of {factor}; "
                "a condition on it may help"
            )
    if "opaque" in kinds:
        return "the difference could not be shown to be zero with the allowed theories alone"
    return "the normal form of the difference is not zero, and no counterexample was found"
