"""Verify the ledger: judge every claim, foundations first, into a report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import BrokenExecutor
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from typing import Any

from tresym.ledger import paper
from tresym.ledger.axioms import Axiom
from tresym.ledger.claim import Claim
from tresym.ledger.definitions import conflict
from tresym.ledger.evidence.box_bounds import Boxes, finding_anew, searching_anew
from tresym.ledger.evidence.chart_bounds import Charted
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.finding import RULINGS, Finding, Ruling
from tresym.ledger.judge import judge, judge_evidence
from tresym.ledger.kept_findings import KeptFindings, kept_findings
from tresym.ledger.paper import Paper
from tresym.ledger.sentences import uncompared
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.exact import InputError, quoted
from tresym.reals.processes import Processes, checked_workers
from tresym.reals.resource_limits import collecting_seldom
from tresym.reals.verdict import Verdict

JSON_VERSION = 1
MUTANTS = 5
"""False variants that each claim should have, at least one for each of its places."""
BATCH = 6
"""Number of consecutive claims per task of a process; neighbours share cached results."""


GC_THRESHOLD = 400_000
"""Number of new objects between runs of Python's garbage collector; the default of 700 would cost a
tenth of the time."""


SHOWN = 40
"""Maximal number of claims that a notebook shows of a report."""


@dataclass(frozen=True)
class Row:
    """A claim with its finding; ``requested`` is False if it is only a dependency of others.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"].finding.verdict.value
        'PROVED'
    """

    claim: Claim
    finding: Finding
    requested: bool = True

    def __repr__(self) -> str:
        beside = "" if self.as_expected else f", expected {self.claim.expect.value}"
        return in_one_line(f"Row({self.claim.label}: {self.finding.verdict.value}{beside})")

    def _repr_html_(self) -> str:
        """Return a small HTML table for notebooks."""
        rows = [("verdict", self.finding.verdict.value), ("why", self.finding.why)]
        return html_table(self.claim.label, rows) + self.claim._repr_html_()

    def _repr_latex_(self) -> str:
        """Return LaTeX of the claim."""
        return self.claim._repr_latex_()

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the expected one, or stronger (PROVED instead of ENCLOSED).

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].as_expected
            True
        """
        return _meets(self.claim.expect, self.finding.verdict)


def _meets(expected: Ruling, verdict: Ruling) -> bool:
    """Return whether the verdict is the expected one, or PROVED where ENCLOSED is expected."""
    return verdict is expected or (expected is Verdict.ENCLOSED and verdict is Verdict.PROVED)


@dataclass(frozen=True)
class Report:
    """The ledger: one row per claim, in the order of the proofs.

    Example:
        >>> import tresym
        >>> report = tresym.verify(["eq_gamma", "eq_Mi"])
        >>> [row for row in report.rows if row.requested]
        [Row(eq_Mi: PROVED), Row(eq_gamma: PROVED)]
    """

    rows: tuple[Row, ...]
    aliases: Mapping[str, str] = field(default_factory=dict, repr=False)
    """Labels by readable names, both of which find a row."""

    def __repr__(self) -> str:
        return in_one_line(f"Report({self._said})")

    @property
    def refuted(self) -> dict[str, int]:
        """The number of refuted claims of each kind.

        ``paper`` counts statements of the paper that do not hold as printed; ``stricter`` counts
        readings that are stricter than the paper's words; ``sharpness`` counts auxiliary claims
        that are false on purpose, to show that a bound cannot be improved. A claim that was
        expected to hold is none of them.

        Example:
            >>> import tresym
            >>> tresym.verify("d24").refuted["paper"]
            1
        """
        kinds = Counter(
            "stricter" if row.claim.paper_says else "paper" if row.claim.where else "sharpness"
            for row in self.rows
            if row.finding.verdict is row.claim.expect is Verdict.REFUTED
        )
        return {kind: kinds[kind] for kind in ("paper", "stricter", "sharpness")}

    @property
    def _said(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self.counts.items() if count)
        outcome = "as expected" if self.as_expected else "not as expected"
        return f"{len(self.rows)} claims: {counts}; {outcome}"

    def _repr_html_(self) -> str:
        """Return the counts and the requested claims, unexpected verdicts first."""
        chosen = sorted((row for row in self.rows if row.requested), key=lambda r: r.as_expected)
        rows = [(row.claim.label, row.finding.verdict.value) for row in chosen[:SHOWN]]
        more = [(f"and {len(chosen) - SHOWN} more",)] if len(chosen) > SHOWN else []
        return html_table(self._said, [*rows, *more])

    def _repr_latex_(self) -> str:
        """Return the counts as LaTeX text."""
        return f"$\\text{{{self._said}}}$"

    def to_frame(self) -> Any:
        """Return the rows as a pandas DataFrame, one row per claim.

        Raises:
            InputError: pandas is not installed.

        Example:
            >>> import tresym
            >>> frame = tresym.verify("d24").to_frame()  # doctest: +SKIP
            >>> frame[frame.verdict == "REFUTED"].label.tolist()  # doctest: +SKIP
            ['d24']
        """
        try:
            import pandas
        except ImportError:
            raise InputError("to_frame needs pandas, which is not installed") from None
        return pandas.DataFrame(
            {
                "label": row.claim.label,
                "kind": row.claim.kind,
                "verdict": row.finding.verdict.value,
                "as_expected": row.as_expected,
                "requested": row.requested,
                "why": row.finding.why,
            }
            for row in self.rows
        )

    @property
    def counts(self) -> dict[str, int]:
        """The number of claims with each verdict; verdicts that do not occur are counted as 0.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma").counts["REFUTED"]
            0
        """
        counted = Counter(row.finding.verdict.value for row in self.rows)
        return {v.value: counted[v.value] for v in RULINGS}

    @property
    def as_expected(self) -> bool:
        """Whether every verdict is the expected one.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma").as_expected
            True
        """
        return all(row.as_expected for row in self.rows)

    @property
    def axioms(self) -> dict[Axiom, tuple[Claim, ...]]:
        """The quoted theorems, each with the claims of the report that depend on it.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma").axioms
            {}
        """
        resting: dict[Axiom, tuple[Claim, ...]] = {}
        for row in self.rows:
            for axiom in row.claim.axioms:
                resting[axiom] = (*resting.get(axiom, ()), row.claim)
        return resting

    def __getitem__(self, label: str) -> Row:
        wanted = self.aliases.get(label, label)
        for row in self.rows:
            if row.claim.label == wanted:
                return row
        near = get_close_matches(str(label), [row.claim.label for row in self.rows], n=1)
        hint = f"; did you mean {near[0]}?" if near else ""
        raise KeyError(f"no claim of this report is labelled {quoted(label)}{hint}")


