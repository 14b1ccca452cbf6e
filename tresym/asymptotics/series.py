"""Series without variables: exact values of rational terms, enclosures, and divergence.

*Rational terms.* If the denominator has simple rational roots r_i, the term is Σ c_i/(k − r_i), and
the series from a on is −Σ c_i ψ(a − r_i) where Σ c_i = 0. Gauss's theorem gives ψ at rational
numbers by logarithms and cotangents (DLMF 5.4.19, 5.7.6).

*Enclosures.* The first terms are added in balls, and the rest is enclosed by the Euler–Maclaurin
formula if f^(2m) has one sign and all derivatives tend to 0 (DLMF 2.10.1). This proves bounds and
refutes equations.

*Divergence.* ``sum(1/k, k, 1, oo) == oo`` is the limit of the partial sums.

Example: ``sum(n/((n+2)*(n+4)*(n+8)), n, 1, oo) == 4/35`` is proved, and with 5/35 it is refuted.
"""

from __future__ import annotations

from functools import partial

from flint import arb, fmpq, fmpq_poly

from tresym.asymptotics.euler_maclaurin import derivative, weight
from tresym.asymptotics.lemma import End, Obligations
from tresym.asymptotics.rational_functions import over, roots_of
from tresym.asymptotics.stirling import bernoulli
from tresym.reals.decisions.answer import Answer, Decide, refuted
from tresym.reals.decisions.hypergeometric import OpenError, polynomial
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.binder_values import enclosing
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError, evaluate, stands
from tresym.reals.language.binders import integral, outermost, total
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    PI,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    number,
    opened,
    replaced,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof, sign
from tresym.reals.values import improper
from tresym.reals.verdict import Verdict

GAUSS = "Gauss's theorem on the digamma function (DLMF 5.4.19)"
ENCLOSURE = "partial sums and the Euler–Maclaurin formula (DLMF 2.10.1)"
DIVERGENCE = "the growth of the partial sums"
STARTS, PAIRS = (12, 48, 200), 4
"""Where the formula begins, and its pairs of derivatives."""
LARGEST_DENOMINATOR, FARTHEST = 24, 400
BITS = 160


