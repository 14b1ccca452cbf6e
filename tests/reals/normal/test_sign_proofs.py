"""Signs proved by ranges, facts, discriminants, conjugates and cases hold at every point."""

from typing import Any

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, Ring
from tresym.reals.normal.sign_proofs import SignProver


def numerator(text: str, under: str) -> tuple[Field, Poly]:
    field = Field(Given.parse(under))
    (value,) = field.normal(parse(text))
    below = field.signs.product_sign(value.den)
    assert below
    return field, value.num * below


PROVED = [
    # with its sign, and one that is too much
    ("x*y + 1", "x > 0, y > 0", 1, "x*y - 1"),
    ("3 - x - y", "0 < x < 1, 0 < y < 2", 1, "3 - x - 2*y"),
    ("x^2 - 4", "x > 2", 1, "x^2 - 5"),
    ("x - 3*x^2 - 1", "-1 < x < 0", -1, "x + 3*x^2 - 1"),
    ("x^2 + x + 1", "", 1, "x^2 + 2*x + 1 - y"),
    ("x^4 + 4", "", 1, "x^4 - 5*x^3 + 4"),
    ("x^4 + x^2*y + y^2", "", 1, "x^4 + 3*x^2*y + y^2"),
    ("5*x^2 - 4*x*y + y^2", "", 1, "3*x^2 - 4*x*y + y^2"),
    ("pi*x - 3*x", "x > 0", 1, "pi*x - 22/7*x - y"),
    ("x - y", "x > y", 1, "x - 2*y"),
    ("x^2 - y", "x > y, y > 1", 1, "x^2 - y^3"),
    ("x + y - z", "x > z, y > 0", 1, "x - y - z"),
    ("sqrt(x) + 1", "", 1, "sqrt(x) - 1"),
    ("sqrt(x + 1) - 1", "x > 0", 1, "sqrt(x + 1) - 2"),
    ("x + 1 - sqrt(x^2 + 1)", "x > 0", 1, "x + 1 - sqrt(2*x^2 + 1)"),
    ("sqrt(x^2 + 1) - x", "", 1, "sqrt(x^2 + 1) - 2*x"),
    ("2 + sign(x)", "", 1, "1/2 + sign(x)"),
    ("x*sign(x - 1) + 2*x", "x > 0", 1, "x*sign(x - 1) + x/2"),
    ("x + y + sign(y - x)*(x - y)/2", "x > 0, y > 0", 1, "x + y + 2*sign(y - x)*(x - y)"),
    ("exp(x) - 1", "x > 0", 1, "exp(x) - 2"),
    ("exp(x) - 1", "x < 0", -1, "exp(x) - 1/2"),
    ("log(x)", "x > 1", 1, "log(x) - 1"),
    ("log(x)", "0 < x < 1", -1, "log(x) + 1"),
    ("tan(x)", "0 < x < pi/2", 1, "tan(x) - 1"),
    ("1 - sin(x)", "0 < x < pi/2", 1, "1 - 2*sin(x)"),
    ("sin(x)", "0 < x < pi", 1, "sin(x) - 1/2"),
    ("sin(x)", "0 < x < pi, y > 0", 1, "sin(x/y)"),
    ("2 + cos(x)", "", 1, "1/2 + cos(x)"),
    ("atan(x) + 2", "", 1, "atan(x) + 1"),
    ("pi - 2*atan(x)", "", 1, "pi - 3*atan(x)"),
    ("pi + 2*atan(x)*atan(y)/2", "x > 0, y > 0", 1, "pi - 4*atan(x)*atan(y)"),
    ("sqrt(2) + sqrt(3) - pi", "", 1, "sqrt(2) + sqrt(3) - pi - x/1000"),
    ("exp(pi) - pi - 20 + 1/1000", "", 1, "exp(pi) - pi - 20 + x"),
    ("cos(pi/7)*x + 9/10*y", "x > 0, y > 0", 1, "cos(pi/7)*x - 9/10*y"),
]


@pytest.mark.parametrize(("text", "under", "expected", "wrong"), PROVED)
def test_signs(text: str, under: str, expected: int, wrong: str) -> None:
    field, p = numerator(text, under)
    assert field.signs.product_sign(p) == expected
    assert field.signs.product_sign(-p) == -expected
    field, p = numerator(wrong, under)
    assert field.signs.product_sign(p) == 0


