"""Verify the ledger: judge every claim, foundations first, into a report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import nullcontext
from dataclasses import dataclass
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
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.exact import InputError, quoted
from tresym.reals.processes import Processes, checked_workers
from tresym.reals.resource_limits import collecting_seldom
from tresym.reals.verdict import Verdict

JSON_VERSION = 1
BATCH = 6
"""Claims that a process takes at once: neighbours, for they share what is remembered."""


SELDOM = 400_000
"""New objects after which Python looks for circles; its own 700 cost a tenth of the time."""


SHOWN = 40
"""Claims that a notebook shows of a report."""


@dataclass(frozen=True)
class Row:
    """A claim, what was found, and whether it was asked for by name (or only rested on).

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
        """A small table for notebooks."""
        rows = [("verdict", self.finding.verdict.value), ("why", self.finding.why)]
        return html_table(self.claim.label, rows) + self.claim._repr_html_()

    def _repr_latex_(self) -> str:
        """The claim, which the verdict is on."""
        return self.claim._repr_latex_()

    @property
    def as_expected(self) -> bool:
        """True when the verdict is the one the claim must get.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].as_expected
            True
        """
        return _meets(self.claim.expect, self.finding.verdict)


def _meets(expected: Ruling, verdict: Ruling) -> bool:
    """A stronger verdict than expected is welcome: PROVED where ENCLOSED would do."""
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

    def __repr__(self) -> str:
        return in_one_line(f"Report({self._said})")

    @property
    def refuted(self) -> dict[str, int]:
        """How many refuted claims are of each kind.

        ``paper``: statements of the paper that do not hold as printed. ``stricter``: readings
        that are stricter than the paper's words. ``sharpness``: claims of our own that are meant
        to fail, which show that a bound cannot be improved.

        Example:
            >>> import tresym
            >>> tresym.verify("d24").refuted["paper"]
            1
        """
        kinds = Counter(
            "stricter" if row.claim.paper_says else "paper" if row.claim.where else "sharpness"
            for row in self.rows
            if row.finding.verdict is Verdict.REFUTED
        )
        return {kind: kinds[kind] for kind in ("paper", "stricter", "sharpness")}

    @property
    def _said(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self.counts.items() if count)
        outcome = "as expected" if self.as_expected else "not as expected"
        return f"{len(self.rows)} claims: {counts}; {outcome}"

    def _repr_html_(self) -> str:
        """The counts, and the claims that were asked for, what is not as expected first."""
        chosen = sorted((row for row in self.rows if row.requested), key=lambda r: r.as_expected)
        rows = [(row.claim.label, row.finding.verdict.value) for row in chosen[:SHOWN]]
        more = [(f"and {len(chosen) - SHOWN} more",)] if len(chosen) > SHOWN else []
        return html_table(self._said, [*rows, *more])

    def _repr_latex_(self) -> str:
        """The counts."""
        return f"$\\text{{{self._said}}}$"

    def to_frame(self) -> Any:
        """The rows as a pandas DataFrame, a line a claim.

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
            raise InputError("to_frame: pandas is not installed") from None
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
        """How many claims got each verdict; all are always present.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma").counts["REFUTED"]
            0
        """
        counted = Counter(row.finding.verdict.value for row in self.rows)
        return {v.value: counted[v.value] for v in RULINGS}

    @property
    def as_expected(self) -> bool:
        """True when every verdict is the expected one.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma").as_expected
            True
        """
        return all(row.as_expected for row in self.rows)

    @property
    def axioms(self) -> dict[Axiom, tuple[Claim, ...]]:
        """The theorems that are quoted, each with the claims of the report that rest on it.

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
        for row in self.rows:
            if row.claim.label == label:
                return row
        near = get_close_matches(str(label), [row.claim.label for row in self.rows], n=1)
        hint = f"; did you mean {near[0]}?" if near else ""
        raise KeyError(f"no claim of this report is labelled {quoted(label)}{hint}")


def verify(
    *labels: str | Iterable[str], on_row: Callable[[Row], None] | None = None, workers: int = 1
) -> Report:
    """Judge every claim, or those named by ``labels`` with all that they rest on.

    Args:
        labels: labels, or lists of them; none means all.
        on_row: called with each row as it is found, for progress.
        workers: processes to look at the evidence in; with 1, this very process.

    Raises:
        InputError: a label that no claim has, claims that no ledger can hold together, or
            processes that keep dying.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"]
        Row(eq_gamma: PROVED)
    """
    asked, workers = _labels(labels), checked_workers(workers)
    found: dict[str, Finding] = {}
    rows = []
    with collecting_seldom(SELDOM):
        claims = paper.all_claims(asked)
        _need_coherent(claims)
        chosen, requested = _choose(claims, asked)
        for claim, evidence in zip(chosen, _evidence(chosen, workers), strict=True):
            found[claim.label] = judge(claim, found, evidence)
            rows.append(Row(claim, found[claim.label], claim.label in requested))
            if on_row is not None:
                on_row(rows[-1])
    return Report(tuple(rows))


def _labels(asked: tuple[Any, ...]) -> tuple[Any, ...]:
    """The labels asked for, one by one or in lists; InputError for anything else."""
    try:
        found = tuple(x for each in asked for x in ((each,) if isinstance(each, str) else each))
    except TypeError:
        found = asked
    if not all(isinstance(label, str) for label in found):
        raise InputError("verify: labels are text, such as eq_gamma")
    return found


def _evidence(claims: tuple[Claim, ...], workers: int) -> Iterator[Finding | None]:
    """What each claim's own evidence comes to, looked at in ``workers`` processes.

    They are copies of this one, in which all claims are at hand.
    """
    batches = [claims[n : n + BATCH] for n in range(0, len(claims), BATCH)]
    if workers == 1 or len(batches) == 1:
        yield from (None for _ in claims)
        return
    with Processes(min(workers, len(batches)), forked=True) as processes:
        asked = [tuple(claim.label for claim in batch) for batch in batches]
        for future in [processes.submit(_evidence_of, a, searching_anew()) for a in asked]:
            try:
                yield from future.result()
            except BrokenExecutor as error:
                raise InputError(f"verify: {error}") from None


def _evidence_of(labels: tuple[str, ...], anew: bool) -> list[Finding | None]:
    """In a process of its own: the evidence of the claims with these labels."""
    known = {claim.label: claim for claim in paper.all_claims(labels)}
    with finding_anew() if anew else nullcontext():
        return [judge_evidence(known[label]) for label in labels]


def save_certificates(report: Report) -> int:
    """Store the box proofs that ``report`` found, for the claims that look for stored ones.

    Returns:
        How many claims were written.

    Raises:
        InputError: the proofs are installed and not a checkout's.
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


def choose(labels: tuple[str, ...]) -> tuple[Claim, ...]:
    """The claims named by ``labels`` with all that they rest on, foundations first."""
    return _choose(paper.all_claims(labels), labels)[0]


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


def graph(labels: tuple[str, ...] = ()) -> str:
    """What rests on what, as a Mermaid flow chart."""
    chosen = choose(labels)
    lines = ["flowchart BT"]
    lines += [f'  {_node(claim)}["{claim.label}"]' for claim in chosen]
    lines += [f"  {_node(claim)} --> {_node(used)}" for claim in chosen for used in claim.uses]
    return "\n".join(lines) + "\n"


def _node(claim: Claim) -> str:
    return "c_" + "".join(c if c.isalnum() and c.isascii() else "_" for c in claim.label)
