"""Fractions in generators are added, multiplied and reduced as the numbers they stand for."""

from collections.abc import Callable
from operator import add, mul, sub, truediv
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.normal.ring import (
    LARGEST_DEGREE,
    MAX_DEGREE,
    Fraction,
    Poly,
    Ring,
    TooLargeError,
    UndefinedError,
    factors_of,
    small_factor,
)
from tresym.reals.numbers.arithmetic import ball_precision

LEAVES = ("x", "y", "2", "3", "A", "B", "s")
VALUES = {"x": fmpq(3, 7), "y": fmpq(11, 5), "2": fmpq(2), "3": fmpq(3), "s": fmpq(-1)}


def made() -> tuple[Ring, dict[str, Fraction]]:
    """Q(x, y) with A² = x, B² = y + A and a sign s² = 1."""
    ring = Ring(6)
    names: dict[str, Any] = {}
    names["x"], names["y"] = ring.symbol("x"), ring.symbol("y")
    x, y = (ring.variable(names[name]) for name in "xy")
    names["A"] = ring.generator("root", "A", (x, 2))
    a = ring.variable(names["A"])
    names["B"] = ring.generator("root", "B", (y + a, 2))
    names["s"] = ring.generator("sign", "s", (x - y,))
    ring.relate(names["A"], 2, x)
    ring.relate(names["B"], 2, y + a)
    ring.relate(names["s"], 2, ring.one_poly)
    leaves = {name: ring.fraction(ring.variable(g)) for name, g in names.items()}
    return ring, leaves | {"2": ring.fraction(2), "3": ring.fraction(3)}


def values() -> dict[str, arb]:
    found = {name: arb(value) for name, value in VALUES.items()}
    found["A"] = found["x"].sqrt()
    found["B"] = (found["y"] + found["A"]).sqrt()
    return found


def at(ring: Ring, p: Poly, known: dict[str, arb]) -> arb:
    by_position = {
        g.position: known[name] for g, name in zip(ring.generators, "xyABs", strict=True)
    }
    total = arb(0)
    for monomial, value in p.terms():
        term = arb(value)
        for i, k in enumerate(monomial):
            if k:
                term *= by_position[i] ** int(k)
        total += term
    return total


trees = st.recursive(
    st.sampled_from(LEAVES),
    lambda inner: st.tuples(st.sampled_from("+-*/"), inner, inner),
    max_leaves=7,
)


OPERATIONS = {"+": add, "-": sub, "*": mul, "/": truediv}


def walk(tree: Any, leaf: Callable[[str], Any]) -> Any:
    if isinstance(tree, str):
        return leaf(tree)
    op, left, right = tree
    return OPERATIONS[op](walk(left, leaf), walk(right, leaf))


@given(trees)
def test_the_value_is_kept(tree: Any) -> None:
    ring, leaves = made()
    try:
        found = walk(tree, leaves.__getitem__)
    except UndefinedError:
        return
    with ball_precision(400):
        known = values()
        expected = walk(tree, known.__getitem__)
        value = at(ring, found.num, known) / at(ring, found.den, known)
        if expected.is_finite() and value.is_finite():
            assert value.overlaps(expected)
        if found.num.is_zero() and expected.is_finite():
            assert expected.contains(0)


@given(trees, trees, trees)
def test_equal_fractions_have_one_form(p: Any, q: Any, r: Any) -> None:
    leaves = made()[1]
    try:
        a, b, c = (walk(tree, leaves.__getitem__) for tree in (p, q, r))
        left = a * (b + c)
        right = c * a + b * a
    except (TooLargeError, UndefinedError):
        return
    assert (left - right).num.is_zero()
    assert (a + b - b).key == (a + 0).key


def test_a_root_leaves_the_denominator() -> None:
    leaves = made()[1]
    x, a = leaves["x"], leaves["A"]
    inverse = 1 / (1 + a)  # 1/(1 + √x) = (1 − √x)/(1 − x)
    expected = (1 - a) / (1 - x)
    assert inverse.key == expected.key


@pytest.mark.parametrize("kind", ["log", "opaque"])
def test_no_conjugate_that_an_unknown_value_may_make_zero(kind: str) -> None:
    """(L − A)/(L² − x) for 1/(L + A) is lost where L is A: the norm may vanish on a region."""
    ring, leaves = made()
    data = (leaves["x"].num + 1,) if kind == "log" else ("f", leaves["x"])
    below = ring.fraction(ring.generator(kind, "L", data)) + leaves["A"]
    assert (1 / below).den in (below.num, -below.num)
    assert ring.is_mixed(below.num) is (kind == "opaque")
    assert not ring.is_mixed(leaves["A"].num)


