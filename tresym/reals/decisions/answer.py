"""The answer to a claim, as plain text and numbers."""

from __future__ import annotations

import decimal
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, field
from html import escape
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.reals.decisions.identity import with_point
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr
from tresym.reals.language.readings import in_latex, in_mathml
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.notebook import abbreviated, html_table, in_one_line
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import (
    Decimal,
    InputError,
    decimal_ball,
    fraction_text,
    parse_number,
)
from tresym.reals.verdict import Cause, Verdict

DIGITS = (12, 40, 220, 1250)
CONSTANT_DIGITS = 6
"""How many digits of the bounds of a constant are shown."""
_WORST = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED, Verdict.PROVED)


class Alternative(NamedTuple):
    """What is true instead of a claim that is refuted.

    Attributes:
        claim, given: the claim that holds and its conditions, in the grammar of text.
        edit: what is different in it, in words.
        verdict: PROVED or ENCLOSED.
    """

    claim: str
    given: str
    edit: str
    verdict: str

    def __str__(self) -> str:
        under = f" given {self.given}" if self.given else ""
        return f"{self.verdict}: {self.claim}{under} ({self.edit})"


class Obligation(NamedTuple):
    """An elementary statement that a lemma asks for, with its verdict.

    Attributes:
        claim, given: the statement and its conditions, in the grammar of text; the claim ends in
            its path where it has one.
        verdict: PROVED or ENCLOSED, or what the statement was found to be instead.
    """

    claim: str
    given: str
    verdict: str

    def __str__(self) -> str:
        under = f" given {self.given}" if self.given else ""
        return f"{self.claim}{under}: {self.verdict}"


