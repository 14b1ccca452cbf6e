"""What a manuscript has said so far: definitions, conditions, and displays by their labels."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from tresym.manuscript import prose, restrictions
from tresym.manuscript.conditions import INDICES, ConditionReader, whole
from tresym.manuscript.dependence import may_depend
from tresym.manuscript.directives import Orders
from tresym.manuscript.display import Said
from tresym.manuscript.kinds import Uses
from tresym.manuscript.mentions import dependent, names_in, quietly, reaches
from tresym.manuscript.scopes import Restriction, Scopes
from tresym.manuscript.terms import Head, base_of, is_plain, read_term, unknown_in
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    BINDERS,
    DOTS,
    LEAVES,
    ONE,
    UNWORKED,
    Expr,
    bind,
    instantiate,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.latex_author import Author, Function
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.numbers.exact import InputError

_LETTER_E = re.compile(
    r"(?<![a-zA-Z\\{_^])e\s*\\(?:sin|cos)|1\s*[-+]\s*e(?![a-zA-Z^])"
    r"|1\s*-\s*e\s*\^\s*(?:\{\s*2\s*\}|2(?!\d))|(?<![a-zA-Z\\^_{])e\s*(?:<|\\ll|\\to)"
    r"|<\s*e(?![a-zA-Z^])|(?:^|[^\\a-z\s]|[$\n])\s*e\s*&?=(?!\s*(?:2\.7|e\s*\^|\\exp|\\lim|\\sum))"
)
"""Where e is a variable rather than the number: e sin E, 1 - e, 1 - e^2, e < 1, e = c/a."""
_LETTER_DELTA = re.compile(r"\\Delta(?![a-zA-Z])\s*(?:[-+=<>^_,.$)}&]|\\(?:[gl]e|[,;]\s*[=<>])|$)")
"""Where Δ stands by itself, so that it is a symbol and not a difference."""
_CALLED = re.compile(
    r"(?<![a-zA-Z\\_^{])((?:[a-zA-Z]|\\[a-zA-Z]+(?:\s*\{\s*\\?[a-zA-Z]+\s*\})?)"
    r"(?:_(?:\w|\{\w+\}))?)\s*\(\s*(?:[a-z]|\\[a-z]+)"
    r"(?:\s*,\s*(?:[a-z]|\\[a-z]+))*\s*\)\s*&?\s*(?::?=|\\equiv|\\coloneqq)"
)
"""The head of a function's definition."""
_TERMS = "012345"
"""The terms of a series of functions: y_2(x) is a function where y(x) and y_0(x) are."""
_ITERATES = re.compile(
    r"\b(?:iterat|with itself|compositional power|period-\w|n-fold)", re.IGNORECASE
)
_PRIMED_TIME = re.compile(r"(?<![a-zA-Z\\])t'(?!')")
_TIME_WITHIN = re.compile(r"(?<![a-zA-Z\\])d\s*\}?\s*\{?t'|''")
"""Where t' is a variable of integration, or derivatives are marked by primes."""
_TENDING = re.compile(
    r"(?<![a-zA-Z\\_^])([a-zA-Z]|\\[a-zA-Z]+)\s*(?:\\(?:to|rightarrow|longrightarrow)(?![a-zA-Z])\s*"
    r"(0(?:\s*\^\s*\{?\s*[-+]\s*\}?)?(?![\d.])|[-+]?\s*\\infty)|\|?\s*(\\ll|\\gg)\s*1(?![\d.]))"
)
"""Where the text says that a symbol tends to 0 or to infinity, or is small or large."""
_ENDED = re.compile(r"[.!?][\s})~]*\Z")
_PARITY_WORD = re.compile(
    r"\b(?:odd|even)(?=[\s~]+(?:case|integer|number|value|one|term|[a-z]{0,3}\$)|[\s~,]*\$|[.,;:]|\s*\Z)"
    r"|\b(?:parity|otherwise|conversely)\b"
)
"""Words behind which a symbol that was called odd may be even."""
_PARAGRAPH = re.compile(r"\n\s*\n|\\par(?![a-zA-Z])")
DEPTH = 10
_ORDER = frozenset(
    ("<", ">", "\\le", "\\leq", "\\ge", "\\geq", "\\leqslant", "\\geqslant", "\\ne", "\\neq")
)
_DIFFERENTIAL = re.compile(r"\s*d\s*[a-zA-Z\\]+\s*=")
"""An equation of differentials, du = 2x dx, which restricts no value."""


