"""Operations are counted as they are done, and what counts gives the same answers."""

from flint import arb, fmpq

from tresym.racket.comparison.operation_counts import Counted, Counting, map_operations, turn_calls


def test_each_operation_counts_once() -> None:
    made: list[str] = []
    x = Counted(arb(2), made)
    found = 1 / Counting.sqrt(x * x - 1) + x
    assert found.ball.overlaps(1 / arb(3).sqrt() + 2)
    assert made == ["mul", "sub", "sqrt", "truediv", "add"]
    assert abs(x) > 1
    assert made[5:] == ["abs", "gt"]


def test_fewer_steps_are_taken_next_to_the_separatrix() -> None:
    calls = [turn_calls(fmpq(1, 10) ** n) for n in (2, 4, 8, 16, 30)]
    assert calls == sorted(calls, reverse=True)
    assert turn_calls(fmpq(0)) == calls[-1] < 50 < 100 < calls[0]


def test_the_map_takes_under_a_thousand() -> None:
    assert 500 < map_operations() < 1000
