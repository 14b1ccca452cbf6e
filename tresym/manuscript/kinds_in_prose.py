"""What the words of a manuscript say a symbol is: "Let $A$ be a matrix", "the operator $L$"."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tresym.manuscript.prose import INLINE

REAL, INTEGER, COMPLEX = "a real number", "an integer", "a complex number"
FUNCTION, SEQUENCE, VECTOR, MATRIX = "a function", "a sequence", "a vector", "a matrix"
OPERATOR, SET, RANDOM, UNKNOWN = "an operator", "a set", "a random variable", "of unknown kind"
BY_NAME = {
    **{"real": REAL, "integer": INTEGER, "complex": COMPLEX, "function": FUNCTION},
    **{"sequence": SEQUENCE, "vector": VECTOR, "matrix": MATRIX, "operator": OPERATOR},
    **{"set": SET, "random": RANDOM, "unknown": UNKNOWN},
}
"""The kinds by the words of a directive."""

_SPACES = r"(?:(?:vector|linear|Banach|Hilbert|metric|topological|normed|measure|probability) )?"
_ALGEBRAIC = "".join(
    rf"(?<!{word}[\s~])"
    for word in ("uniform", "scalar", "force", "gravitational", "external", "constant", "inner")
)
"""What a field is not called that is a set of numbers."""
_ALGEBRAS = r"(?:sub|(?:Lie|Banach|Boolean|Clifford|exterior|tensor|operator|sigma|C\*)[\s~-]+)"
_KIND_OF_SET = (
    r"(?:the|a|an|any|every|each|some|this|finite|open|closed|compact|empty|countable|bounded"
    r"|convex|connected|infinite|null|solution|point|index|level) "
)
_NOUNS = (
    (RANDOM, r"random (?:variables?|vectors?|walks?|process\w*|matri\w+|quantit\w+|samples?)"),
    (RANDOM, r"(?:(?:standard )?normal|exponential|Gaussian|Poisson|Bernoulli) variables?"),
    (RANDOM, r"estimators?|martingales?|stochastic process\w*|r\.v\.s?|Brownian motions?"),
    (
        COMPLEX,
        r"complex(?:-valued)? (?:numbers?|variables?|constants?|parameters?|roots?|scalars?)",
    ),
    (MATRIX, r"matri(?:x|ces)|tensors?|quaternions?|spinors?|bivectors?|multivectors?|octonions?"),
    (OPERATOR, r"operators?|projections?|projectors?|functionals?"),
    (
        OPERATOR,
        r"(?:linear|Lorentz|Galilean|gauge|unitary|orthogonal|similarity|affine|symmetry|coordinate"
        r"|canonical|Legendre|Fourier|Laplace|invertible) transformations?",
    ),
    (OPERATOR, r"derivations?|linear maps?|(?:Laplace|Fourier|integral) transform operators?"),
    (OPERATOR, r"(?:homo|endo|auto|iso)morphisms?|observables?|permutations?|commutators?"),
    (VECTOR, r"(?:eigen|co|bi)?vectors?|vector fields?|(?:electric|magnetic|velocity) fields?"),
    (VECTOR, r"(?:differential |1-|2-|k-|one-|two-|bilinear |multilinear )forms?"),
    (SEQUENCE, r"(?:sub)?sequences?"),
    (
        UNKNOWN,
        r"propositions?|predicates?|(?:Boolean|logical) variables?|strings?|knots?|functors?",
    ),
    (
        UNKNOWN,
        r"sheaf|sheaves|bundles?|connections?|curvature forms?|morphisms?|vertices|simplices",
    ),
    (SET, rf"(?:sub|super)sets?|sets|{_KIND_OF_SET}set|(?:sub)?groups?|(?:sub)?rings?|modules?"),
    (SET, rf"(?:sub)?{_SPACES}spaces?|ideals?|(?:sub)?{_ALGEBRAIC}fields?"),
    (SET, rf"{_ALGEBRAS}algebras?|manifolds?"),
    (
        SET,
        r"events?|categor(?:y|ies)|domains?|collections?|famil(?:y|ies)",
    ),
    (FUNCTION, r"(?:eigen)?functions?|polynomials?|maps?|mappings?|distributions?"),
    (INTEGER, r"integers?|natural numbers?|primes?|prime numbers?|indices|index|whole numbers?"),
    (
        REAL,
        r"(?:real )?(?:numbers?|variables?|constants?|parameters?|scalars?|coefficients?)|reals?",
    ),
    (REAL, r"angles?|lengths?|radius|mass|scalars|factors?"),
)
_ANY = "|".join(f"(?P<n{k}>{pattern})" for k, (_, pattern) in enumerate(_NOUNS))
_F = r"\x02\d+\x03"
_LIST = rf"(?P<list>{_F}(?:(?:\s*,\s*(?:and\s+|or\s+)?|\s+(?:and|or)\s+){_F})*)"
_STOP = (
    r"(?!(?:of|in|on|for|to|with|by|at|from|that|which|if|when|where|whose|such|not|no|less|greater"
    r"|between|under|over|as|into|than|via|through|per|along|across|around|near|about|against|after"
    r"|before|during|within|inside|outside|onto|among|beyond|upon)\b)"
)
_WORDS = rf"(?:{_STOP}[\w\x02\x03'-]+[\s~]+){{0,6}}?"
_OTHER_NOUN = (
    r"(?![\s~-]+(?:norms?|lengths?|elements?|entr\w+|components?|coefficients?|values?|size|velocity"
    r"|strength|order|dimensions?|rank|density|constants?|magnitude|eigenvalues?|parameters?|angles?"
    r"|product|spectrum|radius|of degree|whose|functions?)\b|['’]s\b|\w)"
)
_ADJECTIVE_BEFORE = (
    r"(?:(?!(?:the|an?|for|of|in|on|to|and|or|let|by|with|that|this|is|are|be)\b)[a-z-]+[\s~]+)??"
)
_BEFORE = re.compile(
    rf"\b{_ADJECTIVE_BEFORE}(?:{_ANY}){_OTHER_NOUN}[\s~]*"
    r"(?:,?[\s~]*(?:say|called|named|denoted(?: by)?|given by)[\s~]+)?"
    rf"{_LIST}",
    re.IGNORECASE,
)
_AFTER = re.compile(
    rf"{_LIST}[\s~]*(?:,?[\s~]*(?:is|are|be|being|denotes?|represents?|stands? for|was|were)\b"
    rf"|,?[\s~]*(?=\(?(?:an?|two|any)\b)|(?=\(?the\b)|\()[\s~]*{_WORDS}(?:[\w-]+,[\s~]+an?[\s~]+{_WORDS})?(?:{_ANY})"
    rf"{_OTHER_NOUN}(?![\s~]+\x02)",
    re.IGNORECASE,
)
_DOMAIN_OF = re.compile(
    r"\b(?:domain|range|image|graph|codomain|support)[\s~]+of[\s~]+(?:the function[\s~]+)?\Z",
    re.IGNORECASE,
)
"""Before a name of which not itself is a set."""
_NAMING = re.compile(
    rf"\b(?:denote by|denoted by|write|call|writing|by)[\s~]+{_LIST}[\s~]+"
    rf"(?:for[\s~]+|we denote[\s~]+|denote[\s~]+|the[\s~]+)+{_WORDS}(?:{_ANY}){_OTHER_NOUN}",
    re.IGNORECASE,
)
_ADJECTIVE = re.compile(
    rf"\b(?P<word>complex|real|random|integer|rational)[\s~]+{_LIST}", re.IGNORECASE
)
_ADJECTIVES = {
    "complex": COMPLEX,
    "real": REAL,
    "random": RANDOM,
    "integer": INTEGER,
    "rational": REAL,
}
_BEFORE_ADJECTIVE = re.compile(
    r"(?:\A|[.,;:(]|\b(?:for|all|any|every|each|let|both|some|given|of|in|fixed|arbitrary|be|is|are"
    r"|and|or|where|with|to|real|nonzero|non-zero|possibly|take|consider))[\s~]*\Z",
    re.IGNORECASE,
)
_IS_COMPLEX = re.compile(
    rf"{_LIST}[\s~]*(?:(?:is|are|be|being)[\s~]+(?:\w+[\s~]+)?complex\b|in the complex plane\b)"
)
_COMPLEX_NOUN = re.compile(
    rf"\bcomplex[\s~-]+(?:valued[\s~]+)?(?!plane|analysis|field)[a-z]+[\s~]+{_LIST}", re.IGNORECASE
)
_HOLOMORPHIC = re.compile(
    r"\b(?:holomorphic|analytic|meromorphic|entire)\b[^.⟦]{0,30}?\b(?:in|of)[\s~]+" + _LIST
)
_PLURAL = (
    (MATRIX, r"matrices|tensors|quaternions|spinors"),
    (OPERATOR, r"operators|projections|transformations|maps between|commutators?|do not commute"),
    (RANDOM, r"random variables|estimators"),
    (VECTOR, r"vectors"),
    (COMPLEX, r"complex numbers|complex variables|complex conjugates?"),
    (SET, r"sets|subsets|in the group|in a group|group law|subgroups|modules|cardinality|rings"),
)
OF_BARS = re.compile(
    r"\b(?:determinants?|cardinalit\w+|number of elements|norms?)\b", re.IGNORECASE
)
"""Words by which a bar is no absolute value."""
INVERSES = re.compile(
    r"\binverse (?:trig\w*|circular|hyperbolic|sine|cosine|tangent|cotangent|secant)"
    r"|\b(?:arc|inverse )(?:sine|cosine|tangent)s?\b|\\arc(?:sin|cos|tan)(?![a-zA-Z])",
    re.IGNORECASE,
)
"""Words by which ``\\sin^{-1}`` is the inverse function."""
_OF_SENTENCE = re.compile(
    "|".join(rf"(?P<p{k}>\b(?:{p})\b)" for k, (_, p) in enumerate(_PLURAL)), re.IGNORECASE
)
_SINGULAR = re.compile(r"\b(?:(operator)|(matrix|tensor)|(random variable))\b", re.IGNORECASE)
SPEAKERS = (
    (re.compile(r"\b(?:expectations?|expected values?|mean of|moments?)\b", re.IGNORECASE), "E"),
    (re.compile(r"\bprobabilit\w+", re.IGNORECASE), "P"),
    (re.compile(r"\bvariances?\b", re.IGNORECASE), "V"),
    (re.compile(r"\b(?:Laplace|integral) transforms?\b", re.IGNORECASE), "L"),
    (re.compile(r"\bFourier transforms?\b", re.IGNORECASE), "F"),
    (re.compile(r"\b(?:differential|derivative|difference) operators?\b", re.IGNORECASE), "D"),
    (re.compile(r"\b(?:difference operator|Laplacian)\b", re.IGNORECASE), "Delta"),
)
"""Names of operators, with their usual letters."""


_LETTERS = r"[A-Z](?:_\d)?(?:\s*,\s*[A-Z](?:_\d)?)*(?![a-zA-Z^])"
_CAPITALS = rf"(?:\$\s*{_LETTERS}[^$]{{0,60}}\$(?:[\s~]*(?:,|and|or)[\s~]*)*)+"
_INTERVALS_AFTER = re.compile(rf"\bintervals?[\s~]+{_CAPITALS}")
_INTERVALS_BEFORE = re.compile(
    rf"{_CAPITALS}[\s~]*(?:is|are|be)[\s~]+(?:an?[\s~]+)?"
    r"(?:(?:open|closed|bounded|compact|nonempty|real|two|nontrivial|finite|any)[\s~]+)*intervals?\b"
)


_LOOSE = re.compile(
    r"(?:sub)?(?:spaces?|ideals?|fields?|domains?|events?|collections?|famil(?:y|ies)|rings?"
    r"|modules?|groups?|categor(?:y|ies))",
    re.IGNORECASE,
)
"""Nouns for sets that mean something else in most texts."""


class Declared(NamedTuple):
    """The kind that words give to the symbols of inline formulas.

    Attributes:
        kind: their kind.
        words: the words, with the formulas.
        formulas: the formulas.
        at: where the words begin in the text.
        loosely: whether the words have other meanings, as "space", "field" and "complex" have.
    """

    kind: str
    words: str
    formulas: tuple[str, ...]
    at: int
    loosely: bool = False


def declared(text: str) -> Iterator[Declared]:
    """Yield the kinds that the words of a text give to its symbols."""
    formulas: list[str] = []
    places: list[tuple[int, int]] = []

    def mark(found: re.Match[str]) -> str:
        formulas.append(found[1] or found[2])
        places.append((found.start(), found.end()))
        return f"\x02{len(formulas) - 1}\x03"

    marked = INLINE.sub(mark, text)
    if not formulas:
        return

    def made(kind: str, found: re.Match[str], noun: str = "", first: bool = True) -> Declared:
        own = tuple(formulas[int(n)] for n in re.findall(r"\x02(\d+)\x03", found["list"]))
        if noun and not noun.lower().endswith(("s", "ces", "indices")):
            own = own[:1] if first else own[-1:]
        words = re.sub(r"\x02(\d+)\x03", lambda m: f"${formulas[int(m[1])]}$", found[0])
        place = re.search(r"\x02(\d+)\x03", found[0])
        at = places[int(place[1])][0] if place else 0
        return Declared(kind, " ".join(words.split()), own, at, bool(_LOOSE.fullmatch(noun)))

    for pattern in (_BEFORE, _AFTER, _NAMING):
        for found in pattern.finditer(marked):
            if pattern is _AFTER and _DOMAIN_OF.search(
                marked, max(found.start() - 40, 0), found.start()
            ):
                continue
            named = next(k for k in range(len(_NOUNS)) if found[f"n{k}"] is not None)
            yield made(_NOUNS[named][0], found, found[f"n{named}"], pattern is not _AFTER)
    for found in _ADJECTIVE.finditer(marked):
        if found["word"].lower() == "complex" and not _is_adjective(marked, found, formulas):
            continue
        kind = _ADJECTIVES[found["word"].lower()]
        yield made(kind, found)._replace(loosely=kind == COMPLEX)
    for pattern in (_IS_COMPLEX, _HOLOMORPHIC, _COMPLEX_NOUN):
        for found in pattern.finditer(marked):
            yield made(COMPLEX, found)


def _is_adjective(marked: str, found: re.Match[str], formulas: list[str]) -> bool:
    """Whether "complex" before a symbol says what it is: not in "the complex $t$ plane", and not
    "an intermediate complex $C$" of molecules."""
    if re.match(r"[\s~-]*(?:plane|half|domain)", marked[found.end() :]):
        return False
    letter = formulas[int(re.findall(r"\x02(\d+)\x03", found["list"])[0])].strip()[:1]
    return letter in ("z", "w") or bool(_BEFORE_ADJECTIVE.search(marked, 0, found.start()))


def intervals_in(text: str) -> set[str]:
    """The capital letters that the words of a text call intervals of real numbers."""
    found = (m[0] for words in (_INTERVALS_AFTER, _INTERVALS_BEFORE) for m in words.finditer(text))
    lists = (m[1] for words in found for m in re.finditer(rf"\$\s*({_LETTERS})", words))
    return {letter for letters in lists for letter in re.findall("[A-Z]", letters)}


def of_sentence(sentence: str) -> Iterator[tuple[str, str, bool]]:
    """Yield kinds that a sentence mentions without naming symbols: "the matrices satisfy".

    Each comes with its word, and with whether that is in the plural.
    """
    words = INLINE.sub(" ", sentence)
    for found in _OF_SENTENCE.finditer(words):
        kind = next(k for k in range(len(_PLURAL)) if found[f"p{k}"] is not None)
        yield _PLURAL[kind][0], found[0], True
    kinds = {d.kind for d in declared(sentence)}
    for found in _SINGULAR.finditer(words):
        one = OPERATOR if found[1] else MATRIX if found[2] else RANDOM
        if one not in kinds:
            yield one, found[0], False
