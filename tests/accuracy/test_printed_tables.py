"""Printed tables: the convention of a column is found, and every wrong cell is flagged."""

import json
from pathlib import Path

import mpmath
import pytest

import tresym
from tresym.accuracy.printed_tables import against
from tresym.commands import main


def column(kind: str, places: int, points: list[str]) -> list[str]:
    """The sine integral printed by a convention, with mpmath."""
    cells = []
    with mpmath.workdps(50):
        for x in points:
            value = mpmath.si(mpmath.mpf(x)) * mpmath.mpf(10) ** places
            turn = {
                "nearest": mpmath.nint, "truncated": mpmath.floor,
                "upper": mpmath.ceil, "lower": mpmath.floor,
            }[kind]  # fmt: skip
            text = str(int(turn(value))).rjust(places + 1, "0")
            cells.append(f"{text[:-places]}.{text[-places:]}")
    return cells


POINTS = ["0.5", "1", "1.5", "2", "2.5", "3", "4", "5"]
SI = "integral(sin(t)/t, t, 0, x)"


@pytest.mark.parametrize("kind", ["nearest", "truncated", "upper"])
def test_the_convention_is_found(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "si.csv"
    cells = column(kind, 6, POINTS)
    path.write_text("x,Si\n" + "".join(f"{x},{c}\n" for x, c in zip(POINTS, cells, strict=True)))
    found = against(str(path), SI)
    assert found.convention == kind
    assert found


def test_a_wrong_digit_is_flagged_with_the_true_value(tmp_path: Path) -> None:
    path = tmp_path / "si.csv"
    cells = column("nearest", 6, POINTS)
    cells[3] = cells[3][:-1] + str((int(cells[3][-1]) + 2) % 10)
    path.write_text("x,Si\n" + "".join(f"{x},{c}\n" for x, c in zip(POINTS, cells, strict=True)))
    found = against(str(path), SI)
    assert [cell.at["x"] for cell in found.wrong] == ["2"]
    assert found.wrong[0].shown.startswith("1.6054129768")


def test_rounded_parameters_are_propagated(tmp_path: Path) -> None:
    path = tmp_path / "square.csv"
    path.write_text("x,y\n1.41,2.00\n1.732,3.00\n2.24,5.99\n")
    found = against(str(path), "x**2", rounded_parameters=True)
    assert [cell.fits for cell in found.cells] == [True, True, False]
    assert "rounding of the parameters" in found.cells[0].why


def test_arguments_are_exact_unless_said_otherwise(tmp_path: Path) -> None:
    """The value at 0.5 is 0.5204998…; at 0.504, which rounds to 0.5, it is 0.5240."""
    path = tmp_path / "erf.csv"
    path.write_text("x,erf\n0.5,0.5234999\n1,0.8427008\n1.5,0.9661051\n")
    found = against(str(path), "erf(x)")
    assert [cell.fits for cell in found.cells] == [False, True, True]
    assert found.cells[0].why.startswith("the value is 0.52049987781")
    assert "if the parameters are rounded" in found.cells[0].why
    assert main(["table", "--against", str(path), "erf(x)"]) == 1
    assert main(["table", "--against", str(path), "--rounded", "erf(x)"]) == 0
    assert main(["table", "--rounded", "sin(x)", "x", "--as", "x -> 0+"]) == 2


def test_the_command_says_what_is_wrong(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "log.csv"
    path.write_text("x,name,log\n2,two,0.6931\n3,three,1.0987\n")
    asked = ["table", "--against", str(path), "--column", "log", "log(x)"]
    assert main(asked) == 1
    assert "WRONG" in capsys.readouterr().out
    assert main([*asked, "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert [row["fits"] for row in found["rows"]] == [True, False]


@pytest.mark.parametrize(
    ("text", "formula", "more"),
    [
        ("x,y\n1,2\n", "x*z", {}),
        ("x,y,z\n1,2,3\n", "x", {}),
        ("x,y\n", "x", {}),
        ("x,y\n1\n", "x", {}),
        ("x,y\n1,abc\n", "x", {}),
        ("x,y\nabc!,1\n", "x", {}),
        ("x,y\n1,2\n", "x", {"column": "w"}),
        ("x,y\n1,2\n", "x +", {}),
    ],
)
def test_bad_files_are_refused_in_a_line(
    text: str, formula: str, more: dict[str, str], tmp_path: Path
) -> None:
    path = tmp_path / "table.csv"
    path.write_text(text)
    with pytest.raises(tresym.InputError) as error:
        against(str(path), formula, **more)
    assert "\n" not in str(error.value)


def test_a_missing_file_is_refused() -> None:
    with pytest.raises(tresym.InputError, match="cannot be read"):
        against("nowhere.csv", "x")
