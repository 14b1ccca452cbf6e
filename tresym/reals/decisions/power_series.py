"""Infinite sums and products: power series by differential equations, theorems, limits of sums.

A claim with one series is first decided as one about a power series. If that is open, each series
is replaced by its value by a theorem, or by the limit of a closed form of its partial sums.

The terms f(k) y^(p k + q) with f(k + 1)/f(k) = P(k)/Q(k), P and Q polynomials, have a sum S(y) with
Q(δ − 1) S − y^p P(δ) S = Q(−1) f(0) y^q, where δ = (θ − q)/p and θ = y d/dy. Let G be the function
that S is claimed to equal. It must be analytic on an interval around 0 and satisfy the same
equation there, which the normal form proves. The coefficients d(m) of S − G satisfy Q((m − q)/p −
1) d(m) = P((m − q)/p − 1) d(m − p), so S = G if d(m) = 0 for the finitely many natural numbers m at
which the first factor vanishes; at these the derivatives of G are compared. Then S = G inside the
radius of convergence. At its ends Abel's theorem applies if the series converges there, which
Gauss's test decides.

The variable y may be an expression in x, which is then solved for x. A claim is refuted by partial
sums with a bound on the remainder, or at a point where the series diverges. The method is that of
D. Zeilberger, *A holonomic systems approach to special functions identities*, J. Comput. Appl.
Math. 32 (1990) 321.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import chain, pairwise
from math import factorial

from flint import fmpq, fmpq_poly

from tresym.reals.decisions.answer import Answer, Decide, exactly, refuted
from tresym.reals.decisions.exceptional_values import also_at_zeros
from tresym.reals.decisions.hypergeometric import (
    HIGHEST,
    K,
    OpenError,
    Series,
    has_terms,
    out_of_range,
    radius_of,
    series_of,
    summed,
    whole_roots,
)
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.induction import first_terms, with_values
from tresym.reals.decisions.known_values import Known, known_value
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary, is_infinite, outermost
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    apply,
    fresh,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.solve import solutions
from tresym.reals.normal.at_point import equal_at
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Cause, Verdict

POLES = 4
"""Up to which power of y is multiplied with, where a side has a singularity that is removable."""
POINTS = 6
APART = "partial sums with a bound on the remainder show that the two sides differ"


def decide_infinite(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with infinite sums or products.

    Args:
        decided: the procedure for claims without them.
    """
    nodes = [node for node in outermost(claim.left, claim.right) if is_infinite(node)]
    limit = statement.path is not None
    if claim.derivatives or statement.equations or (limit and not is_infinite(claim.right)):
        why = "a series together with derivatives, limits or conditions with == is not supported"
        return Answer(Verdict.UNDECIDED, why)
    if claim.relation not in ("==", "->") and any(symbols(node) - {"oo"} for node in nodes):
        return Answer(Verdict.UNDECIDED, "for a series with variables only equations are supported")
    found = None
    if len(set(nodes)) == 1 and claim.relation == "==" and not statement.integers:
        solution = claim.solved(nodes[0])
        if solution is not None:
            side, slope = solution
            found = decide_power_series(side, nodes[0], statement.given)
            if found:
                return also_at_zeros(found, [slope], claim, statement, decided, nodes[0])
            if found.verdict is Verdict.REFUTED:
                return _as_claimed(found, claim, nodes[0])
    known: dict[Expr, Known] = {}
    for node in dict.fromkeys(nodes):
        (k,), body = opened(node, statement.given.names)
        form = known_value(node.op, body, k, node.args[1], node.args[2], statement.given)
        if form is None and limit:
            return Answer(Verdict.UNDECIDED, f"{node}: no known theorem gives its value")
        if form is None:
            answer = first_terms(claim, statement, decided)
            return answer if found is None or answer.verdict is not Verdict.UNDECIDED else found
        known[node] = form
    values = {node: form.value for node, form in known.items()}
    said = "; ".join(f"{node} = {form.value} by {form.source}" for node, form in known.items())
    answer = with_values(claim, statement, values, said, decided)
    if answer.verdict is Verdict.UNDECIDED and not limit:  # 0/0 where a theorem leaves out a factor
        other = first_terms(claim, statement, decided)
        return answer if other.verdict is Verdict.UNDECIDED else other
    return answer


def _as_claimed(found: Answer, claim: Comparison, series: Expr) -> Answer:
    """Values of an elementary side and of a series as those of the two sides of the claim."""
    if found.values is None or claim.right == series:
        return found
    return replace(found, values=found.values[::-1] if claim.left == series else None)


# The proof


