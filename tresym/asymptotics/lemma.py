"""What a lemma yields: explicit terms, and a bound of the error that elementary statements prove.

An :class:`Expansion` of an integral, a sum or a factorial f(x) along one side of a path gives, for
every order n, explicit functions A and g with |f − A| ≤ C g. Finding them is cheap; proving the
bound asks the one dispatcher for *obligations*, ordinary statements about explicit functions.

Example: Watson's lemma on f(x) = ∫₀^∞ e^(−xt)/(1 + t) dt at order 2 has A = 1/x − 1/x², g = 1/x³,
and its obligation is ``abs(1/(1 + t) - 1 + t) <= t**2 given t > 0``; C = 2 for every x > 0.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide, Obligation
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    factors_in,
    number,
    rebuild,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.resource_limits import TimeUp, time_limit
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

_ORDER = (Verdict.PROVED, Verdict.ENCLOSED)
NONE = Given()
SECONDS = 3.0
"""The processor time that an obligation may take, where there is no other limit."""
SLACK = fmpq(101, 100)
"""A constant that is tried: so much above the largest value found."""


class Bound(NamedTuple):
    """How far a bound of the error holds.

    Attributes:
        constant: C, or None: some constant, for x near enough to the end of the path.
        upto: for 0 < s ≤ upto, where s is 1/|x| or the distance from the end; None for all s > 0.
        uniform: whether it holds for all values of the parameters that satisfy the conditions.
    """

    constant: fmpq | None = None
    upto: fmpq | None = None
    uniform: bool = False


class End(NamedTuple):
    """One side of a path, with the conditions on the parameters."""

    name: str
    point: Expr | None
    side: int
    given: Given
    names: frozenset[str] = frozenset()
    """All names that are used elsewhere."""

    @property
    def taken(self) -> frozenset[str]:
        """Return the names that a new variable must not have."""
        return self.names | self.given.names | {self.name}

    @property
    def path(self) -> Path:
        """The same as a path."""
        return Path(self.name, self.point, (self.side,))

    def limit(self, e: Expr) -> Expr | None:
        """Return the limit of an explicit function; None where it is not found."""
        return limit_of(e, self.name, self.point, self.side, self.given)

    def tends_to_infinity(self, e: Expr) -> bool:
        """Return whether an explicit function tends to +∞."""
        return self.limit(e) == INFINITY


class Obligations:
    """Ask the dispatcher for the statements of a lemma and store those that hold."""

    def __init__(self, statement: Statement, decided: Decide) -> None:
        """Start without any.

        Args:
            statement: the claim for which the lemma is used.
            decided: decides explicit claims.
        """
        self.statement, self.decided = statement, decided
        self.found: list[Obligation] = []
        self.verdict = Verdict.PROVED
        self.missing = ""

    def ask(
        self,
        left: Expr,
        relation: str,
        right: Expr,
        given: Given = NONE,
        path: Path | None = None,
        integers: Sequence[str] = (),
    ) -> Answer:
        """Decide a statement; it is stored with its verdict if it holds."""
        claim = Comparison(left, relation, right)
        whole = replace(
            self.statement, given=given, path=path, equations=(), integers=tuple(integers)
        )
        try:
            with time_limit(SECONDS):
                answer = self.decided(claim, whole)
        except TimeUp:
            answer = Answer(Verdict.UNDECIDED, f"stopped after {SECONDS} s of processor time")
        end = f" as {path}" if path is not None else ""
        self.keep(f"{left} {relation} {right}{end}", given, answer.verdict)
        return answer

    def holds(
        self,
        left: Expr,
        relation: str,
        right: Expr,
        given: Given = NONE,
        path: Path | None = None,
    ) -> bool:
        """Return whether a statement holds."""
        return bool(self.ask(left, relation, right, given, path))

    def continuous(self, e: Expr, given: Given) -> bool:
        """Return whether ``e`` is shown to be continuous wherever the conditions hold."""
        if e.op in ("number", "symbol", "pi"):
            return True
        shown = not e.hidden and continuous_on(e, given, proof) is None
        self.keep(f"{e} is continuous", given, Verdict.PROVED if shown else Verdict.UNDECIDED)
        return shown

    def keep(self, text: str, given: Given, verdict: Verdict) -> None:
        """Store a statement that holds, or name it as the one that is missing."""
        if not verdict.holds:
            self.missing = f"{text}{f' given {given}' if given.comparisons else ''}"
            return
        part = Obligation(text, str(given), verdict.value)
        if part not in self.found:
            self.found.append(part)
        if verdict is Verdict.ENCLOSED:
            self.verdict = verdict


class Expansion(ABC):
    """An expansion of one integral, sum or factorial along one side of a path.

    Attributes:
        lemma: the name of the theorem with its source.
        unknown: symbols in the terms that stand for constants.
        constants: what is known of these constants.
        is_little_o: whether f = A + o(g) is meant in place of f = A + O(g).
    """

    lemma: str = ""
    unknown: frozenset[str] = frozenset()
    constants: Given = NONE
    is_little_o: bool = False

    @abstractmethod
    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return A and g with f = A + O(g), not yet proved; None where there are none.

        The function g is nonnegative; it is 0 where A is f itself.
        """

    @abstractmethod
    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove |f − A| ≤ C g for the functions of this order, or return None."""


def rounded_up(x: arb, digits: int = 3) -> fmpq:
    """Return a short decimal that is at least ``x`` ≥ 0."""
    value = exact_upper(x)
    if not value > 0:
        return fmpq(0)
    if value.q < 10**digits and value.p < 10**digits:
        return value
    scale = fmpq(1)
    while value >= 10**digits:
        value, scale = value / 10, scale * 10
    while value < 10 ** (digits - 1):
        value, scale = value * 10, scale / 10
    return fmpq(value.ceil()) * scale


def exact_upper(x: arb) -> fmpq:
    """Return the upper end of a ball as a rational."""
    mantissa, exponent = (int(part) for part in x.upper().man_exp())
    return fmpq(mantissa * 2 ** max(exponent, 0), 2 ** max(-exponent, 0))


def upper_bound(e: Expr) -> fmpq | None:
    """Return a short rational at least as large as a constant; None if it has no value."""
    if symbols(e):
        return None
    with ball_precision():
        value = evaluate(e, {})
        return rounded_up(value) if value.is_finite() else None


def supremum(e: Expr, name: str, end: Expr | None) -> arb | None:
    """Return about the largest |e| on 0 < s < end (or s > 0), by numbers: no proof.

    Returns:
        The largest value found, or None where the values grow towards an end, or are too few.
    """
    points: list[arb] = []
    if symbols(e) - {name} or (end is not None and symbols(end)):
        return None
    with ball_precision(256):
        if end is None:
            points = [arb(2) ** (arb(k) / 4) for k in range(-48, 49)]
        else:
            width = evaluate(end, {})
            if not width.is_finite():
                return None
            points = [width * arb(2) ** (-arb(k) / 2) for k in range(1, 36)]
            points += [width * (1 - arb(2) ** (-arb(k) / 2)) for k in range(1, 36)]
            points += [width * arb(k) / 23 for k in range(1, 23)]
            points.sort(key=lambda x: x.mid())
        values = [abs(evaluate(e, {name: x.mid()})) for x in points]
        known = [v.mid() for v in values if v.is_finite() and v.rad() < arb("0.01") * (1 + v)]
        if 2 * len(known) < len(values):
            return None
        largest = arb(0)
        for value in known:
            largest = largest.max(value)
        grows = known[-1] > arb("1.1") * known[-6] or known[0] > arb("1.1") * known[5]
        if grows and (known[-1] == largest or known[0] == largest):
            return None
        return largest


def folded(e: Expr) -> Expr:
    """Return the terms of a lemma with values such as log(1) and products with 0 worked out.

    Only for what is defined near the end of the path, as the terms of a lemma are.
    """
    if e.op in LEAVES or e.hidden:
        return e
    args = tuple(map(folded, e.args))
    if e.op == "*" and ZERO in args:
        return ZERO
    if e.op == "abs" and args[0].op == "number":
        return number(abs(args[0].args[0]))
    if e.op == "^" and args[0] == ONE:
        return ONE
    if e.op in _AT_ZERO and args[0] == ZERO:
        return _AT_ZERO[e.op]
    if e.op == "log" and args[0] == ONE:
        return ZERO
    return rebuild(e, args)


_AT_ZERO = {"exp": ONE, "cos": ONE, "cosh": ONE} | dict.fromkeys(
    ("sin", "sinh", "tan", "tanh", "atan", "asinh", "asin", "atanh"), ZERO
)


MOST_TERMS = 24
"""The most terms to which a product of sums is opened."""


def asserted_terms(e: Expr, name: str) -> tuple[Expr, ...]:
    """Return the terms that ``f ~ e`` asserts: those of a sum, also where it has a factor.

    Sums without the variable of the path, such as a + b in (a + b)*x, are coefficients.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> [str(term) for term in asserted_terms(parse("exp(-x)*(1 + 2/x)"), "x")]
        ['exp(-x)', 'exp(-x)*2/x']
    """
    if e.op == "+":
        return tuple(term for part in e.args for term in asserted_terms(part, name))
    found: list[Expr] = [ONE]
    for factor in factors_in(e):
        is_sum = factor.op == "+" and name in symbols(factor)
        parts = asserted_terms(factor, name) if is_sum else (factor,)
        found = [term * part for term in found for part in parts]
        if len(found) > MOST_TERMS:
            return (e,)
    return tuple(found)


def smallest(e: Expr, end: End) -> Expr | None:
    """Return the term of a sum that is o of every other, or the only term."""
    terms = asserted_terms(e, end.name)
    best = terms[0]
    for term in terms[1:]:
        ratio = end.limit(term / best)
        if ratio == ZERO:
            best = term
        elif ratio not in (INFINITY, -INFINITY):
            return e if ratio is not None else None
    return best
