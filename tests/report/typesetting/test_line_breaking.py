"""Long formulas: nothing is lost when they are broken, and no line is much too wide."""

import re
from functools import cache

import pytest

from tresym.ledger.paper import all_claims
from tresym.report.typesetting.chains import displays
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.line_breaking import broken


@cache
def formulas() -> list[str]:
    """What is displayed of the ledger."""
    return sorted(
        {part for c in all_claims() for d in displays(c) for line in d for part in line[:2] if part}
    )


def letters(formula: str) -> str:
    """A formula without its spaces, its brackets' sizes, and the crosses of broken products."""
    bare = re.sub(r"\\left|\\right|\\Bigl|\\Bigr|\\Big/?|\\times|\\frac|[{}()\s/]", "", formula)
    return "".join(sorted(bare))


@pytest.mark.parametrize("limit", [66, 40])
@pytest.mark.slow
def test_nothing_is_lost(limit: int) -> None:
    for formula in formulas():
        lines = broken(formula, limit)
        added = formula.count(r"\frac") and any(r"\frac{1}{" in line for line in lines)
        assert added or letters("".join(lines)) == letters(formula), formula


def test_lines_are_whole() -> None:
    for formula in formulas():
        for line in broken(formula, 66):
            assert line.count("{") == line.count("}"), formula
            assert line.count(r"\left") == line.count(r"\right"), formula


def test_no_line_is_much_too_wide() -> None:
    wide = [f for f in formulas() if width(f) > 66 and r"\begin" not in f]
    assert len(wide) > 40
    for formula in wide:
        assert max(map(width, broken(formula, 66))) < 84, formula


A, B, C = "a" * 10, "b" * 10, "c" * 10


@pytest.mark.parametrize(
    ("formula", "lines"),
    [
        (f"{A}+{B}", [f"{A}+{B}"]),
        (f"{A}+{B}-{C}", [f"{A}+{B}", f"-{C}"]),
        (f"{A}{A} = {B}{B}", [f"{A}{A}", f"={B}{B}"]),
        (rf"\sin({A}+{B}+{C})", [rf"\sin\Bigl({A}", rf"+{B}+{C}\Bigr)"]),
        (rf"\frac{{{A}{A}+{B}{B}}}{{c}}", [rf"\frac{{1}}{{c}}\Bigl({A}{A}", rf"+{B}{B}\Bigr)"]),
    ],
)
def test_where_a_line_ends(formula: str, lines: list[str]) -> None:
    assert broken(formula, 30) == lines