@dataclass(frozen=True)
class Answer:
    """The verdict on one claim, with its reason.

    Attributes:
        verdict: PROVED, ENCLOSED, REFUTED or UNDECIDED.
        why: the procedure that decided, or what stopped it and what may help.
        statement: the claim as written.
        given: its conditions.
        witness: for REFUTED, names to exact numbers; or, where ``!=`` fails by a change of sign,
            to the intervals between whose ends it does.
        values: both sides at the witness, in balls that exclude the claim.
        constant: for O, a ball around the supremum of the ratio on the region.
        region: where the claim is certified, when that is less or more precise than it says.
        seconds: processor time, so that a busy machine decides what an idle one decides.
        line: of the file it was read from.
        read_as: the claim with its conditions and path in the grammar of expressions.
        root: where the witness is known by intervals, what it is exactly.
        instead: for REFUTED, claims close to it that hold, where they were looked for.
        lemma: the lemma that reduced the claim to obligations, with its source; or empty.
        obligations: the statements to which the lemma reduced the claim, with their verdicts.
        cause: what decided, or what stopped the decision, for programs. If it is left out, or
            belongs to another verdict, it is the usual one of the verdict.
        uniform: for an order with parameters, whether one constant serves for all of their values
            (True), or the claim was decided for each fixed value and no one constant serves
            (False); None if that is not known or there are no parameters.
        smallest: whether the constant is enclosed from both sides although a lemma decided.

    Example:
        >>> import tresym
        >>> found = tresym.check("x**2 == 9", given="x > 0")
        >>> found.verdict.value, sorted(found.witness)
        ('REFUTED', ['x'])
        >>> bool(found)
        False
    """

    verdict: Verdict
    why: str
    statement: str = ""
    given: str = ""
    witness: Mapping[str, str] | None = None
    values: tuple[Decimal, Decimal] | None = None
    constant: Decimal | None = None
    region: str | None = None
    seconds: float = field(default=0.0, compare=False)
    line: int | None = None
    read_as: str = ""
    instead: tuple[Alternative, ...] = field(default=(), compare=False)
    lemma: str = ""
    obligations: tuple[Obligation, ...] = ()
    cause: Cause | None = None
    uniform: bool | None = None
    smallest: bool = False

    def __post_init__(self) -> None:
        if self.cause is None or self.cause.verdict is not self.verdict:
            usual = Cause.usual(self.verdict, self.witness is not None)
            object.__setattr__(self, "cause", usual)

    def __bool__(self) -> bool:
        """Whether the claim holds: PROVED or ENCLOSED."""
        return self.verdict.holds

    def __repr__(self) -> str:
        return in_one_line(f"Answer({self.verdict.value}: {self.read_as}; {self.why})")

    def __str__(self) -> str:
        sentence, rows = self.in_text()
        lines = (f"  {name}: {text}" for name, text in rows)
        return "\n".join([f"{self.verdict.value}: {sentence}", *lines])

    def in_text(self) -> tuple[str, list[tuple[str, str]]]:
        """Return what text output shows: the reason's first clause, and the details.

        Returns:
            The clause that follows the verdict on the first line, and names with texts for the
            lines below it; what else the reason says is the detail ``note``.

        Example:
            >>> import tresym
            >>> tresym.check("sin(2*x) == sin(x)").in_text()[0]
            'the two sides differ at x = 441/388'
        """
        sentence, _, rest = abbreviated(self.why).partition("; ")
        if sentence.count("(") != sentence.count(")"):  # the semicolon stands in brackets
            sentence, rest = abbreviated(self.why), ""
        rows = [("note", rest) if name == "why" else (name, text) for name, text in self.rows()]
        named = [f"{name} = {value}" for name, value in (self.witness or {}).items()]
        if all(part in sentence for part in named):  # the first line names the point already
            rows = [row for row in rows if row[0] != "witness"]
        return sentence, [row for row in rows if row[1]]

    def rows(self) -> list[tuple[str, str]]:
        """Return everything but the verdict, as names and text.

        The row ``read as`` is left out if the claim was read as it was written, spaces aside.
        Numbers of more than 60 digits are abbreviated in ``read as`` and ``given``.

        Example:
            >>> import tresym
            >>> dict(tresym.check("x + x == 2*x").rows())["claim"]
            'x + x == 2*x'
        """
        written = (self.statement, f"{self.statement} given {self.given}")
        same = any(_unspaced(text) == _unspaced(self.read_as) for text in written)
        read_as = "" if same else self.read_as
        rows = [("claim", self.statement), ("read as", abbreviated(read_as))]
        rows.append(("given", abbreviated(self.given)))
        rows.append(("why", self.why))
        if self.witness is not None:
            shown = ", ".join(f"{name} = {value}" for name, value in self.witness.items())
            rows.append(("witness", shown or "the claim has no variables"))
        if self.values is not None:
            rows.append(("left side", ball_text(self.values[0])))
            rows.append(("right side", ball_text(self.values[1])))
        if self.constant is not None:
            rows.append(("constant", self.constant_text()))
        rows.append(("region", self.region or ""))
        if self.uniform is not None:
            rows.append(("uniform", "yes" if self.uniform else "no"))
        rows.append(("lemma", self.lemma))
        rows += [("obligation", str(part)) for part in self.obligations]
        rows += [("instead", str(found)) for found in self.instead]
        return [row for row in rows if row[1]]

    @property
    def sharp(self) -> bool | None:
        """Whether the constant is known to one per cent; None without a constant.

        A lemma, and a constant for all values of parameters, give an upper bound alone.

        Example:
            >>> import tresym
            >>> tresym.check("exp(x) == 1 + O(x) as x -> 0 on abs(x) <= 1").sharp
            True
        """
        if self.constant is None:
            return None
        middle, radius = map(parse_number, self.constant)
        return self._encloses_smallest and radius <= middle / 100

    @property
    def _encloses_smallest(self) -> bool:
        return self.smallest or (not self.lemma and self.uniform is not True)

    def constant_text(self) -> str:
        """Return what is known of the smallest constant; empty without one.

        Example:
            >>> import tresym
            >>> tresym.check("exp(x) == 1 + O(x) as x -> 0 on abs(x) <= 1").constant_text()
            'between 1.71828 and 1.71829'
            >>> claim = "integral(exp(-x*t)/(1+t), t, 0, oo) == O(1/x) as x -> oo"
            >>> tresym.check(claim).constant_text().split()[:2]
            ['at', 'most']
        """
        if self.constant is None:
            return ""
        return constant_text(self.constant, self._encloses_smallest)

    def as_json(self) -> dict[str, Any]:
        """A JSON value; every key is always there.

        Example:
            >>> import tresym
            >>> tresym.check(r"\\frac{x}{2} + \\frac{x}{2} = x").as_json()["read_as"]
            'x/2 + x/2 == x'
        """
        value = asdict(self) | {
            "verdict": self.verdict.value,
            "cause": self.cause and self.cause.value,
        }
        value["witness"] = None if self.witness is None else dict(self.witness)
        value["constant"] = None if self.constant is None else self.constant._asdict()
        value["sharp"] = self.sharp
        value["values"] = None if self.values is None else [ball._asdict() for ball in self.values]
        value["instead"] = [found._asdict() for found in self.instead]
        value["obligations"] = [part._asdict() for part in self.obligations]
        value["seconds"] = round(self.seconds, 6)
        return value

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        return html_table(self.verdict.value, self.rows(), _typeset)

    def _repr_latex_(self) -> str:
        """The verdict, with the claim as it was read."""
        return rf"$\textbf{{{self.verdict.value}}}:\ {in_latex(self.read_as)}$"


