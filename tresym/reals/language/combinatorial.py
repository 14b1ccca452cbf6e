"""Functions of integers that are written by factorials and products when they are read.

The Catalan number (2n)!/(n! (n + 1)!), the double factorials (2m)!! = 2ᵐ m! and
(2m − 1)!! = (2m)!/(2ᵐ m!), rising factorials such as x (x + 1) (x + 2) and falling ones (DLMF
5.2(iii), 5.4.2, 26.5.1). So whatever decides factorials decides them.
"""

from __future__ import annotations

from collections.abc import Callable

from tresym.reals.language.expression import (
    ONE,
    Expr,
    add,
    integer,
    multiply,
    number,
    power,
    unknown,
)
from tresym.reals.numbers.exact import InputError

MOST_FACTORS = 100
"""A rising or falling factorial of at most so many factors is written as a product."""


def _factorial(n: Expr) -> Expr:
    return unknown("factorial", (n,))


def catalan(n: Expr) -> Expr:
    """Return the Catalan number."""
    return _factorial(2 * n) / (_factorial(n) * _factorial(n + 1))


def double_factorial(n: Expr) -> Expr:
    """Return n!! for an n that is seen to be even or odd, such as 2*m - 1.

    Raises:
        InputError: it is not seen.
    """
    terms = n.args if n.op == "+" else (n,)
    last = [k for k in map(integer, terms) if k is not None]
    rest = [term for term in terms if integer(term) is None]
    halves = [_half(term) for term in rest]
    if None in halves:
        raise InputError(f"factorial2({n}): write factorial2(2*m) or factorial2(2*m - 1)")
    constant = sum(last)
    m = add(*(half for half in halves if half is not None), number((constant + 1) // 2))
    if constant % 2 == 0:
        return power(number(2), m) * _factorial(m)
    return _factorial(2 * m) / (power(number(2), m) * _factorial(m))


def _half(term: Expr) -> Expr | None:
    """Return half of an even multiple of something."""
    first = integer(term.args[0]) if term.op == "*" else None
    if first is None or first % 2:
        return None
    return multiply(number(first // 2), *term.args[1:])


def rising(x: Expr, n: Expr) -> Expr:
    """Return x (x + 1) … (x + n − 1)."""
    return multiply(ONE, *(x + number(j) for j in range(_factors(x, n))))


def falling(x: Expr, n: Expr) -> Expr:
    """Return x (x − 1) … (x − n + 1)."""
    return multiply(ONE, *(x - number(j) for j in range(_factors(x, n))))


def _factors(x: Expr, n: Expr) -> int:
    """Return how many factors a product has.

    Raises:
        InputError: that is no number. A quotient of gamma functions has no value where x is 0 or a
            negative integer, though the product has one.
    """
    k = integer(n)
    if k is None or not 0 <= k <= MOST_FACTORS:
        raise InputError(
            f"a rising or falling factorial has 0 to {MOST_FACTORS} factors here; write "
            f"gamma({x} + {n})/gamma({x}), which speaks of {x} other than 0, -1, -2, ..."
        )
    return k


COMBINATORIAL: dict[tuple[str, int], Callable[..., Expr]] = {
    **dict.fromkeys((("catalan", 1), ("CatalanNumber", 1)), catalan),
    **dict.fromkeys((("factorial2", 1), ("Factorial2", 1)), double_factorial),
    **dict.fromkeys((("pochhammer", 2), ("Pochhammer", 2), ("rf", 2)), rising),
    **dict.fromkeys((("FactorialPower", 2), ("ff", 2)), falling),
}
"""How they are written, by name and number of arguments."""
