"""Consequences of polynomial equations, by membership in an ideal.

Expressions become quotients of polynomials in their variables and in the functions that occur in
them. Each function is a new variable with the equations that it satisfies wherever it is defined:
sin²u + cos²u = 1, r^q = u for a root, |u|² = u²; sums and multiples of angles and exponents are
expanded. Where the equations hold and no denominator vanishes, an expression vanishes if its
numerator N is in the radical of the ideal I of the equations, saturated by the denominators D. This
is so if I and 1 − z D N generate 1 (Rabinowitsch's trick). Gröbner bases are computed by FLINT in
the graded reverse lexicographic order, within size limits.

Source: D. Cox, J. Little, D. O'Shea, *Ideals, Varieties, and Algorithms*, 4.2 and 4.4.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from math import comb, lcm
from operator import mul
from typing import NamedTuple

from flint import Ordering, fmpq, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_mpoly_vec

from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
)
from tresym.reals.language.like_terms import collected, scaled
from tresym.reals.numbers.exact import InputError

MOST_ATOMS, MOST_TERMS, MOST_POWER = 12, 3000, 24
LIMITS = (60, 400, 600)
"""Of a basis: its polynomials, the terms of each, and the bits of their coefficients."""
WAVES = ("sin", "cos", "tan", "cot", "sec", "csc")
HYPERBOLIC = tuple(row.name for row in TABLE.values() if row.family == "hyperbolic")


class Quotient(NamedTuple):
    """A numerator over a denominator."""

    top: fmpz_mpoly
    bottom: fmpz_mpoly


class TooManyError(Exception):
    """A polynomial, or the number of polynomials, exceeds the size limit."""


class System:
    """Polynomials of expressions in one ring, and the equations of the functions in them."""

    def __init__(self, expressions: Sequence[Expr]) -> None:
        """Find the functions in the expressions and give each a generator.

        Raises:
            TooManyError: there are too many of them.
        """
        self.units = _units(expressions)
        self.atoms: dict[Expr, int] = {}
        for e in expressions:
            self._take(e)
        if len(self.atoms) > MOST_ATOMS:
            raise TooManyError
        names = [f"x{i}" for i in range(len(self.atoms) + 1)]  # and one more, for Rabinowitsch
        self.ring = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        self.generators = self.ring.gens()
        self.one: fmpz_mpoly = self.ring.constant(1)

    # -- the functions ----------------------------------------------------------------------

    def _take(self, e: Expr) -> None:
        if e.op == "number":
            return
        if e.op in ("+", "*"):
            inner: Iterable[Expr] = e.args
        elif e.op == "^" and e.args[1].op == "number":
            r = e.args[1].args[0]
            inner = e.args[:1]
            if r.q != 1:
                self._name(_root(e.args[0], int(r.q)))
        elif e.op in (*WAVES, *HYPERBOLIC, "exp"):
            for unit, _ in self._multiples(e):
                for wave in ("sin", "cos") if e.op in WAVES else ("exp",):
                    self._name(apply(wave, unit))
            return
        else:
            self._name(e)
            inner = e.args if e.op == "abs" else ()
        for arg in inner:
            self._take(arg)

    def _name(self, e: Expr) -> None:
        self.atoms.setdefault(e, len(self.atoms))

    def _multiples(self, e: Expr) -> list[tuple[Expr, int]]:
        """An angle or exponent as a sum of whole multiples of units; quarter turns left out."""
        return [
            (number(self.units[term]) * term, int(scale / self.units[term]))
            for scale, term in _terms(e.args[0])
            if e.op not in WAVES or _quarter_turns(scale, term) is None
        ]

    def relations(self) -> list[fmpz_mpoly]:
        """What the functions satisfy wherever they are defined."""
        equations = []
        for atom, i in self.atoms.items():
            x = self.generators[i]
            if atom.op == "sin":
                equations.append(
                    x**2 + self.generators[self.atoms[apply("cos", atom.args[0])]] ** 2 - 1
                )
            elif atom.op == "abs":
                top, bottom = self.quotient(atom.args[0])
                equations.append(x**2 * bottom**2 - top**2)
            elif atom.op == "^" and atom.args[1].op == "number":
                top, bottom = self.quotient(atom.args[0])
                equations.append(x ** int(atom.args[1].args[0].q) * bottom - top)
        return equations

    # -- the quotients ----------------------------------------------------------------------

    def quotient(self, e: Expr) -> Quotient:
        """The expression as a quotient.

        Raises:
            TooManyError: it has too many terms.
        """
        found = self._quotient(e)
        if max(len(part) for part in found) > MOST_TERMS:
            raise TooManyError
        return found

    def _quotient(self, e: Expr) -> Quotient:
        if e.op == "number":
            r = e.args[0]
            return Quotient(self.ring.constant(int(r.p)), self.ring.constant(int(r.q)))
        if e.op == "+":
            return reduce(_sum, map(self.quotient, e.args))
        if e.op == "*":
            return reduce(_product, map(self.quotient, e.args))
        if e.op == "^" and e.args[1].op == "number":
            r = e.args[1].args[0]
            base = e.args[0] if r.q == 1 else _root(e.args[0], int(r.q))
            return self._raised(self.quotient(base) if r.q == 1 else self._atom(base), int(r.p))
        if e.op in WAVES:
            return self._wave(e)
        if e.op in (*HYPERBOLIC, "exp"):
            return self._hyperbolic(e)
        return self._atom(e)

    def _atom(self, e: Expr) -> Quotient:
        return Quotient(self.generators[self.atoms[e]], self.one)

    def _raised(self, base: Quotient, n: int) -> Quotient:
        terms = max(map(len, base))
        if abs(n) > MOST_POWER or comb(abs(n) + terms - 1, terms - 1) > MOST_TERMS:
            raise TooManyError
        top, bottom = base if n >= 0 else base[::-1]
        return Quotient(top ** abs(n), bottom ** abs(n))

    def _wave(self, e: Expr) -> Quotient:
        """A function of an angle by the sines and cosines of the parts of the angle."""
        c, s = self.one, self.ring.constant(0)
        turns = sum(_quarter_turns(*part) or 0 for part in _terms(e.args[0])) % 4
        for _ in range(turns):
            c, s = -s, c
        for unit, n in self._multiples(e):
            if abs(n) > MOST_POWER:
                raise TooManyError
            x, y = (self._atom(apply(wave, unit)).top for wave in ("cos", "sin"))
            for _ in range(abs(n)):
                c, s = (c * x - s * y, c * y + s * x) if n > 0 else (c * x + s * y, s * x - c * y)
        one = self.one
        found = (s, one), (c, one), (s, c), (c, s), (one, c), (one, s)
        return Quotient(*found[WAVES.index(e.op)])

    def _hyperbolic(self, e: Expr) -> Quotient:
        """exp of a sum as a product of powers, and the hyperbolic functions by it."""
        parts = (self._raised(self._atom(apply("exp", u)), n) for u, n in self._multiples(e))
        x = reduce(_product, parts, Quotient(self.one, self.one))
        if e.op == "exp":
            return x
        up, down, both = x.top**2 + x.bottom**2, x.top**2 - x.bottom**2, 2 * x.top * x.bottom
        found = (down, both), (up, both), (down, up), (up, down), (both, up), (both, down)
        return Quotient(*found[HYPERBOLIC.index(e.op)])

    def expression(self, p: fmpz_mpoly) -> Expr:
        """A polynomial as an expression."""
        terms = []
        for powers, c in p.terms():
            factors = [power(a, number(int(powers[i]))) for a, i in self.atoms.items() if powers[i]]
            terms.append(multiply(number(int(c)), *factors))
        return add(ZERO, *terms)


def _root(base: Expr, q: int) -> Expr:
    return Expr("^", (base, number(fmpq(1, q))))


def _terms(e: Expr) -> Iterator[tuple[fmpq, Expr]]:
    """A sum as multiples of terms."""
    whole = collected(e)
    for term in whole.args if whole.op == "+" else (whole,):
        if term != ZERO:
            scale, inner = scaled(term)
            yield (scale, inner) if inner.op != "number" else (inner.args[0] * scale, ONE)


def _quarter_turns(scale: fmpq, term: Expr) -> int | None:
    """How many quarter turns an angle has, where it is a whole number of them."""
    turns = 2 * scale
    return int(turns.p) if term == PI and turns.q == 1 else None


def _units(expressions: Iterable[Expr]) -> dict[Expr, fmpq]:
    """For each term of an angle or exponent, the number of which all its multiples are."""
    scales: dict[Expr, list[fmpq]] = {}
    stack = list(expressions)
    while stack:
        e = stack.pop()
        if e.op in LEAVES:
            continue
        if e.op in (*WAVES, *HYPERBOLIC, "exp"):
            for scale, term in _terms(e.args[0]):
                scales.setdefault(term, []).append(scale)
        stack.extend(e.args)
    return {term: fmpq(1, lcm(*(int(s.q) for s in found))) for term, found in scales.items()}


def _sum(x: Quotient, y: Quotient) -> Quotient:
    if x.bottom == y.bottom:
        return Quotient(x.top + y.top, x.bottom)
    return Quotient(x.top * y.bottom + y.top * x.bottom, x.bottom * y.bottom)


def _product(x: Quotient, y: Quotient) -> Quotient:
    return Quotient(x.top * y.top, x.bottom * y.bottom)


def numerator_factors(e: Expr) -> list[Expr] | None:
    """Expressions one of which is 0 where ``e`` is, and only there; None where none are found."""
    if e.loose or e.hidden:
        return None
    try:
        system = System((e,))
        top = system.quotient(e).top
    except (TooManyError, InputError):
        return None
    return [system.expression(factor) for factor, _ in top.factor()[1]] if top != 0 else None


# Membership


def follows(e: Expr, equations: Sequence[Expr], nonzero: Sequence[Expr], *, vanishes: bool) -> bool:
    """Return whether ``e`` is 0 (or nonzero) at all points at which the equations hold.

    Args:
        equations: expressions that are 0.
        nonzero: expressions that are not 0.
        vanishes: whether to prove that ``e`` is 0; otherwise that it is nowhere 0.
    """
    everything = (e, *equations, *nonzero)
    if any(part.loose or part.hidden for part in everything):
        return False
    try:
        system = System(everything)
        claim, *quotients = map(system.quotient, everything)
        tops = [q.top for q in quotients[: len(equations)]] + system.relations()
        apart = [q.bottom for q in (claim, *quotients)] + [
            q.top for q in quotients[len(equations) :]
        ]
    except (TooManyError, InputError):
        return False
    basis = [p for p in tops if not p.is_zero()]
    if not vanishes:
        return _is_contradiction(system, [*basis, claim.top], apart)
    groebner = _basis(system, basis) if basis else None
    if claim.top.is_zero() or (groebner and claim.top.reduction_primitive_part(groebner).is_zero()):
        return True
    return _is_contradiction(system, basis, [*apart, claim.top])


def _is_contradiction(system: System, zero: list[fmpz_mpoly], apart: list[fmpz_mpoly]) -> bool:
    """Whether no point has all of ``zero`` 0 and none of ``apart``, real or complex."""
    if any(p.is_zero() for p in apart):
        return False
    exponentials = [system.generators[i] for a, i in system.atoms.items() if a.op == "exp"]
    factors = {str(f): f for p in (*apart, *exponentials) for f, _ in p.factor()[1]}
    product = reduce(mul, factors.values(), system.one)
    if product.total_degree() > MOST_POWER:
        return False
    groebner = _basis(system, [*zero, 1 - system.generators[-1] * product])
    return groebner is not None and any(p.is_constant() and not p.is_zero() for p in groebner)


def _basis(system: System, polynomials: list[fmpz_mpoly]) -> fmpz_mpoly_vec | None:
    """A Gröbner basis; None beyond the bounds."""
    vector = fmpz_mpoly_vec(polynomials, system.ring)
    found, is_done = vector.buchberger_naive(limits=LIMITS)
    return found if is_done else None
