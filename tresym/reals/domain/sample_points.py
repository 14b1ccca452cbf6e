"""Choose exact sample points in a box, in a fixed pseudo-random order."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from tresym.reals.numbers.exact import Interval, near

ExactPoint = dict[str, fmpq]
Range = Interval

LONG = 10**18
LISTED = 36


_UNIT = [
    fmpq(*pair)
    for pair in (
        *((3, 7), (5, 8), (2, 9), (7, 9), (1, 3), (8, 13), (1, 17), (15, 16), (4, 9)),
        *((1, 1000), (999, 1000), (6, 11), (1, 2), (2, 3), (10**6 - 1, 10**6), (1, 10**6)),
    )
]
"""The relative positions of samples in a bounded range: central ones first, the ends last."""
_RAY = [
    fmpq(*pair)
    for pair in (
        *((5, 7), (3, 8), (13, 6), (1, 4), (9, 8), (29, 9), (1, 19), (17, 3), (11, 12)),
        *((1, 900), (100, 7), (1, 2), (2, 1), (1, 1), (1000, 3), (1, 10**6)),
    )
]
"""The distances of samples from the end of an unbounded range."""


def _hash(k: int, j: int) -> int:
    """Return a 32-bit hash of two integers."""
    h = (k * 2654435761 + j * 2246822519 + 374761393) & 0xFFFFFFFF
    h = ((h ^ (h >> 15)) * 2246822519) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 3266489917) & 0xFFFFFFFF
    return h ^ (h >> 16)


def _sample(where: Interval, k: int, j: int) -> fmpq:
    """Return the ``k``-th sample value of the ``j``-th symbol, inside its range."""
    h = _hash(k, j)
    pool = 5 if k < 6 else 9 if k < 20 else 16
    low, high = where.low, where.high
    anywhere = fmpq(1 + (h >> 12) % 9973, 9974)  # late samples do not come from the lists
    if k >= LISTED and (k + j) % 4 == 0:
        low, high = _beside_zero(low, high, h % 2 == 0)
    if low is not None and high is not None:
        if k >= LISTED:
            return low + (high - low) * anywhere
        nudge = fmpq(1, 1009 + h % 97) if k else fmpq(0)
        r = _UNIT[h % pool if k < 20 or j else (k - 20) % 16]
        return _simple(low + (high - low) * (r + (1 - r) * r * nudge), low, high)
    x = _RAY[h % pool] * (1 + (anywhere if k >= LISTED else fmpq(1, 97 + h % 89)))
    if low is not None:
        return low + x
    if high is not None:
        return high - x
    alternating = (k + j) % 2 == 1 if k < 2 else k == 3
    negative = alternating if k < 4 else (h >> 8) % 2 == 1
    return -x if negative else x


def _beside_zero(
    low: fmpq | None, high: fmpq | None, below: bool
) -> tuple[fmpq | None, fmpq | None]:
    """Return the part of a range on one side of 0, which may be short compared with the other."""
    if low is not None and low < 0 and (high is None or (below and high > 0)):
        return low, fmpq(0)
    if high is not None and high > 0 and (low is None or (not below and low < 0)):
        return fmpq(0), high
    return low, high


def _simple(x: fmpq, low: fmpq, high: fmpq) -> fmpq:
    """Return a simpler rational near ``x`` if ``x`` is long, as at ends that stand for irrational
    constants.
    """
    if x.q < LONG:
        return x
    gap = max(min(x - low, high - x), fmpq(0)) / 16  # a range may be empty
    return near(x, gap)


def corners(names: list[str], box: dict[str, Interval]) -> Iterator[dict[str, fmpq]]:
    """Yield points some of whose symbols are at closed ends of their ranges."""
    choices = []
    for name in names:
        where = box.get(name, Interval())
        ends = []
        if where.low is not None and not where.low_open:
            ends.append(where.low)
        if where.high is not None and not where.high_open:
            ends.append(where.high)
        choices.append([*ends, fmpq(0), fmpq(1), _sample(where, 0, 0)])
    for k in range(200):
        point = {}
        for name, choice in zip(names, choices, strict=True):
            point[name] = choice[k % len(choice)]
            k //= len(choice)
        yield point
