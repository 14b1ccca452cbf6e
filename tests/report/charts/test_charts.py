"""Charts: pure functions of one saved file, the same bytes each time, readable without colour."""

import json
import shutil
from contextlib import suppress
from itertools import product
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tresym.commands import main
from tresym.reals.numbers.exact import InputError
from tresym.report import charts
from tresym.report.charts import saved, scaling, times, work_precision
from tresym.report.charts.common import tick_text, time_text

pytest.importorskip("matplotlib")

SAVED = Path(__file__).resolve().parents[3] / "docs" / "measurements"
BUILT = SAVED.parent / "generated" / "charts"


def data(workload: str) -> dict:
    return json.loads((SAVED / f"{workload}.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", charts.CHARTS)
def test_a_saved_chart_is_a_picture_that_can_stand_anywhere(name: str) -> None:
    """That it is what is drawn is shown in test_processors.py."""
    text = (BUILT / f"{name}.svg").read_text(encoding="utf-8")
    root = ElementTree.fromstring(text)
    assert root.tag.endswith("svg")
    found = {child.tag.rpartition("}")[2]: child.text for child in root}
    assert found["title"] == charts.CHARTS[name].title
    assert "Measured on" in found["desc"]
    assert "<text" not in text
    assert "<script" not in text
    assert "dc:date" not in text


@pytest.mark.parametrize("name", ["work-precision", "honesty", "scaling"])
@pytest.mark.slow
def test_a_measurement_of_another_shape_is_one_line(name: str, tmp_path: Path) -> None:
    known = data(charts.CHARTS[name].workload)
    path = tmp_path / "measured.json"
    keys = sorted(known.keys() & {"machine", "memory", "notes", "points", "rows", "versions"})
    shapes = (None, [], {}, "[bold", 1e999, {"x": [None]})
    for n, (key, inner) in enumerate(product(keys, shapes)):
        if key != "rows" and n % 5:  # the rows are what is drawn
            continue
        path.write_text(json.dumps({**known, key: inner}), encoding="utf-8")
        with suppress(InputError):
            charts.picture(name, str(path))


@pytest.mark.parametrize("kind", ["svg", "png"])
@pytest.mark.parametrize("label", ["$\\frac$", "\ud800"])
def test_words_that_cannot_be_drawn_are_one_line(label: str, kind: str, tmp_path: Path) -> None:
    path = tmp_path / "measured.json"
    known = data("honesty")
    known["machine"]["processor"] = label
    path.write_text(json.dumps(known))
    with pytest.raises(InputError, match="not a measurement as `tresym bench --save` writes it"):
        charts.picture("honesty", str(path), kind)


def test_what_is_no_file_of_a_measurement_is_one_line(tmp_path: Path) -> None:
    path = tmp_path / "deep.json"
    path.write_text("[" * 200_000)
    for source in (str(path), "/dev/zero"):
        with pytest.raises(InputError, match=r"deeply|too large"):
            charts.picture("work-precision", source)


def test_a_chart_is_the_same_twice_and_from_a_copy_of_its_file(tmp_path: Path) -> None:
    copy = tmp_path / "elsewhere.json"
    shutil.copy(SAVED / "separatrix.json", copy)
    assert charts.svg("separatrix") == charts.svg("separatrix", str(copy))


def test_no_chart_is_kept_that_is_not_drawn() -> None:
    assert {path.stem for path in BUILT.glob("*")} == set(charts.CHARTS)


def test_every_chart_says_what_its_axes_are() -> None:
    for module in {chart.module for chart in charts.CHARTS.values()}:
        source = Path(charts.__file__).with_name(f"{module}.py").read_text(encoding="utf-8")
        assert "set_xlabel" in source
        assert "set_ylabel" in source or "set_yticks" in source


# Black and white


def test_methods_differ_by_more_than_colour() -> None:
    marks = [mark for mark, _ in work_precision.SERIES.values()]
    assert len(marks) <= 8
    looks = [(mark.marker, str(mark.line), mark.filled) for mark in marks]
    assert len(set(looks)) == len(looks)
    ours = [mark.filled for name, (mark, _) in work_precision.SERIES.items() if "tresym" in name]
    assert all(ours)
    assert sum(mark.filled for mark in marks) == len(ours)
    looks = [(m.marker, str(m.line), m.filled) for m in scaling.BY_DIGITS.values()]
    assert len(set(looks)) == len(looks)


# What they show


def test_the_front_holds_the_best_of_what_is_right() -> None:
    def row(seconds: float, digits: float, outcome: str = "right") -> dict:
        return {"seconds": seconds, "digits": digits, "asked": 100, "outcome": outcome}

    rows = [row(1, 10), row(2, 30), row(3, 20), row(0.5, 90, "wrong"), row(2, 40)]
    assert work_precision.front(rows) == [(1, 10), (2, 40)]


def test_every_method_of_the_data_has_its_mark() -> None:
    methods = {row["method"] for row in data("precision")["rows"]}
    assert methods - {"tresym", "tresym.flip_defect"} == set(work_precision.METHODS)
    digits = [r for r in data("scaling")["rows"] if r["scene"] == "time against digits"]
    assert {row["method"] for row in digits} == set(scaling.BY_DIGITS)


def test_captions_count_from_the_data() -> None:
    honesty = charts.import_module("tresym.report.charts.honesty")
    points = [
        {"method": "tresym, balls", "where": "", "claims": 10, "digits": 12},
        {"method": "scipy quad", "where": "", "claims": 10, "digits": 3},
        {"method": "scipy quad", "where": "", "claims": 10, "digits": 11},
    ]
    said = honesty.caption({"points": points})
    assert "1 of 2 results of other methods" in said
    assert "0 of 1 balls claim too much" in said


@pytest.mark.parametrize("name", charts.CHARTS)
def test_every_chart_says_in_a_sentence_what_a_reader_learns(name: str) -> None:
    sentence = charts.conclusion(name)
    assert sentence.endswith(".")
    assert 60 < len(sentence) < 330
    assert "nan" not in sentence
    assert "e+" not in sentence


def test_what_fails_is_drawn_with_its_reason() -> None:
    kept = data("defect")
    assert any(row["outcome"] != "right" and row["why"] for row in kept["rows"])
    assert "with the reason" in times.caption(kept)


def test_times_have_units() -> None:
    assert [time_text(x) for x in (2.5e-9, 1e-6, 0.0123, 4.0)] == [
        "2.5 ns",
        "1 µs",
        "12.3 ms",
        "4 s",
    ]
    assert [tick_text(n) for n in (-9, -7, -3, 0, 2)] == ["1 ns", "100 ns", "1 ms", "1 s", "100 s"]


# The command


@pytest.mark.slow
def test_the_command_lists_the_charts_and_draws_one(capsys, tmp_path: Path) -> None:
    assert main(["chart"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in listed] == list(charts.CHARTS)
    assert main(["chart", "separatrix", "-o", str(tmp_path / "x.svg")]) == 0
    assert (tmp_path / "x.svg").read_text(encoding="utf-8").startswith("<?xml")
    assert main(["chart", "separatrix", "-o", str(tmp_path / "x.pdf")]) == 0
    assert (tmp_path / "x.pdf").read_bytes().startswith(b"%PDF-")


def test_bad_input_is_one_line(capsys, tmp_path: Path) -> None:
    other = str(SAVED / "separatrix.json")
    broken = tmp_path / "broken.json"
    broken.write_text("{", encoding="utf-8")
    hollow = tmp_path / "hollow.json"
    hollow.write_text('{"workload": "turn"}', encoding="utf-8")
    for words, message in (
        (["chart", "nosuch"], "known: deciders, work-precision"),
        (["chart", "turn", "--from", other], "is not a measurement of the workload turn"),
        (["chart", "turn", "--from", str(broken)], "is not JSON"),
        (["chart", "turn", "--from", str(hollow)], "is not a measurement of the workload turn"),
        (["chart", "turn", "--from", str(tmp_path / "none.json")], "cannot be read"),
    ):
        assert main(words) == 2
        shown = capsys.readouterr().err
        assert message in shown
        assert shown.count("\n") == 1


def test_without_a_saved_measurement_it_says_how_to_make_one(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr(saved, "home", lambda: tmp_path)
    with pytest.raises(InputError, match="measure it: tresym bench turn --save"):
        charts.svg("turn")
