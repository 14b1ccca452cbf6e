"""What each link of a display says, and of what kind it is: a definition, an equation, a claim.

What was said before is remembered: definitions, conditions, and displays by their labels. Without
a note of the author's a link is called false only where nothing else can be meant: a chain that
goes on (``… = a = b``), with the same variables on both sides, or a sentence that says "identity"
or "for all". Any other equality that does not hold everywhere is an equation to be solved.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple, TypeAlias

from flint import fmpq

from tresym.manuscript import prose
from tresym.manuscript.notes import Orders, orders_of
from tresym.manuscript.rows import STRANGE, WORDS, Said, statements
from tresym.manuscript.surface import Display, Event, Missing, Note, Prose, Section
from tresym.reals.decisions.reading import chained, functions
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    UNWORKED,
    Expr,
    bind,
    instantiate,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_cursor import Author, Function
from tresym.reals.language.latex_grammar import Reader
from tresym.reals.language.latex_reach import Piece
from tresym.reals.language.latex_tokens import RELATIONS
from tresym.reals.language.parsing import INFINITY, INTEGERS, Compared, parse_given
from tresym.reals.numbers.exact import InputError, parse_number

DEFINED, ASSUMED, EQUATION, UNREAD = "DEFINED", "ASSUMED", "EQUATION", "UNREAD"
_DERIVED = re.compile(r"(?:d|partial)\d?([A-Za-z]\w*?)_(?:d|partial)[A-Za-z]\w*|(\w+?)_prime\d?")
_CONSTANTS = re.compile(r"[CcAB]_?\d*|[CcA]_\w")
_LETTER_E = re.compile(
    r"(?<![a-zA-Z\\{_^])e\s*\\(?:sin|cos)|1\s*[-+]\s*e(?![a-zA-Z^])"
    r"|1\s*-\s*e\s*\^\s*(?:\{\s*2\s*\}|2(?!\d))|(?<![a-zA-Z\\^_{])e\s*(?:<|\\ll|\\to)"
    r"|<\s*e(?![a-zA-Z^])|(?:^|[^\\a-z\s]|[$\n])\s*e\s*&?=(?!\s*2\.7)"
)
"""Where e stands as no number does: e sin E, 1 - e, 1 - e^2, e < 1, e = c/a."""
_CALLED = re.compile(
    r"(?<![a-zA-Z\\_^{])([a-zA-Z]|\\[a-zA-Z]+)\s*\(\s*(?:[a-z]|\\[a-z]+)"
    r"(?:\s*,\s*(?:[a-z]|\\[a-z]+))*\s*\)\s*&?\s*:?="
)
"""The head of a function's definition."""
_L = r"([a-zA-Z]|\\[a-zA-Z]+)"
_D = r"\s*(?:d|\\mathrm\s*\{?d\}?|\\partial)(?:\s*\^\s*\{?\d\}?)?\s*"
_DERIVATIVES = (
    (rf"\\d?dot\s*\{{?\s*{_L}", "t"),
    (r"(?<![a-zA-Z\\])([a-zA-Z])(?:_\w)?'", ""),
    (rf"\\[dt]?frac\s*\{{{_D}{_L}\s*\}}\s*\{{{_D}{_L}", ""),
)
"""How derivatives of symbols are written."""
_UNITS = frozenset(("\\mathrm", "\\text", "\\textrm", "\\rm", "\\unit"))
_WORKED = frozenset(("antiderivative", "derivative", "limit"))
"""What is written to be worked out: an equality with one of these is no equation to be solved."""
_DEPTH = 10


Conditions: TypeAlias = tuple[tuple[Compared, ...], tuple[tuple[str, Expr], ...], str]
"""What conditions state: comparisons, values that are put in, and a path."""


class Attempt(NamedTuple):
    """What is asked, what was put in for it, and what is thereby said."""

    text: str
    how: str
    read_as: str


@dataclass(frozen=True)
class Link:
    """One link of a chain, and what is to be decided of it.

    Attributes:
        number: its place in the display, from 1.
        sides: both sides and the relation, where they are read.
        read_as: what was read, with its conditions.
        status: where nothing is left to decide.
        claims: what is asked, in the order of trying: as it stands, then with definitions put in.
        firm: whether a refutation counts; else the link is then ``otherwise``.
        same: whether the same variables stand on both sides.
        unknown: whether there is a function in it that is left unknown.
    """

    display: Display
    number: int
    sides: Compared | None = None
    read_as: str = ""
    status: str = ""
    why: str = ""
    claims: tuple[Attempt, ...] = ()
    firm: bool = False
    otherwise: tuple[str, str] = ("UNDECIDED", "")
    same: bool = False
    unknown: bool = False
    shown: str = field(default="", repr=False)


@dataclass(frozen=True)
class Under:
    """What a display is said under."""

    given: tuple[Compared, ...] = ()
    put_in: tuple[tuple[str, Expr], ...] = ()
    path: str = ""
    kind: str = ""
    noted: bool = False
    sources: tuple[tuple[str, Expr], ...] = ()