@dataclass(frozen=True)
class Under:
    """The conditions of a display, and what its sentence says about it."""

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
    """Those of the given conditions that its own sentence states."""
    row: tuple[Compared, ...] = ()
    """The conditions that a word such as "for" ties to its own formula."""
    anew: frozenset[str] = frozenset()
    """Symbols that its sentence introduces anew, as "for all real $x$" does."""
    unread: str = ""
    """A condition in its sentence that was not understood."""
    unread_of: frozenset[str] = frozenset()
    """The symbols in that condition, none if they are not known."""
    stated: str = ""
    """Words of its sentence that make it an existence statement or a supposition."""
    uniformly: bool = False
    """Whether its sentence says "uniformly": one constant for all values of the parameters."""


class Memory(ConditionReader):
    """What the manuscript has said so far.

    Attributes:
        noted: conditions of directives, to the end of the section.
        scopes: definitions and conditions of the text, with their scopes.
        labels: the links of displays, by the labels and numbers of these.
        ahead: definitions further on in the display.
        partial: whether derivatives in a chain are written with ∂.
        held: variables of functions of several, of which others are constant under a ∂.
        by: the variable of integration of a chain, if there is exactly one.
        uses: how the names of the display are used elsewhere.
        seen: names that occurred in an earlier display.
        primes: whether a prime makes another symbol, as in a time t', and not a derivative.
        where: the conditions under which symbols are defined, by the symbol.
        told: values stated, but not defined, in the text before the display.
        own: symbols that the sentence of the next display defines.
        line: the line of the current display, 0 in running text.
        lines: the lines in which symbols were defined.
        withheld: symbols whose definition further on is drawn from the link that is read.
        paths: the paths that the section has stated, by variable, the latest last.
        spoken: paths that its text mentions, which are used but refute nothing.
        counts_derivatives: whether ``f^{(4)}(x)`` is a derivative, not an iterate of f.
    """

    def __init__(self, text: str) -> None:
        self.letter_e = self.letter_delta = False
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
        self.held: frozenset[str] = frozenset()
        self.counts_derivatives = "derivative" in text and not _ITERATES.search(text)
        self.primes = bool(_PRIMED_TIME.search(text)) and not _TIME_WITHIN.search(text)
        self.dependent: dict[str, set[str]] = {}
        self.called: frozenset[str] = frozenset()
        self.begin(text)
        self.uses = Uses()
        self.seen: set[str] = set()
        self.told: dict[str, Expr] = {}
        self.where: dict[str, tuple[Compared, ...]] = {}
        self.paths: dict[str, str] = {}
        self.spoken: dict[str, str] = {}
        self.withheld: frozenset[str] = frozenset()

    def begin(self, text: str) -> None:
        """Begin a chapter: which letters are functions, and of what, is told by its own text."""
        self.letter_e = bool(_LETTER_E.search(text))
        self.letter_delta = bool(_LETTER_DELTA.search(text))
        self.dependent = dependent(text)
        self.called = frozenset(
            head.name for m in _CALLED.finditer(text) if (head := self.head(tokenize(m[1])))
        )
        self.called |= {
            f"{n[:-1]}{k}" for n in self.called if n[:-1] in self.called for k in _TERMS
        }

    @property
    def functions(self) -> dict[str, Function]:
        """The definitions of symbols and functions, the latest last."""
        return self.scopes.now.functions

    @property
    def lasting(self) -> list[Compared]:
        """Conditions of the text, to the end of the section or of a scope in it."""
        return self.scopes.now.lasting

    @lasting.setter
    def lasting(self, conditions: list[Compared]) -> None:
        self.scopes.now.lasting = conditions

    @property
    def earlier(self) -> list[Compared]:
        """Conditions of earlier sections, on symbols that were not introduced anew."""
        return self.scopes.now.earlier

    @property
    def recent(self) -> set[str]:
        """Symbols defined in this section; before it a letter may have meant something else."""
        return self.scopes.now.recent

    @property
    def author(self) -> Author:
        """What the LaTeX parser must know about the author's symbols."""
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
        """Forget the definition of a symbol that gets a new one which is not understood."""
        self.functions.pop(name, None)
        self.restrict({name}, "it has a definition that was not understood")

    def section(self, chapter: bool, inner: bool = False, example: bool = False) -> None:
        """Begin a section, which ends the conditions and scopes before it."""
        self.scopes.section(chapter, inner, example)
        self.noted = []
        self.paths, self.spoken = {}, {}

    def tends(self, text: str) -> None:
        """Remember the paths that a text mentions: ``x \\to \\infty``, ``\\epsilon \\ll 1``."""
        for found in _TENDING.finditer(text):
            head = self.head(tokenize(found[1]))
            if head is None or head.parameters:
                continue
            small = found[3] == "\\ll" or (found[2] or "").startswith("0")
            minus = "-" in (found[2] or "")
            end = ("0-" if minus else "0+" if "+" in (found[2] or "+") else "0") if small else ""
            self.spoken.pop(head.name, None)
            self.spoken[head.name] = f"{head.name} -> {end or ('-oo' if minus else 'oo')}"

    def likely_path(self, names: Iterable[str], under: Under) -> str:
        """Return the path of a statement, or the last one that the text mentions for a symbol of
        it, or the usual one of a small parameter; empty if there is none."""
        names = {*names}
        found = self.path_for(names, under)
        found = found or next((self.spoken[n] for n in reversed(self.spoken) if n in names), "")
        small = sorted({"epsilon", "varepsilon"} & names)
        return found or (f"{small[0]} -> 0+" if small else "")

    def path_for(self, names: Iterable[str], under: Under) -> str:
        """Return the path on which a statement about symbols is meant: its own, or the last one of
        the section; empty if none is stated."""
        names = {*names}
        return under.path or next(
            (self.paths[name] for name in reversed(self.paths) if name in names), ""
        )

    def known(self, under: Under) -> dict[str, Expr]:
        """Return the definitions that may be substituted, the latest last."""
        unclear = self.scopes.now.ambiguous - self.own
        functions = {n: f.body for n, f in self.functions.items() if n not in unclear}
        ahead = {n: value for n, value in self.ahead.items() if n not in self.withheld}
        known = ahead | functions
        for name, body in under.sources:
            known.pop(name, None)
            known[name] = body
        return known

    def under_binders(
        self, e: Expr, known: Mapping[str, Expr], constants: frozenset[str] = frozenset()
    ) -> Expr:
        """Substitute functions of the variable under a derivative, an integral, a limit or a sum.

        In print ``y`` under ``d/dx`` means its definition, if that contains x.

        Args:
            constants: symbols bound further out, or called numbers in the text.

        Raises:
            InputError: the text does not say whether a symbol is a function of the variable.
        """
        if e.op in LEAVES or elementary(e):
            return e
        if e.op not in BINDERS or not symbols(e.args[0]).isdisjoint(e.names):
            if e.op in UNWORKED or e.op == "unknown":
                return e
            return rebuild(e, tuple(self.under_binders(arg, known, constants) for arg in e.args))
        args = tuple(self.under_binders(arg, known, constants) for arg in e.args[1:])
        constants = constants.union(
            *map(symbols, args)
        )  # limits of integration do not depend on the variable
        body = instantiate(e.args[0], tuple(map(symbol, e.names)))
        for _ in range(DEPTH):
            values = {
                n: known[n]
                for n in (symbols(body) & known.keys()).difference(e.names)
                if reaches(n, e.names, known)
            }
            if not values:
                break
            body = substitute(body, values)
        for name in sorted(symbols(body) - {*e.names} - self.held):
            on = self.dependent.get(name, frozenset()) | ({""} if name in self.called else set())
            on |= {""} if base_of(name) != name else set()
            free = name not in constants and name not in known
            varies = name in self.uses.functions or may_depend(name, e, body, self.partial)
            if on & {"", *e.names} or (free and varies):
                advice = f"write {name}({e.names[0]}), or % tresym: let {name} real"
                why = f"the text does not say whether {name} is a function of {e.names[0]}"
                raise InputError(f"{why}: {advice}")
        inner = self.under_binders(body, known, constants | {*e.names})
        return Expr(e.op, (bind(inner, e.names), *args), e.names)

    def remember(self, text: str) -> None:
        """Collect definitions, conditions and restrictions of symbols from running text."""
        for n, paragraph in enumerate(_PARAGRAPH.split(text)):
            if n:
                self.scopes.paragraph()
            self.other_parity(paragraph)
            for formula in prose.INLINE.finditer(paragraph):
                self.tends(formula[1] or formula[2])
            for found in prose.inline(paragraph):
                for said in quietly(found.tex):
                    self.heed(said, found)

    def heed(self, said: Said, found: prose.Inline) -> None:
        """Collect what one inline formula defines, assumes or restricts."""
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
            if conditions and conditions[1] and said.ops == ("\\in",):
                understood = self.has_parity(said, conditions[1][0][1])
        why = f"'{found.binds}'" if found.binds else f"${' '.join(found.tex.split())[:60]}$"
        why = f"the text says {why} about it"
        equal = bool(said.ops) and {*said.ops} <= {"=", ":="}
        heads = [
            self.head(term) for term in said.terms[:-1] if equal and not self.applies_known(term)
        ]
        known_heads = [head for head in heads if head is not None and not head.derived]
        if found.binds:
            self.restrict(self.spoken_of(said), why)
        elif not understood and heads and len(known_heads) == len(heads):
            names = {head.name for head in known_heads}  # z = f(x, y) = x + y says nothing of x
            own = names.union(*(head.parameters for head in known_heads))
            others = self.spoken_of(replace(said, terms=said.terms[-1:]))
            self.restrict(names, why, others - own)
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

    def applies_known(self, term: Sequence[str]) -> bool:
        """Whether a term is a known function of something, as f(x, 2), which restricts nothing."""
        one = self.head(term[:1]) if term else None
        known = self.functions.get(one.name) if one else None
        applied = list(term[1:2]) == ["("] and list(term[-1:]) == [")"]
        return bool(known and known.parameters) and applied and list(term).count("(") == 1

    def has_parity(self, said: Said, value: Expr) -> bool:
        """Put in that a symbol is odd or even, as "Let $n$ be odd" says; whether it is one."""
        head = self.head(said.terms[0])
        if head is None or head.parameters:
            return False
        self.functions.pop(head.name, None)
        self.scopes.now.ambiguous.discard(head.name)
        self.scopes.now.recent.discard(head.name)
        self.define(head, value)
        self.rather_positive(head.name, value)
        return True

    def rather_positive(self, name: str, value: Expr) -> None:
        """Bound odd and even numbers for counterexamples: "for even n" rarely means n = -2."""
        if name not in self.scopes.now.restricted:
            bounds = tuple((symbol(half), ">=", ONE) for half in symbols(value))
            self.restrict({name}, "it may be meant to be positive", bounds=bounds)

    def implicitly(self, text: str) -> None:
        """Forget what small letters stood for that an equation determines: "Consider the curve"."""
        for said in quietly(text):
            if said.ops != ("=",) or self.head(said.terms[0]) is not None:
                continue
            for name in self.spoken_of(said) & self.functions.keys():
                if len(name) == 1 and name.islower() and not self.functions[name].parameters:
                    self.undefine(name)

    def other_parity(self, text: str) -> None:
        """Forget that a symbol is odd where a sentence speaks of even numbers, and conversely."""
        words = {word.lower() for word in _PARITY_WORD.findall(prose.without_formulas(text))}
        for name, function in [*self.functions.items()] if words else ():
            if f"{name}_half" in symbols(function.body) and not function.parameters:
                self.undefine(name)

    def restrict(
        self,
        names: Iterable[str],
        why: str,
        by: Iterable[str] = (),
        bounds: tuple[Compared, ...] = (),
    ) -> None:
        """Mark symbols as not free for counterexamples, in claims that contain one of ``by``."""
        for name in names:
            before = self.scopes.now.restricted.get(name)
            if before is None:
                self.scopes.now.restricted[name] = Restriction(why, frozenset(by), bounds)
            elif before.bounds and not bounds:
                self.scopes.now.restricted[name] = Restriction(why, frozenset(by))
            elif before.bounds:
                self.scopes.now.restricted[name] = before._replace(bounds=before.bounds + bounds)

    def spoken_of(self, said: Said) -> set[str]:
        """Return the symbols and functions of a formula; its letters if it cannot be read."""
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
        """Return the symbol that a formula such as ``n`` or ``x > 0`` is about, else ``""``."""
        head = self.head(said.terms[0])
        plain = head is not None and not head.parameters and all(map(is_plain, said.terms))
        return head.name if head and plain else ""

    def forget(self, name: str) -> None:
        """Drop all conditions on a symbol that is introduced anew."""
        for conditions in (self.lasting, self.earlier):
            conditions[:] = [c for c in conditions if name not in names_in((c,))]
        self.scopes.now.restricted.pop(name, None)

    def defined_in_line(self, said: Said, found: prose.Inline) -> bool:
        """Store an inline definition, and return whether it is one; "then $m = 2k + 1$" is not."""
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
        """Return the conditions that the sentence around a display states for it."""
        given: list[Compared] = []
        put_in: list[tuple[str, Expr]] = []
        anew: set[str] = set()
        path = unread = ""
        unread_of: set[str] = set()
        for text in (prose.last_sentence(before), prose.first_sentence(after)):
            if prose.is_of_signs(text):
                continue
            if (both := prose.of_last_or_both(text)) is not None:
                unread = f"{both[0]} and {both[1]}, where both or only the last may be meant"
                unread_of = {one for said in quietly(both[0]) for one in self.spoken_of(said)}
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
                    if more and (not more[1] or said.ops[:1] == ("\\in",)):
                        given += more[0]
                        for one, value in more[1]:
                            self.rather_positive(one, value)
                        put_in += (one for one in more[1] if one[0] not in self.told)
                        path = more[2] or path
                    elif said.ops and found.conditional and not unread:
                        unread, unread_of = " ".join(found.tex.split()), self.spoken_of(said)
        for found in prose.conditions_behind(after):
            for said in quietly(found.tex):
                more = self.condition(said)
                given += more[0] if more and not more[1] else ()
                if not (unread or more) and said.ops:
                    unread, unread_of = " ".join(found.tex.split()), self.spoken_of(said)
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
            unread_of=frozenset(unread_of),
            stated=stated,
            uniformly=prose.is_uniform(before, after),
        )

    def is_defined_function(self, said: Said) -> bool:
        """Whether it is the definition of a function, f(x) = …, and so not a condition."""
        head = self.head(said.terms[0]) if said.ops in (("=",), (":=",)) else None
        return head is not None and bool(head.parameters) and head.name in self.functions

    def following(self, around: Under, orders: Orders) -> Under:
        """Add the displays from which this one follows, as conditions and definitions."""
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
