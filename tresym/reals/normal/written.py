"""Normal forms written as expressions again."""

from __future__ import annotations

from tresym.reals.language.expression import PI, Expr, add, apply, multiply, number, power, symbol
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction, Generator, Poly, UndefinedError
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.places.conditions import Given


def numerator(e: Expr, region: Given) -> Expr:
    """The numerator of the normal form of ``e``, or ``e`` itself where there is none to write."""
    try:
        field = Field(region)
        (value,) = field.normal(e)
        return written(field, value.num) or e
    except (TooLargeError, UndefinedError, InputError):
        return e


def written(field: Field, p: Poly) -> Expr | None:
    """A polynomial in generators as an expression, None where one of them cannot be written."""
    terms: list[Expr] = []
    parts = {i: _generator(field, field.at(i)) for i in field.used(p)}
    for monomial, value in p.terms():
        factors = [number(int(value))]
        for i, part in parts.items():
            if part is None:
                return None
            if monomial[i]:
                factors.append(power(part, number(int(monomial[i]))))
        terms.append(multiply(*factors))
    return add(*terms)


def _generator(field: Field, generator: Generator) -> Expr | None:
    """The function that a generator stands for, where it is one of those of expressions."""
    data = generator.data
    match generator.kind:
        case "symbol":
            return symbol(data[0])
        case "pi":
            return PI
        case "root" | "log":
            inner = written(field, data[0])
            known = field.sign(data[0])
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
    return None


def _fraction(field: Field, x: Fraction) -> Expr | None:
    top, bottom = written(field, x.num), written(field, x.den)
    return None if top is None or bottom is None else top / bottom