def read_links(events: Sequence[Event]) -> list[Link]:
    """Every link of every display, in order."""
    return list(_Reading(events).links())


class _Reading:
    """One pass over a manuscript, and what it has said so far."""

    def __init__(self, events: Sequence[Event]) -> None:
        self.events = events
        text = "\n".join(e.text for e in events if isinstance(e, Display | Prose))
        self.letter_e = bool(_LETTER_E.search(text))
        self.functions: dict[str, Function] = {}
        self.noted: list[Compared] = []
        self.lasting: list[Compared] = []
        self.earlier: list[Compared] = []
        self.labels: dict[str, list[Compared]] = {}
        self.orders = Orders()
        self.shorter = False
        self.ahead: dict[str, Expr] = {}
        self.dependent = _dependent(text)
        self.called = frozenset(m[1].lstrip("\\") for m in _CALLED.finditer(text))
        self.seen: set[str] = set()
        self.cases: list[tuple[tuple[str, ...], tuple[Compared, ...]]] = []

    @property
    def author(self) -> Author:
        return Author(
            self.functions,
            strict=True,
            shorter=self.shorter,
            letter_e=self.letter_e,
            called=self.called,
        )

    def links(self) -> Iterator[Link]:
        """The links of all displays."""
        before = ""
        for n, event in enumerate(self.events):
            if isinstance(event, Note):
                self.note(event)
            elif isinstance(event, Section):
                self.earlier += self.lasting
                self.noted, self.lasting, before = [], [], ""
            elif isinstance(event, Missing):
                continue
            elif isinstance(event, Prose):
                self.remember(event.text)
                before = event.text
            else:
                for note in event.notes:
                    self.note(note)
                follows = self.events[n + 1] if n + 1 < len(self.events) else None
                after = follows.text if isinstance(follows, Prose) else ""
                found = list(self.display(event, before, after))
                for label in (*event.labels, str(event.number)):
                    self.labels[label] = [x.sides for x in found if x.sides]
                yield from found
                self.orders, before = Orders(), ""

    def note(self, note: Note) -> None:
        """Heed a note of the author's."""
        orders = orders_of(note)
        if orders.forget:
            self.noted, self.lasting = [], []
        self.noted += parse_given(orders.given) if orders.given else []
        self.orders = self.orders.with_(orders)

    # prose

    def remember(self, text: str) -> None:
        """Definitions and lasting conditions in the lines of a text."""
        for found in prose.inline(text):
            for said in _quietly(found.tex):
                if len(said.ops) == 1 and said.ops[0] in ("=", ":="):
                    self.defined_in_line(said, found.defining)
                elif found.lasting:
                    given, _, _ = self.condition(said) or ((), (), "")
                    self.lasting += given

    def defined_in_line(self, said: Said, surely: bool) -> None:
        """A definition in the line, by the words before it or as one of a function, f(x) = …."""
        head = self.head(said.terms[0])
        if head is None or not (surely or head.parameters):
            return
        try:
            value = self.term(said.terms[1]).tree
        except InputError:
            return
        if not head.derived and value.op != "number" and head.name not in symbols(value):
            self.define(head, value)

    def conditions_around(self, before: str, after: str) -> Under:
        """What the sentence around a display says of its conditions."""
        given: list[Compared] = []
        put_in: list[tuple[str, Expr]] = []
        path = ""
        for text in (prose.last_sentence(before), prose.first_sentence(after)):
            for found in prose.inline(text):
                if not found.passing:
                    continue
                for said in _quietly(found.tex):
                    more = self.condition(said)
                    if more and not more[1]:
                        given += more[0]
                        path = more[2] or path
        return Under(tuple(given), tuple(put_in), path, prose.kind_of(before))

    # conditions

    def condition(self, said: Said) -> Conditions | None:
        """The comparisons, the values put in and the path that a condition states, if it is one."""
        if not said.ops or any(op in STRANGE for op in said.ops):
            return None
        if said.values and said.ops == ("=",):
            return self.integers(said)
        if said.ops == ("\\in",) and said.terms[1][:1] == ("\\mathbb",):
            return self.member(said)
        try:
            (chain,) = read_latex(" ".join(said.tokens), self.author)
        except (InputError, ValueError):
            return None
        if chain.ops[0].startswith("->"):
            point = {INFINITY: "oo", -INFINITY: "-oo"}.get(chain.terms[1], chain.terms[1])
            return (), (), f"{chain.terms[0]} -> {point}{chain.ops[0][2:]}"
        links = [
            link
            for link in chain.links
            if not {link[0], link[2]} & {INFINITY, -INFINITY} or link[1] not in ("<", "<=")
        ]
        if any(op == "==" for _, op, _ in links):
            left, _, right = links[0]
            if len(links) > 1 or said.values or not elementary(left, right):
                return None
            if left.op != "symbol":
                return tuple(links), (), ""
            return (), ((left.args[0], right),), ""
        if any(op not in NEGATED for _, op, _ in links) or not elementary(
            *(side for left, _, right in links for side in (left, right))
        ):
            return None
        return tuple(links), (), ""

    def integers(self, said: Said) -> Conditions | None:
        """``n = 0, 1, 2, \\ldots``: every integer from the first on, to the last if any is."""
        listed = [said.terms[1], *said.values]
        head, first = self.head(said.terms[0]), said.terms[1]
        if head is None or not all(len(v) == 1 and v[0].isdigit() for v in listed[:-1]):
            return None
        found = [int(v[0]) for v in listed[:-1]]
        if found != list(range(found[0], found[0] + len(found))):
            return None
        name = symbol(head.name)
        given: list[Compared] = [(name, "in", INTEGERS), (name, ">=", number(int(first[0])))]
        last = listed[-1]
        if last != ("\\ldots",):
            if last != (str(found[-1] + 1),):
                return None
            given.append((name, "<=", number(found[-1] + 1)))
        return tuple(given), (), ""

    def member(self, said: Said) -> Conditions | None:
        """``n \\in \\mathbb{Z}``, and the like."""
        head = self.head(said.terms[0])
        which = "".join(t for t in said.terms[1][1:] if t not in "{}^_")
        if head is None or which not in ("R", "Z", "N", "Z+", "N0"):
            return None
        name = symbol(head.name)
        given: list[Compared] = [] if which == "R" else [(name, "in", INTEGERS)]
        if which in ("N", "Z+", "N0"):
            given.append((name, ">=", number(0 if which == "N0" else 1)))
        return tuple(given), (), ""

    # displays

    def display(self, display: Display, before: str, after: str) -> Iterator[Link]:
        """The links of a display."""
        orders = self.orders
        self.shorter = orders.shorter
        around = self.conditions_around(before, after)
        kind = orders.kind or around.kind
        around = replace(
            around, kind=kind, noted=bool(orders.kind), path=orders.path or around.path
        )
        around = self.following(around, orders)
        blank = Link(display, 1, shown=" ".join(display.text.split()))
        if orders.skip is not None:
            yield replace(blank, status=UNREAD, why=f"skipped by a note: {orders.skip}")
            return
        if display.problem:
            yield replace(blank, status=UNREAD, why=display.problem)
            return
        try:
            found = statements(display.text)
        except InputError as error:
            yield replace(blank, status=UNREAD, why=_plain(str(error)))
            return
        if not found:
            yield replace(blank, status=UNREAD, why="it is empty")
            return
        self.remember(after[: prose.MAX_AFTER] if prose.first_sentence(after) else "")
        count, self.cases = 0, []
        groups = list(_grouped(found, self))
        self.ahead = dict(self.defined_in(said for said, _ in groups))
        for said, under in groups:
            open_sign = {"\\pm", "\\mp"} & {*said.tokens} and not said.either
            for sign in "+-" if open_sign else " ":
                one = said.signed(sign) if sign != " " else said
                for link in self.chain(replace(blank, shown=""), one, under, around, sign != " "):
                    count += 1
                    yield replace(link, number=count)

    def defined_in(self, found: Iterable[Said]) -> Iterator[tuple[str, Expr]]:
        """What the chains of a display define, for those that stand before."""
        for said in found:
            if not said.ops or said.ops[0] not in ("=", ":=") or {"\\pm", "\\mp"} & {*said.tokens}:
                continue
            head, value = self.head(said.terms[0]), self.piece(said.terms[1], said)
            if head and not head.derived and not isinstance(value, str) and not said.conditions:
                names = symbols(value.tree)
                if names and head.name not in names and head.name not in self.functions:
                    yield head.name, value.tree

    def following(self, around: Under, orders: Orders) -> Under:
        """With the displays from which this one follows: equations, and what symbols stand for."""
        given = list(around.given)
        values: list[tuple[str, Expr]] = []
        for left, op, right in self.noted:
            if op == "==" and left.op == "symbol":
                values.append((str(left), right))
        if not orders.sources:
            return replace(around, sources=tuple(values))
        for label in orders.sources:
            if label not in self.labels:
                raise InputError(f"the note 'from {label[:60]}': no display before has that label")
            for left, op, right in self.labels[label]:
                name = str(left)
                if op == "==" and left.op == "symbol" and name not in symbols(right):
                    values.append((name, right))
                elif elementary(left, right):
                    given.append((left, op, right))
        kind = around.kind if around.noted else prose.CLAIM
        return replace(around, given=tuple(given), sources=tuple(values), kind=kind, noted=True)

    def chain(
        self, blank: Link, said: Said, extra: Sequence[Said], around: Under, signed: bool
    ) -> Iterator[Link]:
        """The links of one chain."""
        if not said.ops:
            shown = " ".join(said.tokens)
            why = "it states nothing: there is no relation in it"
            if said.words:
                why = f"the words {said.words[0]!a} are not read"
            yield replace(blank, status=UNREAD, why=why, shown=shown)
            return
        if said.values:
            listed = said.ops == ("=",) and said.values[-1] == ("\\ldots",)
            found = self.integers(said) if listed else None
            shown = " ".join(said.tokens)
            if found is None:
                why = "a list of values, or a number with commas, is not read"
                yield replace(blank, status=UNREAD, why=why, shown=shown)
            else:
                self.lasting += found[0]
                why, text = "a condition", chained(found[0])
                yield replace(blank, status=ASSUMED, why=why, shown=shown, read_as=text)
            return
        under, problem = self.under(said, extra, around)
        pieces = [self.piece(term, said) for term in said.terms]
        for n, op in enumerate(said.ops):
            shown = " ".join((*said.terms[n], op, *said.terms[n + 1]))
            signs = {*said.terms[n][:1], *said.terms[n + 1][:1]} & {"\\pm", "\\mp"}
            several = signed or (said.either and bool(signs))
            link = replace(blank, shown=shown)
            yield self.link(link, n, op, said, pieces[n : n + 2], under, problem, several)

    def under(self, said: Said, extra: Sequence[Said], around: Under) -> tuple[Under, str]:
        """What a chain is said under, and what of it is not read."""
        given: list[Compared] = []
        put_in = list(around.put_in)
        path, problem, own = around.path, "", bool(said.conditions or extra)
        for condition in (*said.conditions, *extra):
            found = self.condition(condition) if condition.ops else self.other_cases(said)
            if found is None:
                problem = problem or f"its condition is not read: {' '.join(condition.tokens)}"
            else:
                given += found[0]
                put_in += found[1]
                path = found[2] or path
        if said.conditions:
            self.cases.append((said.terms[0], tuple(given)))
        spoken = [_names((c,)) for c in (*given, *around.given)]
        lasting = [c for c in self.lasting if _names((c,)) not in spoken]
        everything = (*self.noted, *lasting, *around.given, *given)
        bounds = own and not {"=", "\\equiv"} & {*said.ops}
        claimed = said.universal or (bounds and around.kind != prose.ASSUME)
        kind = prose.CLAIM if claimed and not around.noted else around.kind
        return replace(
            around, given=everything, put_in=tuple(put_in), path=path, kind=kind
        ), problem

    def other_cases(self, said: Said) -> Conditions | None:
        """Of "otherwise" what it says: that no case before it is."""
        cases = [given for head, given in self.cases if head == said.terms[0]]
        if not cases or any(len(given) != 1 for given in cases):
            return None
        return tuple((a, NEGATED[r], b) for ((a, r, b),) in cases), (), ""

    def link(
        self,
        link: Link,
        n: int,
        op: str,
        said: Said,
        sides: Sequence[Piece | str],
        under: Under,
        problem: str,
        signed: bool,
    ) -> Link:
        """One link: the kind of the first one is told by its form, the later ones are claims."""
        left, right = sides
        relation = RELATIONS.get(op, op)
        head = self.head(said.terms[0]) if n == 0 and relation == "==" else None
        if isinstance(right, str):
            return replace(link, status=UNREAD, why=right)
        if head and (op == ":=" or self.is_new(head, right.tree, under)):
            return self.definition(link, head, right.tree, signed or bool(said.conditions), under)
        if isinstance(left, str) and head is not None and head.name in self.functions:
            left = Piece(symbol(head.name))
        if isinstance(left, str):
            return replace(link, status=UNREAD, why=left)
        if relation in ("<<", ">>") and n == 0:
            link = _read(link, (left.tree, relation, right.tree))
            return replace(link, status=ASSUMED, why="how much is not said, so it is not used")
        if op in STRANGE or relation in ("<<", ">>"):
            return replace(link, status=UNREAD, why=f"the relation {op} is not read")
        self.seen |= symbols(left.tree) | symbols(right.tree)
        compared = (left.tree, relation, right.tree)
        if op == ":=":
            return replace(_read(link, compared), status=DEFINED, why="a definition")
        if relation == "in" or relation.startswith("->"):
            return self.interval_or_limit(link, said, under)
        bound = relation in NEGATED and relation != "==" and not said.before
        assumed = n == 0 and under.kind == prose.ASSUME
        if bound and (assumed or all(map(_is_plain, said.terms))):
            return self.assumption(link, compared, "a condition")
        if assumed:
            return self.assumption(link, compared, "an assumption")
        if problem:
            return replace(_read(link, compared), status=UNREAD, why=problem)
        return self.claim(link, n, said, compared, (left, right), under, head, signed)

    def interval_or_limit(self, link: Link, said: Said, under: Under) -> Link:
        found = self.condition(said)
        if found is not None and said.ops[0] == "\\in":
            self.lasting += found[0]
            read_as = chained(found[0]) or " ".join(said.tokens)
            return replace(link, status=ASSUMED, why="a condition", read_as=read_as)
        if found is not None and under.path and len(said.ops) == 1:
            name, end = under.path.split(" -> ")
            side = {"+": ", 1", "-": ", -1"}.get(end[-1:], "")
            value = found[2].split(" -> ")[1]
            text = (
                f"limit({found[2].split(' -> ')[0]}, {name}, {end.rstrip('+-')}{side}) == {value}"
            )
            return replace(link, read_as=text, claims=(Attempt(text, "", text),), firm=False)
        return replace(link, status=UNREAD, why="of a limit the path is not read")

    # definitions

    def head(self, tokens: Sequence[str]) -> Head | None:
        """The symbol, or the function of symbols, or the derivative, that a term consists of."""
        return head_of(list(tokens), Author(strict=True, letter_e=self.letter_e))

    def is_new(self, head: Head, value: Expr, under: Under) -> bool:
        """Whether ``head = value`` defines: it was not defined before and is not in the value."""
        if under.noted and under.kind == prose.SOLVE:
            return False
        if under.noted and under.kind == prose.CLAIM:
            known = (
                {name for name, _ in under.sources} | self.functions.keys() | _names(under.given)
            )
            return not head.derived and head.name not in known
        if under.kind == prose.DEFINE and under.noted:
            return True
        base = {head.name, head.base} | {n for n in symbols(value) if _base(n) == head.base}
        if not base.isdisjoint(symbols(value) | _unknown(value)):
            return False
        if head.derived:
            return head.base not in self.functions and head.name not in self.functions
        return head.name not in self.functions

    def definition(self, link: Link, head: Head, value: Expr, several: bool, under: Under) -> Link:
        shown = (
            head.name
            if head.derived or not head.parameters
            else f"{head.name}({', '.join(head.parameters)})"
        )
        link = replace(link, sides=(symbol(head.name), "==", value), read_as=f"{shown} == {value}")
        if any(node.op in ("O", "o") for node in outermost(value)):
            return replace(
                link, status=DEFINED, why="a definition, up to the order that is written"
            )
        constants = sorted(
            name
            for name in symbols(value) - self.seen - {*head.parameters}
            if _CONSTANTS.fullmatch(name)
        )
        if not several and (symbols(value) or under.noted):
            self.define(head, value)
        self.seen |= symbols(value) | {head.name}
        if constants and head.parameters and not under.noted:
            why = f"an ansatz, with the free constants {', '.join(constants)}"
            return replace(link, status=ASSUMED, why=why)
        if under.kind == prose.ASSUME:
            return replace(link, status=ASSUMED, why="an assumption")
        why = "a definition; put in later where that decides"
        return replace(link, status=DEFINED, why="one of several values" if several else why)

    def define(self, head: Head, value: Expr) -> None:
        """Remember what a symbol stands for."""
        self.functions.pop(head.name, None)  # the latest are put in first
        self.functions[head.name] = Function(() if head.derived else head.parameters, value)

    def assumption(self, link: Link, compared: Compared, why: str) -> Link:
        finite = not {compared[0], compared[2]} & {INFINITY, -INFINITY}
        is_condition = compared[1] in NEGATED and compared[1] != "=="
        if is_condition and finite and elementary(compared[0], compared[2]):
            self.lasting.append(compared)
        return replace(_read(link, compared), status=ASSUMED, why=why)

    # claims

    def claim(
        self,
        link: Link,
        n: int,
        said: Said,
        compared: Compared,
        pieces: tuple[Piece, Piece],
        under: Under,
        head: Head | None,
        signed: bool,
    ) -> Link:
        """What is asked of a link, and what it is if the answer is no."""
        left, relation, right = compared
        try:
            known = self.known(under)
            left, right = self.under_binders(left, known), self.under_binders(right, known)
        except InputError as error:
            return replace(_read(link, compared), status=UNREAD, why=str(error))
        if signed and said.either and relation != "==":
            why = "which sign is meant is not said"
            return replace(_read(link, compared), status=UNREAD, why=why)
        if signed and said.either:
            left, right = left**2, right**2
        if pieces[0].printed and not pieces[1].printed and relation == "==":
            left, right, pieces = right, left, pieces[::-1]
        if under.put_in:
            values = dict(under.put_in)
            left, right = substitute(left, values), substitute(right, values)
        orders = any(node.op in ("O", "o") for node in outermost(left, right))
        as_path = ""
        if relation == "~" or orders:
            if relation == "~" and not symbols(left) | symbols(right):
                return self.printed(link, compared, pieces[1])
            path = under.path or _usual_path(right)
            if not path:
                advice = "write % tresym: as x -> 0, or whichever it is, before the display"
                why = f"it has no path: {advice}"
                return replace(_read(link, compared), status=UNREAD, why=why)
            as_path = f" as {path}"
        elif (
            relation == "=="
            and pieces[1].printed.strip("-")
            and not symbols(left)
            and (not pieces[1].printed.strip("-").isdigit())
        ):
            return self.printed(link, compared, pieces[1])
        attempts: dict[str, Attempt] = {}
        same, free = False, {"oo"}
        if any(node.op == "antiderivative" for node in outermost(left, right)):
            free |= {name for name in symbols(left) | symbols(right) if _CONSTANTS.fullmatch(name)}
        for conditions in (under.given, (*under.given, *self.earlier)):
            if as_path:
                ends = as_path.split()[1]
                conditions = tuple(c for c in conditions if ends not in _names((c,)))
            about = chained(_about(symbols(left) | symbols(right), conditions))
            said_so = f"{left} {relation} {right}" + (f" given {about}" if about else "") + as_path
            for one, other, given, how in self.forms(left, right, conditions, under):
                if as_path:  # where it holds, the path says
                    given = [c for c in given if as_path.split()[1] not in _names((c,))]
                shown = chained(_about(symbols(one) | symbols(other), given))
                text = f"{one} {relation} {other}" + (f" given {shown}" if shown else "")
                attempts.setdefault(text + as_path, Attempt(text + as_path, how, said_so))
                same = same or not (symbols(one) ^ symbols(other)) - free
        sure = under.kind == prose.CLAIM and (under.noted or same or not said.before)
        goes_on = n > 0 and same and under.kind != prose.SOLVE
        constants = not symbols(left) | symbols(right)
        worked = not _unknown(left, right) and any(
            node.op in _WORKED for node in outermost(compared[0], compared[2])
        )
        firm = not said.before and not as_path and (sure or goes_on or constants)
        firm = firm or (worked and same and relation == "==" and under.kind != prose.SOLVE)
        if under.noted and under.kind in (prose.SOLVE,) and n == 0:
            firm = False
        read_as = next(iter(attempts.values())).read_as
        link = replace(link, sides=(left, relation, right), read_as=read_as)
        fallback = self.fallback(left, relation, right, head)
        if under.noted and under.kind == prose.CLAIM:
            fallback = "UNDECIDED", ""
        if under.noted and n == 0 and under.kind == prose.SOLVE:
            return replace(link, status=fallback[0], why=fallback[1])
        if head is not None and fallback[0] == DEFINED and symbols(right):
            self.define(head, right)
        undecided = "UNDECIDED", ""
        keep = firm or (same and relation == "==" and n > 0) or as_path or relation != "=="
        link = replace(link, claims=tuple(attempts.values()), firm=firm, same=same)
        if fallback[0] == EQUATION and _unknown(left, right):
            link = replace(link, same=False, unknown=True)
        return replace(link, otherwise=undecided if keep and fallback[0] != DEFINED else fallback)

    def forms(
        self,
        left: Expr,
        right: Expr,
        given: Sequence[Compared],
        under: Under,
    ) -> Iterator[tuple[Expr, Expr, Sequence[Compared], str]]:
        """Both sides and the conditions as they stand, and with definitions put in.

        What was defined last is put in first, by itself, then all of what the claim is said to
        follow from; in the end everything is.
        """
        yield left, right, given, ""
        known, equal = self.known(under), {name for name, _ in under.sources}
        given = [c for c in given if c[1] != "==" or str(c[0]) not in equal]
        used: list[str] = []
        found: list[tuple[Expr, Expr, Sequence[Compared], str]] = []
        for _ in range(_DEPTH):
            names = symbols(left) | symbols(right)
            name = next((n for n in reversed(known) if n in names), "")
            if not name:
                break
            value = {name: known[name]}
            try:
                left, right = substitute(left, value), substitute(right, value)
                given = [(substitute(a, value), r, substitute(b, value)) for a, r, b in given]
            except InputError:
                break
            used.append(f"{name} = {value[name]}")
            found.append((left, right, given, f"with {', '.join(used)} put in"))
        named = [f for f in found if (symbols(f[0]) | symbols(f[1])).isdisjoint(equal)]
        yield from (*found[:1], *(named[:1] if equal else ()), *found[1:][-1:])

    def known(self, under: Under) -> dict[str, Expr]:
        """What symbols stand for, what was said last at the end."""
        known = self.ahead | {name: function.body for name, function in self.functions.items()}
        for name, body in under.sources:
            known.pop(name, None)
            known[name] = body
        return known

    def under_binders(self, e: Expr, known: Mapping[str, Expr]) -> Expr:
        """With what is a function of the variable of a derivative or an integral put in there.

        In print ``y`` under ``d/dx`` is what it stands for, where that has x in it.

        Raises:
            InputError: it is not known whether a symbol is a function of the variable.
        """
        if e.op in LEAVES or elementary(e):
            return e
        if e.op not in BINDERS or not symbols(e.args[0]).isdisjoint(e.names):
            if e.op in UNWORKED or e.op == "unknown":
                return e
            return rebuild(e, tuple(self.under_binders(arg, known) for arg in e.args))
        args = tuple(self.under_binders(arg, known) for arg in e.args[1:])
        body = instantiate(e.args[0], tuple(map(symbol, e.names)))
        for _ in range(_DEPTH):
            values = {
                n: known[n] for n in symbols(body) & known.keys() if _reaches(n, e.names, known)
            }
            if not values:
                break
            body = substitute(body, values)
        for name in sorted(symbols(body) - {*e.names}):
            on = self.dependent.get(name, frozenset()) | ({""} if name in self.called else set())
            if on & {"", *e.names}:
                raise InputError(f"whether {name} is a function of {e.names[0]} is not said")
        return Expr(e.op, (bind(self.under_binders(body, known), e.names), *args), e.names)

    def fallback(
        self, left: Expr, relation: str, right: Expr, head: Head | None
    ) -> tuple[str, str]:
        """What an equality is that does not hold everywhere."""
        if relation != "==":
            return "UNDECIDED", ""
        known = head is not None and head.name in self.functions and not head.derived
        if head is not None and known and head.name not in symbols(right):
            return DEFINED, "defined before, and otherwise: from here on it is this"
        names = (symbols(left) | symbols(right)) - {"oo"}
        unknown = _unknown(left, right)
        if unknown:
            return EQUATION, f"to be solved for {' or '.join(sorted(unknown))}"
        derived = sorted({base for name in names if (base := _base(name)) != name})
        if head is not None and not derived and head.name in symbols(right):
            derived = [head.name]
        new = names - self.functions.keys() - _names(self.noted) - _names(self.lasting)
        unknowns = derived or sorted(new or names)
        return EQUATION, f"to be solved for {' or '.join(unknowns) or 'nothing'}"

    def printed(self, link: Link, compared: Compared, piece: Piece) -> Link:
        """A constant, and its digits as they are printed."""
        left, _, right = compared
        digits = piece.printed.strip("-")
        if not digits:
            why = "how near is not said, and the right side is no decimal"
            return replace(_read(link, compared), status=UNREAD, why=why)
        mantissa, _, exponent = digits.partition("e")
        places = len(mantissa.partition(".")[2])
        unit = parse_number(f"1e{int(exponent or 0) - places}")
        attempts = []
        shown = f"{left} == {piece.printed} to the digits printed"
        for share, how in (
            (fmpq(1, 2), "the last digit is rounded"),
            (fmpq(1), "the last digit is cut off, not rounded"),
        ):
            bound = number(unit * share)
            attempts.append(Attempt(f"abs({left} - ({right})) <= {bound}", how, shown))
        return replace(
            link, sides=(left, "==", right), read_as=shown, claims=tuple(attempts), firm=True
        )

    # terms

    def piece(self, tokens: Sequence[str], said: Said) -> Piece | str:
        """A term, or why it is not read."""
        if "hot" in tokens:
            return "how small the terms of higher order are is not said"
        if WORDS in tokens:
            return f"the words {(said.words or ('in it',))[0]!a} are not read"
        try:
            lone = len(said.ops) == 1 and self.head(said.terms[0]) is not None
            tokens = _without_units(tokens) if lone else tokens
            if said.either and tokens[:1] in (("\\pm",), ("\\mp",)):
                tokens = tokens[1:]
            return self.term(tokens)
        except InputError as error:
            return _plain(str(error))

    def term(self, tokens: Sequence[str]) -> Piece:
        tokens = _digits_joined(list(tokens))
        while tokens and tokens[-1] in (",", ".", ";", ":"):
            tokens.pop()
        reader = Reader(tokens, self.author)
        try:
            piece = reader.sum()
        except RecursionError:
            raise InputError("LaTeX: nested too deeply") from None
        if reader.peek():
            reader.refuse("an operation or the end is expected")
        return piece


