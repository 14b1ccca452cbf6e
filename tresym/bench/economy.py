"""Model no more than the scene needs: what each table cell and figure panel takes, and what more
would cost.

A scene asks for digits: those the paper prints, those our tables show, or those a pixel shows. It
takes the lowest rung that has them; the same is timed on the next heavier rung.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq

from tresym.bench import peers
from tresym.bench.run import Contender, Keep, Measurement, Pace, forget, interleave
from tresym.racket.angle import Angle
from tresym.racket.body import NAMED_BODIES, Shape
from tresym.racket.flip.ladder import RUNGS, climb
from tresym.racket.floats.flipmap import flip_map
from tresym.racket.floats.shapes import defects
from tresym.racket.motion.trajectory import Start, travel
from tresym.reals.numbers.exact import parse_number

PACE = Pace(rounds=7, limit=10.0, patience=0.3)

ARRAYS = "float64 arrays"
MANY = 4096
PIXEL = 3
"""Digits that a figure of a thousand pixels shows."""

PRINTED = {"str": 2, "racket-1": 2, "racket-2": 2, "racket-3": 2, "book": 2, "ethylene": 3}
"""Digits of the flip that the paper prints of a body (Table 1, Sec. 8)."""


class Cell(NamedTuple):
    """A table cell or figure panel: the digits it needs, and the rungs by which it could be had.

    ``works`` are in order of cost, the one it takes first; each gives ``pieces`` answers.
    """

    where: str
    cell: str
    digits: int
    works: dict[str, tuple[Callable[[], Any], int]]


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``economy``."""
    cells = list(all_cells())
    contenders = (c for cell in cells for c in _contenders(cell))
    timings, complete = interleave(contenders, pace, keep)
    says = "the rung of each table cell and figure panel, and the next heavier one"
    tables = {
        "cells": [
            {"where": c.where, "cell": c.cell, "digits": c.digits, "rungs": list(c.works)[:2]}
            for c in cells
        ]
    }
    return Measurement("economy", says, timings, tables=tables, complete=complete)


def _contenders(cell: Cell) -> Iterator[Contender]:
    scene = f"{cell.where}: {cell.cell}"
    for rung, (work, pieces) in list(cell.works.items())[:2]:
        yield Contender(scene, rung, work, ours=True, asked=cell.digits, pieces=pieces)


def all_cells() -> Iterator[Cell]:
    """Every cell of the paper's tables and of ours, and every panel of the figures."""
    for name, digits in PRINTED.items():
        yield _cell("Table 1 and Sec. 8 of the paper", name, NAMED_BODIES[name].shape, "0", digits)
    for name, body in NAMED_BODIES.items():
        yield _cell("table objects", name, body.shape, "0", 50)
    yield from _error_cells()
    for name, body in NAMED_BODIES.items():
        yield _cell("table slope", name, body.shape, "0", 15)
    yield from _constant_cells()
    yield from _threshold_cells()
    yield from _route_cells()
    yield from _panels()


def _cell(where: str, name: str, shape: Shape, gamma: str, digits: int) -> Cell:
    level = parse_number(gamma)
    first = climb(shape, level, digits).rung
    rungs = RUNGS[RUNGS.index(first) :]
    works: dict[str, tuple[Callable[[], Any], int]] = {
        rung: (partial(climb, shape, level, digits, rung), 1) for rung in rungs
    }
    return Cell(where, name, digits, works)


def _error_cells() -> Iterator[Cell]:
    """The table of errors: ε₀ to the digits at which the error has four."""
    from tresym.racket.compared.errors import PRODUCTS, WIDTHS

    for b in WIDTHS:
        for product in PRODUCTS:
            name = f"ab = {_number(product):g}, b = {_number(b):g}"
            yield _cell("table errors", name, Shape(product / b, b), "0", 60)


def _constant_cells() -> Iterator[Cell]:
    """The table of constants: ε₀ to digits that leave the ratio with ε*⁴ six."""
    from tresym.racket.compared.constants import CONSTANTS

    for row in CONSTANTS:
        shape = Shape(parse_number(row.least), fmpq(1))
        yield _cell("table constants", f"a = {row.least}, b = 1", shape, "0", 30)


def _threshold_cells() -> Iterator[Cell]:
    """The table of thresholds: ε at the levels of the bodies, which the search goes through."""
    from tresym.racket.angle import parse_angle
    from tresym.racket.flip.levels import level_of

    for name, body in NAMED_BODIES.items():
        for value in ("-pi/12", "pi/12"):
            level = level_of(*body.shape, parse_angle(value), 12).str(12, radius=False)
            yield _cell("table thresholds", f"{name}, ε = {value}", body.shape, level, 12)


def _route_cells() -> Iterator[Cell]:
    from tresym.racket.compared.routes import CASES

    for body, gamma in CASES:
        where = "table routes"
        yield _cell(where, f"{body}, γ = {gamma}", NAMED_BODIES[body].shape, gamma, 50)


def _panels() -> Iterator[Cell]:
    """The figures that show ε or Δψ, by a point of theirs."""
    a, b, _ = peers.floats(NAMED_BODIES["str"].shape, fmpq(0))
    yield _flip_panel("Fig. 7", "symmetric flips", a, b, *_start_at(a, b, 3e-3))
    yield _flip_panel("Fig. 8", "exact", a, b, *_start_at(a, b, 1e-2))
    for gamma in ("1e-3", "3e-3", "3e-2", "-1e-3", "-3e-3", "-3e-2"):
        yield _flip_panel("Fig. 9", f"γ = {gamma}", a, b, *_start_at(a, b, float(gamma)))
    yield _flip_panel("Fig. 10", "every start", a, b, 0.3, 0.5)
    yield _flip_panel("Fig. 10", "zoom", a, b, 0.1, 0.1)
    shape = NAMED_BODIES["str"].shape
    one = np.full(MANY, a), np.full(MANY, b)
    works: dict[str, tuple[Callable[[], Any], int]] = {
        ARRAYS: (partial(defects, *one), MANY),
        "separatrix": (partial(climb, shape, 0, PIXEL, "separatrix"), 1),
    }
    yield Cell("Fig. 11", "every shape", PIXEL, works)


def _start_at(a: float, b: float, gamma: float) -> tuple[float, float]:
    """The start at ψ = π/2 on a level."""
    return math.pi / 2, math.sqrt((a + b) * (gamma + b)) / (1 - b)


def _flip_panel(where: str, cell: str, a: float, b: float, psi: float, rate: float) -> Cell:
    """A panel that is drawn by the float64 map; the next heavier rung is a certified start."""
    p, q, x, v, turn = (fmpq(*y.as_integer_ratio()) for y in (a, b, psi, rate, math.tau))
    start = Start(Angle(fmpq(0), x), v)
    starts = np.full(MANY, psi), np.full(MANY, rate)
    works: dict[str, tuple[Callable[[], Any], int]] = {
        ARRAYS: (partial(flip_map, a, b, *starts), MANY),
        "planar": (partial(travel, Shape(p, q), start, Angle(fmpq(0), turn), PIXEL), 1),
    }
    return Cell(where, cell, PIXEL, works)


def _number(x: fmpq) -> float:
    return int(x.p) / int(x.q)
