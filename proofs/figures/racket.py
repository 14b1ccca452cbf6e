"""The shape of the drawn racket in its own axes: the handle along e₁, the head in (e₁, e₂)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tresym.racket.floats.flipmap import Floats


class Racket(NamedTuple):
    """Points by coordinates along e₁, e₂, e₃: the two ends of the handle, the rim, the strings."""

    handle: Floats
    rim: Floats
    strings: Floats


def racket(points: int = 73) -> Racket:
    """Return a racket of length 2 with its head towards +e₁; ``strings`` has shape (n, 2, 3)."""
    centre, long, wide = 0.62, 0.42, 0.32
    u = np.linspace(0.0, 2 * np.pi, points)
    zero = np.zeros_like(u)
    rim = np.stack([centre + long * np.cos(u), wide * np.sin(u), zero], axis=-1)
    strings = []
    for t in (-0.66, -0.33, 0.0, 0.33, 0.66):
        half = np.sqrt(1 - t * t)
        strings.append([[centre - long * half, wide * t, 0], [centre + long * half, wide * t, 0]])
        strings.append([[centre + long * t, -wide * half, 0], [centre + long * t, wide * half, 0]])
    handle = np.array([[-0.95, 0.0, 0.0], [centre - long, 0.0, 0.0]])
    return Racket(handle, rim, np.array(strings))