def decide_series(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a claim about series of numbers; None where it has another shape."""
    nodes = list(dict.fromkeys(outermost(claim.left, claim.right)))
    names = symbols(claim.left) | symbols(claim.right)
    if names - {"oo"} or claim.derivatives or statement.path is not None or not nodes:
        return None
    if any(
        node.op != "sum" or node.args[2] != INFINITY or integer(node.args[1]) is None
        for node in nodes
    ):
        return None
    try:
        if claim.right == INFINITY and claim.relation == "==" and claim.left == nodes[0]:
            return _divergence(nodes[0], statement, decided)
        if INFINITY in (claim.left, claim.right):
            return None
        values = {node: rational_value(node) for node in nodes}
        known = {node: value for node, value in values.items() if value is not None}
        if len(known) == len(nodes):
            found = decided(claim.mapped(partial(replaced, known=known)), statement)
            said = "; ".join(f"{node} = {value}" for node, value in known.items())
            if found.verdict is not Verdict.UNDECIDED:
                return Answer(
                    found.verdict,
                    f"by {GAUSS}: {said}; {found.why}",
                    witness=found.witness,
                    lemma=GAUSS,
                )
        return _enclosed(claim, nodes)
    except (InputError, OpenError, ZeroDivisionError, OverflowError):
        return None


def _divergence(node: Expr, statement: Statement, decided: Decide) -> Answer | None:
    """Decide whether the partial sums tend to infinity."""
    (k,), body = opened(node)
    part = total("sum", body, k, node.args[1], symbol("n"))
    ask = Obligations(statement, decided)
    answer = ask.ask(part, "->", INFINITY, Given(), Path("n", None, (1,)), ("n",))
    if answer:
        why = f"by {DIVERGENCE}: {answer.why}"
        return Answer(answer.verdict, why, lemma=DIVERGENCE, obligations=tuple(ask.found))
    with ball_precision(BITS):
        for start in STARTS:
            value = enclosure(node, start)
            if value is not None and value.is_finite():
                return refuted("the series converges: its value is enclosed in a ball", {})
    return None


def _enclosed(claim: Comparison, nodes: list[Expr]) -> Answer | None:
    """Decide by enclosures of the series."""
    with ball_precision(BITS):
        for start in STARTS:
            known, at = {}, {}
            for n, node in enumerate(nodes):
                value = enclosure(node, start)
                if value is None:
                    return None
                known[node], at[f"[{n}]"] = symbol(f"[{n}]"), value
            left, right = (evaluate(replaced(e, known), at) for e in (claim.left, claim.right))
            if not (left.is_finite() and right.is_finite()):
                return None
            if stands(left - right, NEGATED[claim.relation]):
                found = refuted("an enclosure of the series excludes it", {}, left, right)
                return found
            if claim.relation != "==" and stands(left - right, claim.relation):
                why = f"by {ENCLOSURE}, from k = {start} on"
                return Answer(Verdict.ENCLOSED, why, lemma=ENCLOSURE)
    return None


def enclosure(node: Expr, start: int) -> arb | None:
    """Return a ball around a series, by the Euler–Maclaurin formula from ``start`` terms on."""
    (k,), f = opened(node)
    low = integer(node.args[1])
    if low is None or f.hidden or symbols(f) != {k}:
        return None
    first, x = low + start, symbol(k)
    beyond = Given(((x, ">=", number(first)),))
    far = End(k, None, 1, Given())
    if continuous_on(f, beyond, proof) is not None:
        return None
    slopes = [derivative(f, k, n) for n in range(2 * PAIRS)]
    if any(far.limit(slope) != ZERO for slope in slopes):
        return None
    last = derivative(f, k, 2 * PAIRS)
    if sign(last, beyond, ">=") not in ("+", ">=0") and sign(last, beyond, "<=") not in (
        "-",
        "<=0",
    ):
        return None
    at = {k: fmpq(first)}
    result = arb(0)
    for n in range(low, first):
        result += evaluate(f, {k: fmpq(n)})
    try:
        rest = improper.integral(integral(f, k, number(first), INFINITY), enclosing({}))
    except UndefinedError:
        return None
    result += rest + evaluate(f, at) / 2
    for j in range(1, PAIRS):
        factor = arb(bernoulli(2 * j))
        for n in range(1, 2 * j + 1):
            factor /= n
        result -= factor * evaluate(slopes[2 * j - 1], at)
    radius = arb(weight(PAIRS)) * abs(evaluate(slopes[2 * PAIRS - 1], at))
    result += arb(0, radius.upper())
    return result if result.is_finite() else None


# Rational terms


def rational_value(node: Expr) -> Expr | None:
    """Return the exact value of a series of rational terms with simple rational poles."""
    (k,), f = opened(node)
    low = integer(node.args[1])
    if low is None or f.hidden or symbols(f) != {k}:
        return None
    above, below = (polynomial(part, k) for part in over(in_lowest_terms(f)))
    if below.degree() < above.degree() + 2:
        return None
    roots = roots_of(below)
    if sum(times for _, times in roots) != below.degree() or any(m > 1 for _, m in roots):
        return None
    slope: fmpq_poly = below.derivative()
    parts = []
    for root, _ in roots:
        c, at = above(root) / slope(root), fmpq(low) - root
        if at.q > LARGEST_DENOMINATOR or abs(at) > FARTHEST or (at.q == 1 and at <= 0):
            return None
        parts.append(number(-c) * digamma_without_gamma(at))
    return add(ZERO, *parts)


def digamma_without_gamma(x: fmpq) -> Expr:
    """Return ψ(x) + γ at a rational number that is no pole (DLMF 5.4.19, 5.5.2)."""
    rest = fmpq(0)
    while x > 1:
        x -= 1
        rest += 1 / x
    while x <= 0:
        rest -= 1 / x
        x += 1
    p, q = int(x.p), int(x.q)
    if q == 1:
        return number(rest)
    angle = PI * number(x)
    parts = [-apply("log", number(2 * q)), -PI / 2 * apply("cot", angle)]
    for n in range(1, (q - 1) // 2 + 1):
        wave = apply("cos", PI * number(fmpq(2 * n * p, q)))
        parts.append(2 * wave * apply("log", apply("sin", PI * number(fmpq(n, q)))))
    return add(number(rest), *parts)
