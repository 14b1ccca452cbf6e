"""The verifier against false variants of its own claims: none may hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from tresym.ledger import paper
from tresym.ledger.claim import Claim, Counterexample
from tresym.ledger.evidence.denial import Denied
from tresym.ledger.finding import RULINGS, Finding, Premise, Ruling
from tresym.ledger.judge import judge
from tresym.ledger.mutants.mutants import Mutant, mutants, why_few
from tresym.ledger.mutants.planted import planted
from tresym.ledger.verification import JSON_VERSION, verify
from tresym.reals.verdict import Verdict

MUTANTS = 5
"""Changes that are tried on each claim, one or more at each place of it."""


@dataclass(frozen=True)
class MutantRow:
    """What became of the mutants of one claim."""

    claim: Claim
    counts: dict[str, int]
    """How many got each verdict; all are always present."""
    survivors: tuple[Mutant, ...]
    """Mutants that were PROVED or ENCLOSED, or denied something: there must be none."""
    stopped: tuple[Mutant, ...]
    """Mutants that the evidence let through and the advocate alone stopped, UNDECIDED: none too."""
    changes: int
    """How many changes made them: one change may be judged with and without its chain."""
    why_few: str = ""
    """Why there are fewer changes than wanted; empty where there are not."""

    @property
    def total(self) -> int:
        """How many mutants were judged."""
        return sum(self.counts.values())


@dataclass(frozen=True)
class MutantReport:
    """The score of the verifier against mutants, a row per claim that has any."""

    rows: tuple[MutantRow, ...]

    @property
    def counts(self) -> dict[str, int]:
        """How many mutants got each verdict."""
        return {v.value: sum(row.counts[v.value] for row in self.rows) for v in RULINGS}

    @property
    def survivors(self) -> tuple[Mutant, ...]:
        """Every mutant that was believed."""
        return tuple(mutant for row in self.rows for mutant in row.survivors)

    @property
    def stopped(self) -> tuple[Mutant, ...]:
        """Every mutant that only the advocate stopped."""
        return tuple(mutant for row in self.rows for mutant in row.stopped)

    @property
    def few(self) -> tuple[MutantRow, ...]:
        """The claims with fewer changes than wanted, with the reason."""
        return tuple(row for row in self.rows if row.why_few)

    def as_json(self) -> dict[str, Any]:
        """The report as `tresym verify --mutants --json` prints it."""
        return {
            "version": JSON_VERSION,
            "counts": self.counts,
            "survivors": [_mutant_json(mutant) for mutant in self.survivors],
            "stopped": [_mutant_json(mutant) for mutant in self.stopped],
            "claims": [
                {"label": row.claim.label, "changes": row.changes, **row.counts}
                for row in self.rows
            ],
            "few": [
                {"label": row.claim.label, "changes": row.changes, "why": row.why_few}
                for row in self.few
            ],
        }


def _mutant_json(mutant: Mutant) -> dict[str, str]:
    return {"label": mutant.origin.label, "place": mutant.place, "change": mutant.change}


def verify_mutants(
    labels: Iterable[str] = (),
    wanted: int = MUTANTS,
    on_row: Callable[[MutantRow], None] | None = None,
) -> MutantReport:
    """Judge mutants of every claim, or of those named by ``labels``: none may hold.

    With those of every claim, the falsehoods that are planted for the guards of the judge.

    Args:
        labels: labels of claims; none means all.
        wanted: changes to each claim, spread over its places, one or more at each.
        on_row: called with each row as it is found, for progress.

    Raises:
        InputError: a label that no claim has.
    """
    report = verify(labels)
    found = {row.claim.label: row.finding for row in report.rows}
    made: dict[str, tuple[Mutant, ...]] = {}

    def of(claim: Claim) -> tuple[Mutant, ...]:
        if claim.label not in made:
            made[claim.label] = tuple(mutants(claim, wanted, using[claim], of))
        return made[claim.label]

    using = _dependents(paper.all_claims())
    rows = []
    for claim in (row.claim for row in report.rows if row.requested):
        judged = [(mutant, _judge_mutant(mutant, found)) for mutant in of(claim)]
        counted = Counter(finding.verdict for _, finding in judged)
        counts = {v.value: counted[v] for v in RULINGS}
        survivors = tuple(mutant for mutant, f in judged if _survives(mutant, f.verdict))
        stopped = tuple(mutant for mutant, finding in judged if finding.stopped)
        changes = len({(mutant.place, mutant.change) for mutant, _ in judged})
        few = why_few(claim, using[claim]) if changes < wanted else ""
        rows.append(MutantRow(claim, counts, survivors, stopped, changes, few))
        if on_row is not None:
            on_row(rows[-1])
    if labels:
        return MutantReport(tuple(rows))
    for claim in planted():
        rows.append(_planted_row(claim))
        if on_row is not None:
            on_row(rows[-1])
    return MutantReport(tuple(rows))


def _planted_row(claim: Claim) -> MutantRow:
    """What became of a planted falsehood, with all that it rests on."""
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    mutant = Mutant(claim, "the judge", "a guard is missing", claim)
    verdict = found[claim.label].verdict
    counts = {v.value: int(v is verdict) for v in RULINGS}
    survivors = (mutant,) if _believed(claim, verdict) else ()
    stopped = (mutant,) if found[claim.label].stopped else ()
    return MutantRow(claim, counts, survivors, stopped, 1)


def _believed(claim: Claim, verdict: Ruling) -> bool:
    return verdict.holds or (isinstance(claim.proof, Counterexample) and verdict is Verdict.REFUTED)


def _survives(mutant: Mutant, verdict: Ruling) -> bool:
    """Whether a false variant is believed: it holds, or what is false still denies something."""
    denies = isinstance(mutant.claim.proof, Denied)
    return verdict.holds or (denies and verdict is Verdict.REFUTED)


def _judge_mutant(mutant: Mutant, found: dict[str, Finding]) -> Finding:
    """The finding on a mutant, where the changed claims it rests on are judged first.

    What others prove by a definition may rest on claims that were not asked for: those are added.
    """
    for used in mutant.claim.rests_on:
        if used.label not in found:
            found[used.label] = judge(used, found)
    changed = dict(found)
    for used in mutant.claim.uses:
        if found[used.label].of not in (None, used):
            changed[used.label] = Finding(Premise.DEFINED, "that was changed", of=used)
    for claim in mutant.beneath:
        changed[claim.label] = judge(claim, changed)
    finding = judge(mutant.claim, changed)
    stopped = finding.stopped or any(changed[claim.label].stopped for claim in mutant.beneath)
    return replace(finding, stopped=stopped)


def _dependents(claims: tuple[Claim, ...]) -> dict[Claim, tuple[Claim, ...]]:
    """For every claim those that name it as evidence, in order."""
    found: dict[Claim, list[Claim]] = {claim: [] for claim in claims}
    for claim in claims:
        for used in claim.uses:
            found[used].append(claim)
    return {claim: tuple(users) for claim, users in found.items()}
