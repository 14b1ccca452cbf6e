"""Formulas at the terminal: letters and signs, and brackets wherever a bar took their place."""

import re

import pytest

from tresym.ledger.paper import all_claims
from tresym.report.typesetting.latex import says_latex
from tresym.report.typesetting.plain_text import in_lines, plain


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        (r"\gamma = \frac{2I_2E}{M^2}-1", "γ = 2I₂E/M²−1"),
        (r"\frac{1}{4b\epsilon_0}", "1/(4bε₀)"),
        (r"\frac{a+b}{2}", "(a+b)/2"),
        (r"\dot M_1 = M_2M_3", "\u1e40₁ = M₂M₃"),
        (r"e^{-\pi\sqrt{a b}}", "e^(−π√(a b))"),
        (r"\sqrt{a}", "√a"),
        (r"x_{-1}-\text{third-order}", "x₋₁−third-order"),
        (r"\left.\frac{d}{db}(x)\right|_{b=0}", "d/db(x)|_(b = 0)"),
        (r"\sin^2\theta", "sin²θ"),
        (r"0 < b \le 1", "0 < b ≤ 1"),
        (r"O(1)\quad(\left( u, \  \mu\right) \to \left( 0, \  0\right))", "O(1) ((u, μ) → (0, 0))"),
        (r"\Bigl(\varphi(W)^n W'\Bigr )", "(φ(W)ⁿ W')"),
        (r"\begin{pmatrix}a\\b\end{pmatrix}", "(a; b)"),
    ],
)
def test_formulas(formula: str, shown: str) -> None:
    assert plain(formula) == shown


@pytest.mark.slow
def test_no_command_is_left_in_any_statement() -> None:
    for claim in all_claims():
        for says in (claim.shown, claim.statement, *claim.given):
            if says is not None:
                text = plain(says if isinstance(says, str) else says_latex(says))
                assert not re.search(r"\\|[{}&]", text), (claim.label, text)


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("a word and one", ["a word and", "one"]),
        ("x = −34.5 ± 0.05", ["x =", "−34.5 ± 0.05"]),
        ("a+b−c+de+fgh+i", ["a+b−c+de", "+fgh+i"]),
        ("e^(−π√ab)+x", ["e^(−π√ab)", "+x"]),
        ("12345678901234", ["12345678901234"]),
    ],
)
def test_lines_break_where_nothing_is_torn(text: str, lines: list[str]) -> None:
    assert list(in_lines(text, "", "", 10)) == lines
