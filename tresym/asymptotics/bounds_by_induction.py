"""Bounds T(n) ≤ h(n) for every n of recurrences T(n) = Σ aᵢ T(⌊bᵢ n⌋ or ⌈bᵢ n⌉) + g(n).

Example: ``T(n) <= 2*n*log(n)`` with T(n) = 2 T(⌊n/2⌋) + n, T(1) = 1 and n ≥ 2.

Up to some N, T(n) is computed from the recurrence and compared. For n > N every argument lies in
[m, n) if m is the first n of the claim, so that T(n) ≤ Σ aᵢ h(argument) + g(n). Where h increases
from the least argument on, h(⌊b n⌋) ≤ h(b n) and h(⌈p n/q⌉) ≤ h((p n + q − 1)/q), and the induction
needs one inequality between explicit functions of a real number n > N. Lower bounds likewise.

An equation T(n) = h(n) holds if h satisfies the recurrence, which is shown for every residue of n.

If a bound fails or stays open, a factor C is looked for with which C h(n) is a bound.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import lcm

from flint import arb, fmpq

from tresym.asymptotics.divided_arguments import Branch, Divided, divided
from tresym.asymptotics.lemma import rounded_up
from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.rounding import is_rounded, residues, without_rounding
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

LEMMA = "induction on the recurrence"
LAST = (24, 96, 300)
"""Where the induction begins: T is computed up to there."""
MIRRORED = {"<=": ">=", "<": ">", ">=": "<=", ">": "<", "==": "=="}


def decide_bound(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a bound of T(n) for every n, or return None where it is no such claim.

    Args:
        claim: the comparison.
        statement: its conditions: the recurrence, first values, and n integer, n >= m.
        decided: decides explicit claims.
    """
    left, relation, right = claim.left, claim.relation, claim.right
    if relation not in MIRRORED or claim.derivatives:
        return None
    if elementary(left):
        left, relation, right = right, MIRRORED[relation], left
    if left.op != "unknown" or len(left.args) != 2 or left.args[1].op != "symbol":
        return None
    n = left.args[1]
    name = str(n.args[0])
    if not elementary(right) or symbols(right) - {name} or name not in statement.integers:
        return None
    found = divided(statement, n)
    if not isinstance(found, Divided) or not found.branches or found.node != left:
        return None
    low = statement.given.box[name].first_integer() if name in statement.given.box else None
    if low is None or any(symbols(e) != {name} for link in _links(statement) for e in link):
        return None

    def open_(why: str) -> Answer:
        return Answer(Verdict.UNDECIDED, why)

    if not all(branch.rounded for branch in found.branches):
        return open_(f"a claim about every {n} needs arguments that are integers, as floor({n}/2)")
    values = found.values(LAST[-1])
    if low not in values:
        return open_(f"the first values do not determine {_called(found, low)}: give more of them")
    if relation == "==":
        return _equal(found, values, low, right, statement, decided)
    # the recurrence is checked at a counterexample, so that it is rather none of the first values
    begin = max(low, *(k + 1 for k in found.starts))
    broken, ratio = _compared(values, begin, right, relation, name)
    if broken is None or begin > low:
        at_first, ratio = _compared(values, low, right, relation, name)
        broken = at_first if broken is None else broken
    if broken is not None:
        why = f"at {n} = {broken}: {_called(found, broken)} = {number(values[broken])}"
        why += _offer(found, values, low, right, relation, ratio, statement, decided)
        return Answer(Verdict.REFUTED, why, witness=_witness(found, values, broken), lemma=LEMMA)
    if relation in ("<", ">"):
        plain = replace(statement, given=Given(), equations=(), integers=())
        for k in range(begin, begin + LAST[0]):
            bound = substitute(right, {name: number(k)})
            if decided(Comparison(number(values[k]), "==", bound), plain):
                why = f"at {n} = {k}: {_called(found, k)} = {bound}"
                witness = _witness(found, values, k)
                return Answer(Verdict.REFUTED, why, witness=witness, lemma=LEMMA)
    for better in _stronger(found, right, relation):
        answer = _induction(found, values, low, better, relation, statement, decided)
        if answer is None:
            continue
        if better == right:
            return answer
        region = Given(((n, ">=", number(low)),))
        plain = replace(statement, given=region, equations=(), integers=())
        above = continuous_on(found.rest, region, proof) is None
        if above and decided(Comparison(found.rest, ">=", ZERO), plain):
            return replace(answer, why=f"{found.node} {relation} {better} {answer.why}")
    offer = _offer(found, values, low, right, relation, ratio, statement, decided)
    return open_(f"the induction does not close for {relation} {right}{offer}")


