"""A limit on processor time: it is kept, lifted after the block, and the outer one holds."""

import pytest

from tresym.reals.limit import TimeUp, time_limit


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
