"""What a manuscript has said so far: definitions, conditions, and displays by their labels."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from tresym.manuscript import prose, restrictions
from tresym.manuscript.conditions import INDICES, ConditionReader, whole
from tresym.manuscript.dependence import may_depend
from tresym.manuscript.directives import Orders
from tresym.manuscript.display import Said, statements
from tresym.manuscript.kinds import Uses
from tresym.manuscript.scopes import Restriction, Scopes
from tresym.manuscript.terms import Head, base_of, is_plain, read_term, unknown_in
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    BINDERS,
    DOTS,
    LEAVES,
    UNWORKED,
    Expr,
    bind,
    instantiate,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.latex_cursor import Author, Function
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.language.parsing import INTEGERS, Compared
from tresym.reals.numbers.exact import InputError

_LETTER_E = re.compile(
    r"(?<![a-zA-Z\\{_^])e\s*\\(?:sin|cos)|1\s*[-+]\s*e(?![a-zA-Z^])"
    r"|1\s*-\s*e\s*\^\s*(?:\{\s*2\s*\}|2(?!\d))|(?<![a-zA-Z\\^_{])e\s*(?:<|\\ll|\\to)"
    r"|<\s*e(?![a-zA-Z^])|(?:^|[^\\a-z\s]|[$\n])\s*e\s*&?=(?!\s*(?:2\.7|e\s*\^|\\exp|\\lim|\\sum))"
)
"""Where e stands as no number does: e sin E, 1 - e, 1 - e^2, e < 1, e = c/a."""
_LETTER_DELTA = re.compile(r"\\Delta(?![a-zA-Z])\s*(?:[-+=<>^_,.$)}&]|\\(?:[gl]e|[,;]\s*[=<>])|$)")
"""Where Δ stands by itself, as no difference does."""
_CALLED = re.compile(
    r"(?<![a-zA-Z\\_^{])((?:[a-zA-Z]|\\[a-zA-Z]+(?:\s*\{\s*\\?[a-zA-Z]+\s*\})?)"
    r"(?:_(?:\w|\{\w+\}))?)\s*\(\s*(?:[a-z]|\\[a-z]+)"
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
_ITERATES = re.compile(
    r"\b(?:iterat|with itself|compositional power|period-\w|n-fold)", re.IGNORECASE
)
_PRIMED_TIME = re.compile(r"(?<![a-zA-Z\\])t'(?!')")
_TIME_WITHIN = re.compile(r"(?<![a-zA-Z\\])d\s*\}?\s*\{?t'|''")
"""Where t' is a variable of integration, or derivatives are marked by primes."""
_ENDED = re.compile(r"[.!?][\s})~]*\Z")
_PARAGRAPH = re.compile(r"\n\s*\n|\\par(?![a-zA-Z])")
DEPTH = 10
_ORDER = frozenset(("<", ">", "\\le", "\\leq", "\\ge", "\\geq", "\\leqslant", "\\geqslant"))
_DIFFERENTIAL = re.compile(r"\s*d\s*[a-zA-Z\\]+\s*=")
"""An equation of differentials, du = 2x dx, which restricts no value."""


@dataclass(frozen=True)
class Under:
    """What a display is said under."""

    given: tuple[Compared, ...] = ()
    put_in: tuple[tuple[str, Expr], ...] = ()
    path: str = ""
    kind: str = ""
    noted: bool = False
    sources: tuple[tuple[str, Expr], ...] = ()
    universal: bool = False
    told: bool = False
    """Whether the sentence says that it holds: "Then", "we have"."""
    passing: tuple[Compared, ...] = ()
    """What its own sentence says, of all that is given."""
    row: tuple[Compared, ...] = ()
    """The conditions that a word such as "for" ties to its own formula."""
    anew: frozenset[str] = frozenset()
    """The symbols of which its sentence speaks anew, as "for all real $x$" does."""
    unread: str = ""
    """A condition in its sentence that is not read."""
    stated: str = ""
    """The words of its sentence that make it a statement about what exists, or a supposition."""