TAKEN_AS_POSITIVE = [("x^2", ""), ("x^2*y", "y > 0"), ("x^2 + y^2", ""), ("x^2 + sin(x)^2", "")]
ONLY_SOMEWHERE = [
    # a sign that holds on the open domain without the zeros, and the one that holds everywhere
    *(pytest.param(text, under, 1, 0) for text, under in TAKEN_AS_POSITIVE),
    ("(x - y)^2", "", 1, 0),
    ("x^2 + 2*x + 1", "", 1, 0),
    ("(x + y)^2 + (y - z)^2", "", 1, 0),
    ("x", "x >= 0", 1, 1),  # the box is taken as open: whoever asks looks at its walls himself
    ("x^2 + 1", "", 1, 1),
    ("x - y", "x > y", 1, 0),  # not by ranges alone
    ("x + y - z", "x > z, y > 0", 1, 0),
]


@pytest.mark.parametrize(("text", "under", "open_sign", "everywhere"), ONLY_SOMEWHERE)
def test_definite_is_more(text: str, under: str, open_sign: int, everywhere: int) -> None:
    field, p = numerator(text, under)
    assert field.signs.product_sign(p) == open_sign
    assert field.signs.definite(p) == everywhere
    assert field.signs.product_sign(p) == open_sign  # what was known before is known again


def prover_of(under: str) -> tuple[SignProver, Poly, Poly]:
    ring = Ring(4)
    x, y = (ring.variable(ring.symbol(name)) for name in "xy")
    return SignProver(ring, Given.parse(under)), x, y


BOXES = ["", "x > 0, y > 0", "0 < x < 2, y < -1/3", "-1 < x < 1", "x > -3/2, 1/7 < y < 1/5"]
rows = st.lists(st.integers(-4, 4), min_size=6, max_size=6)


@given(st.sampled_from(BOXES), rows)
def test_a_proved_sign_is_not_contradicted(under: str, row: list[int]) -> None:
    signs, x, y = prover_of(under)
    monomials = [x**0, x, y, x**2, x * y, y**2]
    p = sum((m * c for m, c in zip(monomials, row, strict=True)), signs.ring.zero_poly)
    found, everywhere, simple = signs.sign(p), signs.definite(p), signs.orthant_sign(p)
    for point in signs.given.points("xy", 12):
        value = signs.ring.ball(p, {name: arb(v) for name, v in point.items()})
        assert not value * found < 0
        assert not value * simple < 0
        assert everywhere == 0 or value * everywhere > 0


ENDS = cases(__file__, "ENDS")


@pytest.mark.parametrize(("text", "under", "kind"), ENDS)
def test_ends_enclose_the_values(text: str, under: str, kind: str) -> None:
    field, _ = numerator(f"({text})^2 + 10", under)
    (position,) = {g.position for g in field.ring.generators if g.kind == kind}
    low, high = field.signs.ends(position)
    p = field.ring.variables[position]
    for point in field.given.points("x", 25):
        value = field.ring.ball(p, {"x": arb(point["x"])})
        assert low is None or value > low
        assert high is None or value < high


def test_points_with_both_signs_end_the_search() -> None:
    calls: list[Any] = []

    def points() -> list[dict[str, fmpq]]:
        calls.append(0)
        return [{"x": fmpq(1), "y": fmpq(3)}, {"x": fmpq(3), "y": fmpq(1)}]

    ring = Ring(4)
    x, y = (ring.variable(ring.symbol(name)) for name in "xy")
    signs = SignProver(ring, Given(), points)
    assert signs.sign(x - y) == 0
    assert signs.sign(x**2 + x * y + y**2) == 1
    assert len(calls) == 1


def test_a_constant_too_small_for_the_balls_has_no_sign() -> None:
    field, p = numerator("exp(pi*sqrt(163)) - 640320^3 - 744", "")
    assert field.signs.sign(p) == -1
    field, p = numerator("exp(1/10^350) - 1", "")
    assert field.signs.sign(p) == 0
