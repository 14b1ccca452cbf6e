"""The four verdicts, and what decided a claim or stopped its decision."""

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


class Cause(Enum):
    """What decided a claim, or what stopped its decision; programs read this and not the reason.

    Example:
        >>> import tresym
        >>> tresym.check("x**2 == 9").cause.value
        'witness'
        >>> tresym.check("log(-x**2 - 1) == 0").cause.value
        'no point'
    """

    EXACT = "exact"
    """PROVED by an exact procedure."""
    BALLS = "balls"
    """ENCLOSED by ball arithmetic."""
    WITNESS = "witness"
    """REFUTED by a counterexample, which the answer gives."""
    CONTRARY = "contrary"
    """REFUTED by a proof of the contrary, such as an expansion with another coefficient."""
    OPEN = "open"
    """UNDECIDED because the methods that apply have failed."""
    NO_POINT = "no point"
    """UNDECIDED because no point was found at which the claim says something."""
    NO_VALUE = "no value"
    """UNDECIDED because an integral has no value that could be found and verified."""
    TOO_LARGE = "too large"
    """UNDECIDED because an intermediate expression exceeds the size limit."""
    UNCONFIRMED = "unconfirmed"
    """UNDECIDED because a counterexample was found and could not be confirmed."""
    CONTRADICTED = "contradicted"
    """UNDECIDED because the independent check contradicts the proof."""
    STOPPED = "stopped"
    """UNDECIDED because the limit on processor time was reached."""
    DIED = "died"
    """UNDECIDED because the process ended, perhaps for want of memory."""
    FAILED = "failed"
    """UNDECIDED because of an internal error."""
    INTERRUPTED = "interrupted"
    """UNDECIDED because the user interrupted the run."""

    @property
    def verdict(self) -> Verdict:
        """The verdict that has this cause."""
        return _VERDICTS.get(self, Verdict.UNDECIDED)

    @property
    def of_the_run(self) -> bool:
        """Whether another run may well decide the claim, so that the answer is not stored."""
        return self in (Cause.STOPPED, Cause.DIED, Cause.FAILED, Cause.INTERRUPTED)

    @staticmethod
    def usual(verdict: Verdict, has_witness: bool = False) -> Cause:
        """Return the cause of an answer for which no other is stated."""
        if verdict is Verdict.REFUTED:
            return Cause.WITNESS if has_witness else Cause.CONTRARY
        return _USUAL[verdict]


_VERDICTS = {
    Cause.EXACT: Verdict.PROVED,
    Cause.BALLS: Verdict.ENCLOSED,
    Cause.WITNESS: Verdict.REFUTED,
    Cause.CONTRARY: Verdict.REFUTED,
}
_USUAL = {
    Verdict.PROVED: Cause.EXACT,
    Verdict.ENCLOSED: Cause.BALLS,
    Verdict.UNDECIDED: Cause.OPEN,
}
