"""Orders of growth of T(n) = Σ aᵢ T(bᵢ n) + g(n), where bᵢ n is rounded to an integer.

Example: ``T(n) == Theta(n*log(n)) given T(n) == T(floor(n/3)) + T(floor(2*n/3)) + n as n -> oo``.

Let aᵢ > 0 and 0 < bᵢ < 1, let the arguments differ from bᵢ n by bounded amounts, and let
g(n) ~ K nˢ logᵗ n with K > 0, or g = 0. The exponent p with Σ aᵢ bᵢᵖ = 1 is compared with s. With
μ = Σ aᵢ bᵢᵖ log(1/bᵢ),

* for s < p, and for g = 0, T = Θ(nᵖ) if T > 0 from some n on,
* for s = p, T ~ K nᵖ logᵗ⁺¹ n/((t + 1) μ) for t > −1, and T ~ K nᵖ log log n/μ for t = −1,
* for s > p, T ~ K nˢ logᵗ n/(1 − Σ aᵢ bᵢˢ).

The theorem of Akra and Bazzi says T = Θ(nᵖ (1 + ∫ g(u)/u^{p+1} du)) for positive T. It implies the
above: solutions with g = 0 are O(nᵖ), so that the first values of T do not matter where the growth
is faster. And if V is the approximation, T − V satisfies the recurrence with o(g) in place of g.

Where arguments such as n/3 are not rounded, they are meant rounded up or down.

Sources: M. Akra and L. Bazzi, *Comput. Optim. Appl.* 10 (1998), 195–210; T. Leighton, *Notes on
better master theorems for divide-and-conquer recurrences*, 1996, with rounded arguments.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.rounding import is_rounded
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.leading_terms import written_term
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MAX_POWER,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    number,
    power,
    replaced,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = "the theorem of Akra and Bazzi (1998) on divide-and-conquer recurrences"
KINDS = ("O", "o", "Theta", "omega", "~")
LOOKED_AT = 64
"""Values of T(n) that are computed."""
BISECTIONS, LARGEST_EXPONENT = 60, 64


class Branch(NamedTuple):
    """A term a T(argument), where the argument is about b n.

    Attributes:
        factor: the number a.
        argument: the argument, with floors and ceilings.
        ratio: the number b.
    """

    factor: fmpq
    argument: Expr
    ratio: fmpq

    @property
    def rounded(self) -> bool:
        """Whether the argument is an integer for every integer n."""
        return any(map(is_rounded, functions(self.argument)))

    def at(self, n: int, name: str) -> fmpq | None:
        """Return the argument at an integer n."""
        return _exact(substitute(self.argument, {name: number(n)}))


class Divided(NamedTuple):
    """A recurrence T(n) = Σ aᵢ T(…) + g(n).

    Attributes:
        node: T(n).
        branches: the terms with T.
        rest: g.
        starts: the values of T that are given.
    """

    node: Expr
    branches: tuple[Branch, ...]
    rest: Expr
    starts: dict[int, fmpq]

    @property
    def name(self) -> str:
        """The index n."""
        return str(self.node.args[1].args[0])

    def values(self, last: int) -> dict[int, fmpq]:
        """Return T(n) for the first n, up to where one needs a value that is not given."""
        known = dict(self.starts)
        if not known or sorted(known) != list(range(min(known), max(known) + 1)):
            return {}
        for n in range(max(known) + 1, last + 1):
            total = _exact(substitute(self.rest, {self.name: number(n)}))
            for branch in self.branches:
                at = branch.at(n, self.name)
                value = None if at is None or at.q != 1 or at >= n else known.get(int(at.p))
                if total is None or value is None:
                    return known
                total += branch.factor * value
            if total is None:
                return known
            known[n] = total
        return known


def _exact(e: Expr) -> fmpq | None:
    """Return the value of an expression without variables, if it is rational."""
    put: dict[Expr, Expr] = {}
    for node in functions(e):
        if is_rounded(node):
            inner = tidied(replaced(node.args[1], put))
            if inner.op != "number":
                return None
            x = inner.args[0]
            put[node] = number(x.floor() if node.args[0].args[0] == "floor" else x.ceil())
    value = tidied(replaced(e, put))
    return value.args[0] if value.op == "number" else None


def alternates(e: Expr, n: str) -> bool:
    """Return whether a power of what may be negative depends on n, as (-1)**n does.

    The normal form is one for real exponents, where such a power has few values.
    """
    if n not in symbols(e):
        return False
    if e.op == "^" and n in symbols(e.args[1]) and sign(e.args[0], _beyond_one(n)) != "+":
        return True
    return any(alternates(arg, n) for arg in e.args if isinstance(arg, Expr) and not arg.hidden)


def _beyond_one(n: str) -> Given:
    return Given(((symbol(n), ">", ONE),))


def divided(statement: Statement, n: Expr) -> Divided | str | None:
    """Return the recurrence of a statement, why it is none of this kind, or None."""
    whole: Expr | None = None
    starts: dict[int, fmpq] = {}
    pairs = []
    for pair in statement.equations:
        nodes = {node for e in pair for node in functions(e) if not is_rounded(node)}
        if len(nodes) == 1 and n.args[0] not in symbols(pair[0]) | symbols(pair[1]):
            (node,) = nodes
            k = integer(node.args[1]) if len(node.args) == 2 else None
            value = tidied(pair[1] if pair[0] == node else pair[0])
            if node not in pair or k is None or value.op != "number" or k in starts:
                return None
            starts[k] = value.args[0]
            whole = whole or node.args[0]
            if node.args[0] != whole:
                return None
        else:
            pairs.append((pair, nodes))
    if len(pairs) != 1:
        return None
    (pair, nodes) = pairs[0]
    if len({m.args[0] for m in nodes} | ({whole} if whole else set())) != 1:
        return None
    whole_nodes = [m for m in nodes if len(m.args) == 2 and m.args[1] == n]
    if len(whole_nodes) != 1 or any(len(m.args) != 2 for m in nodes):
        return None
    (node,) = whole_nodes
    if any(_slope(m.args[1], str(n)) in (None, 1) for m in nodes - {node}):
        return None
    marks = {m: symbol(f"[{k}]") for k, m in enumerate(sorted(nodes - {node}, key=str))}
    marks[node] = symbol("[T]")
    linear = replaced(pair[0] - pair[1], marks)
    names = {str(mark.args[0]) for mark in marks.values()}
    if not elementary(linear) or not symbols(linear) <= names | {str(n)}:
        return "the recurrence must be one of numbers"
    if alternates(linear, str(n)):
        return f"powers whose sign depends on {n} are not supported in such a recurrence"
    slopes = {
        m: tidied(normal_form(differentiate(linear, str(mark.args[0])), Given()))
        for m, mark in marks.items()
    }
    if any(e.op != "number" for e in slopes.values()) or slopes[node] == ZERO:
        return f"the recurrence must be {node} == a*T(…) + … + g({n}) with numbers a"
    lead = slopes.pop(node).args[0]
    branches = []
    for m, slope in slopes.items():
        a = -slope.args[0] / lead
        ratio = _slope(m.args[1], str(n))
        if ratio is None or ratio == 1:
            return None
        if not 0 < ratio < 1 or a <= 0:
            return f"{m} must have a factor > 0 and an argument below {n} that is a share of it"
        branches.append(Branch(a, m.args[1], ratio))
    rest = substitute(linear, dict.fromkeys(names, ZERO)) / number(-lead)
    short = tidied(normal_form(rest, Given()))
    if continuous_on(rest, Given(((n, ">", number(max(starts, default=1))),)), proof) is not None:
        return f"{short} must be defined where the recurrence holds"
    return Divided(node, tuple(branches), short, starts)


def _slope(e: Expr, n: str) -> fmpq | None:
    """Return b where an argument differs from b n by a bounded amount."""
    while True:
        node = next((m for m in functions(e) if is_rounded(m)), None)
        if node is None:
            break
        e = replaced(e, {node: node.args[1]})
    slope = tidied(normal_form(differentiate(e, n), Given())) if elementary(e) else ZERO
    if slope.op != "number" or symbols(e) != {n}:
        return None
    return slope.args[0]


class Growth(NamedTuple):
    """How T grows.

    Attributes:
        scale: T = Θ(scale), or None where the exponent p has no closed form.
        sharp: whether T ~ scale.
        low: a rational number below p.
        high: one above p.
        positive: whether this needs T > 0.
    """

    scale: Expr | None
    sharp: bool
    low: fmpq = fmpq(0)
    high: fmpq = fmpq(0)
    positive: bool = False


def decide_divided_arguments(
    claim: Comparison, statement: Statement, decided: Decide
) -> Answer | None:
    """Decide an order of T(n), or return None where no condition is such a recurrence.

    Args:
        claim: the comparison.
        statement: its conditions: the recurrence and first values, and the path n -> oo.
        decided: decides explicit claims.
    """
    path = statement.path
    if path is None or path.point is not None or path.sides != (1,) or claim.derivatives:
        return None
    n = symbol(path.name)
    found = divided(statement, n)
    if found is None or (isinstance(found, Divided) and not found.branches):
        return None

    def open_(why: str) -> Answer:
        return Answer(Verdict.UNDECIDED, why)

    if isinstance(found, str):
        return open_(found)
    if statement.given.comparisons or statement.integers not in ((), (path.name,)):
        return open_("conditions beside a divide-and-conquer recurrence are not supported")
    if claim.relation in ("O", "o") and elementary(claim.right):
        answer = _difference(claim, statement, found, decided)
        if answer is not None:
            return answer
    if claim.relation not in KINDS or claim.left != found.node or list(functions(claim.right)):
        return open_(f"orders of {found.node} are supported: == Theta(h), O(h), o(h) and ~ h")
    explicit = replace(statement, equations=(), integers=())
    vanishes = found.rest == ZERO and found.starts and not any(found.starts.values())
    if vanishes and _covered(found):
        answer = decided(replace(claim, left=ZERO), explicit)
        return replace(answer, why=f"{found.node} is 0 for every {n}: {answer.why}", lemma=LEMMA)
    growth = growth_of(found)
    if growth is None:
        return open_(f"{found.rest} must be about a power of {n} times a power of log({n})")
    if growth.positive and (why := _not_positive(found, decided, explicit)):
        return open_(why)
    if growth.scale is None:
        return _between(claim, explicit, found, growth, decided)
    if claim.relation == "~" and not growth.sharp:
        return open_(
            f"{found.node} = Theta({growth.scale}) is known; its ratio to that need not tend to a "
            "limit, because it may oscillate (a periodic factor)"
        )
    answer = decided(replace(claim, left=growth.scale), explicit)
    known = f"~ {growth.scale}" if growth.sharp else f"= Theta({growth.scale})"
    relation = "~ " if claim.relation == "~" else f"is {claim.relation}"
    compared = f"{growth.scale} {relation}({claim.right})" if answer else answer.why
    why = f"{found.node} {known}: {compared}"
    return replace(answer, why=why, lemma=LEMMA, region=None, constant=None)


def _difference(
    claim: Comparison, statement: Statement, found: Divided, decided: Decide
) -> Answer | None:
    """Decide T(n) − E(n) = O(h) or o(h) with an explicit E, or return None.

    The difference D satisfies the recurrence with g(n) + Σ aᵢ E(bᵢ n) − E(n) in place of g, up to
    O(|E′(n)|) from what is rounded.
    """
    n = symbol(found.name)
    if claim.left == found.node or set(functions(claim.left)) != {found.node}:
        return None
    solution = Comparison(claim.left, "==", ZERO).solved(found.node)
    if solution is None or solution[1].op != "number" or not elementary(solution[0]):
        return None
    e = solution[0]
    if symbols(e) != {found.name}:
        return None
    shares = [
        number(b.factor) * substitute(e, {found.name: number(b.ratio) * n}) for b in found.branches
    ]
    rest = add(found.rest, *shares, -e)
    plain = replace(statement, equations=(), integers=())
    first = None
    if not is_zero(rest, _beyond_one(found.name)):
        first = written_term(rest, found.name, None, 1, Given())
        if first is None:
            return None
    moved = written_term(differentiate(e, found.name), found.name, None, 1, Given())
    if moved is None or powers_of(moved[1], n) is None:
        return None
    if first is not None:
        apart = limit_of(moved[1] / first[1], found.name, None, 1, Given())
        lead = limit_of(rest / first[1], found.name, None, 1, Given())
        side = None if lead is None else sign(lead, Given())
        if apart == ZERO and side in ("+", "-"):
            signed = rest if side == "+" else -rest
            growth = growth_of(found._replace(rest=signed))
            if growth is not None and growth.sharp and growth.scale is not None:
                answer = decided(replace(claim, left=growth.scale), plain)
                why = f"{found.node} - ({e}) ~ {'-' * (side == '-')}({growth.scale}): {answer.why}"
                return replace(answer, why=why, lemma=LEMMA, region=None, constant=None)
    size = moved[1] if first is None else moved[1] + first[1]
    growth = growth_of(found._replace(rest=size))
    if growth is None:
        return None
    scale = power(n, number(growth.high)) if growth.scale is None else growth.scale
    answer = decided(replace(claim, left=scale), plain)
    why = f"{found.node} - ({e}) = O({scale}): {answer.why}"
    if not answer:
        answer = Answer(Verdict.UNDECIDED, why)
    return replace(answer, why=why, lemma=LEMMA, region=None, constant=None)


def _covered(found: Divided) -> bool:
    """Return whether the first values determine T, all of whose arguments are integers."""
    values = found.values(LOOKED_AT)
    return len(values) > LOOKED_AT // 2 and _reach(found) is not None


def _reach(found: Divided) -> int | None:
    """Return the largest N up to which values are known, if beyond it arguments are below n."""
    values = found.values(LOOKED_AT)
    if not values or max(values) < LOOKED_AT:
        return None
    return max(values)


def _not_positive(found: Divided, decided: Decide, statement: Statement) -> str:
    """Return why T > 0 is not shown from some n on, or nothing.

    For n > N all arguments lie between the first n with known positive values and n - 1.
    """
    n = symbol(found.name)
    if not all(branch.rounded for branch in found.branches):
        start = next(iter(found.starts.values()), None)
        first = next(iter(found.starts), 1)
        if start is None or start < 0 or (start == 0 and found.rest == ZERO):
            return f"a positive first value, such as {_called(found, 1)} == 1, is needed"
        beyond = Given(((n, ">", number(first)),))
        return _negative_rest(found, beyond, decided, statement, strict=start == 0)
    values = found.values(LOOKED_AT)
    if not values or max(values) < LOOKED_AT:
        need = max(values, default=0) + 1
        return f"the first values do not determine {_called(found, need)}: give more of them"
    last = max(values)
    low = last
    while low - 1 in values and values[low - 1] > 0:
        low -= 1
    least = min(branch.ratio for branch in found.branches)
    away = max(_away(branch) for branch in found.branches)
    if values[last] <= 0 or least * (last + 1) - away < low:
        return f"{found.node} > 0 is not shown from some {n} on"
    most = max(branch.ratio for branch in found.branches)
    if most * (last + 1) + away >= last + 1:
        return f"an argument is not below {n} at {n} = {last + 1}"
    return _negative_rest(found, Given(((n, ">", number(last)),)), decided, statement, False)


def _negative_rest(
    found: Divided, beyond: Given, decided: Decide, statement: Statement, strict: bool
) -> str:
    if found.rest == ZERO:
        return ""
    if continuous_on(found.rest, beyond, proof) is not None:
        return f"{found.rest} must be defined given {beyond}"
    plain = replace(statement, path=None, given=beyond)
    relation = ">" if strict else ">="
    if not decided(Comparison(found.rest, relation, ZERO), plain):
        return f"{found.rest} {relation} 0 given {beyond} is needed"
    return ""


def _away(branch: Branch) -> fmpq:
    """Return a bound of |argument − b n|."""
    e, away, count = branch.argument, fmpq(0), 0
    while True:
        node = next((m for m in functions(e) if is_rounded(m)), None)
        if node is None:
            break
        count += 1
        e = replaced(e, {node: node.args[1]})
    rest = tidied(normal_form(substitute(e, dict.fromkeys(symbols(e), ZERO)), Given()))
    away += abs(rest.args[0]) if rest.op == "number" else 10**6
    # each rounding moves by less than 1, times the size of its coefficient
    return away + fmpq(count) * _largest_coefficient(branch.argument)


def _largest_coefficient(e: Expr) -> fmpq:
    sizes = [fmpq(1)]
    stack = [e]
    while stack:
        node = stack.pop()
        if node.op == "number":
            sizes.append(abs(node.args[0]))
        stack += [arg for arg in node.args if isinstance(arg, Expr) and arg.op != "function"]
    product = fmpq(1)
    for size in sizes:
        product *= max(size, fmpq(1))
    return product


def _called(found: Divided, k: int) -> str:
    return f"{found.node.args[0].args[0]}({k})"


def growth_of(found: Divided) -> Growth | None:
    """Return how T grows."""
    n = symbol(found.name)
    if found.rest == ZERO:
        return homogeneous(found)
    first = written_term(found.rest, found.name, None, 1, Given())
    if first is None:
        return None
    s, t = powers_of(first[1], n) or (None, None)
    lead = limit_of(found.rest / first[1], found.name, None, 1, Given())
    if s is None or t is None or lead is None or sign(lead, Given()) != "+":
        return None
    total = add(*(number(b.factor) * power(number(b.ratio), number(s)) for b in found.branches))
    side = sign(total - 1, Given())
    if side == "+":
        return homogeneous(found)
    if side == "-":
        return Growth(tidied(normal_form(lead / (1 - total), Given())) * first[1], True)
    if side != "0" and not is_zero(total - 1, Given()):
        return None
    sizes: dict[fmpq, fmpq] = {}
    for b in found.branches:
        sizes[b.ratio] = sizes.get(b.ratio, fmpq(0)) + b.factor
    weights = [
        number(a) * power(number(ratio), number(s)) * apply("log", number(1 / ratio))
        for ratio, a in sizes.items()
    ]
    mean = tidied(add(*weights))
    same, log = ONE if s == 0 else power(n, number(s)), apply("log", n)
    if t > -1:
        whole = lead * same * power(log, number(t + 1)) / (number(t + 1) * mean)
        return Growth(tidied(whole), True)
    if t == -1:
        return Growth(tidied(lead * same * apply("log", log) / mean), True)
    return homogeneous(found)


def powers_of(e: Expr, n: Expr) -> tuple[fmpq, fmpq] | None:
    """Return s and t where ``e`` is n^s log(n)^t."""
    log = apply("log", n)
    s = _limit(differentiate(e, str(n)) * n / e, n)
    if s is None:
        return None
    beside = e / power(n, number(s))
    t = _limit(differentiate(beside, str(n)) * n * log / beside, n)
    if t is None or not is_zero(beside - power(log, number(t)), Given(((n, ">", number(3)),))):
        return None
    return s, t


def _limit(e: Expr, n: Expr) -> fmpq | None:
    found = limit_of(e, str(n), None, 1, Given())
    found = None if found is None else tidied(found)
    return found.args[0] if found is not None and found.op == "number" else None


def homogeneous(found: Divided) -> Growth | None:
    """Return n^p, exactly or between two powers."""
    branches = found.branches
    n = symbol(found.name)
    closed = _exponent(branches)
    if closed is not None:
        scale = ONE if closed == ZERO else power(n, closed)
        return Growth(scale, False, positive=True)
    low, high = _enclosed(branches)
    return None if low is None or high is None else Growth(None, False, low, high, True)


def _exponent(branches: tuple[Branch, ...]) -> Expr | None:
    """Return p with Σ aᵢ bᵢᵖ = 1 in closed form."""
    for q in (1, 2, 3, 4):
        for k in sorted(range(-12 * q, 12 * q + 1), key=abs):
            p = number(fmpq(k, q))
            total = add(*(number(b.factor) * power(number(b.ratio), p) for b in branches))
            with ball_precision():
                close = _ball(branches, fmpq(k, q)).contains(1)
            if close and is_zero(total - 1, Given()):
                return p
    sizes: dict[fmpq, fmpq] = {}
    for b in branches:
        sizes[b.ratio] = sizes.get(b.ratio, fmpq(0)) + b.factor
    ratios = sorted(sizes, reverse=True)
    if len(ratios) == 1:
        return apply("log", number(sizes[ratios[0]])) / apply("log", number(1 / ratios[0]))
    if len(ratios) == 2 and ratios[1] == ratios[0] ** 2:
        a, b = sizes[ratios[0]], sizes[ratios[1]]
        x = (sqrt(number(a * a + 4 * b)) - number(a)) / number(2 * b)  # b x² + a x = 1
        return apply("log", 1 / x) / apply("log", number(1 / ratios[0]))
    return None


def _ball(branches: tuple[Branch, ...], p: fmpq) -> arb:
    return sum((arb(b.factor) * arb(b.ratio) ** arb(p) for b in branches), arb(0))


def _enclosed(branches: tuple[Branch, ...]) -> tuple[fmpq | None, fmpq | None]:
    """Return numbers below and above p; the sum falls with p."""
    with ball_precision():
        low, high = fmpq(-LARGEST_EXPONENT), fmpq(LARGEST_EXPONENT)
        if not (_ball(branches, low) > 1 and _ball(branches, high) < 1):
            return None, None
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            if max(abs(middle.p), middle.q) > MAX_POWER:
                break
            value = _ball(branches, middle)
            if value > 1:
                low = middle
            elif value < 1:
                high = middle
            else:
                break
        return low, high


def _between(
    claim: Comparison, statement: Statement, found: Divided, growth: Growth, decided: Decide
) -> Answer:
    """Decide a claim about T = Θ(n^p) where p is known between two numbers."""
    n = symbol(found.name)
    low, high = (power(n, number(p)) for p in (growth.low, growth.high))
    with ball_precision():
        middle = arb((growth.low + growth.high) / 2).str(8, radius=False)
    said = f"{found.node} = Theta({n}**p) with p = {middle}…"

    def holds(left: Expr, relation: str) -> bool:
        return bool(decided(replace(claim, left=left, relation=relation), statement))

    right, relation = claim.right, claim.relation
    verdict = Verdict.UNDECIDED
    below, above = holds(high, "o"), holds(low, "omega")
    if (relation in ("O", "o") and below) or (relation == "omega" and above):
        verdict = Verdict.ENCLOSED
    elif below or above:
        verdict = Verdict.REFUTED
    order = "of smaller order than" if below else "of larger order than" if above else "compared to"
    why = f"{said}, {order} {right}"
    if verdict is Verdict.UNDECIDED:
        why = f"{said}, which is too close to {right}"
    return Answer(verdict, why, lemma=LEMMA)
