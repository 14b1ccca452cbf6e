"""Fig. 8: ε over (ε₀, γ) at b = 0.1: the exact ε(γ) beside the paper's linear ε₀ − γ/(4bε₀)."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import rate_at

from tresym.racket.floats.flipmap import Floats, flip_map
from tresym.racket.formulas.stable import separatrix_map
from tresym.report.figures import style

B = 0.1
TOLERANCE = math.pi / 12
_FIRM = {"linestyles": "solid", "linewidths": 1.8}
_DASHED = {"linestyles": [(0, (4, 2))], "linewidths": 1.0}
_THIN = {"linestyles": "solid", "linewidths": 0.5}
LINES: tuple[tuple[float, str, dict[str, Any]], ...] = (
    (0.0, "0", _FIRM),
    (-TOLERANCE, "−π/12", _DASHED),
    (TOLERANCE, "π/12", _DASHED),
    (-math.pi / 4, "−π/4", _THIN),
    (math.pi / 4, "π/4", _THIN),
)
"""Level lines of both panels: the exact flip, the paper's tolerance, and one more on each side."""


class Data(NamedTuple):
    """Columns ε₀ (with their a), rows γ; the maps have shape (rows, columns), in radians."""

    b: float
    a: Floats
    defect0: Floats
    gamma: Floats
    exact: Floats
    linear: Floats


def data() -> Data:
    """Compute both maps; the exact one follows the trajectories through turning points."""
    defect0 = np.linspace(0.02, 0.5, 97)
    gamma = np.linspace(-0.08, 0.08, 129)
    a = shape_with_defect(defect0, B)
    columns = [symmetric_defect(float(x), B, gamma) for x in a]
    linear = defect0 - gamma[:, None] / (4 * B * defect0)
    return Data(B, a, defect0, gamma, np.stack(columns, axis=1), linear)


def shape_with_defect(defect0: Floats, b: float) -> Floats:
    """Return the a with this ε₀ at fixed b, by bisection: ε₀ decreases in a."""
    low, high = np.full_like(defect0, -12.0), np.full_like(defect0, 12.0)
    for _ in range(60):
        middle = (low + high) / 2
        # The fixed-point map is above the diagonal exactly where its root is.
        large = separatrix_map(defect0, np.exp(middle), b, np) > defect0
        low, high = np.where(large, middle, low), np.where(large, high, middle)
    return np.asarray(np.exp(high))


def symmetric_defect(a: float, b: float, gamma: Floats) -> Floats:
    """Return ε(γ): ψ at φ = −π on the trajectory through ψ = π/2 at φ = 0."""
    rate = rate_at(np.full_like(gamma, math.pi / 2), gamma, a, b)
    return math.pi / 2 + flip_map(a, b, math.pi / 2, rate, -math.pi)


def draw(data: Data) -> Any:
    """Draw filled steps of π/12 in both panels; the exact flip is solid, the tolerance dashed."""
    figure, grid = style.canvas(7.2, 3.6, 1, 2, sharey=True)
    steps = np.arange(-6, 7) * TOLERANCE
    for sheet, values, title in zip(
        grid[0],
        (data.exact, data.linear),
        ("exact: symmetric trajectory", "linear: ε₀ − γ/(4bε₀)"),
        strict=True,
    ):
        filled = sheet.contourf(data.defect0, data.gamma, values, steps, extend="both")
        for level, name, look in LINES:
            line = sheet.contour(data.defect0, data.gamma, values, [level], colors="black", **look)
            sheet.clabel(line, fmt={level: style.label(name)}, fontsize=8)
        sheet.set_title(f"{title}, b = {data.b}")
        sheet.set_xlabel(r"$\varepsilon_0$ (rad)")
    grid[0, 0].set_ylabel("γ")
    bar = figure.colorbar(filled, ax=grid[0].tolist(), label="ε (rad)", shrink=0.95)
    names = ["−π/2", "−π/3", "−π/6", "0", "π/6", "π/3", "π/2"]
    bar.set_ticks(steps[::2], labels=names)
    return figure
