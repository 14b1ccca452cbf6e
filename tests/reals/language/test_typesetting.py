"""Claims in LaTeX and MathML, as notebooks and pages show them."""

import pytest
from cases import cases

from tresym.reals.language.parsing import parse_claim
from tresym.reals.language.readings import in_latex
from tresym.reals.language.typesetting import to_latex, to_mathml


@pytest.mark.parametrize(
    ("claim", "latex"),
    cases(__file__, "how_a_claim_is_set"),
)
def test_how_a_claim_is_set(claim: str, latex: str) -> None:
    assert to_latex(parse_claim(claim)) == latex


@pytest.mark.parametrize(
    ("claim", "latex"),
    [
        ("x == x given x > 0, y <= 1", r"x = x \quad (x > 0,\ y \le 1)"),
        ("sin(n*pi) == 0 given n integer", r"\sin(n \, \pi) = 0 \quad (n \in \mathbb{Z})"),
        ("log(x) == o(x) as x -> oo", r"\ln(x) = o(x) \quad (x \to \infty)"),
        ("exp(x) == 1 + o(1) as x -> 0-", r"e^{x} = 1 + o(1) \quad (x \to 0^-)"),
        ("no claim", ""),
    ],
)
def test_conditions_and_paths_stand_behind(claim: str, latex: str) -> None:
    assert in_latex(claim) == latex


@pytest.mark.parametrize(
    ("claim", "mathml"),
    cases(__file__, "a_claim_in_mathml"),
)
def test_a_claim_in_mathml(claim: str, mathml: str) -> None:
    assert to_mathml(parse_claim(claim), block=False) == f"<math>{mathml}</math>"
