"""Coefficients of generating functions: claims of known truth, series and singularities."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
import sympy

from tresym.asymptotics.dominant_singularities import UnsupportedError, nearest_singularities
from tresym.asymptotics.exact_coefficients import taylor
from tresym.checking.dispatch import decide_claim
from tresym.reals.language.parsing import as_written, parse

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "coefficients.txt"
KINDS = {"HOLDS": ("PROVED", "ENCLOSED"), "FALSE": ("REFUTED",), "NONE": ("UNDECIDED",)}


def _rows() -> list[tuple[str, str]]:
    lines = (x.partition(" ") for x in DATA.read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in KINDS]


@pytest.mark.parametrize(("kind", "claim"), _rows()[::4])
def test_some_claims_about_coefficients(kind: str, claim: str) -> None:
    assert decide_claim(claim).verdict.value in KINDS[kind]


@pytest.mark.night
@pytest.mark.parametrize(("kind", "claim"), _rows())
def test_all_claims_about_coefficients(kind: str, claim: str) -> None:
    assert decide_claim(claim).verdict.value in KINDS[kind]


@pytest.mark.parametrize(
    "text",
    ["tan(z)", "(1 - sqrt(1 - 4*z))/(2*z)", "log(1/(1 - z))**2/(1 + z)", "z/(exp(z) - 1)"],
)
def test_power_series_agree_with_sympy(text: str) -> None:
    found = taylor(as_written(f"coefficient({text}, z, n)"), 7)
    z = sympy.Symbol("z")
    p = sympy.Poly(sympy.series(sympy.sympify(text), z, 0, 7).removeO(), z)
    expected = [p.coeff_monomial(z**k) for k in range(7)]
    assert found is not None
    assert [Fraction(int(x.p), int(x.q)) for x in found] == [
        Fraction(int(x.p), int(x.q)) for x in expected
    ]


@pytest.mark.parametrize(
    ("text", "points"),
    [
        ("((1/2 - sqrt(1 - z))/(1/2 + sqrt(1 - z)))**(-1)", ["3/4"]),  # its norm has no zero
        ("1/(1 + sqrt(1 - 4*z))", ["1/4"]),  # no pole at 0, which is one of the other branch
        ("sqrt((1 + z)/(1 - z))", ["-1", "1"]),
        ("sec(z)", ["-pi/2", "pi/2"]),
        ("1/(1 - z) + 1/(3 - exp(z))", ["1"]),
    ],
)
def test_the_nearest_singularities(text: str, points: list[str]) -> None:
    found = nearest_singularities(parse(text), "z")
    assert found is not None
    assert sorted(str(point) for point, _ in found.points) == points


@pytest.mark.parametrize("text", ["sqrt(z)", "exp(-1/z**2)", "1/(2 - exp(z) - log(1 - z))", "1/z"])
def test_what_has_no_power_series_or_unknown_zeros_is_refused(text: str) -> None:
    with pytest.raises(UnsupportedError):
        nearest_singularities(parse(text), "z")
