"""Explain a verdict as a proof that can be read: what is claimed, and why it holds or fails.

    explain("sin(x) == x + O(x**3) as x -> 0").text()

The explanation names the method or the lemma with its source, gives each obligation of the lemma
with its own verdict and reason, and shows for a limit or an order how the two sides compare on the
way to the end: a short table in which the failure of a false claim can be seen, and in HTML also a
picture. Every number comes from balls.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from importlib.util import find_spec
from itertools import groupby

from flint import fmpq

from tresym.checking.dispatch import decide_claim
from tresym.checking.towards_the_end import RATIO, STEPS, sides_of
from tresym.papers.error_rows import rounded
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.decisions.path_regions import conditions_of, reach_of
from tresym.reals.language.as_typed import as_typed
from tresym.reals.language.expression import ZERO
from tresym.reals.language.parsing import as_written, parse_claim
from tresym.reals.language.readings import in_latex
from tresym.reals.language.typesetting import expression_in_latex, to_latex
from tresym.reals.numbers.exact import InputError, decimal_ball
from tresym.reals.verdict import Cause
from tresym.report.typesetting import html
from tresym.report.typesetting.formulas_in_words import parts, region_latex

PLACES = tuple(fmpq(4, 5) ** n for n in range(32))
"""Where the picture has points: parts of the region."""
FEWEST = 6
"""Points of a picture at least."""
DIGITS = 6
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
    """A statement on which a proof rests, with its conditions, its verdict and the reason."""

    claim: str
    given: str
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
        return "\n".join(self._lines(lambda f: f, lambda words: words, "{}", _aligned, _as_typed))

    def markdown(self) -> str:
        """Return the explanation in Markdown, with its formulas in LaTeX between dollars."""
        text = self._lines(_formula, _typeset, "**{}**", _in_markdown, _typed_in_latex)
        return "\n".join(text)

    def html(self, with_claim: bool = True) -> str:
        """Return the explanation in HTML, with its formulas as MathML and a picture.

        Args:
            with_claim: whether it begins with the claim.
        """
        text = self._lines(_formula, _typeset, "**{}**", _in_html, _typed_in_latex)
        if not with_claim:
            next(text)
        return "\n".join([*_paragraphs(text), self.picture()])

    def picture(self) -> str:
        """Return a curve on the way to the end, as SVG: the ratio, or what has a limit.

        It is empty where there is nothing to draw, and a sentence without matplotlib.
        """
        return _picture(self.answer)

    def _lines(
        self,
        formula: Callable[[str], str],
        words: Callable[[str], str],
        strong: str,
        table: Callable[[Table], Iterator[str]],
        claim: Callable[[Answer], str],
    ) -> Iterator[str]:
        answer = self.answer
        meant = MEANT.get(answer.cause) if answer.cause else None
        on_the_way = bool(self.compared) and answer.cause is Cause.WITNESS
        if on_the_way:  # a point of the path refutes nothing about its end
            meant = "what happens on the way to the end contradicts it"
        yield f"{strong.format('Claim.')} {claim(answer)}\n"
        because = f": {meant}" if meant else ""
        yield f"{strong.format('Verdict.')} {answer.verdict.value}{because}.\n"
        name = "Lemma." if answer.lemma else "Reason."
        if answer.lemma:
            yield f"{strong.format(name)} {words(answer.lemma[0].upper() + answer.lemma[1:])}.\n"
        if not answer.lemma or not self.steps:
            reason = _reason(answer)
            edit = answer.instead[0].edit if answer.instead else ""
            reason = f"{edit}: {reason}" if edit.startswith("the coefficient of") else reason
            yield f"{strong.format('Reason.')} {words(reason[:1].upper() + reason[1:])}.\n"
        elif (note := answer.why.partition("; ")[2]) and answer.verdict.holds:
            yield f"{strong.format('It gives')} {words(note)}.\n"
        if self.steps:
            yield f"{strong.format('It needs')}\n"
            for n, step in enumerate(self.steps, 1):
                under = f" for {formula(step.given)}" if step.given else ""
                reason = f", because {words(step.why)}" if step.why else ""
                yield f"{n}. {formula(step.claim)}{under}: {step.verdict}{reason}."
            yield ""
        if answer.constant is not None:
            where = f" on {formula(answer.region)}" if answer.region else ""
            yield f"{strong.format('Constant.')} {answer.constant_text()}{where}.\n"
        elif answer.region:
            yield f"{strong.format('Where.')} {words(answer.region)}.\n"
        if answer.witness and not on_the_way:
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

    return explained(check(claim, given, path, limit=limit))


def explained(answer: Answer) -> Explanation:
    """Return the explanation of an answer: the reasons of its steps, and the table of both sides.

    Args:
        answer: a verdict of :func:`tresym.check` or of a file of claims.
    """
    return Explanation(answer, tuple(_steps(answer)), tuple(_compared(answer)))


def _reason(answer: Answer) -> str:
    """The reason; of an order the factor is left out, which is given as the constant."""
    if answer.constant is not None and answer.why.startswith("|left| <= C |right|"):
        told = answer.why.partition("; ")[2]
        return f"the ratio of the two sides is bounded{'; ' if told else ''}{told}"
    return answer.why


def _steps(answer: Answer) -> Iterator[Step]:
    for part in answer.obligations:
        why = ""
        try:
            found = decide_claim(part.claim, part.given)
            why = found.in_text()[0] if found.verdict.value == part.verdict else ""
        except InputError:
            pass  # a statement in words, such as that a function is continuous
        yield Step(part.claim, part.given, part.verdict, why)


def _compared(answer: Answer) -> Iterator[tuple[str, ...]]:
    """Yield the heads of the columns and the rows in which both sides are compared."""
    sides = sides_of(answer)
    if sides is None:
        return
    rows = [
        (str(x), *(rounded(decimal_ball(v, 2 * DIGITS), DIGITS) for v in values))
        for x, values in sides.rows(STEPS)
    ]
    if len(rows) > 1:
        yield (sides.end.name, *sides.heads)
        yield from rows


def _picture(answer: Answer) -> str:
    sides = sides_of(answer)
    if sides is None:
        return ""
    try:
        reach = reach_of(conditions_of(answer.region or ""), sides.end)
    except InputError:
        reach = fmpq(1)
    points = [(x, float(y[-1])) for x, y in sides.rows(reach * part for part in PLACES)]
    if len(points) < FEWEST:
        return ""
    if find_spec("matplotlib") is None:
        return "The picture of it needs matplotlib: pip install 'tresym[docs]'."
    from tresym.report.charts.own import ratio

    name, point = sides.end.name, sides.end.point
    away = [
        float(certified_evaluation().value(x if point is None else x - point).mid())
        for x, _ in points
    ]
    along = name if point is None or point == ZERO else f"|{name} − {point}|"
    curve = [(abs(x), y) for x, (_, y) in zip(away, points, strict=True)]
    bound = float(Fraction(answer.constant.mid)) if answer.constant is not None else None
    title = sides.heads[0] if len(sides.heads) == 1 else "left side / right side"
    return ratio(curve, along, title, bound)


_CLAUSES = re.compile(r"\s(?:given|as)\s.*$")
"""The conditions and the path of a claim, as it was read."""


def _as_typed(answer: Answer) -> str:
    """Return the claim in the form in which it was typed, with its conditions and its path."""
    typed = answer.statement.strip()
    read_as = answer.read_as or typed
    try:  # the typed text only where the strict grammar reads the same of it
        if parse_claim(_CLAUSES.sub("", typed)) != parse_claim(_CLAUSES.sub("", read_as)):
            return read_as
    except InputError:
        return read_as
    clauses = _CLAUSES.search(read_as)
    return _CLAUSES.sub("", typed) + (clauses[0] if clauses else "")


def _typed_in_latex(answer: Answer) -> str:
    """Return the claim in LaTeX between dollars, with its terms in the order of the text."""
    read_as = answer.read_as or answer.statement
    shown = _formula(read_as)
    formula = _CLAUSES.sub("", read_as)
    try:
        links = tuple(parse_claim(formula))
    except InputError:
        return shown
    typed = to_latex(as_typed(_as_typed(answer), links))
    return shown.replace(to_latex(links), typed, 1)


_ORDER = re.compile(r"(.+) (O|o|Theta|omega) (.+?)( as .+)?")
"""How an obligation states an order: ``left O right``."""


def _formula(text: str) -> str:
    if " is " in text:  # such as "1/k is continuous"
        what, _, more = text.partition(" is ")
        return f"{_formula(what)} is {_typeset(more)}"
    if (order := _ORDER.fullmatch(text)) and "==" not in text:
        left, sign, right, path = order.groups()
        text = f"{left} == {sign}({right}){path or ''}"
    shown = in_latex(text) or region_latex(text)
    if not shown and text != RATIO:
        with suppress(InputError):
            shown = expression_in_latex(as_written(text))
    return f"${shown}$" if shown else _typeset(text)


def _typeset(words: str) -> str:
    return "".join(
        f"${part}$" if is_formula else _quoted(part) for part, is_formula in parts(words)
    )


def _quoted(words: str) -> str:
    """Words as Markdown: what has signs of it is code."""
    return re.sub(r"[^\s`]*[*_^<>|][^\s`,;.]*", lambda word: f"`{word[0]}`", words)


def _in_markdown(table: Table) -> Iterator[str]:
    head, *rows = table
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    yield from (f"| {' | '.join(row)} |" for row in rows)


def _in_html(table: Table) -> Iterator[str]:
    yield '<div class="wide"><table>'
    for n, row in enumerate(table):
        tag = "td" if n else "th"
        yield f"<tr>{''.join(f'<{tag}>{html.words(cell)}</{tag}>' for cell in row)}</tr>"
    yield "</table></div>"


def _paragraphs(lines: Iterable[str]) -> Iterator[str]:
    """Yield an explanation in HTML: a numbered list, tables as they are, paragraphs."""
    for is_item, group in groupby(lines, key=lambda line: bool(re.match(r"\d+\. ", line))):
        if is_item:
            items = (html.words(line.partition(" ")[2]) for line in group)
            yield "<ol>\n" + "\n".join(f"<li>{item}</li>" for item in items) + "\n</ol>"
        else:
            for line in filter(str.strip, group):
                yield line if line[0] == "<" else f"<p>{html.words(line.strip())}</p>"


def _aligned(table: Table) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    for row in table:
        yield "  ".join(f"{cell:<{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
