"""Sweeps: the same rows whatever the executor, the restarts and the order; nothing lost or twice.

The kill tests are repeated 20 times where ``HYPOTHESIS_PROFILE`` is ``deep``.
"""

import csv
import itertools
import json
import logging
import os
import select
import signal
import socket
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, closing, contextmanager, suppress
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from cases import cases
from flint import arb, ctx, fmpq
from hangs import HANGS

from tresym import flip_defect
from tresym.checking.time_limited import BATCH
from tresym.commands import main
from tresym.racket.formulas import printed
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision
from tresym.reals.numbers.exact import InputError, parse_number
from tresym.sweep import CsvFile, Grid, cluster, processes, sweep, to_frame
from tresym.sweep.rows import FORMULAS, SweepRow, compute
from tresym.sweep.run import Progress, batch_size, duration
from tresym.sweep.source import LONGEST_LINE, read_values
from tresym.sweep.table import packed
from tresym.sweep.workers import Here, Workers, _unheard

ROOT = Path(__file__).resolve().parents[2]
DEEP = os.environ.get("HYPOTHESIS_PROFILE") == "deep"
KILLS = 20 if DEEP else 1
GRID = Grid.read("0.01:100:9log", "1/1000,0.31,1", "-1e-4,0,1/200")


def rows_of(path: Path | str) -> list[tuple[Any, ...]]:
    with closing(sqlite3.connect(path)) as connection:
        return list(connection.execute("SELECT * FROM rows ORDER BY line"))


def float_rows_of(path: Path | str) -> list[SweepRow]:
    """Rows in float64, whose table has no column for a radius."""
    radius = SweepRow._fields.index("radius")
    return [SweepRow(*values[:radius], None, *values[radius:]) for values in rows_of(path)]


def lent(*arguments: Any) -> Callable[[], AbstractContextManager[Workers]]:
    """Workers of an executor, as a sweep asks for them."""

    @contextmanager
    def workers() -> Iterator[Workers]:
        yield Workers(*arguments)

    return workers


serial = lent(Here(), 1)


class Answering(Executor):
    """Gives the answers of a function of their number, from 1 on, and of the computation."""

    def __init__(self, answer: Callable[[int, Callable[[], Any]], Any]) -> None:
        self.answer, self.asked = answer, 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self.asked += 1
        try:
            future.set_result(self.answer(self.asked, lambda: fn(*args, **kwargs)))
        except Exception as error:
            future.set_exception(error)
        return future


