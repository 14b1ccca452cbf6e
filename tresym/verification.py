"""Verification: every claim judged, foundations first, into a report that prints and saves."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import nullcontext
from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import Any

from tresym.claims.bounds import Boxes, finding_anew, searching_anew
from tresym.claims.claim import Claim, Counterexample
from tresym.claims.denial import Denied
from tresym.claims.finding import Finding
from tresym.claims.judge import judge, judge_evidence
from tresym.claims.meaning import is_formal
from tresym.claims.mutants import Mutant, mutants, why_few
from tresym.claims.planted import planted
from tresym.claims.table import conflict
from tresym.exact import InputError, fraction_text, quoted
from tresym.processes import Processes
from tresym.verdict import Verdict

JSON_VERSION = 1
BATCH = 6
"""Claims that a process takes at once: neighbours, for they share what is remembered."""

MUTANTS = 5
"""Changes that are tried on each claim, one or more at each place of it."""


@dataclass(frozen=True)
class Row:
    """A claim, what was found, and whether it was asked for by name (or only rested on)."""

    claim: Claim
    finding: Finding
    requested: bool = True

    @property
    def as_expected(self) -> bool:
        """True when the verdict is the one the claim must get."""
        return _meets(self.claim.expect, self.finding.verdict)


def _meets(expected: Verdict, verdict: Verdict) -> bool:
    """A stronger verdict than expected is welcome: PROVED where ENCLOSED would do."""
    return verdict is expected or (expected is Verdict.ENCLOSED and verdict is Verdict.PROVED)


@dataclass(frozen=True)
class Report:
    """The ledger: one row per claim, in the order of the proofs."""

    rows: tuple[Row, ...]

    @property
    def counts(self) -> dict[str, int]:
        """How many claims got each verdict; all four are always present."""
        counted = Counter(row.finding.verdict.value for row in self.rows)
        return {v.value: counted[v.value] for v in Verdict}

    @property
    def as_expected(self) -> bool:
        """True when every verdict is the expected one."""
        return all(row.as_expected for row in self.rows)

    def __getitem__(self, label: str) -> Row:
        return next(row for row in self.rows if row.claim.label == label)

    def as_json(self) -> dict[str, Any]:
        """The report as `tresym verify --json` prints it."""
        lines = display_lines()
        return {
            "version": JSON_VERSION,
            "counts": self.counts,
            "prose": [row.claim.label for row in self.rows if not is_formal(row.claim)],
            "claims": [_row_json(row, lines) for row in self.rows],
        }


def display_lines() -> dict[int | None, int]:
    """The line of the paper's source on which each display begins."""
    import json
    from importlib.resources import files

    index = json.loads((files("tresym.proofs") / "index.json").read_text(encoding="utf-8"))
    return {display["number"]: display["line"] for display in index["displays"]}


def verify(
    labels: Iterable[str] = (), on_row: Callable[[Row], None] | None = None, workers: int = 1
) -> Report:
    """Judge every claim, or those named by ``labels`` with all that they rest on.

    Args:
        labels: labels of claims; none means all.
        on_row: called with each row as it is found, for progress.
        workers: processes to look at the evidence in; with 1, this very process.

    Raises:
        InputError: a label that no claim has, claims that no ledger can hold together, or
            processes that keep dying.
    """
    claims = all_claims()
    _need_coherent(claims)
    chosen, requested = _choose(claims, tuple(labels))
    found: dict[str, Finding] = {}
    rows = []
    for claim, evidence in zip(chosen, _evidence(chosen, workers), strict=True):
        found[claim.label] = judge(claim, found, evidence)
        rows.append(Row(claim, found[claim.label], claim.label in requested))
        if on_row is not None:
            on_row(rows[-1])
    return Report(tuple(rows))


def _evidence(claims: tuple[Claim, ...], workers: int) -> Iterator[Finding | None]:
    """What each claim's own evidence comes to, looked at in ``workers`` processes."""
    batches = [claims[n : n + BATCH] for n in range(0, len(claims), BATCH)]
    if workers == 1 or len(batches) == 1:
        yield from (None for _ in claims)
        return
    with Processes(min(workers, len(batches))) as processes:
        asked = [tuple(claim.label for claim in batch) for batch in batches]
        for future in [processes.submit(_evidence_of, a, searching_anew()) for a in asked]:
            try:
                yield from future.result()
            except BrokenExecutor as error:
                raise InputError(f"verify: {error}") from None


def _evidence_of(labels: tuple[str, ...], anew: bool) -> list[Finding | None]:
    """In a process of its own: the evidence of the claims with these labels."""
    known = {claim.label: claim for claim in all_claims()}
    with finding_anew() if anew else nullcontext():
        return [judge_evidence(known[label]) for label in labels]


def save_certificates(report: Report) -> int:
    """Store the box proofs that ``report`` found, for the claims that look for stored ones.

    Returns:
        How many claims were written.

    Raises:
        InputError: the proofs are installed and not a checkout's.
    """
    from tresym.proofs.certificates import save

    found = {
        row.claim.label: row.finding.trees
        for row in report.rows
        if row.finding.trees and isinstance(row.claim.proof, Boxes) and row.claim.proof.stored
    }
    save(found)
    return len(found)


