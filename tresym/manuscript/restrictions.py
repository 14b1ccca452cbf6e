"""Words that tie a symbol down: after them it is not free for a counterexample.

After "there is an $M$ such that", "choose $d$" or "let $r$ be a root", a statement about the symbol
need not hold for every number, and its restriction is not understood. So no counterexample to such
a statement is reported.
"""

from __future__ import annotations

import re

_EXISTS = (
    r"there (?:is|are|exists?|must|will|can)\b|\bexists?\b|\bsuch that\b|\bsatisf\w+"
    r"|(?<!we )(?<!one )(?<!can )\bfind\b(?! that)|\bfor some\b|\bfor which\b"
)
_CHOSEN = (
    r"\b(?:choos\w+|chosen|pick\w*|fix\w*|select\w*|some|large enough|small enough|sufficiently"
    r"|in (?:the|this) case|case|happens?|at the (?:point|origin|end|place)"
    r"|given(?! (?:any|all|every|each|an arbitrary|arbitrary|that)\b))\b"
)
_ABSURD = (
    r"\bcontradict\w*|\bcontrary\b|\bimpossible\b|\babsurd\w*|\bwould\b|\bwere\b|\bfalse\b"
    r"|\bunless\b|\bif not\b|\bcan(?:no| no|')t\b|\bnot (?:hold|true|possible|the case)\b"
)
_WHAT = (
    r"(?:solutions?|roots?|zeros?|eigenvalues?|primes?|inverses?|minim\w+|maxim\w+|extrem\w+|infim\w+"
    r"|suprem\w+|limits?|(?:upper |lower )?bounds?|points?|such|as (?:above|before|in)"
    r"|fixed|given|chosen|critical|stationary|equilibri\w+|fixed points?|partitions?|periods?)\b"
)
_NOUN_AFTER = re.compile(
    r"[\s~,]*(?:be|is|are|being|denotes?|become)[\s~]+(?:(?:the|an?|any|some|one|its|their|also"
    rf"|(?:un)?known|first|smallest|largest|least|positive|negative|real|only|unique)[\s~]+)*{_WHAT}"
)
_NOUN_BEFORE = re.compile(
    rf"\b{_WHAT}(?:[\s~]+(?:of the form|with|at|in|to|of))?[\s~]*\Z", re.IGNORECASE
)
_BINDING = re.compile(
    rf"{_EXISTS}|{_ABSURD}|{_CHOSEN}(?=[^$.;]{{0,60}}(?:\$(?:[\s~,]|and|or)*)*\Z)", re.IGNORECASE
)
_STATED = re.compile(f"{_EXISTS}|{_ABSURD}", re.IGNORECASE)
_HYPOTHETICAL = re.compile(_ABSURD, re.IGNORECASE)
_SUPPOSED = re.compile(
    r"\b(?:if|suppos\w+|assum\w+|whenever|satisf\w+|such that|there (?:is|are|exists?)|exists?"
    r"|in (?:the|this) case|when|unless|until)\b[^$;:]*\Z",
    re.IGNORECASE,
)
_CONDITIONAL = re.compile(
    r"(?:\b(?:for|when|if|whenever|provided|unless|as long as)\b)[^.,;:$]*\Z",
    re.IGNORECASE,
)
_NEXT = re.compile(
    r"\b(?:only|valid|holds?|true|converg\w+|provided|as long as|requir\w+|must|defined|exists?"
    r"|makes? sense|assum\w+|suppos\w+|legitimate|correct)\b[^.;$]*\Z",
    re.IGNORECASE,
)


_LOOSE = re.compile(
    r"approximat\w*|neglect\w*|ignor\w*|roughly|(?<!\\)\b(?:small|large)\b"
    r"|(?<!using the )\border\b(?! of integration)|asymptotic\w*"
    r"|\bleading\b|lineari[sz]\w*|\bup to\b|\bmod(?:ulo)?\b|characteristic|formal(?:ly)?\b"
    r"|\berrors?\b|mistakes?|\bwrong\w*|incorrect\w*|\bfalse\w*|fallac\w+|nonsense|naive\w*"
    r"|\b(?:may|might|could) (?:write|think|guess|try|say|be)|tempt\w*|pretend\w*|heuristic\w*"
    r"|vanish\w*|by symmetry|orthogonal\w*|\bnot true\b|\bbogus\b|students?\b|\bcases?\b"
    r"|\binstead of\b|\bcompare\w*|\bintersect\w*|\bmeets?\b",
    re.IGNORECASE,
)
"""Words that mark a display as approximate, wrong, or true in a special case only."""
_PHRASE = re.compile(
    r"\s*(?:and |but |so |now |then |while )?((?:for|if|when|whenever|where|at|on|in|under|unless"
    r"|near|with|without|inside|outside|along|during|after|before|only|except)\b"
    r"(?!,? (?:all|any|every|each|example|instance|brevity|convenience|simplicity|clarity|this"
    r"|these|that|fact|particular|other words|general|summary|addition|order|short|turn|contrast"
    r"|so|hand|which|the (?:right|left|following|last|first|above|next|other|same|end|meantime"
    r"|sequel))\b)"
    r"[^$,.;:]{3,60})[,:]?\s*(?:we\b|then\b|one\b|\Z)",
    re.IGNORECASE,
)
"""A phrase before a statement that restricts it in a way that is not understood."""
_RETRACTED = re.compile(
    r"\s*(?:this|it|that|which|these|they|but this|however, this|of course,? this)\b[^.$]{0,40}?"
    r"\b(?:wrong|false|not|incorrect|nonsense|impossible|absurd|contradict\w*|fails?|approximat\w*)\b",
    re.IGNORECASE,
)


def loose(before: str, after: str) -> str:
    """Return the words that mark a display as approximate, wrong or a special case; else ``""``.

    Args:
        before: the part of its sentence before it, with ``$`` for formulas.
        after: the text behind it.
    """
    found = _LOOSE.search(before) or _PHRASE.match(before)
    found = found or _RETRACTED.match(after.lstrip(" \n\t.,;"))
    return " ".join(found[0].split())[:60] if found else ""


def binding(before: str, after: str) -> str:
    """Return the words that bind the symbols of a formula between them; ``""`` if none do.

    Args:
        before: the sentence up to the formula, with other formulas replaced by ``$``.
        after: what follows the formula.
    """
    found = [*_BINDING.finditer(before)] or [*filter(None, [_NOUN_BEFORE.search(before[-60:])])]
    if found:
        return " ".join(found[-1][0].split())
    noun = _NOUN_AFTER.match(after[:120])
    if noun:
        return " ".join(noun[0].split())
    later = _HYPOTHETICAL.search(after[:200])
    return later[0] if later else ""


def is_absurd(words: str) -> bool:
    """Whether words that bind a symbol say that something does not hold."""
    return bool(_HYPOTHETICAL.search(words))


def stated_under(before: str) -> str:
    """Return the words before a display that make it an existence statement or a supposition;
    ``""`` if there are none."""
    found = _STATED.search(before)
    return found[0] if found else ""


def is_hypothesis(before: str, after: str) -> bool:
    """Whether a formula between these words is supposed or denied."""
    absurd = _HYPOTHETICAL.search(before) or _HYPOTHETICAL.search(after[:200])
    return bool(absurd or _SUPPOSED.search(before))


def is_conditional(before: str) -> bool:
    """Whether a formula after these words is a condition of something else."""
    return bool(_CONDITIONAL.search(before))


def is_of_display_before(before: str) -> bool:
    """Whether a formula after these words is a condition of the display before their sentence:
    "This is valid only if $s > 0$"."""
    return bool(_NEXT.search(before))
