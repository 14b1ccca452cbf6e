"""Explicit formulas for ε₀ that are accurate for every shape a > 0, 0 < b ≤ 1.

All come from the phase equation P = π + arctan(r tanh kP), k = √(ab), r = √(b/a), whose root is
between π and 3π/2: one sweep from a fixed start, and one Newton step after that sweep. Certified
worst relative errors in ε₀ (the proofs are in ``proofs/asymptotics.py``):

- sweep from π: 2.8 %, always too large;
- sweep from 4: 0.65 %, on either side, at the same cost;
- one Newton step after it: 0.01 % from π and 0.0004 % from 4, always too small.
"""

from __future__ import annotations

from typing import Any

from tresym.racket.formulas import stable


def swept_phase(start: Any, k: Any, r: Any, m: Any) -> Any:
    """π + arctan(r tanh(start·k)): one sweep of the phase map."""
    return stable.phase_map(start, k, r, m)


def newton_phase(start: Any, k: Any, r: Any, m: Any) -> Any:
    """One Newton step for the phase equation after one sweep from ``start``."""
    phase = swept_phase(start, k, r, m)
    residual = phase - stable.phase_map(phase, k, r, m)
    return phase - residual / stable.phase_slope(phase, k, r, m)


def one_line(a: Any, b: Any, m: Any) -> Any:
    """tan ε₀ ≈ √(a/(a+b)) / sinh(√(ab)[π + arctan(√(b/a) tanh(π√(ab)))])."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(swept_phase(m.pi, k, r, m), k, r, m)


def balanced(a: Any, b: Any, m: Any) -> Any:
    """tan ε₀ ≈ √(a/(a+b)) / sinh(√(ab)[π + arctan(√(b/a) tanh(4√(ab)))])."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(swept_phase(4, k, r, m), k, r, m)


def one_step(a: Any, b: Any, m: Any, start: Any = 4) -> Any:
    """The balanced formula (or any other start) with one Newton step on the phase."""
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    return stable.defect_at(newton_phase(start, k, r, m), k, r, m)
