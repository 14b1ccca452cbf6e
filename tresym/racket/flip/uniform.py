"""Explicit formulas for ε₀ that are accurate for every shape a > 0, 0 < b ≤ 1.

They are derived from the phase equation P = π + arctan(r tanh kP), k = √(ab), r = √(b/a), whose
root is between π and 3π/2: by one step of the fixed-point iteration (a *sweep*) from a fixed
initial value, and by one Newton step after it. Certified worst relative errors in ε₀ (the proofs
are in ``proofs/asymptotics.tresym``):

- sweep from π: 2.8 %, always too large;
- sweep from 4: 0.65 %, of either sign, at the same cost;
- one Newton step after it: 0.01 % from π and 0.0004 % from 4, always too small.
"""

from __future__ import annotations

from typing import Any

from tresym.racket.formulas import stable


def swept_phase(start: Any, k: Any, r: Any, m: Any) -> Any:
    """Return π + arctan(r tanh(start·k)), one step of the fixed-point iteration."""
    return stable.phase_map(start, k, r, m)


def newton_phase(start: Any, k: Any, r: Any, m: Any) -> Any:
    """Return one Newton step for the phase equation after one sweep from ``start``."""
    phase = swept_phase(start, k, r, m)
    residual = phase - stable.phase_map(phase, k, r, m)
    return phase - residual / stable.phase_slope(phase, k, r, m)


def one_line(a: Any, b: Any, m: Any) -> Any:
    """Return ε₀ by tan ε₀ ≈ √(a/(a+b)) / sinh(√(ab)[π + arctan(√(b/a) tanh(π√(ab)))])."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(swept_phase(m.pi, k, r, m), k, r, m)


def balanced(a: Any, b: Any, m: Any) -> Any:
    """Return ε₀ by tan ε₀ ≈ √(a/(a+b)) / sinh(√(ab)[π + arctan(√(b/a) tanh(4√(ab)))])."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(swept_phase(4, k, r, m), k, r, m)


def one_step(a: Any, b: Any, m: Any, start: Any = 4) -> Any:
    """Return ε₀ by one sweep from ``start`` and one Newton step on the phase."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(newton_phase(start, k, r, m), k, r, m)
