"""Find the formulas in the reason of a verdict, so that documents typeset them.

    parts("it behaves like -1/6/eps near 0")    # "it behaves like ", a formula, " near 0"

A reason is a sentence for a terminal, with formulas in the grammar of text. A formula is the
longest run of words that can be read as a claim or an expression, that holds a sign of operation or
a relation, and whose variables are single letters or known names; so ``right-hand`` stays a word.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import as_written, parse_given
from tresym.reals.language.readings import in_latex
from tresym.reals.language.typesetting import expression_in_latex, to_latex
from tresym.reals.numbers.exact import InputError

LONGEST = 40
"""Words of a formula at most."""
_SIGN = re.compile(r"[-+*/^()<>=]")
_WORD = re.compile(r"[A-Za-z_]\w*")
_TAIL = re.compile(r"[,;:.]$")


def parts(text: str, known: Collection[str] = ()) -> Iterator[tuple[str, bool]]:
    """Yield the pieces of a sentence, and whether each is a formula, which is given in LaTeX.

    Args:
        text: the sentence.
        known: names of variables that are longer than a letter.
    """
    words = re.split(r"(\s+)", text)
    plain, n = "", 0
    while n < len(words):
        formula = ""
        if _WORD.search(words[n]) or words[n][:1].isdigit() or words[n][:1] in "(-":
            last = min(len(words), n + 2 * LONGEST)
            for end in range(last - 1 + last % 2, n, -2):
                run = "".join(words[n:end])
                tail = _TAIL.search(run)
                run = run[: tail.start()] if tail else run
                closing = tail[0] if tail else ""
                if run.endswith(")") and run.count(")") > run.count("("):  # of a remark
                    run, closing = run[:-1], f"){closing}"
                formula = _formula(run, known)
                if formula:
                    yield plain, False
                    yield formula, True
                    plain, n = closing, end
                    break
        if not formula:
            plain += words[n]
            n += 1
    yield plain, False


def _formula(text: str, known: Collection[str]) -> str:
    """Return a text in LaTeX if it is a formula, else nothing."""
    if not _SIGN.search(text) or not re.search(r"\w", text) or " is " in text:
        return ""
    try:
        if re.search(r"[<>=~]", text):
            shown = in_latex(text)
            names = set(_WORD.findall(text)) - {"given", "and", "integer", "as"}
            return shown if all(_is_variable(n, known) or f"{n}(" in text for n in names) else ""
        e = as_written(text)
    except InputError:
        return ""
    return expression_in_latex(e) if all(_is_variable(n, known) for n in symbols(e)) else ""


def _is_variable(name: str, known: Collection[str]) -> bool:
    return len(name.rstrip("0123456789_")) == 1 or name in known or name in ("pi", "oo", "eps")


def region_latex(region: str) -> str:
    """Return a region in LaTeX, each condition once; nothing if it is not of conditions."""
    try:
        found = parse_given(re.sub(r"\|([^|]+)\|", r"abs(\1)", region))
    except InputError:
        return ""
    return to_latex(dict.fromkeys(found))
