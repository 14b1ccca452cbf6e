"""Evidence by ball arithmetic: bounds on boxes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any, ClassVar

from flint import fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.finding import Finding, Ruling
from tresym.reals.balls.branch_and_bound import (
    Bound,
    BoxProof,
    CertificateError,
    Counterexample,
    Open,
    decide_bound,
    inconsistent,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, Interval, decimal_ball, fraction_text
from tresym.reals.verdict import Verdict

_anew: ContextVar[bool] = ContextVar("_anew", default=False)


@contextmanager
def finding_anew() -> Iterator[None]:
    """Search for box proofs anew inside the ``with`` block, ignoring the stored ones."""
    token = _anew.set(True)
    try:
        yield
    finally:
        _anew.reset(token)


def searching_anew() -> bool:
    """Return whether the code runs inside :func:`finding_anew`."""
    return _anew.get()


def decisions_of(
    bounds: tuple[Bound, ...], stored: Callable[[], tuple[BoxProof, ...] | None] | None, budget: int
) -> tuple[BoxProof | Counterexample | Open, ...]:
    """Return the result for each bound, checking its stored proof if there is one.

    Args:
        bounds: the bounds, each on its box.
        stored: returns the stored proofs, one per bound, or None; None to search in any case.
        budget: maximal number of boxes in a search, per bound.

    Raises:
        CertificateError: the stored proofs do not prove the bounds.
    """
    proofs = None if searching_anew() or stored is None else stored()
    if proofs is None:
        return tuple(decide_bound(bound, budget) for bound in bounds)
    if len(proofs) != len(bounds):
        raise CertificateError(f"{len(proofs)} proofs are stored for {len(bounds)} bounds")
    pairs = zip(bounds, proofs, strict=True)
    return tuple(decide_bound(bound, budget, proof) for bound, proof in pairs)


@dataclass(frozen=True)
class Boxes:
    """Evidence that a statement holds because each of several functions is positive on a box.

    Attributes:
        bounds: the bounds; together they imply the statement.
        names: names of the coordinates, for witnesses and regions.
        region: where the statement holds, in words.
        constant: the constant of the statement, or None.
        claims: claims that the reduction to these bounds uses.
        stored: returns the stored proofs, or None if there are none. None itself if no proofs are
            stored for this claim, because the search is short or ends at a counterexample.
        budget: maximal number of boxes in a search, per bound.
        meant: for a formula, the meaning of its symbols on the box; see
            `tresym.ledger.evidence.allowed_evidence.Meant`.
    """

    bounds: tuple[Bound, ...]
    names: tuple[str, ...]
    region: str
    constant: fmpq | None = None
    claims: tuple[Claim, ...] = ()
    stored: Callable[[], tuple[BoxProof, ...] | None] | None = None
    budget: int = 20_000
    meant: Any = None
    kind: ClassVar[str] = "bound"
    expect: ClassVar[Ruling] = Verdict.ENCLOSED

    def decisions(self) -> tuple[BoxProof | Counterexample | Open, ...]:
        """Return the result for each bound, checking its stored proof if there is one.

        Raises:
            CertificateError: the stored proofs do not prove the bounds.
        """
        return decisions_of(self.bounds, self.stored, self.budget)

    def judge(self, region: str = "") -> Finding:
        """Return ENCLOSED if all bounds are proved, REFUTED with a point if one fails.

        Args:
            region: the region as stated by the conditions of the claim; if empty, that of the
                evidence is reported.
        """
        for bound in self.bounds:
            with ball_precision(bound.precision):
                why = inconsistent(bound.margin, bound.box, bound.slopes)
            if why is not None:
                return Finding(Verdict.UNDECIDED, why)
        decisions = self.decisions()
        constant = None if self.constant is None else decimal(self.constant)
        for found in decisions:
            if isinstance(found, Counterexample):
                point = dict(zip(self.names, found.point, strict=True))
                where = ", ".join(f"{name} = {fraction_text(x)}" for name, x in point.items())
                why = f"the bound fails at {where}"
                return Finding(Verdict.REFUTED, why, constant=constant, witness=point)
        return closed(decisions, region or self.region, constant)


def closed(
    decisions: Sequence[BoxProof | Counterexample | Open],
    region: str | None,
    constant: Decimal | None = None,
) -> Finding:
    """Return ENCLOSED if there is a proof for every bound, else UNDECIDED.

    Args:
        decisions: the results for the bounds; empty gives UNDECIDED.
        region: where the statement holds, for the report.
        constant: the constant of the statement, for the report.
    """
    proofs = [found for found in decisions if isinstance(found, BoxProof)]
    if not decisions or len(proofs) < len(decisions):
        points = [found.point for found in decisions if isinstance(found, Counterexample)]
        why = (
            "the search ended before the bound was proved on all boxes"
            if decisions
            else "the evidence contains no bound"
        )
        why += f"; it fails at {points[0]}" if points else ""
        return Finding(Verdict.UNDECIDED, why, constant=constant)
    leaves = sum(found.leaves for found in proofs)
    return Finding(
        Verdict.ENCLOSED,
        f"proved on {leaves} box" + "es" * (leaves != 1),
        constant=constant,
        region=region,
        trees=tuple(found.tree for found in proofs),
        boxes=leaves,
    )


def decimal(x: fmpq) -> Decimal:
    """Return an exact constant as a decimal with 12 digits, for reports."""
    with ball_precision(64):
        return decimal_ball(Interval(x, x).ball(), 12)
