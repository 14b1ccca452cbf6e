"""The benchmark's machinery, its contenders' answers and its saved data; no test reads a clock."""

import json
import math
from importlib.util import find_spec
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from flint import arb, fmpq

from tresym.commands import bench as show
from tresym.commands import main
from tresym.dev.bench import (
    flipmap,
    honesty,
    identities,
    many,
    peers,
    precision,
    scaling,
    separatrix,
    turn,
    workloads,
)
from tresym.dev.bench.names import MODULES, WORKLOADS
from tresym.dev.bench.run import (
    Contender,
    Judged,
    Measurement,
    Pace,
    Rising,
    Timing,
    TooSlowError,
    interleave,
)
from tresym.dev.bench.truth import by_digits, true_digits
from tresym.racket.flip import asymptotic
from tresym.racket.flip.model_selection import climb
from tresym.racket.flip.separatrix import solve
from tresym.racket.floats.shapes import defects
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp
from tresym.reals.verdict import Verdict
from tresym.report.charts import CHARTS

QUICK = Pace(rounds=1, limit=20.0, patience=0.01)
SAVED = Path(__file__).resolve().parents[3] / "docs" / "measurements"
NOISE = 1.2
"""A model counts as faster only where it takes less than 1/1.2 of the time: what one run's medians
scatter by on a machine that others use too."""


def contender(name: str, work, judge=lambda _: Judged(), **options) -> Contender:
    return Contender("a scene", name, work, judge, **options)


# The run


def test_every_contender_is_sampled_once_a_round_in_turning_order() -> None:
    seen: list[str] = []

    def sample(name: str) -> float:
        seen.append(name)
        return float(len(seen))

    makers = [contender(n, lambda: None, sample=lambda n=n: sample(n)) for n in "xyz"]
    timings, complete = interleave(makers, Pace(rounds=3))
    assert complete
    assert "".join(seen) == "xyz" + "yzx" + "zxy"
    assert [t.seconds for t in timings] == [[1, 6, 8], [2, 4, 9], [3, 5, 7]]


def test_ratios_are_taken_round_by_round() -> None:
    slow = Timing(contender("slow", None), Judged(50.0), [4.0, 40.0, 6.0])
    fast = Timing(contender("fast", None), Judged(), [2.0, 20.0, 1.0])
    assert slow.ratio(fast) == 2.0
    found = Measurement("trial", "two contenders", [slow, fast], "fast")
    assert [row["ratio"] for row in found.as_json()["rows"]] == [2.0, 1.0]
    assert "2 x" in workloads.measurement_text(found)


def test_what_fails_is_wrong_or_takes_too_long_stays_with_its_reason() -> None:
    def forever() -> None:
        while True:
            pass

    def fails() -> None:
        raise ValueError("no root in   sight")

    makers = [
        contender("loops", forever),
        contender("fails", fails),
        contender("lies", lambda: 3.14, by_digits(arb.pi(), 10)),
        contender("works", lambda: math.pi, by_digits(arb.pi(), 15), ours=True),
    ]
    timings, _ = interleave(makers, Pace(rounds=2, limit=0.05))
    rows = Measurement("trial", "", timings, "works").as_json()["rows"]
    assert [row["outcome"] for row in rows] == ["timed out", "failed", "wrong", "right"]
    assert [row["seconds"] is None for row in rows] == [True, True, False, False]
    assert rows[0]["why"] == "more than 0.05 s of processor time"
    assert rows[1]["why"] == "ValueError: no root in sight"
    assert rows[2]["why"] == "3.3 true digits of the 10 asked for"
    text = workloads.measurement_text(Measurement("trial", "", timings, "works"))
    assert "timed out: more than" in text


def test_a_contender_that_fails_later_keeps_its_samples_and_says_why() -> None:
    answers = iter([1.0, 2.0])
    makers = [contender("x", lambda: None, sample=lambda: next(answers))]
    timings, complete = interleave(makers, Pace(rounds=5))
    assert complete
    assert timings[0].seconds == [1.0, 2.0]
    assert timings[0].judged.outcome == "failed"
    assert timings[0].judged.why == "StopIteration"


