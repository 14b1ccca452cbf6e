"""Values that are computed on first use and cached."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import count, islice
from typing import Generic, TypeVar

T = TypeVar("T")


class Kept(Generic[T]):
    """What an iterator gives, as often as it is asked for, made once and no further than asked."""

    def __init__(self, make: Callable[[], Iterator[T]]) -> None:
        """``make`` starts the iterator, which always gives the same; again after an exception."""
        self._make, self._source = make, make()
        self._kept: list[T] = []

    def __iter__(self) -> Iterator[T]:
        """All of it, from the start."""
        for n in count():
            if n == len(self._kept):
                try:
                    self._kept.append(next(self._source))
                except StopIteration:
                    return
                except BaseException:  # as a time limit: what was cut short has not ended
                    self._source = islice(self._make(), n, None)
                    raise
            yield self._kept[n]

    def first(self, n: int) -> Iterable[T]:
        """At most ``n`` of it."""
        return islice(self, n)
