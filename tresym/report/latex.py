"""Statements in LaTeX, in the paper's symbols."""

from __future__ import annotations

from sympy import And, Basic, Equivalent, Tuple, latex
from sympy.core.relational import Relational

from tresym.notation import LATEX

_RELATIONS = {"==": "=", ">": ">", ">=": r"\ge", "<": "<", "<=": r"\le", "!=": r"\ne"}


def expression_latex(e: Basic) -> str:
    """An expression as a mathematician would write it."""
    return latex(
        e, symbol_names=LATEX, ln_notation=True, inv_trig_style="full", fold_short_frac=False
    )


def says_latex(says: Basic | str) -> str:
    """What a claim says: prose as it is, anything else in LaTeX."""
    if isinstance(says, str):
        return says
    if isinstance(says, Equivalent):
        return r" \iff ".join(says_latex(part) for part in says.args)
    if isinstance(says, Tuple | And):
        return r",\quad ".join(says_latex(part) for part in says.args)
    if isinstance(says, Relational):
        left, right = map(expression_latex, says.args)
        return f"{left} {_RELATIONS[says.rel_op]} {right}"
    return expression_latex(says)


def given_latex(condition: Basic) -> str:
    """A condition in LaTeX."""
    return says_latex(condition)
