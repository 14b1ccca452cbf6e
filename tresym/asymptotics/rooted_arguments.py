"""Orders of growth of T(n) = a n^γ T(n^β) + g(n) with 0 < β < 1, such as T(√n).

Example: ``T(n) == Theta(log(n)) given T(n) == 2*T(sqrt(n)) + 1, T(2) == 1 as n -> oo``.

With n^δ for δ = γ/(1 − β), V(n) = T(n)/n^δ satisfies V(n) = a V(n^β) + g(n)/n^δ. In x = log n this
is U(x) = a U(β x) + G(x), a recurrence of :mod:`tresym.asymptotics.divided_arguments` if G is about
a power of x times one of log x. If G(x) is about e^{c x}, it determines U where c > 0, so that
T ~ g, and adds a convergent sum where c < 0.
"""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from tresym.asymptotics.divided_arguments import (
    KINDS,
    LEMMA,
    Branch,
    Divided,
    Growth,
    alternates,
    growth_of,
    homogeneous,
)
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.rounding import is_rounded
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
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

_T, _PART = "[T]", "[P]"


def decide_rooted(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide an order of T(n), or return None where no condition is such a recurrence.

    Args:
        claim: the comparison.
        statement: its conditions: the recurrence and a first value, and the path n -> oo.
        decided: decides explicit claims.
    """
    path = statement.path
    if path is None or path.point is not None or path.sides != (1,) or claim.derivatives:
        return None
    n = symbol(path.name)
    pairs = [pair for pair in statement.equations if _nodes(pair, n) is not None]
    if len(pairs) != 1:
        return None
    (pair,) = pairs
    node, part, beta = _nodes(pair, n) or (n, n, fmpq(0))
    if not beta:
        return None

    def open_(why: str) -> Answer:
        return Answer(Verdict.UNDECIDED, why)

    if beta >= 1:
        return open_(f"{part} must be a value at a smaller argument than {node}")
    linear = replaced(pair[0] - pair[1], {node: symbol(_T), part: symbol(_PART)})
    if not elementary(linear) or not symbols(linear) <= {_T, _PART, path.name}:
        return open_("the recurrence must be one of numbers")
    if alternates(linear, path.name):
        return open_(f"powers whose sign depends on {n} are not supported in such a recurrence")
    lead, other = (tidied(normal_form(differentiate(linear, x), Given())) for x in (_T, _PART))
    scaled = lead.op == "number" and lead != ZERO and _power(-other / lead, n)
    if not scaled:
        return open_(f"the recurrence must be {node} == a*{part} + g({n}), with a power for a")
    a, gamma = scaled
    rest = substitute(linear, {_T: ZERO, _PART: ZERO}) * number(-1 / lead.args[0])
    start = _start(statement, pair, node)
    if isinstance(start, str):
        return open_(start)
    beyond = Given(((n, ">", number(fmpq(1) if start is None else start[0])),))
    if a <= 0 or statement.given.comparisons or statement.integers not in ((), (path.name,)):
        return open_("a factor a > 0 is needed, and no conditions beside the recurrence")
    if continuous_on(rest, beyond, proof) is not None:
        return open_(f"{rest} must be defined given {beyond}")
    if claim.relation not in KINDS or claim.left != node or list(functions(claim.right)):
        return open_(f"orders of {node} are supported: == Theta(h), O(h), o(h) and ~ h")
    delta = number(gamma / (1 - beta))
    growth = _growth(node, Branch(a, part.args[1], beta), rest / power(n, delta))
    if growth is None or growth.scale is None:
        return open_(f"{rest} must be about a product of powers of {n}, log({n}) and its logarithm")
    plain = replace(statement, equations=(), integers=())
    if growth.positive:
        if start is None or start[1] <= 0 or any(map(is_rounded, functions(part))):
            return open_(f"one value T(k) > 0 with k > 1 is needed, and {part} without rounding")
        inside = replace(plain, path=None, given=beyond)
        if not decided(Comparison(rest, ">=", ZERO), inside):
            return open_(f"{rest} >= 0 given {beyond} is needed")
    scale = substitute(growth.scale, {path.name: apply("log", n)})
    scale = scale if delta == ZERO else scale * power(n, delta)
    if claim.relation == "~" and not growth.sharp:
        return open_(f"{node} = Theta({scale}) is known; its ratio to that may oscillate")
    answer = decided(replace(claim, left=scale), plain)
    why = f"{node} {'~ ' if growth.sharp else '= Theta'}({scale}): {answer.why}"
    return replace(answer, why=why, lemma=LEMMA, region=None, constant=None)


def _nodes(pair: tuple[Expr, Expr], n: Expr) -> tuple[Expr, Expr, fmpq] | None:
    """Return T(n), T(n^β) and β where an equation contains these alone."""
    nodes = {node for e in pair for node in functions(e) if not is_rounded(node)}
    whole = [m for m in nodes if len(m.args) == 2 and m.args[1] == n]
    if len(nodes) != 2 or len(whole) != 1 or len({m.args[0] for m in nodes}) != 1:
        return None
    (part,) = nodes - {*whole}
    if len(part.args) != 2:
        return None
    inside = part.args[1]
    if is_rounded(inside):
        inside = inside.args[1]
    if inside.op != "^" and inside.op != "sqrt":
        return None
    found = _power(inside, n)
    return (whole[0], part, found[1]) if found is not None and found[0] == 1 else None


def _power(e: Expr, n: Expr) -> tuple[fmpq, fmpq] | None:
    """Return a and γ where ``e`` is a n^γ."""
    name = str(n.args[0])
    if not elementary(e) or not symbols(e) <= {name} or e == ZERO:
        return None
    given = Given(((n, ">", ZERO),))
    gamma = tidied(normal_form(differentiate(e, name) * n / e, given))
    if gamma.op != "number":
        return None
    a = tidied(normal_form(e / power(n, gamma), given))
    return (a.args[0], gamma.args[0]) if a.op == "number" else None


def _start(
    statement: Statement, pair: tuple[Expr, Expr], node: Expr
) -> tuple[fmpq, fmpq] | str | None:
    """Return k and T(k) of the only other condition, None without one, or why it does not serve."""
    others = [other for other in statement.equations if other != pair]
    if not others:
        return None
    for left, right in (others[0], others[0][::-1]):
        if len(others) == 1 and left.op == "unknown" and left.args[0] == node.args[0]:
            k, value = tidied(left.args[1]), tidied(right)
            if k.op == value.op == "number" and k.args[0] > 1:
                return k.args[0], value.args[0]
    return "one value T(k) with k > 1, such as T(2) == 1, is supported beside the recurrence"


def _growth(node: Expr, branch: Branch, rest: Expr) -> Growth | None:
    """Return how U(x) grows, with x in place of n."""
    name = str(node.args[1].args[0])
    along = tidied(normal_form(substitute(rest, {name: apply("exp", symbol(name))}), Given()))
    found = Divided(node, (branch,), along, {})
    growth = growth_of(found)
    if growth is not None:
        return growth
    rate = limit_of(differentiate(along, name) / along, name, None, 1, Given())
    if rate is None or symbols(rate):
        return None
    side = sign(rate, Given())
    if side == "-":
        return homogeneous(found)
    if side == "+" and sign_at_infinity(along, name) == "+":
        return Growth(along, True)
    return None


def sign_at_infinity(e: Expr, name: str) -> str:
    """Return the sign of what tends to infinity, or nothing."""
    far = limit_of(ONE / e, name, None, 1, Given())
    up = limit_of(e, name, None, 1, Given())
    return "+" if far == ZERO and up is not None and str(up) == "oo" else ""