def test_an_interrupt_ends_the_run_with_what_was_measured() -> None:
    calls = iter([1.0, 2.0, KeyboardInterrupt()])

    def sample() -> float:
        value = next(calls)
        if isinstance(value, BaseException):
            raise value
        return value

    timings, complete = interleave([contender("x", lambda: None, sample=sample)], Pace(rounds=9))
    assert not complete
    assert timings[0].seconds == [1.0, 2.0]


def test_after_what_is_too_slow_nothing_larger_is_tried() -> None:
    rising = Rising()

    def work(size: int) -> int:
        if size == 2:
            raise TimeUp
        return size

    assert rising.work(work, 1)() == 1
    with pytest.raises(TimeUp):
        rising.work(work, 2)()
    with pytest.raises(TooSlowError, match="too slow at 2 already"):
        rising.work(work, 3)()
    assert rising.work(work, 1)() == 1


# True digits


def test_digits_are_counted_in_every_arithmetic() -> None:
    with ball_precision(400):
        third = arb(1) / 3
    assert 15.5 < true_digits(1 / 3, third) < 17.5
    with mp_precision(60) as mp:
        assert 59 < true_digits(mp.mpf(1) / 3, third) < 62
        assert true_digits(-mp.mpf(1) / 3, third) == 0
    assert true_digits(fmpq(3, 2**70), arb(3) / 2**70, most=77.0) == 77.0
    assert true_digits(math.nan, third) == 0
    assert true_digits(1j, third) == 0
    assert true_digits(0.0, arb(0)) > 1000
    assert true_digits(1e-300, arb(0)) == 0


# What is saved