class Silent(Executor):
    """Never answers."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        return Future()


def nobody() -> None:
    raise InputError("nobody is left")


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[Any, ...]]:
    path = tmp_path_factory.mktemp("serial") / "table"
    found = sweep(GRID, str(path), 20, serial)
    assert (found.rows, found.bad, found.computed) == (81, 0, 81)
    return rows_of(path)


# What a row says


def test_rows_are_what_flip_says(expected: list[tuple[Any, ...]]) -> None:
    points = list(itertools.product(*GRID))
    assert [row[0] for row in expected] == list(range(1, 82))
    for values, (a, b, gamma) in zip(expected, points, strict=True):
        row = SweepRow(*values)
        answer = flip_defect(a, b, gamma, 40)
        assert [parse_number(str(x)) for x in (row.a, row.b, row.gamma)] == [a, b, gamma]
        assert row.realizable == answer.realizable
        with ball_precision(300):
            mid, rad = arb(str(row.defect)), arb(str(row.radius))
            assert abs(mid - answer.defect) <= rad
            assert rad <= abs(mid) * arb("1e-20")


def test_errors_of_the_formulas_are_right_to_six_digits(expected: list[tuple[Any, ...]]) -> None:
    shown = 0
    for values in expected:
        row = SweepRow(*values)
        a, b, gamma = (parse_number(str(x)) for x in (row.a, row.b, row.gamma))
        with ball_precision(400):
            truth, middle = (flip_defect(a, b, g, 90).defect for g in (gamma, 0))
            wanted = {
                name: formula(arb(a), arb(b), balls) / truth - 1
                for name, formula in FORMULAS.items()
            }
            if gamma != 0:
                linear = printed.linear_defect(middle, arb(b), arb(gamma)) / truth - 1
                wanted = dict.fromkeys(FORMULAS, None) | {"error_linear": linear}
        for name, error in wanted.items():
            said = getattr(row, name)
            assert (said is None) or error is not None
            if said is not None:
                assert said == pytest.approx(float(error), rel=1e-5)
                shown += 1
    assert shown > 150


def test_float_rows_are_right_to_twelve_digits(tmp_path: Path) -> None:
    grid = Grid.read("1e-6:1e4:8log", "1e-6,0.03,1", "-1e-7,0,1e-7")
    sweep(grid, str(tmp_path / "t"), None, serial)
    for row in float_rows_of(tmp_path / "t"):
        truth = flip_defect(*(str(x) for x in (row.a, row.b, row.gamma)), 17)
        assert row.defect == pytest.approx(float(truth.defect), rel=2e-13)


def test_float64_says_what_it_cannot_hold(tmp_path: Path) -> None:
    grid = Grid.read("1,1e6,1e400,1e-400", "1,1e-400", "0,1/2")
    found = sweep(grid, str(tmp_path / "t"), None, serial)
    assert found.bad >= 6
    for row in float_rows_of(tmp_path / "t"):
        assert (row.defect is None) == (row.problem is not None)
        if row.defect is not None:
            truth = flip_defect(*(str(x) for x in (row.a, row.b, row.gamma)), 17).defect
            assert row.defect == pytest.approx(float(truth), rel=1e-11)


def test_threads_of_one_process_take_turns(tmp_path: Path, expected: list[tuple[Any, ...]]) -> None:
    @contextmanager
    def threads() -> Iterator[Workers]:
        with ThreadPoolExecutor(4) as executor:
            yield Workers(executor, 8)

    before = ctx.prec
    sweep(GRID, str(tmp_path / "t"), 20, threads)
    assert ctx.prec == before
    assert rows_of(tmp_path / "t") == expected


def test_batches_computed_backwards_are_the_same(expected: list[tuple[Any, ...]]) -> None:
    for size in (1, 7, 81):
        parts = [part for _, part in GRID.parts(size, ())]
        rows = [row for part in reversed(parts) for row in compute(part, 20)]
        assert sorted(map(tuple, rows)) == expected


# Sources


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("1/3", ["1/3"]),
        (" 1, 0.5 ,2e-3", ["1", "1/2", "1/500"]),
        ("0:1:3", ["0", "1/2", "1"]),
        ("1:0:5", ["1", "3/4", "1/2", "1/4", "0"]),
        ("1e-2:1e2:3log", ["1/100", "1", "100"]),
        ("-1e-3:1e-3:3", ["-1/1000", "0", "1/1000"]),
    ],
)
def test_values(text: str, values: list[str]) -> None:
    assert read_values(text, "a") == tuple(map(parse_number, values))


@pytest.mark.parametrize(
    "text",
    ["", ",", "1,", "1:2", "1:2:", "1:2:1", "1:2:0", "1:2:999999999", "0:1:5log", "-1:1:5log",
     "1:2:3lin", "1:2:3:4", "nan", "1:inf:3", "1:2:-3", "1:2:٣", "1:2:3e1"],
)  # fmt: skip
def test_values_that_are_refused(text: str) -> None:
    with pytest.raises(InputError) as caught:
        read_values(text, "a")
    assert "\n" not in str(caught.value)


def test_equal_ratios_are_exact_decimals() -> None:
    values = read_values("1e-3:7:50log", "a")
    assert (values[0], values[-1], len(values)) == (fmpq(1, 1000), fmpq(7), 50)
    ratios = [float(Fraction(str(y / x))) for x, y in itertools.pairwise(values)]
    assert max(ratios) == pytest.approx(min(ratios), rel=1e-13)


def test_a_grid_beyond_the_limit_is_refused() -> None:
    with pytest.raises(InputError, match="beyond the limit"):
        Grid.read("1:2:100000", "0.1:1:100000", "0:1:1000")


CSV = (
    b"\xef\xbb\xbfname, I1,I2,I3,gamma,maker\r\n"
    b"r1,886,16336,18270,,Head\r\n"
    b"back,3,2,1,,\r\n"
    b"short,1,2\r\n"
    b'"quoted, name",1210,16380,17480,1/100,Wilson\r\n'
    b"\r\n"
    b"decimal comma,\"1,5\",2,3,,\r\n"
    b"far,1210,16380,17480,50,\r\n"
    b"\xff\xfe,\x00,2,3,,\r\n"
    b'open quote,"1,2,3,,\r\n'
    b"long," + b"1" * LONGEST_LINE + b",2,3,,\r\n"
    b"digits,1,2," + b"9" * 10_001 + b",,\r\n"
    b"last,1,2,2.5,0,"
)  # fmt: skip


def test_bad_rows_stand_beside_good_ones(tmp_path: Path) -> None:
    source = tmp_path / "bodies.csv"
    source.write_bytes(CSV)
    found = sweep(CsvFile(str(source)), str(tmp_path / "t"), 15, serial)
    rows = {values[0]: SweepRow(*values) for values in rows_of(tmp_path / "t")}
    assert sorted(rows) == [2, 3, 4, 5, 7, 8, 9, 10, 11, 12, 13]
    good = {line for line, row in rows.items() if row.problem is None}
    assert good == {2, 5, 13}
    assert found.bad == 8
    assert found.problems[0] == (3, rows[3].problem)
    wanted = {
        3: "expected order", 4: "3 values for 6 columns", 7: "'1,5' is not a number",
        8: "gamma: must be between", 9: "is not a number", 10: "line: ", 11: "longer than",
        12: "beyond the limit of 10000",
    }  # fmt: skip
    for line, words in wanted.items():
        assert words in str(rows[line].problem)
        assert "\n" not in str(rows[line].problem)
    assert (rows[5].name, rows[5].gamma) == ("quoted, name", "1/100")
    with ball_precision(200):
        answer = flip_defect("1517/121", "55/874", "1/100", 40).defect
        assert abs(arb(str(rows[5].defect)) - answer) <= arb(str(rows[5].radius))


def test_named_bodies_and_shapes_are_read(tmp_path: Path) -> None:
    for text in ("body\nbook\nethylene\n", "gamma,b,a\n0,31/100,1.11\n,0.5,2\n"):
        (tmp_path / "c.csv").write_text(text)
        (tmp_path / "t").unlink(missing_ok=True)
        assert sweep(CsvFile(str(tmp_path / "c.csv")), str(tmp_path / "t"), 5, serial).bad == 0


@pytest.mark.parametrize(
    "text", ["", "\n", "a\n1\n", "a,b,body\n", "a,a,b\n", "x,y\n", '"a,b\n', "\0", "1,2\n3,4\n"]
)
def test_a_header_that_says_nothing_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "c.csv").write_text(text)
    with pytest.raises(InputError, match="first line must name the columns"):
        CsvFile(str(tmp_path / "c.csv"))


def test_an_empty_file_of_bodies_makes_an_empty_table(tmp_path: Path) -> None:
    (tmp_path / "c.csv").write_text("a,b\n")
    assert sweep(CsvFile(str(tmp_path / "c.csv")), str(tmp_path / "t"), 5).rows == 0


# The table


def test_what_landed_before_the_workers_died_is_kept(
    tmp_path: Path, expected: list[tuple[Any, ...]]
) -> None:
    def three(n: int, compute: Callable[[], Any]) -> Any:
        if n > 3:  # as a pool does whose workers die
            raise BrokenExecutor("all workers have died")
        return compute()

    with pytest.raises(InputError, match="all workers have died"):
        sweep(GRID, str(tmp_path / "t"), 20, lent(Answering(three), 1))
    assert rows_of(tmp_path / "t") == expected[:15]
    assert sweep(GRID, str(tmp_path / "t"), 20, serial).computed == 81 - 15
    assert rows_of(tmp_path / "t") == expected


def losing(answers: int) -> Answering:
    """Loses the first answers on their way, as Dask does when a worker dies after its answer."""

    def later(n: int, compute: Callable[[], Any]) -> Any:
        if n <= answers:
            raise ValueError("too many values to unpack (expected 3)")
        return compute()

    return Answering(later)


@pytest.mark.parametrize(("answers", "ends"), [(1, True), (3, True), (4, False)])
def test_a_lost_answer_is_asked_for_again_but_not_for_ever(
    answers: int, ends: bool, tmp_path: Path, expected: list[tuple[Any, ...]]
) -> None:
    workers = lent(losing(answers), 1)
    if ends:
        assert sweep(GRID, str(tmp_path / "t"), 20, workers).computed == 81
        assert rows_of(tmp_path / "t") == expected
    else:
        with pytest.raises(ValueError, match="too many values"):
            sweep(GRID, str(tmp_path / "t"), 20, workers)


@pytest.mark.parametrize(("answers", "ends"), [(1, True), (3, True), (4, False)])
def test_a_lost_answer_is_asked_for_again_in_order_too(answers: int, ends: bool) -> None:
    """As ``tresym check -f --scheduler`` asks."""
    asked = [b"%d" % n for n in range(9)]
    for window in (1, 20):
        found = Workers(losing(answers), window).in_order(bytes.strip, iter(asked))
        if ends or window > 1:
            assert list(found) == asked
        else:
            with pytest.raises(ValueError, match="too many values"):
                list(found)


@pytest.mark.parametrize(
    "batch", [b"nonsense" * 1000, packed([SweepRow(1, "x", defect=0.5)], True)]
)
def test_a_batch_that_is_none_does_not_land(
    tmp_path: Path, batch: bytes, expected: list[tuple[Any, ...]]
) -> None:
    with pytest.raises(InputError, match="/t: "):
        sweep(GRID, str(tmp_path / "t"), 20, lent(Answering(lambda *_: batch), 1))
    assert sweep(GRID, str(tmp_path / "t"), 20, serial).computed == 81
    assert rows_of(tmp_path / "t") == expected


def test_processes_that_only_die_are_given_up() -> None:
    with processes(2) as workers:
        with pytest.raises(BrokenExecutor, match="3 processes have died"):
            workers.executor.submit(os._exit, 1).result()
        assert workers.executor.submit(abs, -1).result() == 1


def test_what_fails_in_a_process_fails_here() -> None:
    with processes(2) as workers, pytest.raises(ZeroDivisionError):
        workers.executor.submit(divmod, 1, 0).result()


def precisions() -> tuple[int, int]:
    """The working precision of balls and of mpmath where this is called."""
    return ctx.prec, mpmath.mp.prec


def fail_inside(precision: int) -> None:
    """Fail where both precisions are set."""
    with ball_precision(precision), mp_precision(precision):
        raise ArithmeticError(f"at {precision} bits")


def test_precision_never_leaks_across_workers(tmp_path: Path) -> None:
    """Batches at many precisions, bad rows and errors in turn, in two processes and in this one."""
    (tmp_path / "c.csv").write_text("a,b,gamma\n1,1/2,0\nx,1,0\n1,1/2,99\n3,1/5,1e-3\n1,7,0\n")
    parts = [part for _, part in GRID.parts(9, ())]
    parts += [part for _, part in CsvFile(str(tmp_path / "c.csv")).parts(5, ())]
    calls = list(itertools.product(parts, (20, None, 3, 70)))
    here = precisions()
    with processes(2) as workers:
        submit = workers.executor.submit
        there = submit(precisions).result()
        sent = []
        for i, call in enumerate(calls):
            sent.append(submit(compute, *call))
            with pytest.raises(ArithmeticError, match="bits"):
                submit(fail_inside, 60 + i).result(HANGS)
        for call, future in zip(reversed(calls), reversed(sent), strict=True):
            assert future.result(HANGS) == compute(*call)
            with suppress(ArithmeticError):
                fail_inside(99)
        assert {submit(precisions).result(HANGS) for _ in range(8)} == {there}
    assert precisions() == here


def test_a_table_belongs_to_its_request(tmp_path: Path) -> None:
    path = str(tmp_path / "t")
    sweep(GRID, path, 5, serial)
    with pytest.raises(InputError, match="other rows or other digits"):
        sweep(GRID, path, 6, serial)
    with pytest.raises(InputError, match="other rows or other digits"):
        sweep(Grid.read("1", "1"), path, 5, serial)
    assert sweep(GRID, path, 5, serial).computed == 0


def test_a_strangers_database_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "stranger"
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("CREATE TABLE rows (x)")
        connection.commit()
    before = path.read_bytes()
    with pytest.raises(InputError, match="something else"):
        sweep(GRID, str(path), 5, serial)
    assert path.read_bytes() == before


def test_a_file_of_one_byte_is_not_replaced_by_a_table(tmp_path: Path) -> None:
    (tmp_path / "table").write_text("x")
    with pytest.raises(InputError, match="is not replaced"):
        sweep(Grid.read("1", "1/2"), str(tmp_path / "table"), 5)
    assert (tmp_path / "table").read_text() == "x"


def test_a_table_in_use_is_not_shared(tmp_path: Path) -> None:
    path = str(tmp_path / "t")
    seen: list[str] = []

    def again(_: str) -> None:
        if not seen:
            with pytest.raises(InputError) as caught:
                sweep(GRID, path, 5, serial)
            seen.append(str(caught.value))

    sweep(GRID, path, 5, serial, notice=again)
    assert "in use by another process" in seen[0]


# Export


def test_exports_say_what_the_table_says(tmp_path: Path, expected: list[tuple[Any, ...]]) -> None:
    sweep(GRID, str(tmp_path / "t"), 20, serial, export=str(tmp_path / "t.csv"))
    with open(tmp_path / "t.csv", newline="", encoding="utf-8") as file:
        header, *lines = csv.reader(file)
    assert tuple(header) == SweepRow._fields
    assert lines == [["" if x is None else str(x) for x in row] for row in expected]
    parquet = pytest.importorskip("pyarrow.parquet")
    sweep(GRID, str(tmp_path / "t"), 20, serial, export=str(tmp_path / "t.parquet"))
    table = parquet.read_table(tmp_path / "t.parquet")
    assert table.column_names == list(SweepRow._fields)
    assert [tuple(row.values()) for row in table.to_pylist()] == expected
    assert sorted(p.name for p in tmp_path.iterdir()) == ["t", "t.csv", "t.parquet"]


def test_floats_are_floats_in_parquet(tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    sweep(GRID, str(tmp_path / "t"), None, serial, export=str(tmp_path / "t.parquet"))
    table = parquet.read_table(tmp_path / "t.parquet")
    assert "radius" not in table.column_names
    found = table.column("defect_float64").to_pylist()
    assert found == [row.defect for row in float_rows_of(tmp_path / "t")]


def test_the_header_says_that_float64_is_not_certified(tmp_path: Path) -> None:
    export = tmp_path / "t.csv"
    sweep(Grid.read("1", "1/2"), str(tmp_path / "t"), None, serial, export=str(export))
    header = export.read_text().splitlines()[0].split(",")
    assert "defect_float64" in header
    assert not {"defect", "radius"} & set(header)


def test_a_table_is_a_frame_where_pandas_is(
    tmp_path: Path, expected: list[tuple[Any, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    found = sweep(GRID, str(tmp_path / "t # 1.db"), 20, serial)
    stranger = tmp_path / "other.db"
    with closing(sqlite3.connect(stranger)) as connection:
        connection.execute("CREATE TABLE rows (line INTEGER)")
    if find_spec("pandas") is None:
        with pytest.raises(InputError, match="pandas is not installed"):
            found.to_frame()
        monkeypatch.setitem(sys.modules, "pandas", SimpleNamespace(DataFrame=list))
        rows = found.to_frame()
    else:
        rows = found.to_frame().to_dict("records")
    assert [row["line"] for row in rows] == [line for line, *_ in expected]
    first = SweepRow(*expected[0])
    assert list(rows[0]) == list(SweepRow._fields)
    assert (rows[0]["defect"], rows[0]["radius"]) == (first.defect, first.radius)
    assert all(isinstance(row["realizable"], bool) for row in rows)
    for wrong, why in ((stranger, "is not the table"), (tmp_path / "no.db", "unable to open")):
        with pytest.raises(InputError, match=why):
            to_frame(str(wrong))


def test_parquet_without_pyarrow_is_refused_before_any_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InputError, match="Parquet needs pyarrow"):
        sweep(GRID, str(tmp_path / "t"), 20, serial, export=str(tmp_path / "t.parquet"))
    assert not (tmp_path / "t").exists()


def test_an_export_replaces_only_an_export(tmp_path: Path) -> None:
    (tmp_path / "in.csv").write_text("a,b\n3,1/2\n")
    (tmp_path / "letter.csv").write_text("dear,reader\n")
    (tmp_path / "letter.parquet").write_text("no table")
    source, path = CsvFile(str(tmp_path / "in.csv")), str(tmp_path / "t.csv")
    kept = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    for name in ("in.csv", "letter.csv", "t.csv", "letter.parquet"):
        with pytest.raises(InputError, match="another file"):
            sweep(source, path, 5, serial, export=str(tmp_path / name))
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == kept
    for _ in range(2):
        sweep(source, path, 5, serial, export=str(tmp_path / "out.csv"))
    assert (tmp_path / "out.csv").read_text().startswith("line,")


@pytest.mark.parametrize(
    "damage",
    cases(__file__, "rows_that_are_not_what_was_landed_are_computed_again"),
)
def test_rows_that_are_not_what_was_landed_are_computed_again(tmp_path: Path, damage: str) -> None:
    path = str(tmp_path / "t")
    sweep(GRID, path, 5, serial)
    whole = [row[: len(row) - 1] for row in rows_of(path)]
    with closing(sqlite3.connect(path)) as connection:
        connection.execute(damage)
        connection.commit()
    assert sweep(GRID, path, 5, serial).computed > 0 or "INSERT" in damage
    assert [row[: len(row) - 1] for row in rows_of(path)] == whole


def test_a_row_too_many_is_noticed(tmp_path: Path) -> None:
    path, file = str(tmp_path / "t"), tmp_path / "in.csv"
    file.write_text("a,b\n3,1/2\n\n4,1/2\n")
    sweep(CsvFile(str(file)), path, 5, serial)
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("INSERT INTO rows (line, a) VALUES (3, 'x')")
        connection.commit()
    assert sweep(CsvFile(str(file)), path, 5, serial).rows == 2


def test_a_damaged_table_is_refused_in_one_line(tmp_path: Path) -> None:
    path = tmp_path / "t"
    sweep(GRID, str(path), 20, serial)
    data = bytearray(path.read_bytes())
    data[4096:] = b"\xff" * (len(data) - 4096)
    path.write_bytes(data)
    with pytest.raises(InputError) as caught:
        sweep(GRID, str(path), 20, serial, export=str(tmp_path / "t.csv"))
    assert "\n" not in str(caught.value)


def test_what_a_killed_export_left_is_removed(tmp_path: Path) -> None:
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    (tmp_path / f"t.csv.{gone.pid}.part").write_text("half")
    (tmp_path / f"t.csv.{os.getppid()}.part").write_text("somebody writes")
    sweep(Grid.read("1", "1"), str(tmp_path / "t"), 5, serial, export=str(tmp_path / "t.csv"))
    left = sorted(p.name for p in tmp_path.glob("*.part"))
    assert left == [f"t.csv.{os.getppid()}.part"]


@pytest.mark.parametrize("name", ["t.xlsx", "nowhere/t.csv", "folder.csv"])
def test_an_export_that_cannot_be_written_is_one_line(tmp_path: Path, name: str) -> None:
    (tmp_path / "folder.csv").mkdir()
    with pytest.raises(InputError) as caught:
        sweep(Grid.read("1", "1"), str(tmp_path / "t"), 5, serial, export=str(tmp_path / name))
    assert "\n" not in str(caught.value)
    assert not list(tmp_path.glob("*.part"))


# Progress


def test_what_is_left_is_a_range_between_the_mean_and_the_latest_rate() -> None:
    progress = Progress(100_000, 10_000, lambda _: None)
    progress.computed = 30_000
    progress.latest.clear()
    progress.latest.append((progress.start + 10, 20_000))
    line = progress.line(progress.start + 20)
    # mean 1500 a second, latest 1000: 60 000 rows take 40 s to 60 s
    assert line == "40000 of 100000 rows, 1.5e+03 a second, about 40 s to 60 s left"
    assert [duration(x) for x in (0.4, 119, 120, 7300, 1e6)] == [
        "0 s", "119 s", "2 min", "2 h", "12 d",
    ]  # fmt: skip


def test_progress_is_told_as_rows_land(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Progress, "EVERY", 0.0)
    said: list[str] = []
    sweep(GRID, str(tmp_path / "t"), 20, serial, notice=said.append)
    assert said[0] == "81 rows; 17 batches of 5 to go"
    assert said[-1].startswith("81 of 81 rows")
    sweep(GRID, str(tmp_path / "t"), 20, serial, notice=said.append)
    assert said[-1] == "81 rows; 81 of them computed before; 0 batches of 5 to go"


@pytest.mark.parametrize("digits", [None, 1, 50, 1000, 10_000])
@pytest.mark.parametrize("total", [0, 1, 416, 10**6, 10**12])
def test_batches_are_bounded(total: int, digits: int | None) -> None:
    size = batch_size(total, digits)
    assert 1 <= size <= 20_000
    assert digits is None or size * digits <= 200_000


# Whole processes


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "tresym", "sweep", *words]


def environment(**more: str) -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT), **more}


def family(token: str) -> list[int]:
    """The processes whose environment holds ``token``."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if token.encode() in (folder / "environ").read_bytes():
                found.append(int(folder.name))
        except OSError:
            continue
    return found


