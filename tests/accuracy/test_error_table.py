"""Error tables of unseen pairs: every digit, sign and order against mpmath at 80 digits."""

import json
import sqlite3
from collections.abc import Callable
from pathlib import Path

import mpmath
import pytest

import tresym
from tresym.accuracy.error_table import ErrorTable, error_table
from tresym.commands import main

Of = Callable[[mpmath.mpf], mpmath.mpf]
PAIRS: tuple[tuple[str, str, str, dict[str, str], Of, Of], ...] = (
    (
        "tan(x)", "x + x**3/3", "x -> 0+", {"order": "x**5"},
        mpmath.tan, lambda x: x + x**3 / 3,
    ),
    (
        "y", "M + e*sin(M)", "e -> 0+", {"given": "y - e*sin(y) == M, M == 1, 0 < y, y < 3"},
        lambda e: mpmath.findroot(lambda y: y - e * mpmath.sin(y) - 1, 1.2),
        lambda e: 1 + e * mpmath.sin(1),
    ),
    (
        "integral(1/sqrt(1 - k**2*sin(t)**2), t, 0, pi/2)", "pi/2*(1 + k**2/4)", "k -> 0+", {},
        lambda k: mpmath.ellipk(k**2), lambda k: mpmath.pi / 2 * (1 + k**2 / 4),
    ),
    (
        "integral(exp(-x*t)/(1 + t), t, 0, oo)", "1/x - 1/x**2", "x -> oo", {},
        lambda x: mpmath.exp(x) * mpmath.e1(x), lambda x: 1 / x - 1 / x**2,
    ),
    (
        "integral(1/(sqrt(t)*(1 + e*t)), t, 0, 1)", "2 - 2*e/3", "e -> 0+", {},
        lambda e: 2 * mpmath.atan(mpmath.sqrt(e)) / mpmath.sqrt(e), lambda e: 2 - 2 * e / 3,
    ),
    (
        "sum(x**k/factorial(k)**2, k, 0, oo)", "1 + x", "x -> 0+", {},
        lambda x: mpmath.besseli(0, 2 * mpmath.sqrt(x)), lambda x: 1 + x,
    ),
)  # fmt: skip


@pytest.mark.parametrize(("exact", "approx", "path", "more", "f", "g"), PAIRS)
def test_every_number_is_right(
    exact: str, approx: str, path: str, more: dict[str, str], f: Of, g: Of
) -> None:
    found = error_table(exact, approx, path, digits=30, decide=False, **more)
    with mpmath.workdps(120):
        before = None
        for row in found.rows:
            (name,) = row.at
            x = mpmath.mpf(1) * mpmath.mpf(row.at[name].split("/")[0])
            x /= mpmath.mpf(row.at[name].split("/")[-1]) if "/" in row.at[name] else 1
            true, near = f(x), g(x)
            for shown, ball, value in (
                (row.exact_text, row.exact, true),
                (row.approx_text, row.approx, near),
                (row.error_text, row.error, near - true),
                (row.relative_text, row.relative, near / true - 1),
            ):
                digits = 30 if shown in (row.exact_text, row.approx_text) else 6
                unit = mpmath.mpf(10) ** (mpmath.floor(mpmath.log10(abs(value))) - digits + 1)
                assert abs(mpmath.mpf(shown) - value) <= unit * mpmath.mpf("0.500001")
                assert ball is not None
                assert abs(mpmath.mpf(ball.mid) - value) <= mpmath.mpf(ball.rad)
                assert mpmath.mpf(ball.rad) <= abs(value) * mpmath.mpf(10) ** -30
            if before is not None:
                order = mpmath.log(abs((before[1]) / (near - true))) / mpmath.log(before[0] / x)
                assert abs(mpmath.mpf(row.order_text) - order) < mpmath.mpf(10) ** -5 * 10
            before = x, near - true


def test_the_claim_and_the_constant() -> None:
    found = tresym.error_table("tan(x)", "x + x**3/3 + O(x**5)", "x -> 0+", region="0 < x <= 1")
    assert found.claim is not None
    assert found.claim.verdict.holds
    assert found.constant is not None
    supremum = mpmath.tan(1) - mpmath.mpf(4) / 3
    low, high = mpmath.mpf(found.constant.low), mpmath.mpf(found.constant.high)
    assert low <= supremum <= high <= low * mpmath.mpf("1.02")


def test_a_constant_that_a_lemma_rounds_up_is_no_lower_bound() -> None:
    """The supremum of x³ |∫ t² e^(−xt)/(1 + t²) dt| is 2; the lemma proves 2.06."""
    found = tresym.error_table(
        "integral(exp(-x*t)/(1 + t**2), t, 0, oo)", "1/x + O(1/x**3)", "x -> oo", digits=20
    )
    assert found.claim is not None
    assert found.claim.verdict.holds
    assert found.constant is not None
    assert 1.99 < float(found.constant.low) <= 2 <= float(found.constant.high)


