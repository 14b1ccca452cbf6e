"""Decide what reading leaves open, many links at once, and give each link a status."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from tresym.checking.time_limited import Task, check_all, check_within
from tresym.manuscript import accusations, prose
from tresym.manuscript.attempts import answers_to
from tresym.manuscript.classification import (
    CUT,
    DEFINED,
    EQUATION,
    SHARED,
    UNREAD,
    Attempt,
    Link,
    Obstacle,
)
from tresym.manuscript.consequences import (
    Context,
    Difference,
    Fact,
    Search,
    Step,
    difference,
    fact,
    learn,
)
from tresym.manuscript.instances import instances
from tresym.manuscript.mentions import names_in
from tresym.manuscript.multiples import multiple_of
from tresym.manuscript.solutions import Solves
from tresym.manuscript.terms import base_of
from tresym.reals.decisions.answer import Alternative, Answer
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import ONE, ZERO, Expr, symbols
from tresym.reals.language.formula import chained
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause, Verdict

FAR = 40
"""The links before a proved one among which the equation is sought that it restates."""
NEAR = 40
"""The links before an equation among which those are sought that it follows from."""
COORDINATE = re.compile(r"[xyzuvw]\d*")
"""Letters that take all real values in most texts."""
PASSES = (Verdict.PROVED.value, Verdict.ENCLOSED.value)
STATUSES = (*(v.value for v in Verdict), "SUSPECT", "DEFINED", "ASSUMED", EQUATION, UNREAD)


@dataclass(frozen=True)
class Row:
    """A link and its status.

    Attributes:
        status: one of ``STATUSES``.
        why: the reason, for a reader.
        witness: for REFUTED and SUSPECT, the counterexample: names to exact numbers.
        given: the conditions of the claim that was decided.
        seconds: processor time.
        instead: for REFUTED and SUSPECT, true statements close to it.
        refuted: the claim that fails, in the grammar of ``tresym check``; empty if none does.
        put: the values that were substituted for symbols, where it passes or where it fails.
        fails_at: a point at which it fails, whatever its status.
        cause: what decided its last claim, or what stopped the decision.
        obstacle: what the author can remove, if it is not decided.
        failing: the claim that fails, with the substitutions.
        holds_given: conditions that the text does not state and under which it is proved.
    """

    link: Link
    status: str
    why: str
    witness: dict[str, str] | None = None
    given: str = ""
    seconds: float = 0.0
    instead: tuple[Alternative, ...] = ()
    refuted: str = ""
    put: tuple[tuple[str, Expr], ...] = ()
    fails_at: dict[str, str] | None = None
    cause: Cause | None = None
    obstacle: Obstacle | None = None
    failing: str = ""
    holds_given: str = ""

    def as_json(self) -> dict[str, Any]:
        """Return a JSON value; every key is always present."""
        display = self.link.display
        return {
            "display": display.number,
            "line": display.line,
            "file": display.file or None,
            "label": display.labels[0] if display.labels else None,
            "link": self.link.number,
            "read_as": self.link.read_as,
            "status": self.status,
            "why": self.why,
            "witness": self.witness,
            "instead": [found._asdict() for found in self.instead],
            "latex": self.link.shown,
            "seconds": round(self.seconds, 6),
        }


def decided(
    links: Sequence[Link],
    limit: float,
    processes: int | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
    keep: bool = False,
) -> list[Row]:
    """Decide the claims of all links, in parallel, and return a row for each link.

    Args:
        limit: seconds for each claim.
        processes: how many to use; None for one per core.
        progress: called with the number of links done and their total.
        keep: after Ctrl-C, return what is done; the other rows say that they were interrupted.
    """
    asked = [*links, *(link.second for link in links if link.second is not None)]
    answers = answers_to(asked, limit, processes, progress, keep)
    own = [(link, answers.get(n, [])) for n, link in enumerate(asked)]
    rows = [_failing(_row(link, found, limit), found) for link, found in own]
    rows = _solving(rows, limit, processes)
    rows = _restating(rows, limit, processes)
    rows = _varied(rows, answers, limit, processes)
    rows = _following(rows, limit, processes)
    rows = _where_positive(rows, limit, processes)
    rows = _by_euler_number(rows, limit, processes)
    found = [(row, answers.get(n, [])) for n, row in enumerate(rows)]
    seconds = iter(found[len(links) :])
    return [
        row if link.second is None else _of_both((row, own), next(seconds))
        for link, (row, own) in zip(links, found[: len(links)], strict=True)
    ]


def _solving(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; a solution of what turned out to be no equation is a definition again, and
    one that does not take the stated initial values is none."""
    tasks = [
        (n, shown, Task(text, line=n))
        for n, row in enumerate(rows)
        if row.link.solves is not None and row.status in PASSES
        for text, shown in row.link.solves.beside
    ]
    if tasks:
        answers = check_all([task for *_, task in tasks], limit, processes)
        for (n, shown, task), (_, found) in zip(tasks, answers, strict=True):
            if isinstance(found, Answer) and found.verdict is Verdict.REFUTED:
                why = f"it does not take the value {shown}"
                ruling = Verdict.REFUTED if rows[n].link.solves.called else Verdict.UNDECIDED
                rows[n] = replace(rows[n], status=ruling.value, why=why, refuted=str(task.claim))
            elif not isinstance(found, Answer) or not found:
                why = f"it solves the equation, but the value {shown} is not decided"
                rows[n] = replace(rows[n], status=Verdict.UNDECIDED.value, why=why)
    equations = {
        (row.link.display.number, row.link.shown)
        for row in rows
        if row.status == EQUATION or (row.status == "DEFINED" and _is_of_derivative(row.link))
    }
    result = []
    for row in rows:
        solves: Solves | None = row.link.solves
        if solves is not None and (solves.display, solves.shown) not in equations:
            status, why = solves.otherwise
            row = Row(row.link, status, why, seconds=row.seconds)
        result.append(row)
    return result


