"""Formulas are found in the sentences of verdicts, and words are left as words."""

import pytest

from tresym.report.typesetting.formulas_in_words import parts, region_latex


@pytest.mark.parametrize(
    ("text", "formulas"),
    [
        ("it behaves like -1/6/eps near 0", [r"-\frac{1}{6 \, \epsilon}"]),
        ("with n! = gamma(n + 1): on 119 boxes", [r"n! = \Gamma(n + 1)"]),
        ("the two sides differ at x = 1/2, y = -3", [r"x = \frac{1}{2}", "y = -3"]),
        ("not at n (with S = 1/n + 2).", [r"S = \frac{1}{n} + 2"]),
        ("unbounded as k -> oo", [r"k \to \infty"]),
        ("the right-hand side, a non-negative number", []),
        ("(Olver 1974, ch. 3, §3) and the ratio left/right", []),
        ("the difference has normal form 0 (2 generators)", []),
    ],
)
def test_formulas_in_a_sentence(text: str, formulas: list[str]) -> None:
    assert [part for part, is_formula in parts(text) if is_formula] == formulas


def test_nothing_of_a_sentence_is_lost() -> None:
    text = "by a lemma: x/2 <= 1 given x > 0: PROVED; and so on"
    words = "".join("…" if is_formula else part for part, is_formula in parts(text))
    assert words == "by a lemma: …: PROVED; and so on"


def test_a_region_is_typeset_once() -> None:
    assert region_latex("0 < |x| <= 1") == r"0 < \left|x\right| \le 1"
    assert region_latex("n >= 0, n >= 0, 2*n >= 0") == r"n \ge 0,\ 2 \, n \ge 0"
    assert region_latex("where both sides are defined: x != 0") == ""
