"""Decide claims along a path about the root of an equation: orders, limits, inequalities.

Example: ``y == 1 - e/5 - e**2/25 + O(e**3) given y**5 + e*y == 1, y > 0 as e -> 0``. Two lemmas
reduce such a claim to claims about explicit functions, which the same dispatcher decides.

*Elimination of the path variable.* The equation is solved for the path variable, e = G(y); here
G = (1 − y⁵)/y. The interval to which the conditions restrict y is divided at the zeros of G − e₀,
the poles and the critical points of G. On each part G − e₀ has one sign and G is monotone, so that
y(e) tends to an end of it where G → e₀, or the part holds no root for e near e₀. If exactly one
branch remains, or the other conditions single one out near the end of the path, the root exists,
is unique, and the claim is one along y → y₀ with G(y) put in for e. Both a proof and a refutation
carry over. (N. G. de Bruijn, *Asymptotic Methods in Analysis*, 1958, chapter 2.)

*Residual.* Where the slope ∂F/∂y is at least m > 0 wherever the conditions hold, F has at most one
root there, and |y − A| ≤ |F(A)|/m. This also holds with parameters: Kepler's equation
``u - e*sin(u) == m``, with slope at least 1/2 for e ≤ 1/2.

In a family such as ``tan(x) == x, n*pi < x < (n + 1/2)*pi, n integer as n -> oo`` the unknown is
shifted by the multiple of π that grows with n; by the periods n may then be real.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import NamedTuple

from flint import arb, fmpq, fmpq_poly

from tresym.asymptotics.constants import rounded
from tresym.asymptotics.lemma import End
from tresym.asymptotics.lemma_claims import decide_with_expansions
from tresym.asymptotics.order_claims import region
from tresym.asymptotics.root_systems import Component, System, starts_of, system_of
from tresym.asymptotics.tubes import Equation, Root, conditions_of, forms, starts
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text, worst
from tresym.reals.decisions.equation_solutions import solved
from tresym.reals.decisions.equations import chained_zero
from tresym.reals.decisions.path_regions import along
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.expansions.leading_terms import leading_sign, leading_term, sharp_constant
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.expansions.scale import T
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    integer,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, InputError, parse_number
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

ELIMINATED = "elimination of the path variable (de Bruijn 1958, chapter 2)"
RESIDUAL = "residual and slope of the equation (mean value theorem)"
FAR = (2, 10, 100, 1000)
"""From where on the slope of an equation is bounded."""
SAMPLES = 60
MOST_FUNCTIONS = 1
"""The number of transcendental functions in a slope of which bounds are sought by all methods."""
MOST_DEGREE = 12
HALVINGS = 12
REGIONS = 6
"""Regions that are tried for a sharp constant, each half as long as the one before."""
RANGE_HALVINGS = 20
SHARP_BITS = 320
CLOSE = arb("0.01")
LARGE = arb("1e300")
_OPEN_ENDS = (INFINITY, -INFINITY)


class _OpenError(Exception):
    """The lemma is not shown to apply; the text says what is missing."""


def decide_implicit(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim along a path whose conditions include equations with the path variable.

    Args:
        claim: the comparison.
        statement: its conditions and path.
        decided: the procedure for claims about explicit functions.
    """
    try:
        found = _decide(claim, statement, decided)
        if found and statement.path and statement.path.reach and found.constant is None:
            raise _OpenError(f"no constant was found on the region asked for; {found.why}")
        return found
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))
    except InputError as error:
        return Answer(
            Verdict.UNDECIDED, f"an intermediate expression exceeds the size limit: {error}"
        )


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    assert path is not None
    trees = (claim.left, claim.right, *claim.differentiated, *statement.said)
    if not elementary(*trees):
        raise _OpenError(
            "a root along a path is supported if the claim and its equation are explicit: "
            "without integrals, sums and arbitrary functions"
        )
    if claim.derivatives:
        raise _OpenError("derivatives of roots along a path are not supported")
    if len(path.sides) > 1:
        answers = [
            _decide(claim, replace(statement, path=replace(path, sides=(side,))), decided)
            for side in path.sides
        ]
        return _both_sides(answers, path)
    claim, statement = _with_explicit(claim, statement)
    base = _base_of_either_sign(statement)
    if base is not None:
        raise _OpenError(
            f"where {base} is negative and its exponent is an integer there may be further roots: "
            f"add the condition that {base} is positive"
        )
    if not statement.equations:
        return _along(claim, statement, (), decided)
    if len(statement.equations) > 1:
        whole = claim, statement
        try:
            claim, statement = _with_one_less(claim, statement)
            found = (_in_families if statement.integers else _of_root)(claim, statement, decided)
            if found.verdict is not Verdict.UNDECIDED:
                return found
        except _OpenError:
            if len(whole[1].equations) != 2 or statement.integers:
                raise
        return _of_two(*whole, decided)
    if statement.integers:
        return _in_families(claim, statement, decided)
    return _of_root(claim, statement, decided)


def _base_of_either_sign(statement: Statement) -> Expr | None:
    """Return the base of a power in an equation that may be negative, or None.

    With a variable exponent, x**n == 2 has the root -2**(1/n) where n is an even integer.
    """
    path = statement.path
    assert path is not None
    links = [link for link in statement.given.comparisons if not _holds_power(link)]
    if path.point in (None, ZERO):
        links.append((symbol(path.name), "<" if path.sides == (-1,) else ">", ZERO))
    inside = Given(tuple(links))
    sides = [side for pair in statement.equations for side in pair]
    for node in operations(sides):
        base, exponent = node.args if node.op == "^" else (ZERO, ZERO)
        if not symbols(base) or not symbols(exponent):
            continue
        if sign(base, inside, dear=False) not in ("+", ">=0"):
            return base
    return None


def _holds_power(link: Compared) -> bool:
    """Whether a comparison holds a power with a variable exponent."""
    return any(e.op == "^" and symbols(e.args[1]) for e in operations(link[::2]))


def _with_explicit(claim: Comparison, statement: Statement) -> tuple[Comparison, Statement]:
    """Put in what an equation defines explicitly, as q == (n + 1/2)*pi does.

    A parameter in terms of the unknown is not put in: it is fixed, while the unknown moves.
    """
    path = statement.path
    assert path is not None
    first = claim.left.args[0] if claim.left.op == "+" else claim.left
    for pair in statement.equations:
        for left, right in (pair, pair[::-1]):
            if left.op != "symbol" or left.args[0] in symbols(right) | {path.name}:
                continue
            if left.args[0] in statement.integers:
                continue
            if left != first and symbols(right) - {path.name} and not _closed(statement):
                continue
            others = tuple(other for other in statement.equations if other is not pair)
            put = partial(substitute, mapping={str(left.args[0]): right})
            links = tuple((e, relation, ZERO) for e, relation in needs((right,)))
            rest = replace(statement, equations=others, given=statement.given & Given(links))
            return _with_explicit(claim.mapped(put), rest.mapped(put))
    return claim, statement


