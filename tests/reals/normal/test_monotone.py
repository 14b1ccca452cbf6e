"""What stands for an inverse function has its sign at every point, or there is none."""

import pytest
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly
from tresym.reals.normal.sign_proofs import MAX_MULTIPLE
from tresym.reals.numbers.arithmetic import ball_precision

POSITIVE = "x > 0, y > 0"
SAME = [
    ("log(x)", POSITIVE),
    ("-log(x)", POSITIVE),
    ("log(x) - log(y + 1)", POSITIVE),
    ("2*log(x) - log(y + 1)", POSITIVE),
    ("3*log(x) - 6*log(y)", POSITIVE),
    ("log(x + 1) - log(x + y) - log(y)", POSITIVE),
    ("12*log(x) - log(y)", POSITIVE),
    ("log(-x)", "x < 0"),
    ("-log(2 - x)", "x < 2"),
    ("log(2 - x) - log(y)", "x < 2, y > 0"),
    ("atan(x)", ""),
    ("-atan(x - y)", ""),
    ("atan(x^2 - 2) + 0*y", ""),
    ("pi/2 - atan(x)", ""),
    ("pi/2 + atan(x - y)", ""),
    ("pi/2 - atan(x)/3", ""),
    ("atan(x) - pi/2", ""),
    ("pi - atan(x)", ""),
    ("sign(y)*atan(x)", ""),
    ("pi/2*sign(x - y) - atan(x)", ""),
]
OTHER = [
    ("pi/2 - 3/2*atan(x)", ""),  # from pi/2 − 3π/4 to pi/2 + 3π/4
    ("pi/2 - 2*atan(x - y)", ""),
    ("pi/4 + atan(x)", ""),
    ("pi/2*sign(x - y) - 3*atan(x)", ""),
    ("atan(x) + atan(y)", ""),
    ("atan(x) - x", ""),
    ("y*atan(x)", ""),
    ("atan(x)^2", ""),
    ("log(x) - 1", POSITIVE),
    ("log(x)*log(y)", POSITIVE),
    ("log(x)^2", POSITIVE),
    ("log(x) - pi", POSITIVE),
    ("log(x)*y", POSITIVE),
    (f"{MAX_MULTIPLE + 1}*log(x) - log(y)", POSITIVE),
    ("log((x - y)^2)", ""),  # log|x − y| with either sign inside
    ("log(x^2)", ""),
    ("log(x^2) + log(y^2)", "x > 0"),
]
VALUES = [fmpq(-7, 2), fmpq(-1), fmpq(-1, 3), fmpq(2, 5), fmpq(1), fmpq(9, 4), fmpq(50)]


def numerator(text: str, given: str) -> tuple[Field, Poly]:
    field = Field(Given.parse(given))
    (value,) = field.normal(parse(text))
    return field, value.num


def sign(x: arb) -> int | None:
    return 1 if x > 0 else -1 if x < 0 else None


@pytest.mark.parametrize(("text", "given"), SAME)
def test_same_sign(text: str, given: str) -> None:
    field, p = numerator(text, given)
    found = field.signs.same_sign(p)
    assert found is not None
    assert found.total_degree() <= 15
    seen = set()
    for x in VALUES:
        for y in VALUES:
            point = {"x": arb(x), "y": arb(y)}
            conditions = Given.parse(given).conditions
            if not all(condition.holds(point) for condition in conditions):
                continue
            with ball_precision(200):
                here, there = sign(field.ring.ball(p, point)), sign(field.ring.ball(found, point))
            assert here == there or None in (here, there)
            seen.add(here)
    assert seen & {1, -1}


@pytest.mark.parametrize(("text", "given"), OTHER)
def test_of_another_form(text: str, given: str) -> None:
    field, p = numerator(text, given)
    assert field.signs.same_sign(p) is None


@pytest.mark.parametrize(
    ("text", "given", "expected"),
    [
        ("pi/2 - atan(x)", "", 1),
        ("pi/2 - 3/2*atan(x)", "", 0),
        ("log(1 + x^2 + y^2)", "", 1),
        ("log(1/2 + x^2)", "", 0),
        ("log(x) - log(y)", "x > y, y > 0", 1),
        ("log(x) - log(2*y)", "x > y, y > 0", 0),
        ("atan(x) - pi/2", "", -1),
        ("atan(x) - pi/4", "", 0),
        ("atan(x - y)", "x > y", 1),
    ],
)
def test_the_sign_that_follows(text: str, given: str, expected: int) -> None:
    field, p = numerator(text, given)
    assert field.signs.sign(p) == expected
