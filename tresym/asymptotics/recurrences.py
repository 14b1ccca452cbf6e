"""Decide claims about a sequence that a recurrence a(n + 1) = f(a(n)) and a first value determine.

Example: ``a(n) ~ sqrt(3/n) given a(n+1) == sin(a(n)), a(0) == 1 as n -> oo``.

*Linear recurrences* are solved: a(n) = L + (a(k) − L) pⁿ⁻ᵏ for f(x) = p x + q and L = q/(1 − p).

*The limit.* Let a(k) > L, and for L < x ≤ a(k) let f be continuous with L < f(x) < x. Then the
sequence decreases, and its limit is a fixed point of f in [L, a(k)), so that it is L. The same
holds from below, and for L = ∞. Otherwise |f′| ≤ q < 1 on an interval around the fixed point L
shows that a(n) → L.

*The rate, where f(x) − x = o(x − L).* If a function ψ satisfies ψ(f(x)) − ψ(x) → d > 0 as x → L,
then ψ(a(n))/n → d by the theorem of Stolz and Cesàro. With the next term of
ψ(f(x)) − ψ(x) − d ~ e(x), the sum of e(a(n)) gives ψ(a(n)) = d n + S(n) + O(1). For sin x and
L = 0, ψ = 1/x² gives d = 1/3, e = x²/15 ~ 1/(5 n) and S = log(n)/5.

*Geometric convergence.* If L is approached monotonically and 0 < f′(L) = λ < 1, with f″ bounded
near L, then a(n) − L ~ K λⁿ with a constant K ≠ 0 (G. Koenigs 1884).

Sources: N. G. de Bruijn, *Asymptotic Methods in Analysis*, 1958, chapter 8; K. Knopp, *Theory and
Application of Infinite Series*, 1951, §9 (Stolz).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.approximation import Approximation, approximated, size
from tresym.asymptotics.divide_and_conquer import decide_divided
from tresym.asymptotics.divided_arguments import (
    Divided,
    decide_divided_arguments,
    divided,
    growth_of,
)
from tresym.asymptotics.dominant_roots import decide_by_largest_root
from tresym.asymptotics.first_order_recurrences import FirstOrder, first_order
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.asymptotics.lemma_claims import approximations, decide_with_expansions
from tresym.asymptotics.linear_recurrences import (
    LINEAR,
    UNSUPPORTED_ROOTS,
    Solved,
    sequence_nodes,
    solved,
)
from tresym.asymptotics.rooted_arguments import decide_rooted
from tresym.asymptotics.roots import zeros_of
from tresym.asymptotics.systems_of_sequences import decide_system
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.leading_terms import written_term
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
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
from tresym.reals.language.parsing import Compared
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LIMIT_LEMMA = "monotone sequences and fixed points"
RATE_LEMMA = "the theorem of Stolz and Cesàro (de Bruijn 1958, chapter 8)"
MOST_STEPS = 12
"""Steps of the recurrence after which the sequence must be monotone."""
ITERATIONS = 200
"""Steps in numbers by which the limit is guessed."""
RATIOS = (fmpq(1, 2), fmpq(9, 10), fmpq(99, 100))
"""Bounds of |f'| that are tried."""
_X, _W = "[x]", "[w]"
_INFINITE = (INFINITY, -INFINITY)


class _OpenError(Exception):
    """The recurrence is of a kind that is not supported; the text says which are."""


class _Sequence(NamedTuple):
    """A sequence a(n + 1) = f(a(n)) with its first value.

    Attributes:
        node: a(n).
        f: the function, of the variable ``_X``.
        first: the index of the first value.
        start: the first value.
        given: the conditions on the parameters.
    """

    node: Expr
    f: Expr
    first: int
    start: Expr
    given: Given