def verify(
    *labels: str | Iterable[str],
    on_row: Callable[[Row], None] | None = None,
    workers: int = 1,
    of: Paper | None = None,
) -> Report:
    """Judge all claims of a paper, or those with these labels and their dependencies.

    Args:
        labels: labels or readable names, or lists of them; without any, all claims are judged.
        on_row: a function that is called with each row as soon as it is known, or None.
        workers: the number of processes that check evidence; 1 uses the current process.
        of: the paper; that on the racket unless given.

    Raises:
        InputError: no claim has one of the labels, two claims have the same label or conflicting
            definitions, or worker processes die repeatedly.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"]
        Row(eq_gamma: PROVED)
    """
    whose = paper.racket() if of is None else of
    asked = tuple(map(whose.label_of, _labels(labels)))
    workers = checked_workers(workers)
    found: dict[str, Finding] = {}
    rows = []
    folder = whose.folder if of is None and not searching_anew() else None
    with collecting_seldom(GC_THRESHOLD), kept_findings(folder) as kept:
        claims = _claims_of(of, asked)
        _need_coherent(claims)
        chosen, requested = _choose(claims, asked, whose.labels_by_alias)
        for claim, evidence in zip(chosen, _all_evidence(chosen, workers, of, kept), strict=True):
            finding = judge(claim, found, evidence)
            found[claim.label] = _compared(claim, finding) if of is None else finding
            rows.append(Row(claim, found[claim.label], claim.label in requested))
            if on_row is not None:
                on_row(rows[-1])
    return Report(tuple(rows), whose.labels_by_alias)


_PAPERS: dict[str, Paper] = {}
"""The papers that forked processes judge, by name."""


def _claims_of(of: Paper | None, labels: Iterable[str]) -> tuple[Claim, ...]:
    """Return the claims of a paper; those of the paper on the racket if it is None."""
    return paper.all_claims(labels) if of is None else of.all_claims(labels)


def _compared(claim: Claim, finding: Finding) -> Finding:
    """Return the finding, or UNDECIDED if the sentence was not compared with its formula."""
    why = uncompared(claim)
    return finding if why is None else replace(finding, verdict=Verdict.UNDECIDED, why=why)


def _labels(asked: tuple[Any, ...]) -> tuple[Any, ...]:
    """Flatten the labels, given one by one or in lists; InputError for anything else."""
    try:
        found = tuple(x for each in asked for x in ((each,) if isinstance(each, str) else each))
    except TypeError:
        found = asked
    if not all(isinstance(label, str) for label in found):
        raise InputError("verify: labels must be strings, such as 'eq_gamma'")
    return found


