"""Derivations as lines: each expression in LaTeX with the reasons for the step to it.

The article and the site typeset the same lines, each in its own format.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from tresym.ledger.claim import Chain, Claim, Reason, Step
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.formulas import EqualMatrices, in_trees, is_bound, is_equation, parts_of
from tresym.reals.functions.table import TABLE, upright
from tresym.reals.language.compound import Equivalent
from tresym.reals.language.expression import ZERO
from tresym.reals.language.formula import Relation
from tresym.report.typesetting.latex import bracketed, expression_latex, says_latex, side_latex

EQUIVALENT = r"\iff{}"
"""The left part of a line that is equivalent to the line before."""

_SIGN = "by the sign prover"
_VERBS = {"substituting": "by", "citing": "since"}
_SIGNS = {">": ">", ">=": r"\ge", "<": "<", "<=": r"\le", "!=": r"\ne"}


class Because(NamedTuple):
    """A reason: its words, a formula that belongs to it, and the labels of the claims it cites."""

    words: str
    formula: str = ""
    labels: tuple[str, ...] = ()


class Line(NamedTuple):
    """A line of a display: the LaTeX left and right of the alignment mark, and the reasons."""

    left: str
    right: str
    reasons: tuple[Because, ...] = ()


Display = tuple[Line, ...]


def displays(claim: Claim) -> tuple[Display, ...]:
    """Return the displays of a claim: one for each auxiliary fact and each part of the statement.

    Each display holds the chain of equalities by which it is derived, if there is one.
    """
    facts = tuple((Line("", says_latex(fact), (Because(_SIGN),)),) for fact in claim.knowing)
    return (*facts, *_shown(claim))


def _shown(claim: Claim) -> tuple[Display, ...]:
    proof, says = claim.proof, claim.says
    if claim.shown is not None:
        return ((Line("", claim.shown),),)
    if isinstance(says, str):
        return ()
    parts = parts_of(in_trees(says))
    derived = all(isinstance(p, Relation | EqualMatrices | Equivalent) for p in parts)
    if isinstance(proof, Decided) and proof.chains and derived:
        one_each = len(proof.chains) == len(parts)
        chains = proof.chains if one_each else proof.chains * len(parts)
        return tuple(_lines(part, chain) for part, chain in zip(parts, chains, strict=True))
    return tuple((Line("", says_latex(part)),) for part in parts)


def _lines(says: Any, chain: Chain) -> Display:
    """A chain as in a textbook: each expression in a line, with its reason at the right."""
    says = in_trees(says)
    if isinstance(says, Equivalent):
        return tuple(_equivalence(says, chain))
    if is_bound(says):
        sign, up = _SIGNS[says.sign], says.upward
        if chain[0].expression is None:
            return (Line("", says_latex(says), _reasons(chain[0], _SIGN)),)
        if chain[-1].expression is None:  # both sides as they were written, the sign at the end
            last = Line("", f"{sign} {expression_latex(says.right)}", _reasons(chain[-1]))
            return (*_equations(expression_latex(says.left), chain[:-1], ""), last)
        difference = expression_latex(up.left if up.right == ZERO else up.left - up.right)
        return tuple(_equations(difference, chain, "", f" {_SIGNS[up.sign]} 0"))
    goal = side_latex(says.right) if is_equation(says) else ""
    return tuple(_equations(side_latex(says.left), chain, goal))


def _equations(start: str, chain: Chain, goal: str, sign: str = "") -> Iterator[Line]:
    for n, link in enumerate(chain):
        shown = goal if link.expression is None else side_latex(link.expression)
        end = sign if n == len(chain) - 1 else ""
        if n == 0 and shown == start:
            yield Line(start, end.strip(), _reasons(link))
        else:
            yield Line(start if n == 0 else "", f"= {shown}{end}", _reasons(link))


def _equivalence(says: Equivalent, chain: Chain) -> Iterator[Line]:
    first, second = says.parts
    backwards = chain[-1].expression == first
    yield Line("", says_latex(second if backwards else first))
    for link in chain:
        arrived = second if link.expression is None else link.expression
        yield Line(EQUIVALENT, says_latex(arrived), _reasons(link))


def _reasons(link: Step, otherwise: str = "algebra") -> tuple[Because, ...]:
    said = tuple(_said(reason) for reason in link.reasons if reason.name != "algebra")
    return said or (Because(otherwise),)


def _said(reason: Reason) -> Because:
    if reason.claims:
        labels = tuple(claim.label for claim in reason.claims)
        return Because(_VERBS.get(reason.name, f"{reason.name},"), labels=labels)
    if reason.function is not None:
        row = TABLE.get(reason.function)
        printed = row is not None and row.family == "inverse hyperbolic"
        name = upright(row) if printed and row else reason.function
        return Because(f"{name} of both sides")
    if reason.factor is not None:
        return Because("times", bracketed(expression_latex(reason.factor)))
    if reason.term is not None:
        return Because("adding", expression_latex(reason.term))
    return Because(reason.name)
