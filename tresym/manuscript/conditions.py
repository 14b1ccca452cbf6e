"""Formulas read as conditions: comparisons, sets, lists of integers, and what a symbol is not."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

from tresym.manuscript.display import STRANGE, Said
from tresym.manuscript.terms import Head, head_of, read_term
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY, INTEGERS
from tresym.reals.language.expression import (
    HALF,
    ONE,
    PI,
    ZERO,
    Expr,
    apply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED, Compared
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_author import Author
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

INDICES = frozenset("ijklmnpqrsIJKLMN")
"""Letters that usually denote integers."""
_OFF = (("\\ne",), ("\\neq",), ("\\notin",))
Conditions: TypeAlias = tuple[tuple[Compared, ...], tuple[tuple[str, Expr], ...], str]
"""What conditions state: comparisons, values to substitute, and a path."""


class ConditionReader(ABC):
    """Parse conditions as authors write them."""

    letter_e: bool
    letter_delta: bool

    @property
    @abstractmethod
    def author(self) -> Author:
        """What the LaTeX parser must know about the author's symbols."""

    def head(self, tokens: Sequence[str]) -> Head | None:
        """Return the symbol, function of symbols, or derivative that a term consists of."""
        author = Author(strict=True, letter_e=self.letter_e, letter_delta=self.letter_delta)
        return head_of(list(tokens), author)

    def condition(self, said: Said) -> Conditions | None:
        """Return what a condition states; None if it is not understood as a condition."""
        off = self.off_multiples(said) if said.ops in _OFF else None
        if off is not None:
            return off
        if not said.ops or any(op in STRANGE for op in said.ops):
            return None
        if said.values and said.ops == ("=",):
            return self.integers(said)
        if said.ops == ("\\in",) and said.terms[1][:1] == ("\\mathbb",):
            return self.member(said)
        if said.ops[0] == "\\in" and said.terms[1][:1] == ("\\mathbb",):
            return self.member_from(said)
        try:
            (chain,) = read_latex(" ".join(said.tokens), self.author)
        except (InputError, ValueError):
            return None
        if chain.ops[0].startswith("->"):
            point = {INFINITY: "oo", -INFINITY: "-oo"}.get(chain.terms[1], chain.terms[1])
            return (), (), f"{chain.terms[0]} -> {point}{chain.ops[0][2:]}"
        links = [
            link
            for link in chain.links
            if not {link[0], link[2]} & {INFINITY, -INFINITY} or link[1] not in ("<", "<=")
        ]
        if any(op == "==" for _, op, _ in links):
            left, _, right = links[0]
            if len(links) > 1 or said.values or not elementary(left, right):
                return None
            if left.op != "symbol":
                return tuple(links), (), ""
            return (), ((left.args[0], right),), ""
        if any(op not in NEGATED for _, op, _ in links) or not elementary(
            *(side for left, _, right in links for side in (left, right))
        ):
            return None
        return tuple(links), (), ""

    def off_multiples(self, said: Said) -> Conditions | None:
        """Off all multiples of π or 1, or odd ones of its half: ``x \\ne 0, \\pm\\pi, \\ldots``.

        It is None for what is no such condition.
        """
        try:
            x = read_term(said.terms[0], self.author).tree
            if said.ops == ("\\notin",):
                whole = said.terms[1][:1] == ("\\mathbb",) and "Z" in said.terms[1]
                return (((apply("sin", PI * x), "!=", ZERO),), (), "") if whole else None
            listed = [t for t in (said.terms[1], *said.values) if t != ("\\ldots",)]
            if len(said.values) != len(listed):  # nothing goes on
                return None if said.values else self.off_each(x, said.terms[1])
            values = [read_term([t for t in v if t != "\\pm"], self.author).tree for v in listed]
        except InputError:
            return None
        return _off(x, values)

    def off_each(self, x: Expr, term: Sequence[str]) -> Conditions | None:
        """Exclude the values of a term for every integer in it."""
        value = read_term(term, self.author).tree
        (name, *more) = sorted(symbols(value)) or [""]
        if more or name not in INDICES or value == symbol(name) or symbols(x) & INDICES:
            return None
        return _off(x, [substitute(value, {name: number(k)}) for k in range(3)])

    def integers(self, said: Said) -> Conditions | None:
        """``n = 0, 1, 2, \\ldots``: every integer from the first on, to the last if any is."""
        listed = [said.terms[1], *said.values]
        head, first = self.head(said.terms[0]), said.terms[1]
        if head is None or not all(len(v) == 1 and v[0].isdigit() for v in listed[:-1]):
            return None
        found = [int(v[0]) for v in listed[:-1]]
        if found != list(range(found[0], found[0] + len(found))):
            return None
        name = symbol(head.name)
        given: list[Compared] = [(name, "in", INTEGERS), (name, ">=", number(int(first[0])))]
        last = listed[-1]
        if last != ("\\ldots",):
            if last != (str(found[-1] + 1),):
                return None
            given.append((name, "<=", number(found[-1] + 1)))
        return tuple(given), (), ""

    def member_from(self, said: Said) -> Conditions | None:
        """``n \\in \\mathbb{Z} \\ge 4``, as "for integers $n \\ge 4$" is read."""
        own = self.member(replace(said, terms=said.terms[:2], ops=said.ops[:1]))
        terms = said.terms[:1] + said.terms[2:]
        bound = self.condition(replace(said, terms=terms, ops=said.ops[1:]))
        return (own[0] + bound[0], own[1] + bound[1], bound[2]) if own and bound else None

    def member(self, said: Said) -> Conditions | None:
        """``n \\in \\mathbb{Z}``, and the like."""
        head = self.head(said.terms[0])
        which = "".join(t for t in said.terms[1][1:] if t not in "{}^_")
        if head is None or which not in ("R", "Z", "N", "Z+", "N0", *PARITIES):
            return None
        if which in PARITIES:
            half = symbol(f"{head.name}_half")
            value = number(2) * half + number(int(which[0] == "O"))
            return whole(half, PARITIES[which]), ((head.name, value),), ""
        return () if which == "R" else whole(symbol(head.name), which), (), ""


PARITIES = {"O": "Z", "O+": "N0", "O0": "N0", "E": "Z", "E+": "N", "E0": "N0"}
"""The sets of odd and of even integers, and to which set half of these belongs."""


def whole(name: Expr, which: str) -> tuple[Compared, ...]:
    """Return the conditions that a symbol is in Z, N (from 1 on) or N0 (from 0 on)."""
    least = {"N": 1, "Z+": 1, "N0": 0}.get(which)
    return (name, "in", INTEGERS), *(() if least is None else [(name, ">=", number(least))])


def _off(x: Expr, values: Sequence[Expr]) -> Conditions | None:
    """Exclude all multiples, or odd multiples of one half, of π or 1, if ``values`` begin them."""
    for unit in (PI, ONE):
        for start, wave in ((ZERO, "sin"), (HALF, "cos")):
            row = [(start + k) * unit for k in range(len(values))]
            with ball_precision():
                gaps = [evaluate(one - other, {}) for one, other in zip(row, values, strict=True)]
                if len(values) > 1 and all(gap.contains(0) for gap in gaps):
                    return ((apply(wave, x if unit == PI else PI * x), "!=", ZERO),), (), ""
    return None
