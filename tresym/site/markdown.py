"""Pieces of Markdown that several pages are made of: statements, verdicts, chains."""

from __future__ import annotations

from typing import Any

from tresym.report.words.chains import EQUIVALENT
from tresym.report.words.markdown import sentence

LONGEST_IN_A_LINE = 60
"""Systems of more LaTeX characters than this are set one equation below the other."""
LONGEST_IN_A_LIST = 220
"""Formulas of more LaTeX characters than this stand on the page of their claim only."""


def badge(verdict: str) -> str:
    """The word of a verdict, in its colour."""
    return f"[{verdict}]{{.verdict .{verdict.lower()}}}"


def link(label: str, folder: str = "/claims/") -> str:
    """A link to the page of a claim."""
    return f"[`{label}`]({folder}{label}.md)"


def statement(claim: dict[str, Any]) -> str:
    """What a claim says, on a line of its own: a sentence, a formula, or both."""
    parts = [sentence(claim["says"])] if claim["says"] else []
    parts += [display(claim["formula"])] if claim["formula"] else []
    return "\n\n".join(parts)


def inline(claim: dict[str, Any]) -> str:
    """What a claim says, within a line; a formula too long for that is named as such."""
    if claim["says"]:
        return sentence(claim["says"])
    formula = claim["formula"]
    if len(formula) > LONGEST_IN_A_LIST:
        return "a formula of several lines"
    parts = formula.replace("|", r"\vert ").split(r",\quad ")
    return ", ".join(f"${part.strip()}$" for part in parts)


def display(formula: str) -> str:
    """A formula on a line of its own; a long system takes a line for each of its parts."""
    formula = formula.strip()
    if len(formula) > LONGEST_IN_A_LINE:
        for joint in (r",\quad ", r" \iff "):
            parts = formula.split(joint)
            if len(parts) > 1 and r"\begin" not in formula:
                mark = r"\iff\quad " if "iff" in joint else ""
                lines = rf" \\ {mark}".join(parts)
                return f"$$\n\\begin{{gathered}}{lines}\\end{{gathered}}\n$$"
    return f"$$\n{formula}\n$$"


def chain(lines: list[dict[str, Any]]) -> str:
    """A chain: each expression with its reasons, which name the claims they rest on."""
    rows = []
    for line in lines:
        if line["left"] and line["left"] != EQUIVALENT:
            rows.append(_row("start", line["left"], ""))
        arrow = r"\iff\quad " if line["left"] == EQUIVALENT else ""
        words = ", ".join(_said(reason) for reason in line["reasons"])
        rows.append(_row("step", arrow + line["right"], words))
    body = "\n".join(rows)
    return f":::::{{container}} chain\n{body}\n:::::"


def _row(kind: str, formula: str, words: str) -> str:
    said = f":::{{container}} reason\n{words}\n:::\n" if words else ""
    return f"::::{{container}} {kind}\n{display(formula)}\n\n{said}::::"


def _said(reason: dict[str, Any]) -> str:
    if reason["labels"]:
        return f"{reason['words']} " + ", ".join(map(link, reason["labels"]))
    return f"{reason['words']} ${reason['formula']}$" if reason["formula"] else reason["words"]