def decide_power_series(side: Expr, node: Expr, given: Given) -> Answer:
    """Decide ``side == node`` for an infinite sum ``node`` of hypergeometric terms.

    Args:
        side: an elementary expression.
        given: the conditions.
    """
    s = series_of(node, symbols(side) | given.names)
    if s is not None:
        why = "a series is compared only with elementary functions"
        if not elementary(side) or any(True for _ in functions(side)):
            return Answer(Verdict.UNDECIDED, f"{node}: {why}, not with {side}")
    if s is None:
        return Answer(
            Verdict.UNDECIDED,
            (
                f"{node}: only series are supported whose ratio of "
                "consecutive terms is rational in the index"
            ),
        )
    answer = _at_points(side, s, given)
    if answer is not None:
        return answer
    try:
        how = _shown(side, s, given)
    except OpenError as error:
        return Answer(Verdict.UNDECIDED, f"{node}: {error}")
    except InputError as error:
        return Answer(
            Verdict.UNDECIDED,
            f"an intermediate expression exceeds the size limit: {error}",
            cause=Cause.TOO_LARGE,
        )
    for at in given.points(symbols(side) | symbols(s.u) | symbols(s.head), POINTS):
        with ball_precision():
            if evaluate(side, at).is_finite() and evaluate(s.first, at).is_finite():
                return Answer(Verdict.PROVED, exactly(f"{how}; both sides are defined", at))
    return Answer(
        Verdict.UNDECIDED,
        "no point was found where both sides are defined, so there "
        "is nothing to prove; check the conditions",
    )


def _shown(side: Expr, s: Series, given: Given) -> str:
    """Return the proof in words; raise OpenError if there is none."""
    y = fresh("y", symbols(side) | symbols(s.u) | symbols(s.head) | given.names)
    need_range(side, s, given)
    for x in sorted(symbols(s.u), key=lambda name: (name not in symbols(side), name)):
        power = _power_of(s.head, s.u, x, given)
        if power is None:
            continue
        for moved in functions_of(side, s.u, x, y, given):
            shown = by_equation(moved, power, s, y, without(x, given))
            if shown:
                return shown
    raise OpenError(
        "the other side could not be shown to satisfy the differential equation of the series"
    )


def need_range(side: Expr, s: Series, given: Given) -> None:
    """Check that the series converges wherever the conditions hold and ``side`` is continuous.

    Raises:
        OpenError: this could not be proved.
    """
    problem = "the other side may be discontinuous" if jumps(side) else out_of_range(s, given)
    if problem:
        raise OpenError(problem)


def without(x: str, given: Given) -> Given:
    """Return the conditions that do not contain x."""
    return Given(tuple(c for c in given.comparisons if x not in symbols(c[0]) | symbols(c[2])))


def _power_of(head: Expr, u: Expr, x: str, given: Given) -> tuple[Expr, int] | None:
    """Return c and n with ``head`` = c u^n and c free of x, or None."""
    for n in (0, *(m for k in range(1, HIGHEST) for m in (k, -k))):
        for scale in (in_lowest_terms(head * u ** number(-n)), substitute(head, {x: ONE})):
            if x in symbols(scale):
                continue
            if n == 0 and scale == head:
                return scale, 0
            if decide(head, scale * u ** number(n), given).verdict is Verdict.PROVED:
                return scale, n
    return None


def functions_of(e: Expr, u: Expr, x: str, y: str, given: Given) -> Iterator[Expr]:
    """Yield forms of ``e`` as a function of y = u, free of x."""
    if u == symbol(x):
        yield substitute(e, {x: symbol(y)})
        return
    for moved in dict.fromkeys(_moved(e, u, x, y, without(x, given))):
        if x not in symbols(moved):
            again = substitute(moved, {y: u})
            if again == e or decide(again, e, given).verdict is Verdict.PROVED:
                yield moved


def _moved(e: Expr, u: Expr, x: str, y: str, given: Given) -> Iterator[Expr]:
    """Candidates for these."""
    yield replaced(_by_exponentials(e), {u: symbol(y)})
    positive = given & Given(((symbol(y), ">", ZERO),))
    for found in (*_moebius(u, x, y), *solutions(u - symbol(y), x)):
        moved = substitute(e, {x: found})
        yield moved
        yield normal_form(moved, positive)


def _by_exponentials(e: Expr) -> Expr:
    """``e`` with powers whose exponents are no numbers as exponentials."""
    if e.op in LEAVES:
        return e
    args = tuple(map(_by_exponentials, e.args))
    if e.op == "^" and args[1].op != "number":
        return apply("exp", args[1] * apply("log", args[0]))
    return rebuild(e, args)


def _moebius(u: Expr, x: str, y: str) -> Iterator[Expr]:
    """The inverse of (a x + b)/(c x + d), by three of its values."""
    try:
        f, g, h = (in_lowest_terms(substitute(u, {x: number(n)})) for n in (2, 3, 5))
        left = (symbol(y) - f) * (g - h)  # the cross ratio of values is that of their places
        right = (symbol(y) - h) * (g - f)
        yield in_lowest_terms((5 * left + 4 * right) / (left + 2 * right))
    except (InputError, ZeroDivisionError):
        return