def _following(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; a link that follows from equations before it is PROVED from them."""
    found = {n: step for n in range(len(rows)) if (step := step_to(rows, n)) is not None}
    tasks = [Task(text, line=n) for n, step in found.items() for text in step.claims]
    held: dict[int, list[bool]] = {}
    for task, answer in check_all(tasks, limit, processes) if tasks else ():
        proved = isinstance(answer, Answer) and answer.verdict is Verdict.PROVED
        held.setdefault(task.line or 0, []).append(proved)
    for n, step in found.items():
        if all(held[n]):
            status = Verdict.PROVED.value
            rows[n] = replace(rows[n], status=status, why=step.why, refuted="", fails_at=None)
    return _differing(rows, limit, processes)


_REWRITTEN = re.compile(
    r"\b(?:divi\w+|multipl\w+|simplif\w+|rewrit\w+|rearrang\w+|equivalent\w*|becomes?|i\.e\.)",
    re.IGNORECASE,
)
"""Words that announce that an equation is another form of the one before it."""


def _differing(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; an equation that is announced as a multiple of the one before it, and is
    none because of one term, is SUSPECT."""
    found: list[tuple[int, Row, Difference]] = []
    for n, row in enumerate(rows):
        words = prose.last_sentence(row.link.around[0])
        if row.status != EQUATION or row.link.sides is None or not _REWRITTEN.search(words):
            continue
        near = [other for other in rows[max(n - 3, 0) : n] if other.status == EQUATION]
        for other in reversed([one for one in near if _is_premise(one, row.link)]):
            context = Context()
            sides = [one.link.sides for one in (other, row) if one.link.sides]
            learn(context, [side for compared in sides for side in compared[::2]])
            facts = [fact(one, 0, "", context) for one in sides]
            if len(facts) == 2 and facts[0] and facts[1] and facts[0].zero != facts[1].zero:
                candidate = difference(facts[1], facts[0])
                if candidate is not None:
                    found.append((n, other, candidate))
                    break
    tasks = [Task(candidate.claim, line=n) for n, _, candidate in found]
    answers = check_all(tasks, limit, processes) if tasks else ()
    for (n, other, candidate), (_, answer) in zip(found, answers, strict=True):
        if isinstance(answer, Answer) and answer.verdict is Verdict.PROVED:
            times = "" if candidate.factor == ONE else f", times {candidate.factor},"
            why = f"by the equation of line {other.link.display.line}{times} the term"
            why = f"{why} {candidate.printed} should be {candidate.expected}"
            edit = f"{candidate.expected} in place of {candidate.printed}"
            instead = (Alternative(candidate.right, "", edit, Verdict.PROVED.value),)
            rows[n] = replace(rows[n], status="SUSPECT", why=why, instead=instead)
    return rows


def _restating(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; an equation from which a definition was drawn is not proved by it.

    After ``x + y = 10`` and ``y = 10 - x`` a second ``x + y = 10`` is no result.
    """
    tasks: list[Task] = []
    found: list[tuple[int, Row]] = []
    for n, row in enumerate(rows):
        sides = row.link.sides
        if row.status not in PASSES or not row.put or sides is None or sides[1] != "==":
            continue
        for one in rows[max(n - FAR, 0) : n]:
            source = one.link.sides
            if one.status != EQUATION or source is None or source[1] != "==":
                continue
            if symbols(source[0] - source[2]) != symbols(sides[0] - sides[2]):
                continue
            if source[0] - source[2] == sides[0] - sides[2]:
                rows[n] = _restated(row, one)
                break
            candidate = multiple_of(source, sides)
            if candidate is not None:
                found.append((n, one))
                tasks.append(Task(candidate.claim, line=n))
                break
    if tasks:
        answers = check_all(tasks, limit, processes)
        for (n, one), (_, answer) in zip(found, answers, strict=True):
            if isinstance(answer, Answer) and answer.verdict is Verdict.PROVED:
                rows[n] = _restated(rows[n], one)
    return rows


def _restated(row: Row, before: Row) -> Row:
    why = f"restates the equation of line {before.link.display.line}"
    return replace(row, status=EQUATION, why=why, put=())


def step_to(rows: Sequence[Row], n: int) -> Step | None:
    """Return the step by which an undecided link may follow from those before it in its section."""
    row, link = rows[n], rows[n].link
    if row.status not in (EQUATION, DEFINED, Verdict.UNDECIDED.value) or link.sides is None:
        return None
    if link.sides[1] != "==" or link.noted:
        return None
    start = n  # the chain of the link: its links are claims, and no premises of each other
    while start and rows[start].link.goes_on and rows[start - 1].link.display == link.display:
        start -= 1
    before = [other for other in rows[max(n - NEAR, 0) : start] if _is_premise(other, link)]
    if not before:
        return None
    context = Context(moving=link.moving)
    trees = [side for other in (*before, row) for side in (other.link.sides or ())[::2]]
    learn(context, trees)
    facts = []
    for other in before:
        sides = other.link.sides
        one = sides and fact(sides, other.link.display.line, other.link.read_as, context)
        facts += [one] if one else []
        if other.link.value is not None:
            context.values.append((other.link.display.line, *other.link.value))
    goal = fact(link.sides, link.display.line, link.read_as, context)
    if goal is None or not facts:
        return None
    search = Search(context, facts, goal, _beside(rows, n, context))
    if goal.series:
        return search.agreement(goal)
    if goal.name and (step := search.solution(goal.name, goal)) is not None:
        return step
    if row.status == DEFINED and goal.name:
        return None
    return search.consequence(goal.zero, goal.sides, goal.line) or search.agreement(goal)


def _beside(rows: Sequence[Row], n: int, context: Context) -> list[Fact]:
    """Return the definitions further on in the display: the other unknowns of a system."""
    link, found = rows[n].link, []
    for other in rows[n + 1 : n + 5]:
        sides = other.link.sides
        if other.link.display != link.display or sides is None or sides[1] != "==":
            break
        one = fact(sides, other.link.display.line, other.link.read_as, context)
        found += [one] if one and one.name and not one.series else []
    return found


def _is_premise(row: Row, link: Link) -> bool:
    """Whether a row states something that holds where a later link stands."""
    own = row.link
    if own.reach != link.reach[: len(own.reach)]:
        return False
    if own.value is not None:
        return True
    if own.sides is None or own.sides[1] != "==" or row.why.startswith("one of several"):
        return False
    if own.display == link.display and link.sides and own.sides[2] == link.sides[0]:
        return False  # the next link of one chain says something new
    stated = (EQUATION, DEFINED, "ASSUMED", Verdict.UNDECIDED.value)
    from_before = bool(own.solves) or row.why.startswith(("it follows", "it solves"))
    return row.status in stated or (from_before and row.status in PASSES)


def _is_of_derivative(link: Link) -> bool:
    """Whether a link gives the value of a derivative, and so is a differential equation."""
    left = str(link.sides[0]) if link.sides else ""
    return base_of(left) != left


def _solution_row(link: Link, answers: Sequence[Answer | InputError]) -> Row:
    """Return the row of a solution: its residual vanishes, does not, or is not decided."""
    solves: Solves = link.solves
    status, why = solves.otherwise
    read = [
        (asked, answer)
        for asked, answer in zip(link.claims, answers, strict=False)
        if isinstance(answer, Answer)
    ]
    seconds = sum(answer.seconds for _, answer in read)
    held = next(((asked, answer) for asked, answer in read if answer), None)
    failed = next((one for one in read if one[1].verdict is Verdict.REFUTED), None)
    if held is not None:
        asked, answer = held
        why = f"it solves the equation of line {solves.line}: {_told(answer.why, '')}"
        row = Row(link, answer.verdict.value, why, None, answer.given, seconds)
        return replace(row, cause=answer.cause)
    if failed is not None and not solves.complete:
        return replace(
            Row(link, status, why, seconds=seconds), refuted="", fails_at=_named(failed[1].witness)
        )
    if failed is None:
        if status == Verdict.UNDECIDED.value and read:
            why = f"{why}; {_told(read[-1][1].why, '')}"
        return Row(link, status, why, seconds=seconds)
    asked, answer = failed
    told = f"it does not solve the equation of line {solves.line}: {_told(answer.why, '')}"
    witness = _named(answer.witness)
    row = Row(link, Verdict.UNDECIDED.value, told, None, answer.given, seconds)
    row = replace(row, cause=answer.cause, refuted=asked.text, fails_at=witness)
    if solves.called:
        return replace(row, status=Verdict.REFUTED.value, witness=witness)
    return row


def _varied(
    rows: list[Row],
    answers: dict[int, list[Answer | InputError]],
    limit: float,
    processes: int | None,
) -> list[Row]:
    """Return the rows; a proved link of which an instance is refuted becomes UNDECIDED."""
    tasks: list[Task] = []
    told: list[tuple[int, str]] = []
    for n, row in enumerate(rows):
        passed = len(answers.get(n, [])) - 1
        if row.status not in PASSES or passed < 0:
            continue
        attempt = row.link.claims[passed]
        if attempt.sides is None or "(" in attempt.under:
            continue
        for text, values in instances(attempt.sides, row.link.constants):
            told.append((n, values))
            tasks.append(Task(text + attempt.under, line=n))
    if tasks:
        for (n, values), (_, found) in zip(told, check_all(tasks, limit, processes), strict=True):
            if isinstance(found, Answer) and found.verdict is Verdict.REFUTED:
                why = f"it seemed to be proved, but fails with {values}; please report this"
                rows[n] = replace(rows[n], status=Verdict.UNDECIDED.value, why=why)
    return rows


def _where_positive(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; an equality that holds if all its symbols are positive, as those of lengths
    and masses are, is no equation, and is not decided until the text says so."""
    tasks: list[Task] = []
    asked: list[tuple[int, str]] = []
    for n, row in enumerate(rows):
        sides = row.link.sides
        if (
            row.status not in (EQUATION, Verdict.UNDECIDED.value)
            or sides is None
            or not row.failing
        ):
            continue
        names = symbols(sides[0]) | symbols(sides[2])
        names = names.union(*(symbols(value) for _, value in row.put)) - {
            name for name, _ in row.put
        }
        names -= accusations.NO_VARIABLES
        powers = "sqrt(" in row.failing or "/" in row.failing or "log(" in row.failing
        plain = elementary(sides[0], sides[2]) and all(map(COORDINATE.fullmatch, names))
        if sides[1] != "==" or not names or not powers or plain:
            continue
        conditions = ", ".join(f"{name} > 0" for name in sorted(names))
        asked.append((n, conditions))
        tasks.append(Task(under_also(row.failing, conditions), line=n))
    if tasks:
        for (n, given), (_, answer) in zip(asked, check_all(tasks, limit, processes), strict=True):
            if isinstance(answer, Answer) and answer:
                why = f"it holds for {given}, which the text does not say"
                undecided = Verdict.UNDECIDED.value
                rows[n] = replace(rows[n], status=undecided, why=why, holds_given=given)
                rows[n] = replace(rows[n], obstacle=Obstacle.POSITIVE)
    return rows


def _by_euler_number(rows: list[Row], limit: float, processes: int | None) -> list[Row]:
    """Return the rows; a link that fails for a variable e, but holds for Euler's number, as
    ln(1 + e) - ln(e) + 1 = ln(1 + e), is not called false."""
    asked = [n for n, row in enumerate(rows) if re.search(r"\be\b(?!\()", row.refuted)]
    tasks = [Task(re.sub(r"\be\b(?!\()", "E", rows[n].refuted), line=n) for n in asked]
    if tasks:
        for n, (_, answer) in zip(asked, check_all(tasks, limit, processes), strict=True):
            if isinstance(answer, Answer) and answer:
                why = "it fails for a variable e, but holds for Euler's number; write \\mathrm{e}"
                undecided = Verdict.UNDECIDED.value
                rows[n] = replace(rows[n], status=undecided, why=why, witness=None)
                rows[n] = replace(rows[n], refuted="", failing="", obstacle=Obstacle.TWO_READINGS)
    return rows


def under_also(claim: str, more: str) -> str:
    """Return a claim in the grammar of ``tresym check`` with further conditions."""
    claim, towards, path = claim.partition(" as ")
    return f"{claim}{',' if ' given ' in claim else ' given'} {more}{towards}{path}"


def _of_both(
    first: tuple[Row, list[Answer | InputError]], second: tuple[Row, list[Answer | InputError]]
) -> Row:
    """Return the row of a link with two readings: proved if both are, SUSPECT if both are false,
    else UNREAD."""
    (one, _), (other, _) = first, second
    if one.status in PASSES and other.status in PASSES:
        weaker = max((one, other), key=lambda row: PASSES.index(row.status))
        both = f"in both readings of the formula, {one.link.read_as} and {other.link.read_as}"
        return replace(weaker, why=f"{weaker.why}; {both}")
    verdicts = {_verdict(found) for _, found in (first, second)}
    clear = any(_is_clear(row) for row in (one, other))
    if verdicts == {Verdict.REFUTED.value} and clear and one.link.number > 1:
        both = f"it fails in both readings, {one.link.read_as} and {other.link.read_as}"
        return replace(one, status="SUSPECT", why=f"{both}: {one.why}")
    told = " and ".join(
        f"{row.link.read_as} is {_verdict(found)}" for row, found in (first, second)
    )
    why = f"two readings remain: {told}"
    return replace(one, status=UNREAD, why=why, witness=None, obstacle=Obstacle.TWO_READINGS)


def _is_clear(row: Row) -> bool:
    """Whether a failing reading relates the same symbols on both sides, without a doubt but that
    a derivative in both of them was not read."""
    link = row.link
    kinds = {doubt.kind for doubt in link.ground.doubts}
    if link.sides is not None and elementary(*link.sides[::2]):
        kinds -= {accusations.DoubtKind.UNREAD}
    return link.same and not kinds and bool(row.refuted)


def _verdict(answers: list[Answer | InputError]) -> str:
    """Return the best verdict of several attempts at one reading."""
    read = [answer for answer in answers if isinstance(answer, Answer)]
    best = next((answer for answer in read if answer), read[0] if read else None)
    return best.verdict.value if best is not None else "not read"


def _failing(row: Row, answers: list[Answer | InputError]) -> Row:
    """Return the row with the claim that fails and a point at which it does, whatever its status.

    This is the last attempt that needs no definition from another paragraph.
    """
    pairs = [*zip(row.link.claims, answers, strict=False)]
    for asked, answer in reversed(pairs):
        failed = isinstance(answer, Answer) and answer.verdict is Verdict.REFUTED
        if isinstance(answer, Answer) and failed and asked.may_fail and not asked.far:
            at = _named(answer.witness)
            text = asked.plain or asked.text
            put = row.put if row.status in PASSES else asked.put
            return replace(row, refuted=text, put=put, fails_at=at, failing=asked.text)
    return row


def _restates(link: Link, asked: Attempt) -> str:
    """Return why a proved equality shows nothing, as its sides are the same; ``""`` if it does."""
    one, _, other = asked.sides or (ZERO, "", ONE)
    if one != other or link.multiplied:
        return ""
    if not asked.how or asked.how == SHARED:
        left, equal, right = link.shown.partition(" = ")
        bare = bool(equal) and left.split() == right.split()
        why = "both sides are read as the same expression, so there is nothing to check"
        return why if bare or (symbols(one) and link.ground.alike) else ""
    put = {name for name, _ in asked.put}
    lone = next((s for s in (link.sides or ())[::2] if str(s) in link.ground.places), None)
    if lone is None and any(str(side) in put for side in (link.sides or ())[::2]):
        return "a definition; it is substituted later if that decides a link"
    place = link.ground.places[str(lone)] if lone is not None else 0
    return f"restates {f'line {place}' if place else f'what {lone} stands for'}" if lone else ""


def _refuted(link: Link, answers: list[Answer | InputError]) -> tuple[Attempt, Answer] | None:
    """Return the last attempt that needs no definition from elsewhere, if all are refuted."""
    found = None
    for asked, answer in zip(link.claims, answers, strict=False):
        if isinstance(answer, Answer) and asked.may_fail:
            if answer.verdict is not Verdict.REFUTED:
                return None
            if not asked.far and (asked.same or link.ground.explicit or asked.sides is None):
                found = asked, answer
    return found


def _needed(link: Link) -> str:
    """Return why a refutation that needs a definition from elsewhere is not reported."""
    far = dict.fromkeys(name for asked in link.claims for name in asked.far)
    if not far:
        return "other readings of it are not refuted"
    return f"{', '.join(far)} is defined in another paragraph (% tresym: from LABEL uses it)"


def _doubt(link: Link, asked: Attempt, limit: float) -> str:
    """Return why a refutation is not reported as an error of the text; empty if it is reported."""
    if link.ground.doubts:
        return link.ground.doubts[0].text
    if asked.sides is None or link.ground.explicit or " as " in asked.text:
        return ""
    point = accusations.holds_elsewhere(asked.sides, asked.given)
    if point is not None:
        at = ", ".join(f"{name} = {value}" for name, value in point.items())
        return f"it holds at {at}: a condition may be missing"
    known = names_in(asked.given) | names_in(link.ground.bounds)
    free = sorted(names_in([asked.sides]) - known - {*"ABC"} - accusations.NO_VARIABLES)
    signs = [f"{name} > 0" for name in free]
    more = ", ".join(filter(None, (chained(link.ground.bounds), *signs)))
    if not more or not (link.ground.bounds or not elementary(asked.sides[0], asked.sides[2])):
        return ""
    if check_within(Task(under_also(asked.text, more)), limit).verdict is Verdict.REFUTED:
        return ""
    return f"it is not refuted where {more}: a condition may be missing"


def _told(why: str, how: str) -> str:
    """Return a reason with the substitutions; functions have the names that the author uses."""
    return re.sub(r"\bfn_", "", f"{why}; {how}" if how else why)


def _named(witness: Mapping[str, str] | None) -> dict[str, str] | None:
    """Return a witness in which functions have the names that the author uses."""
    if witness is None:
        return None
    return {re.sub(r"\bfn_", "", name): value for name, value in witness.items()}


def _counted(link: Link, asked: Attempt, answer: Answer, limit: float) -> tuple[Answer, str]:
    """Return a refutation at numbers that may be indices, where the symbol is one elsewhere; if
    there is none, the first one and why it is not reported."""
    wrong = [n for n in sorted(link.counted) if not _at(answer, n).isdecimal()]
    if not wrong:
        return answer, ""
    whole = ", ".join(f"{name} integer, {name} >= 1" for name in wrong)
    again = check_within(Task(under_also(asked.text, whole)), limit)
    if again.verdict is Verdict.REFUTED and all(_at(again, n).isdecimal() for n in wrong):
        return again, ""
    return answer, f"{', '.join(wrong)} is an index elsewhere, so an integer"


def _at(answer: Answer, name: str) -> str:
    """Return the value of a symbol in a witness, 1 if it has none."""
    return (answer.witness or {}).get(name, "1")


def _row(link: Link, answers: list[Answer | InputError], limit: float) -> Row:
    if not answers:
        status, why = (link.status, link.why) if link.status else link.otherwise
        return Row(link, status, why, obstacle=link.obstacle)
    if link.solves is not None:
        return _solution_row(link, answers)
    read = [answer for answer in answers if isinstance(answer, Answer)]
    if not read:
        return Row(link, UNREAD, str(answers[0]))
    counted = [n for n, answer in enumerate(read) if answer or link.claims[n].may_fail] or [0]
    last, asked = read[counted[-1]], link.claims[counted[-1]]
    seconds = sum(answer.seconds for answer in read)
    how = asked.how
    if last:
        link = replace(link, read_as=asked.read_as)
    why, witness = _told(last.why, how), _named(last.witness)
    row = Row(link, last.verdict.value, why, witness, last.given, seconds)
    row = replace(row, cause=last.cause, obstacle=link.obstacle)
    if last:
        same = _restates(link, asked)
        row = replace(row, put=asked.put)
        return replace(row, status="DEFINED", why=same) if same else row
    status, fallback = link.otherwise
    if last.verdict is Verdict.REFUTED and link.firm:
        failed = _refuted(link, answers)
        doubt = "" if failed else _needed(link)
        if failed is not None:
            asked, last = failed
            last, doubt = _counted(link, asked, last, limit)
            doubt = doubt or _doubt(link, asked, limit)
            witness = _named(last.witness)
            why = _told(last.why, "neither rounded nor cut off" if asked.how == CUT else asked.how)
            row = Row(link, last.verdict.value, why, witness, last.given, seconds)
            row = replace(row, cause=last.cause, obstacle=link.obstacle)
        if not doubt:
            return replace(row, link=replace(link, read_as=asked.read_as))
        if status != "DEFINED":
            status, fallback = "UNDECIDED", ""
        at = ", ".join(f"{k} = {v}" for k, v in (witness or {}).items())
        why = fallback or f"not reported as false: {doubt}; it fails at {at or 'the constants'}"
        return replace(row, status=status, why=why, witness=None)
    if last.verdict is Verdict.REFUTED:
        if (not link.same and status != "UNDECIDED") or status == "DEFINED":
            return replace(row, status=status, why=fallback, witness=None)
        at = ", ".join(f"{k} = {v}" for k, v in (witness or {}).items())
        where = f"it fails, for example, at {at or 'the constants'}"
        row = replace(row, obstacle=Obstacle.FAILS)
        advice = "if you meant an identity, write % tresym: claim before the display"
        if status == "UNDECIDED":
            return replace(row, status=status, why=f"{where}; {advice}", witness=None)
        return replace(row, status=status, why=f"{fallback}; {where}: {advice}", witness=None)
    if status == "DEFINED" or link.unknown:
        return replace(row, status=status, why=fallback)
    return row
