"""The LaTeX reader: what it reads, what it refuses, and that it reads what SymPy writes."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from sympy import I, latex, nan, zoo

from tresym.arithmetic import ball_precision
from tresym.exact import InputError
from tresym.identity import Expr, Given, evaluate, parse, symbols, to_sympy
from tresym.identity.expression import apply, number, power, sqrt, symbol
from tresym.identity.latex import read_expression, read_latex

EXPRESSIONS = {
    r"a+b": "a + b",
    r"-a+b": "-a + b",
    r"a-(b-c)": "a - (b - c)",
    r"-2\pi b": "-2*pi*b",
    r"ab": "a*b",
    r"a\cdot b\times c": "a*b*c",
    r"2^{10}": "2**10",
    r"x^2y": "x**2*y",
    r"-x^2": "-x**2",
    r"x^{-2}": "x**(-2)",
    r"b^{3/2}": "b**(3/2)",
    r"\frac12": "1/2",
    r"\frac ab": "a/b",
    r"\frac{a+1}{b-1}": "(a + 1)/(b - 1)",
    r"\frac{1}{2}\left(1+\frac{b}{a}\right)": "1/2*(1 + b/a)",
    r"\sqrt{a+b\sin^2\psi}": "sqrt(a + b*sin(psi)**2)",
    r"\sqrt[3]{x}": "x**(1/3)",
    r"\sin\theta(a+b)": "sin(theta)*(a + b)",
    r"\sin\psi\cos\psi": "sin(psi)*cos(psi)",
    r"\sin 2x": "sin(2*x)",
    r"\sin(2x)": "sin(2*x)",
    r"\cos\frac{x}{2}": "cos(x/2)",
    r"\arcsin [\sqrt{\frac{|\gamma|}{b}}]": "asin(sqrt(abs(gamma)/b))",
    r"\operatorname{artanh}(x)": "atanh(x)",
    r"\textrm{arctanh}(x)": "atanh(x)",
    r"\ln[(1+u)/(1-u)]": "log((1 + u)/(1 - u))",
    r"e^{-\sqrt{ab}\pi}": "exp(-sqrt(a*b)*pi)",
    r"e x": "E*x",
    r"\left|x-1\right|+|y|": "abs(x - 1) + abs(y)",
    r"\psi_0+\epsilon_{0}+M_{1f}": "psi0 + epsilon0 + M1f",
    r"\theta_{\min}-\psi_f": "theta_min - psi_f",
    r"\Delta\psi": "Delta_psi",
    r"\lambda E": "lambda_*E_",
    r"\dot{\theta}+\dot\phi": "dtheta_dt + dphi_dt",
    r"\frac{d\psi}{d\phi}+d\psi/d\phi": "dpsi_dphi + dpsi_dphi",
    r"\frac{\partial F}{\partial\gamma}": "partialF_partialgamma",
    r"\frac{d}{dx}\sin(x)": "diff(sin(x), x)",
    r"\frac{d^2}{dx^2}\sin(x)+1": "diff(sin(x), x, 2) + 1",
    r"\frac{\partial^{3}}{\partial\psi^{3}}\psi^4": "diff(psi**4, psi, 3)",
    r"1.09\times 10^{-2}": "1.09e-2",
    r"0.1150\textrm{ rad}": "0.1150",
    r"f(a,b)+\epsilon(\gamma)+f(2x)": "f(a, b) + epsilon(gamma) + f(2*x)",
    r"\left.\frac{d\epsilon}{d\gamma}\right|_{\gamma=0}": "at(depsilon_dgamma, gamma, 0)",
    r"\Delta\psi|_{\Delta\phi=2\pi}": "at(Delta_psi, Delta_phi, 2*pi)",
    r"\left[\frac{x^2}{2}\right]_{0}^{b}": "between(x**2/2, 0, b)",
    r"\int_0^{\pi}\sin x\,dx": "integral(sin(x), x, 0, pi)",
    r"2\int_a^b f(x)\mathrm{d}x+c": "2*integral(f(x), x, a, b) + c",
    r"\int_0^1\frac{dx}{1-x^2}-b\frac{dx}{x}-c": "integral(1/(1 - x**2) - b*(1/x), x, 0, 1) - c",
    r"O(\gamma^2)+o\left(\frac1x\right)": "O(gamma**2) + o(1/x)",
    r"x % a comment": "x",
    r"\frac{du}{d\lambda}(0,0,0)": "value(du_dlambda, 0, 0, 0)",
}

REFUSED = {
    r"3\,000": "two numbers side by side",
    r"\sin\pi/6": "where does the function's argument end",
    r"\cos 2\theta/3": "where does the function's argument end",
    r"\frac{d^2}{dx^3}x": "a derivative of higher order is written",
    r"\frac{d^2y}{dx^2}": "a derivative of higher order is written",
    r"\sin x y": "where does the function's argument end",
    r"\cos\omega t": "where does the function's argument end",
    r"\sin^{-1}x": "can mean its inverse",
    r"1/2x": "what is below the slash",
    r"x^12": "several digits needs braces",
    r"\foo{x}": "this is not read",
    r"\vec{M}": "this is not read",
    r"\int f dx": "needs its limits",
    r"\int_0^1 f": "differential",
    r"(a+b": "ends where more is expected",
    r"(a+b]": "is not closed",
    r"|a+b": "ends where more is expected",
    r"a+": "ends where more is expected",
    r"a = b": "an operation or the end is expected",
    r"\frac{}{b}": "empty numerator",
    r"x_{a+b}": "the subscript",
    "{" * 100 + "x" + "}" * 100: "nested deeper",
    "x" * 10_001: "beyond the limit",
    "": "ends where more is expected",
}

DISPLAYS = {
    r"M_1=I_1\Omega_1,\quad M_2=I_2\Omega_2. \label{eq}": [
        "M1 = I1*Omega1",
        "M2 = I2*Omega2",
    ],
    r"a:=b\equiv c": ["a = b = c"],
    r"0\leq b\leq 1,\; -b\le\gamma<a": ["0 <= b <= 1", "-b <= gamma < a"],
    r"x\in[\pi-1,\pi+1)": ["pi - 1 <= x < pi + 1"],
    r"a=b\Rightarrow c=-d": ["a = b", "c = -d"],
    r"x\to+\infty": ["x -> inf"],
    r"\theta_0\simeq\frac{\pi}{2}, a\gg 1": ["theta0 ~ pi/2", "a >> 1"],
    r"\begin{array}{ll} & \dot{q}=p, \\[2pt] & \dot{p}=-q. \end{array}": [
        "dq_dt = p",
        "dp_dt = -q",
    ],
    r"\begin{aligned} x &= y \\ &= z \end{aligned}": ["x = y = z"],
    r"\epsilon_0^2+hot=1": ["epsilon0**2 + hot = 1"],
}


@pytest.mark.parametrize("source", EXPRESSIONS)
def test_expressions(source: str) -> None:
    assert read_expression(source, author=True) == EXPRESSIONS[source]


@pytest.mark.parametrize("source", REFUSED)
def test_what_is_not_read_is_refused_in_one_line(source: str) -> None:
    with pytest.raises(InputError) as caught:
        read_expression(source)
    assert REFUSED[source] in str(caught.value)
    assert str(caught.value).startswith("LaTeX: ")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("source", DISPLAYS)
def test_displays(source: str) -> None:
    assert [str(chain) for chain in read_latex(source)] == DISPLAYS[source]


def test_headings_of_columns_become_conditions() -> None:
    source = r"""\begin{array}{ll}
        \textrm{For }c>0: & \quad \textrm{For }c<0: \\
        x=\sqrt{c} & y=\sqrt{-c} \\ z=c & z=-c \end{array}"""
    chains = read_latex(source)
    assert [(str(c), str(c.condition)) for c in chains] == [
        ("x = sqrt(c)", "c > 0"),
        ("y = sqrt(-c)", "c < 0"),
        ("z = c", "c > 0"),
        ("z = -c", "c < 0"),
    ]


@pytest.mark.parametrize(
    "source",
    [r"a+b", r"\begin{matrix} a \end{matrix}", r"a=b \begin{array} c \end{array}", r"a=", r"=b"],
)
def test_displays_that_are_no_statement(source: str) -> None:
    with pytest.raises(InputError, match="LaTeX: "):
        read_latex(source)


SYMBOLS = st.sampled_from(["a", "b", "psi", "theta", "x0", "epsilon", "M1"]).map(symbol)
NUMBERS = st.fractions(min_value=-9, max_value=9, max_denominator=7).map(number)
NAMES = ["sin", "cos", "tan", "exp", "log", "asin", "atan", "sinh", "cosh", "tanh", "abs", "asinh"]


def _larger(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] - p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        st.tuples(inner, SYMBOLS).map(lambda p: p[0] / p[1]),
        st.tuples(inner, st.integers(2, 5)).map(lambda p: power(p[0], number(p[1]))),
        inner.map(sqrt),
        st.tuples(st.sampled_from(NAMES), SYMBOLS | inner).map(lambda p: _apply(*p)),
    )


def _apply(name: str, argument: Expr) -> Expr:
    return argument if argument.op == "number" else apply(name, argument)


EXPRESSION_TREES = st.recursive(SYMBOLS | NUMBERS, _larger, max_leaves=12)


@given(EXPRESSION_TREES)
def test_what_sympy_writes_is_read_back(tree: Expr) -> None:
    written = to_sympy(tree)
    if written.is_real is False or written.has(zoo, nan, I):
        return
    read = parse(read_expression(latex(written, ln_notation=True)))
    for point in Given().points(symbols(tree) | symbols(read), 6):
        with ball_precision(256):
            at = {name: arb(value) for name, value in point.items()}
            first, second = evaluate(tree, at), evaluate(read, at)
        if first.is_finite() and second.is_finite():
            assert (first - second).contains(0)


TOKENS = (
    r"a b x 2 + - = / ^ _ ( ) [ ] { } | , . & \\ d e : f O \frac \sqrt \int \sin \psi \dot \in "
    r"\left( \right) \left. \right| \begin{array} \end{array} \partial \Delta \text{for}"
)
PIECES = st.sampled_from(TOKENS.split())


@given(st.lists(PIECES, max_size=20).map(" ".join))
def test_any_tokens_are_read_or_refused(source: str) -> None:
    for read in (read_expression, read_latex):
        try:
            read(source)
        except InputError:
            continue


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(source: str) -> None:
    for read in (read_expression, read_latex):
        try:
            read(source)
        except InputError:
            continue
