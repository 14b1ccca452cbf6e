"""Explain a verdict as a proof that can be read: what is claimed, and why it holds or fails.

    explain("sin(x) == x + O(x**3) as x -> 0").text()

The explanation names the method or the lemma with its source, gives each obligation of the lemma
with its own verdict and reason, and shows for a limit or an order how the two sides compare on the
way to the end: a short table in which the failure of a false claim can be seen. Every number comes
from balls.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from flint import fmpq

from tresym.asymptotics.lemma import asserted_terms
from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.decisions.path_regions import along
from tresym.reals.decisions.statement import Statement
from tresym.reals.expansions.scale import T
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import number, substitute, symbols
from tresym.reals.language.readings import in_latex
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, decimal_ball
from tresym.reals.verdict import Cause
from tresym.report.typesetting.formulas_in_words import parts, region_latex

STEPS = tuple(fmpq(1, 4**n) for n in range(6))
"""Where the two sides are compared: values of the small parameter."""
DIGITS = 5
MEANT = {
    Cause.EXACT: "an exact procedure proves it, without floating-point numbers",
    Cause.BALLS: "interval arithmetic with proved error bounds proves it",
    Cause.WITNESS: "a counterexample refutes it",
    Cause.CONTRARY: "the contrary is proved",
}


Table = tuple[tuple[str, ...], ...]
"""The heads of the columns, and the rows."""


@dataclass(frozen=True)
class Step:
    """A statement on which a proof rests, with its verdict and the reason."""

    claim: str
    verdict: str
    why: str


@dataclass(frozen=True)
class Explanation:
    """What is claimed, and why it holds or fails.

    Attributes:
        answer: the verdict.
        steps: the statements to which it was reduced.
        compared: names of columns and rows of numbers on the way to the end of the path.
    """

    answer: Answer
    steps: tuple[Step, ...]
    compared: Table

    def text(self) -> str:
        """Return the explanation for a terminal."""
        return "\n".join(self._lines(lambda f: f, lambda words: words, "{}", _aligned))

    def markdown(self) -> str:
        """Return the explanation in Markdown, with its formulas in LaTeX between dollars."""
        return "\n".join(self._lines(_formula, _typeset, "**{}**", _in_markdown))

    def _lines(
        self,
        formula: Callable[[str], str],
        words: Callable[[str], str],
        strong: str,
        table: Callable[[Table], Iterator[str]],
    ) -> Iterator[str]:
        answer = self.answer
        meant = MEANT.get(answer.cause) if answer.cause else None
        yield f"{strong.format('Claim.')} {formula(answer.read_as or answer.statement)}\n"
        because = f": {meant}" if meant else ""
        yield f"{strong.format('Verdict.')} {answer.verdict.value}{because}.\n"
        name = "Lemma." if answer.lemma else "Reason."
        if answer.lemma:
            yield f"{strong.format(name)} {words(answer.lemma[0].upper() + answer.lemma[1:])}.\n"
        if not answer.lemma or not self.steps:
            yield f"{strong.format('Reason.')} {words(_reason(answer))}.\n"
        elif (note := answer.why.partition("; ")[2]) and answer.verdict.holds:
            yield f"{strong.format('It gives')} {words(note)}.\n"
        if self.steps:
            yield f"{strong.format('It needs')}\n"
            for n, step in enumerate(self.steps, 1):
                reason = f", because {words(step.why)}" if step.why else ""
                yield f"{n}. {formula(step.claim)}: {step.verdict}{reason}."
            yield ""
        if answer.constant is not None:
            where = f" on {formula(answer.region)}" if answer.region else ""
            yield f"{strong.format('Constant.')} {answer.constant_text()}{where}.\n"
        elif answer.region:
            yield f"{strong.format('Where.')} {words(answer.region)}.\n"
        if answer.witness:
            point = ", ".join(f"{x} = {value}" for x, value in answer.witness.items())
            yield f"{strong.format('Counterexample.')} {words(point)}.\n"
        if self.compared:
            head, *rows = self.compared
            yield f"{strong.format('On the way to the end')}\n"
            yield from table((tuple(map(formula, head)), *rows))
            yield ""
        if answer.instead:
            best = answer.instead[0]
            true = formula(f"{best.claim} given {best.given}" if best.given else best.claim)
            yield f"{strong.format('True instead.')} {true} ({words(best.edit)}).\n"


def explain(
    claim: str, given: str = "", path: str | None = None, limit: float = 20.0
) -> Explanation:
    """Decide a claim and explain the verdict.

    Args:
        claim: the claim, as for `tresym.check`.
        given: its conditions.
        path: the limit process.
        limit: seconds of processor time for the decision; each step has as much.

    Raises:
        InputError: the claim cannot be read.

    Example:
        >>> explain("sqrt(x**2) == x").answer.verdict.value
        'REFUTED'
    """
    from tresym.repair import check

    answer = check(claim, given, path, limit=limit)
    return Explanation(answer, tuple(_steps(answer)), tuple(_compared(claim, given, path)))


def _reason(answer: Answer) -> str:
    """The reason; of an order the factor is left out, which is given as the constant."""
    if answer.constant is not None and answer.why.startswith("|left| <= C |right|"):
        told = answer.why.partition("; ")[2]
        return f"the ratio of the two sides is bounded{'; ' if told else ''}{told}"
    return answer.why


def _steps(answer: Answer) -> Iterator[Step]:
    for part in answer.obligations:
        under = f" given {part.given}" if part.given else ""
        why = ""
        try:
            found = decide_claim(part.claim, part.given)
            why = found.in_text()[0] if found.verdict.value == part.verdict else ""
        except InputError:
            pass  # a statement in words, such as that a function is continuous
        yield Step(part.claim + under, part.verdict, why)


def _compared(claim: str, given: str, path: str | None) -> Iterator[tuple[str, ...]]:
    """Yield the heads of the columns and the rows in which both sides are compared."""
    try:
        statement = read(claim, given, path)
    except InputError:
        return
    comparisons = statement.comparisons
    end = statement.path
    if end is None or end.together or len(comparisons) != 1 or statement.equations:
        return
    (compared,) = comparisons
    if (symbols(compared.left) | symbols(compared.right)) - {end.name} or compared.derivatives:
        return
    limit = compared.relation == LIMIT
    if compared.relation == "~" and len(terms := asserted_terms(compared.right, end.name)) > 1:
        compared = Comparison(compared.left - compared.right, "o", terms[-1])
    rows = _rows(compared, statement, limit)
    if len(rows) > 1:
        sides = str(compared.left), str(compared.right)
        shown = sides[:1] if limit else (*sides, "left/right")
        yield (end.name, *shown)
        yield from rows


def _rows(compared: Comparison, statement: Statement, limit: bool) -> list[tuple[str, ...]]:
    path = statement.path
    assert path is not None
    rows = []
    with ball_precision():
        for t in STEPS:
            point = along(path, path.sides[0])
            at = {path.name: substitute(point, {T: number(t)})}
            sides = (compared.left,) if limit else (compared.left, compared.right)
            try:
                values = [certified_evaluation().value(substitute(e, at)) for e in sides]
                values += [] if limit else [values[0] / values[1]]
            except (UndefinedError, InputError, ZeroDivisionError):
                continue
            if all(value.is_finite() and value.rad() < 1e-3 for value in values):
                shown = (decimal_ball(value, DIGITS).mid for value in values)
                rows.append((str(at[path.name]), *shown))
    return rows


def _formula(text: str) -> str:
    shown = "" if " is " in text else in_latex(text) or region_latex(text)
    return f"${shown}$" if shown else _typeset(text)


def _typeset(words: str) -> str:
    return "".join(f"${part}$" if is_formula else part for part, is_formula in parts(words))


def _in_markdown(table: Table) -> Iterator[str]:
    head, *rows = table
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    yield from (f"| {' | '.join(row)} |" for row in rows)


def _aligned(table: Table) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    for row in table:
        yield "  ".join(f"{cell:<{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