def _equal(
    found: Divided,
    values: dict[int, fmpq],
    low: int,
    right: Expr,
    statement: Statement,
    decided: Decide,
) -> Answer:
    """Decide T(n) == h(n): h must satisfy the recurrence, for every residue of n."""
    name, n = found.name, symbol(found.name)
    plain = replace(statement, given=Given(), equations=(), integers=())
    for k in sorted(range(low, low + LAST[0]), key=lambda k: k in found.starts):
        bound = substitute(right, {name: number(k)})
        if decided(Comparison(number(values[k]), "!=", bound), plain):
            why = f"at {n} = {k}: {_called(found, k)} = {number(values[k])}"
            return Answer(Verdict.REFUTED, why, witness=_witness(found, values, k), lemma=LEMMA)
        if not decided(Comparison(number(values[k]), "==", bound), plain):
            return Answer(Verdict.UNDECIDED, f"{_called(found, k)} is not compared with {bound}")
    last = low + LAST[0] - 1
    least = [_value(_end_of(branch, n, False), name, last + 1) for branch in found.branches]
    most = [_value(_end_of(branch, n, True), name, last + 1) for branch in found.branches]
    if any(x is None or x < low for x in least) or any(x is None or x > last for x in most):
        return Answer(Verdict.UNDECIDED, f"an argument is not below {n} from {n} = {last + 1} on")
    terms = [
        number(branch.factor) * substitute(right, {name: branch.argument})
        for branch in found.branches
    ]
    step = Comparison(add(found.rest, *terms), "==", right)
    region = Given(((n, ">", number(last)),))
    whole = replace(plain, comparisons=(step,), given=region, integers=(name,))
    cases = residues(whole)
    wheres = [whole] if cases is None else cases[2]
    answers = []
    for case in map(without_rounding, wheres):
        answers.append(decided(case.comparisons[0], case))
        if not answers[-1]:
            why = f"{right} is not shown to satisfy the recurrence: {answers[-1].why}"
            return Answer(Verdict.UNDECIDED, why)
    why = f"by induction: computed up to {n} = {last}, and {right} satisfies the recurrence beyond"
    return replace(worst(answers), why=why, lemma=LEMMA, region=None)


def _witness(found: Divided, values: dict[int, fmpq], n: int) -> dict[str, str]:
    """Return the values of T that violate a claim at n."""
    used = {k: values[k] for k in (n, *_arguments(found, n), *found.starts)}
    shown = {_called(found, k): str(number(v)) for k, v in sorted(used.items())}
    return {found.name: str(n)} | shown


def _stronger(found: Divided, right: Expr, relation: str) -> Iterator[Expr]:
    """Yield h and stronger bounds, h less multiples of g, for which the induction may close."""
    yield right
    if found.rest == ZERO:
        return
    with ball_precision():
        for at in (10, 1000):
            if not arb(evaluate(found.rest, {found.name: fmpq(at)})) > 0:
                return
    for d in (fmpq(1), fmpq(2), fmpq(1, 2)):
        yield right - number(d if relation in ("<=", "<") else -d) * found.rest


def _links(statement: Statement) -> list[tuple[Expr, ...]]:
    """Return the sides with variables of the conditions."""
    return [tuple(e for e in (x, y) if symbols(e)) for x, _, y in statement.given.comparisons]


def _called(found: Divided, k: int) -> str:
    return f"{found.node.args[0].args[0]}({k})"


def _arguments(found: Divided, n: int) -> list[int]:
    at = (branch.at(n, found.name) for branch in found.branches)
    return [int(x.p) for x in at if x is not None and n not in found.starts]


def _compared(
    values: dict[int, fmpq], low: int, right: Expr, relation: str, name: str
) -> tuple[int | None, arb | None]:
    """Return the first n at which the relation is shown to fail, and the extreme of T(n)/h(n)."""
    with ball_precision():
        for k in range(low, max(values) + 1):
            bound = arb(evaluate(right, {name: fmpq(k)}))
            if not bound.is_finite():
                return None, None
            value = arb(values[k])
            fails = value > bound if relation in ("<=", "<") else value < bound
            if fails:
                return k, _extreme(values, low, right, relation, name)
        return None, _extreme(values, low, right, relation, name)


def _extreme(
    values: dict[int, fmpq], low: int, right: Expr, relation: str, name: str
) -> arb | None:
    """Return the largest T(n)/h(n) for an upper bound, the least for a lower one."""
    found: arb | None = None
    for k in range(low, max(values) + 1):
        bound = arb(evaluate(right, {name: fmpq(k)}))
        if not bound > 0:
            return None
        ratio = arb(values[k]) / bound
        if found is None or (ratio > found if relation in ("<=", "<") else ratio < found):
            found = ratio
    return found


