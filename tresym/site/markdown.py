"""Markdown that several pages share: statements, verdicts, derivations."""

from __future__ import annotations

from typing import Any

from tresym.report.typesetting.chains import EQUIVALENT
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.statements import display, in_line, of_record, on_lines


def badge(verdict: str) -> str:
    """Return the verdict, in its colour."""
    return f"[{verdict}]{{.verdict .{verdict.lower()}}}"


def link(label: str, name: str = "") -> str:
    """Return a link to the page of a claim, under its readable name if that is given."""
    return f"[`{name or label}`](/claims/{label}.md)"


def titled(label: str, claim: dict[str, Any]) -> str:
    """Return the title of a claim, its label as a link to its page, and its verdict."""
    named = link(label, claim["alias"] or "")
    return f"**{sentence(claim['title'])}** {named} {badge(claim['verdict'])}"


def statement(claim: dict[str, Any]) -> str:
    """Return the statement with its conditions, on lines of their own."""
    return on_lines(of_record(claim))


def inline(claim: dict[str, Any]) -> str:
    """Return the statement with its conditions, within a line, for use after its title."""
    return in_line(of_record(claim), "")


def chain(lines: list[dict[str, Any]]) -> str:
    """Return a derivation: each expression with its reasons and the claims that they cite."""
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
