"""The text of a display made ready to be taken apart: layout dropped, numbers and words marked."""

from __future__ import annotations

import re

from tresym.manuscript.macros import group
from tresym.manuscript.notation import plain_notation
from tresym.reals.language.latex_tokens import CONDITION, FUNCTIONS

_UNIT = re.compile(
    r"(?<=[\d}])(?:\s|~|\\[ ,;])*\\(?:text|mathrm|textrm|mbox)\s*\{\s*(?:\\[ ,])?"
    r"((?:square |cubic )?(?:units?|feet|ft|inches|miles|meters|metres)|mph|seconds?|sec"
    r"|hours?|dollars?"
    r"|(?:ft|feet|miles|m|meters|metres|units?|dollars?)\s*/\s*(?:s|sec|second|hour|hr|h|unit)(?:\^?2)?)"
    r"\s*\.?\s*\}(?!\s*[\^_(\d])"
)
"""A unit behind a number; a display with one unit only is compared without it."""
FORALL = "\\forallsaid"
"""The token before a condition that says "for all"."""
GAP, AND, OR, OTHERWISE, WORDS = "\\gapquad", "\\wordand", "\\wordor", "\\otherwise", "\\words"
_DEFINED = re.compile(
    r"\\(?:stackrel|overset|underset)\s*\{((?:[^{}]|\{[^{}]*\})*)\}\s*(?:\{\s*=\s*\}|=)"
)
_DROPPED = re.compile(
    r"\\(?:nonumber|notag|displaystyle|ds|textstyle|allowbreak|nobreak|noindent|hfill|hfil|qedhere"
    r"|pause|null|small|footnotesize|scriptsize|normalsize"
    r"|mathstrut|strut|Biggl|Biggr|middle|qed|postdisplaypenalty\s*=\s*-?\d+)(?![a-zA-Z])"
    r"|\\(?:display|page|no|line)break(?![a-zA-Z])\s*(?:\[\d\])?"
    r"|\\rule\s*(?:\[[^\[\]]*\]\s*)?\{[^{}]*\}\s*\{[^{}]*\}"
    r"|\\(?:hspace|vspace|vphantom|hphantom|phantom|tag|label|cite|footnote|eqref|ref|color|raisebox"
    r"|smash)\*?\s*(?:\[[^\[\]]*\]\s*)?\{[^{}]*\}|\\hskip\s*-?[\d.]+\s*[a-z]{2}|\\hline"
)
_SET = re.compile(r"(?<![_^}\]\s])\s*\{\s*(\\mathbb\s*(?:\{\s*[A-Z]\s*\}|[A-Z]))\s*\}")
_THOUSANDS = re.compile(
    r"(?<![\d.,}])\d{1,3}(?:(?:(?:,|\{,\}|\\,)\d{3}){2,}|(?:\{,\}|\\,)\d{3}|,\d{3}(?=\.\d))"
    r"(?!,?\d)"
)
_ONE_COMMA = re.compile(r"(?<![\d.,}_{])(\d{1,3}),(\d{3})(?![\d,.]*\d)")
_REPEATING = re.compile(r"(?<![\d.])(\d+)\.(\d*)\\(?:overline|bar)\s*\{?(\d+)\}?")
_BRACED_ARRAY = re.compile(
    r"(?<==)\s*\\left\s*\\\{\s*\\begin\{array\}\s*\{[^{}]*\}((?:(?!\\begin).)*?)\\end\{array\}"
    r"\s*\\right\s*\.",
    re.DOTALL,
)
"""Cases that are set as an array behind a brace."""
"""Digits in groups: 36,000,000. One group alone after a bare comma, 1,000, may be a decimal."""
_BRACE = re.compile(r"\\(?:under|over)brace(?![a-zA-Z])")
_BETWEEN = re.compile(r"\\(?:short)?intertext\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_ENDED = re.compile(r"(?:\\\\\s*\*?\s*(?:\[[^\[\]]*\])?|\\end\{\w+\*?\}|\\begin\{\w+\*?\})\s*\Z")
"""The end of a line of a display, or the beginning of its first one."""
_INTEGER = re.compile(
    r"\\text\s*\{\s*(?:for |with |if |when )?(?:all |any |every |each |some |an? )?"
    r"(?:(positive |non-?negative |odd |even )?(?:integers?|numbers?)|(odd|even))"
    r"(?: values of)?\s*\}[\s~]*(?:\\[,;: ])*\s*\$?([a-zA-Z])(?![a-zA-Z])\$?"
)
_ARE_INTEGERS = re.compile(
    r"(?:is |are |an? )*(?:(odd|even|positive|non-?negative) integers?|(odd|even)|integers?)"
)
_WHEN = re.compile(
    r"\(?(?:and |but |only |valid |holds? |true |or |the last \w+ |this |is |are )*"
    r"(?:for|if|iff|when|whenever|where|provided|with|unless|as long as|as soon as|on|in"
    r"|at|assuming|given|except|near|while|until|under|because of|over|outside|inside)\b"
)
"""Words at the beginning of a condition."""
_TEXT = re.compile(
    r"\\(text|textrm|textnormal|mbox|textit|hbox|intertext|shortintertext|textup|mathrm"
    r"|operatorname\*?)\s*\{((?:[^{}]|\{[^{}]*\})*)\}"
)
_ADDED = re.compile(r"\\int\b(?:(?!\\\\|\\\w*quad|;).)*\+\s*\Z", re.DOTALL)
_FOR = re.compile(
    r"(?:and )?(?:holds? )?(?:valid |only |true )?(?:for|for all|for any|for every|for each|if|when"
    r"|whenever|as|given|given that|provided|provided that|with|where|on|in the limit|assuming"
    r"|for real|for all real)"
)
_ALL = re.compile(r"for (?:all|any|every|each)\b")
_REMARK = re.compile(
    r"\s*\(\s*(?:divid|multipl|add|subtract|by|us|factor|cancel|substitut|simplif|replac|tak)[a-z]*\s"
)
"""How a step was made, in brackets: "(divide by $x$)"."""
_WITHOUT = re.compile(
    r"(?:here|then|so|so that|hence|thus|therefore|or equivalently|i\.e\.|which is"
    r"|that is|resp\.?|respectively)"
)


def prepared(text: str, words: list[str]) -> str:
    """Return the text with marks for gaps and upright text, and without layout commands.

    Args:
        words: upright text that is not understood is appended to this list.
    """
    text = plain_notation(_DROPPED.sub(" ", text))
    text = _SET.sub(r" \1 ", text)
    text = _THOUSANDS.sub(lambda m: re.sub(r"\{?,\}?|\\,", "", m[0]), text)
    text = _ONE_COMMA.sub(r"{\1{,}\2}", text)
    text = _REPEATING.sub(_repeating, text)
    text = _BRACED_ARRAY.sub(r"\\begin{cases} \1 \\end{cases}", text)
    text = re.sub(r"\\boxed(?![a-zA-Z])|\\tcboxmath(?![a-zA-Z])(?:\s*\[[^\[\]]*\])?", " ", text)
    text = _without_braces_under(text)
    text = _INTEGER.sub(lambda m: rf"\text{{for }} {m[3]} \in {_set(m[1] or m[2] or '')}", text)
    text = re.sub(r"\\\\\s*\*?\s*(?:\[\s*-?[\d.]+\s*[a-z]{2}\s*\])?", r"\\\\ ", text)
    text = re.sub(
        r"\\q?quad(?![a-zA-Z])|\\enspace(?![a-zA-Z])", f" {GAP} ".replace("\\", r"\\"), text
    )
    text = re.sub(r"\\(?:triangleq|coloneq|doteq|eqdef|defeq)(?![a-zA-Z])|:\s*=", ":=", text)
    text = _DEFINED.sub(_relation_under, text)
    text = re.sub(
        r"\\forall(?![a-zA-Z])", rf"{AND} {FORALL} {CONDITION} ".replace("\\", r"\\"), text
    )
    text = re.sub(r"\\colon(?![a-zA-Z])", " ", text)
    if len({found[1] for found in _UNIT.finditer(text)}) == 1 and "\\SI" not in text:
        text = _UNIT.sub(" ", text)
    text = re.sub(r"\\(?:dots|dotsc|cdots|dotsb)(?![a-zA-Z])", r"\\ldots ", text)
    return _TEXT.sub(lambda m: _spoken(m, words), text)


def _repeating(found: re.Match[str]) -> str:
    """Return a repeating decimal as a fraction."""
    places, period = found[2], found[3]
    nines = 10 ** len(places) * (10 ** len(period) - 1)
    above = int(found[1] + places + period) - int(found[1] + places)
    return rf"\frac{{{above}}}{{{nines}}}"


def _relation_under(found: re.Match[str]) -> str:
    """Return the meaning of an equality sign with something over it, such as "def" or "?"."""
    if re.search(r"[?!]", found[1]):
        return r" \questioned "
    return ":=" if re.search("def|triangle|Delta", found[1]) else "="


_SETS = {"": "Z", "positive": "N", "nonnegative": "N0", "non-negative": "N0"}
_SETS |= {"odd": "O", "even": "E"}


def _set(words: str) -> str:
    """Return the set of integers that words such as "odd" and "positive" name."""
    return rf"\mathbb{{{_SETS[words.strip()]}}}"


def between(text: str) -> tuple[str, list[str]]:
    """Split a display into its formulas and the prose between its lines, which ends a line."""
    found = list(_BETWEEN.finditer(text))
    for words in reversed(found):
        before = text[: words.start()]
        end = " " if not before.strip() or _ENDED.search(before) else r" \\ "
        text = before + end + text[words.end() :]
    return text, [words[1] for words in found]


def _without_braces_under(text: str) -> str:
    """Remove braces over or under formulas, with the labels of the braces."""
    while (mark := _BRACE.search(text)) is not None:
        inside, end = group(text, mark.end())
        label = re.compile(r"\s*[_^]").match(text, end)
        if label and (command := re.compile(r"\s*\\[a-zA-Z]+\s*(?=\{)").match(text, label.end())):
            label = command  # _\text{small}
        end = group(text, label.end())[1] if label else end
        text = f"{text[: mark.start()]} {inside} {text[end:]}"
    return text


def _spoken(found: re.Match[str], words: list[str]) -> str:
    """Replace upright text by the tokens that it stands for."""
    command, text = found[1], found[2]
    if command in ("mathrm", "operatorname", "operatorname*") or re.fullmatch(r"\s*\w\s*", text):
        return found[0]
    ahead = found.string[: found.start()].rstrip()
    if ahead.endswith(("_", "^", "_{", "^{")):
        return found[0]
    pieces = re.split(r"\$([^$]*)\$", text)
    if _REMARK.match(text) and len(pieces) > 1:
        words.append(" ".join(text.split()))
        return f" {GAP} {WORDS} "
    result = ""
    for n, piece in enumerate(pieces):
        if n % 2:
            result += f" {piece} "
            continue
        word = " ".join(re.sub(r"[~\s(),.:;\\]+", " ", piece).lower().split())
        stop = " , " if re.match(r"\s*[,;.]", piece) else " "
        if not word:
            result += stop
        elif word in ("and", "and also", "as well as"):
            result += f" {AND} "
        elif word in ("or",):
            result += f" {OR} "
        elif word in ("otherwise", "else"):
            result += f" {CONDITION} {OTHERWISE} "
        elif _ALL.match(word) and _FOR.fullmatch(word):
            result += f" {AND} {FORALL} {CONDITION} "
        elif _FOR.fullmatch(word):
            result += f" {CONDITION} "
        elif _WITHOUT.fullmatch(word):
            result += f" {AND} "
        elif word == "rad":
            result += " "
        elif word.rstrip(".") in ("const", "constant") and _ADDED.search(ahead):
            result += " C "  # of an integral; E = const. says that E does not vary
        elif word in FUNCTIONS:
            result += found[0]
        elif not re.search(r"[^\W\d_]{2}", word):
            result += found[0] if len(pieces) == 1 else f" {piece} "
        elif one := _ARE_INTEGERS.fullmatch(word):
            result += rf" \in {_set(one[1] or one[2] or '')} "
        else:
            words.append(" ".join(piece.split()))
            apart = CONDITION if _WHEN.match(word) else ""
            apart = apart or (GAP if piece.lstrip().startswith("(") else "")
            result += f" {apart} {WORDS} "
    return result