def _holds_at(
    value: fmpq, bound: Expr, relation: str, statement: Statement, decided: Decide
) -> bool:
    with ball_precision():
        ball = arb(evaluate(bound, {}))
    if relation in ("<=", "<") and arb(value) < ball:
        return True
    if relation in (">=", ">") and arb(value) > ball:
        return True
    plain = replace(statement, given=Given(), equations=(), integers=())
    return bool(decided(Comparison(number(value), relation, bound), plain))


def _induction(
    found: Divided,
    values: dict[int, fmpq],
    low: int,
    right: Expr,
    relation: str,
    statement: Statement,
    decided: Decide,
) -> Answer | None:
    """Return the proof that the relation holds for every n from the first one on."""
    name, n = found.name, symbol(found.name)
    up = relation in ("<=", "<")
    for last in LAST:
        if last > max(values):
            return None
        beyond = Given(((n, ">=", number(last + 1)),))
        places = [_end_of(branch, n, up) for branch in found.branches]
        least = [_end_of(branch, n, False) for branch in found.branches]
        most = [_end_of(branch, n, True) for branch in found.branches]
        if None in places or None in least or None in most:
            return None
        firsts = [_value(e, name, last + 1) for e in least]
        if any(x is None or x < low for x in firsts):
            continue
        if any(branch.ratio >= 1 for branch in found.branches) or any(
            (_value(e, name, last + 1) or fmpq(last + 1)) >= last + 1 for e in most
        ):
            continue
        start = min(x for x in firsts if x is not None)
        inside = Given(((n, ">=", number(start)),))
        plain = replace(statement, given=inside, equations=(), integers=())
        if continuous_on(right, inside, proof) is not None:
            continue
        if not decided(Comparison(differentiate(right, name), ">=", ZERO), plain):
            continue
        if continuous_on(found.rest, beyond, proof) is not None:
            continue
        terms = [
            number(branch.factor) * substitute(right, {name: place})
            for branch, place in zip(found.branches, places, strict=True)
            if place is not None
        ]
        step = Comparison(add(found.rest, *terms), relation[0] + "=", right)
        answer = decided(step, replace(plain, given=beyond))
        if not answer:
            continue
        if not all(
            _holds_at(values[k], substitute(right, {name: number(k)}), relation, statement, decided)
            for k in range(low, last + 1)
        ):
            return None
        verdict = Verdict.ENCLOSED if answer.verdict is Verdict.ENCLOSED else Verdict.PROVED
        why = (
            f"by induction: computed up to {name} = {last}, and beyond by "
            f"{step.left} {step.relation} {step.right} given {beyond}"
        )
        return Answer(verdict, why, lemma=LEMMA)
    return None


def _end_of(branch: Branch, n: Expr, up: bool) -> Expr | None:
    """Return an upper or a lower bound of an argument for integers n, linear in n."""
    e = branch.argument
    name = str(n.args[0])
    for node in functions(e):
        if not is_rounded(node):
            return None
        terms = polynomial(node.args[1])
        inside = node.args[1]
        if terms is None or any(m not in ((), ((name, 1),)) for m in terms):
            return None
        q = lcm(*(int(c.q) for c in terms.values()))
        slack = number(fmpq(q - 1, q))
        if node.args[0].args[0] == "ceiling":
            e = replaced(e, {node: inside + slack if up else inside})
        else:
            e = replaced(e, {node: inside if up else inside - slack})
    whole = polynomial(branch.argument if elementary(branch.argument) else e)
    marks = {m: symbol("[r]") for m in functions(branch.argument)}
    outer = polynomial(replaced(branch.argument, marks))
    if whole is None or outer is None:
        return None
    # the bounds above are those of the whole where what is rounded has a coefficient > 0
    if any("[r]" in dict(m) and c < 0 for m, c in outer.items()):
        return None
    return e


def _value(e: Expr | None, name: str, at: int) -> fmpq | None:
    terms = None if e is None else polynomial(substitute(e, {name: number(at)}))
    return None if terms is None or set(terms) - {()} else terms.get((), fmpq(0))


def _offer(
    found: Divided,
    values: dict[int, fmpq],
    low: int,
    right: Expr,
    relation: str,
    ratio: arb | None,
    statement: Statement,
    decided: Decide,
) -> str:
    """Return a factor with which the bound is proved, in words, or nothing."""
    if ratio is None or relation not in ("<=", "<") or not ratio > 0:
        return ""
    for slack in (fmpq(1), fmpq(101, 100), fmpq(6, 5), fmpq(3, 2)):
        c = number(rounded_up(ratio * arb(slack)))
        if _induction(found, values, low, c * right, "<=", statement, decided):
            return f"; {found.node} <= {c * right} holds for these {found.name}"
    return ""