BIG = ("--a", "0.01:100:24log", "--b", "0.02:1:20", "--gamma", "-1e-3,0", "--digits", "60")


@pytest.fixture(scope="module")
def big_rows(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[Any, ...]]:
    path = tmp_path_factory.mktemp("big") / "table"
    sweep(Grid.read(BIG[1], BIG[3], BIG[5]), str(path), 60, serial)
    return rows_of(path)


needs_proc = pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="needs /proc")


def wait_for(condition: Callable[[], Any], seconds: float = HANGS) -> Any:
    until = time.monotonic() + seconds
    while not (value := condition()):
        assert time.monotonic() < until, "waited too long"
        time.sleep(0.01)
    return value


@pytest.mark.slow
@needs_proc
@pytest.mark.parametrize("kill", range(KILLS))
def test_kill_9_loses_nothing_and_nothing_is_computed_twice(
    tmp_path: Path, kill: int, big_rows: list[tuple[Any, ...]]
) -> None:
    path, token = tmp_path / "t", f"tresym-kill-{os.getpid()}-{kill}"
    wal = tmp_path / "t-wal"
    before = 0
    for attempt in range(2):
        process = subprocess.Popen(
            command("-o", str(path), *BIG, "--workers", "2"),
            env=environment(TOKEN=token),
            stderr=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )
        # Other moments each time: after so many bytes have been written, and a little more.
        size = 4096 * (1 + 37 * kill % 50) * (1 - attempt)
        wait_for(lambda p=process, s=size: p.poll() is not None or _size(wal) > s)
        time.sleep(0.007 * (kill % 13))
        process.kill()
        process.wait(HANGS)
        wait_for(lambda: not family(token))
        with closing(sqlite3.connect(path)) as connection:
            (rows,) = connection.execute("SELECT count(*) FROM rows").fetchone()
            (sent,) = connection.execute("SELECT total(rows) FROM batches").fetchone()
        assert before <= rows == sent
        before = rows
    done = subprocess.run(
        command("-o", str(path), *BIG, "--workers", "2", "--json"),
        env=environment(),
        capture_output=True,
        check=False,
        timeout=HANGS,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["computed"] == len(big_rows) - before
    assert rows_of(path) == big_rows


def _size(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


@pytest.mark.slow
@needs_proc
@pytest.mark.parametrize("kill", range(KILLS))
def test_a_killed_worker_loses_nothing(
    tmp_path: Path, kill: int, big_rows: list[tuple[Any, ...]]
) -> None:
    path, token = tmp_path / "t", f"tresym-worker-{os.getpid()}-{kill}"
    process = subprocess.Popen(
        command("-o", str(path), *BIG, "--workers", "2"),
        env=environment(TOKEN=token),
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
    )
    size = 4096 * (37 * kill % 30)
    wait_for(lambda: _size(tmp_path / "t-wal") > size or process.poll() is not None)
    children = [
        pid for pid in family(token) if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()
    ]
    with suppress(IndexError, ProcessLookupError):  # all done already
        os.kill(children[kill % 2], signal.SIGKILL)
    _, err = process.communicate(timeout=HANGS)
    assert process.returncode == 0
    assert b"Traceback" not in err
    assert rows_of(path) == big_rows


@pytest.mark.slow
@needs_proc
@pytest.mark.parametrize("delay", [0.15, 0.35, 0.6, 0.9] if DEEP else [0.2, 0.7])
def test_ctrl_c_is_one_line_and_leaves_nobody_behind(tmp_path: Path, delay: float) -> None:
    token = f"tresym-int-{os.getpid()}-{delay}"
    process = subprocess.Popen(
        command("-o", str(tmp_path / "t"), *BIG[:-1], "2000", "--workers", "2"),
        env=environment(TOKEN=token),
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        start_new_session=True,
    )
    time.sleep(delay)
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=HANGS)
    # Before the command has begun the interpreter itself speaks, with a status of its own.
    begun = b"tresym: " in err or b"KeyboardInterrupt" not in err
    assert process.returncode in ((130, -signal.SIGINT) if begun else (130, -signal.SIGINT, 1))
    assert b"Traceback" not in err or b"tresym: " not in err
    wait_for(lambda: not family(token))


def test_the_command_in_this_process(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = str(tmp_path / "t")
    words = ["sweep", "-o", path, "--a", "1,2", "--b", "1/2", "--gamma", "-1e-3,5", "--digits", "9"]
    assert main(words) == 1
    out, err = capsys.readouterr()
    assert "4 rows, 4 of them computed now" in out
    assert "line 2: gamma: must be between" in out
    assert err.startswith("tresym: 4 rows; ")
    assert main([*words, "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["bad"] == 2


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--a", "1"], "give either --csv FILE, or --a and --b"),
        (["--csv", "x", "--a", "1"], "give either --csv"),
        (["--csv", "/nonexistent"], "no such file"),
        (["--csv", "/dev/null"], "not a regular file"),
        (["--a", "1", "--b", "x"], "b: 'x' is not a number"),
        (["--a", "1", "--b", "1", "--digits", "0"], "from 1 to 10000"),
        (["--a", "1", "--b", "1", "--digits", "5", "--float64"], "not allowed with"),
        (["--a", "1", "--b", "1", "--workers", "0"], "from 1 to 1024"),
        (["--a", "1", "--b", "1", "--workers", "٣"], "from 1 to 1024"),
        (["--a", "1", "--b", "1", "-o", "/nonexistent/t"], "unable to open"),
        (["--a", "1", "--b", "1", "-o", "/"], "unable to open"),
    ],
)
def test_bad_requests_are_one_line(
    words: list[str], says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["sweep", "-o", str(tmp_path / "t"), *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert says in err
    assert err.count("\n") == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize("where", [["-o", "/dev/full"], ["--export", "/dev/full/x.csv"]])
def test_a_full_disk_is_one_line(
    where: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["sweep", "-o", str(tmp_path / "t"), "--a", "1", "--b", "1", *where]) == 2
    assert capsys.readouterr().err.count("\n") == 1


# A real cluster


class Cluster:
    """A Dask scheduler with two worker processes, all of them in a session of their own."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, str(ROOT / "tests" / "cluster.py")],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment(),
            start_new_session=True,
        )
        assert self.process.stdout is not None
        ready, _, _ = select.select([self.process.stdout], [], [], HANGS)
        line = self.process.stdout.readline() if ready else b""
        if not line:
            self.end()
            pytest.fail("no cluster")
        self.address: str = json.loads(line)

    def end(self) -> None:
        """Ask it to end, and then end it."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(10)
        with suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait(HANGS)
        assert self.process.stdout is not None
        self.process.stdout.close()


# A new one for each of many kills: a nanny starts its worker again some ten times, not more.
@pytest.fixture(scope="function" if DEEP else "module")
def scheduler() -> Iterator[Cluster]:
    pytest.importorskip("distributed")
    found = Cluster()
    yield found
    found.end()


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_cluster_gives_the_same_rows(
    scheduler: Cluster, tmp_path: Path, expected: list[tuple[Any, ...]]
) -> None:
    path = str(tmp_path / "t")
    found = sweep(GRID, path, 20, lambda: cluster(scheduler.address))
    assert found.computed == 81
    assert rows_of(path) == expected


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_cluster_decides_claims(
    scheduler: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "claims.txt"
    wrong = "x == x + 1"
    lines = [f"(x + {k})**2 == x**2 + {2 * k}*x + {k * k}" for k in range(BATCH)] + [wrong]
    file.write_text("\n".join(lines))
    assert main(["check", "-f", str(file), "--json", "--scheduler", scheduler.address]) == 1
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [row["line"] for row in rows] == list(range(1, BATCH + 2))
    assert {row["verdict"] for row in rows[:-1]} == {"PROVED"}
    assert rows[-1]["verdict"] == "REFUTED"


def test_answers_come_in_order_and_few_are_under_way() -> None:
    asked: list[int] = []

    def arguments() -> Iterator[bytes]:
        for k in range(10):
            asked.append(k)
            yield bytes([k])

    found = Workers(Here(), 3).in_order(lambda each: each + each, arguments())
    assert next(found) == b"\0\0"
    assert len(asked) == 4
    assert list(found) == [bytes([k, k]) for k in range(1, 10)]


def test_answers_that_nobody_works_at_are_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tresym.sweep.workers.PATIENCE", 0.01)
    with pytest.raises(InputError, match="nobody is left"):
        next(Workers(Silent(), 3, nobody).in_order(bytes, iter([b""])))


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize("kill", range(KILLS))
def test_a_killed_cluster_worker_loses_nothing(
    kill: int, scheduler: Cluster, tmp_path: Path, big_rows: list[tuple[Any, ...]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    killed: list[int] = []

    def shoot(text: str) -> None:
        if " left" in text and not killed:
            killed.append(workers[kill % 2])
            os.kill(killed[0], signal.SIGKILL)

    # A nanny starts another one for each that was killed before.
    wait_for(lambda: len(children_of(scheduler.process.pid)) == 2)
    workers = children_of(scheduler.process.pid)
    monkeypatch.setattr(Progress, "EVERY", 0.0)
    grid = Grid.read(BIG[1], BIG[3], BIG[5])
    sweep(grid, str(tmp_path / "t"), 60, lambda: cluster(scheduler.address), notice=shoot)
    assert killed
    assert rows_of(tmp_path / "t") == big_rows


def children_of(session: int) -> list[int]:
    """The worker processes of the session that ``session`` leads."""
    return sorted(
        int(path.name)
        for path in Path("/proc").glob("[0-9]*")
        if _session(path) == session and b"spawn_main" in (path / "cmdline").read_bytes()
    )


def _session(path: Path) -> int:
    try:
        return os.getsid(int(path.name))
    except OSError:
        return -1


@pytest.mark.slow
@pytest.mark.skipif(not DEEP, reason="starts a cluster of its own; the watch is tested below")
@pytest.mark.filterwarnings("default")
def test_a_cluster_that_dies_is_one_line_and_the_rest_is_computed_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, big_rows: list[tuple[Any, ...]]
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("tresym.sweep.workers.PATIENCE", 2)
    monkeypatch.setattr(Progress, "EVERY", 0.0)
    doomed, grid = Cluster(), Grid.read(BIG[1], BIG[3], BIG[5])
    path = str(tmp_path / "t")

    def shoot(text: str) -> None:
        if " left" in text:
            with suppress(ProcessLookupError):
                os.killpg(doomed.process.pid, signal.SIGKILL)

    try:
        with pytest.raises(InputError, match="cluster: the scheduler or its workers are lost"):
            sweep(grid, path, 60, lambda: cluster(doomed.address), notice=shoot)
    finally:
        doomed.end()
    landed = len(rows_of(path))
    assert 0 < landed < len(big_rows)
    assert sweep(grid, path, 60, serial).computed == len(big_rows) - landed
    assert rows_of(path) == big_rows


def test_workers_that_are_gone_end_the_wait(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An executor that never answers is asked whether anybody is left."""
    monkeypatch.setattr("tresym.sweep.workers.PATIENCE", 0.01)
    with pytest.raises(InputError, match="nobody is left"):
        sweep(GRID, str(tmp_path / "t"), 20, lent(Silent(), 2, nobody))


IMPATIENT = (
    "import sys; from tresym.sweep import workers; workers.PATIENCE = 1;"
    "from tresym.commands import main; sys.exit(main())"
)


@pytest.mark.slow
@pytest.mark.parametrize("greeting", [b"", b"SSH-2.0-OpenSSH_9.2\r\n"])
def test_a_listener_that_is_no_scheduler_is_one_line(greeting: bytes, tmp_path: Path) -> None:
    """It takes the call and never says a word, or one that is not Dask's; the process ends."""
    pytest.importorskip("distributed")
    with socket.create_server(("127.0.0.1", 0)) as other, ThreadPoolExecutor(1) as waiter:
        talk = waiter.submit(_greet, other, greeting)
        address = f"tcp://127.0.0.1:{other.getsockname()[1]}"
        done = subprocess.run(
            [sys.executable, "-c", IMPATIENT, "sweep", "-o", str(tmp_path / "t"), "--a", "1",
             "--b", "1", "--dask", address],
            env=environment(),
            capture_output=True,
            check=False,
            timeout=HANGS,
        )  # fmt: skip
        talk.result(HANGS)
    assert done.returncode == 2
    assert b"cluster: no scheduler answers" in done.stderr
    assert b"Traceback" not in done.stderr


def _greet(server: socket.socket, greeting: bytes) -> None:
    """Answer the call, and keep the line open until the caller hangs up."""
    server.settimeout(HANGS)
    line, _ = server.accept()
    with line, suppress(OSError):
        line.settimeout(HANGS)
        line.sendall(greeting)
        while line.recv(4096):
            pass


@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize(
    "address",
    ["tcp://127.0.0.1:1", "nonsense", "", "tcp://", "tcp://h:99999", "tcp://[::1", "inproc://h:1"],
)
def test_an_unreachable_scheduler_is_one_line(
    address: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("tresym.sweep.workers.PATIENCE", 1)
    words = ["sweep", "-o", str(tmp_path / "t"), "--a", "1", "--b", "1", "--dask", address]
    assert main(words) == 2
    assert "cluster: no scheduler answers" in capsys.readouterr().err


def test_no_dask_is_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    words = ["sweep", "-o", str(tmp_path / "t"), "--a", "1", "--b", "1", "--dask", "tcp://h:1"]
    assert main(words) == 2
    assert "needs Dask" in capsys.readouterr().err


def test_processes_of_one_is_this_process() -> None:
    with processes(1) as workers:
        assert workers.executor.submit(os.getpid).result() == os.getpid()


def test_dask_logs_nothing_while_it_leads(caplog: pytest.LogCaptureFixture) -> None:
    log = logging.getLogger("distributed.client")
    with _unheard():
        log.error("a traceback")
    assert not caplog.records
    log.error("another")
    assert [record.message for record in caplog.records] in ([], ["another"])
    assert not log.disabled
