"""LaTeX as a mathematician writes it: golden forms of hard expressions."""

import pytest
import sympy
from sympy import Derivative, Integral, Rational, Subs, exp, pi, sqrt

from tresym.formulas import printed
from tresym.notation import I1, I2, I3, M1, M2, M3, E, M, S, T, a, b, epsilon, gamma, psi, r, theta
from tresym.notation import x as x_
from tresym.report.latex import expression_latex, says_latex

GOLDEN = {
    r"a-\sin^2\theta(a+b\sin^2\psi)": printed.depth(theta, psi, a, b, sympy),
    r"-\frac{b\sin\theta\sin\psi\cos\psi}{1-b\sin^2\psi}": printed.planar_rates(
        theta, psi, a, b, sympy
    )[0],
    r"\frac{(a+b\sin^2\psi)\cos\theta}{1-b\sin^2\psi}": printed.planar_rates(
        theta, psi, a, b, sympy
    )[1],
    r"S\sqrt{\frac{\gamma+b\sin^2\psi}{a+b\sin^2\psi}}": printed.cos_theta(
        psi, a, b, gamma, S, sympy
    ),
    r"\frac{S\sqrt{a+b\sin^2\psi}\sqrt{\gamma+b\sin^2\psi}}{1-b\sin^2\psi}": printed.psi_rate(
        psi, a, b, gamma, S, sympy
    ),
    r"\frac{2I_2E}{M^2}-1": printed.depth_from_energy(E, M, I2),
    r"\frac{1}{2}\left(\frac{M_1^2}{I_1}+\frac{M_2^2}{I_2}\right)": sympy.Mul(
        Rational(1, 2), M1**2 / I1 + M2**2 / I2, evaluate=False
    ),
    r"M_2M_3\left(\frac{1}{I_3}-\frac{1}{I_2}\right)": M2 * M3 * (1 / I3 - 1 / I2),
    r"\left.\frac{d}{d\gamma}(\gamma+a)\right|_{\gamma=0}": Subs(
        Derivative(a + gamma, gamma), gamma, 0
    ),
    r"\int_0^1 (1-x)\,dx": Integral(1 - x_, (x_, 0, 1)),
    r"(1+r^2)\sinh^2 T": (1 + r**2) * sympy.sinh(T) ** 2,
    r"e^{-2\pi\sqrt{a b}}": exp(-2 * pi * sqrt(a * b)),
    r"-\frac{1}{4b\epsilon}": -1 / (4 * b * epsilon),
    r"b^{3/2}": sqrt(b) ** 3,
    r"|\sin\psi|": abs(sympy.sin(psi)),
}


@pytest.mark.parametrize("text", GOLDEN)
def test_golden(text: str) -> None:
    assert expression_latex(GOLDEN[text]) == text


def test_statements() -> None:
    assert says_latex(b <= 1) == r"b \le 1"
    assert says_latex("In words.") == "In words."
    assert says_latex(sympy.Tuple(a > 0, b > 0)) == r"a > 0,\quad b > 0"
