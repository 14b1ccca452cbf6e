r"""Fill in the templates of the article: text in which the ledger supplies all that can change.

The templates are LaTeX files in ``proofs/article``. A placeholder ``{{kind arguments}}`` is
replaced by what the ledger has now: a formula, a number, a constant, a condition, a verdict. Every
kind is a method of :class:`Templates`, with its arguments. Three kinds have a text of their own,
which ends at ``{{end}}``: figures, derivations and the sentence of a theorem.

A comment ``% expects: d24 REFUTED, repaired ENCLOSED`` names the verdicts with which the text was
written; claims that it does not list must be proved, defined or assumed. It is an error if a
template names a claim that is gone, or whose verdict has changed. A comment ``% check: CLAIM given
CONDITIONS`` is an identity that the text uses without a claim of the ledger; a test proves it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Decimal
from functools import cache
from typing import Any

from flint import fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.finding import Premise
from tresym.ledger.formulas import EqualMatrices, Rounded, parts_of
from tresym.ledger.paper import file_of
from tresym.ledger.sentences import changed as compared
from tresym.ledger.verification import Row
from tresym.reals.language.compound import Equivalent
from tresym.reals.language.expression import factors_in, number
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import InputError, exact_number, fraction_text
from tresym.report.pages.derivation import LINE, aligned_rows, alone, chosen_lines, continued, prose
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.latex import expression_latex, says_latex, side_latex
from tresym.report.typesetting.line_breaking import broken
from tresym.report.typesetting.statements import in_dollars, said
from tresym.report.typesetting.titles import shown_name

INLINE = re.compile(r"\{\{(\w+)((?: [^{}]*)?)\}\}")
"""A placeholder: its kind and its arguments."""
BLOCK = re.compile(r"\{\{(figure|steps|theorem|named) ([^{}]*)\}\}(.*?)\{\{end\}\}", re.DOTALL)
"""A placeholder with a text of its own."""
PASSAGE = re.compile(r"^% passage: ([\w-]+)\n(.*?)^% end$", re.MULTILINE | re.DOTALL)
"""A passage that other pages quote: its name and its text."""
EXPECTS = re.compile(r"^% expects: (.+)$", re.MULTILINE)
_UNLABELLED = frozenset(["figure", "number", "count", "piece", "end"])
"""The kinds whose first argument is not the label of a claim."""
_RELATION = re.compile(r" (=|<|>|\\le|\\ge|\\iff) ")
_REPEATED = re.compile(r"(\\raised\{\w+\}\{(\w)\})(?:\s*\\raised\{\w+\}\{\2\})+")
"""The same verdict several times in a row: one letter is enough."""
WAYS = {"down": ROUND_FLOOR, "up": ROUND_CEILING}
"""The ways in which a number is rounded that stands in an inequality in words."""
SHARE = 0.86
"""The width of a line of the article relative to that of the ledger."""
HOLDS = frozenset(["PROVED", *(premise.value for premise in Premise)])
"""The verdicts that a template need not declare."""


def names() -> tuple[str, ...]:
    """Return the names of the templates in the order of the article."""
    return tuple(sorted(path.stem for path in file_of("article").glob("*.tex")))


@cache
def text_of(name: str) -> str:
    """Return the text of a template; its name may have another ending than ``.tex``."""
    path = file_of("article") / (name if "." in name else f"{name}.tex")
    return path.read_text(encoding="utf-8")


def labels_in(text: str) -> tuple[str, ...]:
    """Return the labels of the claims that a template names, each once."""
    found = [(m[1], m[2].split()) for m in (*INLINE.finditer(text), *BLOCK.finditer(text))]
    return tuple(dict.fromkeys(args[0] for kind, args in found if kind not in _UNLABELLED))


def theorems() -> dict[str, str]:
    """Return the sentences of the theorems of the article, by the label of their claim."""
    return {
        m[2].split()[0]: " ".join(m[3].split())
        for name in names()
        for m in BLOCK.finditer(text_of(name))
        if m[1] == "theorem"
    }


def figures_in(text: str) -> tuple[str, ...]:
    """Return the names of the figures in a template."""
    return tuple(m[2].strip() for m in BLOCK.finditer(text) if m[1] == "figure")


def passages() -> dict[str, str]:
    """Return the passages of the templates that other pages quote, by name."""
    return {m[1]: m[2] for name in names() for m in PASSAGE.finditer(text_of(name))}


def expected(text: str) -> dict[str, str]:
    """Return the verdict that a template declares for each claim that it names."""
    declared = dict(
        item.split() for line in EXPECTS.findall(text) for item in line.split(",") if item.strip()
    )
    return {label: declared.get(label, "") for label in (*labels_in(text), *declared)}


def changed(text: str, rows: Mapping[str, Row]) -> Iterator[str]:
    """Yield a line for each claim of a template that is gone or has another verdict."""
    for label, declared in expected(text).items():
        found = rows[label].finding.verdict.value if label in rows else "not in the ledger"
        if found != declared and not (declared == "" and found in HOLDS):
            yield f"{label} is {found}; the text expects {declared or 'that it holds'}"
    for kind, args, inside in (m.groups() for m in BLOCK.finditer(text)):
        label = args.split()[0]
        if kind == "theorem" and label in rows:
            key, sentence = f"theorem {label}", " ".join(inside.split())
            why = compared(key, sentence, rows[label].claim)
            if why is not None:
                yield f"theorem {label}: {why}"


class Templates:
    """Templates filled in from verdicts and numbers.

    Args:
        rows: the claims with their verdicts, by label.
        numbers: other numbers by name, from :mod:`tresym.report.pages.numbers`.
        pieces: functions that write longer parts, such as the list of corrections, by name.
    """

    def __init__(
        self,
        rows: Mapping[str, Row],
        numbers: Mapping[str, str],
        pieces: Mapping[str, Callable[..., str]],
    ) -> None:
        """Take the verdicts and numbers that the placeholders stand for."""
        self.rows, self.numbers, self.pieces = rows, numbers, pieces

    def filled(self, name: str) -> str:
        """Return a template with every placeholder replaced.

        Raises:
            InputError: a claim that the template names is gone, or has another verdict.
        """
        text = text_of(name)
        faults = [*changed(text, self.rows)]
        if faults:
            raise InputError(f"article: {name}.tex no longer fits the ledger: {'; '.join(faults)}")
        return self.fill(text)

    def fill(self, text: str) -> str:
        """Return a text with every placeholder replaced, without its comments."""
        text = re.sub(r"^%.*\n", "", text, flags=re.MULTILINE)
        return _REPEATED.sub(r"\1", INLINE.sub(self._inline, BLOCK.sub(self._block, text)))

    def _block(self, found: re.Match[str]) -> str:
        kind, args, inside = found[1], found[2].split(), INLINE.sub(self._inline, found[3])
        return str(getattr(self, kind)(*args, inside=inside.strip()))

    def _inline(self, found: re.Match[str]) -> str:
        kind, args = found[1], found[2].split()
        if kind.startswith("_") or not hasattr(self, kind):
            raise InputError(f"article: there is no placeholder {found[0]}")
        return str(getattr(self, kind)(*args))

    def _claim(self, label: str) -> Claim:
        return self.rows[label].claim

    def _part(self, label: str, part: str) -> str:
        """The formula of a claim, or of its part with a number."""
        claim = self._claim(label)
        if not part:
            return said(claim).formula or ""
        if claim.shown:
            return re.split(r",\\quad |,\\qquad | \\iff ", claim.shown)[int(part) - 1]
        parts = () if isinstance(claim.says, str) else parts_of(claim.says)
        chosen = [says_latex(p) for p in parts] if len(parts) > 1 else _sides(*parts)
        return chosen[int(part) - 1]

    def formula(self, label: str, part: str = "") -> str:
        """Return the formula of a claim, or a part of it, for use in a text."""
        return self._part(label, part)

    def lhs(self, label: str, part: str = "") -> str:
        """Return the left side of the formula of a claim."""
        return _RELATION.split(self._part(label, part), maxsplit=1)[0]

    def rhs(self, label: str, part: str = "") -> str:
        """Return the right side of the formula of a claim."""
        return _RELATION.split(self._part(label, part), maxsplit=1)[2]

    def display(self, label: str, *parts: str) -> str:
        """Return the formula of a claim as a numbered equation, with its verdict in the margin."""
        lines = [self._part(label, part) for part in parts or ("",)]
        body = alone(lines[0], SHARE) if len(lines) == 1 else _aligned(lines)
        return self._equation(label, body)

    def _equation(self, label: str, body: str) -> str:
        name = shown_name(label).replace("_", r"\_\allowbreak ")
        mark = rf"\inmargin{{{label}}}{{{self._letter(label)}}}{{{name}}}"
        return f"{mark}\\begin{{equation}}\\label{{eq:{label}}}\n{body}\n\\end{{equation}}"

    def steps(self, label: str, *_: str, inside: str) -> str:
        """Return chosen lines of a derivation, one for each item of the text between bars.

        An item is the number of a line and the reason in words; without words, no reason is set.
        Numbers joined by a plus sign are set in one line.
        """
        items = (item.strip().partition(" ") for item in inside.split("|"))
        body = chosen_lines(self._claim(label), ((n, why.strip()) for n, _, why in items), SHARE)
        return self._equation(label, body)

    def named(self, label: str, part: str = "", *, inside: str) -> str:
        """Return an equation with the right side of a claim; the text is a name for the left."""
        limit = SHARE * LINE - width(inside)
        first, *rest = broken(f"= {self.rhs(label, part)}", limit)
        return self._equation(label, aligned_rows([f"{inside} &{first}", *map(continued, rest)]))

    def theorem(self, label: str, kind: str = "theorem", *, inside: str) -> str:
        """Return a theorem whose sentence is the text, with the verdict of the claim."""
        sentence = f"{inside}{self.verdict(label)}"
        return rf"\begin{{{kind}}}\label{{thm:{label}}}{sentence}\end{{{kind}}}"

    def figure(self, name: str, *, inside: str) -> str:
        """Return a figure; the text is its caption."""
        return (
            rf"\begin{{figure}}[tb]\centering\shown{{{name}}}"
            rf"\caption{{{inside}}}\label{{fig:{name}}}\end{{figure}}"
        )

    def given(self, label: str, *numbers: str) -> str:
        """Return the conditions of a claim, or those with the given numbers, in a list."""
        found = said(self._claim(label)).given
        chosen = [found[int(n) - 1] for n in numbers] if numbers else found
        return ", ".join(map(in_dollars, chosen))

    def says(self, label: str) -> str:
        """Return the sentence of a claim, or its formula with its conditions."""
        found = said(self._claim(label))
        if found.says:
            return prose(found.says)
        given = ", ".join(map(in_dollars, found.given))
        return f"${found.formula}$" + (f" for {given}." if given else ".")

    def note(self, label: str) -> str:
        """Return the note of a claim."""
        return prose(self._claim(label).note)

    def value(self, label: str, digits: str, way: str = "") -> str:
        """Return the value of a number claim, rounded to so many significant digits.

        After "more than" or "at most" it must be rounded ``down`` or ``up``.
        """
        found = self.rows[label].finding.value
        if found is None:
            raise InputError(f"article: {label} has no value")
        if not way:
            return rounded(Decimal(found.mid), int(digits))
        end = Decimal(found.rad) if way == "up" else -Decimal(found.rad)
        return rounded(Decimal(found.mid) + end, int(digits), WAYS[way])

    def printed(self, label: str) -> str:
        """Return the decimal that the paper prints, which a number claim decides."""
        statement = self._claim(label).statement
        return scientific(statement.text) if isinstance(statement, Rounded) else ""

    def constant(self, label: str, part: str = "1", share: str = "") -> str:
        """Return the constant of a bound: the rational factor of its right side, as a decimal."""
        bound = parts_of(self._claim(label).says)[int(part) - 1]
        first = factors_in(bound.right)[0]
        factor = first.args[0] if first.op == "number" else fmpq(1)
        return decimal(100 * factor if share == "percent" else factor)

    def witness(self, label: str) -> str:
        """Return the point at which a refuted claim fails."""
        point = self.rows[label].finding.witness or {}
        named = ((re.sub(r"(?<=[a-z])(\d)$", r"_\1", n), v) for n, v in point.items())
        return ", ".join(f"${n} = {fraction_text(v)}$" for n, v in named)

    def boxes(self, label: str) -> str:
        """Return the number of boxes on which a bound is proved."""
        found = self.rows[label].finding.boxes
        if not found:
            raise InputError(f"article: {label} is not proved on boxes")
        return str(found)

    def verdict(self, label: str) -> str:
        """Return the verdict of a claim as a small raised letter that links to the ledger."""
        return rf"\raised{{{label}}}{{{self._letter(label)}}}"

    def claim(self, label: str) -> str:
        """Return the label of a claim, linked to the ledger."""
        return rf"\claim{{{label}}}"

    def _letter(self, label: str) -> str:
        return self.rows[label].finding.verdict.value[0]

    def ref(self, label: str) -> str:
        """Return the number of the equation that displays a claim."""
        return rf"\eqref{{eq:{label}}}"

    def number(self, name: str, way: str = "") -> str:
        """Return a number by name, such as the count of claims with a verdict.

        After "more than" or "at most" it must be rounded ``down`` or ``up``.
        """
        return self.numbers[f"{name}_{way}" if way else name]

    count = number

    def piece(self, name: str, *args: str) -> str:
        """Return a longer part, such as the list of corrections."""
        return self.pieces[name](*args)


def _sides(says: Any) -> list[str]:
    """The sides of an equation, an inequality or an equivalence."""
    if isinstance(says, Equivalent):
        return [says_latex(part) for part in says.parts]
    sides = (says.left, says.right) if isinstance(says, Relation | EqualMatrices) else ()
    return [side_latex(side) for side in sides]


def _aligned(formulas: list[str]) -> str:
    """Formulas below each other, aligned at their relations."""
    body = ",\\\\\n".join(_RELATION.sub(r" &\1 ", formula, count=1) for formula in formulas)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def rounded(x: Decimal, digits: int, way: str = ROUND_HALF_EVEN) -> str:
    """Return a decimal in LaTeX with so many significant digits."""
    if x:
        x = x.quantize(Decimal(1).scaleb(x.adjusted() - digits + 1), rounding=way)
    return scientific(f"{x:.{digits}g}" if abs(x) >= Decimal("0.001") else f"{x:.{digits - 1}e}")


def scientific(text: str) -> str:
    """Return a number in LaTeX: ``1.09e-2`` as a product with a power of ten."""
    digits, _, power = text.partition("e")
    return rf"{digits}\times 10^{{{int(power)}}}" if power else digits


def decimal(x: fmpq) -> str:
    """Return a rational number as a finite decimal, or else as a fraction."""
    exact = Decimal(int(x.p)) / Decimal(int(x.q))
    return f"{exact:f}" if exact_number(exact) == x else expression_latex(number(x))
