"""Judge false variants of the claims, and report those that pass."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from dataclasses import dataclass, replace
from functools import cache
from time import process_time
from typing import Any, NamedTuple

from tresym.dev.mutants.mutants import Mutant, mutants, why_few
from tresym.dev.mutants.seeded_faults import planted
from tresym.ledger import paper
from tresym.ledger.claim import AllOf, Claim, Counterexample
from tresym.ledger.computed_once import Kept
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import RULINGS, Finding, Ruling
from tresym.ledger.judge import judge, judge_evidence
from tresym.ledger.refutations import seen_false
from tresym.ledger.verification import JSON_VERSION, MUTANTS, choose
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import Processes
from tresym.reals.resource_limits import time_limit
from tresym.reals.verdict import Verdict

SECONDS = 0.5
"""CPU seconds for the evidence of a mutant, or twice the time of the claim's own, if more."""
BATCH = 4
"""Number of consecutive claims per task of a process; neighbours share mutants of their parts."""


class Slip(NamedTuple):
    """A mutant, described in words."""

    label: str
    place: str
    change: str


@dataclass(frozen=True)
class MutantRow:
    """The results for the mutants of one claim."""

    label: str
    counts: dict[str, int]
    """The number of mutants with each verdict."""
    survivors: tuple[Slip, ...]
    """Mutants that were accepted (PROVED, ENCLOSED, or still refuting something): must be empty."""
    stopped: tuple[Slip, ...]
    """Mutants that passed and were stopped only by the independent check: must be empty, too."""
    changes: int
    """The number of changes; one change may give two mutants, with and without the chain."""
    why_few: str = ""
    """Why there are fewer changes than wanted; empty if there are not."""

    @property
    def total(self) -> int:
        """The number of mutants judged."""
        return sum(self.counts.values())


@dataclass(frozen=True)
class MutantReport:
    """The results of mutation testing, one row for each claim that has mutants."""

    rows: tuple[MutantRow, ...]

    @property
    def counts(self) -> dict[str, int]:
        """The number of mutants with each verdict."""
        return {v.value: sum(row.counts[v.value] for row in self.rows) for v in RULINGS}

    @property
    def survivors(self) -> tuple[Slip, ...]:
        """The mutants that were accepted; there must be none."""
        return tuple(mutant for row in self.rows for mutant in row.survivors)

    @property
    def stopped(self) -> tuple[Slip, ...]:
        """The mutants that passed the evidence and were stopped by the independent check only."""
        return tuple(mutant for row in self.rows for mutant in row.stopped)

    @property
    def few(self) -> tuple[MutantRow, ...]:
        """The claims with fewer changes than wanted, with the reasons."""
        return tuple(row for row in self.rows if row.why_few)

    def as_json(self) -> dict[str, Any]:
        """Return the report as `tresym verify --mutants --json` prints it."""
        return {
            "version": JSON_VERSION,
            "workload": "mutants",
            "counts": self.counts,
            "survivors": [slip._asdict() for slip in self.survivors],
            "stopped": [slip._asdict() for slip in self.stopped],
            "claims": [
                {"label": row.label, "changes": row.changes, **row.counts} for row in self.rows
            ],
            "few": [
                {"label": row.label, "changes": row.changes, "why": row.why_few} for row in self.few
            ],
        }


def verify_mutants(
    labels: Iterable[str] = (),
    wanted: int = MUTANTS,
    on_row: Callable[[MutantRow], None] | None = None,
    workers: int = 1,
) -> MutantReport:
    """Judge mutants of all claims, or of those with these labels; none may pass.

    If all claims are asked for, the seeded faults that test the guards of the judge are included.
    Unchanged claims that a mutant depends on are assumed to have their expected verdicts.

    Args:
        labels: labels of claims; all if empty.
        wanted: the number of changes per claim, spread over its places, at least one at each.
        on_row: called with each row as soon as it is known, or None.
        workers: the number of processes; 1 uses the current process.

    Raises:
        InputError: no claim has one of the labels, or worker processes die repeatedly.
    """
    asked = tuple(map(paper.racket().label_of, labels))
    chosen = [claim.label for claim in choose(asked) if not asked or claim.label in asked]
    rows = []
    for row in _rows(chosen, wanted, workers):
        rows.append(row)
        if on_row is not None:
            on_row(row)
    for claim in () if asked else planted():
        rows.append(_planted_row(claim))
        if on_row is not None:
            on_row(rows[-1])
    return MutantReport(tuple(rows))


def _rows(labels: list[str], wanted: int, workers: int) -> Iterator[MutantRow]:
    batches = [tuple(labels[n : n + BATCH]) for n in range(0, len(labels), BATCH)]
    if workers == 1 or len(batches) == 1:
        for label in labels:
            yield from rows_of((label,), wanted)
        return
    with Processes(min(workers, len(batches))) as processes:
        for future in processes.in_order(rows_of, ((batch, wanted) for batch in batches)):
            try:
                yield from future.result()
            except BrokenExecutor as error:
                raise InputError(f"verify: {error}") from None


