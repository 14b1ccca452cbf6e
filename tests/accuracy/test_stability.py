"""Digits lost in double precision, and the stable forms that are found."""

import math
from pathlib import Path

import mpmath
import pytest
from cases import cases

import tresym
from tresym.accuracy.stability import stability
from tresym.accuracy.work_precision import work_precision

LOSING = (
    ("(1 - cos(x))/x**2", "0 < x <= 1", 15.0),
    ("sqrt(x + 1) - sqrt(x)", "x >= 1", 10.0),
    ("exp(x) - exp(y)", "0 < x <= 1, 0 < y <= 1", 8.0),
    ("log(1 + x)/x", "0 < x <= 1", 10.0),
    ("1/x - 1/(x + 1)", "x > 1", 10.0),
)


@pytest.mark.parametrize(("text", "given", "least"), LOSING)
def test_a_stable_form_is_found_and_proved(text: str, given: str, least: float) -> None:
    found = stability(text, given)
    assert len(found.forms) == 2
    assert found.forms[0].worst > least
    assert found.forms[1].worst < 1
    assert tresym.check(f"{text} == {found.forms[1].text}", given)


def test_a_stable_expression_has_no_other_form() -> None:
    found = stability("x*exp(-x)", "0 < x <= 3")
    assert len(found.forms) == 1
    assert found.forms[0].worst < 1.5


def test_points_outside_the_region_do_not_count() -> None:
    found = stability("sqrt(x - y)", "0 < x <= 1, 0 < y <= 1, y < x")
    rows = found.forms[0].lost
    assert any(math.isnan(x) for row in rows for x in row)
    assert any(not math.isnan(x) for row in rows for x in row)


def test_a_function_of_ones_own(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text("from math import cos\ndef f(x):\n    return (1 - cos(x))/x**2\n")
    found = stability("(1 - cos(x))/x**2", "0 < x <= 1", f"{path}:f")
    assert found.forms[0].text.endswith("mine.py:f")
    assert found.forms[0].worst > 15


@pytest.mark.parametrize(
    ("text", "given", "mine"),
    cases(__file__, "what_cannot_be_measured_is_refused"),
)
def test_what_cannot_be_measured_is_refused(text: str, given: str, mine: str | None) -> None:
    with pytest.raises(tresym.InputError) as error:
        stability(text, given, mine)
    assert "\n" not in str(error.value)


def test_no_method_is_judged_by_its_own_estimate(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mpmath.mp, "dps", mpmath.mp.dps)  # what the user's function leaves behind
    path = tmp_path / "mine.py"
    path.write_text(
        "def wrong(x):\n    return 1.25\n"
        "def exact(x, digits):\n    import mpmath\n    mpmath.mp.dps = digits + 3  # as users do\n"
        "    return mpmath.exp(mpmath.mpf(x.numerator)/x.denominator)\n"
    )
    asked = [f"{path}:wrong", f"{path}:exact"]
    points = work_precision("exp(x)", {"x": "1/3"}, asked, (10, 30))
    of = {(p.method.rpartition(":")[2], p.asked): p for p in points}
    assert of["wrong", None].digits < 2
    assert of["exact", 30].digits > 29
    assert all(p.digits > p.asked for p in points if p.certified and p.asked)
    assert {p.method for p in points} >= {"tresym, balls", "mpmath", "SciPy, double"}


@pytest.mark.parametrize(
    ("text", "at"),
    [
        ("integral(exp(-t**2), t, 0, x)", {"x": "2"}),
        ("root(y - y**3/9 - x, y, 0, 1)", {"x": "1/2"}),
        ("sum(x**k/factorial(k), k, 0, oo)", {"x": "1/2"}),
        ("coth(x) + sech(x) + cbrt(x) + asinh(x) + abs(-x) + sign(x)", {"x": "3/2"}),
    ],
)
def test_the_other_libraries_agree(text: str, at: dict[str, str]) -> None:
    points = work_precision(text, at, asked=(10, 25))
    assert all(p.digits > 9 for p in points), points
    assert any(p.method == "mpmath" and p.asked == 25 for p in points)
