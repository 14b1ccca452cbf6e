"""The float64 flip map compiled by numba, one start at a time.

numba is installed by the extra ``tresym[fast]``. Compiled functions are stored in numba's cache, so
that they are compiled only once. They release Python's global lock.
"""

from __future__ import annotations

from typing import Any

import numba
from numba.extending import overload, register_jitable

from tresym.racket.floats import float_orbit


@overload(float_orbit.largest)
@overload(float_orbit.least)
def _itself(x: Any) -> Any:
    def number(x: Any) -> Any:
        return x

    return number


@overload(float_orbit.choose)
def _either(condition: Any, x: Any, y: Any) -> Any:
    def number(condition: Any, x: Any, y: Any) -> Any:
        return x if condition else y

    return number


PARTS = (
    "orbit",
    "entries",
    "place",
    "spent",
    "of_fast_rotation",
    "arrival",
    "depart",
    "travel",
    "linear",
    "turn",
)

for part in PARTS:
    register_jitable(error_model="numpy")(getattr(float_orbit, part))

turn_each = numba.njit(error_model="numpy", nogil=True, cache=True)(float_orbit.turn_each)