_FORMULAS = ("claim", "read as", "given", "region")
"""The rows whose text is a formula."""
_INSTEAD = re.compile(r"([A-Z]+: )(.*?)( \(.*\))")


def _typeset(name: str, text: str) -> str:
    """Return a cell for notebooks: its formula as MathML, with the text itself on hovering."""
    if text == name:
        return escape(text)
    if name == "instead" and (found := _INSTEAD.fullmatch(text)):
        before, claim, after = found.groups()
        return f"{escape(before)}{_typeset('claim', claim)}{escape(after)}"
    shown = in_mathml(text) if name in _FORMULAS else ""
    return f'<span title="{escape(text)}">{shown}</span>' if shown else escape(text)


Decide = Callable[[Comparison, Statement], Answer]
"""The answer to a simpler claim."""


def worst(answers: Iterable[Answer]) -> Answer:
    """Return the weakest of several answers: REFUTED, then UNDECIDED, ENCLOSED, PROVED."""
    return min(answers, key=lambda found: _WORST.index(found.verdict))


def _unspaced(text: str) -> str:
    return "".join(text.split())


def ball_text(ball: Decimal) -> str:
    """Return a ball in decimal, with its radius unless it is exact."""
    return ball.mid if ball.rad == "0" else f"{ball.mid} ± {ball.rad}"


def failing(relation: str) -> str:
    """Return in words what the values of both sides are where a relation fails.

    Example:
        >>> failing("=="), failing("!="), failing("<")
        ('the two sides differ', 'the two sides are equal', 'the left side is not < the right side')
    """
    words = {"==": "the two sides differ", "!=": "the two sides are equal"}
    return words.get(relation, f"the left side is not {relation} the right side")


def constant_text(ball: Decimal, smallest: bool = True) -> str:
    """Return a constant by bounds with the digits that matter, rounded to the safe sides.

    Args:
        ball: a ball around the constant.
        smallest: whether no smaller constant serves; of another one only the upper bound is shown.

    Example:
        >>> constant_text(Decimal("2.0600099999999", "2e-13"))
        'between 2.06000 and 2.06001'
        >>> constant_text(Decimal("1000", "1200"))
        'at most 2200'
    """
    if ball.rad == "0":
        return ball.mid if smallest else f"at most {ball.mid}"
    with decimal.localcontext(decimal.Context(prec=2 * decimal.getcontext().prec + len(ball.mid))):
        middle, radius = map(decimal.Decimal, ball)
        ends = middle - radius, middle + radius
    low, high = (
        str(decimal.Context(prec=CONSTANT_DIGITS, rounding=side).create_decimal(end)).lower()
        for end, side in zip(ends, (decimal.ROUND_FLOOR, decimal.ROUND_CEILING), strict=True)
    )
    return f"between {low} and {high}" if smallest and ends[0] > 0 else f"at most {high}"


def exactly(sentence: str, point: Mapping[str, fmpq | Expr]) -> str:
    """Return the sentence followed by an exact point, which may have irrational coordinates."""
    return with_point(sentence, point, exact_text)


def exact_text(value: fmpq | Expr) -> str:
    """A coordinate of an exact point, as one would type it: its roots of whole numbers."""
    if isinstance(value, Expr):
        return str(normal_form(value, Given()))
    return fraction_text(value)


def refuted(
    why: str, point: Mapping[str, fmpq | Expr], left: arb | None = None, right: arb | None = None
) -> Answer:
    """Return a refutation at an exact point, with the values of both sides if they are given."""
    witness = {name: exact_text(value) for name, value in point.items()}
    values = None
    if left is not None and right is not None:
        values = _apart(left, right)
    return Answer(Verdict.REFUTED, why, witness=witness, values=values)


def _apart(left: arb, right: arb) -> tuple[Decimal, Decimal]:
    """Both balls in decimal, with the digits it takes to see them apart where they are."""
    with ball_precision(5000):
        for digits in DIGITS[:1] if left.overlaps(right) else DIGITS:
            x, y = decimal_ball(left, digits), decimal_ball(right, digits)
            try:
                gap = abs(parse_number(x.mid) - parse_number(y.mid))
                if gap > parse_number(x.rad) + parse_number(y.rad):
                    break
            except InputError:  # an exponent beyond those that are read: few digits will do
                break
    return x, y


def constant_ball(x: arb) -> Decimal:
    """Return the constant of an O claim in decimal, to 6 digits."""
    with ball_precision(128):
        return decimal_ball(x, 6)
