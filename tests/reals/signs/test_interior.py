"""Signs inside the conditions: by the normal form, and by continuity at limits from there."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import (
    PROVING,
    by_signs_of_parts,
    jumps,
    sign_inside,
    without_powers,
)


@pytest.mark.parametrize(
    ("text", "conditions", "found"),
    cases(__file__, "the_normal_form_tells_of_almost_all_points"),
)
def test_the_normal_form_tells_of_almost_all_points(
    text: str, conditions: str, found: str | None
) -> None:
    """The last is −1 at x = 0, a point of the conditions that is no limit from inside."""
    assert sign_inside(parse(text), Given.parse(conditions)) == found


@pytest.mark.parametrize(
    ("text", "conditions", "jumping"),
    cases(__file__, "what_jumps"),
)
def test_what_jumps(text: str, conditions: str, jumping: bool) -> None:
    assert bool(jumps([parse(text)], Given.parse(conditions))) is jumping


def test_what_proves_a_relation() -> None:
    """By all values of each sign; ``!=`` is not proved by a weak one."""
    values = {"+": {1}, "-": {-1}, "0": {0}, ">=0": {0, 1}, "<=0": {0, -1}, "!=": {1, -1}}
    holds = {">": lambda v: v > 0, ">=": lambda v: v >= 0, "!=": lambda v: v != 0}
    for relation, found in PROVING.items():
        assert set(found) == {s for s, at in values.items() if all(map(holds[relation], at))}


@pytest.mark.parametrize(
    ("text", "conditions", "changes"),
    [
        ("x - 2*sqrt(x) + 1", "x > 0", True),
        ("x**2 - 2*sqrt(x) + x", "", True),
        ("x + sqrt(-x)", "x < 0", False),
        ("x + sqrt(1 + x)", "x > 0", False),
        ("x + sqrt(y)", "x > 0, y > 0", False),
    ],
)
def test_a_positive_symbol_is_a_power_of_its_own_root(
    text: str, conditions: str, changes: bool
) -> None:
    field = Field(Given.parse(conditions))
    (value,) = field.normal(parse(text))
    changed = without_powers(field, value.num)
    assert (changed != value.num) is changes
    with ball_precision(100):
        for x in (arb(fmpq(1, 3)), arb(5)):
            assert not changes or _at(field, changed, x).overlaps(_at(field, value.num, x))


def _at(field: Field, p: Poly, x: arb) -> arb:
    """The value where the one symbol is x and the one root its square root."""
    total = arb(0)
    for monomial, c in p.terms():
        term = arb(c)
        for i in field.ring.used(p):
            base = x if field.ring.at(i).kind == "symbol" else x.sqrt()
            term *= base ** int(monomial[i])
        total += term
    return total


def test_a_root_of_a_symbol_of_unknown_sign_is_left() -> None:
    assert sign_inside(parse("x + sqrt(abs(x))"), Given()) is None
    assert sign_inside(parse("x + sqrt(abs(x))"), Given.parse("x > 0")) == "+"


@pytest.mark.parametrize("text", ["(x + 1)**2 - x**2 - 2*x - 1", "-x**2", "x**2", "x"])
def test_what_may_be_zero_is_not_positive(text: str) -> None:
    assert by_signs_of_parts(parse(text), ">", Given()) is None
    weak = by_signs_of_parts(parse(text), ">=", Given())
    assert (weak is not None) is (text not in ("-x**2", "x"))
