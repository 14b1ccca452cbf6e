"""Proposals for factors: the known ones are right, and no wrong one is believed."""

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from flint import fmpz

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal import factors
from tresym.reals.normal.denesting import canonical
from tresym.reals.normal.factors import factor_polynomial, multiplies
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly


def numerator(text: str, under: str = "x > 0, y > 0") -> tuple[Field, Poly]:
    field = Field(Given.parse(under))
    (value,) = field.normal(parse(text))
    return field, value.num


@pytest.mark.parametrize(
    ("text", "changed"),
    [
        ("sqrt(x) - y", True),  # by its norm and conjugate
        ("x + sqrt(x)*y", True),  # sqrt(x) is a factor
        ("3 + 2*sqrt(2)", True),  # a square
        ("sqrt(x) + y", False),
        ("x + y", False),
    ],
)
def test_proposals(text: str, changed: bool) -> None:
    field, p = numerator(text)
    unit, parts = canonical(field.ring, p, partial(factor_polynomial, field.ring))
    assert (parts != [(p, 1)]) is changed
    assert multiplies(field.ring, p, unit, parts)


LIES: dict[str, Callable[[Any, Poly, Any], Any]] = {
    "another factor": lambda ring, f, _: (fmpz(1), [(f + 1, 1)]),
    "another sign": lambda ring, f, _: (fmpz(-1), [(f, 1)]),
    "another unit": lambda ring, f, _: (fmpz(2), [(f, 1)]),
    "a square": lambda ring, f, _: (fmpz(1), [(f, 2)]),
    "an inverse": lambda ring, f, _: (fmpz(1), [(f, -1)]),
    "none": lambda ring, f, _: (fmpz(1), []),
    "too many": lambda ring, f, _: (fmpz(1), [(f, 1), (ring.variables[-1], 1)]),
}


@pytest.mark.parametrize("lie", LIES)
@pytest.mark.parametrize("text", ["sqrt(x) - y", "x + y*sqrt(x)", "x - y"])
def test_a_wrong_proposal_is_not_believed(
    lie: str, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    field, p = numerator(text)
    monkeypatch.setattr(factors, "canonical", LIES[lie])
    field.ring.factored.clear()
    _, parts = factor_polynomial(field.ring, p)
    assert all(k > 0 for _, k in parts)
    product = field.ring.one_poly
    for part, k in parts:
        product = product * part**k
    assert product in (p, -p)


def test_no_quotient_by_what_may_vanish_on_a_region() -> None:
    """1 + s is 0 wherever the sign s is −1: f = f·(1 + s)/(1 + s) is no statement there."""
    field, p = numerator("x*(sign(x) + 1)", "")
    (position,) = (i for i in field.ring.used(p) if field.ring.at(i).kind == "sign")
    nowhere_safe = 1 + field.ring.variables[position]
    x = field.ring.variables[next(i for i in field.ring.used(p) if i != position)]
    assert not multiplies(field.ring, x, fmpz(1), [(x, 1), (nowhere_safe, 1), (nowhere_safe, -1)])
    assert multiplies(field.ring, x, fmpz(1), [(x, 1), (x + 1, 1), (x + 1, -1)])
