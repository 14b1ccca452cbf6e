"""Claims along a path: limits, orders, and what holds eventually.

``f -> L`` means ``f - L == o(1)``, and ``f -> oo`` means ``exp(-f) == o(1)``; on a two-sided path
both one-sided claims are made. ``f == Theta(g)`` is ``f == O(g)`` and ``g == O(f)``, and
``f == omega(g)`` is ``g == o(f)``. A claim with parameters is made for each value that the
conditions allow, without uniformity. It is proved by the exact limit of the ratio or difference
(limit_values.py), and refuted at values of the parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import chain, islice

from flint import arb, fmpq

from tresym.asymptotics.order_claims import decide_order, region
from tresym.asymptotics.periodic_counterexamples import failure_where_waves_return
from tresym.reals.decisions.answer import Answer, Decide, exact_text, worst
from tresym.reals.decisions.derivative_domains import where_real
from tresym.reals.decisions.equations import is_empty
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.inequalities_on_regions import is_isolated
from tresym.reals.decisions.integer_variables import (
    PERIODIC,
    decide_whole,
    residues,
    with_integer_bounds,
)
from tresym.reals.decisions.readable_witnesses import decided_at, simple_points
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.operation_domains import needs, operations
from tresym.reals.domain.sample_points import corners
from tresym.reals.expansions.leading_terms import leading_sign, sign_towards
from tresym.reals.expansions.limit_values import limit_of, stays_bounded
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    fresh,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

PARAMETERS = 6
"""Values of the parameters at which a refutation is looked for."""
FAR = (1, 10, 1000)
"""From where on an inequality is asked."""
MOST_ENDS = 40
"""Corners of the parameters' ranges that are looked at."""
MOST_SPLIT = 2
"""Parameters of which the signs are told apart."""
Same = Callable[[Expr, Expr], bool]
_EXACT = "computed exactly from leading terms"
_OPEN = (
    "the leading term does not decide the claim for all values "
    "of the parameters; a condition on their signs may help"
)


