"""Signs that hold on the whole of ``given``, its closed ends included, and what may vanish.

A sum is taken as a polynomial in its atoms (symbols, sines, exponentials, …), each with its range;
a Möbius map takes every range to [0, ∞], and a polynomial without negative coefficients that keeps
a term at each closed corner is positive.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product
from typing import NamedTuple

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from tresym.reals.language.expression import ZERO, Expr, apply, replaced, symbols
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.places.conditions import Given
from tresym.reals.places.points import Range
from tresym.reals.places.values import evaluate

MAX_ATOMS = 8
MAX_TERMS = 200
_BITS = 128

_POSITIVE = frozenset(("exp", "cosh", "sech"))
_ODD_INCREASING = frozenset(("sinh", "tanh", "asinh", "atanh", "atan", "asin", "cbrt", "sign"))
PROVING = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-")}
"""The signs of a difference that prove its relation to zero."""
_FLIP = {"+": "-", "-": "+", ">=0": "<=0", "<=0": ">=0", "0": "0"}


class Span(NamedTuple):
    """An interval of values; None is an infinite end, which counts as open."""

    low: fmpq | None
    high: fmpq | None
    low_open: bool = True
    high_open: bool = True


_REALS = Span(None, None)


def sign(e: Expr, given: Given) -> str | None:
    """The proven sign of ``e`` wherever ``given`` holds and ``e`` is defined.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None where nothing is proved. The
        strict signs hold on closed ends too.
    """
    bounds = _Bounds(given)
    found = bounds.sign(e)
    if found in ("+", "-", "0"):
        return found
    found = _open_sign(e, given) or found
    if found in (">=0", "<=0") and bounds.nonzero(e):
        return "+" if found == ">=0" else "-"
    return found


def is_nonzero(e: Expr, given: Given) -> bool:
    """Whether ``e`` is shown to vanish nowhere under ``given``."""
    return sign(e, given) in ("+", "-") or _Bounds(given).nonzero(e)


def jumps(expressions: Iterable[Expr], given: Given) -> list[Expr]:
    """The nodes ``sign u`` and ``atan2(y, x)`` in them that are not shown to be continuous.

    They jump where u is 0, and where y is 0 and x is negative; no other function does so where it
    is defined, and no product of sign u and what vanishes with u.
    """
    found: list[Expr] = []
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in ("number", "symbol", "pi"):
            continue
        seen.add(node)
        for arg in node.args:
            calm = node.op == "*" and arg.op == "sign" and _vanishes_beside(arg, node.args)
            stack.append(arg.args[0] if calm else arg)
        if (
            node.op in ("sign", "atan2")
            and not is_nonzero(node.args[0], given)
            and sign(node.args[0], given) != "0"
            and not (node.op == "atan2" and sign(node.args[1], given) == "+")
        ):
            found.append(node)
    return found


def _vanishes_beside(node: Expr, factors: tuple[Expr, ...]) -> bool:
    """Whether one of the factors is continuous, and 0 where the argument of the node is."""
    known = {node.args[0]: ZERO, -node.args[0]: ZERO}
    return any(
        _constant_sign(rest) == "0" and not jumps((factor,), Given())
        for factor in factors
        if not symbols(rest := replaced(factor, known))
    )


def nonzero_denominators(e: Expr, given: Given) -> Expr | None:
    """The first denominator of ``e`` not proved non-zero under ``given``, or None.

    Denominators are the bases of negative powers, the cosine under ``tan`` and ``sec``, the sine
    under ``cot`` and ``csc``, the arguments of logarithms and hyperbolic cotangents, ``1 − u**2``
    under ``atanh u``, and ``y**2 + x**2`` under ``atan2(y, x)``.
    """
    bounds = _Bounds(given)
    for denominator in denominators(e):
        if not bounds.nonzero(denominator):
            return denominator
    return None


def denominators(e: Expr) -> Iterator[Expr]:
    """What must not vanish for ``e`` to be defined."""
    return _denominators(e, set())


def _denominators(e: Expr, seen: set[Expr]) -> Iterator[Expr]:
    if e in seen or e.op in ("number", "symbol", "pi"):
        return
    seen.add(e)
    for arg in e.args:
        yield from _denominators(arg, seen)
    if e.op == "^":
        base, exponent = e.args
        if exponent.op != "number" or exponent.args[0] < 0:
            yield base
    elif e.op in ("log", "coth", "csch"):
        yield e.args[0]
    elif e.op == "atan2":
        yield e.args[0] ** 2 + e.args[1] ** 2
    elif e.op in ("tan", "sec"):
        yield apply("cos", e.args[0])
    elif e.op in ("cot", "csc"):
        yield apply("sin", e.args[0])
    elif e.op == "atanh":
        yield 1 - e.args[0] ** 2


def _open_sign(e: Expr, given: Given) -> str | None:
    """The sign on the open domain, which bounds the sign on its closure where ``e`` has no jump."""
    if jumps((e,), given):
        return None
    try:
        field = Field(given)
        (value,) = field.normal(e)
        if value.num.is_zero():
            return "0"
        num, den = (without_powers(field, p) for p in (value.num, value.den))
        found = _factored_sign(field, num) * _factored_sign(field, den)
    except (TooLargeError, UndefinedError):
        return None
    return {1: ">=0", -1: "<=0", 0: None}[found]


def without_powers(field: Field, p: Poly) -> Poly:
    """``p`` with each symbol that is positive, and whose root occurs, as a power of that root."""
    for position, order, _ in field.relations:
        generator = field.at(position)
        base = generator.data[0] if generator.kind == "root" else None
        if base is None or len(base) != 1 or base.total_degree() != 1 or field.sign(base) <= 0:
            continue
        (inner,) = field.used(base)
        if p.degrees()[inner] > 0 and p.degrees()[position] > 0:
            power = field.variables[position] ** order
            parts = field.split(p, inner)
            p = sum((part * power**k for k, part in parts.items()), field.zero_poly)
    return p


def _factored_sign(field: Field, p: Poly) -> int:
    """The sign of ``p`` where it is not zero, even factors left out; 0 if unknown."""
    found = field.sign(p)
    if found:
        return found
    content, parts = field.factor(p)
    total = 1 if content > 0 else -1
    for part, multiplicity in parts:
        if multiplicity % 2:
            total *= field.sign(part)
    return total


class _Bounds:
    """Signs under one set of conditions, remembered."""

    def __init__(self, given: Given) -> None:
        self.given = given
        self._signs: dict[Expr, str | None] = {}

    def nonzero(self, e: Expr) -> bool:
        """Whether ``e`` is shown to vanish nowhere."""
        if self.sign(e) in ("+", "-"):
            return True
        if e.op == "*":
            return all(self.nonzero(arg) for arg in e.args)
        if e.op == "^" and e.args[1].op == "number":
            return self.nonzero(e.args[0])
        return self._by_conditions(e)

    def _by_conditions(self, e: Expr) -> bool:
        """Whether every factor of ``e`` is one that a condition keeps from zero.

        Algebra alone: every function is a value of which nothing is known, so that what is shown
        holds at each single point, and not only at almost all of them.
        """
        strict = [c.expression for c in self.given.conditions if c.relation in (">", "!=")]
        try:
            field = Field(Given(), frozenset())
            value, *others = field.normal(e, *strict)
            if value.num.is_zero():
                return False
            allowed: set[str] = set()
            for other in others:
                allowed |= {str(part) for part, _ in field.factor(other.num)[1]}
            _, parts = field.factor(value.num)
        except (TooLargeError, UndefinedError):
            return False
        return all(str(part) in allowed for part, _ in parts)

    def sign(self, e: Expr) -> str | None:
        """As the function of that name, on structure and ranges alone."""
        if e not in self._signs:
            self._signs[e] = None
            self._signs[e] = self._sign(e)
        return self._signs[e]

    def _sign(self, e: Expr) -> str | None:
        if not symbols(e):
            return _constant_sign(e)
        for condition in self.given.conditions:
            if condition.expression == e and condition.relation != "!=":
                return "+" if condition.relation == ">" else ">=0"
            if condition.relation != "!=" and condition.expression == -e:
                return "-" if condition.relation == ">" else "<=0"
        if e.op == "symbol":
            return _span_sign(self.span(e))
        if e.op == "*":
            return self._product_sign(e)
        if e.op == "^":
            return self._power_sign(*e.args)
        if e.op == "+":
            return self._sum_sign(e)
        if e.op in _POSITIVE:
            return "+"
        if e.op in _ODD_INCREASING:
            return self.sign(e.args[0])
        if e.op == "abs":
            return "+" if self.nonzero(e.args[0]) else ">=0"
        return _span_sign(self.span(e))

    def _product_sign(self, e: Expr) -> str | None:
        total = "+"
        for arg in e.args:
            found = self.sign(arg)
            if found is None:
                return None
            total = _times(total, found)
        return total

    def _power_sign(self, base: Expr, exponent: Expr) -> str | None:
        inner = self.sign(base)
        if exponent.op != "number":
            return "+"
        r = exponent.args[0]
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
        signs = {self.sign(arg) for arg in e.args}
        for up in ("+", "-"):
            weak = ">=0" if up == "+" else "<=0"
            if signs <= {up, weak, "0"} and signs:
                return up if up in signs else weak if weak in signs else "0"
        return self._polynomial_sign(e)

    def span(self, e: Expr) -> Span:
        """A range that contains the values of an atom."""
        if e.op == "symbol":
            where = self.given.box.get(e.args[0], Range())
            return Span(
                where.low,
                where.high,
                where.low_open or where.low is None,
                where.high_open or where.high is None,
            )
        if e.op in ("sin", "cos"):
            return Span(fmpq(-1), fmpq(1), False, False)
        if e.op == "tanh":
            return Span(fmpq(-1), fmpq(1))
        if e.op == "cosh":
            return Span(fmpq(1), None, False)
        if e.op == "atan":
            return Span(fmpq(-11, 7), fmpq(11, 7))
        if e.op == "atan2":
            return Span(fmpq(-22, 7), fmpq(22, 7))
        if e.op == "abs":
            return _absolute(self.span(e.args[0]), self.nonzero(e.args[0]))
        if e.op in ("+", "*"):
            return _REALS
        found = self.sign(e)
        if found in ("+", ">=0"):
            return Span(fmpq(0), None, found == "+")
        if found in ("-", "<=0"):
            return Span(None, fmpq(0), True, found == "-")
        return _REALS

    def _polynomial_sign(self, e: Expr) -> str | None:
        atoms: dict[Expr, int] = {}
        _collect(e, atoms)
        if not 0 < len(atoms) <= MAX_ATOMS:
            return None
        context = fmpq_mpoly_ctx.get([f"u{i}" for i in range(len(atoms))], Ordering.lex)
        polynomial = _polynomial(e, atoms, context)
        if polynomial is None or len(polynomial) > MAX_TERMS:
            return None
        spans = [self.span(atom) for atom in atoms]
        return _box_sign(polynomial, spans, context)


def _constant_sign(e: Expr) -> str | None:
    for bits in (_BITS, 8 * _BITS):
        with ball_precision(bits):
            value = evaluate(e, {})
        if value > 0:
            return "+"
        if value < 0:
            return "-"
    return "0" if value.is_zero() else None


def _span_sign(span: Span) -> str | None:
    if span.low is not None and span.low >= 0:
        return "+" if span.low > 0 or span.low_open else ">=0"
    if span.high is not None and span.high <= 0:
        return "-" if span.high < 0 or span.high_open else "<=0"
    return None


def _absolute(span: Span, nonzero: bool) -> Span:
    """The range of the absolute value of what has a range."""
    if span.low is not None and span.low >= 0:
        return span
    if span.high is not None and span.high <= 0:
        low = None if span.low is None else -span.low
        return Span(-span.high, low, span.high_open, span.low_open)
    if span.low is None or span.high is None:
        return Span(fmpq(0), None, nonzero)
    top = max(-span.low, span.high)
    is_open = all(
        o for end, o in ((-span.low, span.low_open), (span.high, span.high_open)) if end == top
    )
    return Span(fmpq(0), top, nonzero, is_open)


def _times(x: str, y: str) -> str:
    if "0" in (x, y):
        return "0"
    result = "+" if x == "+" == y else ">=0"
    if x in ("-", "<=0"):
        result, x = _FLIP[result], _FLIP[x]
    if y in ("-", "<=0"):
        result, y = _FLIP[result], _FLIP[y]
    if x == "+" == y:
        return {">=0": "+", "<=0": "-"}.get(result, result)
    return result


def _collect(e: Expr, atoms: dict[Expr, int]) -> None:
    """Number the atoms of a polynomial expression."""
    if e.op == "number":
        return
    natural = e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1
    if e.op in ("+", "*"):
        for arg in e.args:
            _collect(arg, atoms)
    elif natural and e.args[1].args[0] > 0:
        _collect(e.args[0], atoms)
    else:
        atoms.setdefault(e, len(atoms))


def _polynomial(e: Expr, atoms: dict[Expr, int], context: fmpq_mpoly_ctx) -> fmpq_mpoly | None:
    if e in atoms:
        return context.gens()[atoms[e]]
    if e.op == "number":
        return context.constant(e.args[0])
    if e.op == "^":
        base = _polynomial(e.args[0], atoms, context)
        n = int(e.args[1].args[0].p)
        if base is None or (len(base) > 1 and n * len(base) > MAX_TERMS):
            return None
        return base**n
    total = context.constant(0 if e.op == "+" else 1)
    for arg in e.args:
        part = _polynomial(arg, atoms, context)
        if part is None or len(part) * len(total) > MAX_TERMS * 10:
            return None
        total = total + part if e.op == "+" else total * part
    return total


def _box_sign(
    p: fmpq_mpoly, spans: list[Span], context: fmpq_mpoly_ctx, start: int = 0
) -> str | None:
    """The sign of ``p`` for values in ``spans``, taken as independent."""
    if p.is_zero():
        return "0"
    found = _coefficient_sign(p, spans, context)
    degrees = p.degrees()
    for i in range(start, len(spans)):
        if found is None and degrees[i] == 2:
            found = _quadratic_sign(p, i, spans, context)
    return found


def _coefficient_sign(p: fmpq_mpoly, spans: list[Span], context: fmpq_mpoly_ctx) -> str | None:
    """The sign of all coefficients once every span is mapped to [0, ∞]."""
    closed: list[tuple[int, list[int]]] = []
    for i, span in enumerate(spans):
        degrees = {int(m[i]) for m in p.monoms()}
        if not degrees:
            return "0"  # a side of no length, on which p vanishes
        if degrees == {0}:
            continue
        if span.low is None and span.high is None:
            if any(k % 2 for k in degrees):
                return None
            closed.append((i, [0]))
            continue
        p = _mapped(p, i, span, max(degrees), context)
        ends = [] if span.low_open else [0]
        if span.low is None:
            ends = [] if span.high_open else [0]
        elif span.high is not None and not span.high_open:
            ends.append(max(degrees))
        if ends:
            closed.append((i, ends))
    signs = {value > 0 for value in p.coeffs()}
    if len(signs) != 1:
        return None
    up = "+" if True in signs else "-"
    monomials = p.monoms()
    for corner in product(*(ends for _, ends in closed)):
        fixed = [(i, k) for (i, _), k in zip(closed, corner, strict=True)]
        if not any(all(int(m[i]) == k for i, k in fixed) for m in monomials):
            return ">=0" if up == "+" else "<=0"
    return up


def _quadratic_sign(
    p: fmpq_mpoly, i: int, spans: list[Span], context: fmpq_mpoly_ctx
) -> str | None:
    """``a·u² + b·u + c`` with ``4ac ≥ b²`` has the sign of a and c."""
    parts: dict[int, dict[tuple[int, ...], fmpq]] = {}
    for monomial, value in p.terms():
        others = (*monomial[:i], 0, *monomial[i + 1 :])
        parts.setdefault(int(monomial[i]), {})[others] = value
    c, b, a = (context.from_dict(parts.get(k, {})) for k in range(3))
    lead = _box_sign(a, spans, context, i + 1)
    if lead is None or lead == "0":
        return None
    rest = _box_sign(4 * a * c - b * b, spans, context, i + 1)
    if rest == "+" and lead in ("+", "-"):
        return lead
    up = lead in ("+", ">=0")
    last = _box_sign(c, spans, context, i + 1)
    weak = ("+", ">=0", "0") if up else ("-", "<=0", "0")
    if rest in ("+", ">=0", "0") and last in weak:
        return ">=0" if up else "<=0"
    return None


def _mapped(p: fmpq_mpoly, i: int, span: Span, degree: int, context: fmpq_mpoly_ctx) -> fmpq_mpoly:
    """``p`` times a positive factor with its ``i``-th atom's span mapped to [0, ∞]."""
    u, one = context.gens()[i], context.constant(1)
    if span.low is not None and span.high is not None:
        top, bottom = span.low + span.high * u, one + u
    elif span.low is not None:
        top, bottom = span.low + u, one
    else:
        top, bottom = span.high - u, one
    result = context.constant(0)
    for monomial, value in p.terms():
        k = int(monomial[i])
        rest = context.from_dict({(*monomial[:i], 0, *monomial[i + 1 :]): value})
        result = result + rest * top**k * bottom ** (degree - k)
    return result
