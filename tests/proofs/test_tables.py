"""Tables: every number is inside the ball it came from, in every format."""

import json
import re

import pytest
from flint import arb
from tresym.proofs.tables import TABLES, Table, digits_of, table, written

from tresym.commands import main
from tresym.racket.body import named_body
from tresym.racket.flip.separatrix import solve
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

QUICK = [name for name in TABLES if name != "routes"]


@pytest.fixture(scope="module")
def tables() -> dict[str, Table]:
    return {name: table(name) for name in QUICK}


@pytest.mark.parametrize("name", QUICK)
@pytest.mark.parametrize("form", ["text", "markdown", "latex"])
def test_every_format(tables: dict[str, Table], name: str, form: str) -> None:
    found = tables[name]
    assert all(len(row) == len(found.heads) for row in found.rows)
    text = written(found, form)
    if form == "latex":  # where formulas are set as formulas
        assert text.count(r"\\") == len(found.rows) + 1
    else:
        assert all(row[0] in text for row in found.rows)


@pytest.mark.parametrize("name", QUICK)
def test_a_table_fits_a_terminal_and_breaks_no_number(tables: dict[str, Table], name: str) -> None:
    found = tables[name]
    lines = written(found, "text").splitlines()
    assert max(map(len, lines)) <= 80
    told = [cell for line in lines for cell in re.split("  +", line)]
    assert all(cell in told for row in found.rows for cell in row)
    assert sum(line.startswith(found.rows[0][0] + " ") for line in lines) >= 1


def test_columns_that_find_no_room_stand_below_with_what_the_rows_are_of() -> None:
    rows = (("a", "1", "2" * 40, "3" * 40), ("b", "4", "5" * 40, "6" * 40))
    found = Table("Digits.", ("of", "n", "first", "second one of the two"), rows, keys=2)
    first, second = written(found, "text").split("\n\n")[1:]
    assert [line.split() for line in first.splitlines()][::2] == [
        ["of", "n", "first"],
        [*rows[0][:3]],
    ]
    assert second.splitlines()[-1].split() == ["b", "4", "6" * 40]


def test_the_objects_are_the_certified_flip(tables: dict[str, Table]) -> None:
    for row in tables["objects"].rows:
        truth = solve(*named_body(row[0]).shape, 60).defect
        with ball_precision(300):
            assert abs(arb(row[4]) / truth - 1) < arb(10) ** -49


def test_the_printed_formula_is_wrong_where_the_paper_does_not_look(
    tables: dict[str, Table],
) -> None:
    row = next(r for r in tables["errors"].rows if r[0] == "ab = 0.001, b = 1")
    errors = dict(zip(tables["errors"].heads[1:], map(float, row[1:]), strict=True))
    assert abs(errors["printed"]) > 0.5
    assert abs(errors["one line"]) < 0.028
    assert abs(errors["Newton"]) < 1e-4


def test_only_proved_digits_are_shown() -> None:
    assert digits_of(arb("1.25 +/- 0.01"), 20) in ("1.2", "1.3")


def test_unknown_tables_are_answered_with_the_nearest() -> None:
    with pytest.raises(InputError, match="did you mean slope"):
        table("slop")


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["table", "slope", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["heads"][0] == "shape"


def test_the_constants_are_above_what_is_found_by_less_than_one_per_cent(
    tables: dict[str, Table],
) -> None:
    for row in tables["constants"].rows:
        for proved, found, above in (row[1:4], row[4:7]):
            assert float(found) < float(proved) < 1.01 * float(found)
            assert 0 < float(above.removesuffix(" %")) < 1


def test_the_slope_table_tells_every_error_from_zero(tables: dict[str, Table]) -> None:
    for row in tables["slope"].rows:
        assert float(row[3].removesuffix(" %")) != 0
        assert float(row[1]) < 0


@pytest.mark.parametrize("name", ["errors", "slope", "thresholds"])
def test_the_shapes_go_from_a_thousandth_to_ten_thousand(
    tables: dict[str, Table], name: str
) -> None:
    shapes = [row[0] for row in tables[name].rows]
    assert {"ab = 0.001, b = 1", "ab = 10000, b = 1", "ab = 1, b = 1/10", "str"} <= set(shapes)
