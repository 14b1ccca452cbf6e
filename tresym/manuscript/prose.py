"""Read the prose around a display for its kind and its conditions, cautiously."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tresym.manuscript.restrictions import (
    binding,
    is_conditional,
    is_hypothesis,
    is_of_display_before,
)

DEFINE, ASSUME, SOLVE, CLAIM = "define", "assume", "solve", "claim"

_KINDS = (
    (
        SOLVE,
        r"equations?|solv\w+|roots?|satisf\w+|obeys?|govern\w*|unknowns?|curve|system|constraints?"
        r"|equilibri\w+|differential|conserv\w+|laws?|boundary|initial",
    ),
    (ASSUME, r"suppos\w+|assum\w+|hypothes\w+|ansatz|try|seek|look for|postulat\w+|require\w*"),
    (DEFINE, r"let|defin\w+|denot\w+|introduc\w+|set|put|write|where|with|abbreviat\w+|call\w*"),
    (CLAIM, r"identit\w+|for (?:all|every|any|each)"),
)
_KIND = tuple((kind, re.compile(rf"\b(?:{words})\b")) for kind, words in _KINDS)
_BY = re.compile(r"\b(?:us(?:e|ing)|by|from|with|via|apply(?:ing)?)\b[^,.;:]*?\bidentit\w+")
_TOLD = re.compile(
    r"\b(?:then|since|because|hence|so|thus|therefore|consequently|find|have|obtain|get|see|follows?"
    r"|shows?|gives?|yields?|implies|proves?)\W*(?:that\W*)?\Z",
    re.IGNORECASE,
)
_NAMED = re.compile(
    r"\bthe (?:(?!(?:cases?|conditions?|equations?|equalit\w+|relations?|limits?|lines?|curves?"
    r"|planes?|points?|assumptions?|hypothes\w+|identit\w+|values?|choices?|constraints?|claims?"
    r"|requirements?|possibilit\w+|exceptions?|statements?|ansatz|inequalit\w+)\b)"
    r"[\w-]+[\s~]+){1,3}\Z",
    re.IGNORECASE,
)
"""Words that name the value of a formula: "the energy $E = mc^2$"."""
INLINE = re.compile(r"(?<!\\)\$([^$]+)\$|\\\((.+?)\\\)", re.DOTALL)
_SENTENCE = re.compile(r"(?<=[a-z)}$])[.!?](?=\s+[A-Z\\$])|\n\s*\n|\\par(?![a-zA-Z])")
_LASTING = re.compile(
    r"\b(?:let|suppose|assume|assuming|throughout|consider|restrict\w*|take)\b[^.$]*$",
    re.IGNORECASE,
)
_PASSING = re.compile(
    r"\b(?:for|when|if|where|with|provided|given|whenever|that|all|any|every|on|as|and|or|,)\W*\Z"
    r"|\b(?:for|when|if|where|with|provided|given|whenever)\b[^.$]*\Z"
    r"|\b(?:f(?:ü|ue|\\\"u|\{\\\"u\}|\\\"\{u\})r|falls|wenn|pour|lorsque|para|cuando)\b[^.$]*\Z",
    re.IGNORECASE,
)
_DEFINING = re.compile(
    r"\b(?:let|letting|where|with|defin\w+|set|setting|denot\w+|put|putting|introduc\w+|writ\w+|here"
    r"|notation|abbreviat\w+|substitut\w+)\b[^.$]*\Z",
    re.IGNORECASE,
)
_WHOLE = r"(positive |non-?negative |natural |nonzero )?(?:integers?|natural numbers?)"
_INTEGER_BEFORE = re.compile(rf"(?<![\w-]){_WHOLE}[\s~]*\Z", re.IGNORECASE)
_NO_INTEGER = re.compile(
    r"\b(?:not|no|non|half|half an|neither|nor|except)[\s~-]+(?:an? )?\Z", re.IGNORECASE
)
_LIST = r"((?:[\s~,]*(?:and\b[\s~]*)?\$[^$]*\$){0,8})[\s~,]*(?:is|are|be|being|denotes?)?\s*"
_INTEGER_AFTER = re.compile(
    rf"{_LIST}"
    rf"(?:an?|any|some|both|all|fixed|given|arbitrary)?\s*{_WHOLE}"
)
_SIGNED = {"positive": "> 0", "negative": "< 0", "nonnegative": "\\geq 0", "nonpositive": "\\leq 0"}
_SIGNED["nonzero"] = "\\neq 0"
_SIGN = r"(?:strictly )?((?:non-?)?(?:positive|negative)|non-?zero)"
_NUMBERS = r"(?:\s+(?:real )?(?:numbers?|reals?|constants?|parameters?|values?(?: of)?))?"
_SIGN_BEFORE = re.compile(
    r"\b(?:for|all|any|every|each|both|and|let|with|given|fixed|arbitrary|consider|take|an?|real)"
    rf"[\s~]+{_SIGN}{_NUMBERS}[\s~]*\Z",
    re.IGNORECASE,
)
_SIGN_AFTER = re.compile(
    rf"{_LIST}(?:(?:an?|any|some|all|both|fixed|given|arbitrary|real|real and) )*"
    rf"{_SIGN}{_NUMBERS}[\s~]*(?=[.,;:]|and\b|\Z)"
    r"(?!,?\s*(?:or|if|iff|when|whenever|only|unless|except|but|and not)\b)",
)
_PARITIES = {"odd": "O", "even": "E"}
_FROM = {"positive": "+", "natural": "+", "negative": "0"}
_PARITY_BEFORE = re.compile(
    r"\b(?:(positive|non-?negative)[\s~]+)?(odd|even)(?:[\s~]+(positive|non-?negative|natural))?"
    r"(?:[\s~]+(?:integers?|numbers?|values?(?: of)?))?[\s~]*\Z",
    re.IGNORECASE,
)
_PARITY_AFTER = re.compile(
    r"[\s~,]*(?:is|are|be|being)?[\s~]*(?:an?[\s~]+)?"
    r"(?:(positive|non-?negative)[\s~]+)?(odd|even)\b(?:[\s~]+(positive|non-?negative|natural)\b)?"
    r"(?![\s~]*(?:or|if|function|part|extension|permut|periodic))"
)
_PIECE = re.compile(
    r"[\s~,]*(?:otherwise|elsewhere|else\b"
    r"|(?:only )?(?:for|if|when|whenever|on|in)\b[^.;$]{0,40}"
    r"\$[^$]*(?:[<>=,\[]|\\(?:[lg]eq?|neq?)(?![a-z])))"
)
_WANTED = re.compile(
    r"\b(?:want\w*|wish\w*|need\w*|seek\w*|find|look\w* for|to show|to prove|ensure\w*|guarantee\w*"
    r"|goal|make sure|require\w*|aim\w*)\b[^.;:$]*\Z",
    re.IGNORECASE,
)
_INTRODUCED = re.compile(
    r"\b(?:let|consider|given|suppose(?: that)?|for|an?|any|every|each|two|some|another"
    r"|(?:let|consider|given|suppose|for) the)(?:[\s~]+(?:\w+[\s~]+){0,2}(?:functions?|curves?"
    r"|sequences?|series))?[\s~]*\Z",
    re.IGNORECASE,
)
_RENAMED = re.compile(
    r"[\s~,]*(?:now[\s~]+|here[\s~]+)?(?:is|denotes|means|stands[\s~]+for)[\s~]+(?:now[\s~]+|here[\s~]+)?the[\s~]+"
    r"(?!(?:same|only|unique|required|desired|function[\s~]+(?:above|defined|given|from|in|of)|solution"
    r"|sum|product|inverse|derivative|integral|above|general|following|most|least|smallest|largest"
    r"|case|one)\b)"
)
"""Words behind a symbol that say what it is, "is the tangent", whatever it was before."""
_WRITTEN = re.compile(r"\b(?:write|use|using|writing)[\s~]*\Z", re.IGNORECASE)
_NEITHER = re.compile(r"\b(?:neither|nor|not|no)[\s~]*\Z", re.IGNORECASE)
_SYMBOL = r"(?:\\[a-zA-Z]+|[a-zA-Z])(?:_\w)?"
_SYMBOL_FIRST = re.compile(rf"\s*({_SYMBOL})\s*")
_SYMBOLS = re.compile(rf"\s*{_SYMBOL}(?:\s*,\s*{_SYMBOL})*\s*")
_NARROWED = re.compile(
    r"\bfor (?:all|every|any|each)\b[^.]*?(?:\$|\\\)|numbers?|values?|reals?)\s*,?\s*"
    r"(?:that|which|whose|but|except|not|other|outside|away|near|close|sufficiently)\b",
    re.IGNORECASE,
)
_PARITY = re.compile(r"\b(?:odd|even)\b[^.$]*\Z", re.IGNORECASE)
_HALVED = re.compile(r"\s*[a-zA-Z]\s*=\s*2\s*[a-zA-Z]\s*(?:[+-]\s*1\s*)?")
_ANEW_BEFORE = re.compile(r"\b(?:real|all|any|every|each|arbitrary)\b[^.,;:$]*\Z", re.IGNORECASE)
_ANEW_AFTER = re.compile(
    rf"{_LIST}(?:an?|any|some|both|all|not)?\s*(?:real|non-?zero|arbitrary)\b", re.IGNORECASE
)
_DENIED = re.compile(
    r"\b(?:fails?|failing|false|wrong|invalid|untrue|without(?! loss)|drop\w*|lift\w*|no longer"
    r"|(?:not|never) (?:true|valid|hold\w*|so|correct|assum\w*|requir\w*|need\w*|suppos\w*))"
    r"\b[^.$;:]*\Z|\b(?:no|not)[\s~]*\Z",
    re.IGNORECASE,
)
_DENIED_AFTER = re.compile(
    r"[\s~]*(?:fails?\b|(?:is|are|does|do|need|can)\s*(?:not|no longer)\b"
    r"|is (?:false|violated|wrong)\b"
    r"|no longer\b|cannot\b)",
    re.IGNORECASE,
)
_OR = re.compile(r"[\s~,]*\bor\b(?:[\s~,]*(?=\$|\Z)|\s+(?:not|else|otherwise)\b)")
_EXCEPT = re.compile(
    r"\b(?:except|unless|excluding|other than|but not|apart from)\b[^.$;:]*\Z", re.IGNORECASE
)
_OPPOSITE = {"=": "\\neq ", "<": "\\geq ", ">": "\\leq "}
_OPPOSITE |= dict.fromkeys(("\\le", "\\leq"), "> ") | dict.fromkeys(("\\ge", "\\geq"), "< ")
_OPPOSITE |= dict.fromkeys(("\\ne", "\\neq"), "= ")
_RELATION = re.compile(r"[<>=]|\\(?:[lg]eq?|neq?|in)(?![a-zA-Z])")
_SAID_OF = re.compile(
    r"(?:\W|\b(?:for|if|when|whenever|and|or|then|with|an?|all|every|any|each|real|positive|negative"
    r"|non-?negative|non-?zero|not|both|zero|integers?|is|are|the|numbers?|values?|of)\b)*"
)
_TENDS = re.compile(
    r"\bfor (?:very |sufficiently )?(small|large)[\s~]+(?:values of[\s~]+)?\Z", re.IGNORECASE
)
MAX_AFTER = 600


class Inline(NamedTuple):
    """An inline formula, and what the words around it say about it.

    Attributes:
        tex: the formula.
        lasting: it is a condition to the end of the section ("Let $a > 0$").
        passing: it is a condition of the display of this sentence ("for $x > 0$").
        defining: it may define a symbol ("where $r = \\sqrt{b/a}$").
        told: it is claimed to hold ("then $m = 2k + 1$").
        whole: the set of integers its symbols belong to: Z, N or N0; empty if not integers
            ("a positive integer $n$", "$m$ is odd, so $m = 2k + 1$").
        tends: the limit of its symbol, 0 or oo, as in "for small $x$".
        anew: it introduces its symbols anew ("for all real $x$"), so earlier conditions end.
        binds: words that bind its symbols ("there is", "choose").
        hypothesis: it is supposed or denied, so that it defines nothing.
        conditional: it says when something else holds ("if $a = b$").
        piece: it holds for some arguments only ("$f(t) = t$ for $t < 0$").
        last: it is in the last sentence.
        introduced: it introduces a symbol or a function ("Let $f(x)$ be").
    """

    tex: str
    lasting: bool
    passing: bool
    defining: bool
    told: bool
    whole: str = ""
    anew: bool = False
    tends: str = ""
    binds: str = ""
    hypothesis: bool = False
    conditional: bool = False
    piece: bool = False
    last: bool = False
    introduced: bool = False


def kind_of(before: str) -> str:
    """Return what the sentence before a display calls it; the last such word decides."""
    words = _BY.sub(" ", INLINE.sub(" ", last_sentence(before)).lower())
    found = [(m.end(), kind) for kind, pattern in _KIND for m in pattern.finditer(words)]
    return max(found)[1] if found else ""


_CONDITION = re.compile(r"(?:and\s+)?(?:for|where|when|whenever|if|provided|with|since|because)\b")


def without_formulas(text: str) -> str:
    """Return a text with ``$`` in place of each formula."""
    return INLINE.sub("$", text)


def last_sentence(text: str) -> str:
    """Return the last sentence of a text, which leads to the display behind it."""
    pieces = _SENTENCE.split(text)
    return next((piece for piece in reversed(pieces) if piece.strip()), "")


def first_sentence(text: str) -> str:
    """Return the rest of a sentence that continues after a display, else ``""``."""
    text = text[:MAX_AFTER]
    start = text.lstrip(" \n\t.,;")
    skipped = text[: len(text) - len(start)]
    goes_on = start[:1].islower() or start[:1] == "$" or start[:1] == "("
    if "\n\n" in skipped or "." in skipped or not goes_on:
        return ""
    return _SENTENCE.split(start)[0]


def is_of_next(between: str) -> bool:
    """Whether the text between two displays belongs to the second: "and for $x < 0$,"."""
    leads = re.match(r"[\s~,;]*(?:and|but|while|whereas|or)\b", between)
    return bool(leads) and len(_SENTENCE.split(between.strip())) == 1 and "." not in between


def is_universal(before: str, after: str) -> bool:
    """Whether the sentence before a display only says for which values it is claimed.

    Examples are "If $x > 0$, then" and "For real $a$ and $b$". Behind the display it may continue
    with a condition only: a formula that "has a root" is an equation.
    """
    words = INLINE.sub(" ", last_sentence(before)).lower()
    rest = first_sentence(after)
    return (not rest or bool(_CONDITION.match(rest))) and bool(
        _SAID_OF.fullmatch(words) and re.search(r"\b(?:for|if|when|whenever)\b", words)
    )


_UNIFORMLY = re.compile(
    r"(?<!not )(?<!non-)(?<!non)\buniformly\b"
    r"(?!\s+(?:distributed|random|convergent|continuous|chosen|spaced|\w+ed\b))",
    re.IGNORECASE,
)


def is_uniform(before: str, after: str) -> bool:
    """Whether the sentence of a display says that it holds uniformly."""
    parts = last_sentence(before), first_sentence(after)
    return any(_UNIFORMLY.search(without_formulas(part)) for part in parts)


_OF_LAST_OR_BOTH = re.compile(
    r"\b(?:for|all|any|every|each|real)[\s~]+(?:numbers[\s~]+|values[\s~]+of[\s~]+)?"
    rf"\$({_SYMBOLS.pattern})\$[\s~]*(?:,|and|,[\s~]*and)[\s~]*"
    rf"\$(\s*{_SYMBOL}\s*(?:[<>]|\\[lg]eq?(?![a-zA-Z]))[^$]*)\$",
    re.IGNORECASE,
)


def of_last_or_both(text: str) -> tuple[str, str] | None:
    """Return the symbols of which a condition may be meant, too: "for all $x$ and $y > 0$".

    Returns:
        The symbols before the condition, and the condition; None if no text of this form is there.
    """
    found = _OF_LAST_OR_BOTH.search(text)
    return (found[1].strip(), found[2].strip()) if found else None


def is_told(before: str) -> bool:
    """Whether the sentence before a display claims it: "Let $z < 0$. Then"."""
    return bool(_TOLD.search(last_sentence(before)))


def is_narrowed(before: str) -> bool:
    """Whether "for all $x$" is narrowed by further words, which are not understood."""
    return bool(_NARROWED.search(last_sentence(before)))


def is_of_signs(text: str) -> bool:
    """Whether a text states different conditions for the upper and the lower sign."""
    return bool(re.search(r"\bupper\b.*\blower\b|\blower\b.*\bupper\b", text, re.DOTALL))


def inline(text: str) -> Iterator[Inline]:
    """Yield the inline formulas of a text, sentence by sentence."""
    sentences = _SENTENCE.split(text)
    for number, sentence in enumerate(sentences):
        start, carried, anew = 0, (False, False, False, False), False
        conditional = False
        for found in INLINE.finditer(sentence):
            words = sentence[start : found.start()]
            if start and re.fullmatch(r"[\s,~]*(?:and|or)?[\s,~]*", words):
                marks = carried
            else:
                anew, conditional = bool(_ANEW_BEFORE.search(words)), is_conditional(words)
                marks = (
                    bool(_LASTING.search(words)),
                    bool(_PASSING.search(words)),
                    bool(_DEFINING.search(words)),
                    bool(_TOLD.search(words) or _NAMED.search(words)),
                )
            if _WANTED.search(words):  # a goal, not a condition
                marks, conditional = (False, False, *marks[2:]), False
            tex, rest = found[1] or found[2], sentence[found.end() :]
            signed, parity = _signed(tex, words, rest), ""
            if signed:  # introduced anew, then restricted
                yield Inline(tex, *marks, anew=anew)
                tex, anew = signed, False
            elif parity := _parity(tex, words, rest):
                tex = _SYMBOL_FIRST.sub(rf"\1 \\in \\mathbb{{{parity}}} ", tex, count=1)
            alone = not _RELATION.search(tex)
            told = alone and (anew or bool(_ANEW_AFTER.match(rest[:200])))
            if not alone and _is_no_condition(words, rest):
                marks, told = (False, False, False, False), True
            elif _EXCEPT.search(words):
                tex, marks = opposite(tex), (False, True, False, False)
            halved = _PARITY.search(words) and _HALVED.fullmatch(tex)
            whole = "Z" if halved else "" if parity else _whole(words, rest, alone)
            small = _TENDS.search(words)
            tends = {"small": "0", "large": "oo"}[small[1].lower()] if small else ""
            ahead = INLINE.sub("$", sentence[: found.start()])
            yield Inline(
                *(tex, *marks, whole, told, tends),
                binds=binding(ahead, rest),
                hypothesis=is_hypothesis(ahead, rest),
                conditional=conditional,
                piece=bool(_PIECE.match(rest[:120])),
                last=number == len(sentences) - 1,
                introduced=alone and bool(_INTRODUCED.search(words) or _is_renamed(words, rest)),
            )
            start, carried = found.end(), marks


def _is_renamed(before: str, after: str) -> bool:
    """Whether words say what a symbol is: "Here $h$ is the tangent", "write $h$ for the sine"."""
    written = _WRITTEN.search(before) and re.match(r"[\s~]*for[\s~]+the\b", after)
    return bool(written or _RENAMED.match(after[:120]))


def _signed(tex: str, before: str, after: str) -> str:
    """Return the condition on the signs of symbols that the words around them state, else ``""``.

    Words behind a list apply to all of it only if they are in the plural.
    """
    if not _SYMBOLS.fullmatch(tex) or _NEITHER.search(before):
        return ""
    found, kind = _SIGN_BEFORE.search(before[-60:]), 1
    if found is None:
        found, kind = _SIGN_AFTER.match(after[:200]), 2
        if found and found[1].strip() and not re.search(r"\b(?:are|be|being)\b", found[0]):
            return ""
    if found is None:
        return ""
    relation = _SIGNED[found[kind].replace("-", "").lower()]
    return ", ".join(f"{name.strip()} {relation}" for name in tex.split(","))


def _parity(tex: str, before: str, after: str) -> str:
    """Return O or E if the words around ``n`` or ``n \\ge 1`` call n odd or even, else ``""``.

    Behind it stands + if they call it positive, 0 if not negative.
    """
    one = _SYMBOL_FIRST.match(tex)
    if one is None or (tex[one.end() :] and not _RELATION.match(tex, one.end())):
        return ""
    before = before[-60:]
    found = _PARITY_BEFORE.search(before) or _PARITY_AFTER.match(after[:60])
    denied = found and _NEITHER.search(before[: found.start()])
    if not found or denied:
        return ""
    sign = (found[1] or found[3] or "").lower().replace("non-", "").replace("non", "")
    return _PARITIES[found[2].lower()] + _FROM.get(sign, "")


def conditions_behind(after: str) -> Iterator[Inline]:
    """Yield conditions in the sentences after a display: "It is valid only if $s > 0$"."""
    paragraph = re.split(r"\n\s*\n", after[:MAX_AFTER].lstrip(" \t\n.,;"))[0]
    for sentence in _SENTENCE.split(paragraph)[:3]:
        for found in inline(sentence):
            ahead = sentence[: sentence.find(found.tex.partition(" \\in ")[0])].rstrip("$")
            if is_of_display_before(INLINE.sub("$", ahead)):
                yield found


def _is_no_condition(before: str, after: str) -> bool:
    """Whether a formula between these words is denied, or one of several alternatives."""
    denied = _DENIED.search(before) or _DENIED_AFTER.match(after[:60])
    return bool(denied or _OR.fullmatch(before) or _OR.match(after[:60]))


def opposite(tex: str) -> str:
    """Return the negation of a formula with one relation, ``""`` for any other formula."""
    found = [*_RELATION.finditer(tex)]
    if len(found) != 1 or found[0][0] not in _OPPOSITE:
        return ""
    (one,) = found
    return tex[: one.start()] + _OPPOSITE[one[0]] + tex[one.end() :]


def _whole(before: str, after: str, alone: bool) -> str:
    """Return the set of integers, Z, N or N0, that the words around symbols state, else ``""``.

    Words behind a list apply to all of it if they are in the plural and each symbol stands alone:
    in "$x > 0$ and $n$ a positive integer" they apply to the last.
    """
    found, kind = _INTEGER_BEFORE.search(before[-60:]), 1
    if found is not None and _NO_INTEGER.search(before[-60:][: found.start()]):
        return ""
    if found is None:
        found, kind = _INTEGER_AFTER.match(after[:200]), 2
        if found and found[1].strip() and not (alone and found[0].endswith("s")):
            found = None
    if found is None:
        return ""
    said = (found[kind] or "").strip().replace("-", "").lower()
    return {"positive": "N", "natural": "N", "nonnegative": "N0"}.get(said, "Z")
