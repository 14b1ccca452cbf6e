"""Convert normal forms back to expressions."""

from __future__ import annotations

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.language.expression import (
    LEAVES,
    PI,
    UNWORKED,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction, Generator, Poly, UndefinedError
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError


def numerator(e: Expr, region: Given) -> Expr:
    """Return the numerator of the normal form of ``e``, or ``e`` if it cannot be written."""
    try:
        field = Field(region)
        (value,) = field.normal(e)
        return written(field, value.num) or e
    except (TooLargeError, UndefinedError, InputError):
        return e


def written(field: Field, p: Poly) -> Expr | None:
    """Return a polynomial in generators as an expression, or None if one cannot be written."""
    terms: list[Expr] = []
    parts = {i: _generator(field, field.ring.at(i)) for i in field.ring.used(p)}
    for monomial, value in p.terms():
        factors = [number(int(value))]
        for i, part in parts.items():
            if part is None:
                return None
            if monomial[i]:
                factors.append(power(part, number(int(monomial[i]))))
        terms.append(multiply(*factors))
    return add(*terms)


def common_factors(e: Expr) -> tuple[list[Expr], list[Expr]] | None:
    """Return factors of numerator and denominator of ``e``, as a rational function of its atoms.

    Atoms are symbols, functions and roots. Each list begins with powers of the atoms that all terms
    have in common, and ends with the sum that is left. None if ``e`` is too large.

    Example: the numerator of ``sin(x)*x**2 + sin(x)`` has the factors ``sin(x)`` and ``x**2 + 1``.
    """
    plain, atoms = _with_atoms(e)
    try:
        field = Field(Given())
        (value,) = field.normal(plain)
        above, below = (_split(field, p) for p in (value.num, value.den))
    except (TooLargeError, UndefinedError, InputError):
        return None
    if above is None or below is None:
        return None
    return [substitute(x, atoms) for x in above], [substitute(x, atoms) for x in below]


def _split(field: Field, p: Poly) -> list[Expr] | None:
    """Return the powers of generators that all terms of a polynomial share, and what is left."""
    terms = list(p.terms())
    parts: dict[int, Expr] = {}
    for i in field.ring.used(p):
        part = _generator(field, field.ring.at(i))
        if part is None:
            return None
        parts[i] = part
    if not terms:
        return None
    shared = {i: min(int(monomial[i]) for monomial, _ in terms) for i in parts}
    rest = []
    for monomial, value in terms:
        left = ((part, int(monomial[i]) - shared[i]) for i, part in parts.items())
        rest.append(multiply(number(int(value)), *(power(e, number(n)) for e, n in left if n)))
    return [*(power(parts[i], number(n)) for i, n in shared.items() if n), add(*rest)]


def _generator(field: Field, generator: Generator) -> Expr | None:
    """Return the function that a generator stands for, or None if expressions have no such
    function.
    """
    data = generator.data
    match generator.kind:
        case "symbol":
            return symbol(data[0])
        case "pi":
            return PI
        case "root" | "log":
            inner = written(field, data[0])
            known = field.signs.sign(data[0])
            if inner is None:
                return None
            inner = inner if known > 0 else -inner if known < 0 else abs(inner)
            return (
                apply("log", inner) if generator.kind == "log" else inner ** (1 / number(data[1]))
            )
        case "exp" | "sin" | "cos" as name:
            inner = _fraction(field, data[2])
            return None if inner is None else apply(name, inner / int(data[1]))
        case "tan":
            inner = _fraction(field, data[2])
            return None if inner is None else apply("tan", inner / int(2 * data[1]))
        case "atan":
            inner = _fraction(field, data[0])
            return None if inner is None else apply("atan", inner)
        case "opaque" if data[0] in SPECIAL:
            args = [_fraction(field, arg) for arg in data[1:]]
            return None if None in args else apply(data[0], *(arg for arg in args if arg))
    return None


def _fraction(field: Field, x: Fraction) -> Expr | None:
    top, bottom = written(field, x.num), written(field, x.den)
    return None if top is None or bottom is None else top / bottom


def in_lowest_terms(e: Expr) -> Expr:
    """Return ``e`` with each rational function in it as one fraction in lowest terms.

    Functions and roots are treated as atoms, and their arguments in the same way. If an expression
    is too large, ``e`` is returned unchanged. The domain may become larger: x/x becomes 1.
    """
    plain, atoms = _with_atoms(e)
    try:
        field = Field(Given())
        (value,) = field.normal(plain)
        written_form = _fraction(field, value)
        return e if written_form is None else substitute(written_form, atoms)
    except (TooLargeError, UndefinedError, InputError):
        return e


def _with_atoms(e: Expr) -> tuple[Expr, dict[str, Expr]]:
    """Return ``e`` with symbols for its functions and roots, and what these stand for."""
    atoms: dict[str, Expr] = {}

    def walk(node: Expr) -> Expr:
        whole = node.op == "^" and node.args[1].op == "number" and node.args[1].args[0].q == 1
        if node.op in LEAVES:
            return node
        if node.op in ("+", "*"):
            return rebuild(node, tuple(map(walk, node.args)))
        if whole:
            return rebuild(node, (walk(node.args[0]), node.args[1]))
        inner = node  # operations that bind a variable are left unchanged
        if node.op not in UNWORKED:
            inner = rebuild(node, tuple(map(in_lowest_terms, node.args)))
        name = next((n for n, known in atoms.items() if known == inner), f"[{len(atoms)}]")
        atoms[name] = inner
        return symbol(name)

    return walk(e), atoms


def normal_form(e: Expr, given: Given) -> Expr:
    """Return the normal form of ``e`` as an expression, or ``e`` if it cannot be written."""
    try:
        field = Field(given)
        (value,) = field.normal(e)
        return _fraction(field, value) or e
    except (TooLargeError, UndefinedError, InputError):
        return e


def with_closed_values(e: Expr) -> Expr:
    """Return ``e`` with the functions of constants that have simple values, as cos(0) and atan(1).

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> str(with_closed_values(parse("x*cos(0) + sin(pi/2)*y + sin(1)")))
        'x + y + sin(1)'
    """
    known = {}
    for node in operations((e,)):
        if node.op in TABLE and not node.hidden and not node.loose and not symbols(node):
            value = normal_form(node, Given())
            if all(part.op in ("*", "+") for part in operations((value,))):
                known[node] = value
    return replaced(e, known) if known else e
