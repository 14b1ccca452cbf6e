"""Decide the claims of a file, and show that its definitions define something.

A claim is decided by :mod:`tresym.checking`, each step of a derivation by itself, and gets the
verdict of its weakest step.

The root of ``f`` between two ends exists and is the only one if ``f`` is smooth between them, has
values of opposite signs at the ends, and increases or decreases strictly (intermediate and mean
value theorem). These statements are decided like any claim. The root of an equation without
parameters may also be enclosed in balls, which shows the same. If neither succeeds, neither the
definition nor a claim about the root counts as shown.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from tresym.accuracy.values import value
from tresym.checking.answer_cache import cached_answers
from tresym.checking.time_limited import Task, check_all
from tresym.ledger.finding import RULINGS, WEAKEST_FIRST, Premise, Ruling
from tresym.papers.definitions import Definition, names_in
from tresym.papers.reading import OwnPaper, PaperClaim
from tresym.reals.decisions.answer import Alternative, Answer, worst
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    fresh,
    instantiate,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp, time_limit
from tresym.reals.signs.definedness import continuous_on, undefined
from tresym.reals.verdict import Verdict
from tresym.repair import suggestions

LIMIT = 40.0
"""The processor time in seconds for one claim."""
DEFINEDNESS = 2.0
"""The seconds in which a definition is shown to have a value."""
UNDECIDED = Verdict.UNDECIDED
_LOOK_ALIKE = re.compile(r"; (?:e|i|I) is read as a variable, not [^;]*")
"""A remark on the letters e and i, which a file declares as variables."""


@dataclass(frozen=True)
class Row:
    """The result for one claim or definition.

    Attributes:
        item: the claim or the definition.
        verdict: its verdict; DEFINED for a definition, ASSUMED for a quoted claim that is not
            proved here.
        why: the reason.
        answers: the answers to the steps, in order.
        axioms: the labels of quoted claims that are not proved here and on which it rests.
        instead: true claims close to a refuted one.
        seconds: processor time of the decisions.
        requested: whether it was asked for, rather than only used by what was.
    """

    item: PaperClaim | Definition
    verdict: Ruling
    why: str
    answers: tuple[Answer, ...] = ()
    axioms: tuple[str, ...] = ()
    instead: tuple[Alternative, ...] = ()
    seconds: float = field(default=0.0, compare=False)
    requested: bool = True

    @property
    def label(self) -> str:
        """The label of the claim, or the name that is defined."""
        return self.item.label if isinstance(self.item, PaperClaim) else self.item.name

    @property
    def decisive(self) -> Answer | None:
        """The answer that determines the verdict."""
        return worst(self.answers) if self.answers else None

    @property
    def as_expected(self) -> bool:
        """Whether the claim holds, or is refuted as the file expects."""
        if isinstance(self.item, PaperClaim) and self.item.expect_refuted:
            return self.verdict is Verdict.REFUTED
        return self.verdict.holds

    def as_json(self) -> dict[str, Any]:
        """A JSON value; every key is always there."""
        answer = self.decisive
        found: dict[str, Any] = {
            "label": self.label,
            "requested": self.requested,
            "kind": "definition",
            "says": "",
            "means": [],
            "formal": True,
            "given": "",
            "verdict": self.verdict.value,
            "why": self.why,
            "expect": None,
            "value": None,
            "constant": None
            if answer is None or not answer.constant
            else answer.constant._asdict(),
            "region": None if answer is None else answer.region,
            "parameter": None,
            "steps": [one.as_json() for one in self.answers],
            "where": self.item.line,
            "witness": None if answer is None or not answer.witness else dict(answer.witness),
            "amended_by": [f"{one.claim} given {one.given}" for one in self.instead],
            "place": self.item.place or None,
            "uses": [],
            "axioms": list(self.axioms),
            "coq": None,
            "seconds": round(self.seconds, 6),
        }
        if isinstance(self.item, Definition):
            own = {"says": f"{self.item.head} := {self.item.text}"}
            return found | own | {"given": chained(self.item.given)}
        claim = self.item
        return found | {
            "kind": claim.kind,
            "says": claim.text,
            "means": [*claim.meanings],
            "given": chained(claim.conditions),
            "expect": "REFUTED" if claim.expect_refuted else None,
            "value": claim.rounded or None,
            "parameter": claim.path,
            "uses": [*claim.uses, *claim.rests_on],
            "amended_by": [*claim.instead, *found["amended_by"]],
        }


@dataclass(frozen=True)
class PaperReport:
    """The results for a file of claims.

    Attributes:
        paper: the file as it was read.
        rows: one for each definition and claim, in the order of the file.
    """

    paper: OwnPaper
    rows: tuple[Row, ...]

    @cached_property
    def by_label(self) -> Mapping[str, Row]:
        """The rows by label or name."""
        return {row.label: row for row in self.rows}

    def __getitem__(self, label: str) -> Row:
        return self.by_label[label]

    @property
    def counts(self) -> dict[Ruling, int]:
        """How many rows have which verdict."""
        found = Counter(row.verdict for row in self.rows)
        return {ruling: found[ruling] for ruling in RULINGS}

    @property
    def as_expected(self) -> bool:
        """Whether every line is read, and every verdict as the file expects."""
        return not self.paper.problems and all(row.as_expected for row in self.rows)

    def as_json(self) -> dict[str, Any]:
        """A JSON value, with the problems of the file."""
        import tresym

        return {
            "version": tresym.__version__,
            "file": self.paper.name,
            "counts": {ruling.value: number for ruling, number in self.counts.items()},
            "problems": [problem._asdict() for problem in self.paper.problems],
            "claims": [row.as_json() for row in self.rows],
        }

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {ruling.value}" for ruling, n in self.counts.items() if n)
        return f"PaperReport({self.paper.name}: {counts})"


def verify_paper(
    paper: OwnPaper,
    labels: Iterable[str] = (),
    limit: float = LIMIT,
    processes: int | None = None,
    on_row: Callable[[Row], None] | None = None,
    cached: bool = True,
    suggest: bool = True,
) -> PaperReport:
    """Decide the claims of a file and what they use.

    Args:
        paper: the file.
        labels: the claims; all if there are none.
        limit: the seconds for each claim.
        processes: the number of processes; one for each core unless given.
        on_row: is called with each row as soon as it is known.
        cached: whether answers are taken from the user's cache and stored there.
        suggest: whether to search for true claims close to a refuted one.

    Raises:
        InputError: a label that no claim has.
    """
    asked = {claim.label for claim in paper.chosen(labels)}
    wanted = _needed(paper, asked)
    rows: dict[str, Row] = {}
    with cached_answers() if cached else nullcontext():
        items = [
            item
            for item in paper.items
            if isinstance(item, PaperClaim | Definition) and _key(item) in wanted
        ]
        answers = _answers(items, limit, processes)
        wider: dict[Expr, Expr] = {}
        for item in items:
            found = next(answers)
            if isinstance(item, PaperClaim):
                found = _with_wider_roots(item, found, wider, limit, processes)
                row = _claim_row(item, found, rows)
            else:
                row = _definition_row(item, found, rows)
                wider |= _wider_roots(item, found) if row.verdict.holds else {}
            if suggest and row.verdict is Verdict.REFUTED:
                row = replace(row, instead=_instead(row, processes))
            row = replace(row, requested=not labels or _key(item) in asked)
            rows[_key(item)] = row
            if on_row is not None:
                on_row(row)
    return PaperReport(paper, tuple(rows.values()))


def _key(item: PaperClaim | Definition) -> str:
    """A label and the name of a definition may be the same word."""
    return item.label if isinstance(item, PaperClaim) else f":= {item.name}"


def _needed(paper: OwnPaper, labels: Iterable[str]) -> set[str]:
    """The keys of claims, of what they use, and of the definitions that stand in them."""
    found: set[str] = set()
    open_labels = list(labels)
    while open_labels:
        claim = paper.claims[open_labels.pop()]
        if claim.label not in found:
            found |= {claim.label, *(f":= {name}" for name in claim.rests_on)}
            open_labels += claim.uses
    if set(paper.claims) <= found:
        return found | {f":= {name}" for name in paper.definitions}
    for definition in reversed(tuple(paper.definitions.values())):
        if f":= {definition.name}" in found:
            names = names_in(definition.written)
            found |= {f":= {name}" for name in names if name in paper.definitions}
    return found


def _questions(item: PaperClaim | Definition) -> list[Task]:
    """The statements that decide a claim, or show that a root exists."""
    if isinstance(item, Definition):
        return [task for root in _roots(item.expression) for task in _root_tasks(root, item)]
    moving = read_path(item.path).name if item.near_end and item.path else ""
    plain = tuple(
        (left, sign, right)
        for left, sign, right in item.conditions
        if sign == "in"
        or not (sign == "==" or left.hidden or right.hidden or moving in symbols(left + right))
    )
    return [
        *(Task(*asked, item.line) for asked in item.asked if not item.assumed),
        *(_task(link, (), None, item.line) for link in item.must_hold),
        *(_task(link, plain, item.path, item.line) for link in item.near_end),
        *(_task(*part, item.line) for part in item.required),
    ]


def _task(
    link: Compared, given: tuple[Compared, ...], path: str | None, line: int | None = None
) -> Task:
    return Task(chained((link,)), chained(given), path, line)


def _answers(
    items: list[PaperClaim | Definition], limit: float, processes: int | None
) -> Iterator[list[Answer]]:
    """Yield the answers to the questions of each item."""
    asked = [_questions(item) for item in items]
    found = check_all((task for tasks in asked for task in tasks), limit, processes)
    for tasks in asked:
        yield [_answered(next(found)) for _ in tasks]


def _answered(pair: tuple[Task, Answer | InputError]) -> Answer:
    task, found = pair
    if isinstance(found, InputError):
        return Answer(UNDECIDED, f"the claim is not supported: {found}", str(task.claim))
    return found


PER_ROOT = 8
"""The number of statements about each root of a definition."""


def _wider_roots(definition: Definition, found: list[Answer]) -> dict[Expr, Expr]:
    """Return the roots whose ends do not matter, and the same roots between −∞ and ∞.

    A function that is smooth and strictly monotone on the whole line has no other zero.
    """
    same: dict[Expr, Expr] = {}
    for n, root in enumerate(_roots(definition.expression)):
        slopes = found[PER_ROOT * n + 6 : PER_ROOT * n + PER_ROOT]
        name = fresh(root.names[0], symbols(root))
        body = instantiate(root.args[0], (symbol(name),))
        if any(a.verdict.holds for a in slopes) and _is_smooth(body, _given(definition.given)):
            same[root] = Expr("root", (root.args[0], -INFINITY, INFINITY), root.names)
    return same


def _is_smooth(body: Expr, given: Given) -> bool:
    try:
        with time_limit(DEFINEDNESS):
            return continuous_on(body, given) is None
    except TimeUp:
        return False


def _with_wider_roots(
    claim: PaperClaim,
    found: list[Answer],
    wider: Mapping[Expr, Expr],
    limit: float,
    processes: int | None,
) -> list[Answer]:
    """Decide the undecided steps of an asymptotic claim again with the ends of roots left out."""
    values = {value.name: value.value for value in claim.at}
    put = {substitute(x, values): substitute(y, values) for x, y in wider.items()}
    again = {}
    for n, (left, relation, right) in enumerate(claim.links):
        other = replaced(left, put), relation, replaced(right, put)
        if claim.path and found[n].verdict is UNDECIDED and other != (left, relation, right):
            given = chained(claim.conditions)
            again[n] = Task(claim.asserted(other), given, claim.path, claim.line)
    answers = [*found]
    for n, pair in zip(again, check_all(again.values(), limit, processes), strict=True):
        answer = _answered(pair)
        if answer.verdict is not UNDECIDED:
            answers[n] = answer
    return answers


def _claim_row(claim: PaperClaim, found: list[Answer], rows: Mapping[str, Row]) -> Row:
    """The row of a claim, once everything it uses has one."""
    count = 0 if claim.assumed else len(claim.asked)
    steps = tuple(found[:count])
    others = found[count:]
    must, others = others[: len(claim.must_hold)], others[len(claim.must_hold) :]
    near, required = others[: len(claim.near_end)], others[len(claim.near_end) :]
    seconds = sum(answer.seconds for answer in found)
    answer = worst(steps) if steps else _ALL_HOLD
    verdict: Ruling = answer.verdict
    why = _LOOK_ALIKE.sub("", answer.why)
    for label in claim.joined:
        row = rows.get(label)
        if row is not None and _is_weaker(row.verdict, verdict):
            verdict, why = row.verdict, f"{label}: {row.why}"
    if claim.is_derivation and answer.verdict is not Verdict.PROVED:
        number = steps.index(answer) + 1
        why = f"step {number} of {len(steps)}: {why}"
    for link, one in zip(claim.must_hold, must, strict=True):
        if not one.verdict.holds:
            verdict = UNDECIDED
            why = f"the values do not satisfy the declared condition {chained((link,))}"
    for link, one in zip(claim.near_end, near, strict=True):
        if not one.verdict.holds:
            verdict = UNDECIDED
            why = (
                f"the condition {chained((link,))} is not shown to hold near the end of the path "
                f"{claim.path}: write a path on which it does, such as x -> 0+ for x -> 0"
            )
    for part, one in zip(claim.required, required, strict=True):
        if not one.verdict.holds:
            verdict = UNDECIDED
            why = (
                f"the declared condition {chained((part.link,))} is not shown to hold where the "
                "claim speaks: use another letter for its variable"
            )
    axioms: list[str] = []
    for key in (*claim.uses, *(f":= {name}" for name in claim.rests_on)):
        row = rows.get(key)
        if row is None:
            continue
        axioms += row.axioms
        if row.verdict is Premise.ASSUMED:
            axioms.append(row.label)
        if not row.verdict.holds and (verdict.holds or verdict is Verdict.REFUTED):
            verdict, why = UNDECIDED, f"it depends on {row.label}, which is {row.verdict.value}"
    if claim.restricted and verdict is Verdict.REFUTED:
        verdict = UNDECIDED
        why = f"it fails at a point where {', '.join(claim.restricted)} need not hold ({why})"
    if claim.assumed and verdict is not Verdict.REFUTED:
        return Row(claim, Premise.ASSUMED, "it is assumed from here on", steps, seconds=seconds)
    if claim.source and verdict is UNDECIDED:
        verdict, why = Premise.ASSUMED, f"quoted from {claim.source}, not proved here ({why})"
    return Row(claim, verdict, why, steps, tuple(dict.fromkeys(axioms)), seconds=seconds)


_ALL_HOLD = Answer(Verdict.PROVED, "all of these claims hold")


def _is_weaker(one: Ruling, other: Ruling) -> bool:
    """Whether a conjunction has the first of two verdicts."""
    return WEAKEST_FIRST.index(one) < WEAKEST_FIRST.index(other)


def _instead(row: Row, processes: int | None) -> tuple[Alternative, ...]:
    answer = row.decisive
    if answer is None:
        return ()
    if isinstance(row.item, PaperClaim) and row.item.rounded:
        return ()
    return next(suggestions([(answer.read_as, (), False, True)], processes))


def _roots(e: Expr) -> list[Expr]:
    """The roots in an expression that are not inside of another operation with a variable."""
    if e.op == "root":
        return [e]
    if e.op in LEAVES or e.names:
        return []
    return [root for arg in e.args if isinstance(arg, Expr) for root in _roots(arg)]


def _root_tasks(root: Expr, definition: Definition) -> list[Task]:
    """The statements that show that there is exactly one root.

    They are, for an increasing function and for a decreasing one: its sign at the lower end, at the
    upper end, and that of its slope between; and last the sign of its slope everywhere, which is
    not needed for the root.
    """
    low, high = root.args[1:]
    said = (symbols(side) for link in definition.given for side in link[::2])
    name = fresh(root.names[0], symbols(root).union(*said))
    body = instantiate(root.args[0], (symbol(name),))
    line, given = definition.line, definition.given
    tasks = []
    for below, above in (("<", ">"), (">", "<")):
        for end, sign in ((low, below), (high, above)):
            if end in (INFINITY, -INFINITY):
                where = "oo" if end == INFINITY else "-oo"
                tasks.append(_task((body, sign, ZERO), given, f"{name} -> {where}", line))
            else:
                tasks.append(
                    _task((instantiate(root.args[0], (end,)), sign, ZERO), given, None, line)
                )
        between = (*given, *_between(name, root))
        text = f"diff({body}, {name}) {above} 0"
        tasks.append(Task(text, chained(between), None, line))
    tasks += [Task(f"diff({body}, {name}) {sign} 0", chained(given), None, line) for sign in "><"]
    return tasks


def _between(name: str, root: Expr) -> Iterator[Compared]:
    low, high = root.args[1:]
    if low not in (INFINITY, -INFINITY):
        yield low, "<", symbol(name)
    if high not in (INFINITY, -INFINITY):
        yield symbol(name), "<", high


def _definition_row(definition: Definition, found: list[Answer], rows: Mapping[str, Row]) -> Row:
    """The row of a definition: whether its value is shown to exist."""
    seconds = sum(answer.seconds for answer in found)
    for name in names_in(definition.written):
        used = rows.get(f":= {name}")
        if used is not None and not used.verdict.holds:
            why = f"it depends on {name}, which is not shown to be defined"
            return Row(definition, UNDECIDED, why, seconds=seconds)
    roots = _roots(definition.expression)
    for n, root in enumerate(roots):
        six = found[PER_ROOT * n : PER_ROOT * n + 6]
        increases, decreases = (all(a.verdict.holds for a in part) for part in (six[:3], six[3:]))
        why = _gap_of_root(root, definition, six, increases, decreases)
        if why and not _is_enclosed(root):
            return Row(definition, UNDECIDED, why, seconds=seconds)
    if roots and not any(all(a.verdict.holds for a in part) for part in (found[:3], found[3:6])):
        why = "exactly one root, by interval arithmetic between the ends"
        return Row(definition, Premise.DEFINED, why, seconds=seconds)
    if roots:
        slope = "increases" if found[2].verdict.holds else "decreases"
        why = (
            f"exactly one root: the function {slope} strictly and changes its sign between the ends"
        )
        return Row(definition, Premise.DEFINED, why, seconds=seconds)
    gap = _gap(definition.expression, _given(definition.given))
    return Row(
        definition,
        Premise.DEFINED,
        gap if gap else "it has a value wherever the declared conditions hold",
        seconds=seconds,
    )


def _is_enclosed(root: Expr) -> bool:
    """Whether the root of an equation without parameters is shown to exist alone, in balls."""
    try:
        return not symbols(root) - {INFINITY.args[0]} and bool(value(root, 10))
    except InputError:
        return False


def _gap_of_root(
    root: Expr, definition: Definition, six: list[Answer], increases: bool, decreases: bool
) -> str:
    """Return what is not shown of the root, or ""."""
    if not (increases or decreases):
        rising = sum(a.verdict.holds for a in six[:3]) >= sum(a.verdict.holds for a in six[3:])
        part = six[:3] if rising else six[3:]
        missing = next(a for a in part if not a.verdict.holds)
        return (
            "it is not shown that there is exactly one root: "
            f"{missing.read_as or missing.statement} is {missing.verdict.value} ({missing.why})"
        )
    name = fresh(root.names[0], symbols(root))
    body = instantiate(root.args[0], (symbol(name),))
    given = _given((*definition.given, *((x, "<=", y) for x, _, y in _between(name, root))))
    try:
        with time_limit(DEFINEDNESS):
            gap = continuous_on(body, given)
    except TimeUp:
        return "it is not shown in time that the function is smooth between the ends"
    return (
        ""
        if gap is None
        else f"it is not shown that the function is smooth between the ends: {gap}"
    )


def _given(conditions: Iterable[Compared]) -> Given:
    return Given(tuple(link for link in conditions if link[1] not in ("==", "in"))).unfolded()


def _gap(e: Expr, given: Given) -> str:
    """Return what is not shown of the domain of a definition, or ""."""
    try:
        with time_limit(DEFINEDNESS):
            gap = undefined(e, given)
    except TimeUp:
        gap = e
    return "" if gap is None else f"claims hold where {gap} lies in the domain of its operation"