def _all_evidence(
    claims: tuple[Claim, ...], workers: int, of: Paper | None, kept: KeptFindings
) -> Iterator[Finding | None]:
    """Yield the finding on each claim's own evidence: the one that is kept, or a new one."""
    known = {claim.label: kept.get(claim.label) for claim in claims}
    new = _evidence(tuple(claim for claim in claims if known[claim.label] is None), workers, of)
    for claim in claims:
        found = known[claim.label]
        if found is None:
            found = next(new)
            if found is not None:
                kept.put(claim.label, found)
        yield found


def _evidence(
    claims: tuple[Claim, ...], workers: int, of: Paper | None = None
) -> Iterator[Finding | None]:
    """Yield the finding on each claim's own evidence, computed in ``workers`` processes.

    The processes are forks of the current one, so they have all claims in memory.
    """
    batches = [claims[n : n + BATCH] for n in range(0, len(claims), BATCH)]
    if workers == 1 or len(batches) <= 1:
        yield from map(judge_evidence, claims)
        return
    name = "" if of is None else of.name
    if of is not None:
        _PAPERS[name] = of
    with Processes(min(workers, len(batches)), forked=True) as processes:
        asked = [tuple(claim.label for claim in batch) for batch in batches]
        for future in [processes.submit(_evidence_of, a, searching_anew(), name) for a in asked]:
            try:
                yield from future.result()
            except BrokenExecutor as error:
                raise InputError(f"verify: {error}") from None


def _evidence_of(labels: tuple[str, ...], anew: bool, name: str = "") -> list[Finding | None]:
    """Judge the evidence of the claims with these labels; runs in a worker process."""
    known = {claim.label: claim for claim in _claims_of(_PAPERS.get(name), labels)}
    with finding_anew() if anew else nullcontext():
        return [judge_evidence(known[label]) for label in labels]


def save_certificates(report: Report) -> int:
    """Store the box proofs in ``report`` of those claims that read stored proofs.

    Returns:
        The number of claims whose proofs were written.

    Raises:
        InputError: tresym does not run from a checkout of its repository.
    """
    from tresym.ledger.certificates import save

    found = {
        row.claim.label: row.finding.trees
        for row in report.rows
        if row.finding.trees
        and isinstance(row.claim.proof, Boxes | Charted | Evaluated)
        and row.claim.proof.stored
    }
    save(found)
    return len(found)


def _foundations_first(claims: Iterable[Claim]) -> tuple[Claim, ...]:
    """Return the claims and their dependencies in topological order, dependencies first.

    Raises:
        InputError: a claim depends on itself.
    """
    done: dict[int, Claim] = {}
    open_: set[int] = set()

    def visit(claim: Claim) -> None:
        if id(claim) in open_:
            raise InputError(f"the ledger is circular: {claim.label} depends on itself")
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
    """Require that labels are unique, definitions consistent and dependencies not circular.

    Raises:
        InputError: one of these does not hold.
    """
    claims = _foundations_first(claims)
    counted = Counter(claim.label for claim in claims)
    twins = [label for label, count in counted.items() if count > 1]
    why = f"two claims are labelled {quoted(twins[0])}" if twins else conflict(claims)
    if why is not None:
        raise InputError(f"the ledger: {why}")


def choose(labels: tuple[str, ...], of: Paper | None = None) -> tuple[Claim, ...]:
    """Return the claims with these labels and their dependencies, dependencies first."""
    whose = paper.racket() if of is None else of
    asked = tuple(map(whose.label_of, labels))
    return _choose(whose.all_claims(asked), asked, whose.labels_by_alias)[0]


def _choose(
    claims: tuple[Claim, ...], labels: tuple[str, ...], aliases: Iterable[str] = ()
) -> tuple[tuple[Claim, ...], frozenset[str]]:
    known = {claim.label: claim for claim in claims}
    if not labels:
        return claims, frozenset(known)
    for label in labels:
        if label not in known:
            near = get_close_matches(label, [*known, *aliases], n=1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise InputError(f"no claim is labelled {quoted(label)}{hint}")
    wanted: set[Claim] = set()
    for label in labels:
        wanted |= {known[label], *known[label].rests_on}
    return tuple(claim for claim in claims if claim in wanted), frozenset(labels)


def graph(labels: tuple[str, ...] = (), of: Paper | None = None) -> str:
    """Return the dependency graph of the claims as a Mermaid flow chart.

    Args:
        labels: the claims to show with their dependencies; all if empty.
        of: the paper; that on the racket unless given.
    """
    chosen = choose(labels, of)
    lines = ["flowchart BT"]
    lines += [f'  {_node(claim)}["{claim.label}"]' for claim in chosen]
    lines += [f"  {_node(claim)} --> {_node(used)}" for claim in chosen for used in claim.uses]
    return "\n".join(lines) + "\n"


def _node(claim: Claim) -> str:
    return "c_" + "".join(c if c.isalnum() and c.isascii() else "_" for c in claim.label)
