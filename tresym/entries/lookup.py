"""Find entries of the atlas by name or by words: ``tresym.atlas``.

Words are sought in the name, title, claim, subject and source of an entry, and in what its claim
is: ``large`` or ``x → ∞`` for a limit at infinity, ``bound`` for an inequality, ``expansion`` for a
claim with O. Example: ``erfc large`` finds the expansions of erfc for x → ∞.
"""

from __future__ import annotations

import re
from collections import Counter
from difflib import get_close_matches
from functools import cache
from typing import overload

from tresym.entries.reading import SUBJECTS, Entry, entries
from tresym.reals.numbers.exact import InputError, quoted

_WORD = re.compile(r"[^\s,;?'’]+")
_SPELLED = {"∞": "oo", "infinity": "oo", "→": "->", "−": "-", "^": "**", "≤": "<=", "≥": ">="}
_SAID = (
    ("-> oo", "large infinity infinite"),
    ("-> 0", "small zero"),
    ("O(", "expansion series asymptotic order"),
    ("~", "leading asymptotic equivalent"),
    ("<", "bound inequality below upper"),
    (">", "bound inequality above lower"),
    ("diff(", "ode differential"),
    ("expint(1", "e1"),
    ("binomial(", "coefficient"),
)
"""What is said of a claim in which a sign occurs outside its conditions."""
_IGNORED = frozenset(
    "a,an,the,of,for,at,as,in,on,and,or,is,to,by,which,what,how,hold,holds".split(",")  # noqa: SIM905
)


@overload
def atlas(name: str) -> Entry: ...
@overload
def atlas(*, search: str) -> tuple[Entry, ...]: ...


def atlas(name: str = "", *, search: str = "") -> Entry | tuple[Entry, ...]:
    """Return an entry of the atlas of asymptotics, or the entries that words describe.

    Args:
        name: the identifier of an entry.
        search: words such as ``"erfc large"``.

    Raises:
        InputError: there is no entry of the name.

    Example:
        >>> import tresym
        >>> tresym.atlas("jordan").claim
        'sin(x) >= 2*x/pi given 0 <= x <= pi/2'
        >>> [entry.name for entry in tresym.atlas(search="jordan")]
        ['jordan']
    """
    if search:
        return found(search)
    by_name = {entry.name: entry for entry in entries()}
    if name in by_name:
        return by_name[name]
    near = get_close_matches(name, by_name, 3, 0.6) or [e.name for e in found(name)[:3]]
    meant = f"; did you mean {' or '.join(near)}?" if near else ""
    raise InputError(f"the atlas has no entry {quoted(name)}{meant}")


def found(words: str) -> tuple[Entry, ...]:
    """Return the entries in which all words occur, or else most of them; the best first."""
    asked = [_plain(word) for word in _WORD.findall(words)]
    asked = [word for word in asked if word and word not in _IGNORED]
    if not asked:
        return ()
    scored = [(_score(entry, asked), entry) for entry in entries()]
    most = max((hits for (hits, _), _ in scored), default=0)
    if most < (len(asked) + 1) // 2:
        return ()
    best = [(weight, entry) for (hits, weight), entry in scored if hits == most]
    return tuple(entry for _, entry in sorted(best, key=lambda pair: -pair[0]))


def _plain(word: str) -> str:
    for sign, spelled in _SPELLED.items():
        word = word.replace(sign, spelled)
    word = word.lower()
    word = re.sub(r"\((\w)\)$", "", word)  # erfc(x) is sought as erfc
    return word[:-1] if len(word) > 4 and word.endswith("s") else word


def _score(entry: Entry, asked: list[str]) -> tuple[int, int]:
    """Return how many words occur in an entry, and how prominently they do."""
    name, title = entry.name.lower(), entry.title.lower()
    rest = text_of(entry)
    hits = weight = 0
    for word in asked:
        if word in rest:
            hits += 1
            weight += 4 * (word in name.split("-")) + 2 * (word in title) + (word in name)
    return hits, weight


def text_of(entry: Entry) -> str:
    """Return all the words under which an entry is found."""
    claim, _, _ = entry.claim.partition(" given ")
    if " as " in entry.claim:
        claim += " as " + entry.claim.rpartition(" as ")[2]
    said = [words for sign, words in _SAID if sign in claim.replace("->", " -> ")]
    parts = (entry.name, entry.title, entry.claim, SUBJECTS[entry.subject], entry.source, *said)
    return " ".join(parts).lower().replace("'", "").replace("’", "")


def related(entry: Entry, most: int = 6) -> tuple[Entry, ...]:
    """Return entries about the same function: the rarest one that the claim names and others share.

    Example:
        >>> [other.name for other in related(atlas("jordan"), 2)]
        ['sin-small', 'sin-one']
    """
    used, often = _functions()
    shared = [name for name in used[entry.name] if often[name] > 1]
    if not shared:
        return ()
    about = min(shared, key=lambda name: (often[name], name))
    others = [other for other in entries() if other != entry and about in used[other.name]]

    def distance(other: Entry) -> tuple[bool, int]:
        return other.subject != entry.subject, len(used[other.name] ^ used[entry.name])

    return tuple(sorted(others, key=distance)[:most])


_CALLED = re.compile(r"\b([a-z]\w+)\(")
_COMMON = frozenset({"abs", "sqrt", "min", "max"})


@cache
def _functions() -> tuple[dict[str, frozenset[str]], Counter[str]]:
    """Return the functions that each claim names, and in how many claims each occurs."""
    used = {e.name: frozenset(_CALLED.findall(e.claim)) - _COMMON for e in entries()}
    return used, Counter(name for names in used.values() for name in names)


def bibtex(entry: Entry, version: str) -> str:
    """Return a BibTeX entry with which the statement can be cited."""
    verdict = entry.answer.verdict.value if entry.answer else ""
    return "\n".join(
        [
            f"@misc{{tresym-{entry.name},",
            "  author       = {{The tresym contributors}},",
            f"  title        = {{{{{entry.title}}}}},",
            f"  howpublished = {{tresym {version}, atlas entry \\texttt{{{entry.name}}}}},",
            f"  note         = {{{verdict}; {entry.source}}},",
            "}",
        ]
    )
