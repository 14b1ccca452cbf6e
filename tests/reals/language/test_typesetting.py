"""Claims in LaTeX and MathML, as notebooks and pages show them."""

import pytest

from tresym.reals.decisions.claim_parsing import in_latex
from tresym.reals.language.parsing import parse_claim
from tresym.reals.language.typesetting import to_latex, to_mathml


@pytest.mark.parametrize(
    ("claim", "latex"),
    [
        ("sqrt(x**2) == x", r"\sqrt{x^{2}} = x"),
        ("sin(x) == x - x**3/6 + O(x**5)", r"\sin(x) = x - \frac{x^{3}}{6} + O(x^{5})"),
        ("limit((1 + x)**(1/x), x, 0, 1) == E", r"\lim_{x \to 0^+} (x + 1)^{\frac{1}{x}} = e"),
        ("integral(exp(-x), x, 0, oo) == 1", r"\int_{0}^{\infty} e^{-x} \, dx = 1"),
        ("sum(k, k, 1, n) == n*(n + 1)/2", r"\sum_{k=1}^{n} k = \frac{n \, (n + 1)}{2}"),
        ("diff(f(x), x, 2) == -f(x)", r"\frac{d^{2}}{dx^{2}} f(x) = -f(x)"),
        ("at(diff(f(u), u), u, 2*x) == 1", r"\left.\frac{d}{du} f(u)\right|_{u=2 \, x} = 1"),
        ("integral(x, x) == x**2/2", r"\int x \, dx = \frac{x^{2}}{2}"),
        ("sin(x)**2/(x + y)**2 != -2/3", r"\frac{\sin^{2}(x)}{(x + y)^{2}} \ne -\frac{2}{3}"),
        (
            "2*3**x*(1/2)**y > epsilon0",
            r"2 \cdot 3^{x} \, \left(\frac{1}{2}\right)^{y} > \epsilon_{0}",
        ),
        ("0 < abs(cbrt(x)) < 1", r"0 < \left|\sqrt[3]{x}\right| < 1"),
    ],
)
def test_how_a_claim_is_set(claim: str, latex: str) -> None:
    assert to_latex(parse_claim(claim)) == latex


@pytest.mark.parametrize(
    ("claim", "latex"),
    [
        ("x == x given x > 0, y <= 1", r"x = x \quad (x > 0,\ y \le 1)"),
        ("sin(n*pi) == 0 given n integer", r"\sin(n \, \pi) = 0 \quad (n \in \mathbb{Z})"),
        ("log(x) == o(x) as x -> oo", r"\ln(x) = o(x) \quad (x \to \infty)"),
        ("exp(x) == 1 + o(1) as x -> 0-", r"e^{x} = o(1) + 1 \quad (x \to 0^-)"),
        ("no claim", ""),
    ],
)
def test_conditions_and_paths_stand_behind(claim: str, latex: str) -> None:
    assert in_latex(claim) == latex


@pytest.mark.parametrize(
    ("claim", "mathml"),
    [
        ("1 - x < pi", "<mn>1</mn><mo>−</mo><mi>x</mi><mo>&lt;</mo><mi>π</mi>"),
        ("x0 == 2", "<msub><mi>x</mi><mi>0</mi></msub><mo>=</mo><mn>2</mn>"),
        (
            "dx_dt == y_prime",
            "<mfrac><mrow><mi>d</mi><mi>x</mi></mrow><mrow><mi>d</mi><mi>t</mi></mrow></mfrac>"
            "<mo>=</mo><mi>y</mi><mo>′</mo>",
        ),
        (
            "exp(x)**y == sqrt(2)",
            "<msup><mrow><mrow><mo>(</mo><msup><mrow><mi>e</mi></mrow><mrow><mi>x</mi></mrow></msup>"
            "<mo>)</mo></mrow></mrow><mrow><mi>y</mi></mrow></msup>"
            "<mo>=</mo><msqrt><mrow><mn>2</mn></mrow></msqrt>",
        ),
    ],
)
def test_a_claim_in_mathml(claim: str, mathml: str) -> None:
    assert to_mathml(parse_claim(claim), block=False) == f"<math>{mathml}</math>"