@dataclass(frozen=True)
class Head:
    """The left side of a definition."""

    name: str
    parameters: tuple[str, ...] = ()
    derived: bool = False

    @property
    def base(self) -> str:
        """Of a derivative what it is one of, else the name itself."""
        return _base(self.name) if self.derived else self.name


def head_of(tokens: list[str], author: Author) -> Head | None:
    """The symbol, function of symbols or derivative of one that ``tokens`` are, else nothing."""
    try:
        reader = Reader(tokens, author)
        if reader.kind(0) == "letter" and reader.peek() != "\\pi":
            letter = reader.peek()
            name = reader.symbol()
            if not reader.peek():
                return None if letter == "e" and not author.letter_e else Head(name)
            if reader.peek() == "(":
                values = reader.arguments()
                if not reader.peek() and all(value.op == "symbol" for value in values):
                    return Head(name, tuple(str(value) for value in values))
        reader = Reader(tokens, author)
        tree = reader.sum().tree
    except (InputError, RecursionError):
        return None
    if (
        reader.peek()
        or tree.op != "symbol"
        or not _DERIVED.fullmatch(tree.args[0].split("_of_")[0])
    ):
        return None
    return Head(tree.args[0], derived=True)


def _base(name: str) -> str:
    """Of a derivative's symbol what it is one of."""
    found = _DERIVED.fullmatch(name.split("_of_")[0])
    return (found[1] or found[2]) if found else name


