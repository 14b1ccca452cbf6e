"""Special functions in LaTeX: what is read, and letters that keep another meaning."""

import pytest

import tresym
from tresym.reals.numbers.exact import InputError

READ = {
    r"\Gamma(x+1) = x\,\Gamma(x)": "gamma(x + 1) == x*gamma(x)",
    r"\Gamma(n+1) = n!": "gamma(n + 1) == factorial(n)",
    r"\zeta(2) = \frac{\pi^2}{6}": "zeta(2) == pi**2/6",
    r"\operatorname{erf}(x) \le 1": "erf(x) <= 1",
    r"\mathrm{erf}\,x \le 1": "erf(x) <= 1",
    r"\mathrm{Ei}(x) = 0": "Ei(x) == 0",
    r"J_0^2(x) \le 1": "besselj(0, x)**2 <= 1",
    r"\operatorname{Li}_2(1) = \frac{\pi^2}{6}": "polylog(2, 1) == pi**2/6",
    r"\Gamma\left(\tfrac12\right) = \sqrt\pi": "gamma(1/2) == sqrt(pi)",
    r"\Gamma > 0": "Gamma > 0",
    r"\zeta + 1 > \zeta": "zeta + 1 > zeta",
}


@pytest.mark.parametrize("text", READ)
def test_special_functions_in_latex(text: str) -> None:
    assert tresym.check(text).read_as == READ[text]


@pytest.mark.parametrize(
    "text",
    [
        r"K(k) = \frac{\pi}{2}",
        r"\zeta(x+1) = \zeta x + 1",
        "EllipticK(1/2) > 0",
        "γ(1 + x) > 0",
        "gamma(1 + x) > gamma",
    ],
)
def test_two_meanings_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="two readings"):
        tresym.check(text)


def test_unicode() -> None:
    assert tresym.check("Γ(x+1) == x*Γ(x)").read_as == "gamma(x + 1) == x*gamma(x)"
    assert tresym.check("ζ(2) == π²/6").read_as == "zeta(2) == pi**2/6"
    assert tresym.check("J₀(x) ≤ 1").read_as == "besselj(0, x) <= 1"
