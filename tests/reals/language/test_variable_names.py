"""Names in typed claims that are no variables are refused, with what to write instead."""

from pathlib import Path

import pytest

import tresym
from tresym.commands import main
from tresym.reals.numbers.exact import InputError


@pytest.mark.parametrize(
    ("claim", "advice"),
    [
        *(
            ("x mod 2 == x", "remainders"),
            ("30 Degree == pi/6", "30*pi/180"),
            ("dy/dx == 1", "diff"),
        ),
        *(("1/xy == 1/x/y", "x*y"), ("a/(bc) == a/b/c", "b*c"), ("5 m > 3 cm", "units")),
        *(
            ("x > 0 given x > 1 an", "words"),
            ("x > 0 given x > 1 and", "missing after the word and"),
        ),
        *(("kr*x == x*kr", "kr > 0"), ("aplha + 1 > aplha", "aplha > 0"), ("sine + 1 > 0", "sin")),
    ],
)
def test_it_is_refused(claim: str, advice: str) -> None:
    with pytest.raises(InputError, match=advice.replace("*", r"\*")):
        tresym.check(claim)


def test_conditions_that_are_repeated_hold_together(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "x > 0", "--given", "x > 1", "--given", "x < 5"]) == 0
    assert "x > 1, x < 5" in capsys.readouterr().out
    assert main(["check", "x > 2", "--given", "x > 1", "--given", "x < 5", "--no-suggest"]) == 1


def test_names_in_a_file_are_refused_line_by_line(tmp_path: Path) -> None:
    (tmp_path / "claims").write_text("x**2 >= 0\n30 Degree == pi/6\n", encoding="utf-8")
    assert main(["check", "-f", str(tmp_path / "claims"), "--no-cache", "--json"]) == 2


def test_a_base_on_either_side_is_refused() -> None:
    with pytest.raises(InputError, match="two readings"):
        tresym.check("Log(2, 8) == 3")