def _grouped(found: list[Said], reading: _Reading) -> Iterator[tuple[Said, list[Said]]]:
    """Each chain with the conditions that follow it: ``a = b, x > 0``, or ``otherwise``."""
    waiting: Said | None = None
    under: list[Said] = []
    for said in found:
        if waiting is not None and _is_condition(said, waiting, reading):
            under.append(said)
            continue
        if waiting is not None:
            yield waiting, under
        waiting, under = said, []
    if waiting is not None:
        yield waiting, under


def _is_condition(said: Said, before: Said, reading: _Reading) -> bool:
    """Whether a chain behind an equality is a condition of it, by its form."""
    claims = "=" in before.ops or not all(map(_is_plain, before.terms))
    if said.before or said.conditions or not said.ops or not claims:
        return False
    relations = {RELATIONS.get(op, "") for op in said.ops}
    if relations == {"->"} and len(said.terms[0]) < 3:
        return True
    if not relations <= {"<", ">", "<=", ">=", "!=", "in"}:
        return bool(said.values) and relations == {"=="}
    return any(len(term) <= 4 or "|" in term[0] for term in said.terms) or (
        all(map(_is_plain, said.terms[::2]))
    )


def _usual_path(right: Expr) -> str:
    """Where a remainder is small: O(x**3) as x -> 0, O(1/n) as n -> oo."""
    (*_, gauge) = [None, *(node.args[0] for node in outermost(right) if node.op == "O")]
    if gauge is None:
        return ""
    base, exponent = gauge.args if gauge.op == "^" else (gauge, number(1))
    if base.op != "symbol" or exponent.op != "number":
        return ""
    return f"{base} -> {'0' if exponent.args[0] > 0 else 'oo'}"


