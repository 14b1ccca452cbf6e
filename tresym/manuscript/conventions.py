r"""Words by which a formula means something else than it says: "angles are measured in degrees".

After these words ``\sin 30 = 1/2`` is true and ``(\sin x)' = \cos x`` false. Nothing is known of
such a text but that the usual reading is not the author's, so the formulas that it concerns are
left unread, neither proved nor accused. It concerns those that use a notation of the table, behind
the words in the same section, or in the same chapter if the words say so.
"""

from __future__ import annotations

import re
from typing import NamedTuple


class Convention(NamedTuple):
    """A convention of the table.

    Attributes:
        words: a pattern of the words that state it.
        notation: a pattern of the notation in a display that it concerns.
        why: what a reader is told of a formula that is left unread.
    """

    words: re.Pattern[str]
    notation: re.Pattern[str]
    why: str


_LOG = r"\\log(?![a-zA-Z])(?!\s*_)|\\lg(?![a-zA-Z])"
_WAVE = r"\\(?:sin|cos|tan|cot|sec|csc|arc[a-z]+)(?![a-zA-Z])"
_ANY = r"\S"
_RINGS = "the text calculates in a group or ring, whose elements need be no numbers"
_TABLE = (
    (
        r"log\w*[^.;]{0,40}?\b(?:to|with|of|in|has|have)[\s~]+(?:the[\s~]+)?base[\s~]+"
        r"(?!\$?\s*(?:\\?e\b|\\mathrm))|\bbase[\s~-]+(?:\$?(?:2|10)\$?|two|ten)[\s~]+log"
        r"|\b(?:binary|dyadic|common|decimal|decadic|Briggsian)[\s~]+log"
        r"|\blog\w*[^.;]{0,30}?\bbase[\s~-]+(?:\$?(?:2|10)\$?|two|ten)\b"
        r"|\bdecibels?\b|\bin[\s~]+bits\b|\bbits[\s~]+of[\s~]+(?:information|entropy)\b",
        _LOG,
        "the text uses logarithms to another base than e; write the base, as in \\log_2",
    ),
    (
        r"\b(?:measured|given|expressed|are|is|taken|work\w*|angles?|all)[\s~]+in[\s~]+degrees\b"
        r"|\bin[\s~]+(?:units[\s~]+of[\s~]+)?degrees,?[\s~]+(?:not|rather)|\bdegrees?[\s~-]+mode\b",
        _WAVE,
        "the text measures angles in degrees; write \\sin 30^\\circ",
    ),
    (
        r"\btranspositions?\b|\bcycle[\s~]+notation\b|\bpermutations?[\s~]+(?:group\b|(?:\$|\\\())"
        r"|(?:\$|\\\))[^.$]{0,40}\bpermutations?\b|\bsymmetric[\s~]+group\b",
        r"\\(?:pi|sigma|tau|rho|alpha|beta)(?![a-zA-Z])|\(\s*\d[\d\s]*\)\s*\(\s*\d",
        "the text speaks of permutations, whose products are no products of numbers",
    ),
    (
        r"\bconcatenat\w+|\bfree[\s~]+(?:monoid|group|semigroup)s?\b|\bwords?[\s~]+over[\s~]+"
        r"|\b(?:be|are|two|for|of)[\s~]+(?:\w+[\s~]+)?words\b(?=[^.;]{0,40}(?:\$|alphabet))"
        r"|\$[^$]*\$[\s~]+(?:is|are|be)[\s~]+(?:\w+[\s~]+)?words\b"
        r"|\bformal[\s~]+language|\bwords?\b[^.;$]{0,60}\balphabet\b"
        r"|\bgenerators[\s~]+and[\s~]+relations\b"
        r"|\bgroups?\b[^.;]{0,40}\b(?:with|has|have|by)[\s~]+(?:(?:a|the)[\s~]+)?presentations?\b",
        _ANY,
        "the text speaks of words, whose products are no products of numbers",
    ),
    (
        r"\b(?:infinite|transfinite|uncountable|inaccessible)[\s~]+(?:cardinal|ordinal)s?\b"
        r"|\b(?:cardinal|ordinal)[\s~]+(?:arithmetic|numbers?|addition|exponentiation)\b",
        _ANY,
        "the text speaks of infinite cardinals or ordinals, which are no real numbers",
    ),
    (
        r"\b(?:tropical|max-plus|min-plus)\b|\bidempotent[\s~]+semiring",
        _ANY,
        "the text uses tropical arithmetic, whose sum is a maximum or minimum",
    ),
    (
        r"\bbinary[\s~]+(?:notation|arithmetic|addition|numbers|numerals|digits|system)\b"
        r"|\b(?:written|calculat\w+|numbers)[\s~]+in[\s~]+(?:binary|octal|hexadecimal)\b",
        r"(?<![\d.])[01]{2,}(?![\d.])",
        "the text writes numbers in another base than ten",
    ),
    (
        r"\b(?:arithmetic|calculations?|equalit\w+|equations?|congruences?|everything|computations?"
        r"|calculat\w+|comput\w+|all|reduc\w+|addition|work\w*|operations?)\b[^.;]{0,40}?"
        r"\bmod(?:ulo)?\b"
        r"|\b(?:finite[\s~]+field|characteristic[\s~]+(?:\$?[2p]\$?(?![a-zA-Z])|two\b))|\bLegendre[\s~]+symbol",
        _ANY,
        "the text calculates modulo a number or in a finite field",
    ),
    (
        r"\b(?:boolean|commutative|quotient|polynomial|factor|unital)[\s~]+rings?\b|\brings?[\s~]+"
        r"(?:\$\s*(?-i:[A-Z])\s*\$|\$[^$]*\$[\s~]+(?:is|are)\b|with[\s~]+(?:unity|identity|zero)\b)"
        r"|\$[^$]*\$[\s~]+(?:is|are|be)[\s~]+(?:an?[\s~]+)?rings?\b|\bintegral[\s~]+domain"
        r"|\b(?:group|ring)?[\s~]*homomorphisms?\b|\bdivisors?[\s~]+of[\s~]+zero\b"
        r"|\bzero[\s~-]+divisors?\b",
        _ANY,
        _RINGS,
    ),
    (
        r"\\equiv\b[^.;$]{0,80}(?:\\p?mod(?![a-zA-Z])|\bmod\b)",
        r"\\equiv(?![a-zA-Z])",
        "the text compares numbers by their remainders",
    ),
    (
        r"\b(?:summation|Einstein(?:'s)?(?:[\s~]+summation)?)[\s~]+convention\b"
        r"|\brepeated[\s~]+(?:indices|index|subscripts?)\b",
        r"_\s*\{?\s*[a-z]",
        "the text sums over repeated indices by convention",
    ),
    (
        r"(?:\$\s*\\pi\s*\$|\\\(\s*\\pi\s*\\\))[^.;]{0,60}?\b(?:permutation|polic(?:y|ies)|profit"
        r"|distribution|projection|partition|prior|payoff|plane)\b"
        r"|\b(?:permutation|polic(?:y|ies)|profit|distribution|projection|partition|prior|payoff"
        r"|plane)s?[\s~]+(?:is[\s~]+|be[\s~]+|called[\s~]+|by[\s~]+|denoted[\s~]+by[\s~]+)?"
        r"(?:\$\s*\\pi(?![a-zA-Z])|\\\(\s*\\pi(?![a-zA-Z]))",
        r"\\pi(?![a-zA-Z])",
        "the letter \\pi is not the number 3.14... in the text",
    ),
    (
        r"\bgcd\b|\bgreatest[\s~]+common|\bhighest[\s~]+common|\bEuclid(?:ean|'s)?[\s~]+algorithm"
        r"|\bcoprime|\brelatively[\s~]+prime|\binner[\s~]+product|\bequivalence[\s~]+class"
        r"|\b(?:polar|spherical|cylindrical|homogeneous|projective)[\s~]+coordinates",
        r"(?<![a-zA-Z])\([^()]{1,40},[^()]{1,40}\)\s*&?\s*=",
        "pairs in brackets may be divisors, products or points in the text, and no vectors",
    ),
    (
        r"\bcircuits?\b|\bKirchhoff|\bresistors?\b|\bamperes?\b|\binductors?\b|\binterest\b"
        r"|\bannuit(?:y|ies)\b|\binflation[\s~]+rate",
        r"(?<![a-zA-Z\\])i(?![a-zA-Z])",
        "i may be a current or a rate in the text",
    ),
    (
        r"\bGrassmann(?!ian)|\banti-?commut(?:e|es|ing)[\s~]+(?:numbers?|variables?)",
        _ANY,
        "the text calculates with numbers whose products change sign with their order",
    ),
    (
        r"\broots?[\s~]+of[\s~]+unity\b",
        r"\\(?:omega|zeta|xi|epsilon|varepsilon|eta|alpha)(?![a-zA-Z])|\b[wz]\b",
        "the text speaks of roots of unity, which are complex numbers",
    ),
    (
        r"\bangles?[\s~]+of[\s~]+(?:(?:a|an|the|any|every)[\s~]+)?(?:[\w-]+[\s~]+)?triangle",
        _WAVE,
        "the text speaks of the angles of a triangle, whose sum is \\pi; it is not used",
    ),
    (
        r"\bidempotents?\b|\bidentity[\s~]+element\b|\bneutral[\s~]+element\b",
        r"\^\s*\{?\s*2",
        "the text speaks of an algebra in which a square may be the element itself",
    ),
)
CONVENTIONS = tuple(
    Convention(re.compile(words, re.IGNORECASE), re.compile(notation), why)
    for words, notation, why in _TABLE
)
_FINITE = re.compile(
    r"(?:\\math(?:bb|bf|rm)\s*\{?\s*[ZF]\s*\}?|\\(?:ZZ|Z|FF|F|GF|integers)(?![a-zA-Z]))"
    r"\s*(?:_\s*\{?\s*(?:\d|[mnpq](?![a-zA-Z]))|/\s*\(?(?:\d|[mnp](?![a-zA-Z])))"
)
_REMAINDERS = re.compile(r"\\(?:p?mod|pod)(?![a-zA-Z])|\\(?:text|mathrm)\s*\{\s*\(?\s*mod\b")
"""A modulus at the end of a chain, which holds for all of its links; ``\\bmod`` is an operation."""
_THIRD = re.compile(r"\\[dt]?binom\s*\{[^{}]*\}\s*\{[^{}]*\}\s*\{[^{}]*\}(?!\s*[\^_])")
_VARIES = re.compile(
    r"\$([^$]{1,30})\$[\s~,]*(?:(?:itself|also|slowly|now)[\s~]+)?"
    r"(?:varies|vary|varying|changes|depends?|is[\s~]+not[\s~]+constant"
    r"|(?:is|are)[\s~]+(?:an?[\s~]+)?(?:unknown[\s~]+)?functions?[\s~]+of)\b"
    r"(?![^.;$]{0,20}\bnot\b)"
)
_DERIVED = re.compile(r"\\frac\s*\{\s*\\?[a-z]*\s*d|\\partial|\\dot|\\ddot|'|\\int|\\dv|\\frac\s*d")
_LASTING = re.compile(
    r"\b(?:throughout|(?:this|the)[\s~]+(?:whole[\s~]+)?(?:chapter|book|paper|article|text|notes?"
    r"|thesis|report)|always|from[\s~]+now[\s~]+on|everywhere)\b",
    re.IGNORECASE,
)
_DENIED = re.compile(
    r"\b(?:not|never|no|instead[\s~]+of|unlike|rather[\s~]+than)\b[^.;,$]{0,25}\Z", re.IGNORECASE
)


