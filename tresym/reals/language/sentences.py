"""Parse claims as people type them, with conditions: ``sqrt(x^2) = x for all x in [0, 1]``.

A claim, its conditions and its path are rewritten in the grammar of
:mod:`tresym.reals.language.parsing`, which then parses them. This module sees only text that the
strict grammar rejects, so that it never changes the meaning of valid text.
"""

from __future__ import annotations

import re
from itertools import pairwise
from typing import NamedTuple

from tresym.reals.language.latex_tokens import GREEK
from tresym.reals.language.parsing import sequences_of
from tresym.reals.language.spelling import skip_arrow, spell_sum
from tresym.reals.language.spelling_tokens import END, Token, tokens
from tresym.reals.language.typed_text import (
    CLOSING,
    FUNCTIONS,
    RESERVED,
    NotSpelledError,
    Typed,
)
from tresym.reals.language.unicode_input import signs
from tresym.reals.numbers.exact import InputError

_RELATIONS = {
    **{sign: sign for sign in ("==", "!=", "<", ">", "<=", ">=", "~", "->")},
    **dict.fromkeys(("=", "===", "is", "equals"), "=="),
    **{"<>": "!=", "=/=": "!=", "=<": "<="},
}
_IF = frozenset(("if", "for", "forall", "given", "when", "whenever", "where", "with", "provided"))
_IF |= {"assuming", "suppose", "such", "let"}
_THEN = frozenset(("=>", "==>", "implies", "then"))
_KINDS = {"positive": "> 0", "negative": "< 0", "nonnegative": ">= 0", "nonzero": "!= 0"}
_INTEGERS = frozenset(("integer", "integers", "ZZ", "Z", "Integers"))
_REALS = frozenset(("real", "reals", "R", "RR", "Reals", "number", "numbers"))
_NATURAL = frozenset(("N", "NN", "natural", "naturals", "Naturals"))
_QUANTIFIERS = frozenset(("all", "every", "any", "each"))
_FILLING = _QUANTIFIERS | {"that", "a", "an", "is", "are", "be"}
_UNKNOWN = frozenset(
    (
        *("some", "exists", "no", "even", "odd", "prime", "greater", "less"),
        *("larger", "smaller", "above", "below", "between", "near", "small", "large"),
        *("rational", "irrational", "complex", "most", "almost", "except", "outside", "other"),
        *("exceeding", "sufficiently", "finite"),
    )
)
"""Words that change what a condition says, and are refused."""
_NAME = re.compile(r"\(*[A-Za-z]\w*\)*")
_UNDERSTOOD = frozenset((*FUNCTIONS, *RESERVED, *GREEK, *_KINDS, *_INTEGERS, *_REALS, *_NATURAL))
_CONDITIONS = re.compile(r"\b(?:given|where|with|if|for|when|and)\b")
_SIMPLE = re.compile(
    r"\\(?:leq?|geq?|neq?|to|infty|in|implies|land|[rR]ightarrow|forall|alpha|beta|"
    r"gamma|delta|epsilon|eta|theta|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|chi|psi|omega)\b"
)


class Spelled(NamedTuple):
    """A claim in the strict grammar; ``given`` and ``path`` are empty if not stated."""

    claim: str
    given: str
    path: str


def spelled(text: str, given: str = "") -> Spelled | None:
    """Return a claim in the strict grammar, or None if the text is not understood.

    Args:
        text: the claim, which may contain conditions.
        given: other conditions, which may say that a name is one of a sequence.

    Raises:
        InputError: the text has two readings, or contains a known mistake.
    """
    return _read(text, True, given)


def spelled_conditions(text: str) -> str | None:
    """Return conditions in the strict grammar, or None, as :func:`spelled` does for claims."""
    found = _read(text, False)
    return None if found is None else found.given


def spelled_expression(text: str) -> str | None:
    """Return an expression in the strict grammar, or None, as :func:`spelled` does for claims.

    Example:
        >>> spelled_expression("2n!"), spelled_expression("x <= 1")
        ('2*factorial(n)', None)
    """
    _, found = tokens(text)
    typed = Typed(found, sequences_of(text))
    try:
        result = spell_sum(typed) if found else None
    except (NotSpelledError, RecursionError):
        return None
    return result if typed.at == len(typed.tokens) else None


