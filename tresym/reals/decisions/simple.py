"""Points with small numbers in the conditions: of witnesses, those that are read with ease."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice, product

from flint import fmpq

from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.conditions import Given

SIMPLE = (*map(fmpq, (2, -1, 3, -2, 1, 5)), fmpq(1, 2), fmpq(-3, 2), fmpq(1, 3))
MOST_TRIED = 500


def simple_points(names: Sequence[str], given: Given, count: int) -> list[dict[str, fmpq]]:
    """At most ``count`` points at which every condition is shown to hold, strictly."""
    found = []
    with ball_precision():
        for values in islice(product(SIMPLE, repeat=len(names)), MOST_TRIED):
            at = dict(zip(names, values, strict=True))
            if given.names <= at.keys() and all(c.holds(at) for c in given.conditions):
                found.append(at)
                if len(found) == count:
                    return found
    return found or list(given.points(names, count))
