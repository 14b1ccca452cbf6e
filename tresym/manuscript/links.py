"""What each link of a display says, and of what kind it is: a definition, an equation, a claim.

The manuscript is read once, from first to last. Definitions, conditions and labelled displays are
remembered and used for later links. Without a directive of the author's, a link is called false
only if it must be a claim: if it continues a chain (``… = a = b``) with the same variables on both
sides, or if its sentence says "identity" or "for all". Any other equality that does not hold
everywhere is read as an equation to be solved.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice, pairwise
from typing import TypeAlias

from tresym.manuscript import prose
from tresym.manuscript.accusations import NO_VARIABLES
from tresym.manuscript.classification import (
    ASSUMED,
    DEFINED,
    UNREAD,
    Link,
    TwoReadings,
    claim,
)
from tresym.manuscript.complex_parts import Parts, is_imaginary, parts_of
from tresym.manuscript.components import by_components
from tresym.manuscript.conditions import Conditions
from tresym.manuscript.context import Under
from tresym.manuscript.directives import Orders, orders_of
from tresym.manuscript.display import Said, statements
from tresym.manuscript.display_text import OR, OTHERWISE, between
from tresym.manuscript.files import Note
from tresym.manuscript.link_reading import EITHER, LinkReader
from tresym.manuscript.mentions import names_in
from tresym.manuscript.partials import with_partials
from tresym.manuscript.solutions import Stated, names_of
from tresym.manuscript.source import (
    EXAMPLE,
    STATEMENT,
    Display,
    Event,
    Missing,
    Prose,
    Scope,
    Section,
)
from tresym.manuscript.symbols import mentions
from tresym.manuscript.terms import (
    as_derivatives,
    base_of,
    first_digits,
    is_plain,
    is_rational,
    plain,
    unknown_in,
    variables_of_integrals,
)
from tresym.reals.language.expression import DOTS, ZERO, Expr, symbol, symbols
from tresym.reals.language.formula import NEGATED, Compared, chained
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import RELATIONS
from tresym.reals.language.parsing import parse_given
from tresym.reals.numbers.exact import InputError

Group: TypeAlias = tuple[Said, list[Said]]
"""A chain, and the conditions that follow it."""


def read_links(events: Sequence[Event]) -> list[Link]:
    """Return every link of every display, in order.

    Args:
        events: the manuscript as :func:`tresym.manuscript.source.read_manuscript` returns it.
    """
    return list(_Reading(events).links())


_FUNCTION = re.compile(r"\\(?:a?(?:rc)?(?:sin|cos|tan|cot|sec|csc)h?|exp|ln|log|operatorname|sqrt)")
"""Functions: an inequality that contains one is not a mere condition of the one before it."""
_ASKED = re.compile(
    r"\b(?:evaluate|compute|calculate|simplify|find|determine|expand|factor)[\s:*]*"
    r"(?:the\s+(?:value\s+of|(integral|limit|sum))[\s:*]*(?:of)?[\s:*]*)?\Z",
    re.IGNORECASE,
)
"""Words before a formula whose value a display gives that begins with an equality sign."""
_IMPLICIT = re.compile(
    r"\b(?:consider|implicit(?:ly)?|look\s+at|take|given)\b[^.;$]*\b(?:equation|curve|relation)s?\b",
    re.IGNORECASE,
)
"""Words behind which an equation determines its symbols, whatever they stood for before."""
_ALONE = re.compile(
    r"\W*(?:[\d.]+\W*)?(?:worked\s+)?(?:examples?|exercises?|problems?|questions?|tasks?)\b(?!\s+of\b)",
    re.IGNORECASE,
)
"""Titles of sections whose definitions end with them."""
_PLUS_FIRST = re.compile(r"(?:\s|&|\\[ ,;:>!]|~|\\q?quad|\\begin\{\w+\*?\})*\+(?!\s*\\infty)")
BOUNDS = frozenset(("<", ">", "<=", ">=", "!="))
_COMPONENTS = re.compile(r"\b(?:marginal|densit|component|forces?|fields?)", re.IGNORECASE)
"""Words by which a subscript x names a component or a variable rather than a derivative."""
BETWEEN = 300
"""The most characters between two displays of which the second may continue the first."""
LOOSE = (UNREAD, "it begins with an equality sign; the last term before it is another value")
FIRST = "compared with the first side of the chain, which is equal"


class _Reading(LinkReader):
    """One pass over a manuscript: what was read so far, and where the reader is."""

    def links(self) -> Iterator[Link]:
        """Yield the links of all displays."""
        before, scope = "", 0
        for n, event in enumerate(self.events):
            scope += isinstance(event, Section | Scope)
            self.place = n
            if isinstance(event, Note):
                self.note(event)
            elif isinstance(event, Section):
                example = bool(_ALONE.match(event.title))
                self.memory.section(event.chapter, event.inner, example)
                self.conventions.close(event.chapter, event.inner)
                self.conventions.hear(event.title, event.chapter)
                self.stated.clear()
                self.values.clear()
                self.distributions.close()
                if event.chapter:
                    self.equations.clear()
                    self.memory.begin(self.chapters.pop(0))
                before, self.last_term = "", ()
            elif isinstance(event, Scope):
                self.last_term = ()
                self.memory.scopes.mark(event)
                if event.opens and event.kind in (STATEMENT, EXAMPLE):
                    self.distributions.close()
                before = ""
            elif isinstance(event, Missing):
                continue
            elif isinstance(event, Prose):
                self.memory.own.clear()
                self.memory.remember(event.text)
                for needed in self.distributions.hear(event.text):
                    self.memory.remember(f"Let ${needed}$." if needed else "")
                self.conventions.hear(event.text)
                before = event.text
            else:
                for note in event.notes:
                    self.note(note)
                follows, beyond, *_ = (*self.events[n + 1 : n + 3], None, None)
                after = follows.text if isinstance(follows, Prose) else ""
                if isinstance(beyond, Display) and prose.is_of_next(after):
                    after = ""
                text = before, after, scope
                # what follows from displays that the author names is claimed
                noted = self.orders.kind or (prose.CLAIM if self.orders.sources else "")
                self.memory.line = event.line
                found = [
                    replace(
                        link,
                        around=text,
                        noted=noted,
                        reach=self.memory.scopes.path,
                        moving=frozenset(self.memory.dependent) | self.memory.called,
                    )
                    for link in self.display(event, before, after)
                ]
                following = beyond if isinstance(follows, Prose) else follows
                text_ahead = following.text if isinstance(following, Display) else ""
                at_once = found and not re.search(r"\w", after)
                if at_once and _PLUS_FIRST.match(text_ahead):
                    why = "its sum goes on in the next display"
                    found[-1] = replace(found[-1], status=UNREAD, why=why, claims=())
                self.memory.line = 0
                for label in (*event.labels, str(event.number)):
                    self.memory.labels[label] = [x.sides for x in found if x.sides]
                yield from found
                self.orders, before, self.memory.told = Orders(), "", {}

    def note(self, note: Note) -> None:
        """Apply a directive of the author's."""
        orders = orders_of(note)
        if orders.forget:
            self.memory.noted, self.memory.lasting = [], []
        self.memory.noted += parse_given(orders.given) if orders.given else []
        for names, kind in orders.lets:
            self.kinds.settle(names, kind, note.text, note.line, self.place)
        self.orders = self.orders.with_(orders)

    def display(self, display: Display, before: str, after: str) -> Iterator[Link]:
        """Yield the links of one display.

        Args:
            before: the text before it, back to the previous display or heading.
            after: the text behind it, up to the next display.
        """
        orders = self.orders
        self.words = f"{prose.last_sentence(before)} {prose.first_sentence(after)}"
        self.memory.shorter = orders.shorter
        around = self.memory.conditions_around(before, after)
        kind = orders.kind or around.kind
        around = replace(
            around, kind=kind, noted=bool(orders.kind), path=orders.path or around.path
        )
        if around.path:
            name = around.path.split(" ")[0]
            self.memory.paths.pop(name, None)
            self.memory.paths[name] = around.path
        around = self.memory.following(replace(around, told=prose.is_told(before)), orders)
        blank = Link(display, 1, shown=" ".join(display.text.split()))
        if orders.skip is not None:
            yield replace(blank, status=UNREAD, why=f"skipped by a directive: {orders.skip}")
            return
        if display.problem:
            yield replace(blank, status=UNREAD, why=display.problem)
            return
        self.conventions.hear(prose.first_sentence(after))
        self.conventions.see(display.text)
        if not orders.kind and (why := self.conventions.against(display.text)):
            yield replace(blank, status=UNREAD, why=why)
            return
        self.memory.tends(display.text)
        if _IMPLICIT.search(prose.last_sentence(before)):
            self.memory.implicitly(display.text)
        try:
            text, prose_between = between(self.distributions.in_integrals(display.text, self.words))
            if self.memory.primes:
                text = re.sub(r"(?<![a-zA-Z\\])([a-zA-Z])'", r"\1_{primed}", text)
            for words in prose_between:
                self.memory.remember(words)
            found = statements(text)
        except InputError as error:
            yield replace(blank, status=UNREAD, why=plain(str(error)))
            return
        if not found:
            yield replace(blank, status=UNREAD, why="the display is empty")
            return
        self.memory.remember(prose.first_sentence(after))
        count, self.cases = 0, []
        groups = [
            (one, under)
            for said, under in _with_conditions_behind(_grouped(found))
            for one in by_components(said)
        ]
        plainly = (
            (place, said)
            for place, (said, under) in enumerate(groups)
            if not (said.conditions or under)
        )
        self.memory.ahead = dict(self.defined_in(plainly))
        leads = self.continued(before) if groups and not groups[0][0].terms[0] else ()
        loosely = not leads and bool(groups) and not groups[0][0].terms[0]
        if loosely and len(before) < BETWEEN:
            leads = self.last_term
        if leads:
            said, under = groups[0]
            terms = (
                leads,
                leads,
                *said.terms[1:],
            )  # the first link, of a term to itself, is left out
            groups[0] = replace(said, terms=terms, ops=("=", *said.ops)), under
        goes_on = bool(groups) and self.goes_on(groups[0][0], before)
        self.last_term = groups[-1][0].terms[-1] if groups else ()
        if goes_on and len(groups[-1][0].terms) == 1:
            self.last_term = ()  # a part of a sum
        if goes_on and groups[0][0].ops:
            said, under = groups.pop(0)
            yield replace(blank, status=UNREAD, why="its sum began in the display before it")
            count = 1
            groups.insert(0, (replace(said, terms=said.terms[1:], ops=said.ops[1:]), under))
        last = max((said.row for said, under in groups if said.conditions or under), default=0)
        for self.position, (said, under) in enumerate(groups):
            alone = said.row < last and not (said.conditions or under)
            open_sign = {"\\pm", "\\mp"} & {*said.tokens} and not said.either
            opens = loosely and leads and not count
            for sign in "+-" if open_sign else " ":
                one = said.signed(sign) if sign != " " else said
                two = one.terms[0] != said.terms[0] and self.memory.head(one.terms[0]) is not None
                several = sign != " " and not two  # x_\pm are two symbols
                known = self.kinds.known(one.tokens, self.place)
                start = replace(blank, shown="", symbols=known)
                found_links = self.chain(start, one, under, around, several)
                found_links = islice(found_links, int(bool(leads) and self.position == 0), None)
                for n, link in enumerate(found_links):
                    count += 1
                    firm = link.firm and not alone  # the condition of a later row may be meant
                    if opens and n == 0:
                        link = replace(link, same=False, goes_on=False, otherwise=LOOSE)
                        firm = False
                    if said.worked and link.same and not (said.before or alone):
                        firm = firm or (bool(link.claims) and around.kind != prose.SOLVE)
                    yield replace(link, number=count, firm=firm, multiplied=said.worked)
            for link in self.swallowed(blank, under, around):
                count += 1
                yield replace(link, number=count)

    def goes_on(self, said: Said, before: str) -> bool:
        """Whether a display continues the sum with which the one before it ended: it begins with
        a plus sign, or with a minus sign and numbers, and no words stand between."""
        first = said.terms[0]
        if not self.last_term or re.search(r"\w", before) or first[:1] not in (("+",), ("-",)):
            return False
        return first[0] == "+" or not any(re.fullmatch(r"[a-zA-Z]", one) for one in first)

    def continued(self, before: str) -> tuple[str, ...]:
        """Return the term that a display continues which begins with an equality sign: the last
        one of the display before it, or of the formula that ends the text before it."""
        if not re.search(r"\w", before):
            return self.last_term
        *_, formula = [None, *prose.INLINE.finditer(before)]
        if formula is None or re.search(r"\w", before[formula.end() :]):
            return ()
        asked = _ASKED.search(before, 0, formula.start())
        if asked is None or (asked[1] and f"\\{asked[1][:3]}" not in formula[0]):
            return ()  # of what is to be differentiated the display gives something else
        try:
            *_, said = statements(formula[1] or formula[2] or "")
        except (InputError, ValueError):
            return ()
        if said.ops:
            return ()
        return said.terms[-1]

    def swallowed(self, blank: Link, under: Iterable[Said], around: Under) -> Iterator[Link]:
        """Yield conditions that may be claims: bounds on a symbol that was defined before."""
        for said in under:
            if len(said.ops) != 1 or RELATIONS.get(said.ops[0]) not in BOUNDS or said.before:
                continue
            head = self.memory.head(said.terms[0])
            if not head or head.name not in self.memory.functions:
                continue
            left, right = (self.piece(term, said) for term in said.terms)
            if isinstance(right, str):
                continue
            left = Piece(symbol(head.name)) if isinstance(left, str) else left
            shown = " ".join((*said.terms[0], said.ops[0], *said.terms[1]))
            why = "taken as a condition; if it is a claim, write it in a display of its own"
            compared = left.tree, RELATIONS[said.ops[0]], right.tree
            given, _ = self.under(said, (), around)
            link = replace(blank, shown=shown)
            link = claim(self.memory, link, 0, said, compared, (left, right), given, head, False)
            yield replace(link, firm=False, unknown=True, otherwise=(UNREAD, why))

    def defined_in(self, found: Iterable[tuple[int, Said]]) -> Iterator[tuple[str, Expr]]:
        """Yield what the chains of a display define, since earlier chains of it may use that."""
        for place, said in found:
            if not said.ops or said.ops[0] not in ("=", ":=") or {"\\pm", "\\mp"} & {*said.tokens}:
                continue
            head, value = self.memory.head(said.terms[0]), self.piece(said.terms[1], said)
            if head and not head.derived and not isinstance(value, str):
                names = symbols(value.tree)
                if DOTS.args[0] in names:
                    continue
                if names and head.name not in names and head.name not in self.memory.functions:
                    self.places_ahead[head.name] = place
                    yield head.name, value.tree

    def chain(
        self, blank: Link, said: Said, extra: Sequence[Said], around: Under, signed: bool
    ) -> Iterator[Link]:
        """Yield the links of one chain."""
        if not said.ops:
            shown = " ".join(said.tokens)
            why = "it has no relation such as = or <, so there is nothing to check"
            if said.words:
                why = f"the words {said.words[0]!a} in it are not understood"
            elif not isinstance(self.piece(said.terms[0], said), str):
                return  # an expression alone
            yield replace(blank, status=UNREAD, why=why, shown=shown)
            return
        if said.values == (("\\ldots",),) and {*said.ops} == {"="} and len(said.ops) > 1:
            said = replace(said, values=())  # more of the kind follows
        self.memory.held = frozenset()
        said = replace(said, terms=tuple(map(self.with_partials, said.terms)))
        if (derived := as_derivatives(said.terms)) and {*said.ops} == {"="}:
            said = replace(said, terms=derived)
        if said.values:
            yield self.list_of_values(blank, said)
            return
        under, problem = self.under(said, extra, around)
        self.memory.uses = self.kinds.uses(said.tokens, self.place)
        self.memory.partial = "\\partial" in said.tokens
        by = variables_of_integrals(said.tokens)
        self.memory.by = by.pop() if len(by) == 1 else ""
        pieces = self.pieces(said)
        strange = [self.strange(said, n, blank.display.line) for n in range(len(said.ops))]
        if is_imaginary(said.tokens) and "i" not in self.memory.functions and not any(strange):
            links = list(self.in_parts(blank, said, under))
            if links:
                yield from links
                return
        doubts = [piece for piece in pieces if isinstance(piece, TwoReadings)]
        if doubts == pieces[:1] and self.defines_function(said, pieces):
            doubts = []
        if doubts and self.initial_value(blank, said.terms[0], said.terms[1]):
            self.values.pop()  # it is read again below
            doubts = []
        if doubts and not any(strange) and not self.memory.shorter:
            links = list(self.either_reading(blank, said, under, problem, doubts[0]))
            if links:
                yield from links
                return
        for n, op in enumerate(said.ops):
            shown = _shown_link(said, n)
            if strange[n]:
                yield replace(blank, shown=shown, status=UNREAD, why=strange[n])
                continue
            signs = {*said.terms[n][:1], *said.terms[n + 1][:1]} & {"\\pm", "\\mp"}
            several = signed or (said.either and bool(signs))
            link = replace(blank, shown=shown)
            link = self.link(link, n, op, said, pieces[n : n + 2], under, problem, several)
            if link.claims and n and {*said.ops[:n]} <= {"="} and RELATIONS.get(op, op) in BOUNDS:
                ends = pieces[0], pieces[n + 1]
                first = self.link(link, n, op, said, ends, under, problem, several)
                asked = {a.text for a in link.claims}
                told = tuple(
                    a._replace(how=FIRST, may_fail=False)
                    for a in first.claims
                    if a.text not in asked
                )
                link = replace(link, claims=(*link.claims, *told))
            self.note_equation(link, said, blank.display.line)
            yield link

    def with_partials(self, term: tuple[str, ...]) -> tuple[str, ...]:
        """Return a term with the partial derivatives of known functions that ``f_x`` stands for."""
        if _COMPONENTS.search(self.words):
            return term
        known = self.memory.functions.items()
        several = {name: one.parameters for name, one in known if len(one.parameters) > 1}
        if not several or "_" not in term:
            return term
        read = tuple(with_partials(term, several))
        if read != term:
            held = (names for name, names in several.items() if name in read)
            self.memory.held = self.memory.held.union(*held)
        return read

    def in_parts(self, blank: Link, said: Said, under: Under) -> Iterator[Link]:
        """Yield the links of a chain of complex numbers, two of each: of the real parts, and of
        the imaginary parts."""
        defined = self.memory.head(said.terms[0]) is not None
        taken = not {"\\Re", "\\Im"}.isdisjoint(said.tokens)
        terms = said.terms[defined:]
        parts = [parts_of(term, self.memory.author) for term in terms]
        if {*said.ops} != {"="} or said.conditions or None in parts or len(parts) < 2:
            return
        if defined:
            shown = _shown_link(said, 0)
            why = "a definition by a complex number, which is not used"
            yield replace(blank, shown=shown, status=DEFINED, why=why)
        for n, pair in enumerate(pairwise(part for part in parts if part is not None)):
            if _is_no_unit(*pair):
                return
            for k, name in enumerate(("\\Re", "\\Im")):
                one, other = pair[0][k], pair[1][k]
                if one == other == ZERO:
                    continue
                sides = (" ".join(term) for term in terms[n : n + 2])
                shown = " = ".join(f"{name} ( {side} )" for side in sides)
                link, both = replace(blank, shown=shown), (Piece(one), Piece(other))
                at, compared = n + defined, (one, "==", other)
                link = claim(self.memory, link, at, said, compared, both, under, None, False)
                link = replace(link, ground=replace(link.ground, alike=False))
                firm = taken and link.same and not said.before and under.kind != prose.SOLVE
                yield replace(link, worked=link.worked or taken, firm=link.firm or firm)

    def pieces(self, said: Said) -> list[Piece | str]:
        """Return the terms of a chain as expressions, or the reasons why they cannot be read.

        A decimal with dots, as in ``\\pi = 3.14\\ldots``, gives the first digits of the constant
        that it equals. Of a fraction it would be the value, of a variable a definition, and in a
        bound an end: there it is refused.
        """
        found = [self.piece(term, said) for term in said.terms]
        result = list(found)
        for n, term in enumerate(said.terms):
            beside = [found[k] for k in (n - 1, n + 1) if 0 <= k < len(found)]
            equal = {RELATIONS.get(op) for op in said.ops[max(n - 1, 0) : n + 1]} <= {"==", "~"}
            if (digits := first_digits(term)) and equal and all(map(_is_constant, beside)):
                result[n] = self.piece(digits, said)
        return result

    def defines_function(self, said: Said, pieces: Sequence[Piece | str]) -> bool:
        """Whether a chain begins as ``f(x) = ...`` with x on the right: f is a function there."""
        head = self.memory.head(said.terms[0])
        if head is None or not head.parameters or said.ops[:1] not in (("=",), (":=",)):
            return False
        right = pieces[1]
        if isinstance(right, str) or head.name in symbols(right.tree) | unknown_in(right.tree):
            return False
        return {*head.parameters} <= symbols(right.tree)

    def note_equation(self, link: Link, said: Said, line: int) -> None:
        """Remember an equality that is no definition as an equation for its symbols."""
        if link.sides is None and link.status == UNREAD and " = " in link.shown:
            if self.memory.head(said.terms[0]) is None:
                self.equations |= {base_of(one.name): line for one in mentions(said.tokens)}
            return
        if link.sides is None or link.sides[1] != "==" or link.solves is not None:
            return
        left = str(link.sides[0])
        defines = link.status in (DEFINED, ASSUMED) or link.otherwise[0] == DEFINED
        if defines and base_of(left) == left:  # a derivative is given by an equation
            return
        names = names_of(link.sides[0], link.sides[2])
        self.equations |= dict.fromkeys(names, line)
        at = next((k for k in range(len(said.ops)) if _shown_link(said, k) == link.shown), None)
        if at is not None:
            terms = said.terms[at], said.terms[at + 1]
            number = link.display.number
            self.stated.append(Stated(line, number, link.shown, terms, link.sides, names))

    def list_of_values(self, blank: Link, said: Said) -> Link:
        """Return the link of a list such as ``n = 1, 2, ...``, a condition if it is one."""
        listed = said.ops == ("=",) and said.values[-1] == ("\\ldots",)
        found = self.memory.integers(said) if listed else None
        shown = " ".join(said.tokens)
        if found is None:
            why = "it may be a list of values or a number with commas; neither is read"
            return replace(blank, status=UNREAD, why=why, shown=shown)
        self.memory.lasting += found[0]
        text = chained(found[0])
        return replace(blank, status=ASSUMED, why="a condition", shown=shown, read_as=text)

    def strange(self, said: Said, n: int, line: int) -> str:
        """Return why a link cannot be decided: a symbol in it is not a real number. Else ``""``."""
        left, right = list(said.terms[n]), list(said.terms[n + 1])
        why = self.kinds.against_link(left, said.ops[n], right, self.place, self.words)
        if why and n == 0:
            self.kinds.spread(left, right, self.place, line)
        return why

    def under(self, said: Said, extra: Sequence[Said], around: Under) -> tuple[Under, str]:
        """Return the conditions of a chain, and the condition that was not understood, if any."""
        given: list[Compared] = []
        row: tuple[Compared, ...] = ()
        put_in = list(around.put_in)
        path, problem, own = around.path, "", bool(said.conditions or extra)
        for condition in (*said.conditions, *extra):
            found = (
                self.memory.condition(condition)
                if condition.ops
                else self.other_cases(said, condition)
            )
            if found is None:
                problem = problem or (
                    f"its condition is not understood: {' '.join(condition.tokens)}"
                )
            else:
                given += found[0]
                put_in += found[1]
                path = found[2] or path
            if condition in said.conditions or all(map(is_plain, condition.terms)):
                row = tuple(given)
        if said.conditions:
            self.cases.append((said.terms[0], tuple(given)))
        spoken = [names_in((c,)) for c in (*given, *around.given)]
        lasting = [c for c in self.memory.lasting if names_in((c,)) not in spoken]
        everything = (*self.memory.noted, *lasting, *around.given, *given)
        bounds = own and not {"=", "\\equiv"} & {*said.ops}
        claimed = said.universal or (bounds and around.kind != prose.ASSUME)
        kind = prose.CLAIM if claimed and not around.noted else around.kind
        return replace(
            around,
            passing=around.given,
            row=row,
            given=everything,
            put_in=tuple(put_in),
            path=path,
            kind=kind,
        ), problem

    def other_cases(self, said: Said, condition: Said) -> Conditions | None:
        """Return the meaning of "otherwise": no case before it applies. None for other words."""
        if condition.tokens != (OTHERWISE,):
            return None
        cases = [given for head, given in self.cases if head == said.terms[0]]
        if not cases or any(len(given) != 1 or given[0][1] not in NEGATED for given in cases):
            return None
        return tuple((a, NEGATED[r], b) for ((a, r, b),) in cases), (), ""