class Cautious(Ring):
    """A ring in which anything may vanish on a region."""

    def is_mixed(self, p: Poly) -> bool:
        return True


class Careless(Ring):
    """A ring that looks no further than its logarithms."""

    def is_mixed(self, p: Poly) -> bool:
        return False


@pytest.mark.parametrize(("kind", "name"), [(Cautious, "symbol"), (Careless, "log")])
def test_a_denominator_that_may_vanish_with_its_conjugate_stays(
    kind: type[Ring], name: str
) -> None:
    ring = kind(2)
    x = ring.variable(ring.generator(name, "x", ("x",)))
    two = ring.context.constant(2)
    root = ring.generator("root", "A", (two, 2))
    ring.relate(root, 2, two)
    below = x + ring.variable(root)
    assert ring.make(ring.one_poly, below).den in (below, -below)


def test_the_sign_stands_in_the_numerator() -> None:
    ring, leaves = made()
    p = 1 + leaves["x"].num
    one, other = ring.make(ring.one_poly, -p), ring.make(-ring.one_poly, p)
    assert one.key == other.key


ZERO = [
    ("x - A²", lambda r, v: v["x"] - v["A"] ** 2),
    ("B² − y − A", lambda r, v: v["B"] ** 2 - v["y"] - v["A"]),
    ("s² − 1", lambda r, v: v["s"] ** 2 - 1),
    ("(1 + s)(1 − s)", lambda r, v: (1 + v["s"]) * (1 - v["s"])),
]


@pytest.mark.parametrize(("name", "zero"), ZERO, ids=[name for name, _ in ZERO])
def test_nothing_is_divided_by_zero(name: str, zero: Any) -> None:
    ring, leaves = made()
    x = zero(ring, leaves)
    assert x.num.is_zero()
    with pytest.raises(UndefinedError):
        1 / x
    with pytest.raises(UndefinedError):
        ring.make(ring.one_poly, ring.variables[5] - ring.variables[3] ** 2)
    nearly = x + ring.fraction(fmpq(1, 10**60))
    assert ring.rational(1 / nearly) == 10**60


def test_a_zero_divisor_stays_where_nothing_is_known() -> None:
    ring, leaves = made()
    below = 1 + leaves["s"]
    assert ring.make(ring.one_poly, below.num).den == below.num


def test_bounds() -> None:
    ring, leaves = made()
    x, y = leaves["x"], leaves["y"]
    ring.generator("symbol", "z")
    with pytest.raises(TooLargeError):
        ring.generator("symbol", "one too many")
    with pytest.raises(TooLargeError):
        (x + y) ** (MAX_DEGREE + 1)
    free = Ring(2)
    u = free.variables[0]
    far = free.fraction(u ** (LARGEST_DEGREE + 1))
    with pytest.raises(TooLargeError):
        far + 1


def test_factors_multiply_to_what_they_are_of() -> None:
    ring, leaves = made()
    x, y = leaves["x"].num, leaves["y"].num
    p = -12 * (x**2 - y) ** 2 * (x + y) * y**3
    unit, factors = small_factor(ring, p)
    product = ring.context.constant(unit)
    for factor, k in factors:
        product *= factor**k
    assert product == p
    assert sorted(k for _, k in factors) == [1, 2, 3]
    with pytest.raises(TooLargeError):
        factors_of((x + 10**30) * (x + 10**60))


@pytest.mark.parametrize("position", range(5))
def test_split_by_powers_of_one_generator(position: int) -> None:
    ring = Ring(5)
    g = ring.variables
    p = (1 + g[0] + g[1] * g[2]) ** 3 * (g[3] - g[4] ** 2) + g[position]
    parts = ring.split(p, position)
    assert all(position not in ring.used(part) for part in parts.values())
    assert sum((part * g[position] ** k for k, part in parts.items()), ring.zero_poly) == p


def test_what_is_no_number_is_none() -> None:
    ring, names = made()
    x = ring.fraction(names["x"])
    assert ring.rational(ring.fraction(fmpq(3, 4))) == fmpq(3, 4)
    assert ring.rational(ring.zero) == 0
    assert ring.rational(x) is None
    assert ring.rational(3 / x) is None
    with pytest.raises(UndefinedError):
        ring.zero.inverse()
