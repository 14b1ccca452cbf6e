"""Solve linear recurrences with constant coefficients, for claims about every n from the first on.

Example: ``a(n) == 2**n - 1 given a(n+1) == 2*a(n) + 1, a(0) == 0, n integer, n >= 0``.

Let a(n + k) = c₁ a(n + k − 1) + … + c_k a(n) + f(n) with rational numbers and k consecutive values
from a(m) on, where f(n) is a sum of terms nᵈ rⁿ. The sequence satisfies the recurrence of higher
order whose characteristic polynomial has the factors (x − r)ᵈ⁺¹ once more. A root r of
multiplicity d contributes (A₀ + A₁ n + … ) rⁿ⁻ᵐ, with powers of n − m below d. Roots that are
rational, and pairs (s ± √D)/2, are supported. With D > 0, rⁿ + r̄ⁿ and √D (rⁿ − r̄ⁿ) are rational,
and so are 2 ρⁿ cos(nθ) and ρⁿ⁻¹ sin(nθ)/sin(θ) for the pair ρ e^{±iθ}, so that the coefficients
solve a linear system in rational numbers.

What is claimed of a(n) is claimed of this closed form. A counterexample is an n at which a(n) is
computed from the recurrence.

Source: R. L. Graham, D. E. Knuth and O. Patashnik, *Concrete Mathematics*, 1994, §7.3.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from flint import fmpq, fmpq_mat, fmpz_poly

from tresym.asymptotics.first_order_recurrences import FirstOrder, first_order
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import decided_at, tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
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
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.verdict import Verdict

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tresym.reals.language.comparisons import Comparison
    from tresym.reals.language.parsing import Compared

LINEAR = "the solution of a linear recurrence"
UNSUPPORTED_ROOTS = (
    "the roots of the characteristic polynomial are supported where they are rational, or of "
    "degree 2"
)
ANGLES = {
    fmpq(0): fmpq(1, 2),
    fmpq(1, 4): fmpq(1, 3),
    fmpq(1, 2): fmpq(1, 4),
    fmpq(3, 4): fmpq(1, 6),
}
"""By cos²(θ), the angles θ up to π/2, as shares of π."""
MOST_ORDER = 8
MOST_FORCED = 8
"""The largest degree of the polynomial that annihilates what is added."""
MOST_STEPS = 1000
"""Steps after the first value at which a counterexample is computed."""
LOOKED_AT = 12
"""Values of n at which a claim is computed before it is proved."""


class Solved(NamedTuple):
    """A linear recurrence with its values.

    Attributes:
        name: the function symbol, as in the nodes a(n).
        n: the index.
        first: the index of the first value.
        lowest: the recurrence at n contains a(n + lowest) and none below it.
        coefficients: a(n + k) = Σ coefficients[j] a(n + j), without the constant.
        constant: what is added, if it is a number.
        values: the first k values.
        forcing: what else is added at n to give a(n + lowest + k), or 0.
    """

    name: Expr
    n: str
    first: int
    lowest: int
    coefficients: tuple[fmpq, ...]
    constant: fmpq
    values: tuple[fmpq, ...]
    forcing: Expr = ZERO

    def terms(self) -> Iterator[fmpq]:
        """Yield a(first), a(first + 1), … exactly."""
        last = list(self.values)
        while True:
            yield last[0]
            following = self.constant
            for c, value in zip(self.coefficients, last, strict=True):
                following += c * value
            last = [*last[1:], following]

    def between(self, low: int, high: int) -> dict[Expr, Expr]:
        """Return a(low), …, a(high) exactly; before the first value the recurrence leads back."""
        known = dict(enumerate(islice(self.terms(), max(0, high - self.first) + 1), self.first))
        known |= dict(enumerate(self.values, self.first))
        for k in range(self.first - 1, low - 1, -1):
            rest = known[k + len(self.values)] - self.constant
            for j, c in enumerate(self.coefficients[1:], 1):
                rest -= c * known[k + j]
            known[k] = rest / self.coefficients[0]
        return {
            Expr("unknown", (self.name, number(k))): number(value)
            for k, value in sorted(known.items())
            if low <= k <= high
        }

    def closed(self) -> Expr | None:
        """Return a(n) as an explicit function of n, or None where the roots are not supported."""
        raised = [*(-c for c in self.coefficients), fmpq(1)]
        if self.constant:
            raised = [a - b for a, b in zip([fmpq(0), *raised], [*raised, fmpq(0)], strict=True)]
        scale = 1
        for c in raised:
            scale *= int(c.q)
        _, factors = fmpz_poly([int((c * scale).p) for c in raised]).factor()
        size, columns, forms = len(raised) - 1, [], []
        steps = symbol(self.n) - self.first
        for factor, times in factors:
            pairs = _powers(factor, steps, size)
            if pairs is None:
                return None
            for d in range(int(times)):
                for row, form in pairs:
                    columns.append([fmpq(k) ** d * value for k, value in enumerate(row)])
                    forms.append(form if d == 0 else steps**d * form)
        known = list(islice(self.terms(), size))
        system = fmpq_mat(size, size, [columns[j][i] for i in range(size) for j in range(size)])
        found = system.solve(fmpq_mat(size, 1, known))
        parts = (number(found[j, 0]) * forms[j] for j in range(size) if found[j, 0])
        return add(ZERO, *parts)


def _powers(factor: fmpz_poly, steps: Expr, size: int) -> list[tuple[list[fmpq], Expr]] | None:
    """Return sequences that an irreducible factor contributes: their values and their formula."""
    if factor.degree() == 1:
        r = fmpq(-int(factor[0]), int(factor[1]))
        if r == 0:
            return None
        return [([r**k for k in range(size)], _raised(number(abs(r)), r < 0, steps))]
    if factor.degree() != 2:
        return None
    lead = int(factor[2])
    s, t = fmpq(-int(factor[1]), lead), fmpq(int(factor[0]), lead)
    inside = s * s - 4 * t
    if inside < 0:
        return _turning(s, t, steps, size)
    root = sqrt(number(inside))
    upper, lower = (number(s) + root) / 2, (number(s) - root) / 2
    high = _raised(upper, False, steps) if s > 0 or t < 0 else _raised(-upper, True, steps)
    low = _raised(lower, False, steps) if s > 0 and t > 0 else _raised(-lower, True, steps)
    both, apart = [fmpq(2), s], [fmpq(0), inside]
    for row in (both, apart):
        while len(row) < size:
            row.append(s * row[-1] - t * row[-2])
    return [(both[:size], high + low), (apart[:size], root * (high - low))]


def _turning(s: fmpq, t: fmpq, steps: Expr, size: int) -> list[tuple[list[fmpq], Expr]]:
    """Return 2 ρⁿ cos(nθ) and ρⁿ⁻¹ sin(nθ)/sin(θ) for the roots ρ e^{±iθ} of x² − s x + t."""
    both, apart = [fmpq(2), s], [fmpq(0), fmpq(1)]
    for row in (both, apart):
        while len(row) < size:
            row.append(s * row[-1] - t * row[-2])
    square = s * s / (4 * t)
    share = ANGLES.get(square)
    if share is not None:
        angle = PI * number(share if s >= 0 else 1 - share)
    else:
        angle = apply("acos", number(s) / (2 * sqrt(number(t))))
    whole = ONE if t == 1 else power(number(t), steps / 2)
    sine = sqrt(number(t - s * s / 4))
    return [
        (both[:size], 2 * whole * apply("cos", angle * steps)),
        (apart[:size], whole * apply("sin", angle * steps) / sine),
    ]


def _raised(size: Expr, negative: bool, steps: Expr) -> Expr:
    """Return (±size)^steps for size > 0."""
    whole = ONE if size == ONE else power(size, steps)
    return power(MINUS_ONE, steps) * whole if negative else whole


def solved(statement: Statement, n: str) -> Solved | None:
    """Return the linear recurrence that the equations of a statement are, with its first values."""
    found: Solved | None = None
    starts: dict[int, fmpq] = {}
    for left, right in statement.equations:
        nodes = set(functions(left)) | set(functions(right))
        if any(len(node.args) != 2 for node in nodes) or len({m.args[0] for m in nodes}) != 1:
            return None
        places = {node: _place(node, n) for node in nodes}
        if None in places.values():
            return None
        if n in symbols(left) | symbols(right):
            if found is not None:
                return None
            found = _read(left, right, n, {m: k for m, k in places.items() if k is not None})
            if found is None:
                return None
        else:
            value = tidied(right if left in nodes else left)
            index = places[next(iter(nodes))]
            fits = (left in nodes or right in nodes) and len(nodes) == 1
            if not fits or value.op != "number" or index is None or index in starts:
                return None
            starts[index] = value.args[0]
        if found is not None and next(iter(nodes)).args[0] != found.name:
            return None
    if found is None or len(starts) != len(found.coefficients):
        return None
    first = min(starts)
    if sorted(starts) != list(range(first, first + len(starts))):
        return None
    names = {m.args[0] for pair in statement.equations for e in pair for m in functions(e)}
    if names != {found.name}:
        return None
    values = tuple(starts[k] for k in sorted(starts))
    return _with_forcing(found._replace(first=first, values=values))


def _place(node: Expr, n: str) -> int | None:
    """Return k for a(n + k), and for a(k)."""
    shift = node.args[1] - symbol(n) if n in symbols(node.args[1]) else node.args[1]
    return integer(tidied(normal_form(shift, Given())))


def _read(left: Expr, right: Expr, n: str, places: dict[Expr, int]) -> Solved | None:
    """Return a linear recurrence without its values."""
    if any(n not in symbols(node.args[1]) for node in places):
        return None
    low, high = min(places.values()), max(places.values())
    if not 1 <= high - low <= MOST_ORDER or len(set(places.values())) != len(places):
        return None
    marks = {node: symbol(f"[{k - low}]") for node, k in places.items()}
    whole = replaced(left - right, marks)
    names = {f"[{k}]" for k in range(high - low + 1)}
    if not elementary(whole) or not symbols(whole) <= names | {n}:
        return None
    slopes: list[fmpq] = []
    for k in range(high - low + 1):
        raw = differentiate(whole, f"[{k}]")
        if n in symbols(raw):  # the normal form of (-1)**n is that of real numbers
            return None
        slope = tidied(normal_form(raw, Given()))
        if slope.op != "number":
            return None
        slopes.append(slope.args[0])
    rest = substitute(whole, dict.fromkeys(names, ZERO))
    if n not in symbols(rest):
        rest = tidied(normal_form(rest, Given()))
    if slopes[-1] == 0 or slopes[0] == 0:
        return None
    name = next(iter(places)).args[0]
    coefficients = tuple(-c / slopes[-1] for c in slopes[:-1])
    if rest.op == "number":
        return Solved(name, n, 0, low, coefficients, -rest.args[0] / slopes[-1], ())
    added = rest * number(-1 / slopes[-1])
    return Solved(name, n, 0, low, coefficients, fmpq(0), (), added)


def _with_forcing(sequence: Solved) -> Solved | None:
    """Return the sequence by a recurrence of higher order to which nothing is added."""
    added, n = sequence.forcing, sequence.n
    if added == ZERO:
        return sequence
    bases = _exponentials(added, n)
    degree = sum(d + 1 for d in (bases or {}).values())
    if bases is None or degree > MOST_FORCED:
        return None
    order = len(sequence.coefficients)
    values = list(sequence.values)
    for k in range(degree):
        at = sequence.first + k - sequence.lowest
        more = tidied(normal_form(substitute(added, {n: number(at)}), Given()))
        if more.op != "number":
            return None
        pairs = zip(sequence.coefficients, values[-order:], strict=True)
        values.append(sum((c * x for c, x in pairs), more.args[0]))
    raised = [*(-c for c in sequence.coefficients), fmpq(1)]
    for r, d in bases.items():
        for _ in range(d + 1):  # times x - r
            raised = [
                x - r * y for x, y in zip([fmpq(0), *raised], [*raised, fmpq(0)], strict=True)
            ]
    coefficients = tuple(-c for c in raised[:-1])
    return sequence._replace(coefficients=coefficients, values=tuple(values), forcing=ZERO)


def _exponentials(e: Expr, n: str) -> dict[fmpq, int] | None:
    """Return r and the highest d of the terms nᵈ rⁿ of an expression; None if it is no such sum."""
    marks: dict[Expr, Expr] = {}
    bases: dict[str, fmpq] = {}
    stack = [e]
    while stack:
        node = stack.pop()
        if n not in symbols(node):
            continue
        if node.op == "^" and node.args[0].op == "number":
            exponent = node.args[1]
            slope = integer(tidied(normal_form(differentiate(exponent, n), Given())))
            start = integer(tidied(normal_form(substitute(exponent, {n: ZERO}), Given())))
            if slope is None or start is None or symbols(exponent) != {n}:
                return None
            name = f"[^{len(bases)}]"
            bases[name] = node.args[0].args[0] ** slope
            marks[node] = symbol(name) * number(node.args[0].args[0] ** start)
        else:
            stack += [arg for arg in node.args if isinstance(arg, Expr)]
    terms = polynomial(replaced(e, marks))
    if terms is None or not symbols(e) <= {n}:
        return None
    found: dict[fmpq, int] = {}
    for monomial in terms:
        r, d = fmpq(1), 0
        for name, k in monomial:
            if name == n:
                d = int(k)
            else:
                r *= bases[name] ** int(k)
        if r == 0 or any(k < 0 for _, k in monomial):
            return None
        found[r] = max(found.get(r, 0), d)
    return found


def _is_lower_bound(link: Compared, n: str) -> bool:
    """Return whether a condition is one on parameters alone, or of the form n >= m."""
    left, relation, right = link
    if any(list(functions(e)) for e in (left, right)):
        return False
    if n not in symbols(left) | symbols(right):
        return True
    if left == symbol(n):
        return right.op == "number" and relation in (">", ">=")
    return right == symbol(n) and left.op == "number" and relation in ("<", "<=")


def sequence_nodes(claim: Comparison) -> Iterator[Expr]:
    """Yield the values of sequences in a claim: all but factorials."""
    for e in (claim.left, claim.right):
        yield from (node for node in functions(e) if node.args[0].args[0] != FACTORIAL)


def decide_every_value(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a claim about a(n) for every n, or return None where it is no linear recurrence.

    Args:
        claim: the comparison.
        statement: its conditions: the recurrence, its first values, and n integer, n >= m.
        decided: decides explicit claims.
    """
    nodes = set(sequence_nodes(claim))
    indices = {name for node in nodes for e in node.args[1:] for name in symbols(e)}
    if len(indices) != 1 or claim.derivatives or statement.path is not None:
        return None
    (n,) = indices
    if n not in statement.integers or n not in statement.given.box:
        return None
    given = statement.given
    if not all(_is_lower_bound(link, n) for link in given.comparisons):
        return None
    least = given.box[n].first_integer()
    sequence = solved(statement, n) or first_order(statement, n)
    if sequence is None or least is None or {m.args[0] for m in nodes} != {sequence.name}:
        return None
    places = {node: _place(node, n) for node in nodes}
    shifts = [k for node, k in places.items() if k is not None and n in symbols(node.args[1])]
    fixed = [k for node, k in places.items() if k is not None and n not in symbols(node.args[1])]
    if len(shifts) + len(fixed) != len(nodes):
        return None
    first = sequence.first
    if least + sequence.lowest > first:
        why = f"the recurrence for {n} >= {least} does not reach {sequence.name.args[0]}({first})"
        return Answer(Verdict.UNDECIDED, why)
    if any(least + k < first for k in shifts) or any(k < first for k in fixed):
        why = f"values before {sequence.name.args[0]}({first}) are not given: raise {n} >= {least}"
        return Answer(Verdict.UNDECIDED, why)
    rest = replace(statement, equations=())
    reach = max([0, *(k + least - first for k in shifts), *(k - first for k in fixed)])
    if reach > 200:
        return None
    terms = list(islice(sequence.terms(), reach + LOOKED_AT + 1))
    for m in range(least, min(least + LOOKED_AT, first + len(terms) - reach)):
        at = {
            node: number(terms[(k or 0) + (m if n in symbols(node.args[1]) else 0) - first])
            for node, k in places.items()
        }
        explicit = claim.mapped(partial(replaced, known=at))
        answer, _ = decided_at([{n: number(m)}], explicit, rest, decided)
        if answer is not None:
            return _with_values(replace(answer, lemma=LINEAR), sequence, places)
    form = sequence.closed()
    if form is None:
        return Answer(Verdict.UNDECIDED, UNSUPPORTED_ROOTS)
    known = {node: tidied(substitute(form, {n: node.args[1]})) for node in nodes}
    answer = decided(claim.mapped(partial(replaced, known=known)), rest)
    shown = Expr("unknown", (sequence.name, symbol(n)))
    answer = replace(answer, why=f"{shown} = {form}: {answer.why}", lemma=LINEAR)
    return _with_values(answer, sequence, places)


def _with_values(
    answer: Answer, sequence: Solved | FirstOrder, places: dict[Expr, int | None]
) -> Answer:
    """Return an answer, a refutation with the values of the sequence that violate the claim."""
    at = (answer.witness or {}).get(sequence.n, "")
    if answer.verdict is not Verdict.REFUTED or not at.lstrip("-").isdigit():
        return answer
    m, first, order = int(at), sequence.first, len(sequence.values)
    if m > first + MOST_STEPS:
        return answer
    start = m + sequence.lowest
    used = {*range(first, first + order), *range(start, start + order + 1)}
    for node, k in places.items():
        used.add((k or 0) + (m if sequence.n in symbols(node.args[1]) else 0))
    values = sequence.between(min(used), max(used))
    kept = {str(node): str(v) for node, v in values.items() if integer(node.args[1]) in used}
    return replace(answer, witness=kept | dict(answer.witness or {}))