def test_an_infinite_end_is_not_differentiated_under() -> None:
    found = tresym.error_table("integral(exp(-t)/(1 + x*t), t, 0, oo)", "1 - x", "x -> 0+",
                               at=["1/10", "1/100"], order="x**2", digits=10)  # fmt: skip
    assert found.claim is not None
    assert found.claim.verdict.holds
    # the error over x**2 is the integral of exp(-t)*t**2/(1 + x*t), which tends to 2
    assert found.constant is not None
    assert float(found.constant.low) <= 2 <= float(found.constant.high)


def test_a_false_order_is_refuted() -> None:
    found = tresym.error_table("tan(x)", "x + x**3/4", "x -> 0+", order="x**5")
    assert found.claim is not None
    assert found.claim.verdict.value == "REFUTED"
    assert found.constant is None


def test_an_error_that_is_zero_is_told() -> None:
    found = error_table("sin(x)**2", "1 - cos(x)**2", "x -> 0+", at=["1/2"], digits=10)
    assert found.rows[0].error_text == "0"


def test_zeros_that_are_no_digits_are_not_printed() -> None:
    """1234² = 1522756 and 1000² = 1000000."""
    found = error_table("x**2", "x**2 + x", "x -> oo", at=["1234", "1000"], digits=3)
    text = found.written("csv")
    assert "1.52e6" in text
    assert "1520000" not in text
    assert "1000000" in text


@pytest.mark.parametrize("form", ["text", "markdown", "latex", "csv", "html"])
def test_every_format_holds_the_numbers(form: str) -> None:
    found = error_table("sin(x)", "x", "x -> 0+", at=["1/10", "1/100"], digits=12, order="x**3")
    text = found.written(form)
    assert "0.0998334166468" in text.replace("$", "")
    assert "2.9997" in text or "2.99978" in text


def test_json_has_every_key(capsys: pytest.CaptureFixture[str]) -> None:
    asked = ["table", "sin(x)", "x", "--as", "x -> 0+", "--at", "1/10,1/100", "--json"]
    assert main(asked) == 0
    found = json.loads(capsys.readouterr().out)
    assert {"exact", "approx", "path", "rows", "claim", "constant"} <= found.keys()
    assert found["rows"][0]["at"] == {"x": "1/10"}
    assert set(found["rows"][1]) == {"at", "exact", "approx", "error", "relative", "order"}
    assert found["rows"][0]["order"] is None
    assert found["rows"][0]["error"]["mid"].startswith("0.000166583")
    assert {"low", "high", "gauge", "region", "where", "verdict"} == found["constant"].keys()


@pytest.mark.parametrize(
    "asked",
    [
        ["sin(x)", "x"],
        ["sin(x)", "x", "--as", "y -> 0"],
        ["sin(x)", "a*x", "--as", "x -> 0"],
        ["sin(x)", "x", "--as", "x -> 0+", "--at=-1/10"],
        ["sin(x)", "x", "--as", "x -> 0+", "--at", "0.1.2"],
        ["root(y**2 - x, y, -9, 9)", "x", "--as", "x -> 0+"],
        ["root(y**2 + x, y, -9, 9)", "x", "--as", "x -> 0+"],
        ["integral(1/t, t, 0, x)", "x", "--as", "x -> 0+"],
        ["sin(x", "x", "--as", "x -> 0+"],
        ["sin(x)", "x", "--as", "x -> 0+", "--digits", "0"],
        ["sin(x)", "x", "--as", "x -> 0+", "--digits", "-3"],
        ["y", "x", "--as", "x -> 0+", "--given", "y*z == x"],
    ],
)
def test_bad_input_is_one_line(asked: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["table", *asked]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.strip().count("\n") == 0


def test_the_table_shows_itself() -> None:
    found = error_table("sin(x)", "x", "x -> 0+", at=["1/10"], digits=8, decide=False)
    assert isinstance(found, ErrorTable)
    assert repr(found) == "ErrorTable(x for sin(x), x -> 0+: 1 rows)"
    assert found._repr_html_().startswith("<table>")


def test_many_cells_on_several_processes_are_the_same() -> None:
    from tresym.accuracy.cells import computed, decoded, encoded
    from tresym.accuracy.error_table import asked, cell
    from tresym.reals.language.expression import number

    question = asked("exp(x)", "1 + x", "x -> 0+", "", None)
    there = decoded(computed(encoded(question, number(3), 40)))
    here = cell(question, number(3), 40)
    assert str(there) == str(here)


def test_finished_cells_are_kept_and_damage_is_no_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path))
    points = ",".join(f"1/{n}" for n in range(2, 22))
    asked = ["table", "tan(x)", "x", "--as", "x -> 0+", "--at", points, "--json", "--digits", "20"]
    assert main(asked) == 0
    first = json.loads(capsys.readouterr().out)
    with monkeypatch.context() as nothing:

        def fail(*_: object) -> None:
            raise AssertionError("computed again")

        nothing.setattr("tresym.accuracy.cells.computed", fail)
        assert main(asked) == 0
    again = json.loads(capsys.readouterr().out)
    assert again["rows"] == first["rows"]
    file = sqlite3.connect(tmp_path / "cells.sqlite")
    file.execute("UPDATE cells SET value = replace(value, '[', '[1, ')")
    file.commit()
    file.close()
    assert main(asked) == 0
    assert json.loads(capsys.readouterr().out)["rows"] == first["rows"]
