"""The four verdicts."""

from __future__ import annotations

from enum import Enum


class Verdict(Enum):
    """The result of checking a statement. The value is the word printed everywhere.

    Example:
        >>> import tresym
        >>> tresym.check("exp(x) >= 1 + x").verdict is tresym.Verdict.PROVED
        True
    """

    PROVED = "PROVED"
    """An exact decision procedure proves the statement, without floating-point arithmetic."""
    ENCLOSED = "ENCLOSED"
    """Ball arithmetic proves it: a number within its radius, or an inequality on a whole box."""
    REFUTED = "REFUTED"
    """A witness whose ball excludes the statement, or an exact counterexample."""
    UNDECIDED = "UNDECIDED"
    """None of these. Never counted as a pass."""

    @property
    def holds(self) -> bool:
        """Return whether the verdict is PROVED or ENCLOSED."""
        return self in (Verdict.PROVED, Verdict.ENCLOSED)