def _both_sides(answers: list[Answer], path: Path) -> Answer:
    """Return the answer of a path from both sides; a constant needs the same region on each."""
    found = worst(answers)
    balls = [answer.constant for answer in answers if answer.constant is not None]
    regions = [(answer.region or "").replace("-", "") for answer in answers]
    if not found or len(balls) < len(answers) or len({*regions}) > 1:
        return replace(found, region=None, constant=None)
    largest = max(balls, key=lambda ball: parse_number(ball.mid) + parse_number(ball.rad))
    reach = fmpq(*map(int, (regions[0].split()[-1] + "/1").split("/")[:2]))
    return replace(found, region=region(path, reach), constant=largest)


def _closed(statement: Statement) -> bool:
    """Return whether there are as many equations as variables, so that none is a parameter."""
    path = statement.path
    assert path is not None
    trees = [e for pair in statement.equations for e in pair]
    names = frozenset().union(*map(symbols, trees)) - {path.name}
    return len(names) <= len(statement.equations)


def _with_one_less(claim: Comparison, statement: Statement) -> tuple[Comparison, Statement]:
    """Solve all equations but one for an unknown that the claim does not begin with."""
    path = statement.path
    assert path is not None
    first = claim.left.args[0] if claim.left.op == "+" else claim.left
    while len(statement.equations) > 1:
        if not _closed(statement):
            raise _OpenError("there are more unknowns than equations")
        for pair in statement.equations:
            gap = pair[0] - pair[1]
            for name in sorted(symbols(gap) - {path.name, str(first)}):
                cases = solved(gap, name, statement) or []
                if len(cases) == 1 and cases[0].value is not None and not cases[0].integers:
                    break
            else:
                continue
            break
        else:
            raise _OpenError("no equation could be solved for one of its unknowns")
        (case,) = cases
        assert case.value is not None
        put = partial(substitute, mapping={name: tidied(case.value)})
        others = tuple(other for other in statement.equations if other is not pair)
        links = (*case.conditions, *((e, rel, ZERO) for e, rel in needs((case.value,))))
        rest = replace(
            statement,
            equations=(*others, *case.equations),
            given=statement.given & Given(tuple(links)),
        )
        claim, statement = claim.mapped(put), rest.mapped(put)
    return claim, statement


def _along(
    claim: Comparison, statement: Statement, links: tuple[Compared, ...], decided: Decide
) -> Answer:
    """Decide an explicit claim whose conditions ``links`` must hold near the end of the path."""
    path = statement.path
    assert path is not None
    kept: list[Compared] = []
    for link in (*statement.given.comparisons, *links):
        if path.name not in symbols(link[0]) | symbols(link[2]):
            kept.append(link)
    inside = replace(statement, given=Given(tuple(kept)))
    for link in (*statement.given.comparisons, *links):
        if link not in kept and not _holds_near_the_end(link, inside, decided):
            left, relation, right = link
            raise _OpenError(
                f"the condition {left} {relation} {right} is not shown to hold near the end of the "
                "path"
            )
    return decided(claim, inside)


def _holds_near_the_end(link: Compared, statement: Statement, decided: Decide) -> bool:
    left, relation, right = link
    return bool(decided(Comparison(left, relation, right), statement))


def _fails_near_the_end(link: Compared, statement: Statement, decided: Decide) -> bool:
    left, relation, right = link
    opposite = {">": "<=", ">=": "<", "<": ">=", "<=": ">"}.get(relation)
    if opposite is None:
        return False
    return _holds_near_the_end((left, opposite, right), statement, decided)


