"""Sums whose terms cancel to all powers, rewritten so that nothing is left to cancel.

An expansion in powers sees nothing of e^u − 1 where u is exponentially small, nor of log x where a
second logarithm takes its growth away. Each step is an identity wherever the sum is defined.
"""

from __future__ import annotations

from flint import fmpq

from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    sqrt,
    symbols,
)

MAX_EXPONENT = 100


def without_cancellation(e: Expr) -> list[Expr]:
    """The terms of the sum ``e``, its logarithms joined and tanh(u) ± 1 in exponentials.

    A number, where there is one, comes last.
    """
    terms = _joined_logarithms(list(e.args))
    constant = terms[-1] if terms and terms[-1].op == "number" else None
    if constant is not None:
        for i, term in enumerate(terms[:-1]):
            scale, inner = scaled(term)
            if inner.op == "tanh" and abs(scale) == abs(constant.args[0]):
                side = 1 if scale == constant.args[0] else -1
                u = inner.args[0]
                terms[i] = 2 * constant / (apply("exp", -2 * side * u) + 1)
                terms.pop()
                break
    return terms


def scaled(term: Expr) -> tuple[fmpq, Expr]:
    """A term as a number times the rest."""
    if term.op == "*" and term.args[0].op == "number":
        return term.args[0].args[0], multiply(*term.args[1:])
    return fmpq(1), term


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


def _joined_logarithms(terms: list[Expr]) -> list[Expr]:
    """Multiples of logarithms of the variable as one logarithm, where there are several."""
    found: list[Expr] = []
    rest: list[Expr] = []
    for term in terms:
        r, inner = scaled(term)
        usable = inner.op in ("log", "asinh", "acosh") and max(abs(r.p), r.q) <= MAX_EXPONENT
        if usable and symbols(inner):
            found.append(power(_argument(inner), number(r)))
        else:
            rest.append(term)
    return terms if len(found) < 2 else [apply("log", multiply(*found)), *rest]


def _argument(e: Expr) -> Expr:
    """u with e = log u."""
    x = e.args[0]
    if e.op == "asinh":
        return x + sqrt(x**2 + 1)
    if e.op == "acosh":
        return x + sqrt(x - 1) * sqrt(x + 1)
    return x
