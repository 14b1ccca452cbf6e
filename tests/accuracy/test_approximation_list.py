"""Printed bounds of published approximations: held, rounded, exceeded."""

from pathlib import Path

import pytest

import tresym
from tresym.accuracy.approximation_list import judge, read_list, table
from tresym.commands import main

LIST = Path(__file__).parent.parent.parent / "docs" / "examples" / "approximations.txt"
BLOCK = """
source: A
exact: erf(x)
t = 1/(1 + p*x)
p = 0.47047
approx: 1 - (0.3480242*t - 0.0958798*t**2 + 0.7478556*t**3)*exp(-x**2)
on: x >= 0
bound: {}
"""


@pytest.mark.parametrize(
    ("bound", "verdict"),
    [
        ("2.5e-5", "holds"),  # the largest error is 2.1804e-5
        ("2.2e-5", "holds"),
        ("2.1806e-5", "holds"),
        ("2e-5", "rounds to it"),
        ("2.18e-5", "rounds to it"),
        ("2.1e-5", "exceeded"),  # it would round to 2.2e-5
        ("1e-5", "exceeded"),
        ("none", ""),
        ("2**-15", "holds"),
        ("2**-16", "exceeded"),
        ("1e-4 relative", "exceeded"),  # the formula is no zero at 0
    ],
)
def test_a_printed_bound(bound: str, verdict: str) -> None:
    (one,) = read_list(BLOCK.format(bound))
    assert judge(one).verdict == verdict


@pytest.mark.parametrize(
    ("old", "new"),
    [("on: x >= 0", ""), ("exact:", "exactly:"), ("bound: 1", "bound: 1 percent"),
     ("source: A", "source: A\nsource: B"), ("exp(-x**2)", "exp(-x**2"), ("on: x", "on: y"),
     ("p = 0.47047", "p = 0.47047\nq = 1"), ("t = 1", "x = 1")],
)  # fmt: skip
def test_what_is_not_understood_is_refused_with_its_line(old: str, new: str) -> None:
    with pytest.raises(tresym.InputError, match=r"line [2-4]"):
        [judge(one) for one in read_list(BLOCK.format("1").replace(old, new))]


def test_the_list_of_the_site_is_read() -> None:
    rows = read_list(LIST.read_text(encoding="utf-8"))
    assert len(rows) >= 70
    assert len({one.source for one in rows}) == len(rows)
    judged = [judge(one) for one in rows if "4.4.45" in one.source or "sinf" in one.source]
    assert [one.verdict for one in judged] == ["exceeded", "holds", ""]
    assert len(table(judged).rows) == len(judged)


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "list.txt"
    path.write_text(BLOCK.format("2.5e-5") + BLOCK.format("1e-5"), encoding="utf-8")
    assert main(["error", "-f", str(path), "--format", "csv"]) == 1
    assert "exceeded" in capsys.readouterr().out
    assert main(["error", "-f", str(path), "--on", "x > 0"]) == 2
    assert main(["error", "-f", str(tmp_path / "none.txt")]) == 2