def decide_beside_conditions(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim along a path whose conditions contain the variable of the path."""
    try:
        return _along(claim, statement, (), decided)
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))


# Families of roots


def _in_families(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about roots that are numbered by the integer of the path."""
    path = statement.path
    assert path is not None
    n = path.name
    if statement.integers != (n,):
        raise _OpenError("integer conditions on other variables than that of the path")
    name = _unknown(claim, statement)
    growing = None
    for left, _, right in statement.given.comparisons:
        for x, y in ((left, right), (right, left)):
            if x == symbol(name) and n in symbols(y):
                growing = tidied(differentiate(y, n))
    if growing is None and not any(_turns(e, n) for e in statement.said):
        found = _of_root(claim, replace(statement, integers=()), decided, name)
        if found.verdict is not Verdict.REFUTED or not any(
            node.op in _QUARTERS for node in operations((claim.left, claim.right))
        ):  # what fails by leading terms without waves fails at integers too
            return found
    if growing is None or symbols(growing):
        raise _OpenError(
            f"the conditions do not say where {name} lies for each {n}, as in n*pi < x < (n + 1)*pi"
        )
    shift = symbol(name) + growing * symbol(n)
    free = replace(statement, integers=())
    put = partial(substitute, mapping={name: shift})
    moved, inside = claim.mapped(put), free.mapped(put)
    plain = [_unwound(e, n) for pair in inside.equations for e in pair]
    claimed = [_unwound(e, n) for e in (moved.left, moved.right)]
    if not any(_turns(e, n) for e in (*plain, *claimed)):
        return _periodic(moved, inside, plain, decided, name)
    answers = []
    for rest in (ZERO, ONE):  # n = 2 m + rest
        part = partial(substitute, mapping={n: 2 * symbol(n) + rest})
        there = inside.mapped(part)
        plain = [_unwound(e, n) for pair in there.equations for e in pair]
        if any(_turns(e, n) for e in plain):
            raise _OpenError(f"the equation is not periodic in the integer {n}")
        answers.append(_periodic(moved.mapped(part), there, plain, decided, name))
    return worst(answers)


def _periodic(
    claim: Comparison, statement: Statement, plain: list[Expr], decided: Decide, name: str
) -> Answer:
    """Decide a claim after the periods of its equation have removed the integer from angles."""
    path = statement.path
    assert path is not None
    plain = [_turned(e, name) for e in plain]
    pairs = tuple(zip(plain[::2], plain[1::2], strict=True))
    links = tuple(
        (_normal(x - y), relation, ZERO) for x, relation, y in statement.given.comparisons
    )
    inside = replace(statement, equations=pairs, given=Given(links))
    sides = [_turned(_unwound(e, path.name), name) for e in (claim.left, claim.right)]
    if any(_turns(e, path.name) for e in sides):
        raise _OpenError("the claim is not periodic in the integer of the path")
    found = _of_root(replace(claim, left=sides[0], right=sides[1]), inside, decided, name)
    return replace(found, region=None, constant=None)


def _normal(e: Expr) -> Expr:
    return normal_form(e, Given())


def _turns(e: Expr, n: str) -> bool:
    """Return whether an angle or the exponent of −1 contains the integer."""
    return any(_period(node) is not None and n in symbols(node) for node in operations((e,)))


def _period(node: Expr) -> tuple[Expr, Expr] | None:
    """Return what repeats in a node, an angle or an exponent of −1, and its period."""
    if node.op in ("sin", "cos", "sec", "csc"):
        return node.args[0], 2 * PI
    if node.op in ("tan", "cot"):
        return node.args[0], PI
    return (node.args[1], number(2)) if node.op == "^" and node.args[0] == MINUS_ONE else None


def _unwound(e: Expr, n: str) -> Expr:
    """Return ``e`` for integers n, without whole periods in its angles and signs (−1)ⁿ."""
    known: dict[Expr, Expr] = {}
    for node in operations((e,)):
        repeats = _period(node)
        if repeats is None or n not in symbols(node):
            continue
        inner, period = repeats
        if integer(_normal(differentiate(inner, n) / period)) is not None:
            start = _normal(substitute(inner, {n: ZERO}))
            angle = period != number(2)
            known[node] = apply(node.op, start) if angle else power(MINUS_ONE, start)
    return replaced(e, known)


# One root


def _unknown(claim: Comparison, statement: Statement) -> str:
    """Return the variable that the equation determines."""
    path = statement.path
    assert path is not None
    if len(statement.equations) > 1:
        raise _OpenError("several equations: solve all but one for a variable, in the form x == …")
    left, right = statement.equations[0]
    names = sorted((symbols(left) | symbols(right)) - {path.name})
    if len(names) == 1:
        return names[0]
    first = claim.left.args[0] if claim.left.op == "+" else claim.left
    if first.op == "symbol" and first.args[0] in names:
        return str(first.args[0])
    linear = [
        name
        for name in names
        if (slope := differentiate(claim.left, name)).op == "number" and slope != ZERO
    ]
    if len(linear) == 1:
        return linear[0]
    raise _OpenError(
        f"it is not clear which of {', '.join(names)} the equation determines: write it alone on "
        "the left side of the claim"
    )


def _of_root(
    claim: Comparison, statement: Statement, decided: Decide, name: str | None = None
) -> Answer:
    name = _unknown(claim, statement) if name is None else name
    reasons = []
    for lemma in (_by_elimination, _by_solution, _by_residual, _by_tube):
        try:
            found = lemma(claim, statement, name, decided)
        except _OpenError as error:
            reasons.append(str(error))
            continue
        if found.verdict is not Verdict.UNDECIDED:
            return found
        reasons.append(found.why)
    unsolved = "could not be solved" in reasons[0]
    raise _OpenError(reasons[-1] if unsolved else reasons[0])


def _by_solution(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer:
    """Decide a claim whose equation can be solved for the unknown itself."""
    left, right = statement.equations[0]
    cases = solved(left - right, name, statement)
    if cases is None or any(case.value is None or case.integers for case in cases):
        raise _OpenError(f"the condition {left} == {right} could not be solved for {name}")
    answers, dropped = [], 0
    for case in cases:
        assert case.value is not None
        put = partial(substitute, mapping={name: case.value})
        rest = replace(statement, equations=case.equations).mapped(put)
        links = (*case.conditions, *((e, rel, ZERO) for e, rel in needs((case.value,))))
        if case.equations:
            raise _OpenError("the solution has exceptional cases")
        conditions = tuple(
            link
            for link in (*rest.given.comparisons, *links)
            if rest.path and rest.path.name in symbols(link[0]) | symbols(link[2])
        )
        inside = replace(
            rest,
            given=Given(tuple(x for x in rest.given.comparisons if x not in conditions)),
        )
        if any(_fails_near_the_end(link, inside, decided) for link in conditions):
            dropped += 1
            continue
        answers.append(_along(claim.mapped(put), inside, conditions, decided))
    if len(answers) != 1:
        raise _OpenError(_count(len(answers), name))
    return replace(answers[0], lemma=ELIMINATED)


def _count(branches: int, name: str) -> str:
    if not branches:
        return (
            "no root satisfies the conditions near the end of the path, so there is nothing to "
            "prove"
        )
    return (
        f"{branches} roots satisfy the conditions near the end of the path; a further condition "
        f"on {name} must select one"
    )


@dataclass(frozen=True)
class _Branch:
    """One way in which the root approaches the end: e = G(y) and where y tends."""

    solution: Expr
    point: Expr | None
    side: int


class _Alive(NamedTuple):
    """The one branch that the conditions select.

    Attributes:
        branch: how the root approaches the end.
        inside: the conditions on the parameters, with the path of the unknown.
        put: substitutes the solution for the path variable.
        low, high: the ends between which constant conditions keep the unknown.
        single: whether no other branch and no further condition was looked at.
    """

    branch: _Branch
    inside: Statement
    put: Callable[[Expr], Expr]
    low: Expr
    high: Expr
    single: bool


def start_of_root(statement: Statement, decided: Decide) -> tuple[str, Expr, Expr]:
    """Return the unknown of a statement, its equation, and its leading behaviour along the path.

    Raises:
        InputError: no single branch is found, or its leading behaviour is no power.
    """
    path = statement.path
    assert path is not None
    try:
        claim, statement = _with_explicit(Comparison(ZERO, "==", ZERO), statement)
        if len(statement.equations) != 1:
            raise _OpenError("one equation must determine the root")
        name = _unknown(claim, statement)
        alive = _selected(statement, name, decided)
    except _OpenError as error:
        raise InputError(str(error)) from None
    left, right = statement.equations[0]
    branch = alive.branch
    gap = branch.solution if path.point is None else branch.solution - path.point
    first = leading_term(gap, name, branch.point, branch.side, Given())
    if first is None or set(first.powers) != {T} or first.powers[T].op != "number":
        raise InputError("the root does not begin with a power of the path variable")
    # |e − e₀|, or |e|, is |c| s^p with s = |y − y₀|, or 1/|y|.
    p, c = first.powers[T].args[0], first.coefficient
    with ball_precision():
        size = c if evaluate(c, {}) > 0 else -c
    e = symbol(path.name)
    distance = path.sides[0] * (e if path.point is None else e - path.point)
    if branch.point is None:
        return name, left - right, branch.side * (distance / size) ** number(-1 / p)
    return name, left - right, branch.point + branch.side * (distance / size) ** number(1 / p)


def _by_elimination(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer:
    path = statement.path
    assert path is not None
    branch, inside, put, low, high, single = _selected(statement, name, decided)
    moved = claim.mapped(put)
    where = f"with {path.name} = {branch.solution} as {inside.path}"
    at_zero = _at_zero(moved, inside, name)
    answer = decided(moved, inside) if at_zero is None else decided(*at_zero)
    if at_zero is not None and answer.witness and name in answer.witness:
        moved_to = branch.point + branch.side * parse(answer.witness[name])
        answer = replace(answer, witness=dict(answer.witness) | {name: exact_text(moved_to)})
    if answer and claim.relation == "O" and single:
        shown = _sharp(moved, inside, branch, path, low, high)
        if shown is not None:
            constant, region_ = shown
            said = answer.why.partition("; ")[2] or answer.why
            why = f"|left| <= C |right| with C = {constant.high}; {where}, {said}"
            return replace(
                answer, why=why, region=region_, constant=_as_ball(constant), lemma=ELIMINATED
            )
    witness = answer.witness and _moved_witness(answer.witness, branch, name, path.name)
    return replace(
        answer,
        why=f"{where}: {answer.why}",
        witness=witness,
        region=None,
        constant=None,
        lemma=ELIMINATED,
    )


def _selected(statement: Statement, name: str, decided: Decide) -> _Alive:
    path = statement.path
    assert path is not None
    left, right = statement.equations[0]
    cases = solved(left - right, path.name, statement)
    if cases is None or any(case.integers for case in cases):
        raise _OpenError(f"the condition {left} == {right} could not be solved for {path.name}")
    low, high, others = _interval(name, statement, left - right)
    parameters = Given(
        tuple(x for x in others if not {name, path.name} & (symbols(x[0]) | symbols(x[2])))
    )
    others = [x for x in others if x not in parameters.comparisons]
    plain = replace(statement, equations=(), given=parameters)
    for end in _closed_ends(name, statement, left - right, (low, high)):
        at_end = substitute(left - right, {name: end})
        if not _holds_near_the_end((at_end, "!=", ZERO), plain, decided):
            raise _OpenError(
                f"{name} = {end} is not shown to be no root: exclude it by {name} != {end}, or by "
                "a strict condition"
            )
    found: list[tuple[_Branch, tuple[Compared, ...]]] = []
    between = Given(_links(name, low, high))
    for case in cases:
        if case.value is None or case.equations:
            squares = add(*((x - y) ** 2 for x, y in case.equations))
            apart = replace(statement, equations=(), path=None, given=parameters & between)
            if path.name in symbols(squares) or not decided(Comparison(squares, ">", ZERO), apart):
                raise _OpenError(f"where {chained_zero(case)} the equation has further solutions")
            continue
        g = tidied(case.value)
        links = tuple((e, relation, ZERO) for e, relation in needs((g, left, right)))
        for branch in _branches(g, name, low, high, path, parameters):
            found.append((branch, (*case.conditions, *links)))
    alive = []
    for branch, links in found:
        put = partial(substitute, mapping={path.name: branch.solution})
        there = Path(name, branch.point, (branch.side,))
        inside = replace(statement, equations=(), given=parameters, path=there)
        conditions = [(put(x), relation, put(y)) for x, relation, y in (*others, *links)]
        if any(_fails_near_the_end(link, inside, decided) for link in conditions):
            continue
        for link in conditions:
            if symbols(link[0] - link[2]) and not _holds_near_the_end(link, inside, decided):
                x, relation, y = link
                raise _OpenError(
                    f"the condition {x} {relation} {y} is not shown to hold near {there}"
                )
        alive.append((branch, inside, put))
    if len(alive) != 1:
        raise _OpenError(_count(len(alive), name))
    return _Alive(*alive[0], low, high, len(found) == 1 and not others)


class _Sharp(NamedTuple):
    """Bounds of a supremum: ``high`` is to be quoted."""

    low: arb
    top: arb

    @property
    def high(self) -> str:
        """The upper bound in decimal, rounded up."""
        return rounded(self.top, 1)


def _as_ball(constant: _Sharp) -> Decimal:
    return constant_ball(constant.low.union(constant.top))


def _sharp(
    claim: Comparison, statement: Statement, branch: _Branch, path: Path, low: Expr, high: Expr
) -> tuple[_Sharp, str] | None:
    """Return the constant of an order on a region of the path variable, with the region.

    It is found in the unknown, along which the claim is explicit. G must be monotone on the whole
    interval of the unknown, so that there is one root for each value of the path variable. The
    region is the image of a range of the unknown, rounded inward.
    """
    there = statement.path
    assert there is not None
    if {*_free(claim)} - {there.name} or symbols(branch.solution) != {there.name}:
        return None
    gap = branch.solution if path.point is None else branch.solution - path.point
    if path.point is not None and symbols(path.point):
        return None
    slope, inside = differentiate(branch.solution, there.name), Given(_links(there.name, low, high))
    if not {sign(slope, inside, ">="), sign(slope, inside, "<=")} & {"+", "-", ">=0", "<=0"}:
        return None
    asked = path.reach
    for n in range(1 if asked is not None else REGIONS):
        reach = asked if asked is not None else fmpq(1, 2**n)
        range_ = _range(gap, there, branch, path, reach, low, high)
        if range_ is None:
            continue
        put = {there.name: along(there, branch.side)}
        sides = substitute(claim.left, put), substitute(claim.right, put)
        found = sharp_constant(*sides, range_, 0)
        if found is None:
            continue
        least = found.low
        if found.at is not None:  # the point must lie in the region, which is rounded inward
            at = {T: arb(found.at * fmpq(9999, 10000))}
            with ball_precision(SHARP_BITS):
                least = abs(evaluate(sides[0] / sides[1], at)).lower().min(found.low)
        return _Sharp(least, found.high), region(replace(path, sides=path.sides[:1]), reach)
    return None


def _free(claim: Comparison) -> frozenset[str]:
    return symbols(claim.left) | symbols(claim.right)


def _range(
    gap: Expr, there: Path, branch: _Branch, path: Path, reach: fmpq, low: Expr, high: Expr
) -> fmpq | None:
    """Return a small parameter of the unknown up to which it must be followed to cover a region.

    At it the path variable lies at most a part in 10⁵ beyond the region.
    """
    distance = substitute(gap, {there.name: along(there, branch.side)})

    def covers(t: fmpq) -> bool | None:
        value = evaluate(distance, {T: arb(t)})
        if not value.is_finite():
            return None
        small = abs(value) if path.point is not None else 1 / abs(value)
        return bool(small >= arb(reach)) if small >= arb(reach) or small < arb(reach) else None

    with ball_precision():
        most = _longest(there, branch, low, high)
        outside = None
        for n in range(-8, 12):
            t = fmpq(1, 2) ** n
            if (most is not None and t >= most) or covers(t) is not True:
                continue
            outside = t
        if outside is None:
            return None
        inside = outside / 2
        for _ in range(RANGE_HALVINGS):
            middle = (inside + outside) / 2
            here = covers(middle)
            if here is None:
                return None
            inside, outside = (inside, middle) if here else (middle, outside)
    return outside


def _longest(there: Path, branch: _Branch, low: Expr, high: Expr) -> fmpq | None:
    """Return a bound of the small parameter of the unknown from the other end of its interval."""
    other = high if (branch.side > 0) == (there.point is not None) else low
    if other in _OPEN_ENDS:
        return None
    end = _number(other).mid().fmpq()
    if there.point is None:
        return None if end * branch.side <= 0 else 1 / abs(end)
    return abs(end - _number(there.point).mid().fmpq())


def _at_zero(
    claim: Comparison, statement: Statement, name: str
) -> tuple[Comparison, Statement] | None:
    """Return the claim with angles near multiples of π/2 written as small angles.

    The variable becomes its distance from the end of the path. None if there are no such angles.
    """
    path = statement.path
    assert path is not None
    turns = [node for node in operations((claim.left, claim.right)) if node.op in _QUARTERS]
    if path.point is None or not turns or symbols(path.point) or path.point == ZERO:
        return None
    put = {name: path.point + path.sides[0] * symbol(name)}

    def change(e: Expr) -> Expr:
        return _collected(_turned(substitute(e, put), name, path.sides[0]))

    there = replace(path, point=ZERO, sides=(1,))
    return claim.mapped(change), replace(statement, path=there)


def _turned(e: Expr, name: str, side: int = 1) -> Expr:
    """Return ``e`` without quarter turns in its angles, and with odd functions of −x as of x."""
    known: dict[Expr, Expr] = {}
    for node in operations((e,)):
        if node.op not in _QUARTERS or name not in symbols(node):
            continue
        start = _normal(substitute(node.args[0], {name: ZERO}))
        quarters = integer(_normal(2 * start / PI))
        if quarters is None:
            continue
        sign_, op = _QUARTERS[node.op][quarters % 4]
        rest = tidied(_normal(node.args[0] - start))
        if side < 0:
            rest, sign_ = -rest, sign_ if op == "cos" else -sign_
        known[node] = sign_ * apply(op, tidied(_normal(rest)))
    return replaced(e, known)


def _collected(e: Expr) -> Expr:
    """Return the normal form of ``e`` as a rational function of its sines, cosines and the like."""
    nodes = [node for node in operations((e,)) if node.op in _QUARTERS]
    marks = {node: symbol(f"[{k}]") for k, node in enumerate(nodes)}
    form = normal_form(replaced(e, marks), Given())
    return substitute(form, {str(mark): node for node, mark in marks.items()})


_QUARTERS: dict[str, tuple[tuple[int, str], ...]] = {
    "sin": ((1, "sin"), (1, "cos"), (-1, "sin"), (-1, "cos")),
    "cos": ((1, "cos"), (-1, "sin"), (-1, "cos"), (1, "sin")),
    "tan": ((1, "tan"), (-1, "cot")) * 2,
    "cot": ((1, "cot"), (-1, "tan")) * 2,
}
"""What a function becomes if a number of quarter turns is taken from its angle."""


def _moved_witness(
    witness: Mapping[str, str], branch: _Branch, name: str, along: str
) -> dict[str, str]:
    """Return a witness with the value of the path variable beside that of the unknown."""
    try:
        point = {n: parse(text) for n, text in witness.items()}
    except InputError:
        return dict(witness)
    if name not in point:
        return dict(witness)
    value = tidied(substitute(branch.solution, point))
    return dict(witness) | {along: exact_text(value)}


def _interval(name: str, statement: Statement, equation: Expr) -> tuple[Expr, Expr, list[Compared]]:
    """Return the ends between which constant conditions keep the unknown, and the other ones."""
    path = statement.path
    assert path is not None
    ends: dict[int, list[Expr]] = {-1: [], 1: []}
    others: list[Compared] = []
    domain = [bound(*part) for part in needs((equation,)) if symbols(part[0]) == {name}]
    for link in (*statement.given.comparisons, *domain):
        left, relation, right = link
        gap = left - right
        slope = tidied(differentiate(gap, name))
        rest = substitute(gap, {name: ZERO})
        if slope.op == "number" and slope != ZERO and not symbols(rest) and relation != "!=":
            above = (relation[0] == ">") == (slope.args[0] > 0)
            ends[-1 if above else 1].append(tidied(_normal(-rest / slope)))
        else:
            others.append(link)
    return (
        _outermost(ends[-1], 1) if ends[-1] else -INFINITY,
        _outermost(ends[1], -1) if ends[1] else INFINITY,
        others,
    )


def _closed_ends(
    name: str, statement: Statement, equation: Expr, ends: tuple[Expr, Expr]
) -> list[Expr]:
    """Return the finite ends of the interval that the conditions do not exclude."""
    found = [end for end in ends if end not in _OPEN_ENDS]
    domain = [bound(*part) for part in needs((equation,)) if symbols(part[0]) == {name}]
    for left, relation, right in (*statement.given.comparisons, *domain):
        if relation not in (">", "<", "!="):
            continue
        gap = left - right
        if symbols(gap) == {name}:
            found = [e for e in found if not is_zero(substitute(gap, {name: e}), Given())]
    return found


def _outermost(values: list[Expr], sign_: int) -> Expr:
    return max(values, key=lambda e: sign_ * float(_number(e).mid()))


def _number(e: Expr) -> arb:
    with ball_precision(200):
        if e in _OPEN_ENDS:
            return arb("inf") if e == INFINITY else -arb("inf")
        found = evaluate(e, {})
    if not found.is_finite():
        raise _OpenError(f"{e} could not be evaluated")
    return found


def _branches(
    g: Expr, name: str, low: Expr, high: Expr, path: Path, parameters: Given
) -> Iterator[_Branch]:
    """Yield the ways in which y in (low, high) can move so that G(y) tends to the path's end.

    Raises:
        _OpenError: it is not shown where G is monotone.
    """
    if jumps(g):
        raise _OpenError(f"{g} has jumps")
    side = path.sides[0]
    end = side * INFINITY if path.point is None else path.point
    gap = g if path.point is None else g - path.point
    slope = differentiate(g, name)
    breaks: list[Expr] = []
    zeros = [gap, slope] if path.point is not None else [slope]
    poles = [e for e, relation in needs((g,)) if name in symbols(e) and relation != ">="]
    for e in (*zeros, *poles):
        breaks += _zeros(e, name, parameters)
    breaks += _turning_points(slope, name, low, high)
    for e in (*poles, *zeros[:-1]):
        breaks += _recognised(e, name, low, high)
    inner = _sorted(breaks, low, high)
    for first, last in pairwise([low, *inner, high]):
        yield from _on_part(g, gap, slope, name, (first, last), end, side, parameters)


def _zeros(e: Expr, name: str, parameters: Given) -> list[Expr]:
    """Return exact zeros of ``e`` that are numbers, as far as they are found."""
    from tresym.reals.normal.to_expression import in_lowest_terms

    empty = Statement((), parameters, None, "")
    found: list[Expr] = []
    try:
        parts = [e, in_lowest_terms(normal_form(e, Given()))]
    except InputError:
        parts = [e]
    for part in parts:
        factors = factors_in(part)
        for factor in factors:
            if name not in symbols(factor):
                continue
            cases = solved(factor, name, empty)
            values = (case.value for case in cases or ())
            found += [e for e in values if e is not None and not symbols(e)]
            found += _polynomial_zeros(factor, name)
    return found


def zeros_of(e: Expr, name: str, given: Given) -> list[Expr]:
    """Return exact zeros of a function in their order, as far as they are found."""
    try:
        return _sorted(_zeros(e, name, given), -INFINITY, INFINITY)
    except _OpenError:
        return []


def _polynomial_zeros(e: Expr, name: str) -> list[Expr]:
    """Return the rational zeros of a polynomial over the rationals, and real roots of numbers."""
    if symbols(e) != {name} or any(
        op.op not in ("+", "*", "^") or (op.op == "^" and (integer(op.args[1]) or -1) < 0)
        for op in operations((e,))
    ):
        return []
    coefficients: list[fmpq] = []
    factorial = fmpq(1)
    for k in range(MOST_DEGREE + 1):
        at_zero = _normal(substitute(e, {name: ZERO}))
        if at_zero.op != "number":
            return []
        coefficients.append(at_zero.args[0] / factorial)
        e, factorial = tidied(differentiate(e, name)), factorial * (k + 1)
    if not is_zero(e, Given()):
        return []
    _, factors = fmpq_poly(coefficients).numer().factor()
    found: list[Expr] = []
    for factor, _ in factors:
        c = [fmpq(int(x)) for x in factor.coeffs()]
        if len(c) == 2:
            found.append(number(-c[0] / c[1]))
        elif len(c) % 2 == 0 and not any(c[1:-1]):  # one real root, of odd order
            r = -c[0] / c[-1]
            root = number(abs(r)) ** number(fmpq(1, len(c) - 1))
            found.append(root if r > 0 else -root)
    return found


def _recognised(e: Expr, name: str, low: Expr, high: Expr) -> list[Expr]:
    """Return simple zeros near the changes of sign on a grid: fractions, and those of π."""
    found = []
    for near in _changes(e, name, low, high):
        with ball_precision():
            x = arb((near[0] + near[1]) / 2)
            for unit, value in ((ONE, arb(1)), (PI, arb.pi())):
                for q in range(1, 13):
                    p = int(float((x * q / value).mid()) // 1)
                    tried = [number(fmpq(k, q)) * unit for k in (p, p + 1)]
                    close = [t for t in tried if abs(evaluate(t, {}) - x) < CLOSE]
                    found += [t for t in close if is_zero(substitute(e, {name: t}), Given())]
    return found


def _links(name: str, low: Expr, high: Expr) -> tuple[Compared, ...]:
    """Return the conditions that the unknown lies between its ends."""
    y = symbol(name)
    first: tuple[Compared, ...] = () if low in _OPEN_ENDS else ((y, ">", low),)
    return first if high in _OPEN_ENDS else (*first, (y, "<", high))


def _turning_points(slope: Expr, name: str, low: Expr, high: Expr) -> list[Expr]:
    """Return rational points around each change of sign of the slope that a grid shows.

    Nothing is proved here; between the two points G is evaluated in balls.
    """
    return [number(x) for pair in _changes(slope, name, low, high) for x in pair]


def _changes(e: Expr, name: str, low: Expr, high: Expr) -> list[tuple[fmpq, fmpq]]:
    """Return short intervals between whose ends a function of one variable changes its sign."""
    if symbols(e) != {name}:
        return []
    found = []
    with ball_precision():

        def sign_at(x: fmpq) -> int | None:
            value = evaluate(e, {name: x})
            return 1 if value > 0 else -1 if value < 0 else None

        for a, b in pairwise(_grid(low, high)):
            signs = sign_at(a), sign_at(b)
            if None in signs or signs[0] == signs[1]:
                continue
            for _ in range(HALVINGS):
                middle = (a + b) / 2
                here = sign_at(middle)
                if here is None:
                    break
                a, b = (middle, b) if here == signs[0] else (a, middle)
            found.append((a, b))
    return found


def _grid(low: Expr, high: Expr) -> list[fmpq]:
    """Return rational points between the ends, crowded at finite ones."""
    odd = fmpq(1013, 1000)  # so that simple zeros are not hit exactly
    steps = [fmpq(k, 24) * odd for k in range(1, 24)]
    near = [odd / 2**k for k in range(2, 12)]
    if low in _OPEN_ENDS and high in _OPEN_ENDS:
        far = [odd * fmpq(2) ** k for k in range(-4, 8)]
        return [*(-x for x in far[::-1]), fmpq(1, 1000), *far]
    if low in _OPEN_ENDS or high in _OPEN_ENDS:
        start = _rounded(high if low in _OPEN_ENDS else low)
        side = -1 if low in _OPEN_ENDS else 1
        points = [
            start + side * x for x in [*near[::-1], *(odd * fmpq(2) ** k for k in range(-1, 8))]
        ]
        return sorted(points)
    first, last = _rounded(low), _rounded(high)
    parts = sorted({*steps, *near, *(1 - x for x in near)})
    return [first + (last - first) * x for x in parts]


def _rounded(e: Expr) -> fmpq:
    """Return a number to 20 binary places."""
    return fmpq(int(float(_number(e).mid()) * 2**20), 2**20)


def _sorted(breaks: list[Expr], low: Expr, high: Expr) -> list[Expr]:
    """Return the points between the ends in their order, each once."""
    first, last = _number(low), _number(high)
    points: list[tuple[arb, Expr]] = []
    for e in breaks:
        try:
            x = _number(e)
        except _OpenError:
            continue
        inside = (low in _OPEN_ENDS or x > first) and (high in _OPEN_ENDS or x < last)
        if inside and not any(x.overlaps(y) for y, _ in points):
            points.append((x, _simple(e)))
    return [e for _, e in sorted(points, key=lambda item: float(item[0].mid()))]


def _simple(e: Expr) -> Expr:
    return normal_form(e, Given())


def _on_part(
    g: Expr,
    gap: Expr,
    slope: Expr,
    name: str,
    ends: tuple[Expr, Expr],
    end: Expr,
    side: int,
    parameters: Given,
) -> Iterator[_Branch]:
    """Yield the branches in one part, on which G has no pole and its slope no zero if all is well.

    Between two breaks nothing is assumed: it is proved that G stays away from the end of the path,
    or that it is smooth and strictly monotone.
    """
    low, high = ends
    inside = parameters & Given(_links(name, low, high))
    for e, relation in needs((g,)):
        if relation in (">", ">=") and sign(e, inside, "<") == "-":
            return  # G is not real here
    if continuous_on(g, inside, proof) is not None:
        raise _OpenError(f"{g} is not shown to be smooth for {inside or 'all ' + name}")
    if low not in _OPEN_ENDS and high not in _OPEN_ENDS and symbols(g) == {name}:
        with ball_precision():
            values = evaluate(gap, {name: _number(low).union(_number(high))})
        if values.is_finite() and (end in _OPEN_ENDS or not values.contains(0)):
            return  # G stays away from the end of the path
    against = sign(side * gap, inside, "<=")
    if against in ("-", "<=0", "0"):
        return
    # The zeros of the slope of an analytic function that is not constant are isolated.
    found = sign(slope, inside, ">=")
    rising = 1 if found in ("+", ">=0") else 0
    if not rising and sign(slope, inside, "<=") in ("-", "<=0"):
        rising = -1
    if not rising:
        raise _OpenError(f"{g} is not shown to be monotone for {inside or 'all ' + name}")
    positions = []
    for place, toward in ((low, 1), (high, -1)):
        point = None if place in _OPEN_ENDS else place
        direction = toward if point is not None else -toward
        limit = limit_of(g, name, point, direction, parameters)
        if limit is None:
            raise _OpenError(f"the limit of {g} as {name} -> {place} is not known")
        positions.append(_position(limit, end, parameters))
        # G moves away from the end of the path with growing distance from ``place``.
        if positions[-1] == 0 and (end in _OPEN_ENDS or rising * toward == side):
            yield _Branch(g, point, direction)
    if sorted(positions) == [-1, 1]:
        raise _OpenError(
            f"{g} takes the value {end} inside {inside or 'all ' + name}, and the root there is "
            "not known exactly"
        )


def _position(limit: Expr, end: Expr, parameters: Given) -> int:
    """Return −1, 0 or 1 as a limit is below, at or above the end of the path.

    Raises:
        _OpenError: the two could not be told apart.
    """
    if limit in _OPEN_ENDS or end in _OPEN_ENDS:
        first, last = (_rank(e) for e in (limit, end))
        return (first > last) - (first < last)
    if is_zero(limit - end, parameters):
        return 0
    found = sign(limit - end, parameters, ">")
    if found == "+":
        return 1
    if sign(limit - end, parameters, "<") == "-":
        return -1
    raise _OpenError(f"{limit} and {end} could not be told apart")


def _rank(e: Expr) -> int:
    return _OPEN_ENDS[::-1].index(e) * 2 if e in _OPEN_ENDS else 1


# Residual


def _by_residual(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer:
    """Decide a claim y − A = O(g), o(g) by the residual F(A) and a bound of the slope."""
    path = statement.path
    assert path is not None
    left, right = statement.equations[0]
    f = left - right
    if claim.relation == LIMIT:
        claim = Comparison(claim.left - claim.right, "o", ONE)
    if claim.relation == "~":
        claim = Comparison(claim.left - claim.right, "o", claim.right)
    factor = differentiate(claim.left, name)
    if claim.relation not in ("O", "o") or factor.op != "number" or factor == ZERO:
        raise _OpenError(
            f"the claim is not of the form {name} == A + O(g), and the equation could not be "
            f"solved for {path.name}"
        )
    if name in symbols(claim.right):
        raise _OpenError(f"the comparison function contains {name}")
    a = tidied(-substitute(claim.left, {name: ZERO}) / factor)
    if jumps(f):
        raise _OpenError("the equation has jumps")
    low, high, others = _interval(name, statement, f)
    if any(name in symbols(x[0]) | symbols(x[2]) for x in others):
        raise _OpenError(f"the conditions do not keep {name} in a constant interval")
    links = _links(name, low, high)
    plain = [x for x in others if path.name not in symbols(x[0]) | symbols(x[2])]
    beside = [x for x in others if x not in plain]
    rest = replace(statement, equations=(), given=Given(tuple(plain)))
    for link in beside:
        if not _holds_near_the_end(link, rest, decided):
            raise _OpenError("a condition is not shown to hold near the end of the path")
    slope = differentiate(f, name)
    side, least, most, where = _slope_bounds(slope, rest, links, decided)
    for end, relation in ((low, ">"), (high, "<")):
        if end in _OPEN_ENDS:
            continue
        at_end = side * substitute(f, {name: end})
        opposite = "<" if relation == ">" else ">"
        if not _holds_near_the_end((a, relation, end), rest, decided) or not _holds_near_the_end(
            (at_end, opposite, ZERO), rest, decided
        ):
            raise _OpenError(f"it is not shown that a root lies on the inner side of {end}")
    residual = tidied(substitute(f, {name: a}))
    found = decided(Comparison(residual, claim.relation, claim.right), rest)
    said = f"the slope of the equation is at least {least} where {where}, and its value at {a}"
    if found:
        return replace(
            found, why=f"{said}: {found.why}", region=None, constant=None, lemma=RESIDUAL
        )
    if found.verdict is Verdict.REFUTED and most is not None:
        return replace(found, why=f"{said}: {found.why}", lemma=RESIDUAL, values=None)
    raise _OpenError(f"the value of the equation at {a} does not decide the claim: {found.why}")


def _by_tube(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer:
    """Decide any claim about a root near an approximation that the claim states or implies."""
    path = statement.path
    assert path is not None
    equations, rest = _tube_equations(statement, name, decided)
    why = f"no approximation of {name} was found"
    for equation in equations:
        for start in (*starts(claim, name), *_at_the_end(equation)):
            root = {symbol(name): Root(equation, start)}
            found = decide_with_expansions(claim, rest, decided, root)
            if found.verdict is not Verdict.UNDECIDED:
                return replace(found, region=None, constant=None)
            why = found.why
    raise _OpenError(why)


def _tube_equations(
    statement: Statement, name: str, decided: Decide
) -> tuple[Iterator[Equation], Statement]:
    """Return equations with the same root, and the statement without what determines it."""
    path = statement.path
    assert path is not None
    left, right = statement.equations[0]
    if jumps(left - right):
        raise _OpenError("the equation has jumps")
    low, high, _ = _interval(name, statement, left - right)
    links = conditions_of(left - right, name, statement.given.comparisons)
    others = [x for x in statement.given.comparisons if x not in links]
    moving = [x for x in others if path.name in symbols(x[0]) | symbols(x[2])]
    fixed = Given(tuple(x for x in others if x not in moving))
    rest = replace(statement, equations=(), given=fixed)
    if not all(_holds_near_the_end(link, rest, decided) for link in moving):
        raise _OpenError("a condition is not shown to hold near the end of the path")
    for edge in _closed_ends(name, statement, left - right, (low, high)):
        at_end = substitute(left - right, {name: edge})
        if not _holds_near_the_end((at_end, "!=", ZERO), rest, decided):
            raise _OpenError(f"{name} = {edge} is not shown to be no root")
    taken = symbols(left - right) | statement.given.names
    end = End(path.name, path.point, path.sides[0], fixed, taken)

    def found() -> Iterator[Equation]:
        for f, positive in forms(left, right, name):
            equation = Equation(name, f, end, (low, high), links, (rest, decided))
            if all(map(equation.is_positive, positive)):
                yield equation

    return found(), rest


def roots_near(statement: Statement, decided: Decide) -> Iterator[Root]:
    """Yield what may be expansions of the root that a statement determines; nothing is proved."""
    path = statement.path
    assert path is not None
    try:
        _, statement = _with_explicit(Comparison(ZERO, "==", ZERO), statement)
        if len(statement.equations) != 1:
            return
        name = _unknown(Comparison(ZERO, "==", ZERO), statement)
        x = symbol(path.name)
        large = path.sides[0] * x if path.point is None else 1 / (path.sides[0] * (x - path.point))
        for equation in _tube_equations(statement, name, decided)[0]:
            for start in (*_at_the_end(equation), ONE, apply("log", large), large, 1 / large):
                if not _excluded(equation, start):
                    yield Root(equation, start)
    except _OpenError:
        return


def _excluded(here: Equation, start: Expr) -> bool:
    """Return whether a value of the unknown violates a condition near the end of the path."""
    end = here.end
    for left, relation, right in here.links:
        gap = substitute(left - right, {here.name: start})
        found = leading_sign(gap, end.name, end.point, end.side, end.given)
        if found is not None and found * (1 if relation[0] == ">" else -1) < 0:
            return relation != "!="
    return False


def _at_the_end(here: Equation) -> Iterator[Expr]:
    """Yield the roots of the equation in the limit, where they are found exactly."""
    end, low, high = here.end, here.low, here.high
    limit = end.limit(here.f)
    if limit is None or limit in _OPEN_ENDS:
        return
    for zero in _zeros(limit, here.name, end.given):
        inside = all(
            sign(side * (zero - e), end.given, ">=") in ("+", ">=0", "0")
            for side, e in ((1, low), (-1, high))
            if e not in _OPEN_ENDS
        )
        if inside:
            yield zero


def _of_two(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about the root of two equations for two unknowns."""
    path = statement.path
    assert path is not None
    trees = [e for pair in statement.equations for e in pair]
    names = sorted(frozenset().union(*map(symbols, trees)) - {path.name})
    if len(names) != 2 or len(statement.equations) != 2 or statement.integers:
        raise _OpenError("no equation could be solved for one of its unknowns")
    f = tuple(left - right for left, right in statement.equations)
    if any(map(jumps, f)):
        raise _OpenError("the equations have jumps")
    one, two = names
    intervals = []
    for name in names:
        inner = statement.given.comparisons
        links = tuple(x for x in inner if symbols(x[0]) | symbols(x[2]) == {name})
        low, high, _ = _interval(name, replace(statement, given=Given(links)), ZERO)
        intervals.append((low, high))
    domain = tuple(bound(*part) for part in needs(f) if {*names} & symbols(part[0]))
    links = (*statement.given.comparisons, *domain)
    links = tuple(x for x in links if {*names} & (symbols(x[0]) | symbols(x[2])))
    others = [x for x in statement.given.comparisons if x not in links]
    if any(path.name in symbols(x[0]) | symbols(x[2]) for x in others):
        raise _OpenError(f"conditions on {path.name} beside two equations are not supported")
    fixed = Given(tuple(others))
    rest = replace(statement, equations=(), given=fixed)
    end = End(path.name, path.point, path.sides[0], fixed, frozenset((*names, path.name)))
    why = "no root of the two equations in the limit was found"
    pair = system_of(
        (f[0], f[1]), (one, two), end, (intervals[0], intervals[1]), links, (rest, decided)
    )
    for start in starts_of((f[0], f[1]), (one, two), end, zeros_of):
        system = System(pair, start)
        known = {symbol(name): Component(system, k) for k, name in enumerate(names)}
        found = decide_with_expansions(claim, rest, decided, known)
        if found.verdict is not Verdict.UNDECIDED:
            return replace(found, region=None, constant=None)
        why = found.why
    raise _OpenError(why)


def _slope_bounds(
    slope: Expr, statement: Statement, links: tuple[Compared, ...], decided: Decide
) -> tuple[int, Expr, Expr | None, str]:
    """Return the sign of the slope, a positive lower bound of its size, and an upper one if known.

    They hold on a neighbourhood of the end of the path, for all values of the unknown and of the
    parameters.
    """
    from tresym.asymptotics.path_claims import neighbourhood

    path = statement.path
    assert path is not None
    names = sorted(symbols(slope) | {path.name})
    for far in FAR:
        near = neighbourhood(path, path.sides[0], number(far))
        inside = statement.given & Given(links) & near
        values = []
        with ball_precision():
            for point in inside.points(names, SAMPLES):
                value = evaluate(slope, point)
                if value.is_finite() and abs(value) < LARGE:
                    values.append(float(value.mid()))
        if not values or min(values) <= 0 <= max(values):
            continue
        side = 1 if values[0] > 0 else -1
        least = number(fmpq(int(500 * min(map(abs, values))) or 1, 1000))
        there = replace(statement, path=None, given=inside)
        apart = [op for op in operations((slope,)) if op.op not in ("+", "*", "^")]
        if len(apart) > MOST_FUNCTIONS:  # a decomposition in many variables takes too long
            if sign(side * slope - least, inside, ">=", dear=False) in ("+", ">=0"):
                return side, least, None, str(near)
            continue
        if decided(Comparison(side * slope, ">=", least), there):
            most = number(fmpq(int(2000 * max(map(abs, values))) + 1, 1000))
            above = bool(decided(Comparison(side * slope, "<=", most), there))
            return side, least, most if above else None, str(near)
    raise _OpenError(
        "no positive lower bound of the slope of the equation was found where the conditions hold"
    )