def _read(text: str, claimed: bool, given: str = "") -> Spelled | None:
    if "\\" in text and "\\" in _SIMPLE.sub("", text):
        return None
    source, found = tokens(text)
    if not found or sum(token.text == "given" for token in found) > 1:
        return None
    said = _CONDITIONS.sub(",", signs(f"{given}, {text}"))
    sentence = _Sentence(source, found, sequences_of(said))
    try:
        result = sentence.claim() if claimed else sentence.only_conditions()
    except (NotSpelledError, RecursionError):
        return None
    return _with_euler(result)


class _Sentence:
    """Parse a claim with its conditions."""

    def __init__(self, source: str, found: list[Token], sequences: frozenset[str]) -> None:
        self.typed = Typed(found, sequences)
        self.source = source
        self.given: list[str] = []
        self.path = ""

    def claim(self) -> Spelled:
        """Return the claim, its conditions and its path."""
        if self.typed.peek().text in _IF:
            self.typed.next()
            self.conditions()
            self.typed.take(",", ";", ":")
            self.typed.take("then")
            self.typed.take(",")
        first = self.chain()
        if self.typed.peek().text in _THEN and len(first) > 1:
            self.typed.next()
            self.given.append(" ".join(first))
            first = self.chain()
        self.no_other_claim(first)
        self.tails()
        if self.typed.at < len(self.typed.tokens):
            raise NotSpelledError
        if len(first) < 3:
            raise NotSpelledError
        return Spelled(" ".join(first), ", ".join(self.given), self.path)

    def only_conditions(self) -> Spelled:
        """Return conditions without a claim."""
        self.conditions()
        if self.typed.at < len(self.typed.tokens) or not self.given:
            raise NotSpelledError
        return Spelled("", ", ".join(self.given), "")

    def chain(self) -> list[str]:
        """Return expressions with relations between them."""
        found = [spell_sum(self.typed)]
        while self.typed.peek().text in _RELATIONS:
            found.append(_RELATIONS[self.typed.next().text])
            found.append(spell_sum(self.typed))
        if self.typed.peek().text in ("≈", "≅", "≃"):
            raise InputError(
                "the accuracy of ≈ is not stated: write abs(a - b) <= 0.005, or a ~ b with a path"
            )
        return found

    def no_other_claim(self, first: list[str]) -> None:
        """Reject text that contains two claims, with both written out."""
        one = " ".join(first)
        after = self.typed.peek().text
        if after == "=>" and len(first) == 1:
            self.typed.next()
            other = " ".join(self.chain())
            raise InputError(
                f"two readings remain: write {one} >= {other}, or, of a condition and what follows "
                "from it, CLAIM given CONDITION"
            )
        if after in ("<=>", "iff") and len(first) > 1:
            self.typed.next()
            other = " ".join(self.chain())
            raise InputError(
                f"an equivalence is two claims: {other} given {one}, and {one} given {other}"
            )
        if after in ("and", "&&", "or") and len(first) > 1:
            word = self.typed.next().text
            other = " ".join(self.chain())
            if word == "or":
                raise InputError(f"one claim at a time: write {one}, or {other} by itself")
            raise InputError(f"one claim at a time: write {one} and {other} apart")
        if after in ("in", "not"):
            raise InputError(f"{one} in … is a condition: write the claim as a <= {one} <= b")
        if after == "±":
            raise InputError("two signs are two claims: write one for each")

    def tails(self) -> None:
        """Parse conditions and a path after the claim."""
        typed = self.typed
        while typed.at < len(typed.tokens):
            typed.take(",")
            if typed.peek().text == "as":
                typed.next()
                self.path = self.path_ahead()
            elif typed.peek().text in _IF or (
                typed.peek().text == "(" and typed.peek(1).text in _IF
            ):
                closing = typed.take("(")
                typed.next()
                self.conditions()
                if closing:
                    typed.need(")")
            else:
                raise NotSpelledError

    def path_ahead(self) -> str:
        """Parse a path, behind the word "as"."""
        typed = self.typed
        name = typed.name()
        skip_arrow(typed)
        start = typed.peek().at
        while typed.at < len(typed.tokens) and typed.peek().text not in (*_IF, ","):
            typed.next()
        end = typed.peek().at if typed.at < len(typed.tokens) else len(self.source)
        path = f"{name} -> {self.source[start:end].strip()}"
        for word in ("infinity", "Infinity", "inf"):
            path = path.replace(f" {word}", " oo").replace(f"-{word}", "-oo")
        return path

    def conditions(self) -> None:
        """Parse conditions separated by commas or the word "and".

        What is said after the last of a bare list, as in ``x, y > 0``, is said of all of them. A
        quantifier or an adjective begins a group: ``all x and each y > 0`` says nothing of x.
        """
        pending: list[str] = []
        loose = described = False
        while True:
            start = self.typed.at
            kinds, integer, filled = self.adjectives()
            if pending and self.typed.at > start:
                if not loose:
                    raise NotSpelledError
                pending, loose, described = [], False, False
            loose = loose or filled
            described = described or any(
                token.text in _REALS for token in self.typed.tokens[start : self.typed.at]
            )
            self.no_unknown_word()
            pending.append(spell_sum(self.typed))
            more, known = self.predicate(pending)
            if described and len(pending) > 1 and (more or known not in ("", "real", "integer")):
                both, last = ", ".join(pending), " ".join([pending[-1], *more[:1]])
                raise InputError(
                    f"two readings remain: write {both} {more[0] if more else known} for all of "
                    f"them, or {last} alone"
                )
            kinds += more
            if kinds or integer or known:
                for name in pending:
                    self.given += [f"{name} {kind}" for kind in kinds]
                    if integer or known == "integer":
                        self.given.append(f"{name} integer")
                pending, loose = [], False
            if self.typed.at >= len(self.typed.tokens) or self.typed.peek().text not in (
                ",",
                "and",
                "&&",
                ";",
            ):
                break
            if self.ends_conditions():
                break
            self.typed.next()
            self.typed.take("and")
            if self.typed.peek().text in _IF:
                self.typed.next()
        if pending and not loose:
            raise NotSpelledError
        if any(not _NAME.fullmatch(name) for name in pending):
            raise NotSpelledError  # nothing is said of it, as in "for all x + 1"

    def no_unknown_word(self) -> None:
        """Refuse words that say something of a variable, as in ``all even n`` or ``x near 1``.

        Raises:
            InputError: there is such a word, which the grammar would take for a factor.
        """
        depth = 0
        for token, after in pairwise([*self.typed.tokens[self.typed.at :], END]):
            depth += (token.text in CLOSING) - (token.text in CLOSING.values())
            if depth == 0 and token.text in (",", ";", "and", "&&", "as", *_RELATIONS, *_THEN):
                return
            if token.text in _UNKNOWN or (
                token.kind == "name"
                and len(token.text) > 1
                and token.text.isalpha()
                and token.text not in _UNDERSTOOD
                and after.kind in ("name", "number")
                and after.text not in RESERVED
            ):
                raise InputError(
                    f"'{token.text}' is not understood in a condition: write it as a relation, "
                    "such as x > 1, or n integer"
                )

    def ends_conditions(self) -> bool:
        """Return whether the claim follows after a comma, as in ``if x > 0, x^2 > 0``."""
        if self.typed.peek().text not in (",", ";") or self.typed.tokens[0].text not in _IF:
            return False
        if self.typed.peek(1).text == "then":
            return True
        rest = self.typed.tokens[self.typed.at + 1 :]
        depth = 0
        for token in rest:
            depth += (token.text in ("(", "[", "{")) - (token.text in (")", "]", "}"))
            if depth == 0 and token.text in (",", "then"):
                return False
        return not any(token.text in ("then", "=>", *_IF, "in") for token in rest)

    def adjectives(self) -> tuple[list[str], bool, bool]:
        """Parse the words before a variable.

        Returns:
            The relations they state, whether the variable is an integer, and whether there was a
                word.
        """
        kinds, integer, filled = [], False, False
        while True:
            word, after = self.typed.peek().text, self.typed.peek(1)
            if after.kind != "name" and word not in _FILLING:
                break
            if word in self.typed.sequences and after.text == "(":
                break
            if word in _FILLING and (after.kind == "name" or after.text in ("(", "|")):
                filled = True
            elif word in _KINDS:
                kinds.append(_KINDS[word])
            elif word in _REALS and word not in ("R", "RR"):
                filled = True
            elif word in ("integer", "integers"):
                integer = True
            elif word in ("natural", "naturals"):
                raise _natural(after.text)
            elif word == "nonnegative":
                kinds.append(">= 0")
            else:
                break
            self.typed.next()
        return kinds, integer, filled

    def predicate(self, pending: list[str]) -> tuple[list[str], str]:
        """Parse what follows a variable: relations, ``in``, ``positive``, ``integer``."""
        last = pending[-1]
        if self.typed.peek().text in _RELATIONS and self.typed.peek().text != "is":
            texts = []
            while self.typed.peek().text in _RELATIONS:
                texts.append(f"{_RELATIONS[self.typed.next().text]} {spell_sum(self.typed)}")
            if len(pending) > 1 and texts[0].startswith("in"):
                raise NotSpelledError
            return [" ".join(texts)], "relation"
        if self.typed.take("in", "element"):
            return self.set_of(last)
        kinds: list[str] = []
        known = ""
        while True:
            word = self.typed.peek().text
            if word in ("is", "are", "a", "an"):
                self.typed.next()
            elif word in _KINDS:
                kinds.append(_KINDS[self.typed.next().text])
                known = known or "kind"
            elif word in ("integer", "integers"):
                self.typed.next()
                known = "integer"
            elif word in ("real", "reals"):
                self.typed.next()
                known = known or "real"
            elif word in ("natural", "naturals"):
                raise _natural(last)
            else:
                return kinds, known

    def set_of(self, name: str) -> tuple[list[str], str]:
        """Parse the set after ``in``, such as ``[0, 1)`` or ``Z``."""
        token = self.typed.next()
        if token.text in _NATURAL:
            raise _natural(name)
        if token.text in _INTEGERS or token.text in _REALS:
            self.typed.take("numbers")
            if self.typed.peek().text in ("+", "^", "**", "-"):
                raise InputError(f"two readings remain: write {name} > 0 or {name} >= 0")
            return [], "integer" if token.text in _INTEGERS else "real"
        if token.text not in ("[", "(", "]"):
            raise InputError(f"a variable is in an interval: write {name} in [a, b], or a < {name}")
        low = spell_sum(self.typed)
        self.typed.need(",")
        high = spell_sum(self.typed)
        close = self.typed.need("]", ")", "[")
        kinds = []
        if low not in ("(-oo)", "-oo"):
            kinds.append(f"{'>=' if token.text == '[' else '>'} {low}")
        if high != "oo":
            kinds.append(f"{'<=' if close == ']' else '<'} {high}")
        return kinds, "interval"