def test_samples_are_kept_while_a_workload_runs(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(workloads, "KEEP_EVERY", -1.0)
    keep = workloads.keeper("turn", tmp_path)
    timing = Timing(contender("x", None), Judged(), [1.0])
    keep([timing])
    partial = json.loads((tmp_path / "turn.partial.json").read_text())
    assert partial["complete"] is False
    assert partial["rows"][0]["seconds"] == 1.0
    finished = Measurement("turn", "", [timing])
    assert workloads.save(finished, tmp_path) == "docs/measurements/turn.json"
    assert [path.name for path in tmp_path.iterdir()] == ["turn.json"]
    assert json.loads((tmp_path / "turn.json").read_text()) == finished.as_json()


def test_an_interrupted_run_leaves_the_finished_one_alone(tmp_path: Path) -> None:
    workloads.save(Measurement("turn", "whole", []), tmp_path)
    workloads.save(Measurement("turn", "part", [], complete=False), tmp_path)
    assert json.loads((tmp_path / "turn.json").read_text())["says"] == "whole"
    assert json.loads((tmp_path / "turn.partial.json").read_text())["says"] == "part"


def test_the_command_stops_after_an_interrupted_workload(monkeypatch, capsys) -> None:
    ran = []

    def measure(name: str, keep) -> Measurement:
        ran.append(name)
        return Measurement(name, "says", [], complete=False)

    monkeypatch.setattr(workloads, "measure", measure)
    assert show.run_all(["turn", "defect"], False, False, None) == 130
    assert ran == ["turn"]
    assert "interrupted" in capsys.readouterr().out


@pytest.mark.parametrize("name", WORKLOADS)
def test_every_workload_has_its_module(name: str) -> None:
    assert find_spec(MODULES[name]) is not None


def test_unknown_workloads_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(InputError, match="workload: 'x' is not known"):
        workloads.measure("x")
    assert main(["bench", "turn", "x"]) == 2
    assert capsys.readouterr().err.startswith("tresym: workload: 'x' is unknown")


def test_help_lists_every_workload(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["bench", "--help"])
    shown = capsys.readouterr().out
    assert all(f"\n  {name} " in shown for name in WORKLOADS)


MEASURED = {name for name in WORKLOADS if (SAVED / f"{name}.json").exists()}
"""What `tresym bench` has saved; what other scripts found is saved beside it."""


def test_what_the_charts_are_drawn_from_is_saved() -> None:
    assert {chart.workload for chart in CHARTS.values()} <= MEASURED


@pytest.mark.parametrize("name", sorted(MEASURED))
def test_every_saved_workload_is_whole_and_has_its_reasons(name: str) -> None:
    data = json.loads((SAVED / f"{name}.json").read_text(encoding="utf-8"))
    assert data["workload"] == name
    assert data["complete"]
    assert data["versions"]["python-flint"]
    for row in data["rows"]:
        assert row["outcome"] in ("right", "wrong", "timed out", "failed")
        if row["outcome"] != "right":
            assert row["why"]
            assert not (row["ours"] and row["outcome"] == "wrong")
        if row["seconds"] is not None:
            assert row["quartiles"][0] <= row["seconds"] <= row["quartiles"][1]


# No model of ours is both faster and as accurate as the one that the ladder takes


def precision_rows() -> dict:
    data = json.loads((SAVED / "precision.json").read_text(encoding="utf-8"))
    rows = [r for r in data["rows"] if r["method"].startswith("tresym, ") and r["seconds"]]
    return {"picks": data["notes"]["picks"], "rows": rows}


@pytest.mark.parametrize("scene", [s.name for s in precision.SCENES])
def test_no_model_beats_the_pick_of_the_ladder(scene: str) -> None:
    data = precision_rows()
    rows = [r for r in data["rows"] if r["scene"] == scene and "float64" not in r["method"]]
    for digits, model in data["picks"][scene].items():
        asked = int(digits)
        pick = next(r for r in rows if (r["method"], r["asked"]) == (f"tresym, {model}", asked))
        assert pick["outcome"] == "right"
        others = [r for r in rows if r["method"] != pick["method"]]
        enough = [r for r in others if min(r["digits"], r["asked"]) >= asked]
        faster = [r["method"] for r in enough if r["seconds"] * NOISE < pick["seconds"]]
        assert faster == [], f"{scene}, {digits} digits"


def test_the_saved_picks_are_what_the_ladder_takes_today() -> None:
    assert {"picks": precision_rows()["picks"]} == precision.picks()


def test_the_ladder_asks_the_closed_formula_only_where_it_reaches() -> None:
    for scene in precision.SCENES:
        if scene.gamma != 0:
            continue
        for digits in (1, 2, 3, 4, 6, 10, 16, 25, 35):
            try:
                climb(scene.shape, 0, digits, "asymptotic")
                answers = True
            except InputError:
                answers = False
            assert (climb(scene.shape, 0, digits).model == "asymptotic") == answers


def test_the_constant_of_the_closed_formula_is_an_upper_bound() -> None:
    with ball_precision(200):
        quarter = arb.pi() / 2
        K = ((4 / arb.pi()).log() - arb.pi() ** 2 / 48) / quarter**4
        assert K < asymptotic.LARGEST_K < K * arb("1.001")


# The contenders' answers


@pytest.mark.parametrize("name", separatrix.WORK)
def test_every_contender_finds_all_fifty_digits(name: str) -> None:
    shape = separatrix.named_body(separatrix.BODY).shape
    assert separatrix.digits_at(separatrix.WORK[name], shape) >= 49


def test_ours_is_correct_on_every_shape_and_the_printed_equation_is_not() -> None:
    shapes = honesty.SHAPES
    assert len(shapes) == 75
    ours = [separatrix.digits_at(separatrix.certified, shape) for shape in shapes]
    assert min(ours) >= 49
    printed = [separatrix.digits_at(peers.findroot_printed, shape) for shape in shapes[::5]]
    assert sum(d < 45 for d in printed) >= 3


@pytest.mark.slow
def test_the_separatrix_runs_in_its_processes() -> None:
    found = workloads.measure("separatrix", pace=Pace(rounds=2, patience=1.0)).as_json()
    assert {row["outcome"] for row in found["rows"]} == {"right"}
    assert json.loads(json.dumps(found)) == found


def test_arrays_of_shapes_have_float64_accuracy() -> None:
    rng = np.random.default_rng(5)
    a, b = 10 ** rng.uniform(-8, 4, 300), 10 ** rng.uniform(-8, 0, 300)
    for p, q, value in zip(a.tolist(), b.tolist(), defects(a, b).tolist(), strict=True):
        time = math.pi * math.sqrt(p * q)
        if time < 600:
            (shape,) = many.exact(np.array([p]), np.array([q]))
            error = 10 ** -true_digits(value, solve(*shape, 25).defect)
            assert error < 1e-15 * (1 + time)
    assert np.isnan(defects([-1, 1, 1], [0.5, 0, 1.5])).all()
    assert defects(1e-3, [[1e-3], [1e-2]]).shape == (2, 1)


def test_the_scipy_routes_over_arrays_agree_on_a_tame_shape() -> None:
    a, b = np.array([2.0, 12.5]), np.array([0.5, 0.06])
    for method, _ in many.METHODS.values():
        assert method(a, b) == pytest.approx(defects(a, b), rel=1e-10)


def test_every_start_of_the_flip_map_agrees_with_the_ball() -> None:
    a, b, _ = peers.floats(flipmap.BODIES["standard racket"], fmpq(0))
    truths = [flipmap.ball_flip(a, b, *s) for s in zip(*flipmap.starts(4), strict=True)]
    assert flipmap.judged(truths, flipmap.flipmap.flip_map(a, b, *flipmap.starts(4))).digits > 13
    coarse = flipmap.by_scipy("RK45", 1e-3)(a, b, *flipmap.starts(4))
    assert flipmap.judged(truths, coarse).outcome == "wrong"


def test_heyoka_agrees_with_the_ball() -> None:
    pytest.importorskip("heyoka")
    a, b, _ = peers.floats(flipmap.BODIES["standard racket"], fmpq(0))
    truths = [flipmap.ball_flip(a, b, *s) for s in zip(*flipmap.starts(8), strict=True)]
    for method in (flipmap.by_heyoka, flipmap.by_heyoka_batch):
        assert flipmap.judged(truths, method(a, b, *flipmap.starts(8))).digits > 12


def test_the_integral_is_right_on_both_our_routes_and_wrong_by_quad_at_the_turning_point() -> None:
    tried = (turn.OURS, "tresym, FLINT's R_F and R_J", "mpmath quad, tanh-sinh")
    scene = "γ = -1/1000, at the turning point"
    found = [c for c in turn.contenders() if c.scene == scene and c.method in tried]
    rows = {c.method: c.judge(c.work()) for c in found}
    assert rows[turn.OURS].digits >= 50
    assert rows["tresym, FLINT's R_F and R_J"].digits >= 50
    assert rows["mpmath quad, tanh-sinh"].outcome == "wrong"


def test_identities_of_the_ledger_and_their_false_variants() -> None:
    some = [identity for pair in islice(identities.pairs(), 6) for identity in pair]
    assert {identity.true for identity in some} == {True, False}
    for identity in some:
        verdict = identities._verdict(identity.left, identity.right, identity.given)
        assert verdict is (Verdict.PROVED if identity.true else Verdict.REFUTED)
    false = next(identity for identity in some if not identity.true)
    assert identities._judge(false, identities.OURS, Verdict.PROVED).outcome == "wrong"
    assert identities._judge(false, "sympy equals", True).outcome == "wrong"
    assert identities._judge(false, "sympy simplify", False).outcome == "right"


@pytest.mark.night
def test_a_claim_beyond_the_truth_is_seen_in_the_honesty_data() -> None:
    points = {p["where"]: p for p in honesty._quadratures() if p["method"] == "scipy quad"}
    assert all(p["claims"] <= p["digits"] + 0.5 for p in points.values())
    balls = [honesty.point("x", "y", 70, 80), honesty.point("x", "y", -1, math.inf)]
    assert balls[0] == {"method": "x", "where": "y", "claims": 60.0, "digits": 60.0}
    assert balls[1]["claims"] == 0


def test_the_memory_of_the_flip_map_is_that_of_a_piece() -> None:
    scaling.peak(scaling.PIECE)  # what is loaded once does not count
    one, three = scaling.peak(scaling.PIECE), scaling.peak(3 * scaling.PIECE)
    assert three < 1.2 * one


def test_the_first_run_of_a_workload_can_be_short() -> None:
    timings, complete = interleave(list(turn.contenders())[:2], QUICK)
    assert complete
    assert all(t.seconds for t in timings)
