"""Decide inequalities: counterexamples, exact sign proofs, Taylor's theorem, then boxes.

A claim ``left >= right`` is about every real point of ``given`` where both sides are defined. It is
proved only if such a point is found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import chain, islice, pairwise, product
from operator import itemgetter

from flint import arb, fmpq, fmpq_mat

from tresym.reals.decisions.algebraic_witnesses import (
    equal_at_algebraic,
    equal_at_simple,
)
from tresym.reals.decisions.answer import Answer, exactly, refuted
from tresym.reals.decisions.cleared_factors import cleared, is_singular
from tresym.reals.decisions.derivative_domains import where_real
from tresym.reals.decisions.ideals import follows
from tresym.reals.decisions.identity import decide, no_point, sampled_values
from tresym.reals.decisions.inequalities_on_regions import is_bounded, is_isolated, search
from tresym.reals.decisions.inverse_branches import of_same_sign
from tresym.reals.decisions.variable_reduction import by_one_variable
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.local_search import low_points
from tresym.reals.domain.operation_domains import operations, with_domain
from tresym.reals.domain.sample_points import Range, corners
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    fresh,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.resource_limits import stage
from tresym.reals.signs.closure import ONLY_INSIDE, is_regular
from tresym.reals.signs.definedness import at_domain_ends
from tresym.reals.signs.interior import PROVING, sign_inside
from tresym.reals.signs.polynomials import cells
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Cause, Verdict

LOOKS = ((128, 40), (700, 10))
HALVINGS = 40
MAX_PAIRS = 8
LARGE = 40
"""Operations in an inequality in three variables or more, from which on exact methods, which take
long and seldom succeed, are tried after branch and bound if that can divide by positive factors."""
SEVERAL, SHORT_BUDGET = 12, 2_000
"""Operations in an inequality in three variables or more, all of them bounded, from which on branch
and bound with few boxes is tried before exact methods, which take ten times as long there."""
GRID, GRID_STEPS = range(-80, 81), 5
MAX_STARTS = 24
PERIODS = (2 * PI, number(2))
NO_POINT_FOUND = (
    "no point was found that satisfies the conditions and where both sides {}are defined, "
    "so there may be nothing to prove; check the conditions, or bound the variables"
)


def decide_inequality(
    left: Expr,
    relation: str,
    right: Expr,
    given: Given,
    differentiated: Iterable[Expr] = (),
    by: Iterable[str] = (),
) -> Answer:
    """Decide the inequality ``left relation right`` under ``given``.

    Args:
        differentiated: the functions of which derivatives, by the variables ``by``, are compared.
    """
    if relation in ("<", "<="):
        mirrored = relation.replace("<", ">")
        answer = decide_inequality(right, mirrored, left, given, differentiated, by)
        values = answer.values and (answer.values[1], answer.values[0])
        return replace(answer, values=values)
    inside, whole = where_real(given, differentiated, by)
    names = sorted(symbols(left) | symbols(right) | inside.names)
    defined, refutation = _sampled(left, relation, right, inside, names)
    if refutation is not None:
        return refutation
    if defined is None and (moved := at_domain_ends((left, right), given)):
        (left, right), given = moved
        answer = decide_inequality(left, relation, right, given, differentiated, by)
        return replace(answer, why=f"rewritten as {left} {relation} {right}: {answer.why}")
    if defined is None:
        more = "and the differentiated functions " if differentiated else ""
        why = NO_POINT_FOUND.format(more) if names else no_point((left, right), inside)
        return Answer(Verdict.UNDECIDED, why, cause=Cause.NO_POINT)
    if not symbols(left) | symbols(right):
        return _constants(left, relation, right)
    region = with_domain(whole, left, right)
    count = sum(1 for _ in operations((left, right))) if len(names) > 2 else 0
    boxed = count > SEVERAL and all(is_bounded(region.box.get(name, Range())) for name in names)
    large = boxed or count > LARGE
    if large and relation != "!=":
        with stage("division by positive factors"):
            divided = _by_division(left - right, relation, region, inside)
        if divided is not None:
            return _shown_under(given, divided)
        if boxed:
            with stage("branch and bound"):
                few = search(left, right, relation == ">", region, inside, SHORT_BUDGET)
            if few:
                return _shown_under(given, few)
    with stage("proof of a sign"):
        sentence = proof(left - right, relation, region)
        for e in of_same_sign(left - right, region) if sentence is None else ():
            if sentence is None and (shown := proof(e, relation, region)):
                sentence = f"without the inverse function it is {e} {relation} 0; {shown}"
    partly = sentence is not None and not is_regular(given)
    if sentence is not None and not partly:
        return Answer(Verdict.PROVED, exactly(f"{sentence}; both sides are defined", defined))
    zero = equal_at_algebraic(left, right, inside) if relation != ">=" else None
    if zero is not None:
        return zero
    strict = relation in (">", "!=") and is_regular(given)
    if strict and _vanish_nowhere_together(left - right, region):
        why = (
            "no term of the difference is negative, and they do not vanish together (Gröbner basis)"
        )
        return Answer(Verdict.PROVED, exactly(f"{why}; both sides are defined", defined))
    if not differentiated and (again := in_positive_variables((left, right), given)) is not None:
        (first, second), positive, said = again
        answer = decide_inequality(first, relation, second, positive)
        if answer:
            return replace(answer, why=f"with {said} > 0: {answer.why}", region=None)
    if relation == "!=":
        answer = _shown_under(given, _apart(left, right, region, inside, defined))
        split = None if differentiated or answer.verdict is not Verdict.UNDECIDED else _sides(given)
        return answer if split is None else _on_both_sides(left, right, *split, answer)
    with stage("search for a counterexample"):
        refutation = _refuted_at_lowest(left, relation, right, region, inside)
    if refutation is not None:
        return refutation
    if not differentiated:
        reduced = by_one_variable(left, relation, right, given, decide_inequality)
        if reduced is not None and not (partly and reduced):
            return reduced
    period = _one_period(left - right, region, given)
    with stage("division by positive factors"):
        divided = None if large or partly else _by_division(left - right, relation, region, inside)
    if divided is not None:
        return _shown_under(given, divided)
    with stage("branch and bound"):
        answer = _shown_under(given, search(left, right, relation == ">", period, inside))
    if partly and answer.verdict is Verdict.UNDECIDED:
        return replace(answer, why=ONLY_INSIDE)
    return answer


def _by_division(difference: Expr, relation: str, region: Given, inside: Given) -> Answer | None:
    """Prove an inequality after division by positive factors, where it has no box or a pole."""
    if not is_singular(difference, region):
        return None

    def positive(e: Expr) -> bool:
        return bool(search(e, ZERO, True, region, inside))

    rest = cleared(difference, region, positive)
    if rest is None:
        return None
    answer = search(rest, ZERO, relation == ">", region, inside)
    return (
        replace(answer, why=f"after division by positive factors, {answer.why}") if answer else None
    )


def _vanish_nowhere_together(difference: Expr, region: Given) -> bool:
    """Whether a sum has terms that are not negative and have no common zero."""
    if difference.op != "+":
        return False
    terms = [term for term in difference.args if symbols(term)]
    if any(sign_inside(term, region) not in ("+", ">=0", "0") for term in difference.args):
        return False
    nonzero = [c.expression for c in region.conditions if c.relation != ">="]
    return follows(ONE, terms, nonzero, vanishes=True)


def in_positive_variables(
    sides: tuple[Expr, Expr], given: Given
) -> tuple[tuple[Expr, Expr], Given, str] | None:
    """Return the sides in new variables that are positive, where n linear conditions allow that.

    Of a triangle, ``a + b > c, b + c > a, c + a > b`` become u > 0, v > 0, w > 0 with
    ``u = a + b - c`` and so on.

    Returns:
        The sides, the conditions on the new variables, and the variables in words; None unless the
        conditions are as many strict linear inequalities as there are variables, independent ones.
    """
    names = sorted(frozenset().union(*map(symbols, sides)) | given.names)
    forms = [c.expression for c in given.conditions]
    if len(forms) != len(names) or not 1 < len(names) <= MOST_LINEAR:
        return None
    if any(c.relation != ">" for c in given.conditions) or all(f.op == "symbol" for f in forms):
        return None
    rows = []
    for form in forms:
        slopes = [differentiate(form, name) for name in names]
        start = substitute(form, dict.fromkeys(names, ZERO))
        if any(slope.op != "number" for slope in slopes) or start.op != "number":
            return None
        rows.append([slope.args[0] for slope in slopes] + [start.args[0]])
    matrix = fmpq_mat([row[:-1] for row in rows])
    if matrix.det() == 0:
        return None
    inverse, taken, new = matrix.inv(), {*names}, []
    for n in range(len(names)):
        new.append(symbol(fresh("uvwz"[n], taken)))
        taken.add(str(new[-1]))
    put = {}
    for i, name in enumerate(names):
        terms = (number(inverse[i, j]) * (new[j] - number(rows[j][-1])) for j in range(len(names)))
        put[name] = sum(terms, ZERO)
    positive = Given(tuple((x, ">", ZERO) for x in new))
    said = ", ".join(f"{x} = {form}" for x, form in zip(new, forms, strict=True))
    first, second = (in_lowest_terms(substitute(side, put)) for side in sides)
    return (first, second), positive, said


MOST_LINEAR = 4
"""The largest number of linear conditions that become positive variables."""


def _refuted_at_lowest(
    left: Expr, relation: str, right: Expr, region: Given, inside: Given
) -> Answer | None:
    """Return a refutation in an open cell, at a low point, or at a zero beside one; or None."""
    names = sorted(symbols(left) | symbols(right) | inside.names)
    starts = inside.points(names, MAX_STARTS)
    for point in chain(_in_cells(left - right, region), low_points(left - right, inside, starts)):
        refutation = _refuted_at(point, left, relation, right, inside)
        if refutation is None and relation == ">" and len(names) > 1:
            refutation = equal_at_simple(left, right, inside, point)
        if refutation is not None:
            return refutation
    return None


def _shown_under(given: Given, found: Answer) -> Answer:
    """Return an enclosed answer with the conditions as the user wrote them."""
    if found.verdict is not Verdict.ENCLOSED or not given.comparisons:
        return found
    return replace(found, region=str(given))


def _one_period(difference: Expr, region: Given, given: Given) -> Given:
    """Return the region, reduced to one period if the claim is periodic."""
    names = symbols(difference)
    if len(names) != 1 or names & given.names:
        return region
    x = symbol(*names)
    # Its domain must be periodic too: what is equal is so only where both are defined.
    parts = [difference, *(condition.expression for condition in region.conditions)]
    for period in PERIODS:
        shift = {x.args[0]: x + period}
        if all(decide(substitute(e, shift), e).verdict is Verdict.PROVED for e in parts):
            return region & Given(((x, ">=", -period / 2), (x, "<=", period / 2)))
    return region


def _sampled(
    left: Expr, relation: str, right: Expr, given: Given, names: list[str]
) -> tuple[dict[str, fmpq] | None, Answer | None]:
    """Return a point where both sides are defined, and a refutation if a sample gives one."""
    defined = None
    for bits, count in LOOKS:
        for point, (x, y) in sampled_values(left, right, given, names, count, bits):
            defined = point
            if relation != "!=" and x < y:
                return defined, refuted(exactly("it fails", point), point, x, y)
            if relation != ">=" and x.overlaps(y) and equal_at(left, right, point):
                return defined, refuted(exactly("both sides are equal", point), point, x, y)
    return defined, _at_corners(left, relation, right, given, names) if defined else None


def _in_cells(difference: Expr, region: Given) -> Iterator[dict[str, fmpq]]:
    """Yield a point of each open cell in which the polynomial difference is negative."""
    with suppress(TooLargeError):
        open_cells = cells(difference, region)
        if open_cells is not None and open_cells.against:
            yield dict(open_cells.against)


def _at_corners(
    left: Expr, relation: str, right: Expr, given: Given, names: list[str]
) -> Answer | None:
    """Return a refutation with variables at 0, 1 or the closed ends of their ranges, or None."""
    for point in dict.fromkeys(tuple(p.items()) for p in corners(names, given.box)):
        answer = _refuted_at(dict(point), left, relation, right, given)
        if answer is not None:
            return answer
    return None


def _refuted_at(
    point: dict[str, fmpq], left: Expr, relation: str, right: Expr, given: Given
) -> Answer | None:
    """Return a refutation if the point satisfies the conditions and violates the claim."""
    if not given.names <= point.keys():  # found where the claim's own variables are
        return None
    for bits, _ in LOOKS:
        with ball_precision(bits):
            at = {name: arb(value) for name, value in point.items()}
            if not all(satisfies(condition, point, at) for condition in given.conditions):
                continue
            x, y = evaluate(left, at), evaluate(right, at)
        if not (x.is_finite() and y.is_finite()):
            continue
        found = None
        if relation != "!=" and x < y:
            found = refuted(exactly("it fails", point), point, x, y)
        elif relation != ">=" and x.overlaps(y) and equal_at(left, right, point):
            found = refuted(exactly("both sides are equal", point), point, x, y)
        if found is not None:
            return None if is_isolated(at, (left, right)) else found
    return None


def _constants(left: Expr, relation: str, right: Expr) -> Answer:
    """Decide an inequality between two constants that no ball refutes."""
    if equal_at(left, right, {}):
        if relation == ">=":
            return Answer(Verdict.PROVED, "the two constants are equal")
        return refuted("the two constants are equal", {})
    its_sign = sign(left - right, Given())
    if its_sign in PROVING[relation] and left.op == right.op == "number":
        return Answer(Verdict.PROVED, "these are numbers")
    if its_sign in PROVING[relation]:
        return Answer(Verdict.ENCLOSED, "interval arithmetic separates the two constants")
    return Answer(
        Verdict.UNDECIDED,
        ("the two constants agree to 1024 bits, and could not be shown to be equal"),
    )


def _apart(
    left: Expr, right: Expr, region: Given, inside: Given, defined: dict[str, fmpq]
) -> Answer:
    """Decide ``left != right``: a zero refutes it, a strict inequality proves it."""
    names = sorted(defined)
    signs: dict[bool, list[dict[str, fmpq]]] = {True: [], False: []}
    sampled = sampled_values(left, right, region, names, *LOOKS[0][::-1])
    for point, (x, y) in chain(sampled, _on_grid(left, right, inside, names)):
        if not x.overlaps(y):
            signs[bool(x > y)].append(point)
    pairs = islice(product(signs[True], signs[False]), MAX_PAIRS)
    for start, end in chain(_neighbours(signs), pairs):
        zero = _zero_between(left - right, region, start, end)
        if zero is not None:
            return zero
    above = bool(signs[True])
    if above and signs[False]:
        why = "the difference takes both signs, so it may vanish, but no zero was found"
        return Answer(Verdict.UNDECIDED, why)
    pair = (left, right) if above else (right, left)
    answer = search(*pair, True, region, inside)
    if answer.verdict is not Verdict.REFUTED:
        return answer
    point = {name: parse(text) for name, text in (answer.witness or {}).items()}
    if equal_at(left, right, point):
        return replace(answer, why=exactly("both sides are equal", point))
    if all(value.op == "number" for value in point.values()):
        exact = defined | {name: value.args[0] for name, value in point.items()}
        zero = _zero_between(left - right, region, defined, exact)
        if zero is not None:
            return zero
    why = "the difference changes sign, so it may vanish, but no zero was found"
    return Answer(Verdict.UNDECIDED, why)


def _on_grid(
    left: Expr, right: Expr, given: Given, names: list[str]
) -> Iterator[tuple[dict[str, fmpq], tuple[arb, arb]]]:
    """Yield values on a regular grid, which finds zeros between neighbouring poles."""
    for k in GRID if len(names) == 1 else ():
        point = {names[0]: fmpq(k, GRID_STEPS)}
        sides = None
        with ball_precision():
            at = {name: arb(value) for name, value in point.items()}
            if all(condition.holds_exactly(at) for condition in given.conditions):
                sides = evaluate(left, at), evaluate(right, at)
        if sides is not None and all(side.is_finite() for side in sides):
            yield point, sides


def _neighbours(
    signs: dict[bool, list[dict[str, fmpq]]],
) -> Iterator[tuple[dict[str, fmpq], dict[str, fmpq]]]:
    """Yield neighbouring points of one variable at which the signs of the difference differ."""
    points = [(*p.values(), above, p) for above, found in signs.items() for p in found]
    if points and len(points[0]) == 3:
        for (_, above, p), (_, below, q) in pairwise(sorted(points, key=itemgetter(0))):
            if above != below:
                yield p, q


def _sides(given: Given) -> tuple[Given, Given] | None:
    """Split the conditions at one of the form ``u != v`` into u > v and u < v, or None."""
    for k, comparison in enumerate(given.comparisons):
        left, relation, right = comparison
        if relation == "!=":
            others = given.comparisons[:k] + given.comparisons[k + 1 :]
            return Given(((left, ">", right), *others)), Given(((left, "<", right), *others))
    return None


def _on_both_sides(left: Expr, right: Expr, one: Given, other: Given, answer: Answer) -> Answer:
    """Decide ``left != right`` in two cases; return ``answer`` if they do not decide it."""
    answers = [decide_inequality(left, "!=", right, case) for case in (one, other)]
    for each in answers:
        if each.verdict is Verdict.REFUTED:
            return each
    if not all(answers):
        return answer
    weakest = next((each for each in answers if each.verdict is Verdict.ENCLOSED), answers[0])
    why = f"in each of the two cases left by the condition with !=: {weakest.why}"
    return replace(weakest, why=why, region=None)


def _zero_between(
    difference: Expr, region: Given, start: dict[str, fmpq], end: dict[str, fmpq]
) -> Answer | None:
    """Refute ``difference != 0`` by bisection between two points of opposite sign, or return None.

    The difference is continuous on the small box about the last two points, as its ball there is
    finite, so it vanishes on the segment between them.
    """
    with ball_precision(LOOKS[-1][0]):
        above = evaluate(difference, {name: arb(x) for name, x in start.items()}) > 0
        for _ in range(HALVINGS):
            middle = {name: (start[name] + end[name]) / 2 for name in start}
            value = evaluate(difference, {name: arb(x) for name, x in middle.items()})
            if not (value > 0 or value < 0):
                return None
            start, end = (middle, end) if (value > 0) == above else (start, middle)
        box = {name: arb(start[name]).union(arb(end[name])) for name in start}
        inside = all(condition.holds(box) for condition in region.conditions)
        if not (inside and evaluate(difference, box).is_finite()):
            return None
    ends = {name: sorted((start[name], end[name])) for name in start}
    witness = {
        name: f"[{fraction_text(low)}, {fraction_text(high)}]" if low < high else fraction_text(low)
        for name, (low, high) in ends.items()
    }
    why = (
        "the difference is continuous and changes sign between the "
        "ends of the intervals given as witness, so it vanishes there"
    )
    return Answer(Verdict.REFUTED, why, witness=witness)
