"""Prove signs at every single point, from the signs and ranges of subexpressions.

A sum is written as a polynomial in its atoms (symbols, sines, roots, exponentials, …), each with
its range. A Möbius map takes every range to [0, ∞]. A polynomial without negative coefficients is
not negative there, and it is positive if it keeps a term at each closed corner. Where this is not
enough, the polynomial is factored, or written as multiples of conditions plus a rest. For example,
x² − xy + y for 0 < y < 1 < x becomes, with x = 1 + u and y = v/(1 + v), a polynomial in u and v
without negative coefficients.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property, lru_cache, reduce

from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound
from tresym.reals.functions.row import Function
from tresym.reals.functions.table import TABLE, names
from tresym.reals.language.expression import ONE, PI, Expr, apply, as_expr, number, symbols, trees
from tresym.reals.normal.box import REALS, sign_on_box
from tresym.reals.normal.ring import (
    MAX_DEGREE,
    Fraction,
    Poly,
    UndefinedError,
    project,
    small_factor,
)
from tresym.reals.numbers.arithmetic import ball_precision, side
from tresym.reals.numbers.exact import Interval
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.atoms import SIZE, Atoms
from tresym.reals.signs.spans import (
    absolute_sign,
    beside,
    constant_sign,
    constant_span,
    span_sign,
    times,
)

MAX_ATOMS = 8
SMALL = 10
"""The number of atoms of the ring that is tried first."""
MAX_TERMS = 200
MAX_FACTS = 16
MAX_SPLIT = 24
"""The maximal number of terms of a sum from which conditions are subtracted."""
MAX_TRIALS = 100
"""The maximal number of multiples of conditions tried for one expression."""
MAX_LOOKS = 160
"""The maximal number of polynomials examined for one expression, including its parts."""
DEPTH = 2
"""The maximal number of conditions subtracted from a sum."""
POINTS, BITS = 6, 64
"""The number of points at which an expression is looked at, and the precision there."""
SETS, REMEMBERED = 256, 4096
"""How many sets of conditions, and how many signs, are kept."""

WEAK = ("+", ">=0", "0")
FLIP = {"+": "-", "-": "+", ">=0": "<=0", "<=0": ">=0", "0": "0", None: None}
_RISING = names(lambda row: row.rising) | {"sin", "root"}
"""Strictly increasing functions; the sine is so on [−π/2, π/2]."""


Taken = tuple[tuple[Poly, Poly, int], ...]
"""Conditions subtracted from a polynomial one by one: c, m, and the index of the condition."""


def sign_by_form(e: Expr) -> str | None:
    """Return the sign that the outermost operations of ``e`` show, wherever it is defined."""
    if e.op == "number":
        return "+" if e.args[0] > 0 else "0" if e.args[0] == 0 else "-"
    if e.op == "*":
        factors = [sign_by_form(factor) for factor in e.args]
        return None if None in factors else reduce(times, factors, "+")  # type: ignore[arg-type]
    if e.op == "^" and e.args[1].op == "number":
        r = e.args[1].args[0]
        even = r.q % 2 == 0 or (r.q == 1 and r.p % 2 == 0)
        return ("+" if r < 0 else ">=0") if even else None
    if e.op == "+":
        terms = {sign_by_form(term) for term in e.args}
        return "+" if terms in ({"+"}, {"+", ">=0"}) else ">=0" if terms == {">=0"} else None
    return {"pi": "+", "exp": "+", "abs": ">=0"}.get(e.op)


@lru_cache(maxsize=SETS)
def _looked_at(
    given: Given, names: frozenset[str]
) -> list[tuple[dict[str, fmpq], dict[Expr, arb]]]:
    """Return few points of the conditions, with the known values of expressions there.

    Args:
        names: further symbols, of which the conditions say nothing.
    """
    pairs = zip(given.points((), POINTS), Given().points(names, POINTS), strict=False)
    return [({**point, **further}, {}) for point, further in pairs]


@lru_cache(maxsize=REMEMBERED)
def signs_seen(e: Expr, given: Given) -> frozenset[int]:
    """Return the signs +1 and −1 that ``e`` has at few points inside the conditions.

    An expression with both has no sign that could be proved, which is much faster to see than
    every attempt at a proof.
    """
    seen: set[int] = set()
    with ball_precision(BITS):
        for point, known in _looked_at(given, symbols(e) - given.names):
            found = side(evaluate(e, point, known))
            if found is not None:
                seen.add(found)
            if len(seen) > 1:
                break
    return frozenset(seen)


class Signs:
    """What the parts of one expression show of its sign: a `Parts` that was asked for it alone.

    Attributes:
        sign: its sign, as :meth:`Parts.sign` returns it.
    """

    def __init__(self, e: Expr, given: Given) -> None:
        """Prove the sign, in a small ring if that has room: operations take less time there."""
        self._e, self._parts = e, Parts(given, SMALL)
        self.sign = self._parts.sign(e)
        if self._parts.atoms.ring.full:
            self._parts = Parts(given)
            self.sign = self._parts.sign(e)

    @cached_property
    def nonzero(self) -> bool:
        """Whether the expression is shown to vanish nowhere."""
        found = self._parts.nonzero(self._e)
        full = self._parts.atoms.ring.full and self._parts.atoms.ring.size < SIZE
        return Parts(self._parts.given).nonzero(self._e) if full else found


@lru_cache(maxsize=SETS)
def signs_of_parts(e: Expr, given: Given) -> Signs:
    """Return what the parts of ``e`` show of its sign; several methods ask for it in turn."""
    return Signs(e, given)


class Parts:
    """Prove signs under one set of conditions, and cache them."""

    def __init__(self, given: Given, size: int = SIZE) -> None:
        """Start with the conditions as the only known facts, and at most ``size`` atoms."""
        self.given = given
        self.atoms = Atoms(size)
        self._signs: dict[Expr, str | None] = {}
        self._seen: dict[Expr, str | None] = {}
        self._asked: set[Expr] = set()
        self._boxes: dict[str, list[tuple[list[Interval], str | None]]] = {}
        self._cut = False
        self._known: list[tuple[Fraction, bool]] | None = None
        self._facts: list[tuple[Poly, bool, Poly]] | None = None
        self._trials, self._looks, self._depth = 0, 0, DEPTH

    def sign(self, e: Expr) -> str | None:
        """Return the proven sign of ``e`` wherever the conditions hold and ``e`` is defined.

        Returns:
            ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None if nothing is proved.
        """
        if e in self._signs:
            return self._signs[e]
        if e in self._asked:
            self._cut = True  # answers found meanwhile may be incomplete and are not cached
            return None
        self._asked.add(e)
        before, self._cut = self._cut, False
        its_sign = self._sign(e)
        self._asked.discard(e)
        if not self._cut or not self._asked:
            self._signs[e] = its_sign
        self._cut = (self._cut or before) and bool(self._asked)
        return its_sign

    def nonzero(self, e: Expr) -> bool:
        """Return whether ``e`` is shown to vanish nowhere."""
        if self.sign(e) in ("+", "-"):
            return True
        if e.op == "*":
            return all(self.nonzero(arg) for arg in e.args)
        if e.op == "^" and e.args[1].op == "number":
            return e.args[1].args[0] < 0 or self.nonzero(e.args[0])
        if e.op in TABLE and TABLE[e.op].never_zero:
            return True
        return self._by_conditions(e)

    def _by_conditions(self, e: Expr) -> bool:
        """Return whether every factor of ``e`` divides an expression that a condition keeps from
        zero.
        """
        strict = [c.expression for c in self.given.conditions if c.relation in (">", "!=")]
        try:
            value = self.atoms.of(e).num
            if value.is_zero():
                return False
            parts = small_factor(self.atoms.ring, value)[1]
            allowed: set[str] = set()
            for other in strict:
                p = self.atoms.of(other).num
                allowed |= {str(part) for part, _ in small_factor(self.atoms.ring, p)[1]}
        except (TooLargeError, UndefinedError):
            return False
        return all(str(part) in allowed for part, _ in parts)

    # -- by the outermost operation -------------------------------------------------------------

    def _sign(self, e: Expr) -> str | None:
        if not symbols(e):
            return constant_sign(e)
        at_once = self._at_once(e)
        if at_once in ("+", "-", "0"):
            return at_once
        stated = self._stated(e)
        if stated in ("+", "-"):
            return stated
        by_operation = self._by_operation(e)
        return by_operation if by_operation in ("+", "-", "0") else stated or by_operation

    def _at_once(self, e: Expr) -> str | None:
        """Return the sign that is seen without a search, as of ``a + b*sin(x)**2`` for a, b > 0.

        The sign of sin(x), which takes long to find, is of no interest there.
        """
        if e not in self._seen:
            stated, ruled = self._stated_signs.get(e), self._by_rules(e)
            strict = (its_sign for its_sign in (stated, ruled) if its_sign in ("+", "-", "0"))
            self._seen[e] = next(strict, stated or ruled)
        return self._seen[e]

    def _by_rules(self, e: Expr) -> str | None:
        """Return the sign of an operation from the signs that its arguments have at once."""
        if e.op in ("number", "pi") or not symbols(e):
            return constant_sign(e)
        if e.op == "symbol":
            return span_sign(self.span(e))
        if e.op in ("exp", "abs"):
            return "+" if e.op == "exp" else ">=0"
        if e.op == "*":
            factors = [self._at_once(factor) for factor in e.args]
            return None if None in factors else reduce(times, factors, "+")  # type: ignore[arg-type]
        if e.op == "+":
            terms = {self._at_once(term) for term in e.args}
            for up, weak in (("+", ">=0"), ("-", "<=0")):
                if terms <= {up, weak, "0"}:
                    return up if up in terms else weak if weak in terms else "0"
        if e.op != "^" or e.args[1].op != "number":
            return None
        inner, r = self._at_once(e.args[0]), e.args[1].args[0]
        if r > 0 and r.q == 1 and r.p % 2:
            return inner
        if r < 0 and r.q == 1 and r.p % 2:
            return {"+": "+", ">=0": "+", "-": "-", "<=0": "-"}.get(inner or "")
        return "+" if r <= 0 or inner in ("+", "-") else ">=0"

    @cached_property
    def _stated_signs(self) -> dict[Expr, str]:
        """The signs of expressions that conditions state directly."""
        found: dict[Expr, str] = {}
        for condition in self.given.conditions:
            if condition.relation != "!=":
                up = "+" if condition.relation == ">" else ">=0"
                for e, its_sign in ((condition.expression, up), (-condition.expression, FLIP[up])):
                    if found.get(e) not in ("+", "-"):
                        found[e] = str(its_sign)
        return found

    def _stated(self, e: Expr) -> str | None:
        """Return the sign that conditions state directly, or by a difference of squares."""
        stated = self._stated_signs.get(e)
        return self._difference_of_squares(e) if stated is None and e.op == "+" else stated

    def _difference_of_squares(self, e: Expr) -> str | None:
        """Return ``"+"`` for ``1 - u**2`` if conditions say that ``1 - u`` and ``1 + u`` are
        positive.
        """
        if len(e.args) != 2 or ONE not in e.args:
            return None
        square = -next(arg for arg in e.args if arg != ONE)
        if square.op != "^" or square.args[1] != number(2):
            return None
        u = square.args[0]
        strict = {c.expression for c in self.given.conditions if c.relation == ">"}
        return "+" if {ONE - u, ONE + u} <= strict else None

    def _by_operation(self, e: Expr) -> str | None:
        match e.op:
            case "*":
                return self._product_sign(e.args) or self._algebraic(e)
            case "^":
                return self._power_sign(*e.args)
            case "+":
                return self._sum_sign(e)
            case "sin" | "cos":
                return self._in_half_turn(e)
            case "tan" | "cot":
                return self._product_sign([apply(f, *e.args) for f in ("sin", "cos")])
            case "abs":
                return "+" if self.nonzero(e.args[0]) else ">=0"
            case "atan2":
                y, x = map(self.sign, e.args)
                return y if y == "+" or x == "+" else None
            case "symbol":
                return span_sign(self.span(e))
        return self._by_row(TABLE[e.op], e.args) if e.op in TABLE else None

    def _by_row(self, row: Function, args: tuple[Expr, ...]) -> str | None:
        """Return the sign of a function from its range, or from the sign that its row states."""
        least = span_sign(row.range)
        if least in ("+", "-"):
            return least
        for where, found in ((row.positive_where, "+"), (row.negative_where, "-")):
            if where is not None and self.sign(as_expr(where(*args, trees))) == "+":
                return found
        if row.sign_of is not None:
            return self.sign(row.sign_of(*args, trees)) or least
        return self.sign(args[0]) if row.vanishes_with_argument and row.odd else least

    def _product_sign(self, factors: list[Expr] | tuple[Expr, ...]) -> str | None:
        total = "+"
        for factor in factors:
            its_sign = self.sign(factor)
            if its_sign is None:
                return None
            total = times(total, its_sign)
        return total

    def _power_sign(self, base: Expr, exponent: Expr) -> str | None:
        inner = self.sign(base)
        if exponent.op != "number":
            return "+"
        r = exponent.args[0]
        if r == 0:
            return "+"  # of 0 too
        if r < 0:
            return (
                inner
                if r.q == 1 and r.p % 2 and inner in ("-", "<=0")
                else ("+" if r.q != 1 or r.p % 2 == 0 or inner in ("+", ">=0") else None)
            )
        if r.q != 1:
            return "+" if self.nonzero(base) else ">=0"
        if r.p % 2 == 0:
            return "0" if inner == "0" else "+" if self.nonzero(base) else ">=0"
        return inner

    def _sum_sign(self, e: Expr) -> str | None:
        if sign_by_form(e) == "+":
            return "+"  # such as u**2 + 1, where the sign of u is of no interest
        signs = {self.sign(arg) for arg in e.args}
        for up in ("+", "-"):
            weak = ">=0" if up == "+" else "<=0"
            if signs <= {up, weak, "0"} and signs:
                return up if up in signs else weak if weak in signs else "0"
        return self._angle_sign(e) or self._algebraic(e)

    def _angle_sign(self, e: Expr) -> str | None:
        """Return the sign of ±atan2(y, x) plus a constant, by its range from −π, excluded, to π."""
        angles = [part for part in e.args if symbols(part)]
        if len(angles) != 1 or "atan2" not in (angles[0].op, (-angles[0]).op):
            return None
        rest = sum((part for part in e.args if part != angles[0]), number(0))
        if angles[0].op != "atan2":
            opposite = self._angle_sign(-angles[0] - rest)
            return {"+": "-", "-": "+", ">=0": "<=0", "<=0": ">=0"}.get(opposite or "")
        above = "0" if rest == PI else constant_sign(rest - PI)
        if above in ("+", "0"):
            return "+"
        below = "0" if rest == -PI else constant_sign(rest + PI)
        return {"-": "-", "0": "<=0"}.get(below or "")

    def _in_half_turn(self, e: Expr) -> str | None:
        """Return the sign of a sine or cosine whose angle lies between two neighbouring zeros."""
        (angle,) = e.args
        if not symbols(angle) & self.given.names:
            return None
        middle = PI / 2 if e.op == "sin" else number(0)
        for turns, up in ((0, "+"), (1, "-"), (-1, "-")):
            from_middle = angle - middle - turns * PI
            signs = [self.sign(PI / 2 + from_middle), self.sign(PI / 2 - from_middle)]
            if all(sign in WEAK for sign in signs):
                strict = signs == ["+", "+"]
                return up if strict else ">=0" if up == "+" else "<=0"
        return None

    # -- ranges of atoms ------------------------------------------------------------------------

    def span(self, e: Expr) -> Interval:
        """Return an interval that contains all values of an atom."""
        if e.op == "symbol":
            return self.given.box.get(e.args[0], REALS)
        if not symbols(e):
            return constant_span(e)
        if e.op == "abs":
            return absolute_sign(self.span(e.args[0]), self.nonzero(e.args[0]))
        if e.op in ("+", "*"):
            return REALS
        known = TABLE[e.op].range if e.op in TABLE else REALS
        return known & self._span_by_sign(e)

    def _span_by_sign(self, e: Expr) -> Interval:
        """Return the range given by the sign of ``e`` and, for an exponential or root, of ``e −
        1``.
        """
        own_sign, above_one = self.sign(e), None
        if e.op == "exp":
            above_one = self.sign(e.args[0])
        elif e.op == "^" and e.args[1].op == "number" and e.args[1].args[0] > 0:
            above_one = self.sign(e.args[0] - ONE)
        return beside(fmpq(0), own_sign) & beside(fmpq(1), above_one)

    # -- polynomials in atoms -------------------------------------------------------------------

    def _algebraic(self, e: Expr) -> str | None:
        """Return the sign of a sum or product as a fraction of polynomials in atoms."""
        depth = self._depth
        if depth == DEPTH:
            self._trials = self._looks = 0
        self._depth = max(0, depth - 1)  # for the ranges of atoms that are needed on the way
        try:
            value = self.atoms.of(e)
            open_ = any(self._on_box(p) is None for p in (value.num, value.den))
            if open_ and len(signs_seen(e, self.given)) > 1:
                return None
            return self._fraction(value, depth)
        except (TooLargeError, UndefinedError):
            return None
        finally:
            self._depth = depth

    def _fraction(self, value: Fraction, depth: int) -> str | None:
        """Return the sign of a fraction with nonzero denominator, using conditions if depth > 0."""
        below, above = (self._polynomial(p) for p in (value.den, value.num))
        if below is None or below == "0":
            return None
        turned = below not in WEAK
        best = FLIP[above] if turned else above
        num, den = (-p if turned else p for p in (value.num, value.den))
        if best not in ("+", "-", "0") and depth:
            for up, p in (("+", num), ("-", -num)):
                for taken in self._ways(p, den, depth):
                    less = self._less(p, taken)
                    if less == "+":
                        return up
                    best = best or (less and (">=0" if up == "+" else "<=0"))
        return best

    def _less(self, p: Poly, taken: Taken) -> str | None:
        """Return ``"+"`` or ``">=0"`` for ``p``, from the sign of the rest after subtracting
        conditions.

        Each step replaces p by c·p − m·f, where f > 0 or f ≥ 0 is a known fact, c > 0 and m ≥ 0.
        """
        strict = False
        for scale, multiple, n in taken:
            fact, is_strict, _ = self.facts[n]
            room = self._polynomial(multiple, roots=False)
            if room not in WEAK or self._polynomial(scale, roots=False) != "+":
                return None
            p = p * scale - multiple * fact
            strict = strict or (is_strict and room == "+")
        terms = self._polynomial(p, roots=False)  # conjugates subtract conditions by themselves
        return None if terms not in WEAK else "+" if strict or terms == "+" else ">=0"

    def _ways(self, p: Poly, den: Poly, depth: int) -> Iterator[Taken]:
        """Yield conditions whose multiples may be subtracted from ``p/den`` to cancel a term."""
        if self._trials >= MAX_TRIALS or max(p.total_degree(), den.total_degree()) > MAX_DEGREE:
            return
        steps: list[tuple[Poly, Poly, int]] = []
        used = {*self.atoms.ring.used(p)}
        for n, (fact, _, below) in enumerate(self.facts):
            size = len(p) * len(below) + len(den) * len(fact)
            if (
                size <= MAX_TERMS
                and fact.total_degree() <= MAX_DEGREE
                and not used.isdisjoint(self.atoms.ring.used(fact))
            ):
                few = len(p) <= MAX_SPLIT
                multiples = self._multiples(p, fact) if few else ()
                multiples_by_text = {(str(c), str(m)): (c, m, n) for c, m in multiples}
                if len(p * below - den * fact) < len(p * below) + len(fact):
                    multiples_by_text[str(below), str(den)] = below, den, n
                steps += multiples_by_text.values()
        for step in steps[: max(0, MAX_TRIALS - self._trials)]:
            self._trials += 1
            yield (step,)
        for scale, multiple, n in steps if depth > 1 else ():
            for more in self._ways(
                p * scale - multiple * self.facts[n][0], self.atoms.ring.one_poly, 1
            ):
                yield ((scale, multiple, n), *more)

    def _multiples(self, p: Poly, fact: Poly) -> Iterator[tuple[Poly, Poly]]:
        """Yield c and m such that ``c·p − m·fact`` lacks a term of ``p`` that may be negative."""
        for monomial, value in list(p.terms()):
            if value > 0 and self._on_box(p.context().from_dict({monomial: 1})) in WEAK:
                continue
            for other, known in fact.terms():
                quotient = tuple(i - j for i, j in zip(monomial, other, strict=True))
                if (known > 0) == (value > 0) and min(quotient) >= 0:
                    m = p.context().from_dict({quotient: abs(value)})
                    if self._on_box(m) in WEAK:
                        yield p.context().constant(abs(known)), m

    def _polynomial(self, p: Poly, roots: bool = True) -> str | None:
        """Return the sign of a polynomial in atoms by their ranges, its factors, or conjugates."""
        if p.is_constant():
            return "0" if p.is_zero() else "+" if p.leading_coefficient() > 0 else "-"
        self._looks += 1
        if self._looks > MAX_LOOKS or len(p) > MAX_TERMS:
            return None
        best = None
        for q in self.atoms.rewritten(p, self._is_positive):
            sign = self._on_box(q)
            sign = sign if sign in ("+", "-", "0") else self._by_factors(q) or sign
            if sign in ("+", "-", "0"):
                return sign
            best = best or sign
        return best or self._at_ends(p) or (self._by_conjugate(p) if roots else None)

    def _by_conjugate(self, p: Poly) -> str | None:
        """Return the sign of ``u + v·g``, g ≥ 0 a square root, from that of ``u² − v²·g²``."""
        for i in self.atoms.ring.used(p):
            generator = self.atoms.ring.at(i)
            if generator.kind != "root" or generator.data[2] != 2 or p.degrees()[i] != 1:
                continue
            parts, inner = self.atoms.ring.split(p, i), generator.data[1]
            if len(parts) != 2 or len(p) > MAX_SPLIT or not self._is_positive(inner.den):
                continue
            size = self._fraction(
                self.atoms.ring.fraction(parts[0]) ** 2 - parts[1] ** 2 * inner, 1
            )
            if size in ("+", "-"):
                terms = self._polynomial(parts[0 if size == "+" else 1])
                return {">=0": "+", "<=0": "-"}.get(terms or "", terms)
        return None

    def _at_ends(self, p: Poly) -> str | None:
        """Return the sign of a polynomial that is linear in a squared sine or cosine."""
        for i in self.atoms.ring.used(p):
            if self.atoms.ring.at(i).kind in ("sin", "cos") and p.degrees()[i] == 2:
                parts = self.atoms.ring.split(p, i)
                if 1 not in parts:
                    low = parts.get(0, self.atoms.ring.zero_poly)
                    ends = {self._polynomial(end) for end in (low, low + parts[2])}
                    for up in ("+", "-"):
                        weak = ">=0" if up == "+" else "<=0"
                        if ends <= {up, weak, "0"}:
                            return up if ends == {up} else weak
        return None

    def _is_positive(self, p: Poly) -> bool:
        return p.is_one() or self._on_box(p) == "+"

    def _on_box(self, p: Poly) -> str | None:
        used = self.atoms.ring.used(p)
        if p.is_zero():
            return "0"
        if len(used) > MAX_ATOMS or len(p) > MAX_TERMS:
            return None
        spans = [self.span(self.atoms.expression(i)) for i in used]
        known = self._boxes.setdefault(str(p), [])
        for others, its_sign in known:  # the known ranges may have become narrower meanwhile
            if others == spans:
                return its_sign
        its_sign = sign_on_box(project(p, used), spans)
        known.append((spans, its_sign))
        return its_sign

    def _by_factors(self, p: Poly) -> str | None:
        unit, parts = small_factor(self.atoms.ring, p)
        if len(parts) == 1 and parts[0][1] == 1:
            return self._known_part(p)
        total = "+" if unit > 0 else "-"
        for part, multiplicity in parts:
            its_sign = self._on_box(part) or self._known_part(part)
            if multiplicity % 2 == 0:
                its_sign = "+" if its_sign in ("+", "-") else ">=0"
            if its_sign is None:
                return None
            total = times(total, its_sign)
        return total

    def _known_part(self, p: Poly) -> str | None:
        """Return the sign of a condition, of a difference of two values of an increasing function,
        or of an angle bounded by a quarter or half turn.
        """
        for fact, strict, _ in self.facts:
            if fact in (p, -p):
                room = "+" if strict else ">=0"
                return room if fact == p else FLIP[room]
        used = self.atoms.ring.used(p)
        if len(used) != 2 or len(p) != 2 or p.total_degree() != 1:
            return None
        first, second = (self.atoms.ring.at(i) for i in used)
        scales = [int(p.derivative(i).leading_coefficient()) for i in used]
        x, y = (self.atoms.expression(i) for i in used)
        if {first.kind, second.kind} == {"pi", "atan"}:
            above = scales[0] if first.kind == "pi" else scales[1]
            size = 2 * abs(above) - abs(scales[0] + scales[1] - above)
            return ("+" if above > 0 else "-") if size >= 0 else None
        if {first.kind, second.kind} == {"pi", "acos"} and scales[0] == -scales[1]:
            angle, above = (y, scales[0]) if first.kind == "pi" else (x, scales[1])
            room = "+" if self.sign(1 + angle.args[0]) == "+" else ">=0"
            return room if above > 0 else FLIP[room]
        if first.kind != second.kind or scales[0] != -scales[1] or first.kind not in _RISING:
            return None
        u, v = x.args[0], y.args[0]
        if first.kind == "sin" and not all(
            self.sign(PI / 2 + side * end) in WEAK for end in (u, v) for side in (1, -1)
        ):
            return None
        if first.kind == "root" and first.data[2] != second.data[2]:
            return None
        its_sign = self.sign(u - v)
        return its_sign if scales[0] > 0 else FLIP[its_sign]

    @property
    def known(self) -> list[tuple[Fraction, bool]]:
        """Return what the conditions keep nonnegative, and whether strictly.

        Rational bounds of a single symbol are omitted, since ranges take them into account.
        """
        if self._known is None:
            self._known = []
            everything = dict.fromkeys((*self.given.beyond_box, *self.given.conditions))
            for e, relation in ((c.expression, c.relation) for c in everything):
                if relation == "!=" or bound(e, relation)[0].op == "symbol":
                    continue
                with suppress(TooLargeError, UndefinedError):
                    if len(self._known) < MAX_FACTS:
                        self._known.append((self.atoms.of(e), relation == ">"))
        return self._known

    @property
    def facts(self) -> list[tuple[Poly, bool, Poly]]:
        """Return the same as polynomials, with their denominators, which are positive."""
        if self._facts is None:
            self._facts = []
            pieces = []
            for value, strict in self.known:
                below = self._polynomial(value.den)
                if below is not None and below != "0":
                    side = 1 if below in WEAK else -1
                    pieces.append((side * value.num, strict, side * value.den))
            self._facts = pieces
        return self._facts
