"""Orders of growth of divide-and-conquer recurrences T(n) = a T(n/c) + g(n), for n = k cᵐ.

Example: ``T(n) == Theta(n*log(n)) given T(n) == 2*T(n/2) + n, T(1) == 1 as n -> oo``.

Written out, T(k cᵐ) = aᵐ (T(k) + Σ g(k cʲ)/aʲ) with j = 1, …, m. Let a > 0, c > 1, T(k) ≥ 0 and
g ≥ 0 from n = k c on, where not both vanish, and g(n) ~ K nˢ logᵗ n with K > 0. With
p = log a/log c the terms of the sum are about c^{(s−p)j} jᵗ, so that T = Θ(S) with

* S = nᵖ for s < p, and for g = 0,
* S = nᵖ logᵗ⁺¹ n for s = p and t > −1, nᵖ log log n for t = −1 and nᵖ for t < −1,
* S = nˢ logᵗ n for s > p.

T = O(h), o(h), ω(h) or Θ(h) holds if and only if the same is true of S.

Source: J. L. Bentley, D. Haken and J. B. Saxe, *SIGACT News* 12 (1980), 36–44.
"""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from tresym.asymptotics.divided_arguments import alternates, powers_of
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.leading_terms import written_term
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    integer,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = "the orders of growth of divide-and-conquer recurrences (Bentley, Haken and Saxe 1980)"
KINDS = ("O", "o", "Theta", "omega")
_T, _PART = "[T]", "[P]"


def decide_divided(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide an order of T(n), or return None where no condition is such a recurrence.

    Args:
        claim: the comparison.
        statement: its conditions: the recurrence and one value, and the path n -> oo.
        decided: decides explicit claims.
    """
    path = statement.path
    if path is None or path.point is not None or path.sides != (1,) or claim.derivatives:
        return None
    n = symbol(path.name)
    shrinking = [pair for pair in statement.equations if _ratio(pair, n) is not None]
    if len(shrinking) != 1:
        return None
    (pair,) = shrinking
    ratio = _ratio(pair, n)
    whole = next(m for e in pair for m in functions(e) if m.args[1] == n)
    part = next(m for e in pair for m in functions(e) if m.args[1] != n)

    def open_(why: str) -> Answer:
        return Answer(Verdict.UNDECIDED, why)

    if ratio is None or ratio <= 1:
        return open_(f"{part} must be a value at a smaller argument than {whole}")
    others = [other for other in statement.equations if other != pair]
    if statement.given.comparisons or statement.integers not in ((), (path.name,)):
        return open_("conditions beside a divide-and-conquer recurrence are not supported")
    linear = replaced(pair[0] - pair[1], {whole: symbol(_T), part: symbol(_PART)})
    if not elementary(linear) or not symbols(linear) <= {_T, _PART, path.name}:
        return open_("the recurrence must be one of numbers")
    if alternates(linear, path.name):
        return open_(f"powers whose sign depends on {n} are not supported in such a recurrence")
    slopes = [tidied(normal_form(differentiate(linear, x), Given())) for x in (_T, _PART)]
    if any(e.op != "number" or e.args[0] == 0 for e in slopes):
        return open_(f"the recurrence must be {whole} == a*{part} + g({n}) with a number a")
    a = -slopes[1].args[0] / slopes[0].args[0]
    rest = substitute(linear, {_T: ZERO, _PART: ZERO}) / number(-slopes[0].args[0])
    g = tidied(normal_form(rest, Given()))
    start = _start(others, whole)
    if a <= 0 or start is None:
        return open_(f"a factor a > 0 of {part} and one value, such as T(1) == 1, are needed")
    k, value = start
    beyond = Given(((n, ">=", number(k * ratio)),))
    plain = replace(statement, path=None, equations=(), integers=(), given=beyond)
    if continuous_on(g, beyond, proof) is not None:
        return open_(f"{g} must be defined from {n} = {k * ratio} on")
    if value < 0 or (g != ZERO and not decided(Comparison(g, ">=", ZERO), plain)):
        return open_(f"a first value >= 0 and {g} >= 0 from {n} = {k * ratio} on are needed")
    if value == 0 and (g == ZERO or not decided(Comparison(g, ">", ZERO), plain)):
        return open_(f"{whole} may vanish: its first value is 0, and so may be {g}")
    scale = _scale(a, ratio, g, n)
    if scale is None:
        return open_(f"{g} must be about a power of {n} times a power of log({n})")
    if claim.relation not in KINDS or claim.left != whole or list(functions(claim.right)):
        return open_(
            f"{whole} = Theta({scale}) is known; its ratio to that need not tend to a limit, "
            "because it may oscillate between the powers of "
            f"{number(ratio)} (a periodic factor)"
        )
    explicit = replace(claim, left=scale)
    answer = decided(explicit, replace(statement, equations=(), integers=()))
    # The constant of the scale is none of the claim.
    compared = f"{scale} is {claim.relation}({claim.right})" if answer else answer.why
    powers = f"{number(ratio)}**m" if k == 1 else f"{number(k)}*{number(ratio)}**m"
    why = f"{whole} = Theta({scale}) for {n} = {powers}: {compared}"
    return replace(answer, why=why, lemma=LEMMA, region=None, constant=None)


def _ratio(pair: tuple[Expr, Expr], n: Expr) -> fmpq | None:
    """Return c where an equation contains T(n) and T(n/c) and no other value."""
    nodes = {node for e in pair for node in functions(e)}
    if len(nodes) != 2 or len({m.args[0] for m in nodes}) != 1:
        return None
    if any(len(m.args) != 2 for m in nodes) or not any(m.args[1] == n for m in nodes):
        return None
    (other,) = (m.args[1] for m in nodes if m.args[1] != n)
    found = tidied(normal_form(other / n, Given()))
    if found.op != "number" or found.args[0] <= 0:
        return None
    return 1 / found.args[0]


def _start(others: list[tuple[Expr, Expr]], whole: Expr) -> tuple[int, fmpq] | None:
    """Return k and the number T(k) of the only other condition."""
    for left, right in (pair for other in others for pair in (other, other[::-1])):
        if len(others) == 1 and left.op == "unknown" and left.args[0] == whole.args[0]:
            k, value = integer(left.args[1]), tidied(right)
            if k is not None and k > 0 and value.op == "number":
                return k, value.args[0]
    return None


def _scale(a: fmpq, c: fmpq, g: Expr, n: Expr) -> Expr | None:
    """Return S with T = Θ(S), or None where g is of another kind."""
    log = apply("log", n)
    exponent = next((number(k) for k in range(-12, 13) if c**k == a), None)
    if exponent is None:
        exponent = apply("log", number(a)) / apply("log", number(c))
    own = ONE if exponent == ZERO else power(n, exponent)
    if g == ZERO:
        return own
    first = written_term(g, str(n), None, 1, Given())
    if first is None:
        return None
    powers = powers_of(first[1], n)
    if powers is None:
        return None
    s, t = powers
    gap = sign(number(a) - power(number(c), number(s)), Given())
    if gap == "+":
        return own
    if gap == "-":
        return first[1]
    if gap != "0":
        return None
    same = power(n, number(s))
    if t == -1:
        return same * apply("log", log)
    return same if t < -1 else same * power(log, number(t + 1))
