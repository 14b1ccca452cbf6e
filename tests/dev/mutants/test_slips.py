"""The line of a claim with one change: what can be changed is, and the rest stands as it is."""

from pathlib import Path

import pytest

from tresym.dev.mutants.slips import Place, moved_digits, other_units, slips, without
from tresym.papers.changed_lines import Line, lines_of
from tresym.reals.numbers.exact import InputError

DECLARED = "a, b, x, S real\nf(x) := x**2 + a\nturn := (a, b; -b, a)\nlet shape: a > 0, b > 0\n"


def line(text: str, tmp_path: Path) -> Line:
    """A line below some declarations."""
    path = tmp_path / "lines.tresym"
    path.write_text(f"{DECLARED}claim: {text}\n", encoding="utf-8")
    return lines_of(path, lambda name: {})["claim"]


def texts(places: list[Place], name: str) -> set[str]:
    return {slip.text for place in places if place.name == name for slip in place.slips}


CHANGED = [
    ("sin(x) <= x given x > 0", "side 1", "cos(x) <= x given x > 0"),
    ("sin(x) <= x given x > 0", "side 1", "-sin(x) <= x given x > 0"),
    ("sin(x) <= 2*x given x > 0", "side 2", "sin(x) <= 3*x given x > 0"),
    ("sin(x) <= x given x > 0", "relation", "sin(x) >= x given x > 0"),
    ("sin(x) <= x given x > 0", "relation", "sin(x) < x given x > 0"),
    ("sin(x) <= x given x > 0", "conditions", "sin(x) <= x"),
    ("a*x <= x given x > 0, a < 1", "conditions", "a*x <= x given a < 1"),
    ("a*x <= x given x > 0, a < 1", "condition", "a*x <= x given x > 0, a < 2"),
    ("a*x <= x given x > 0, a < 1", "condition", "a*x <= x given x < 0, a < 1"),
    ("f(x) == x**2 + a", "side 2", "f(x) == x**2 - a"),
    ("f(x) == x**2 + a", "side 2", "f(x) == x**3 + a"),
    ("f(x) == x**2 + a", "side 1", "f(a) == x**2 + a"),
    ("a == a + b - b == a", "step 2", "a == a + b + b == a"),
    ("x > 0 and x + 1 > 1 given x > 0", "side 3", "x > 0 and x - 1 > 1 given x > 0"),
    ("exactly one x in (0, 1): x == b - x given b > 0, b < 2", "side 2", "2"),
    ("2*x ~= 0.115 given x ~= 0.0575", "side 2", "2*x ~= 0.116 given x ~= 0.0575"),
    ("2*x ~= 0.115 given x ~= 0.0575", "condition", "2*x ~= 0.115 given x ~= 0.0576"),
    ("transposed(turn) == (a, -b; b, a)", "side 3", "transposed(turn) == (a, b; b, a)"),
    ("diff(x**3, x) == 3*x**2", "side 1", "diff(x**4, x) == 3*x**2"),
    ("sin(x) == x + O(x**3) as x -> 0", "side 2", "sin(x) == x + O(x**4) as x -> 0"),
]


@pytest.mark.parametrize(("text", "place", "changed"), CHANGED)
def test_what_can_be_changed_is_changed(
    text: str, place: str, changed: str, tmp_path: Path
) -> None:
    stated = line(text, tmp_path)
    found = texts(slips(stated), place)
    assert changed in found or any(f"({changed}, 1)" in each for each in found)
    assert text not in found


def test_the_change_of_a_step_is_asked_alone(tmp_path: Path) -> None:
    stated = line("a == a + b - b [by sums] == a given a > 0", tmp_path)
    (place,) = (place for place in slips(stated) if place.name.startswith("step"))
    slip = next(slip for slip in place.slips if "a + b + b" in slip.text)
    assert slip.text == "a == a + b + b [by sums] == a given a > 0"
    assert slip.step.split() == [
        "a",
        "==",
        "a",
        "+",
        "b",
        "+",
        "b",
        "[by",
        "sums]",
        "given",
        "a",
        ">",
        "0",
    ]


def test_conditions_behind_a_name_are_left_out_one_by_one(tmp_path: Path) -> None:
    stated = line("a + b > 0 given shape, x > 0", tmp_path)
    (place,) = (place for place in slips(stated) if place.name == "conditions")
    left = [len(stated.read(s.text, conditions=s.conditions).given) for s in place.slips]
    assert sorted(left) == [1, 2, 2, 2]


def test_a_name_is_no_place_for_a_change(tmp_path: Path) -> None:
    stated = line("a > 0 given shape", tmp_path)
    assert texts(slips(stated), "condition") == set()


def test_the_first_slips_are_of_different_kinds(tmp_path: Path) -> None:
    stated = line("x == 3*sin(a) + b given b > 0", tmp_path)
    place = slips(stated)[1]
    first = [slip.new for slip, _ in zip(place.slips, range(4), strict=False)]
    assert len({*first}) == 4
    assert first == [slip.new for slip, _ in zip(slips(stated)[1].slips, range(4), strict=False)]


def test_clauses_are_left_out(tmp_path: Path) -> None:
    stated = line("a > 0 given b > 0 expect refuted at a == -1, b == 1", tmp_path)
    assert without(stated, stated.text, "expect", "at").strip() == "a > 0 given b > 0"
    assert without(stated, stated.text, "given").split() == (
        ["a", ">", "0", "expect", "refuted", "at", "a", "==", "-1,", "b", "==", "1"]
    )


def test_what_cannot_be_read_is_refused(tmp_path: Path) -> None:
    stated = line("transposed(turn) == (a, -b; b, a)", tmp_path)
    for text in ("transposed(turn**2) == turn", "a >", "unknown_name > 0"):
        with pytest.raises(InputError):
            stated.read(text)


def test_digits_are_moved_last_ones_first() -> None:
    found = list(moved_digits("1.9e-3"))
    assert found[:4] == ["1.8e-3", "2.9e-3", "0.9e-3", "-1.9e-3"]
    assert "1.9e-3" not in found
    assert all(text.endswith("e-3") for text in found)
    assert "1.2" in moved_digits("-1.2")
    assert [*other_units("1.2e-3")] == ["1.2e-2", "1.2e-4", "1.2e0", "1.2e-6"]
