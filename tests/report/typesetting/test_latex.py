"""LaTeX as a mathematician writes it: golden forms of hard expressions."""

import pytest
import sympy
from sympy import Derivative, Integral, Subs, exp, pi, sqrt

from tresym.ledger.audit.transcription import _conditions
from tresym.ledger.audit.tree_comparison import of_claim, of_display, same
from tresym.ledger.formulas import in_trees, sides_of
from tresym.ledger.paper import all_claims
from tresym.racket.formulas import printed
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import at, ordered
from tresym.reals.language.compound import read_compound
from tresym.reals.language.expression import Expr, replaced, symbol, symbols
from tresym.reals.language.latex import read_expression
from tresym.reals.language.latex_author import Author
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError
from tresym.report.typesetting.conditions import gathered
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.latex import expression_latex, says_latex

NAMES = "I1 I2 I3 M1 M2 M3 E M S T a b epsilon gamma psi r theta x"
I1, I2, I3, M1, M2, M3, E, M, S, T, a, b, epsilon, gamma, psi, r, theta, x_ = sympy.symbols(
    NAMES, real=True
)

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


@pytest.mark.parametrize(
    ("claim", "shown"),
    [
        (
            "exactly one psi in [0, 1): sin(psi)**2 == b",
            r"\exists!\, \psi \in [0, 1):\ \sin^2\psi = b",
        ),
        ("convex(exp(gamma), gamma)", r"e^{\gamma} \text{ is convex in } \gamma"),
        ("increasing(gamma, gamma)", r"\gamma \text{ increases strictly in } \gamma"),
        ("infimum(b*cos(psi), psi) == -b", r"\inf_{\psi} \left( b\cos\psi \right) = -b"),
        ("at some point: epsilon0 == 1", r"\text{at some point } \epsilon_0 = 1"),
    ],
)
def test_statements_of_everyone_in_the_letters_of_the_paper(claim: str, shown: str) -> None:
    whole = read_compound(claim)
    assert whole is not None
    assert says_latex(whole.formula) == shown


@pytest.mark.parametrize(
    ("at_itself", "shown"),
    [
        (at(parse("x**2"), {"x": parse("x + 1")}), r"\left.x^2\right|_{x=1+x}"),
        (at(parse("y"), {"x": parse("1")}), r"\left.y\right|_{x=1}"),
        (parse("-(a - b)"), "-(a-b)"),
    ],
)
def test_values_and_signs(at_itself: Expr, shown: str) -> None:
    assert expression_latex(at_itself) == shown


@pytest.mark.parametrize(
    ("exponent", "shown"),
    [
        (-b / sqrt(1 + a), r"e^{-b/\sqrt{1+a}}"),
        (-(pi + T) / r, r"e^{-(\pi+T)/r}"),
        (-pi * sqrt(a * b), r"e^{-\pi\sqrt{a b}}"),
        (a / (2 * b), "e^{a/(2b)}"),
        (-(a + b), "e^{-(a+b)}"),
        (a + b, "e^{a+b}"),
        (-1 / a, "e^{-1/a}"),
        (a, "e^a"),
    ],
)
def test_fractions_in_exponents_have_a_stroke(exponent: sympy.Expr, shown: str) -> None:
    assert expression_latex(exp(exponent, evaluate=False)) == shown


def test_rates_orders_and_functions() -> None:
    rate = sympy.Symbol("dG_dlambda", real=True)
    assert expression_latex(rate**2) == r"\left(\frac{dG}{d\lambda}\right)^2"
    partial = sympy.Symbol("partialF_partialepsilon0", real=True)
    assert expression_latex(partial) == r"\frac{\partial F}{\partial \epsilon_0}"
    assert expression_latex(sympy.Function("o")(gamma)) == r"o(\gamma)"
    half = -sqrt(a / b) * Integral(1 - x_, (x_, a, b)) / 2
    assert expression_latex(half) == r"-\frac{1}{2}\sqrt{\frac{a}{b}}\int_a^b (1-x)\,dx"


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ((I1 > 0, I2 > 0, I3 > 0, I2 - I1 > 0, I3 - I2 > 0), ["0 < I_1 < I_2 < I_3"]),
        ((a > 0, b > 0, b <= 1), ["a > 0", r"0 < b \le 1"]),
        ((a > 0, gamma > 0, gamma < a), [r"0 < \gamma < a"]),
        ((gamma < 0, gamma > -b, b > 0), [r"-b < \gamma < 0", "b > 0"]),
        ((psi >= 0, psi >= 0), [r"\psi \ge 0"]),
        ((a * b <= 1, sympy.true), [r"a b \le 1"]),
        ((I1 > 0, I2 - I1 >= 0), [r"0 < I_1 \le I_2"]),
        ((a >= 0, b - a >= 0, b > 0), [r"0 \le a \le b", "b > 0"]),
    ],
)
def test_conditions_are_gathered(given: tuple[sympy.Basic, ...], shown: list[str]) -> None:
    assert sorted(gathered(given)) == sorted(shown)


def uses_e(e: Expr) -> bool:
    """Whether a variable is called e, which the reader may take for Euler's number."""
    inner = (arg for arg in e.args if isinstance(arg, Expr))
    return e == symbol("e") or "e" in e.names or any(map(uses_e, inner))


def read_back(e: Expr) -> Expr | None:
    """The expression that the reader of manuscripts finds in the print; None if it reads none."""
    own = {r"\epsilon_*": r"\epsilon_{11}", r"\mathrm{hot}": "H_{12}"}

    def read(text: str) -> Expr:
        for ours, theirs in own.items():
            text = text.replace(ours, theirs)
        return of_display(read_expression(text, Author()), {})

    try:
        names = {read(expression_latex(symbol(n))): symbol(n) for n in symbols(e)}
        return replaced(read(expression_latex(e)), names)
    except InputError:  # two values at once, |_{x=0, y=0}, and sums before a bar are not read
        return None


@pytest.mark.night
def test_what_is_printed_is_read_back() -> None:
    read, unread = 0, 0
    for claim in all_claims():
        stated = (claim.statement, *claim.given, *claim.knowing)
        for e in {e for s in stated if s is not None for e in sides_of(in_trees(s))}:
            if "oo" in symbols(e) or "root(" in str(e) or uses_e(e):
                continue
            found = read_back(e)
            unread += found is None
            if found is not None:
                read += 1
                same_tree = ordered(found) == ordered(of_claim(e))
                assert same_tree or same(found, of_claim(e), _conditions(claim)), claim.label
    assert unread < read / 10


def test_a_slip_in_print_would_be_seen() -> None:
    e = in_trees(a - (a + b * sympy.sin(psi) ** 2) * sympy.sin(theta) ** 2)
    assert read_back(e) is not None
    assert same(read_back(e), e, Given())  # type: ignore[arg-type]
    assert not same(read_back(e), in_trees(a + b * sympy.sin(psi) ** 2), Given())  # type: ignore


def test_widths_are_about_right() -> None:
    assert width(r"\frac{a+b}{c}") == width("a+b")
    assert width(r"\left(\sin\theta\right)") > width("(x)")
    assert width(r"\begin{pmatrix}a & b\\c & d\end{pmatrix}") < width("a+b+c+d+e")
    assert width("x^{2}_1") < 3
    assert width("") == 0