def _is_plain(term: Sequence[str]) -> bool:
    """A symbol or a number, perhaps with a sign, or infinity."""
    bare = [t for t in term if t not in ("+", "-", "|", "\\left|", "\\right|")]
    if not bare:
        return False
    if len(bare) == 1:
        return bare[0][0].isdigit() or bare[0][0] == "." or bare[0][-1].isalpha()
    return head_of(bare, Author(strict=True)) is not None


def _quietly(tex: str) -> list[Said]:
    try:
        return statements(tex) if len(tex) < 400 else []
    except InputError:
        return []


def _read(link: Link, compared: Compared) -> Link:
    left, relation, right = compared
    return replace(link, sides=compared, read_as=f"{left} {relation} {right}")


def _names(comparisons: Iterable[Compared]) -> frozenset[str]:
    return frozenset().union(*(symbols(a) | symbols(b) for a, _, b in comparisons))


def _about(names: frozenset[str], given: Sequence[Compared]) -> list[Compared]:
    """The conditions that speak of these variables, and of those that they tie to them."""
    reached, size = set(names), 0
    while len(reached) != size:
        size = len(reached)
        for left, _, right in given:
            own = symbols(left) | symbols(right)
            if own & reached:
                reached |= own
    kept = [c for c in given if (symbols(c[0]) | symbols(c[2])) & reached]
    return list(dict.fromkeys(kept))