class StatedConventions:
    """The conventions that the text has stated so far, for its section and for its chapter."""

    def __init__(self) -> None:
        """Begin without conventions."""
        self.section: list[tuple[re.Pattern[str], str]] = []
        self.chapter: list[tuple[re.Pattern[str], str]] = []
        self._whole: list[tuple[re.Pattern[str], str]] | None = None

    def close(self, chapter: bool, inner: bool = False) -> None:
        """End a section, or a chapter, or a subsection, which leaves those of its section."""
        if inner and self._whole is None:
            self._whole = [*self.section]
        elif not inner:
            self._whole = None
        self.section = [*(self._whole or ())]
        if chapter:
            self.chapter.clear()

    def hear(self, text: str, lasting: bool = False) -> None:
        """Note the conventions that a text states, or the title of a chapter, for all of it."""
        before = len(self.section)
        self.see(text)
        self._hear(text)
        if lasting:
            self.chapter += self.section[before:]
            del self.section[before:]

    def _hear(self, text: str) -> None:
        for one in CONVENTIONS:
            for found in one.words.finditer(text):
                if not _DENIED.search(text, max(found.start() - 60, 0), found.start()):
                    self._note(text, found.start(), one.notation, one.why)
                    break
        for found in _VARIES.finditer(text):
            name = found[1].strip()
            if re.fullmatch(r"\\?[a-zA-Z]+(?:_\w)?", name):
                why = f"the text says that {name} varies; write it with its argument"
                apart = "" if name[0] == "\\" else r"(?<![a-zA-Z\\])"
                alone = rf"{apart}{re.escape(name)}(?![a-zA-Z])(?!\s*\()"
                used = rf"(?s)(?=.*(?:{_DERIVED.pattern})).*{alone}"
                self._note(text, found.start(), re.compile(used), why)

    def _note(self, text: str, at: int, notation: re.Pattern[str], why: str) -> None:
        start = text.rfind(".", 0, at) + 1
        stop = text.find(".", at)
        sentence = text[start : stop if stop >= 0 else len(text)]
        lasting = why == _RINGS or _LASTING.search(sentence)
        (self.chapter if lasting else self.section).append((notation, why))

    def see(self, formula: str) -> None:
        """Note that a formula names a set of remainders, as in ``x \\in \\mathbb{Z}_5``."""
        if _FINITE.search(formula):
            self.section.append((re.compile(_ANY), "the text calculates with remainders"))

    def against(self, display: str) -> str:
        """Return why a display is left unread because of a convention; empty if it is not."""
        if _THIRD.search(display):
            return "\\binom takes two arguments; here it has three, and may be the author's own"
        if _REMAINDERS.search(display):
            return "the display compares numbers by their remainders"
        stated = reversed((*self.chapter, *self.section))
        return next((why for notation, why in stated if notation.search(display)), "")
