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
    """Inside the block box proofs are searched for again, and stored ones are not looked at."""
    token = _anew.set(True)
    try:
        yield
    finally:
        _anew.reset(token)


def searching_anew() -> bool:
    """Whether this is inside :func:`finding_anew`."""
    return _anew.get()


def decisions_of(
    bounds: tuple[Bound, ...],
    stored: Callable[[], tuple[BoxProof, ...] | None] | None,
    budget: int,
) -> tuple[BoxProof | Counterexample | Open, ...]:
    """What each bound comes to, by its stored proof where there is one.

    Raises:
        CertificateError: stored proofs that do not prove the bounds.
    """
    proofs = None if searching_anew() or stored is None else stored()
    if proofs is None:
        return tuple(decide_bound(bound, budget) for bound in bounds)
    if len(proofs) != len(bounds):
        raise CertificateError("stored proofs of another number of bounds")
    pairs = zip(bounds, proofs, strict=True)
    return tuple(decide_bound(bound, budget, proof) for bound, proof in pairs)


@dataclass(frozen=True)
class Boxes:
    """Every bound holds on its box.

    Attributes:
        bounds: the bounds; together they are the statement.
        names: names of the coordinates, for witnesses and regions.
        region: where the statement holds, in words.
        constant: the constant of the statement, where it has one.
        claims: claims the reduction to these bounds rests on.
        stored: gives the stored proofs, or None where there are none; None itself where none are
            kept, because the search is short or ends at a counterexample.
        budget: boxes a search may look at, for each bound.
        meant: for a formula, what its symbols are in the box (see meant.py).
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
        """What each bound came to, by its stored proof where there is one.

        Raises:
            CertificateError: stored proofs that do not prove the bounds.
        """
        return decisions_of(self.bounds, self.stored, self.budget)

    def judge(self, region: str = "") -> Finding:
        """ENCLOSED when all bounds are, REFUTED at a point where one fails.

        Args:
            region: where the statement holds, by the conditions of the claim.
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
    """ENCLOSED where all boxes are closed, and there is one."""
    proofs = [found for found in decisions if isinstance(found, BoxProof)]
    if not decisions or len(proofs) < len(decisions):
        points = [found.point for found in decisions if isinstance(found, Counterexample)]
        why = "the search left boxes open" if decisions else "there is no bound to show"
        why += f", at {points[0]}" if points else ""
        return Finding(Verdict.UNDECIDED, why, constant=constant)
    leaves = sum(found.leaves for found in proofs)
    return Finding(
        Verdict.ENCLOSED,
        f"closed in {leaves} box" + "es" * (leaves != 1),
        constant=constant,
        region=region,
        trees=tuple(found.tree for found in proofs),
    )


def decimal(x: fmpq) -> Decimal:
    """An exact constant, as it is shown."""
    with ball_precision(64):
        return decimal_ball(Interval(x, x).ball(), 12)