def rows_of(labels: tuple[str, ...], wanted: int) -> list[MutantRow]:
    """Judge the mutants of the claims with these labels in the current process."""
    claims = paper.all_claims()
    using = _dependents(claims)
    found = {claim.label: Finding(claim.expect, "as expected") for claim in claims}
    return [_row(claim, wanted, using, found) for claim in claims if claim.label in labels]


def _row(
    claim: Claim, wanted: int, using: dict[Claim, tuple[Claim, ...]], found: dict[str, Finding]
) -> MutantRow:
    judged = [
        (Slip(claim.label, mutant.place, mutant.change), mutant, _judge_mutant(mutant, found))
        for mutant in _mutants_of(claim, wanted, using[claim])
    ]
    counted = Counter(finding.verdict for _, _, finding in judged)
    changes = len({(slip.place, slip.change) for slip, _, _ in judged})
    return MutantRow(
        claim.label,
        {v.value: counted[v] for v in RULINGS},
        tuple(slip for slip, mutant, finding in judged if _survives(mutant, finding.verdict)),
        tuple(slip for slip, _, finding in judged if finding.stopped),
        changes,
        why_few(claim, using[claim]) if changes < wanted else "",
    )


@cache
def _mutants_of(claim: Claim, wanted: int, dependents: tuple[Claim, ...] = ()) -> Kept[Mutant]:
    """Return the mutants of a claim; conjunctions reuse those of their parts."""
    return Kept(lambda: mutants(claim, wanted, dependents, lambda part: _mutants_of(part, wanted)))


def _planted_row(claim: Claim) -> MutantRow:
    """Judge a seeded fault together with the claims that it depends on."""
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    slip = Slip(claim.label, "the judge", "a guard is missing")
    verdict = found[claim.label].verdict
    counts = {v.value: int(v is verdict) for v in RULINGS}
    survivors = (slip,) if _believed(claim, verdict) else ()
    stopped = (slip,) if found[claim.label].stopped else ()
    return MutantRow(claim.label, counts, survivors, stopped, 1)


def _believed(claim: Claim, verdict: Ruling) -> bool:
    return verdict.holds or (isinstance(claim.proof, Counterexample) and verdict is Verdict.REFUTED)


def _survives(mutant: Mutant, verdict: Ruling) -> bool:
    """Return whether a false variant is accepted: it passes, or still refutes something."""
    denies = isinstance(mutant.claim.proof, Denied)
    return verdict.holds or (denies and verdict is Verdict.REFUTED)


def _judge_mutant(mutant: Mutant, found: dict[str, Finding]) -> Finding:
    """Return the finding on a mutant, after judging the changed claims that it depends on.

    A conjunction with a refuted part is false, even if the definitions also conflict.
    """
    changed = dict(found)
    for claim in mutant.beneath:
        changed[claim.label] = _judged(claim, changed)
    finding = _judged(mutant.claim, changed)
    part = changed[mutant.beneath[-1].label] if mutant.beneath else finding
    if finding.verdict is Verdict.UNDECIDED and isinstance(mutant.claim.proof, AllOf):
        finding = part if part.verdict is Verdict.REFUTED else finding
    stopped = finding.stopped or any(changed[claim.label].stopped for claim in mutant.beneath)
    return replace(finding, stopped=stopped)


class _NotBelievedError(BaseException):
    """The time limit for the evidence was reached."""


_once: dict[int, tuple[Claim, Finding]] = {}
"""What became of changed claims, which conjunctions share with their parts."""


def _judged(claim: Claim, found: dict[str, Finding]) -> Finding:
    """Return the finding on a changed claim (cached); a timeout counts as not accepted.

    If the judge is undecided, for example because definitions conflict, a counterexample is
    searched for.
    """
    if id(claim) not in _once:
        label = claim.label
        finding = _within(_allowed.get(label, SECONDS), claim, found)
        if finding is None and label not in _allowed:
            _allowed[label] = max(SECONDS, 2 * _own_seconds(label))
            finding = _within(_allowed[label], claim, found) if _allowed[label] > SECONDS else None
        if finding is None or finding.verdict is Verdict.UNDECIDED:
            seen = seen_false(claim)
            if finding is None or seen.verdict is Verdict.REFUTED:
                finding = replace(seen, stopped=finding is not None and finding.stopped)
        _once[id(claim)] = claim, finding
    return _once[id(claim)][1]


_allowed: dict[str, float] = {}
"""CPU seconds for mutants of a claim after one of them took too long."""


def _own_seconds(label: str) -> float:
    """Return the CPU time that the claim's own evidence takes."""
    claims = paper.all_claims()
    began = process_time()
    judge_evidence(next(claim for claim in claims if claim.label == label))
    return process_time() - began


def _within(seconds: float, claim: Claim, found: dict[str, Finding]) -> Finding | None:
    try:
        with time_limit(seconds, _NotBelievedError):
            return judge(claim, found)
    except _NotBelievedError:
        return None


def _dependents(claims: tuple[Claim, ...]) -> dict[Claim, tuple[Claim, ...]]:
    """Return for every claim those that name it as evidence, in order."""
    found: dict[Claim, list[Claim]] = {claim: [] for claim in claims}
    for claim in claims:
        for used in claim.uses:
            found[used].append(claim)
    return {claim: tuple(users) for claim, users in found.items()}
