"""The benchmark's machinery and its contenders' answers; nothing here looks at a clock."""

from __future__ import annotations

import json

import pytest

from tresym.bench import separatrix
from tresym.bench.run import Contender, Measurement, Timing, interleave
from tresym.bench.workloads import measure, measurement_text
from tresym.cli import main
from tresym.exact import InputError


def test_every_contender_is_sampled_once_a_round_in_turning_order() -> None:
    seen: list[str] = []

    def sample(name: str) -> float:
        seen.append(name)
        return float(len(seen))

    names = ("x", "y", "z")
    timings = interleave([Contender(n, lambda n=n: sample(n)) for n in names], 3)
    assert "".join(seen) == "xyz" + "xyz" + "yzx" + "zxy"
    assert [t.seconds for t in timings] == [[4, 9, 11], [5, 7, 12], [6, 8, 10]]


def test_ratios_are_taken_round_by_round() -> None:
    slow, fast = Timing("slow", [4.0, 40.0, 6.0], 50), Timing("fast", [2.0, 20.0, 1.0], None)
    assert slow.ratio(fast) == 2.0
    measurement = Measurement("trial", "two contenders", 3, [slow, fast], "fast")
    found = measurement.as_json()
    assert [t["ratio"] for t in found["timings"]] == [2.0, 1.0]
    assert "2 x" in measurement_text(measurement)


@pytest.mark.parametrize("name", separatrix.WORK)
def test_every_contender_finds_all_fifty_digits(name: str) -> None:
    assert separatrix.digits_of(separatrix.WORK[name]()) == separatrix.DIGITS


@pytest.mark.slow
def test_the_workload_runs_in_its_processes() -> None:
    found = separatrix.measure(rounds=2).as_json()
    assert found["reference"] == "tresym, certified"
    assert {t["digits"] for t in found["timings"]} == {50}
    assert json.loads(json.dumps(found)) == found


def test_unknown_workloads_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(InputError, match="workload: 'x' is not known"):
        measure("x")
    assert main(["bench", "x"]) == 2
    assert capsys.readouterr().err.startswith("tresym: workload: 'x' is not known")