def _natural(name: str) -> InputError:
    return InputError(
        f"two readings remain: write {name} integer, {name} >= 1 or {name} integer, {name} >= 0"
    )


_TWO_E = (
    "two readings remain of e: write E or exp(x) for Euler's number, "
    "or the variable e by another name"
)
_EULER = re.compile(r"(?<![\w.])e(?!\w)")
_EULER_POWER = re.compile(r"(?<![\w.])e\*\*(\(+-?\w+|-?\w+)")


def _with_euler(found: Spelled) -> Spelled:
    """Replace ``e`` by Euler's number if it is the base of each of its powers and one is variable.

    Raises:
        InputError: this holds for some occurrences of ``e`` only.
    """
    places = len(_EULER.findall(found.claim))
    powers = _EULER_POWER.findall(found.claim)
    varied = any(re.search("[A-Za-z]", power) for power in powers)
    if _EULER.search(found.given) or _EULER.search(found.path):
        if varied and not found.path.startswith("e "):
            raise InputError(_TWO_E)
        return found  # a condition on e, or its path, makes it a variable
    if not places:
        return found
    if not varied or places != len(powers):
        raise InputError(_TWO_E)
    if re.search(r"\bi\b", found.claim):
        raise InputError("complex numbers are not supported: all variables are real")
    return Spelled(_EULER.sub("E", found.claim), _EULER.sub("E", found.given), found.path)
