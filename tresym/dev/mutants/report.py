"""Judge false variants of the claims, and report those that pass."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from dataclasses import dataclass, field, replace
from itertools import islice
from time import process_time
from typing import Any, NamedTuple

from tresym.dev.mutants.mutants import Mutant, Place, places_of, why_few
from tresym.dev.mutants.seeded_faults import planted
from tresym.ledger import paper
from tresym.ledger.claim import Claim, Counterexample
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import RULINGS, Finding, Ruling
from tresym.ledger.judge import NEVER_ATTACKED, judge, judge_evidence
from tresym.ledger.refutations import seen_false
from tresym.ledger.verification import JSON_VERSION, MUTANTS, choose
from tresym.reals.computed_once import Kept
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import Processes
from tresym.reals.resource_limits import time_limit
from tresym.reals.verdict import Verdict

SECONDS, MOST = 0.5, 10.0
"""CPU seconds for the evidence of a mutant, or twice the time of the claim's own, but no more than
these; as many for the search for a point at which it is false."""
TRIES, TOGETHER = 5, 24
"""Changes tried at one place to find those that are seen to be false; where there are few places,
so many at all of them."""
KEPT = 400
"""Findings on changed claims that are kept for the claims made of them."""
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
    aside: tuple[tuple[str, Slip], ...] = ()
    """Changes that nothing shows to be false, with their verdicts; those that hold are true."""

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
    def aside(self) -> dict[str, int]:
        """The number of changes with each verdict that nothing shows to be false."""
        counted = Counter(verdict for row in self.rows for verdict, _ in row.aside)
        return {v.value: counted[v.value] for v in Verdict}

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
            "aside": self.aside,
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
    if len(_once) > KEPT:
        _once.clear()
        _parts.clear()
    judging = _Judging(found, wanted, using)
    judged = [(mutant, judging.finding(mutant)) for m in judging.false(claim) for mutant in m]
    changes = len({(mutant.place, mutant.change) for mutant, _ in judged})
    counted = Counter(finding.verdict for _, finding in judged)
    return MutantRow(
        claim.label,
        {v.value: counted[v] for v in RULINGS},
        tuple(_slip(mutant) for mutant, finding in judged if _survives(mutant, finding.verdict)),
        tuple(_slip(mutant) for mutant, finding in judged if finding.stopped),
        changes,
        why_few(claim, using[claim]) if changes < wanted else "",
        tuple(judging.aside),
    )


def _slip(mutant: Mutant) -> Slip:
    return Slip(mutant.label, mutant.place, mutant.change)


@dataclass
class _Judging:
    """Judge the variants of claims, and tell those that are false from the others.

    Attributes:
        found: the findings on all claims, unchanged.
        wanted: the number of changes per claim.
        using: the claims that use a claim.
        aside: the variants that nothing shows to be false, with their verdicts.
    """

    found: dict[str, Finding]
    wanted: int
    using: dict[Claim, tuple[Claim, ...]]
    aside: list[tuple[str, Slip]] = field(default_factory=list)

    def false(self, claim: Claim) -> Iterator[tuple[Mutant, ...]]:
        """Yield false variants, for each change those that it gives: some of each place."""
        found_at = places_of(claim, self.using.get(claim, ()), self._of_part)
        tries = max(TRIES, TOGETHER // max(len(found_at), 1))
        places = [self._at(place, tries) for place in found_at]
        share = math.ceil(self.wanted / len(places)) if places else 0
        count = 0
        for found in (m for place in places for m in islice(place, share)):
            count += 1
            yield found
        # If some places have no further changes, more are made at the others.
        yield from islice((m for place in places for m in place), max(0, self.wanted - count))

    def _at(self, place: Place, tries: int) -> Iterator[tuple[Mutant, ...]]:
        for changed in islice(place.mutants, tries):
            if self._is_false(changed[0]):
                yield changed
            else:
                verdict = self.finding(changed[0]).verdict
                self.aside.append((verdict.value, _slip(changed[0])))

    def _of_part(self, part: Claim) -> Iterable[tuple[Mutant, ...]]:
        """Return the false variants of a part; claims that share it share them."""
        if part not in _parts:
            alone = replace(self, aside=[])
            _parts[part] = Kept(lambda: alone.false(part))
        return _parts[part]

    def _is_false(self, mutant: Mutant) -> bool:
        """Return whether balls, or the engine by a witness, show that a variant is false."""
        if mutant.part is not None:
            return True
        asked = mutant.claim if mutant.step is None else mutant.step
        finding = _judged(asked, self.found)
        if not finding.verdict.holds:
            return finding.verdict is Verdict.REFUTED
        return finding.stopped or _seen_false(asked).verdict is Verdict.REFUTED

    def finding(self, mutant: Mutant) -> Finding:
        """Return the finding on a variant, which is refuted with its step or its part."""
        below = {}
        if mutant.part is not None:
            below[mutant.part.label] = self.finding(mutant.part)
        if mutant.step is not None:
            below[""] = _judged(mutant.step, self.found)
        finding = _judged(mutant.claim, {**self.found, **below})
        if finding.verdict is Verdict.UNDECIDED and not isinstance(mutant.claim.proof, Denied):
            refuted = (f for f in below.values() if f.verdict is Verdict.REFUTED)
            finding = next(refuted, finding)
        return replace(finding, stopped=any(f.stopped for f in (finding, *below.values())))


_parts: dict[Claim, Iterable[tuple[Mutant, ...]]] = {}
"""False variants of claims of which others are made."""


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
            _allowed[label] = min(MOST, max(SECONDS, 2 * _own_seconds(label)))
            finding = _within(_allowed[label], claim, found) if _allowed[label] > SECONDS else None
        if finding is None or finding.verdict is Verdict.UNDECIDED:
            seen = _seen_false(claim)
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
    except (_NotBelievedError, SystemError):  # FLINT may wrap what a time limit raises
        return None


def _seen_false(claim: Claim) -> Finding:
    """Return REFUTED if balls show at a point that a claim is false, without its evidence."""
    nothing = Finding(Verdict.UNDECIDED, "no point was found at which it is false")
    if isinstance(claim.proof, NEVER_ATTACKED):  # no single point contradicts it
        return nothing
    try:
        with time_limit(MOST, _NotBelievedError):
            return seen_false(claim)
    except (_NotBelievedError, SystemError):  # FLINT may wrap what a time limit raises
        return nothing


def _dependents(claims: tuple[Claim, ...]) -> dict[Claim, tuple[Claim, ...]]:
    """Return for every claim those that name it as evidence, in order."""
    found: dict[Claim, list[Claim]] = {claim: [] for claim in claims}
    for claim in claims:
        for used in claim.uses:
            found[used].append(claim)
    return {claim: tuple(users) for claim, users in found.items()}