@dataclass(frozen=True)
class MutantRow:
    """What became of the mutants of one claim."""

    claim: Claim
    counts: dict[str, int]
    """How many got each verdict; all four are always present."""
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
        return {v.value: sum(row.counts[v.value] for row in self.rows) for v in Verdict}

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

    using = _dependents(all_claims())
    rows = []
    for claim in (row.claim for row in report.rows if row.requested):
        judged = [(mutant, _judge_mutant(mutant, found)) for mutant in of(claim)]
        counted = Counter(finding.verdict for _, finding in judged)
        counts = {v.value: counted[v] for v in Verdict}
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
    counts = {v.value: int(v is verdict) for v in Verdict}
    survivors = (mutant,) if _believed(claim, verdict) else ()
    stopped = (mutant,) if found[claim.label].stopped else ()
    return MutantRow(claim, counts, survivors, stopped, 1)


def _believed(claim: Claim, verdict: Verdict) -> bool:
    return verdict.holds or (isinstance(claim.proof, Counterexample) and verdict is Verdict.REFUTED)


def _survives(mutant: Mutant, verdict: Verdict) -> bool:
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
            changed[used.label] = Finding(Verdict.PROVED, "a definition that was changed", of=used)
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


def all_claims() -> tuple[Claim, ...]:
    """Every claim of the proofs, each after all that it rests on.

    Raises:
        InputError: a claim that rests on itself.
    """
    from tresym.proofs import claims

    return _foundations_first(claims())


def _foundations_first(claims: Iterable[Claim]) -> tuple[Claim, ...]:
    """These claims and all that they use, each after what it rests on.

    Raises:
        InputError: a claim that rests on itself.
    """
    done: dict[int, Claim] = {}
    open_: set[int] = set()

    def visit(claim: Claim) -> None:
        if id(claim) in open_:
            raise InputError(f"the ledger: {claim.label} rests on itself")
        if id(claim) not in done:
            open_.add(id(claim))
            for used in claim.uses:
                visit(used)
            open_.discard(id(claim))
            done[id(claim)] = claim

    for claim in claims:
        visit(claim)
    return tuple(dict.fromkeys(done.values()))


def _need_coherent(claims: tuple[Claim, ...]) -> None:
    """That a ledger can hold these claims: each label and each symbol once, and nothing in circles.

    Raises:
        InputError: it cannot.
    """
    claims = _foundations_first(claims)
    counted = Counter(claim.label for claim in claims)
    twins = [label for label, count in counted.items() if count > 1]
    why = f"two claims are labelled {quoted(twins[0])}" if twins else conflict(claims)
    if why is not None:
        raise InputError(f"the ledger: {why}")


def sections() -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """The parts of the proofs in the paper's order: a title and the claims stated there."""
    from tresym.proofs import parts

    return parts()


def choose(labels: tuple[str, ...]) -> tuple[Claim, ...]:
    """The claims named by ``labels`` with all that they rest on, foundations first."""
    return _choose(all_claims(), labels)[0]


def _choose(
    claims: tuple[Claim, ...], labels: tuple[str, ...]
) -> tuple[tuple[Claim, ...], frozenset[str]]:
    known = {claim.label: claim for claim in claims}
    if not labels:
        return claims, frozenset(known)
    for label in labels:
        if label not in known:
            near = get_close_matches(label, known, n=1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise InputError(f"no claim is labelled {quoted(label)}{hint}")
    wanted: set[Claim] = set()
    for label in labels:
        wanted |= {known[label], *known[label].rests_on}
    return tuple(claim for claim in claims if claim in wanted), frozenset(labels)


def _row_json(row: Row, lines: dict[int | None, int]) -> dict[str, Any]:
    from tresym.report.latex import given_latex, says_latex

    claim, finding = row.claim, row.finding
    where = claim.where
    return {
        "label": claim.label,
        "requested": row.requested,
        "kind": claim.kind,
        "says": says_latex(claim.says),
        "formal": is_formal(claim),
        "given": [given_latex(condition) for condition in claim.given],
        "verdict": finding.verdict.value,
        "expect": claim.expect.value,
        "value": finding.value and finding.value._asdict(),
        "constant": finding.constant and finding.constant._asdict(),
        "region": finding.region,
        "parameter": finding.parameter,
        "steps": [
            {"verdict": s.verdict.value, "why": s.why, "seconds": round(s.seconds, 6)}
            for s in finding.steps
        ],
        "where": where
        and {
            "display": where.display,
            "line": where.line or lines.get(where.display),
            "cell": where.cell,
        },
        "witness": finding.witness
        and {name: fraction_text(v) for name, v in sorted(finding.witness.items())},
        "amended_by": [claim.label for claim in claim.amended_by],
        "uses": [used.label for used in claim.uses],
        "why": finding.why,
        "seconds": round(finding.seconds, 6),
    }


def graph(labels: tuple[str, ...] = ()) -> str:
    """What rests on what, as a Mermaid flow chart."""
    chosen = choose(labels)
    lines = ["flowchart BT"]
    lines += [f'  {_node(claim)}["{claim.label}"]' for claim in chosen]
    lines += [f"  {_node(claim)} --> {_node(used)}" for claim in chosen for used in claim.uses]
    return "\n".join(lines) + "\n"


def _node(claim: Claim) -> str:
    return "c_" + "".join(c if c.isalnum() and c.isascii() else "_" for c in claim.label)
