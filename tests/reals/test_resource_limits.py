"""A limit on processor time: it is kept, lifted after the block, and the outer one holds."""

import gc

import pytest

from tresym.reals.resource_limits import TimeUp, collecting_seldom, time_limit


def test_the_limit_is_lifted_after_the_block() -> None:
    def forever() -> None:
        with time_limit(0.02):
            while True:
                pass

    with pytest.raises(TimeUp):
        forever()
    with time_limit(30):
        sum(range(1000))


def test_within_a_limit_the_outer_one_holds() -> None:
    def forever() -> None:
        with time_limit(0.02), time_limit(0.001, KeyError):
            while True:
                pass

    with pytest.raises(TimeUp):
        forever()


def test_memory_is_searched_as_before_behind_it() -> None:
    before = gc.get_threshold()
    with collecting_seldom(20_000):
        assert gc.get_threshold()[0] == max(20_000, before[0])
        with collecting_seldom(1_000):
            assert gc.get_threshold()[0] == max(20_000, before[0])
    assert gc.get_threshold() == before


def test_what_is_never_searched_stays_so() -> None:
    before = gc.get_threshold()
    try:
        gc.set_threshold(0)
        with collecting_seldom(20_000):
            assert gc.get_threshold()[0] == 0
    finally:
        gc.set_threshold(*before)
