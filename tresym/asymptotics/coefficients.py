"""Coefficients [zⁿ] f(z) of generating functions as n → ∞, from the singularities of f.

Example: ``coefficient((1 - sqrt(1 - 4*z))/(2*z), z, n) ~ 4**n/sqrt(pi*n**3)`` (Catalan numbers).

Let ρ be the nearest singularity of f. With u = 1 − z/ρ, an expansion of f in terms c uᵅ logᵏ u and
an error O(uᵝ logᵏ u) as u → 0 gives [zⁿ] f term by term, with an error O(ρ⁻ⁿ n^{−β−1} logᵏ n), as f
is analytic in a larger disc without the half-line from ρ on. With s = −α,

    [wⁿ] (1 − w)⁻ˢ = Γ(n + s)/(Γ(s) n!) = nˢ⁻¹/Γ(s) (1 + s(s − 1)/(2n) + …),

and powers of log(1/(1 − w)) are derivatives by s. Singularities at ρ and −ρ add up. Where all are
poles, the error is O(R⁻ⁿ) for a radius R > ρ within which there is no other singularity.

A rational f gives a linear recurrence with constant coefficients, which is solved exactly.

Source: P. Flajolet and A. Odlyzko, *SIAM J. Discrete Math.* 3 (1990), 216–240.
"""

from __future__ import annotations

from math import comb, factorial
from typing import NamedTuple

from flint import fmpq, fmpq_poly

from tresym.asymptotics.dominant_singularities import (
    Nearest,
    UnsupportedError,
    nearest_singularities,
    stays_regular,
)
from tresym.asymptotics.explicit_terms import explicit_terms
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.asymptotics.linear_recurrences import Solved
from tresym.asymptotics.rational_functions import over
from tresym.asymptotics.stirling import bernoulli
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    number,
    opened,
    power,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.signs.sign import sign

CAUCHY = "Cauchy's bound of coefficients by the maximum on a circle"
LEMMA = "singularity analysis (Flajolet and Odlyzko 1990)"
RATIONAL = "the linear recurrence of the coefficients of a rational function"
MOST_TERMS = 7
"""Terms of the expansion at a singularity that are looked at."""
MOST_LOGARITHMS = 2
_U = "[u]"


class Term(NamedTuple):
    """A term c uᵅ log(1/u)ᵏ at a singularity."""

    coefficient: Expr
    alpha: fmpq
    logarithms: int

    @property
    def vanishes(self) -> bool:
        """Whether the term is a polynomial, without coefficients for large n."""
        return bool(self.logarithms == 0 and self.alpha >= 0 and self.alpha.q == 1)


class Coefficients(Expansion):
    """The expansion of [zⁿ] f(z), where n is the variable of the path."""

    lemma = LEMMA

    def __init__(self, f: Expr, z: str, n: str, nearest: Nearest) -> None:
        """Expand the coefficients of a function with these nearest singularities."""
        self.f, self.z, self.n, self.nearest = f, z, n, nearest

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the contributions of ``order`` terms at each singularity, and the error."""
        mains: list[Expr] = []
        errors: list[Expr] = []
        n = symbol(self.n)
        for point, pole in self.nearest.points:
            found = _at_singularity(self.f, self.z, point, order, pole)
            if found is None:
                return None
            terms, error = found
            rate = power(abs_of(point), -n)
            if sign(point, Given()) == "-":
                rate = power(MINUS_ONE, n) * rate
            for term in terms:
                whole, left_out = _of_power(term, n, order)
                mains.append(rate * term.coefficient * whole)
                if left_out != ZERO:
                    errors.append(power(abs_of(point), -n) * left_out)
            if error is not None:
                at = _power(n, -error.alpha - 1)
                if error.logarithms:
                    at = at * power(apply("log", n), number(error.logarithms))
                errors.append(power(abs_of(point), -n) * at)
        if all(pole for _, pole in self.nearest.points):
            errors.append(power(number(self.nearest.radius), -n))
        return add(ZERO, *mains), add(ZERO, *errors)

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """What is needed was shown when the singularities were found."""
        where = ", ".join(str(point) for point, _ in self.nearest.points) or "none"
        text = f"{self.f} has no other singularity for abs({self.z}) <= {self.nearest.radius}"
        ask.keep(f"{text} than {where}", Given(), ask.verdict)
        return Bound()


class _OfEntire(Expansion):
    """The coefficients of an entire function, which are O(R⁻ⁿ) for every R (Cauchy)."""

    lemma = CAUCHY

    def __init__(self, n: str) -> None:
        """Take the name of the index."""
        self.n = n

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return 0, and R⁻ⁿ with a radius that grows with the order."""
        return ZERO, power(number(10**order), -symbol(self.n))

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """That the function is entire was shown."""
        return Bound()


