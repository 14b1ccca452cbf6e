"""Products and sums in t > 0 with their like parts joined, so that what cancels is gone."""

from __future__ import annotations

from itertools import product

from flint import fmpq

from tresym.reals.language.cancellation import scaled
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    E,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    rebuild,
    symbol,
    symbols,
)

MAX_TERMS = 60
MAX_POWER = 8
LONGEST_FACTORED = 10**12


def factors(e: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """Bases and exponents whose product is ``e``, for positive values of the variable ``name``.

    The two are equal where ``e`` is defined.
    """
    return [*_product(e, name).items()]


def joined(e: Expr, name: str) -> Expr:
    """The product of :func:`factors`: exponentials in one, the terms of sums collected."""
    parts = factors(e, name)
    return multiply(*(apply("exp", x) if base == E else power(base, x) for base, x in parts))


def collected(e: Expr) -> Expr:
    """A sum with its like terms as one, multiples of sums multiplied out."""
    found: dict[Expr, Expr] = {}

    def take(term: Expr, scale: Expr) -> None:
        own, inner = scaled(term)
        scale = scale * number(own)
        if inner.op == "+":
            for part in inner.args:
                take(part, scale)
        else:
            found[inner] = found.get(inner, ZERO) + scale

    take(e, ONE)
    return add(*(multiply(scale, inner) for inner, scale in found.items() if scale != ZERO))


def in_exponentials(e: Expr, name: str) -> Expr:
    """``e`` in exponentials for sinh, cosh and coth, multiplied out, like terms collected."""
    if name not in symbols(e) or e.op == "symbol":
        return e
    args = tuple(in_exponentials(arg, name) for arg in e.args)
    if e.op in ("sinh", "cosh"):
        side = 1 if e.op == "cosh" else -1
        return apply("exp", args[0]) / 2 + side * apply("exp", -args[0]) / 2
    if e.op == "coth":
        return 1 + 2 / (apply("exp", 2 * args[0]) - 1)
    if e.op == "log":
        return collected(add(*_logarithms(args[0], name)))
    if e.op == "^" and _is_no_product(args[1]):
        exponent, rest = _large(args[0], name)
        return joined(power(rest, args[1]) * apply("exp", exponent * args[1]), name)
    found = rebuild(e, args)
    terms = _multiplied_out(found) if e.op in ("+", "*", "^") else None
    return found if terms is None else collected(add(*(joined(term, name) for term in terms)))


def _is_no_product(exponent: Expr) -> bool:
    """Whether a power is a root or a reciprocal."""
    return exponent.op == "number" and (exponent.args[0].q > 1 or exponent.args[0] < 0)


def _logarithms(e: Expr, name: str) -> list[Expr]:
    """The terms of log of ``e``: its exponential and its numbers taken out."""
    exponent, rest = _large(e, name)
    terms, others = [exponent], []
    for base, x in factors(rest, name):
        if base == E:
            terms.append(x)
        elif base.op == "number" and base.args[0] > 0:
            terms += [x * k * apply("log", number(p)) for p, k in _primes(base.args[0])]
        else:
            others.append((base, x))
    if len(others) != 1 or others[0][1] != ONE:
        return [exponent, apply("log", rest)]
    return [*terms, apply("log", others[0][0])]


def _primes(r: fmpq) -> list[tuple[fmpq, int]]:
    """Primes and powers of a positive rational, itself where it is long."""
    if max(r.p, r.q) > LONGEST_FACTORED:
        return [(r, 1)]
    return [(fmpq(p), side * int(k)) for side, n in ((1, r.p), (-1, r.q)) for p, k in n.factor()]


def _large(e: Expr, name: str) -> tuple[Expr, Expr]:
    """u and v with ``e`` = exp(u) v, where ``e`` is a sum with one exponential."""
    large = [term for term in e.args if term.op == "exp"] if e.op == "+" else []
    if len(large) != 1:
        return ZERO, e
    (term,) = large
    rest = (joined(part / term, name) for part in e.args if part != term)
    return term.args[0], add(*rest, ONE)


def _multiplied_out(e: Expr) -> list[Expr] | None:
    """The terms of products and powers of sums; None where they are too many."""
    if e.op == "+":
        parts = [_multiplied_out(arg) for arg in e.args]
        terms = [term for part in parts for term in part or ()]
        return None if None in parts or len(terms) > MAX_TERMS else terms
    if e.op == "*":
        return _product_of_sums([_multiplied_out(arg) for arg in e.args])
    if e.op == "^" and e.args[0].op == "+" and e.args[1].op == "number":
        n = e.args[1].args[0]
        if n.q == 1 and 0 < n <= MAX_POWER:
            return _product_of_sums([_multiplied_out(e.args[0])] * int(n))
    return [e]


def _product_of_sums(parts: list[list[Expr] | None]) -> list[Expr] | None:
    terms = [ONE]
    for part in parts:
        if part is None or len(part) * len(terms) > MAX_TERMS:
            return None
        terms = [multiply(x, y) for x, y in product(terms, part)]
    return terms


def _product(e: Expr, name: str) -> dict[Expr, Expr]:
    found: dict[Expr, Expr] = {}
    for part in e.args if e.op == "*" else (e,):
        for base, exponent in _parts(part, name):
            found[base] = collected(found.get(base, ZERO) + exponent)
    return {base: exponent for base, exponent in found.items() if exponent != ZERO}


def _parts(e: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """The factors of one that is no product."""
    if e.op == "exp":
        return _parts_of_exponential(e.args[0], name)
    if e.op == "log":
        return _parts_of_logarithm(e, name)
    if e.op == "abs":
        return [(_size(b, name), x) for b, x in _product(e.args[0], name).items()]
    if e.op == "+":
        return _parts_of_sum(collected(e), name)
    if e.op != "^":
        return [(e, ONE)]
    base, exponent = e.args
    inside = _product(base, name)
    whole = exponent.op == "number" and exponent.args[0].q == 1
    if whole or all(_is_positive(b, name) for b in inside):
        return [(b, collected(x * exponent)) for b, x in inside.items()]
    return [(joined(base, name), exponent)]


def _parts_of_exponential(exponent: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """exp(u + c log v) as exp(u) and the powers in v**c."""
    rest, parts = [], []
    for term in exponent.args if exponent.op == "+" else (exponent,):
        scale, inner = scaled(term)
        if inner.op == "log":
            inside = _product(inner.args[0], name)
            if scale.q == 1 or all(_is_positive(base, name) for base in inside):
                parts += [(base, collected(x * number(scale))) for base, x in inside.items()]
            else:  # the sign of a base counts: (v²)^(1/2) is no v
                parts.append((joined(inner.args[0], name), number(scale)))
        else:
            rest.append(term)
    return [(E, add(*rest)), *parts]


def _parts_of_logarithm(e: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """log(t**r) as r log t."""
    inside = _product(e.args[0], name)
    if list(inside) != [symbol(name)]:
        return [(apply("log", joined(e.args[0], name)), ONE)]
    return [(inside[symbol(name)], ONE), (apply("log", symbol(name)), ONE)]


def _parts_of_sum(e: Expr, name: str) -> list[tuple[Expr, Expr]]:
    """The sum, with what all terms have in common taken out."""
    if e.op != "+":
        return [*_product(e, name).items()]
    terms = [_product(term, name) for term in e.args]
    common = {
        base: exponent
        for base, exponent in terms[0].items()
        if all(_has(term, base, exponent, name) for term in terms)
    }
    if not common:
        return [(e, ONE)]
    factor = multiply(*(power(base, -exponent) for base, exponent in common.items()))
    rest = add(*(joined(term * factor, name) for term in e.args))
    return [*common.items(), (rest, ONE)]


def _has(term: dict[Expr, Expr], base: Expr, exponent: Expr, name: str) -> bool:
    """Whether the factor may be taken out: any growing exponential, else one that is the same."""
    own = term.get(base)
    both = own is not None and {name} <= symbols(own) & symbols(exponent)
    return own == exponent or (base == E and both)


def _size(base: Expr, name: str) -> Expr:
    """|base|."""
    if base.op == "number":
        return number(abs(base.args[0]))
    return base if base.op == "abs" or _is_positive(base, name) else apply("abs", base)


def _is_positive(base: Expr, name: str) -> bool:
    return base in (E, symbol(name)) or (base.op == "number" and base.args[0] > 0)