def by_equation(side: Expr, power: tuple[Expr, int], s: Series, y: str, given: Given) -> str:
    """Prove ``side = c y^n Σ f(k) y^(p k + q)`` inside the radius of convergence.

    Args:
        side: a function of y.
        power: c and n.
        given: the conditions on what else is in it.
    """
    scale, plain = power
    v = symbol(y)
    radius = radius_of(s)
    inside = given
    if radius is not None:
        inside = given & Given(((v, "<", radius), (v, ">", -radius)))
    for pole in range(POLES):
        q = s.start + plain + pole
        if q < 0:
            continue
        g = in_lowest_terms(side * v ** number(pole))
        if continuous_on(g, inside, proof) is not None:
            continue
        below = s.below((K - q) / s.step - 1)
        above = s.above((K - q) / s.step)
        if max(below.degree(), above.degree()) > HIGHEST:
            return ""
        left = _applied(below, g, y) - v ** number(s.step) * _applied(above, g, y)
        right = number(s.below(fmpq(-1))) * scale * v ** number(q)
        if decide(left, right, inside).verdict is not Verdict.PROVED:
            return ""
        free = [m for m in whole_roots(below) if m >= 0]
        if max(free, default=0) > 2 * HIGHEST:
            return ""
        if all(_coefficient_is(g, y, m, s, q, scale, given) for m in free):
            at = ", ".join(map(str, sorted(free)))
            return (
                f"both sides satisfy the same linear differential equation in {s.u}"
                + (
                    (f", and their Taylor coefficients of order {at}, which it leaves free, agree")
                    if at
                    else ", which has only one power series solution"
                )
                + ("" if radius is None else f"; the radius of convergence is {radius}")
            )
        return ""
    return ""


def _applied(p: fmpq_poly, g: Expr, y: str) -> Expr:
    """A polynomial in θ = y d/dy of a function: θ(θ − 1)…(θ − j + 1) is y^j (d/dy)^j."""
    values = [p(fmpq(n)) for n in range(p.degree() + 1)]
    result, derivative = ZERO, g
    for j in range(len(values)):
        if values[0]:
            result = result + number(values[0] / factorial(j)) * symbol(y) ** number(j) * derivative
        values = [b - a for a, b in pairwise(values)]
        derivative = differentiate(derivative, y)
    return result


def _coefficient_is(g: Expr, y: str, m: int, s: Series, q: int, scale: Expr, given: Given) -> bool:
    """Return whether the coefficient of y^m in g equals that of the series."""
    for _ in range(m):
        g = differentiate(g, y)
    k, rest = divmod(m - q, s.step)
    value = fmpq(0)
    if rest == 0 and k >= 0:
        value = fmpq(1)
        for j in range(k):
            value = value * s.above(fmpq(j)) / s.below(fmpq(j))
    wanted = scale * number(value * factorial(m)) if value else ZERO
    return decide(substitute(g, {y: ZERO}), wanted, given).verdict is Verdict.PROVED


# Points


def _at_points(side: Expr, s: Series, given: Given) -> Answer | None:
    """Return a refutation where the sides differ or the series diverges, or None."""
    names = symbols(side) | symbols(s.u) | symbols(s.head)
    inside = ({n: number(x) for n, x in at.items()} for at in given.points(names, POINTS))
    spoken_of = not symbols(s.u) or bool(symbols(s.u) & given.names)  # else no range is said
    for at in chain(inside, _beyond(s, given, names) if spoken_of else ()):
        with ball_precision(256):
            ball = {name: evaluate(value, {}) for name, value in at.items()}
            value, total = evaluate(side, ball), summed(s, ball)
        if not value.is_finite():
            continue
        if total is not None and not value.overlaps(total):
            return refuted(APART, at, value, total)
        where = _divergence(s, at) if spoken_of else ""
        if where and has_terms(s, ball):
            return refuted(f"the series diverges{where}", at)
    return None


def _beyond(s: Series, given: Given, names: frozenset[str]) -> Iterator[dict[str, Expr]]:
    """Points outside the interval of convergence, and, in one variable, at its ends."""
    radius = radius_of(s)
    if radius is None or not symbols(s.u):
        return
    far = given & Given(((apply("abs", s.u), ">", radius),))
    yield from ({n: number(x) for n, x in at.items()} for at in far.points(names, POINTS))
    for end in (radius, -radius) if len(names) == 1 else ():
        for point in solutions(s.u - end, *names):
            at = dict.fromkeys(names, point)
            links = given.mapped(partial(substitute, mapping=at)).comparisons
            if not symbols(point) and constants_hold(links) is not None:
                yield at


def _divergence(s: Series, at: dict[str, Expr]) -> str:
    """Return where the series is proved to diverge if all terms are not 0; empty if nowhere."""
    radius, u = radius_of(s), substitute(s.u, at)
    if radius is None:
        return ""
    with ball_precision():
        if abs(evaluate(u, {})) > evaluate(radius, {}):
            return f", for abs({s.u}) > {radius}"
    for side in (1, -1) if s.rate else ():
        even = side > 0 or s.step % 2 == 0
        if not s.converges(bool((s.rate or 0) > 0) == even) and equal_at(u, side * radius, {}):
            return f" where {s.u} is {side * radius}"
    return ""
