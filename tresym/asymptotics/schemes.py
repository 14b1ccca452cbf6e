"""Differences and quadrature for every smooth f: Taylor's theorem at one point x.

A scheme is a sum of values f(x + c h), derivatives there and integrals between such points, with
powers of h as coefficients. By Taylor's theorem with remainder it is, up to every power of h, a
polynomial in h whose coefficients are linear in f(x), f′(x), f″(x), … These numbers are arbitrary
for smooth f: the scheme is O(h**p) for every f if and only if all coefficients below h**p are zero,
and if one is not, a polynomial (t − x)**k is a counterexample.

Example: ``(f(x+h) - 2*f(x) + f(x-h))/h**2 == diff(f(x), x, 2) + O(h**2) as h -> 0``.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import factorial
from typing import NamedTuple

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    multiply,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.verdict import Verdict

LEMMA = "Taylor's theorem with remainder at one point (DLMF 1.4(vi))"
FURTHER = 12
"""Powers of h beyond the claimed one in which the leading error is looked for."""
LARGEST = 40
"""Larger exponents of h are not read."""
Powers = dict[int, Fraction]
"""A sum of powers of h: coefficients by exponents."""


class _UnreadError(Exception):
    """The claim is not a scheme, for the reason that is said."""


class _Atom(NamedTuple):
    """f^(order) at x + high h; or its integral from x + low h to x + high h."""

    name: str
    order: int
    high: Fraction
    low: Fraction | None = None

    def term(self, j: int) -> Fraction:
        """Return the coefficient of f^(order + j)(x) h^j, or h^(j + 1) for an integral."""
        if self.low is None:
            return self.high**j / factorial(j)
        return (self.high ** (j + 1) - self.low ** (j + 1)) / factorial(j + 1)


Linear = dict[_Atom | None, Powers]
"""A sum of atoms with powers of h as coefficients; None stands for 1."""


class _Reader:
    """Reads expressions as schemes in h."""

    def __init__(self, h: str) -> None:
        self.h = h
        self.base: Expr | None = None
        self.atoms: dict[Expr, _Atom] = {}

    def place(self, e: Expr) -> Fraction:
        """Return c of an argument x + c h, and remember x, which is the same for all."""
        if not _is_polynomial(e):
            raise _UnreadError(f"the argument {e} is not x + c*h")
        slope = normal_form(differentiate(e, self.h), Given())
        base = normal_form(substitute(e, {self.h: ZERO}), Given())
        if slope.op != "number":
            raise _UnreadError(f"the argument {e} is not x + c*{self.h} with a rational number c")
        if self.base is not None and base != self.base:
            raise _UnreadError(f"the arguments {base} and {self.base} are not near one point")
        self.base = base
        return Fraction(int(slope.args[0].p), int(slope.args[0].q))

    def atom(self, e: Expr) -> _Atom:
        """Return what an unknown value or an integral of one is."""
        f = e.args[0] if e.op == "integral" else e
        if f.op != "unknown" or len(f.args) != 2:
            raise _UnreadError("only functions of one argument and their plain integrals are read")
        name, orders = f.args[0].args
        if e.op == "unknown":
            return _Atom(name, orders[0], self.place(f.args[1]))
        if f.args[1].op != "bound":
            raise _UnreadError(f"the integrand of {e} is not the plain {name}")
        return _Atom(name, orders[0], self.place(e.args[2]), self.place(e.args[1]))

    def read(self, e: Expr) -> Linear:
        """Return an expression as a scheme."""
        if e.op == "number":
            return {None: {0: Fraction(int(e.args[0].p), int(e.args[0].q))}}
        if e == symbol(self.h):
            return {None: {1: Fraction(1)}}
        if e.op in ("unknown", "integral"):
            self.atoms[e] = self.atom(e)
            return {self.atoms[e]: {0: Fraction(1)}}
        if e.op == "+":
            return _sum(*map(self.read, e.args))
        if e.op == "*":
            product: Linear = {None: {0: Fraction(1)}}
            for factor in e.args:
                product = _product(product, self.read(factor))
            return product
        n = integer(e.args[1]) if e.op == "^" else None
        if n is None or abs(n) > LARGEST:
            raise _UnreadError(f"{e} is not a number or a sum of powers of {self.h}")
        base = self.read(e.args[0])
        if n < 0:
            powers = base.get(None, {})
            if len(base) != 1 or len(powers) != 1:
                raise _UnreadError(f"the denominator {e.args[0]} is not a power of {self.h}")
            ((m, c),) = powers.items()
            base, n = {None: {-m: 1 / c}}, -n
        found: Linear = {None: {0: Fraction(1)}}
        for _ in range(n):
            found = _product(found, base)
        return found


def _is_polynomial(e: Expr) -> bool:
    if e.op in ("+", "*"):
        return all(map(_is_polynomial, e.args))
    return e.op == "number" or (e.op == "symbol" and e.args[0] not in ("oo", "..."))


def _sum(*terms: Linear) -> Linear:
    total: defaultdict[_Atom | None, defaultdict[int, Fraction]]
    total = defaultdict(lambda: defaultdict(Fraction))
    for term in terms:
        for atom, powers in term.items():
            for n, c in powers.items():
                total[atom][n] += c
    kept = {atom: {n: c for n, c in powers.items() if c} for atom, powers in total.items()}
    return {atom: powers for atom, powers in kept.items() if powers}


def _product(one: Linear, other: Linear) -> Linear:
    terms: list[Linear] = []
    for first, powers in one.items():
        for second, more in other.items():
            if first is not None and second is not None:
                raise _UnreadError("a product of values of functions is not linear in them")
            atom = second if first is None else first
            terms += [{atom: {n + m: c * d}} for n, c in powers.items() for m, d in more.items()]
    if any(abs(n) > LARGEST for term in terms for powers in term.values() for n in powers):
        raise _UnreadError(f"powers beyond {LARGEST} are not read")
    return _sum(*terms)


Jet = tuple[str, int] | None
"""f^(k)(x), or None for 1."""


def _series(scheme: Linear, top: int) -> dict[int, dict[Jet, Fraction]]:
    """Return the coefficients of the powers of h up to ``top``, linear in the derivatives at x."""
    found: defaultdict[int, defaultdict[Jet, Fraction]]
    found = defaultdict(lambda: defaultdict(Fraction))
    for atom, powers in scheme.items():
        for n, c in powers.items():
            if atom is None:
                if n <= top:
                    found[n][None] += c
                continue
            first = n + (atom.low is not None)
            for j in range(max(0, top - first + 1)):
                found[first + j][atom.name, atom.order + j] += c * atom.term(j)
    kept = {n: {jet: c for jet, c in jets.items() if c} for n, jets in found.items()}
    return {n: jets for n, jets in sorted(kept.items()) if jets}


def decide_scheme(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide that a scheme is O(h**p) or o(h**p) for all smooth functions in it."""
    try:
        return _decide(claim, statement, decided)
    except _UnreadError as reason:
        why = f"integrals, limits and orders of arbitrary functions need a scheme in h: {reason}"
        return Answer(Verdict.UNDECIDED, why)


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    if path is None or path.point != ZERO or path.expression is not None:
        raise _UnreadError("its path must be h -> 0")
    if claim.relation not in ("O", "o"):
        raise _UnreadError("only O and o are decided")
    if statement.said or statement.integers or statement.uniformly or path.reach is not None:
        raise _UnreadError("conditions, ranges and uniformity are not supported")
    if claim.derivatives:
        raise _UnreadError("derivatives of other functions are not supported")
    reader = _Reader(path.name)
    gauge = reader.read(claim.right)
    if [*gauge] != [None] or len(gauge[None]) != 1:
        raise _UnreadError(f"the order {claim.right} is not a power of {path.name}")
    (p,) = gauge[None]
    scheme = reader.read(claim.left)
    base = ZERO if reader.base is None else reader.base
    names = sorted({atom.name for atom in reader.atoms.values()})
    series = _series(scheme, p + FURTHER)
    h = symbol(path.name)
    shown = ", ".join(names)
    if not scheme:
        return Answer(Verdict.PROVED, f"for all smooth {shown} the error is zero", lemma=LEMMA)
    q = next(iter(series), None)
    leading = None if q is None else _leading(series[q], q, h, base)
    if q is not None and (q < p or (q == p and claim.relation == "o")):
        jet = None if None in series[q] else min(j for j in series[q] if j is not None)
        example = _with_polynomial(claim, reader, jet, h)
        found = decided(example, statement)
        if found.verdict is not Verdict.REFUTED:
            why = f"the error is {leading} + …, but the example {example.left} is not refuted"
            return Answer(Verdict.UNDECIDED, why)
        which = f"{shown} = 0"
        if jet is not None:
            which = f"{jet[0]}(t) = {_power(symbol('t') - base, jet[1])}"
            which += ", all others 0" if len(names) > 1 else ""
        why = f"the error is {leading} + …, so the true order is {_power(h, q)}"
        return Answer(Verdict.REFUTED, f"{why}; for example {which}", witness={}, lemma=LEMMA)
    example = _with_exponentials(claim, reader, names, h)
    if decided(example, statement).verdict is Verdict.REFUTED:
        return Answer(Verdict.UNDECIDED, "an exponential function contradicts Taylor's theorem")
    error = f"the error is {leading} + …" if q is not None else "no term of the error was found"
    fixed = f" at each fixed {base}" if symbols(base) else f" at {base}"
    near = f"for all smooth {shown}{fixed}, by Taylor's theorem with remainder"
    return Answer(Verdict.PROVED, f"{near}: {error}", lemma=LEMMA)