def _is_no_unit(one: Parts, other: Parts) -> bool:
    """Whether i may be an index that an equation such as 1 + 2i = 7 determines."""
    imaginary = [part.im for part in (one, other)]
    return ZERO in imaginary and any(im.op == "number" and im != ZERO for im in imaginary)


def _shown_link(said: Said, n: int) -> str:
    """Return the text of a link of a chain."""
    return " ".join((*said.terms[n], said.ops[n], *said.terms[n + 1]))


def _grouped(found: list[Said]) -> Iterator[Group]:
    """Yield each chain with the conditions that follow it: ``a = b, x > 0``, or ``otherwise``.

    If the conditions are alternatives, ``x > 1 or x < 0``, the chain is yielded once for each.
    """
    ways: list[Group] = []
    for said in found:
        waiting, under = ways[-1] if ways else (said, [])
        choice = said.before == OR and (under or waiting.conditions)
        plainly = replace(said, before="") if choice else said
        if not ways or not _is_condition(plainly, waiting, under):
            yield from ways
            ways = [(said, [])]
        elif not choice:
            ways = [(one, [*known, said]) for one, known in ways]
        elif under:
            ways.append((waiting, [*under[:-1], plainly]))
        else:
            last = (*waiting.conditions[:-1], plainly)
            ways.append((replace(waiting, conditions=last), []))
    yield from ways


