"""Algebra in atoms: what is equal is so at every single point."""

import pytest
from cases import cases

from tresym.reals.language.parsing import parse
from tresym.reals.signs.atoms import Atoms

EQUAL = cases(__file__, "EQUAL")
UNLIKE = cases(__file__, "UNLIKE")


@pytest.mark.parametrize(("left", "right"), EQUAL)
def test_equal_fractions(left: str, right: str) -> None:
    atoms = Atoms()
    assert atoms.of(parse(left)).key == atoms.of(parse(right)).key


@pytest.mark.parametrize(("left", "right"), UNLIKE)
def test_nothing_is_known_of_atoms(left: str, right: str) -> None:
    atoms = Atoms()
    assert atoms.of(parse(left)).key != atoms.of(parse(right)).key


@pytest.mark.parametrize(
    ("text", "forms"),
    [
        ("1 - cos(x)**2", {"1 - cos(x)**2", "sin(x)**2"}),
        ("sin(x)**3 - cos(x)", {"sin(x)**3 - cos(x)", "sin(x)*(1 - cos(x)**2) - cos(x)"}),
        ("sqrt(x + 1)**3 - 1", {"(x + 1)*sqrt(x + 1) - 1"}),
        ("sqrt(x/y)**2 - x", {"x - x*y"}),
    ],
)
def test_squares_are_put_in(text: str, forms: set[str]) -> None:
    atoms = Atoms()
    p = atoms.of(parse(text)).num
    found = atoms.rewritten(p, lambda den: True)
    assert {str(q) for q in found} == {str(atoms.of(parse(form)).num) for form in forms}


def test_a_radicand_over_what_may_be_negative_stays() -> None:
    """(x/y)·y² may have another sign than sqrt(x/y)²."""
    atoms = Atoms()
    p = atoms.of(parse("sqrt(x/y)**2 - x")).num
    assert atoms.rewritten(p, lambda den: den.is_one()) == [p]