def _leading(jets: dict[Jet, Fraction], q: int, h: Expr, base: Expr) -> Expr:
    """Return the leading term of the error."""
    values = {jet: ONE if jet is None else unknown(jet[0], (base,), (jet[1],)) for jet in jets}
    total = add(*(multiply(number(c), values[jet]) for jet, c in jets.items()))
    return multiply(_power(h, q), total)


def _power(base: Expr, n: int) -> Expr:
    return ONE if n == 0 else power(base, number(n))


def _with_polynomial(claim: Comparison, reader: _Reader, jet: Jet, h: Expr) -> Comparison:
    """Return the claim for (t − x)**k in place of one function and 0 in place of the others."""

    def value(atom: _Atom) -> Expr:
        if jet is None or atom.name != jet[0] or atom.order > jet[1]:
            return ZERO
        j = jet[1] - atom.order
        size = number(atom.term(j) * factorial(jet[1]))
        return multiply(size, _power(h, j + (atom.low is not None)))

    return _put_in(claim, reader, value)


def _with_exponentials(claim: Comparison, reader: _Reader, names: list[str], h: Expr) -> Comparison:
    """Return the claim for exp(r (t − x)) in place of each function, with r = 2, 3, …"""

    def value(atom: _Atom) -> Expr:
        r = Fraction(2 + names.index(atom.name))
        high = apply("exp", multiply(number(r * atom.high), h))
        if atom.low is None:
            return multiply(number(r**atom.order), high)
        low = apply("exp", multiply(number(r * atom.low), h))
        return multiply(number(r ** (atom.order - 1)), high - low)

    return _put_in(claim, reader, value)


def _put_in(claim: Comparison, reader: _Reader, value: Callable[[_Atom], Expr]) -> Comparison:
    known = {node: value(atom) for node, atom in reader.atoms.items()}
    return replace(claim, left=replaced(claim.left, known))