def _with_conditions_behind(groups: Iterable[Group]) -> list[Group]:
    """Return the groups, each with conditions: a chain without one of its own gets those of the
    next chain in its row, or of the next row that consists of conditions only."""
    groups = list(groups)
    result: list[Group] = []
    rows, row = {said.row for said, _ in groups}, -1
    later: list[Said] = []
    for said, under in reversed(groups):
        if said.row != row:
            later, row = [c for c in later if c.row not in rows], said.row
        later = [*said.conditions, *under] or later
        if result and result[-1][0].before == OR and not said.before:
            said = replace(said, before=EITHER)
        result.append((said, under if said.conditions or under else later))
    return result[::-1]


def _is_condition(said: Said, before: Said, others: Sequence[Said]) -> bool:
    """Whether a chain behind another one has the form of a condition of it."""
    claims = "=" in before.ops or not all(map(is_plain, before.terms))
    if said.before or said.conditions or not said.ops or not claims or (said.opens and said.row):
        return False
    if said.ops == ("\\notin",):
        return True
    relations = {RELATIONS.get(op, "") for op in said.ops}
    if relations == {"->"} and len(said.terms[0]) < 3:
        return True
    if not relations <= {"<", ">", "<=", ">=", "!=", "in"}:
        value = bool(others or before.conditions) and all(map(is_plain, said.terms))
        listed = bool(said.values) and len(said.ops) == 1
        return (listed or value) and relations == {"=="}
    short = any(len(term) <= 4 for term in said.terms)
    if "=" not in before.ops:  # an inequality behind an inequality may be one more
        powers = {pair for term in said.terms for pair in pairwise(term)}
        if ("e", "^") in powers or any(_FUNCTION.fullmatch(t) for x in said.terms for t in x):
            return False
        if not short and not any(map(is_plain, said.terms)):
            return False
    bars = any("|" in term[0] for term in said.terms if term)
    return short or bars or all(map(is_plain, said.terms[::2]))


def _is_constant(side: Piece | str) -> bool:
    """Whether a side is a number that is not written as a fraction."""
    if not isinstance(side, Piece) or symbols(side.tree) - NO_VARIABLES:
        return False
    return not is_rational(side.tree)