def decide_tending(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim along the path of the statement.

    Args:
        decided: decides what is no claim along a path.
    """
    path = statement.path
    if path is None:
        raise TypeError("a claim along a path needs its path")
    if statement.integers:
        return _among_integers(claim, path, statement, decided)
    path = _where_defined(claim, path, statement.given)
    if not path.sides:
        return Answer(
            Verdict.UNDECIDED,
            "the two sides are not real near the end of the path, so there is nothing to prove",
        )
    statement = replace(statement, path=path)
    if _parameters(claim, path):
        return _with_parameters(claim, path, statement, decided)
    if claim.relation == LIMIT:
        return _limit(claim, path)
    if claim.relation == "Theta":
        return _theta(claim, path)
    if claim.relation == "omega":
        found = decide_order(_order(claim, claim.right, "o", claim.left), path)
        return replace(found, why=f"with the two sides exchanged: {found.why}")
    if claim.relation == "o":
        return _exactly(decide_order(claim, path), claim, path)
    if claim.relation in ("O", "~"):
        return decide_order(claim, path)
    if claim.derivatives and where_real(Given(), claim.differentiated, claim.by)[0] != Given():
        return Answer(
            Verdict.UNDECIDED,
            "the differentiated functions are not real everywhere, and this case is not supported",
        )
    return _eventually(claim, path, statement, decided)


def _exactly(found: Answer, claim: Comparison, path: Path) -> Answer:
    """Return the answer to ``f == o(g)``, PROVED where the limit 0 of f/g is computed exactly."""
    exact = _by_exact_limit(claim, path, Given()) if found.verdict is Verdict.ENCLOSED else None
    if exact is None or claim.derivatives:
        return found
    return replace(found, verdict=Verdict.PROVED, why=f"{found.why} ({_EXACT})")


def _where_defined(claim: Comparison, path: Path, given: Given) -> Path:
    """Return the path without the sides on which the claim is proved not to be real.

    A power with a variable as exponent may have one also where its base is negative.
    """
    if len(path.sides) == 1:
        return path
    sides = [e for e in (claim.left, claim.right) if e not in (INFINITY, -INFINITY)]
    parts = needs(sides, powers=False)

    def is_real(side: int) -> bool:
        for e, relation in parts:
            found = leading_sign(e, path.name, path.point, side, given)
            if found is not None and not stands(arb(found), relation):
                return False
        return True

    return replace(path, sides=tuple(side for side in path.sides if is_real(side)))


def _parameters(claim: Comparison, path: Path) -> list[str]:
    found = symbols(claim.left) | symbols(claim.right) - {INFINITY.args[0]}
    found |= frozenset() if path.point is None else symbols(path.point)
    return sorted(found - {path.name})


def _order(claim: Comparison, left: Expr, relation: str, right: Expr) -> Comparison:
    return replace(claim, left=left, relation=relation, right=right)


def _limit(claim: Comparison, path: Path) -> Answer:
    f, end = claim.left, claim.right
    infinite = end in (INFINITY, -INFINITY)
    if not claim.derivatives:
        found = [limit_of(f, path.name, path.point, side, Given()) for side in path.sides]
        if all(value is not None and _are_equal(value, end, Given()) for value in found):
            return Answer(Verdict.PROVED, f"the left side tends to {end}, {_EXACT}")
    if not infinite:
        answer = decide_order(_order(claim, f - end, "o", ONE), path)
        said = "left is the left side minus the limit and right is 1"
    else:
        answer = decide_order(_order(claim, ONE, "o", f), path)
        said = "left is 1 and right is the left side"
        if answer.verdict is not Verdict.REFUTED:
            toward = apply("exp", -f if end == INFINITY else f)
            answer = decide_order(_order(claim, toward, "o", ONE), path)
            said = f"left is {toward} and right is 1"
    if answer.verdict is Verdict.ENCLOSED:
        return replace(answer, why=f"the left side tends to {end}")
    if answer.verdict is Verdict.REFUTED:
        return replace(
            answer,
            why=f"the left side does not tend to {end}: {answer.why}, where {said}",
            values=None,
        )
    return answer


def _are_equal(value: Expr, end: Expr, given: Given, same: Same | None = None) -> bool:
    infinite = (INFINITY, -INFINITY)
    if value in infinite or end in infinite:
        return value == end
    if same is not None:
        return same(value, end)
    return decide(value, end, given).verdict is Verdict.PROVED


def _theta(claim: Comparison, path: Path) -> Answer:
    above = decide_order(replace(claim, relation="O"), path)
    if above.verdict is not Verdict.ENCLOSED:
        return above
    below = decide_order(_order(claim, claim.right, "O", claim.left), path)
    if below.verdict is not Verdict.ENCLOSED:
        return replace(below, why=f"with the two sides exchanged: {below.why}")
    return replace(above, why=f"{above.why}; and with the two sides exchanged: {below.why}")


def _with_parameters(
    claim: Comparison, path: Path, statement: Statement, decided: Decide
) -> Answer:
    given = statement.given
    names = sorted({*_parameters(claim, path), *given.names})
    if given.satisfying_point(names) is None:
        return Answer(
            Verdict.UNDECIDED,
            "no values of the parameters were found that satisfy the "
            "conditions; check the conditions",
        )
    simple = simple_points(names, given, PARAMETERS)
    points = (*simple, *_at_ends(claim, path, names, given))
    exact = ({name: number(value) for name, value in at.items()} for at in points)
    found, _ = decided_at(exact, claim, statement, partial(decide_tending, decided=decided))
    if found is not None:
        return found
    inside, _ = where_real(given, claim.differentiated, claim.by)
    if claim.derivatives and inside != given:
        return Answer(Verdict.UNDECIDED, _OPEN)
    return (
        _by_exact_limit(claim, path, given)
        or _by_signs(claim, path, given)
        or _from_somewhere_on(claim, path, statement, decided)
    )


def _with_zeros(names: list[str]) -> Iterator[dict[str, fmpq]]:
    """Values of the parameters of which all, or one, are 0."""
    yield dict.fromkeys(names, fmpq(0))
    for zero in names if len(names) > 1 else ():
        yield {name: fmpq(2 * (name != zero)) for name in names}


# Integers


def _among_integers(claim: Comparison, path: Path, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim in which the variable of the path, or parameters, are integers."""
    if path.name in statement.integers:
        return _through_integers(claim, path, statement, decided)
    given = with_integer_bounds(statement.given, statement.integers)
    statement = replace(statement, given=given)
    names = sorted({*_parameters(claim, path), *given.names})
    if simple_points(names, given, 1, statement.integers):
        exact = _by_residues(claim, statement, decided)
        if exact is not None:
            return exact
    return decide_whole(claim, statement, decided)


def _by_residues(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """The claim by exact limits, for every residue of the parameters that are integers."""
    trees = [claim.left, claim.right, *claim.differentiated, *statement.said]
    names = [n for n in statement.integers if any(n in symbols(e) for e in trees)]
    found = None
    for case, inside in residues(claim, statement, names, statement.given) or ():
        assert inside.path is not None

        def same(left: Expr, right: Expr, there: Statement = inside) -> bool:
            return bool(decided(Comparison(left, "==", right), replace(there, path=None)))

        found = _by_exact_limit(case, inside.path, inside.given, same)
        if found is None:
            return None
    return found


def _through_integers(
    claim: Comparison, path: Path, statement: Statement, decided: Decide
) -> Answer:
    """A claim on the integers n → ±∞: of every residue of n, for real values of what remains.

    A refutation for real values is one for integers if it is by leading terms, without waves.
    """
    name, plain = path.name, tuple(n for n in statement.integers if n != path.name)
    far = statement.given & Given(((path.sides[0] * symbol(name), ">=", ONE),))
    cases = residues(claim, statement, (name,), far)
    if cases is None:
        return Answer(
            Verdict.UNDECIDED,
            "the claim could not be reduced to finitely many residue classes of the integers",
        )
    answers = []
    for rest, (moved, _) in enumerate(cases):
        new, which = symbol(name), f"integers {name}"
        if len(cases) > 1:  # n = M m + r, and what is said of m must not be read as said of n
            new = symbol(fresh("m", {name, *statement.given.names, *_parameters(claim, path)}))
            which = f"{name} = {number(len(cases)) * new + number(rest)}, integers {new}"
        along, put_in = replace(path, name=new.args[0]), partial(substitute, mapping={name: new})
        inside = replace(statement.mapped(put_in), integers=plain, path=along)
        found = decided(moved.mapped(put_in), inside)
        if found.verdict is Verdict.REFUTED:
            there = far.mapped(put_in)
            found = _at_integers(found, moved.mapped(put_in), along, len(cases), rest, there)
            at = {name if n == along.name else n: v for n, v in (found.witness or {}).items()}
            found = replace(found, witness=at)
        found = replace(found, why=f"for {which}: {found.why}", region=None, constant=None)
        answers.append(found)
        if not found:
            break
    weakest = worst(answers)
    if weakest and len(cases) > 1:
        why = f"in each residue class of {name} modulo {len(cases)}; {weakest.why}"
        return replace(weakest, why=why)
    return weakest


def _at_integers(
    found: Answer, claim: Comparison, path: Path, period: int, rest: int, given: Given
) -> Answer:
    """The refutation of a residue as one at integers; UNDECIDED if it may be one at a phase."""
    waves = (node for node in operations((claim.left, claim.right)) if node.op in PERIODIC)
    phases = (node.args[0] for node in waves if path.name in symbols(node))
    ends = (limit_of(phase, path.name, path.point, path.sides[0], given) for phase in phases)
    if any(end is None or end in (INFINITY, -INFINITY) for end in ends):
        return Answer(
            Verdict.UNDECIDED, f"undecided for integers; it is false for real values: {found.why}"
        )
    witness = dict(found.witness or {})
    value = witness.get(path.name, "")
    if value.lstrip("-").isdecimal():
        witness[path.name] = str(period * int(value) + rest)
    return replace(found, witness=witness, values=None)


def _at_ends(
    claim: Comparison, path: Path, names: list[str], given: Given
) -> Iterator[dict[str, fmpq]]:
    """Values of the parameters that satisfy a condition by equality, as 0 does ``a >= 0``, and 0.

    Left out are those beside which no side is defined: no claim speaks of them.
    """
    step = number(fmpq(path.sides[0], FAR[-1]))
    at_ends = islice(corners(names, given.box), MOST_ENDS) if given.comparisons else ()
    for at in chain(at_ends, _with_zeros(names)):
        with ball_precision():
            if not all(c.holds_exactly(at) for c in given.conditions):
                continue
            beside = {name: arb(value) for name, value in at.items()}
            beside[path.name] = evaluate(1 / step if path.point is None else path.point + step, at)
        sides = (claim.left, ONE if claim.right in (INFINITY, -INFINITY) else claim.right)
        if not is_isolated(beside, sides):
            yield at


def compared_of(claim: Comparison) -> tuple[Expr, str]:
    """Return the expression whose limit decides the claim, and a phrase for it."""
    left, right = claim.left, claim.right
    if claim.relation == LIMIT:
        return left, "left side"
    if claim.relation == "omega":
        return right / left, "ratio right/left"
    if claim.relation in ("O", "o", "~", "Theta"):
        return left / right, "ratio left/right"
    return left - right, "difference left - right"


def _by_exact_limit(
    claim: Comparison, path: Path, given: Given, same: Same | None = None
) -> Answer | None:
    """Prove the claim by the exact limit of a side, of the ratio, or of the difference.

    Args:
        same: decides whether two constants are equal; by the conditions alone unless told.
    """
    compared, what = compared_of(claim)
    right, relation = claim.right, claim.relation
    found = [limit_of(compared, path.name, path.point, side, given) for side in path.sides]
    values = [value for value in found if value is not None]
    if len(values) < len(found):
        ends = ((compared, path.name, path.point, side, given) for side in path.sides)
        if relation == "O" and all(stays_bounded(*end) for end in ends):
            return Answer(Verdict.PROVED, "the ratio is bounded, since its sines and cosines are")
        return None
    if not all(allows(relation, v, right, given, same) for v in values):
        return None
    return Answer(Verdict.PROVED, f"the {what} tends to {values[0]}, {_EXACT}")


def _by_signs(claim: Comparison, path: Path, given: Given) -> Answer | None:
    """The claim where a parameter is positive, where it is negative, and where it may be 0."""
    signs = {name: sign(symbol(name), given, "!=") for name in _parameters(claim, path)}
    open_ = [name for name, found in signs.items() if found not in ("+", "-")]
    if not open_ or len(open_) > MOST_SPLIT:
        return None
    name, x = open_[0], symbol(open_[0])
    sides = (given & Given(((x, relation, ZERO),)) for relation in ("<", ">"))
    cases = [(claim, inside) for inside in sides if not is_empty(inside)]
    if signs[name] not in PROVING["!="]:
        put_in = partial(_at_zero, name=name, path=path)
        there = (part for part in given.mapped(put_in).comparisons if symbols(part[0] - part[2]))
        cases.append((claim.mapped(put_in), Given(tuple(there))))
    if all(_by_exact_limit(c, path, g) or _by_signs(c, path, g) for c, g in cases):
        return Answer(
            Verdict.PROVED, f"the limit, {_EXACT}, confirms the claim for each sign of {name}"
        )
    return None


def _at_zero(e: Expr, name: str, path: Path) -> Expr:
    """Return ``e`` where a parameter is 0; 0**x is 0 far out on a path x → oo."""
    x, moved = symbol(path.name), substitute(e, {name: ZERO})
    far = path.point is None and path.sides == (1,)
    return replaced(moved, {Expr("^", (ZERO, x)): ZERO}) if far else moved


def allows(relation: str, value: Expr, right: Expr, given: Given, same: Same | None = None) -> bool:
    """Return whether the claim follows if the compared expression has the limit ``value``."""
    infinite = value in (INFINITY, -INFINITY)
    if relation == LIMIT:
        return _are_equal(value, right, given, same)
    if relation in ("o", "omega", "~"):
        return _are_equal(value, ONE if relation == "~" else ZERO, given, same)
    if relation in ("O", "Theta"):
        return not infinite and (relation == "O" or sign(value, given, "!=") in PROVING["!="])
    if relation in ("<", "<="):
        return value == -INFINITY if infinite else sign(value, given, "<") == "-"
    if relation in (">", ">="):
        return value == INFINITY if infinite else sign(value, given, ">") == "+"
    return infinite or sign(value, given, "!=") in PROVING["!="]


# Eventually


def _eventually(claim: Comparison, path: Path, statement: Statement, decided: Decide) -> Answer:
    """Decide an inequality on some neighbourhood of the end of the path."""
    difference = claim.left - claim.right
    signs = [sign_towards(difference, path.name, path.point, side) for side in path.sides]
    for side, found in zip(path.sides, signs, strict=True):
        if found is not None and not stands(arb(found[0]), claim.relation):
            return _fails_beside(claim, path, side, *found)
    reaches = [found[1] for found in signs if found is not None]
    if len(reaches) == len(signs):
        return Answer(
            Verdict.ENCLOSED,
            "the leading term of left - right determines its sign",
            region=region(path, min(reaches)),
        )
    exact = _by_exact_limit(claim, path, Given())
    return exact or _from_somewhere_on(claim, path, statement, decided)


def _fails_beside(claim: Comparison, path: Path, side: int, found: int, reach: fmpq) -> Answer:
    """Refute: the difference has the wrong sign for all 0 < t <= reach."""
    sign_of = {0: "0", 1: "positive", -1: "negative"}[found]
    why = f"left - right is {sign_of} for all {region(replace(path, sides=(side,)), reach)}"
    at = number(side / reach) if path.point is None else path.point + number(side * reach)
    return Answer(Verdict.REFUTED, why, witness={path.name: exact_text(at)})


def _from_somewhere_on(
    claim: Comparison, path: Path, statement: Statement, decided: Decide
) -> Answer:
    """An inequality on one of a few neighbourhoods, for all values of the parameters at once."""
    if claim.relation not in (">", ">=", "<", "<=", "!="):
        return Answer(Verdict.UNDECIDED, _OPEN)
    for far in FAR:
        near = [neighbourhood(path, side, number(far)) for side in path.sides]
        answers = []
        for where in near:
            inside = replace(statement, path=None, given=statement.given & where)
            answers.append(decided(claim, inside))
            if not answers[-1]:
                break
        else:
            best = min(answers, key=lambda found: found.verdict is Verdict.PROVED)
            return replace(best, region=str(near[0]) if len(near) == 1 else None)
    found = failure_where_waves_return(claim.left - claim.right, claim.relation, path)
    if found is not None:
        return found
    why = (
        "the claim could not be proved on any of a few neighbourhoods of the end of the "
        "path, and no sequence of counterexamples was found"
    )
    return Answer(Verdict.UNDECIDED, why)


def neighbourhood(path: Path, side: int, far: Expr) -> Given:
    """Return the conditions x > far, or 0 < x − a < 1/far, for a side of the path."""
    x = symbol(path.name)
    if path.point is None:
        return Given(((x, ">", far),) if side == 1 else ((x, "<", -far),))
    end = path.point + side / far
    low, high = (path.point, end) if side == 1 else (end, path.point)
    return Given(((low, "<", x), (x, "<", high)))
