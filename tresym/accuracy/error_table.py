"""Compare an approximation with the exact expression: certified errors, order and constant.

:func:`error_table` evaluates both along a path, at exact parameters. The error is the difference of
the two expressions, not of rounded numbers, and its precision is raised until its sign and its
digits are proved. Below the rows stand the verdict of the order claim, by :func:`tresym.check`, and
the supremum of |exact − approximate|/gauge on a region, enclosed from both sides, by
:func:`tresym.constant`.

Example: ``error_table("tan(x)", "x + x**3/3", "x -> 0+", order="x**5")``.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from html import escape
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy import table as tables
from tresym.accuracy.constants import constant as best_constant
from tresym.accuracy.table import Table
from tresym.accuracy.values import (
    MAX_DIGITS,
    Exact,
    certified,
    constant,
    placed,
    point_text,
    read,
    rounded,
    rounded_number,
)
from tresym.asymptotics.constants import Constant
from tresym.asymptotics.recurrences import explicit_sequence
from tresym.checking import check
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read as read_claim
from tresym.reals.decisions.path_regions import conditions_of
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import root
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import path_in_latex, path_in_mathml
from tresym.reals.language.expression import (
    ONE,
    Expr,
    add,
    apply,
    number,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse_given, sequences_of
from tresym.reals.language.paths import Path, read_path
from tresym.reals.language.readings import in_latex, in_mathml
from tresym.reals.language.typesetting import (
    expression_in_latex,
    expression_in_mathml,
    to_latex,
    to_mathml,
)
from tresym.reals.language.unicode_input import plain
from tresym.reals.notebook import in_one_line
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import (
    Decimal,
    InputError,
    as_rational,
    decimal_ball,
    shortened,
    whole_number,
)
from tresym.reals.verdict import Verdict

DIGITS = 15
"""The digits of values that are shown if no number is asked for."""
FEW = 6
"""The digits of errors and orders that a table shows."""
POINTS = (fmpq(1, 2), fmpq(1, 10), fmpq(1, 100), fmpq(1, 1000), fmpq(1, 10000))
"""The distances from the end of the path that are taken if no points are asked for."""
LONGEST_POINT = 30
"""Characters of a point that is shown exactly."""
MOST_ROWS = 10_000
SECONDS = 20.0
"""The limit of the order claim."""
LONGEST = 160
"""Characters of the reason that are shown."""


class Row(NamedTuple):
    """One point of an error table.

    Attributes:
        at: the parameters, as exact text.
        exact, approx: balls.
        error: approximate − exact; None if it cannot be told apart from 0.
        relative: error/exact; None as well where the exact value is 0.
        order: the empirical order against the row before, log(error ratio)/log(distance ratio).
        exact_text, approx_text: the values rounded correctly to the digits that were asked for.
        error_text, relative_text, order_text: the same, rounded to a few digits.
        note: why a number is missing.
    """

    at: Mapping[str, str]
    exact: Decimal
    approx: Decimal
    error: Decimal | None
    relative: Decimal | None
    order: Decimal | None
    exact_text: str
    approx_text: str
    error_text: str
    relative_text: str
    order_text: str
    note: str = ""

    def as_json(self) -> dict[str, Any]:
        """Return the row for JSON."""
        balls = {
            name: None if ball is None else ball._asdict()
            for name, ball in zip(
                ("exact", "approx", "error", "relative"),
                (self.exact, self.approx, self.error, self.relative),
                strict=True,
            )
        }
        order = None if self.order is None else float(self.order.mid)
        return {"at": dict(self.at)} | balls | {"order": order}


class Cell(NamedTuple):
    """The balls of one row, as they come from a worker: text, and bits of accuracy."""

    exact: arb
    approx: arb
    error: arb | None
    relative: arb | None
    distance: arb


@dataclass(frozen=True)
class ErrorTable:
    """An error table, with the verdict of the order claim and the best constant.

    Attributes:
        exact, approx, path: what was compared, as it was read.
        rows: a row for each point.
        claim: the answer to ``exact == approx + O(gauge)``; None without a gauge.
        gauge: the comparison function; it is guessed from the empirical order if none was given.
        guessed: whether it was.
        constant: the supremum of ``abs((exact - approx)/gauge)`` on the region, or None.
        digits: the digits of the values.
        seconds: processor time.
        region: the region that was asked for.
    """

    exact: str
    approx: str
    path: str
    rows: tuple[Row, ...]
    claim: Answer | None = None
    gauge: str = ""
    guessed: bool = False
    constant: Constant | None = None
    digits: int = DIGITS
    seconds: float = field(default=0.0, compare=False)
    region: str = ""

    @cached_property
    def table(self) -> Table:
        """The rows as a table of text."""
        names = list(self.rows[0].at) if self.rows else []
        heads = (*names, "exact", "approximate", "error", "relative error", "order")
        rows = tuple(
            (
                *map(_short_point, row.at.values()),
                row.exact_text,
                row.approx_text,
                row.error_text,
                row.relative_text,
                row.order_text,
            )
            for row in self.rows
        )
        return Table(self.caption, heads, rows, "errors", len(names))

    @property
    def caption(self) -> str:
        """What the table shows, in one sentence."""
        return self._caption(str)

    def _caption(self, formula: Callable[[str], str]) -> str:
        return (
            f"{formula(self.approx)} compared with {formula(self.exact)}, {formula(self.path)}: "
            "error = approximate − exact; "
            "every digit is certified, order is the empirical order against the row above."
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """The sentences below the table."""
        return self._notes(str, str)

    def _notes(self, formula: Callable[[str], str], words: Callable[[str], str]) -> tuple[str, ...]:
        found = [f"at {_where(row.at)}: {row.note}" for row in self.rows if row.note]
        if self.claim is not None:
            guessed = " (the order was guessed from the last rows)" if self.guessed else ""
            sentence = words(shortened(self.claim.in_text()[0], LONGEST))
            claim = formula(self.claim.read_as or self.claim.statement)
            found.append(f"{self.claim.verdict.value}: {claim}{guessed}: {sentence}")
        if self.constant is not None:
            found.append(
                f"smallest constant on {formula(self.constant.region)}: between "
                f"{self.constant.low} and {self.constant.high}"
                f"{_place(formula(self.constant.where))}"
            )
        elif self.claim is not None and self.claim.verdict is not Verdict.REFUTED:
            where = formula(self.region) if self.region else "a region"
            found.append(f"no enclosure of the smallest constant was found on {where}")
        return tuple(found)

    def text(self) -> str:
        """Return the table for a terminal."""
        return "\n".join([tables.written(self.table, "text"), *self.notes, ""])

    def markdown(self) -> str:
        """Return the table in Markdown, with its formulas in LaTeX between dollars."""
        words = tables.markdown_text
        shown = partial(_in_dollars, words=words)
        notes = "".join(f"\n{note}\n" for note in self._notes(shown, words))
        return tables.written(self.table, "markdown", caption=self._caption(shown)) + notes

    def latex(self) -> str:
        """Return the table in LaTeX, for booktabs, array and graphicx."""
        words = tables.latex_text
        shown = partial(_in_dollars, words=words)
        points = {text for row in self.rows for text in row.at.values()}
        cell: Callable[[str], str] = lambda text: (shown if text in points else words)(text)  # noqa: E731
        caption = self._caption(shown).replace("−", "$-$")
        notes = "".join(f"\n{note}\n" for note in self._notes(shown, words))
        return tables.written(self.table, "latex", cell, caption=caption) + notes

    def csv(self) -> str:
        """Return the rows as comma-separated values."""
        return tables.written(self.table, "csv")

    def html(self) -> str:
        """Return the table in HTML."""
        notes = "".join(f"<p>{note}</p>\n" for note in self._notes(_in_mathml, escape))
        return tables.written(self.table, "html", caption=self._caption(_in_mathml)) + notes

    def written(self, form: str) -> str:
        """Return the table as text, markdown, latex, csv or html."""
        found: str = getattr(self, form)()
        return found

    def as_json(self) -> dict[str, Any]:
        """Return the table for JSON; every key is always there."""
        found = self.constant
        return {
            "exact": self.exact,
            "approx": self.approx,
            "path": self.path,
            "rows": [row.as_json() for row in self.rows],
            "claim": None if self.claim is None else self.claim.as_json(),
            "constant": None
            if found is None
            else {
                "low": found.low,
                "high": found.high,
                "gauge": self.gauge,
                "region": found.region,
                "where": found.where,
                "verdict": "ENCLOSED",
            },
            "seconds": round(self.seconds, 3),
        }

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        verdict = "" if self.claim is None else f", {self.claim.verdict.value} O({self.gauge})"
        return in_one_line(
            f"ErrorTable({self.approx} for {self.exact}, {self.path}: {len(self.rows)} rows"
            f"{verdict})"
        )

    def _repr_html_(self) -> str:
        return self.html()

    def _repr_markdown_(self) -> str:
        return self.markdown()

    def _repr_latex_(self) -> str:
        return self.latex()


def _in_dollars(text: str, words: Callable[[str], str]) -> str:
    """Return an expression, a path, conditions or a claim in LaTeX between dollars, or as words."""
    for shown in (
        lambda: expression_in_latex(read(text)),
        lambda: path_in_latex(read_path(text)),
        lambda: in_latex(text),
        lambda: to_latex(conditions_of(text)),
    ):
        try:
            if found := shown():
                return f"${found}$"
        except InputError:
            continue
    return words(text)


def _in_mathml(text: str) -> str:
    for shown in (
        lambda: expression_in_mathml(read(text)),
        lambda: path_in_mathml(read_path(text)),
        lambda: in_mathml(text),
        lambda: to_mathml(conditions_of(text), block=False),
    ):
        try:
            if found := shown():
                return found
        except InputError:
            continue
    return escape(text)


class Question(NamedTuple):
    """What an error table compares: both expressions in the variable of the path alone.

    Attributes:
        exact, approx: the expressions.
        gauge: the comparison function, if one was given.
        path: the path.
        shown: both expressions as they were read, before parameters are put in.
    """

    exact: Expr
    approx: Expr
    gauge: Expr | None
    path: Path
    shown: tuple[str, str]


def error_table(
    exact: str | Expr,
    approx: str | Expr,
    path: str,
    at: Sequence[Exact] = (),
    given: str = "",
    digits: int = DIGITS,
    order: str | Expr | None = None,
    region: str = "",
    *,
    decide: bool = True,
    rows: Callable[[Question, Sequence[Expr], int], Iterable[Cell | InputError]] | None = None,
) -> ErrorTable:
    """Compare an approximate expression with the exact one along a path.

    Args:
        exact: the exact expression, in the grammar of :func:`tresym.value`. An unknown that an
            equation in ``given`` defines is the root that the conditions on it select.
        approx: the approximate one; it may end in ``+ O(gauge)``.
        path: such as ``"e -> 0+"`` or ``"x -> oo"``.
        at: the values of the variable of the path; sensible ones if there are none.
        given: values of other parameters (``"M == 1"``), an equation that defines an unknown of
            ``exact`` and conditions on it (``"y - e*sin(y) == M, 0 < y, y < pi"``).
        digits: the digits of the values.
        order: the comparison function; if none is given, it is guessed from the last rows.
        region: where the constant is taken, such as ``"0 < e <= 1/2"``.
        decide: whether the order claim is decided and the constant enclosed.
        rows: computes the cells, for example on several processes; in this process if not given.

    Raises:
        InputError: something cannot be read or has no value; one line says what.

    Example:
        >>> import tresym
        >>> found = tresym.error_table("tan(x)", "x + x**3/3", "x -> 0+", order="x**5", digits=20)
        >>> found.rows[-1].relative_text, found.rows[-1].order_text
        ('-1.33333e-17', '5.00000')
    """
    start = time.process_time()
    digits = whole_number(digits, 1, MAX_DIGITS, "digits")
    question = asked(exact, approx, path, given, order)
    chosen = not at
    points = (
        points_of(question.path, region)
        if chosen
        else [constant(x, question.path.name) for x in at]
    )
    if len(points) > MOST_ROWS:
        raise InputError(f"{len(points)} points are more than {MOST_ROWS}")
    for x in points:
        _need_on_path(question.path, x)
    cells = list((rows or _here)(question, points, digits))
    kept = [(x, c) for x, c in zip(points, cells, strict=True) if not isinstance(c, InputError)]
    failed = [c for c in cells if isinstance(c, InputError)]
    if failed and (not chosen or not kept):
        raise failed[0]
    found = tuple(_rows(question.path, kept, digits))
    gauge, guessed = question.gauge, False
    if gauge is None and found and found[-1].order is not None:
        gauge = _guessed(question.path, found[-1].order)
        guessed = gauge is not None
    claim = best = None
    if decide and gauge is None and region:
        raise InputError(
            f"the constant on {region} needs the comparison function, which could not be guessed "
            f"from the rows: name it, as in --order '{question.path.name}**2', or leave the region "
            "out"
        )
    if decide and gauge is not None:
        claim, best = _decided(question, gauge, region, kept)
    return ErrorTable(
        *question.shown,
        str(question.path),
        found,
        claim,
        "" if gauge is None else str(gauge),
        guessed,
        best,
        digits,
        time.process_time() - start,
        region,
    )


def asked(
    exact: str | Expr, approx: str | Expr, path: str, given: str, order: str | Expr | None
) -> Question:
    """Read what is to be compared.

    Raises:
        InputError: it cannot be read, or the path, the equations and the expressions do not fit.
    """
    way = read_path(path)
    sequence = _sequence(exact, path, given)
    if sequence is not None:
        exact, given = sequence, ""
    one, (other, gauge) = read(exact), _with_order(read(approx))
    if order is not None:
        wanted = read(order)
        gauge = wanted.args[0] if wanted.op == "O" else wanted
    links = parse_given(plain(given))
    fixed: dict[str, Expr] = {}
    equations = []
    for left, relation, right in links:
        if relation != "==":
            continue
        name, number_ = (left, right) if left.op == "symbol" else (right, left)
        if name.op == "symbol" and not symbols(number_):
            fixed[str(name.args[0])] = number_
        else:
            equations.append(left - right)
    shown = str(one), str(other)
    inequalities = Given(tuple(c for c in links if c[1] not in ("==", "in"))).unfolded()
    for equation in equations:
        one = _solved(one, equation, way, fixed, inequalities)
    if way.name in fixed:
        raise InputError(f"{way.name} is the variable of the path, so it has no fixed value")
    one, other = substitute(one, fixed), substitute(other, fixed)
    gauge = None if gauge is None else substitute(gauge, fixed)
    for e in (one, other, *([] if gauge is None else [gauge])):
        unknown = sorted(symbols(e) - {way.name, INFINITY.args[0]})
        if unknown:
            raise InputError(
                f"give the value of {unknown[0]}, as in --given '{unknown[0]} == 1': the path is "
                f"one of {way.name}"
            )
    if way.name not in symbols(one) | symbols(other):
        raise InputError(f"the path is one of {way.name}, which neither expression contains")
    return Question(one, other, gauge, way, shown)


def _sequence(exact: str | Expr, path: str, given: str) -> Expr | None:
    """Return the explicit form of a sequence a(n) that conditions determine, or None."""
    if not isinstance(exact, str) or not sequences_of(given):
        return None
    statement = read_claim(f"{exact} == O(1) given {given} as {path}")
    found = explicit_sequence(statement)
    left = statement.comparisons[0].left
    way = read_path(path)
    if found is None or left.op != "unknown" or left.args[1:] != (symbol(way.name),):
        raise InputError(f"no explicit form of {exact} was found; write a formula instead")
    return found[0]


def _with_order(e: Expr) -> tuple[Expr, Expr | None]:
    """Return an approximation without its term O(gauge), and the gauge."""
    terms = e.args if e.op == "+" else (e,)
    orders = [term for term in terms if term.op in ("O", "o", "Theta", "omega")]
    if not orders:
        return e, None
    if len(orders) > 1 or orders[0].op != "O":
        raise InputError("an approximation may end in one term O(…)")
    return add(*(term for term in terms if term is not orders[0])), orders[0].args[0]


def _solved(e: Expr, equation: Expr, path: Path, fixed: Mapping[str, Expr], given: Given) -> Expr:
    """Return an expression with the unknown of an equation as a root."""
    unknowns = sorted((symbols(equation) & symbols(e)) - {path.name} - fixed.keys())
    if len(unknowns) != 1:
        raise InputError(
            f"the equation {equation} == 0 should define one unknown of the exact expression; "
            f"it has {', '.join(unknowns) or 'none'}"
        )
    (name,) = unknowns
    low, high = -INFINITY, INFINITY
    x = symbol(name)
    for left, relation, right in given.comparisons:
        if relation == "!=":
            continue
        if right == x:
            left, right = right, left
            relation = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}[relation]
        if left != x:
            continue
        if relation in (">", ">="):
            low = right
        else:
            high = right
    return substitute(e, {name: root(equation, name, low, high)})


def points_of(path: Path, region: str = "") -> list[Expr]:
    """Return sensible points along a path, far ones first; those inside the region, if any is."""
    side = path.sides[0]
    if path.point is None:
        found = [number(side * 10**k) for k in (1, 2, 3, 4)]
    else:
        found = [path.point + number(side * d) for d in POINTS]
    if not region:
        return found
    inside = Given.parse(region)
    for other in sorted({x for link in inside.comparisons for e in link[::2] for x in symbols(e)}):
        if other not in (path.name, INFINITY.args[0]):
            raise InputError(f"the region {region} is one of {path.name}, not of {other}")
    with ball_precision():
        values = [{path.name: certified(x, 15)} for x in found]
        kept = [
            x
            for x, at in zip(found, values, strict=True)
            if all(c.holds_exactly(at) for c in inside.conditions)
        ]
    return kept or found


def _need_on_path(path: Path, x: Expr) -> None:
    """Require that a point lies on the side from which the path comes."""
    if path.point is None:
        gap = x * path.sides[0]
        fits = certified(gap, 5) > 0
    else:
        gap = certified(x - path.point, 5)
        fits = (gap > 0 and 1 in path.sides) or (gap < 0 and -1 in path.sides)
    if not fits:
        raise InputError(f"the point {path.name} = {x} is not on the path {path}")


def _here(question: Question, points: Sequence[Expr], digits: int) -> Iterator[Cell | InputError]:
    for x in points:
        yield cell(question, x, digits)


def cell(question: Question, x: Expr, digits: int) -> Cell | InputError:
    """Return the balls of one row, or why it has none."""
    at = {question.path.name: x}
    one, other = placed(question.exact, at), placed(question.approx, at)
    try:
        exact, approx = certified(one, digits), certified(other, digits)
        error = _difference(one, other, digits)
    except InputError as problem:
        return InputError(f"at {_where(point_text(at))}: {problem}")
    relative = None
    with ball_precision(bits(digits) + 64):
        if error is not None and not exact.contains(0):
            relative = error / exact
    gap = x if question.path.point is None else x - question.path.point
    return Cell(exact, approx, error, relative, abs(certified(gap, 20)))


def _difference(exact: Expr, approx: Expr, digits: int) -> arb | None:
    """Return approximate − exact, None if it cannot be told apart from 0."""
    try:
        return certified(approx - exact, digits)
    except InputError as problem:
        if "apart from 0" in str(problem):
            return None
        raise


def _rows(path: Path, cells: Sequence[tuple[Expr, Cell]], digits: int) -> Iterator[Row]:
    before: Cell | None = None
    few = min(FEW, digits)
    for x, found in cells:
        note = ""
        order = None
        if found.error is None:
            note = "the error could not be told apart from 0"
        elif before is not None:
            order = _order(before, found)
        with ball_precision(bits(digits) + 64):
            balls = [
                None if ball is None else decimal_ball(ball, digits)
                for ball in (found.exact, found.approx, found.error, found.relative)
            ]
            shown = None if order is None else decimal_ball(order, few)
        assert balls[0] is not None
        assert balls[1] is not None
        yield Row(
            point_text({path.name: x}),
            balls[0],
            balls[1],
            balls[2],
            balls[3],
            shown,
            rounded(found.exact, digits),
            rounded(found.approx, digits),
            "" if found.error is None else _signed(found.error, few),
            "" if found.relative is None else _signed(found.relative, few),
            "" if order is None else rounded(order, few),
            note,
        )
        before = found if found.error is not None and not found.error.is_zero() else None


def _signed(x: arb, digits: int) -> str:
    return ("+" if x > 0 else "") + rounded(x, digits)


def _order(before: Cell, here: Cell) -> arb | None:
    """Return the empirical order of two rows."""
    if before.error is None or here.error is None or here.error.is_zero():
        return None
    with ball_precision(bits(40)):
        steps = (before.distance / here.distance).log()
        if steps.contains(0):
            return None
        return (abs(before.error) / abs(here.error)).log() / steps


def _guessed(path: Path, order: Decimal) -> Expr | None:
    """Return the power of the distance whose exponent is near the empirical order."""
    near = float(order.mid)
    whole = round(2 * near) / 2
    if abs(near - whole) > 0.05 or abs(whole) > 100:
        return None
    distance = symbol(path.name) if path.point is None else symbol(path.name) - path.point
    exponent = fmpq(int(2 * whole), 2)
    base = distance if path.sides == (1,) or exponent.q == 1 else apply("abs", distance)
    base = -base if path.sides == (-1,) and exponent.q != 1 else base
    return ONE if exponent == 0 else power(base, number(exponent))


def _decided(
    question: Question, gauge: Expr, region: str, cells: Sequence[tuple[Expr, Cell]]
) -> tuple[Answer, Constant | None]:
    """Return the answer to the order claim, and the best constant."""
    claim = f"{question.exact} == {question.approx} + O({gauge})"
    path = str(question.path)
    answer = check(
        f"{claim} as {path} on {region}" if region else claim,
        path=None if region else path,
        limit=SECONDS,
    )
    if region and answer.verdict is Verdict.UNDECIDED:  # the order may hold nevertheless
        answer = replace(check(claim, path=path, limit=SECONDS), constant=None)
    if answer.verdict is Verdict.REFUTED:
        return answer, None
    best = best_constant(question.exact, question.approx, gauge, question.path, region)
    return answer, best or _from_rows(answer, question, gauge, region, cells)


def _from_rows(
    answer: Answer,
    question: Question,
    gauge: Expr,
    region: str,
    cells: Sequence[tuple[Expr, Cell]],
) -> Constant | None:
    """Return the constant of an answer as the upper bound, and the largest ratio of a row.

    The constant of an answer need not be the best one: a lemma proves one that is rounded up.
    """
    if not answer or answer.constant is None or not (region or answer.region):
        return None
    region = region or answer.region or ""
    middle, radius = (as_rational(x) for x in answer.constant)
    name = question.path.name
    try:
        inside = Given(conditions_of(region))
    except InputError:
        return None
    best: tuple[fmpq, str] | None = None
    for x, one in cells:
        at = certified(x, 20)
        with ball_precision():
            if one.error is None or not all(c.holds_exactly({name: at}) for c in inside.conditions):
                continue
            ratio = abs(one.error) / abs(certified(substitute(gauge, {name: x}), 20))
            low = ratio.lower().fmpq()
        if best is None or low > best[0]:
            best = low, str(x)
    if best is None or not best[0] > 0:
        return None
    low, where = best
    found = Constant(_outward(low, -1), _outward(middle + radius, 1), region, "")
    return found._replace(where=f"{name} = {where}, of the points of the table")


def _outward(x: fmpq, side: int) -> str:
    """Return a positive number to 6 digits, rounded down or up."""
    near = rounded_number(x, FEW)
    if (as_rational(near) - x) * side >= 0:
        return near
    return rounded_number(x * (1 + side * fmpq(1, 10 ** (FEW - 1))), FEW)


def _where(at: Mapping[str, str]) -> str:
    return ", ".join(f"{name} = {_short_point(x)}" for name, x in at.items())


def _short_point(text: str) -> str:
    """Return a point as it is shown: a fraction with many digits as a decimal of a few."""
    if len(text) <= LONGEST_POINT:
        return text
    try:
        return rounded_number(as_rational(text), FEW)
    except InputError:
        return text


def _place(where: str) -> str:
    if not where:
        return ""
    return f" (largest {where if where.startswith('as ') else f'at {where}'})"