class ExactCoefficients(Expansion):
    """The coefficients of a rational function as an explicit function of n."""

    lemma = RATIONAL

    def __init__(self, form: Expr) -> None:
        """Take the function."""
        self.form = form

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the function."""
        return (self.form, ZERO) if order >= 1 else None

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Nothing is left to prove."""
        return Bound()


def coefficients(node: Expr, end: End) -> Expansion | None:
    """Return the expansion of a coefficient whose index is the variable of the path, or None."""
    if node.op != "coefficient" or node.args[1] != symbol(end.name):
        return None
    if end.point is not None or end.side != 1:
        return None
    (z,), f = opened(node, end.taken)
    if f.hidden or symbols(f) - {z}:
        return None
    rational = rational_coefficients(f, z, end.name)
    if rational is not None and rational.form is not None:
        return ExactCoefficients(rational.form)
    try:
        nearest = nearest_singularities(f, z)
    except UnsupportedError:
        return None
    if nearest is None:
        return _OfEntire(end.name)
    if not all(stays_regular(f, z, point) for point, _ in nearest.points):
        return None
    return Coefficients(f, z, end.name, nearest)


def abs_of(point: Expr) -> Expr:
    """Return the absolute value of a number with a known sign."""
    return -point if sign(point, Given()) == "-" else point


def _at_singularity(
    f: Expr, z: str, point: Expr, count: int, pole: bool
) -> tuple[list[Term], Term | None] | None:
    """Return that many terms with coefficients at a singularity, and the error."""
    along = substitute(f, {z: point * (1 - symbol(_U))})
    path = Path(_U, ZERO, (1,))
    found: list[Term] = []
    for most in range(1, MOST_TERMS + 1):
        terms = explicit_terms(along, path, Given(), most)
        if terms is None:
            return None
        read = [_read(e) for e in terms.terms]
        if None in read:
            return None
        found = [term for term in read if term is not None and not term.vanishes]
        if terms.gauge is None:
            return found, None
        error = _read(terms.gauge)
        if error is None:
            return None
        if pole and error.alpha >= 0:  # the rest is analytic
            return found, None
        if len(found) >= count and not (error.vanishes and most < MOST_TERMS):
            return found, error
    return None


def _read(e: Expr) -> Term | None:
    """Return a term c uᵅ log(1/u)ᵏ in its parts."""
    u = symbol(_U)
    log = -apply("log", u)
    alpha = _number(limit_of(differentiate(e, _U) * u / e, _U, ZERO, 1, Given()))
    if alpha is None:
        return None
    beside = e / power(u, number(alpha))
    ratio = -differentiate(beside, _U) * u * log / beside
    k = _number(limit_of(ratio, _U, ZERO, 1, Given()))
    if k is None or k.q != 1 or not 0 <= k <= MOST_LOGARITHMS:
        return None
    small = Given(((u, ">", ZERO), (u, "<", ONE)))
    scale = tidied(normal_form(beside / log ** int(k.p), small))
    if symbols(scale):
        return None
    return Term(scale, alpha, int(k.p))


def _number(e: Expr | None) -> fmpq | None:
    value = None if e is None or e.hidden else tidied(normal_form(e, Given()))
    return value.args[0] if value is not None and value.op == "number" else None


# Coefficients of powers and logarithms


def _of_power(term: Term, n: Expr, order: int) -> tuple[Expr, Expr]:
    """Return [wⁿ] (1 − w)^α log(1/(1 − w))ᵏ in powers of n and log n, and the size of the error."""
    s, k = -term.alpha, term.logarithms
    corrections = _corrections(order + 1)
    if s.q == 1 and s >= 1:  # a polynomial in n, where there are no logarithms
        corrections = _corrections(max(order + 1, int(s.p) + 1))
    log = apply("log", n)
    parts: list[Expr] = []
    last = len(corrections) - 1
    for j, e in enumerate(corrections[:-1]):
        for b in range(k + 1):
            reciprocal = _reciprocal_gamma(s, b)
            for c in range(k - b + 1):
                value = _derivative(e, c)(s)
                a = k - b - c
                if value == 0 or reciprocal == ZERO:
                    continue
                many = factorial(k) // (factorial(a) * factorial(b) * factorial(c))
                logs = ONE if a == 0 else log**a
                scale = number(fmpq(many) * value) * reciprocal * logs
                parts.append(scale * _power(n, s - 1 - j))
    ends = k == 0 and all(_derivative(e, 0)(s) == 0 for e in corrections[max(int(s.floor()), 0) :])
    if k == 0 and s.q == 1 and s >= 1 and ends:
        return add(ZERO, *parts), ZERO
    error = _power(n, s - 1 - last)
    return add(ZERO, *parts), error if k == 0 else error * power(log, number(k))


