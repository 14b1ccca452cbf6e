"""What is kept is made once, and what an exception cut short goes on where it was."""

from collections.abc import Iterator

import pytest

from tresym.reals.computed_once import Kept


def test_what_is_kept_is_made_once_and_no_further_than_asked() -> None:
    made: list[int] = []

    def numbers() -> Iterator[int]:
        for n in range(5):
            made.append(n)
            yield n

    kept = Kept(numbers)
    assert not made
    assert [*kept.first(2)] == [0, 1] == made
    assert [*kept] == [*kept] == made == [0, 1, 2, 3, 4]


def test_what_an_exception_cut_short_has_not_ended() -> None:
    starts = 0

    def numbers() -> Iterator[int]:
        nonlocal starts
        starts += 1
        yield from (1, 2)
        if starts == 1:
            raise KeyboardInterrupt
        yield 3

    kept = Kept(numbers)
    with pytest.raises(KeyboardInterrupt):
        list(kept)
    assert [*kept] == [1, 2, 3]