class Memory(ConditionReader):
    """What was said, and what it makes of what is read.

    Attributes:
        noted: conditions of the author's notes, to the section's end.
        scopes: what the text says, as far as that reaches.
        labels: what displays say, by their labels and numbers.
        ahead: what is defined further on in the display.
        partial: whether derivatives in a chain are written with ∂.
        by: the one variable by which a chain integrates, if it is one.
        uses: what the names of the display are elsewhere.
        seen: names that stood in a display before.
        counts_derivatives: whether ``f^{(4)}(x)`` is a derivative, and no iterate of f.
        primes: whether primes make other symbols, as where there is a time t', and no derivatives.
        where: conditions of the sentences that define symbols, by the symbol.
        told: values that the lines before the display tell, without defining by them.
        own: what the sentence of the next display defines.
        line: where the display stands that is read, 0 in the running text.
        lines: where symbols were defined.
    """

    def __init__(self, text: str) -> None:
        self.letter_e = bool(_LETTER_E.search(text))
        self.letter_delta = bool(_LETTER_DELTA.search(text))
        self.scopes = Scopes()
        self.own: set[str] = set()
        self.line = 0
        self.lines: dict[str, int] = {}
        self.noted: list[Compared] = []
        self.labels: dict[str, list[Compared]] = {}
        self.shorter = self.longer = False
        self.ahead: dict[str, Expr] = {}
        self.by = ""
        self.partial = False
        self.counts_derivatives = "derivative" in text and not _ITERATES.search(text)
        self.primes = bool(_PRIMED_TIME.search(text)) and not _TIME_WITHIN.search(text)
        self.dependent = _dependent(text)
        self.called = frozenset(
            head.name for m in _CALLED.finditer(text) if (head := self.head(tokenize(m[1])))
        )
        self.uses = Uses()
        self.seen: set[str] = set()
        self.told: dict[str, Expr] = {}
        self.where: dict[str, tuple[Compared, ...]] = {}

    @property
    def functions(self) -> dict[str, Function]:
        """What symbols and functions stand for, the latest last."""
        return self.scopes.now.functions

    @property
    def lasting(self) -> list[Compared]:
        """Conditions of the prose, to the end of the section or of a scope in it."""
        return self.scopes.now.lasting

    @lasting.setter
    def lasting(self, conditions: list[Compared]) -> None:
        self.scopes.now.lasting = conditions

    @property
    def earlier(self) -> list[Compared]:
        """Conditions of sections before, of symbols that are not spoken of anew."""
        return self.scopes.now.earlier

    @property
    def recent(self) -> set[str]:
        """What was defined in this section; before it a letter may have been another."""
        return self.scopes.now.recent

    @property
    def author(self) -> Author:
        """Whose formulas are read, for the reader of LaTeX."""
        unclear = self.scopes.now.ambiguous - self.own
        return Author(
            {n: f for n, f in self.functions.items() if n not in unclear},
            strict=True,
            shorter=self.shorter,
            longer=self.longer,
            letter_e=self.letter_e,
            letter_delta=self.letter_delta,
            called=self.called,
            applied=self.uses.applied,
            bare=self.uses.bare,
            numbers=self.uses.numbers,
            sequences=self.uses.sequences,
            inverses=self.uses.inverses,
            variable=self.by,
        )

    def define(self, head: Head, value: Expr, where: Sequence[Compared] = ()) -> None:
        """Remember what a symbol stands for, and the conditions of the sentence that says so."""
        if DOTS.args[0] in symbols(value):
            return  # not all of it is written
        now, name = self.scopes.now, head.name
        found = Function(() if head.derived else head.parameters, value)
        before = now.functions.pop(name, None)  # the latest are put in first
        outer = self.scopes.before.functions.get(name)
        if before not in (None, found, outer) and name in now.recent:
            now.ambiguous.add(name)
        now.recent.add(name)
        now.places[name] = now.paragraph
        self.lines[name] = self.line
        self.where[name] = () if head.parameters else tuple(where)
        now.functions[name] = found

    def undefine(self, name: str) -> None:
        """A symbol is another from here on, and how is not read."""
        self.functions.pop(name, None)
        self.restrict({name}, "it has a definition that was not understood")

    def section(self, chapter: bool) -> None:
        """A section begins: conditions end, and what is said in scopes."""
        self.scopes.section(chapter)
        self.noted = []

    def known(self, under: Under) -> dict[str, Expr]:
        """What symbols stand for, what was said last at the end."""
        unclear = self.scopes.now.ambiguous - self.own
        functions = {n: f.body for n, f in self.functions.items() if n not in unclear}
        known = self.ahead | functions
        for name, body in under.sources:
            known.pop(name, None)
            known[name] = body
        return known

    def under_binders(
        self, e: Expr, known: Mapping[str, Expr], constants: frozenset[str] = frozenset()
    ) -> Expr:
        """With what is a function of the variable of a derivative or an integral put in there.

        In print ``y`` under ``d/dx`` is what it stands for, where that has x in it.

        Args:
            constants: what is bound around it, or said to be a number.

        Raises:
            InputError: it is not known whether a symbol is a function of the variable.
        """
        if e.op in LEAVES or elementary(e):
            return e
        if e.op not in BINDERS or not symbols(e.args[0]).isdisjoint(e.names):
            if e.op in UNWORKED or e.op == "unknown":
                return e
            return rebuild(e, tuple(self.under_binders(arg, known, constants) for arg in e.args))
        args = tuple(self.under_binders(arg, known, constants) for arg in e.args[1:])
        constants = constants.union(*map(symbols, args))  # an end is not moved by the variable
        body = instantiate(e.args[0], tuple(map(symbol, e.names)))
        for _ in range(DEPTH):
            values = {
                n: known[n]
                for n in (symbols(body) & known.keys()).difference(e.names)
                if _reaches(n, e.names, known)
            }
            if not values:
                break
            body = substitute(body, values)
        for name in sorted(symbols(body) - {*e.names}):
            on = self.dependent.get(name, frozenset()) | ({""} if name in self.called else set())
            on |= {""} if base_of(name) != name else set()
            free = name not in constants and name not in known
            varies = name in self.uses.functions or may_depend(name, e, body, self.partial)
            if on & {"", *e.names} or (free and varies):
                advice = f"write {name}({e.names[0]}), or % tresym: let {name} real"
                raise InputError(
                    f"the text does not say whether {name} is a function of {e.names[0]}: {advice}"
                )
        inner = self.under_binders(body, known, constants | {*e.names})
        return Expr(e.op, (bind(inner, e.names), *args), e.names)

    def remember(self, text: str) -> None:
        """Definitions, lasting conditions and what restricts symbols in the lines of a text."""
        for n, paragraph in enumerate(_PARAGRAPH.split(text)):
            if n:
                self.scopes.paragraph()
            for found in prose.inline(paragraph):
                for said in quietly(found.tex):
                    self.heed(said, found)

    def heed(self, said: Said, found: prose.Inline) -> None:
        """What one formula in the line says."""
        name = self.lone(said) if found.whole or found.anew else ""
        if name and found.anew:
            self.forget(name)
        if name and found.whole and (name[:1] in INDICES or not found.passing):
            self.lasting += whole(symbol(name), found.whole)
        one = self.head(said.terms[0]) if found.introduced else None
        known = self.functions.get(one.name) if one else None
        if one and known and (one.parameters or known.parameters):
            self.undefine(one.name)
        understood = not said.ops or found.conditional
        if len(said.ops) == 1 and said.ops[0] in ("=", ":="):
            if self.defined_in_line(said, found):
                return
        elif said.ops and found.lasting and not restrictions.is_absurd(found.binds):
            conditions = self.condition(said)
            self.lasting += conditions[0] if conditions else ()
            understood = conditions is not None and not conditions[1]
        why = f"'{found.binds}'" if found.binds else f"${' '.join(found.tex.split())[:60]}$"
        why = f"the text says {why} about it"
        head = self.head(said.terms[0]) if said.ops in (("=",), (":=",)) else None
        if found.binds:
            self.restrict(self.spoken_of(said), why)
        elif not understood and head is not None and not head.derived:
            others = self.spoken_of(replace(said, terms=said.terms[1:])) - {*head.parameters}
            self.restrict({head.name}, why, others - {head.name})
        elif not understood and not _DIFFERENTIAL.match(found.tex):
            conditions = self.condition(said) if {*said.ops} <= _ORDER else None
            bounds = conditions[0] if conditions else ()
            self.restrict(self.spoken_of(said), why, bounds=bounds)
        elif said.ops and found.conditional:
            conditions = self.condition(said)
            bounds = conditions[0] if conditions and not conditions[1] else ()
            within = self.scopes.now.paragraph
            for name in self.spoken_of(said) if conditions != ((), (), "") else ():
                tied = Restriction(why, bounds=bounds, within=within)
                self.scopes.now.restricted.setdefault(name, tied)

    def restrict(
        self,
        names: Iterable[str],
        why: str,
        by: Iterable[str] = (),
        bounds: tuple[Compared, ...] = (),
    ) -> None:
        """Symbols are not free for a counterexample from here on, where ``by`` is spoken of too."""
        for name in names:
            before = self.scopes.now.restricted.get(name)
            if before is None:
                self.scopes.now.restricted[name] = Restriction(why, frozenset(by), bounds)
            elif before.bounds and not bounds:
                self.scopes.now.restricted[name] = Restriction(why, frozenset(by))
            elif before.bounds:
                self.scopes.now.restricted[name] = before._replace(bounds=before.bounds + bounds)

    def spoken_of(self, said: Said) -> set[str]:
        """The symbols and functions in a formula, by their letters where it is not read."""
        names: set[str] = set()
        for term in said.terms:
            try:
                tree = read_term(term, self.author).tree
                names |= symbols(tree) | unknown_in(tree)
            except InputError:
                heads = (self.head([t]) for t in term if t[-1:].isalpha())
                names |= {head.name for head in heads if head}
        return names

    def lone(self, said: Said) -> str:
        """The symbol of which a plain formula speaks, if it is one."""
        head = self.head(said.terms[0])
        plain = head is not None and not head.parameters and all(map(is_plain, said.terms))
        return head.name if head and plain else ""

    def forget(self, name: str) -> None:
        """No condition on a symbol holds any longer: it is spoken of anew."""
        for conditions in (self.lasting, self.earlier):
            conditions[:] = [c for c in conditions if name not in names_in((c,))]
        self.scopes.now.restricted.pop(name, None)

    def defined_in_line(self, said: Said, found: prose.Inline) -> bool:
        """Whether it is a definition in the line, by the words before it or as f(x) = ….

        What is only told, as in "then $m = 2k + 1$", may help to prove the next display.
        """
        head = self.head(said.terms[0])
        if head is None or head.derived:
            return False
        surely = (found.defining and not found.hypothesis) or said.ops[0] == ":="
        try:
            value = read_term(said.terms[1], self.author).tree
        except InputError:
            if surely and head.name in self.functions:
                self.undefine(head.name)
            return False
        names = symbols(value)
        if value.op == "number" or head.name in names | unknown_in(value):
            return False
        of_all = bool(head.parameters) and names >= {*head.parameters}
        of_all = of_all and not (found.hypothesis or any("0" in p for p in head.parameters))
        if found.piece and (surely or head.parameters):
            self.undefine(head.name)
            return True
        if of_all or (surely and not head.parameters):
            self.define(head, value)
            self.own |= {head.name} if found.last else set()
            return True
        if head.name in self.functions and self.functions[head.name].body != value:
            self.undefine(head.name)
        if found.told and not found.hypothesis and names and value.op != "symbol":
            self.told[head.name] = value
            for name in names if found.whole else ():
                self.lasting += whole(symbol(name), found.whole)
        return False

    def conditions_around(self, before: str, after: str) -> Under:
        """What the sentence around a display says of its conditions."""
        given: list[Compared] = []
        put_in: list[tuple[str, Expr]] = []
        anew: set[str] = set()
        path = unread = ""
        for text in (prose.last_sentence(before), prose.first_sentence(after)):
            if prose.is_of_signs(text):
                continue
            for found in prose.inline(text):
                if not found.passing:
                    continue
                for said in quietly(found.tex):
                    if found.tends and (name := self.lone(said)):
                        path = f"{name} -> {found.tends}"
                    anew |= {self.lone(said)} if found.anew else set()
                    if found.whole and (name := self.lone(said)):
                        given += whole(symbol(name), found.whole)
                    if self.is_defined_function(said):
                        continue
                    more = self.condition(said)
                    if more and (not more[1] or said.ops == ("\\in",)):
                        given += more[0]
                        put_in += (one for one in more[1] if one[0] not in self.told)
                        path = more[2] or path
                    elif said.ops and found.conditional:
                        unread = unread or " ".join(found.tex.split())
        for found in prose.conditions_behind(after):
            for said in quietly(found.tex):
                more = self.condition(said)
                given += more[0] if more and not more[1] else ()
                unread = unread or ("" if more or not said.ops else " ".join(found.tex.split()))
        universal = prose.is_universal(before, after)
        kind = prose.kind_of(before)
        kind = "" if kind == prose.CLAIM and prose.is_narrowed(before) else kind
        leading = "" if _ENDED.search(before) else prose.last_sentence(before)
        leading = prose.without_formulas(leading)
        stated = restrictions.stated_under(leading) or restrictions.loose(leading, after)
        return Under(
            *(tuple(given), tuple(put_in), path, kind),
            universal=universal,
            anew=frozenset(anew),
            unread=unread,
            stated=stated,
        )

    def is_defined_function(self, said: Said) -> bool:
        """Whether it is the definition of a function, f(x) = …, which is no condition."""
        head = self.head(said.terms[0]) if said.ops in (("=",), (":=",)) else None
        return head is not None and bool(head.parameters) and head.name in self.functions

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
                raise InputError(
                    f"the directive 'from {label[:60]}': no earlier display has that label"
                )
            for left, op, right in self.labels[label]:
                name = str(left)
                if op == "==" and left.op == "symbol" and name not in symbols(right):
                    values.append((name, right))
                elif elementary(left, right):
                    given.append((left, op, right))
        kind = around.kind if around.noted else prose.CLAIM
        return replace(around, given=tuple(given), sources=tuple(values), kind=kind, noted=True)


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


def quietly(tex: str) -> list[Said]:
    """The chains of a formula in the line, none where it is not taken apart."""
    try:
        return statements(tex) if len(tex) < 400 else []
    except InputError:
        return []


def names_in(comparisons: Iterable[Compared]) -> frozenset[str]:
    """The names that stand in comparisons."""
    return frozenset().union(*(symbols(a) | symbols(b) for a, _, b in comparisons))


def about(names: frozenset[str], given: Sequence[Compared]) -> list[Compared]:
    """The conditions that speak of these variables, and of those that they tie to them."""
    reached, size = set(names), 0
    while len(reached) != size:
        size = len(reached)
        for left, _, right in given:
            own = (symbols(left) | symbols(right)) - symbols(INTEGERS)
            if own & reached:
                reached |= own
    kept = [c for c in given if (symbols(c[0]) | symbols(c[2])) & reached]
    return list(dict.fromkeys(kept))
