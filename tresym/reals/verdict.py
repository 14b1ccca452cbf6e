"""The four verdicts."""

from __future__ import annotations

from enum import Enum


class Verdict(Enum):
    """What tresym says of a statement. The value is the word printed everywhere.

    Example:
        >>> import tresym
        >>> tresym.check("exp(x) >= 1 + x").verdict is tresym.Verdict.PROVED
        True
    """

    PROVED = "PROVED"
    """An exact decision procedure said yes; no floating point took part."""
    ENCLOSED = "ENCLOSED"
    """Ball arithmetic contains it: a number with its radius, or an inequality on a whole box."""
    REFUTED = "REFUTED"
    """A witness whose ball excludes the statement, or an exact counterexample."""
    UNDECIDED = "UNDECIDED"
    """None of these. Never counted as a pass."""

    @property
    def holds(self) -> bool:
        """True for PROVED and ENCLOSED only."""
        return self in (Verdict.PROVED, Verdict.ENCLOSED)