def decide_recurrence(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about a sequence as its index tends to infinity.

    Args:
        claim: the comparison.
        statement: its conditions with the recurrence and the first value, and the path n -> oo.
        decided: decides explicit claims.
    """
    try:
        found = _decide(claim, statement, decided)
        parts = (
            o._replace(claim=_shown(o.claim), given=_shown(o.given)) for o in found.obligations
        )
        witness = {n: v for n, v in (found.witness or {}).items() if n not in (_X, _W)}
        if found.verdict is not Verdict.REFUTED:
            return replace(found, why=_shown(found.why), obligations=tuple(parts))
        return replace(
            found, why=_shown(found.why), obligations=tuple(parts), witness=witness, values=None
        )
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    assert path is not None
    if path.point is not None or path.sides != (1,) or claim.derivatives:
        raise _OpenError("claims about a sequence are supported as n -> oo, without derivatives")
    answer = decide_system(claim, statement, decided)
    answer = decide_divided(claim, statement, decided) if answer is None else answer
    answer = decide_rooted(claim, statement, decided) if answer is None else answer
    if answer is None or answer.verdict is Verdict.UNDECIDED:
        other = decide_divided_arguments(claim, statement, decided)
        if answer is None or (other is not None and other.verdict is not Verdict.UNDECIDED):
            answer = other
    if answer is not None:
        return answer
    higher = solved(statement, path.name)
    if higher is not None and len(higher.coefficients) > 1:
        return _of_higher_order(claim, statement, higher, decided)
    first = first_order(statement, path.name)
    if first is not None and (first.added != ZERO or path.name in symbols(first.factor)):
        return _of_higher_order(claim, statement, first, decided)
    sequence = _sequence(statement)
    n = symbol(path.name)
    names = {node for e in (claim.left, claim.right) for node in functions(e)}
    if names - {sequence.node}:
        following = _shifted(sequence.node, n, 1)
        put = {following: substitute(sequence.f, {_X: sequence.node})}
        claim = claim.mapped(partial(replaced, known=put))
        names = {node for e in (claim.left, claim.right) for node in functions(e)}
    if names != {sequence.node}:
        raise _OpenError(f"the claim must be about {sequence.node} alone")
    whole = tuple(dict.fromkeys((*statement.integers, path.name)))
    rest = replace(statement, equations=(), given=sequence.given, integers=whole)
    solution = _linear(sequence, n)
    if solution is not None:
        explicit = claim.mapped(partial(replaced, known={sequence.node: solution}))
        answer = decided(explicit, rest)
        why = f"{sequence.node} = {solution}: {answer.why}"
        return replace(answer, why=why, lemma=LINEAR, region=None, constant=None)
    return _of_limit(claim, rest, sequence, decided)


def _of_higher_order(
    claim: Comparison, statement: Statement, sequence: Solved | FirstOrder, decided: Decide
) -> Answer:
    """Decide a claim about the solution of a linear recurrence of order 2 and more."""
    n = sequence.n
    if n in statement.given.names:
        raise _OpenError(f"conditions on {n} beside a recurrence are not supported")
    nodes = set(sequence_nodes(claim))
    if any(m.args[0] != sequence.name or _shift(m, symbol(n)) is None for m in nodes):
        raise _OpenError(f"the claim must be about {sequence.name.args[0]}({n}) alone")
    form = sequence.closed()
    if form is None and isinstance(sequence, Solved):
        found = decide_by_largest_root(claim, statement, sequence, decided)
        if found is not None:
            return found
    if form is None:
        raise _OpenError(UNSUPPORTED_ROOTS)
    whole = tuple(dict.fromkeys((*statement.integers, n)))
    known = {node: tidied(substitute(form, {n: node.args[1]})) for node in nodes}
    explicit = claim.mapped(partial(replaced, known=known))
    answer = decided(explicit, replace(statement, equations=(), integers=whole))
    why = f"{sequence.name.args[0]}({n}) = {form}: {answer.why}"
    return replace(answer, why=why, lemma=LINEAR, region=None, constant=None)


def _shown(text: str) -> str:
    """Return a text with plain names for the variables of this module."""
    return text.replace(_X, "x").replace(_W, "w").replace("[K]", "K")


def _sequence(statement: Statement) -> _Sequence:
    """Return the sequence that a statement describes."""
    path = statement.path
    assert path is not None
    n = symbol(path.name)
    if len(statement.recurrences) != 1:
        raise _OpenError("one recurrence at a time is supported")
    (pair,) = statement.recurrences
    gap_nodes = [node for e in pair for node in functions(e)]
    shifts = {node: _shift(node, n) for node in gap_nodes}
    kinds = sorted({k for k in shifts.values() if k is not None})
    if None in shifts.values() or len(kinds) != 2 or kinds[1] - kinds[0] != 1:
        raise _OpenError(
            "recurrences of the form a(n + 1) == f(a(n)) are supported: of first order, and with "
            "constant coefficients"
        )
    low = next(node for node, k in shifts.items() if k == kinds[0])
    high = next(node for node, k in shifts.items() if k == kinds[1])
    node = _shifted(low, n, -kinds[0])
    other = pair[1] if pair[0] == high else pair[0] if pair[1] == high else None
    if other is None or high in list(functions(other)):
        raise _OpenError(f"write the recurrence with {high} alone on one side")
    f = replaced(other, {low: symbol(_X)})
    if not elementary(f) or path.name in symbols(f):
        raise _OpenError(
            f"recurrences a(n + 1) == f(a(n)) are supported whose right side depends on "
            f"{path.name} through a({path.name}) alone"
        )
    others = [other for other in statement.equations if other != pair]
    if len(others) != 1:
        raise _OpenError("one first value, such as a(0) == 1, determines a sequence")
    for left, right in (others[0], others[0][::-1]):
        at = left.op == "unknown" and left.args[0] == node.args[0] and integer(left.args[1])
        if at is not False and at is not None and elementary(right):
            if path.name in symbols(right) or path.name in statement.given.names:
                raise _OpenError(f"conditions on {path.name} beside a recurrence are not supported")
            return _Sequence(node, f, int(at), right, statement.given)
    raise _OpenError("one first value, such as a(0) == 1, determines a sequence")


def _shift(node: Expr, n: Expr) -> int | None:
    return integer(tidied(normal_form(node.args[1] - n, Given()))) if len(node.args) == 2 else None


def _shifted(node: Expr, n: Expr, by: int) -> Expr:
    """Return a(m + by) for a(m)."""
    place = tidied(normal_form(node.args[1] + by, Given()))
    return Expr("unknown", (node.args[0], n if place == n else place))


def _linear(sequence: _Sequence, n: Expr) -> Expr | None:
    """Return a(n) for a linear function f with a slope that is a number."""
    slope = tidied(differentiate(sequence.f, _X))
    if _is_fixed(sequence.f, sequence.start, sequence.given):
        return sequence.start
    if slope.op != "number" or not is_zero(differentiate(slope, _X), Given()):
        return None
    p, q = slope.args[0], tidied(substitute(sequence.f, {_X: ZERO}))
    steps = n - sequence.first
    if p == 1:
        return sequence.start + q * steps
    fixed = q / number(1 - p)
    geometric = power(number(abs(p)), steps) if p else ZERO
    if p < 0:
        geometric = power(MINUS_ONE, steps) * geometric
    return fixed + (sequence.start - fixed) * geometric


# The limit


class _Found(NamedTuple):
    """The limit of a sequence.

    Attributes:
        limit: the limit, which may be infinite.
        side: +1 where the sequence lies above its limit (or tends to −∞), −1 below; 0 where that
            is not known.
        obligations: what was shown for it.
    """

    limit: Expr
    side: int
    obligations: Obligations


def _is_fixed(f: Expr, x: Expr, given: Given) -> bool:
    """Return whether f(x) = x, where x is defined and a number if it has no parameters."""
    if not symbols(x) and symbols(f) <= {_X}:
        with ball_precision():
            if not evaluate(f, {_X: evaluate(x, {})}).is_finite():
                return False
    return is_zero(substitute(f, {_X: x}) - x, given)


def _of_limit(
    claim: Comparison, statement: Statement, sequence: _Sequence, decided: Decide
) -> Answer:
    found = _limit(claim, sequence, replace(statement, integers=()), decided)
    if found is None:
        raise _OpenError(
            f"the limit of {sequence.node} is not found: neither monotone convergence to a fixed "
            "point nor a contraction is shown"
        )
    end, node = found.limit, sequence.node
    if claim.relation == LIMIT and claim.left == node:
        same = claim.right == end
        if not same and not {claim.right, end} & {*_INFINITE}:
            same = is_zero(claim.right - end, sequence.given)
            if not same and not decided(
                Comparison(claim.right, "!=", end), replace(statement, path=None, integers=())
            ):
                raise _OpenError(f"{node} tends to {end}, and it is open whether that is the limit")
        ask = found.obligations
        verdict = ask.verdict if same else Verdict.REFUTED
        why = f"{node} tends to {end} by {LIMIT_LEMMA}: {'; '.join(map(str, ask.found[:2]))}"
        return Answer(verdict, why, lemma=LIMIT_LEMMA, obligations=tuple(ask.found))
    rate = _rate(sequence, found, statement)
    if rate is None:
        if end in _INFINITE:
            raise _OpenError(f"{node} tends to {end}, at a rate that is not found")
        known: Expansion = _attracted(sequence, end, found, statement)
        return decide_with_expansions(
            claim.mapped(partial(replaced, known={node: symbol(_W)})),
            statement,
            decided,
            {symbol(_W): known},
        )
    value, expansion = rate
    moved = claim.mapped(partial(replaced, known={node: value}))
    answer = decide_with_expansions(moved, statement, decided, {symbol(_W): expansion})
    return replace(answer, why=f"with {node} = {value}: {answer.why}")


def _limit(
    claim: Comparison, sequence: _Sequence, statement: Statement, decided: Decide
) -> _Found | None:
    candidates = _candidates(claim, sequence, _iterated(sequence))
    for start in _starts(sequence):
        for end in candidates:
            ask = Obligations(statement, decided)
            side = _monotone(sequence, start, end, ask)
            if side:
                return _Found(end, side, ask)
            ask = Obligations(statement, decided)
            if end not in _INFINITE and _contracts(sequence, start, end, ask):
                return _Found(end, 0, ask)
    return None


def _iterated(sequence: _Sequence) -> arb | None:
    """Return a late value of the sequence in numbers, or None; nothing is proved."""
    names = symbols(sequence.start) | symbols(sequence.f) - {_X}
    point = sequence.given.satisfying_point(sorted(names))
    if point is None:
        return None
    with ball_precision(128):
        x = evaluate(sequence.start, point).mid()
        for _ in range(ITERATIONS):
            y = evaluate(sequence.f, {**point, _X: x})
            if not y.is_finite() or abs(y) > arb(10) ** 50:
                break
            x = y.mid()
    return x


def _starts(sequence: _Sequence) -> Iterator[tuple[Expr, Expr]]:
    """Yield bounds of the first value and of those after it."""
    yield sequence.start, sequence.start
    if symbols(sequence.start) or symbols(sequence.f) - {_X}:
        return
    found = []
    with ball_precision(256):
        x = evaluate(sequence.start, {})
        for _ in range(MOST_STEPS):
            x = evaluate(sequence.f, {_X: x})
            if not x.is_finite():
                break
            found.append((number(_rational(x.lower(), -1)), number(_rational(x.upper(), 1))))
    yield from found


def _rational(x: arb, side: int) -> fmpq:
    """Return a short rational at most, or at least, as large as ``x``."""
    scaled = x * 2**40
    whole = scaled.floor() if side < 0 else scaled.ceil()
    return fmpq(int(whole.mid().fmpq().p), 2**40)


def _candidates(claim: Comparison, sequence: _Sequence, guess: arb | None) -> list[Expr]:
    """Return what may be the limit, the likeliest first."""
    fixed = zeros_of(sequence.f - symbol(_X), _X, sequence.given)
    fixed += [e for e in _simple(guess) if e not in fixed]
    fixed = [e for e in fixed if _is_fixed(sequence.f, e, sequence.given)]
    found = [*fixed, INFINITY, -INFINITY]
    if claim.relation == LIMIT and elementary(claim.right) and claim.right not in found:
        found.insert(0, claim.right)
    if guess is None:
        return list(dict.fromkeys(found))

    def distance(e: Expr) -> float:
        if e in _INFINITE:
            return 1 / (1 + abs(float(guess)))
        with ball_precision():
            value = evaluate(e, {})
        return abs(float((value - guess).mid())) if value.is_finite() else 1e9

    numbers = [e for e in found if not symbols(e) or e in _INFINITE]
    return sorted(numbers, key=distance)[:3] + [e for e in found if e not in numbers]


def _simple(guess: arb | None) -> Iterator[Expr]:
    """Yield simple numbers that may be fixed points."""
    yield from map(number, (0, 1, -1, 2, -2))
    if guess is None or abs(guess) > 1000:
        return
    for square in (False, True):
        close = float(guess * guess if square else guess)
        for q in range(1, 13):
            p = fmpq(round(close * q), q)
            if abs(int(p.p) / int(p.q) - close) < 1e-3:
                side = 1 if guess > 0 else -1
                yield side * sqrt(number(p)) if square else number(p)
                break


def _monotone(sequence: _Sequence, start: tuple[Expr, Expr], end: Expr, ask: Obligations) -> int:
    """Return on which side of its limit a sequence lies that tends to it monotonically, or 0."""
    x, f, given = symbol(_X), sequence.f, sequence.given
    low, high = start
    if end in _INFINITE:
        side = -1 if end == INFINITY else 1
        inside: tuple[Compared, ...] = ((x, ">=", low) if side < 0 else (x, "<=", high),)
        wanted = [(side * (f - x), "<", ZERO)]
    else:
        side = next((s for s, e in ((1, low), (-1, high)) if sign(s * (e - end), given) == "+"), 0)
        if not side:
            return 0
        inside = ((x, ">", end), (x, "<=", high)) if side > 0 else ((x, "<", end), (x, ">=", low))
        wanted = [(side * (f - x), "<", ZERO), (side * (f - end), ">", ZERO)]
    where = given & Given(inside) & _bounds_of_start(sequence, inside[-1][1][0])
    if continuous_on(f, where, proof) is not None:
        return 0
    if not all(ask.holds(*link, where) for link in wanted):
        return 0
    return side


def _bounds_of_start(sequence: _Sequence, side: str) -> Given:
    """Return bounds of a first value c that is a parameter, as those of x <= c, or of x >= c.

    Args:
        sequence: the sequence.
        side: ``<`` for upper bounds, ``>`` for lower ones.
    """
    links: list[Compared] = []
    for left, relation, right in sequence.given.comparisons:
        mirrored = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}.get(relation, "")
        if left == sequence.start and relation[0] == side and not symbols(right):
            links.append((symbol(_X), relation, right))
        if right == sequence.start and mirrored.startswith(side) and not symbols(left):
            links.append((symbol(_X), mirrored, left))
    return Given(tuple(links))


def _contracts(sequence: _Sequence, start: tuple[Expr, Expr], end: Expr, ask: Obligations) -> bool:
    """Return whether f contracts an interval around its fixed point that holds the start."""
    x, given = symbol(_X), sequence.given
    if (
        symbols(end)
        or any(map(symbols, start))
        or not is_zero(substitute(sequence.f, {_X: end}) - end, given)
    ):
        return False
    with ball_precision():
        low, high, middle = (evaluate(e, {}) for e in (*start, end))
        far = max((abs(e - middle).upper() for e in (low, high)), key=float)
        radius = number(_rational(far, 1) + fmpq(1, 1000))
    where = given & Given(((x, ">=", end - radius), (x, "<=", end + radius)))
    if continuous_on(sequence.f, where, proof) is not None:
        return False
    slope = differentiate(sequence.f, _X)
    if continuous_on(slope, where, proof) is not None:
        return False
    return any(ask.holds(abs(slope), "<=", number(q), where) for q in RATIOS)


# The rate


class _Tends(Expansion):
    """A sequence of which the limit alone is known."""

    lemma = LIMIT_LEMMA
    is_little_o = True

    def __init__(self, limit: Expr, found: _Found) -> None:
        """Take the limit."""
        self.limit, self.found = limit, found

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the limit with an error o(1)."""
        return (self.limit, ONE) if order == 1 else None

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """What is needed was shown with the limit."""
        _keep(self.found, ask)
        return Bound()


class _Attracted(_Tends):
    """A sequence with a(n) − L = o(qⁿ) for every q > |f′(L)|, as f′ is continuous at L."""

    lemma = "the mean value theorem near a fixed point"

    def __init__(self, limit: Expr, slope: fmpq, n: Expr, found: _Found) -> None:
        """Take |f′(L)| < 1."""
        super().__init__(limit, found)
        self.slope, self.n = slope, n

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the limit with an error o(qⁿ), with q nearer to |f′(L)| for higher orders."""
        q = fmpq(1, 10**order) if self.slope == 0 else self.slope + (1 - self.slope) / 4**order
        return self.limit, power(number(q), self.n)


class _Geometric(_Tends):
    """A sequence with a(n) − L ~ K λⁿ and an unknown constant K > 0."""

    lemma = "Koenigs' theorem on geometric convergence to a fixed point"
    unknown = frozenset(("[K]",))
    constants = Given(((symbol("[K]"), ">", ZERO),))

    def __init__(self, ratio: Expr, n: Expr, found: _Found) -> None:
        """Take the ratio λ."""
        super().__init__(ZERO, found)
        self.ratio, self.n = ratio, n

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return K λⁿ with an error o(λⁿ)."""
        whole = power(self.ratio, self.n)
        return (symbol("[K]") * whole, whole) if order == 1 else None


class _Stolz(Expansion):
    """ψ(a(n)) = d n + S(n) + an error.

    Attributes:
        known: approximations, each better than the one before.
    """

    lemma = RATE_LEMMA

    def __init__(self, known: list[Approximation], found: _Found) -> None:
        """Take the approximations."""
        self.known, self.found = known, found

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return an approximation."""
        if order > len(self.known):
            return None
        main, error, self.is_little_o = self.known[order - 1]
        return main, error

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """What is needed was shown when the approximations were found."""
        _keep(self.found, ask)
        return Bound()


def _keep(found: _Found, ask: Obligations) -> None:
    ask.found += [part for part in found.obligations.found if part not in ask.found]
    if found.obligations.verdict is Verdict.ENCLOSED:
        ask.verdict = Verdict.ENCLOSED


def _attracted(sequence: _Sequence, end: Expr, found: _Found, statement: Statement) -> _Tends:
    """Return how fast a sequence tends to a fixed point, from the slope of f there."""
    path, name = statement.path, _X
    plain = _Tends(end, found)
    if path is None or symbols(end) or sequence.given.comparisons or symbols(sequence.f) != {name}:
        return plain
    slope = differentiate(sequence.f, name)
    with ball_precision():
        middle = evaluate(end, {})
        if not middle.is_finite():
            return plain
        radius = number(fmpq(1, 10**6))
    near = Given(((symbol(name), ">=", end - radius), (symbol(name), "<=", end + radius)))
    if continuous_on(sequence.f, near, proof) is not None:
        return plain
    if continuous_on(slope, near, proof) is not None:
        return plain
    value = tidied(normal_form(abs(substitute(slope, {name: end})), Given()))
    if is_zero(value, Given()):
        value = ZERO
    if value.op != "number" or not value.args[0] < 1:
        return plain
    return _Attracted(end, value.args[0], symbol(path.name), found)


def _rate(
    sequence: _Sequence, found: _Found, statement: Statement
) -> tuple[Expr, _Stolz | _Geometric] | None:
    """Return a(n) in terms of ψ(a(n)), or of its distance from the limit, and how that behaves."""
    path = statement.path
    assert path is not None
    if not found.side:
        return None
    x, n, given = symbol(_X), symbol(path.name), sequence.given
    infinite = found.limit in _INFINITE
    point, side = (None, -found.side) if infinite else (found.limit, found.side)
    step = sequence.f - x
    if not infinite:
        slope = limit_of(differentiate(sequence.f, _X), _X, point, side, given)
        bend = limit_of(differentiate(differentiate(sequence.f, _X), _X), _X, point, side, given)
        if slope is None or slope in _INFINITE:
            return None
        below = sign(slope, given) == "+" and sign(1 - slope, given) == "+"
        if below and bend not in (None, *_INFINITE):
            return found.limit + side * symbol(_W), _Geometric(slope, n, found)
        if not is_zero(slope - 1, given):
            return None
    distance = side * x if infinite else side * (x - found.limit)
    first = written_term(step, _X, point, side, given)
    if first is None:
        return None
    for psi, inverse in _transforms(first[1], distance):
        psi_next = substitute(psi, {_X: sequence.f})
        gain = limit_of(psi_next - psi, _X, point, side, given)
        if gain is None or gain in _INFINITE or sign(gain, given) != "+":
            continue
        value = side * inverse if infinite else found.limit + side * inverse
        end = End(path.name, None, 1, given, frozenset())
        rest = psi_next - psi - gain
        known = _stolz(gain, rest, value, (point, side), end)
        return value, _Stolz(known, found)
    return None


def explicit_sequence(statement: Statement) -> tuple[Expr, int] | None:
    """Return the solution of a linear recurrence on n, and from which n on the recurrence holds."""
    path = statement.path
    if path is None or statement.given.comparisons:
        return None
    found = solved(statement, path.name) or first_order(statement, path.name)
    form = None if found is None else found.closed()
    return None if found is None or form is None else (form, found.first - min(found.lowest, 0))


def growth(e: Expr, statement: Statement) -> tuple[str, Expr] | None:
    """Return ``~`` or ``Theta`` and how a divide-and-conquer recurrence may grow; not proved."""
    path = statement.path
    if path is None:
        return None
    found = divided(statement, symbol(path.name))
    if not isinstance(found, Divided) or not found.branches or e != found.node:
        return None
    known = growth_of(found)
    if known is None or known.scale is None:
        return None
    return "~" if known.sharp else "Theta", known.scale


def sequence_approximations(
    e: Expr, statement: Statement, decided: Decide
) -> Iterator[tuple[Expr, Expr]]:
    """Yield explicit approximations of a sequence a(n), each with its error.

    Raises:
        InputError: nothing is found; the text says why.
    """
    path = statement.path
    assert path is not None
    explicit = explicit_sequence(statement)
    if explicit is not None:
        form, _ = explicit
        if not form.hidden:
            yield form, ZERO
            return
        rest = replace(statement, equations=(), integers=(path.name,))
        yield from approximations(form, rest, decided)
        return
    try:
        sequence = _sequence(statement)
        if e != sequence.node:
            raise _OpenError(f"write {sequence.node} to be expanded")
        solution = _linear(sequence, symbol(path.name))
        if solution is not None:
            yield solution, ZERO
            return
        rest = replace(statement, equations=(), given=sequence.given, integers=())
        found = _limit(Comparison(e, "O", ONE), sequence, rest, decided)
        rate = None if found is None else _rate(sequence, found, statement)
    except _OpenError as error:
        raise InputError(str(error)) from None
    if rate is None or not isinstance(rate[1], _Stolz):
        raise InputError(f"no rate of {sequence.node} was found")
    end = End(path.name, None, 1, sequence.given)
    for known in rate[1].known:
        whole = approximated(rate[0], {symbol(_W): known}, end)
        if whole is not None:
            yield whole.main, whole.error


def _transforms(step: Expr, distance: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Yield functions ψ with ψ′ about 1/|f(x) − x|, and the distance from the limit by ψ = w."""
    w = symbol(_W)
    exponent = _exponent(step, distance)
    if exponent is not None and exponent != 1:
        r = number(1 - exponent)
        yield power(distance, r), power(w, 1 / r)
    if step.op == "exp":
        k = tidied(normal_form(-step.args[0] / distance, Given()))
        if not symbols(k):
            yield apply("exp", k * distance), apply("log", w) / k


def _exponent(e: Expr, distance: Expr) -> fmpq | None:
    """Return p where ``e`` is the power distance^p."""
    name = next(iter(symbols(distance)), _X)
    slope = tidied(
        normal_form(
            differentiate(e, name) * distance / (e * differentiate(distance, name)), Given()
        )
    )
    return slope.args[0] if slope.op == "number" else None


def _stolz(
    gain: Expr, rest: Expr, value: Expr, approach: tuple[Expr | None, int], end: End
) -> list[Approximation]:
    """Return approximations of ψ(a(n)), which grows by ``gain`` + ``rest`` at a(n).

    Args:
        gain: the limit of the growth.
        rest: the growth less its limit, in terms of a(n).
        value: a(n) in terms of ψ(a(n)).
        approach: where a(n) tends, and from which side.
        end: the path n -> oo.
    """
    n = symbol(end.name)
    known = [Approximation(gain * n, n, small=True)]
    point, side = approach
    if is_zero(rest, end.given):
        return [*known, Approximation(gain * n, ONE)]
    first = written_term(rest, _X, point, side, end.given)
    if first is None:
        return known
    term = first[0]
    start = substitute(term, {_X: substitute(value, {_W: gain * n})})
    if _is_summable(start, end):
        return [*known, Approximation(gain * n, ONE)]
    total = _summed(start, end)
    if total is None:
        return known
    increment, whole = total
    known.append(Approximation(gain * n + whole, size(whole, end), small=True))
    # the same again, with what is known now
    w = {symbol(_W): Approximation(gain * n, size(whole, end))}
    at = approximated(value, w, end)
    if at is None:
        return known
    better = approximated(term, {symbol(_X): at}, end)
    second = written_term(rest - term, _X, point, side, end.given)
    if better is None or (second is None and not is_zero(rest - term, end.given)):
        return known
    error = abs(better.main - increment) + better.error
    if second is not None:
        error = error + abs(substitute(second[0], {_X: substitute(value, {_W: gain * n})}))
    if _is_summable(error, end):
        known.append(Approximation(gain * n + whole, ONE))
    return known


def _is_summable(e: Expr, end: End) -> bool:
    """Return whether |e| = O(1/(n log² n)), so that its sum over n converges."""
    n = symbol(end.name)
    return end.limit(e * n * apply("log", n) ** 2) == ZERO


def _summed(e: Expr, end: End) -> tuple[Expr, Expr] | None:
    """Return K n^−t ~ e(n) with 0 < t ≤ 1, and its sum up to n in leading order."""
    n = symbol(end.name)
    first = written_term(e, end.name, None, 1, end.given)
    t = None if first is None else _exponent(first[1], n)
    if first is None or t is None or not -1 <= t < 0:
        return None
    factor = tidied(normal_form(first[0] / power(n, number(t)), Given()))
    if symbols(factor) & {end.name}:
        return None
    whole = apply("log", n) if t == -1 else power(n, number(1 + t)) / number(1 + t)
    return factor * power(n, number(t)), factor * whole