def _power(n: Expr, exponent: fmpq) -> Expr:
    return ONE if exponent == 0 else power(n, number(exponent))


def _derivative(p: fmpq_poly, times: int) -> fmpq_poly:
    for _ in range(times):
        p = p.derivative()
    return p


def _corrections(count: int) -> list[fmpq_poly]:
    """Return e_j(s) with Γ(n + s)/Γ(n + 1) = nˢ⁻¹ Σ e_j(s) n⁻ʲ, from the series of log Γ.

    log Γ(n + s)/Γ(n + 1) = (s − 1) log n + Σ (−1)^{j+1} (B_{j+1}(s) − B_{j+1}(1))/(j(j+1) nʲ).
    """
    logs = [fmpq_poly([0])]
    for j in range(1, count):
        b = _bernoulli_polynomial(j + 1)
        logs.append((b - fmpq_poly([b(fmpq(1))])) * fmpq((-1) ** (j + 1), j * (j + 1)))
    found = [fmpq_poly([1])]
    for j in range(1, count):  # E' = L' E
        total = fmpq_poly([0])
        for i in range(1, j + 1):
            total += logs[i] * fmpq(i) * found[j - i]
        found.append(total * fmpq(1, j))
    return found


def _bernoulli_polynomial(m: int) -> fmpq_poly:
    return fmpq_poly([bernoulli(m - k) * comb(m, k) for k in range(m + 1)])


def _reciprocal_gamma(s: fmpq, times: int) -> Expr:
    """Return a derivative of 1/Γ at s, up to the second."""
    if s.q == 1 and s <= 0:
        m = -int(s.p)
        scale = number(fmpq((-1) ** m * factorial(m)))
        psi = number(sum((fmpq(1, i) for i in range(1, m + 1)), fmpq(0))) - apply("EulerGamma", ONE)
        return (ZERO, scale, -2 * scale * psi)[times]
    one = 1 / _gamma(s)
    if times == 0:
        return one
    psi = apply("digamma", number(s))
    if s.q == 1:
        whole = sum((fmpq(1, i) for i in range(1, int(s.p))), fmpq(0))
        psi = number(whole) - apply("EulerGamma", ONE)
    if times == 1:
        return -psi * one
    squares = sum((fmpq(1, i * i) for i in range(1, int(s.p))), fmpq(0)) if s.q == 1 else fmpq(0)
    slope = PI**2 / 6 - number(squares) if s.q == 1 else apply("polygamma", ONE, number(s))
    return (psi**2 - slope) * one


def _gamma(s: fmpq) -> Expr:
    """Return Γ(s), in numbers and √π where 2 s is an integer."""
    if s.q > 2:
        return apply("gamma", number(s))
    value, base = fmpq(1), s
    while base > 1:
        base -= 1
        value *= base
    while base < fmpq(1, 2):
        value /= base
        base += 1
    return number(value) * (sqrt(PI) if s.q == 2 else ONE)


# Rational functions


class Rational(NamedTuple):
    """The coefficients of a rational function.

    Attributes:
        sequence: their recurrence.
        form: an explicit function of n, or None where the roots are not supported.
        first: the first n for which it holds.
    """

    sequence: Solved
    form: Expr | None
    first: int


def rational_coefficients(f: Expr, z: str, n: str) -> Rational | None:
    """Return the coefficients of a rational function that is defined at 0, or None."""
    form = in_lowest_terms(f)
    above, below = over(form)
    p, q = (_polynomial(e, z) for e in (above, below))
    if p is None or q is None or q[0] == 0:
        return None
    degree = q.degree()
    first = max(0, p.degree() - degree + 1)
    if degree == 0:
        return None
    series: list[fmpq] = []
    for k in range(first + degree):
        known = sum((q[j] * series[k - j] for j in range(1, min(k, degree) + 1)), fmpq(0))
        series.append((p[k] - known) / q[0])
    coefficients = tuple(-q[degree - j] / q[0] for j in range(degree))
    sequence = Solved(symbol("a"), n, first, 0, coefficients, fmpq(0), tuple(series[first:]))
    try:
        found = sequence.closed()
    except ZeroDivisionError:
        found = None
    return Rational(sequence, found, first)


def _polynomial(e: Expr, z: str) -> fmpq_poly | None:
    terms = polynomial(e)
    if terms is None or any(name != z for m in terms for name, _ in m):
        return None
    degree = max((dict(m).get(z, 0) for m in terms), default=0)
    values = [fmpq(0)] * (degree + 1)
    for m, c in terms.items():
        values[dict(m).get(z, 0)] = c
    return fmpq_poly(values)
