"""Values that are computed on first use and cached."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import count, islice
from typing import Generic, TypeVar

T = TypeVar("T")


class Kept(Generic[T]):
    """The items of an iterator, cached: each is computed once, and only when it is needed."""

    def __init__(self, make: Callable[[], Iterator[T]]) -> None:
        """Store ``make``, which starts the iterator and is called again after an exception.

        Every call of ``make`` must produce the same items.
        """
        self._make, self._source = make, make()
        self._kept: list[T] = []

    def __iter__(self) -> Iterator[T]:
        """Yield all items from the first one."""
        for n in count():
            if n == len(self._kept):
                try:
                    self._kept.append(next(self._source))
                except StopIteration:
                    return
                except BaseException:  # such as a time limit: restart after the cached items
                    self._source = islice(self._make(), n, None)
                    raise
            yield self._kept[n]

    def first(self, n: int) -> Iterable[T]:
        """Return an iterator over at most ``n`` items."""
        return islice(self, n)