def _digits_joined(tokens: list[str]) -> list[str]:
    """``2.71828 18284 59045 \\ldots`` as one decimal."""
    result: list[str] = []
    for n, token in enumerate(tokens):
        grouped = result and "." in result[-1] and result[-1][0].isdigit() and token.isdigit()
        places = len(result[-1].partition(".")[2]) if grouped else 1
        if grouped and (places % 5 == 0 or places % 3 == 0) and tokens[n - 1][-1:].isdigit():
            result[-1] += token
        elif token == "\\ldots" and result and "." in result[-1] and n == len(tokens) - 1:
            continue
        else:
            result.append(token)
    return result


def _reaches(name: str, names: Iterable[str], known: Mapping[str, Expr]) -> bool:
    """Whether what ``name`` stands for has one of ``names`` in it, however deep."""
    reached, left = set(), {name}
    while left:
        reached |= left
        left = {s for n in left if n in known for s in symbols(known[n])} - reached
    return not reached.isdisjoint(names)


def _dependent(text: str) -> dict[str, set[str]]:
    """The letters of which derivatives are written, and by what; the empty name for any."""
    found: dict[str, set[str]] = {}
    for pattern, by in _DERIVATIVES:
        for match in re.finditer(pattern, text):
            name, *rest = (part.lstrip("\\") for part in match.groups())
            found.setdefault(name, set()).add(rest[0] if rest else by)
    return found


def _unknown(*trees: Expr) -> set[str]:
    """The names of the functions in the trees that are left unknown."""
    return {str(f.args[0].args[0]) for e in trees for f in functions(e)}


def _without_units(tokens: Sequence[str]) -> Sequence[str]:
    """A number without the unit behind it."""
    start = next((n for n, token in enumerate(tokens) if token in _UNITS), 0)
    numbers = {"\\times", "\\cdot", "^", "{", "}", "-", "+"}
    if start and all(t in numbers or t[0].isdigit() or t[0] == "." for t in tokens[:start]):
        return tokens[:start]
    return tokens


def _plain(why: str) -> str:
    return " ".join(why.removeprefix("LaTeX: ").split())
