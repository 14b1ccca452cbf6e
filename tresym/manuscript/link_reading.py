"""Read one link of a chain: what it assumes, defines, claims or continues."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tresym.manuscript import prose
from tresym.manuscript.classification import (
    ASSUMED,
    CONSTANTS,
    DEFINED,
    EQUATION,
    NO_VARIABLES,
    UNREAD,
    Attempt,
    Link,
    Obstacle,
    TwoReadings,
    claim,
    read_so,
    usual_path,
    without_dots,
)
from tresym.manuscript.context import Memory, Under
from tresym.manuscript.conventions import StatedConventions
from tresym.manuscript.directives import Orders
from tresym.manuscript.display import STRANGE, Said
from tresym.manuscript.display_text import OR, WORDS
from tresym.manuscript.kinds import Kinds
from tresym.manuscript.mentions import about, names_in
from tresym.manuscript.random_variables import Distributions
from tresym.manuscript.solutions import (
    Solves,
    Stated,
    Value,
    at_points,
    equation_for,
    expansion_claims,
    is_called_solution,
    is_complete,
    residual,
)
from tresym.manuscript.source import Display, Event, Prose, Section
from tresym.manuscript.terms import (
    SIGNS,
    Head,
    base_of,
    is_plain,
    plain,
    read_term,
    unknown_in,
    with_derivatives_counted,
    with_primed_variables,
    without_units,
)
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import DOTS, Expr, symbol, symbols
from tresym.reals.language.formula import NEGATED, Compared, chained
from tresym.reals.language.latex_cursor import is_letter
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import RELATIONS
from tresym.reals.numbers.exact import AmbiguityError, InputError
from tresym.reals.verdict import Verdict

EITHER = "either"
"""Marks the first of two alternatives: a chain that is followed by "or"."""


class LinkReader:
    """What was read so far, and how one link of a chain is read.

    Attributes:
        equations: the lines of the last equations for symbols, by symbol.
        position: the place of the chain in its display.
        places_ahead: the places of the chains of the display that define symbols.
        stated: the equalities of the section that may be equations.
        values: the initial and boundary values that the section states.
        last_term: the last term of the display before, which the next one may continue.
        chapters: the texts of the chapters that follow.
    """

    def __init__(self, events: Sequence[Event]) -> None:
        self.events = events
        self.memory = Memory("\n".join(e.text for e in events if isinstance(e, Display | Prose)))
        texts: list[list[str]] = [[]]
        for event in events:
            if isinstance(event, Section) and event.chapter:
                texts.append([])
            elif isinstance(event, Display | Prose):
                texts[-1].append(event.text)
        self.chapters = ["\n".join(text) for text in texts]
        self.memory.begin(self.chapters.pop(0))
        self.kinds = Kinds(events)
        self.place, self.words = 0, ""
        self.orders = Orders()
        self.cases: list[tuple[tuple[str, ...], tuple[Compared, ...]]] = []
        self.equations: dict[str, int] = {}
        self.stated: list[Stated] = []
        self.conventions = StatedConventions()
        self.distributions = Distributions()
        self.position = 0
        self.places_ahead: dict[str, int] = {}
        self.values: list[Value] = []
        self.last_term: tuple[str, ...] = ()

    def either_reading(
        self, blank: Link, said: Said, under: Under, problem: str, why: str
    ) -> Iterator[Link]:
        """Yield the links of a chain that has two readings, each link with both readings.

        Args:
            problem: the condition that was not understood, if any.
            why: the reason why it has two.
        """
        rows: list[list[Piece | str]] = []
        for longer in (True, False):
            self.memory.longer, self.memory.shorter = longer, not longer
            rows.append([self.piece(term, said) for term in said.terms])
        self.memory.longer = self.memory.shorter = False
        if any(isinstance(piece, str) for row in rows for piece in row):
            return
        if any(RELATIONS.get(op, "->") in ("->", "in", "<<", ">>") for op in said.ops):
            return
        for n, op in enumerate(said.ops):
            shown = " ".join((*said.terms[n], op, *said.terms[n + 1]))
            if rows[0][n : n + 2] == rows[1][n : n + 2] and n:
                link = replace(blank, shown=shown)
                yield self.link(link, n, op, said, rows[0][n : n + 2], under, problem, False)
                continue
            both = []
            for row in rows:
                one, other = row[n : n + 2]
                if isinstance(one, Piece) and isinstance(other, Piece):
                    compared = one.tree, RELATIONS[op], other.tree
                    link = replace(blank, shown=shown)
                    link = claim(
                        self.memory, link, 1, said, compared, (one, other), under, None, False
                    )
                    link = replace(link, firm=False, otherwise=(UNREAD, why))
                    both.append(replace(link, obstacle=Obstacle.TWO_READINGS))
            yield both[0] if both[0].claims == both[1].claims else replace(both[0], second=both[1])

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
        """Classify one link: the first of a chain by its form; later ones are claims."""
        left, right = sides
        relation = RELATIONS.get(op, op)
        if (
            relation == "=="
            and n == 0
            and (value := self.initial_value(link, said.terms[0], said.terms[1]))
        ):
            return value
        head = self.memory.head(said.terms[0]) if n == 0 and relation == "==" else None
        if n and op in ("\\equiv", ":="):  # x = f(t) \equiv the value of f
            inner = self.memory.head(said.terms[n])
            head = inner if inner and inner.parameters else None
            op = ":=" if head and head.name not in self.memory.functions else op
        if any(isinstance(side, TwoReadings) for side in sides):
            link = replace(link, obstacle=Obstacle.TWO_READINGS)
        if isinstance(right, str):
            return replace(link, status=UNREAD, why=right)
        if head and (op == ":=" or self.is_new(head, right.tree, under)):
            return self.definition(link, head, right.tree, signed or bool(said.conditions), under)
        if isinstance(left, str) and head is not None and head.name in self.memory.functions:
            left = Piece(symbol(head.name))
        if isinstance(left, str):
            return replace(link, status=UNREAD, why=left)
        if (
            relation == "~"
            and n == 0
            and (found := self.approximation(link, said, right.tree, under))
        ):
            return found
        if relation in ("<<", ">>") and (
            found := self.small_beside(link, left.tree, relation, right.tree, under)
        ):
            return found
        if relation in ("<<", ">>") and n == 0:
            link = read_so(link, (left.tree, relation, right.tree))
            return replace(
                link,
                status=ASSUMED,
                why="a condition that does not say by how much; it is not used",
            )
        if op in STRANGE or relation in ("<<", ">>"):
            return replace(link, status=UNREAD, why=f"the relation {op} is not supported")
        self.memory.seen |= symbols(left.tree) | symbols(right.tree)
        compared = (left.tree, relation, right.tree)
        if op == ":=":
            return replace(read_so(link, compared), status=DEFINED, why="a definition")
        if relation == "in" or relation.startswith("->"):
            return self.interval_or_limit(link, said, under)
        bound = relation in NEGATED and relation != "=="
        lone = bound and all(map(is_plain, said.terms))
        if lone and said.before in (OR, EITHER):
            why = "the text does not say which of the alternatives holds"
            return replace(read_so(link, compared), status=UNREAD, why=why)
        assumed = n == 0 and under.kind == prose.ASSUME
        if bound and not said.before and (assumed or lone):
            defined = not assumed and self.is_of_defined(said)
            asked = claim(self.memory, link, n, said, compared, (left, right), under, head, signed)
            if under.told or (under.universal and not assumed):
                return asked if defined else replace(asked, firm=False)
            condition = self.assumption(link, compared, "a condition")
            asked = replace(asked, firm=False, otherwise=(ASSUMED, "a condition"))
            return asked if defined else condition
        if assumed:
            return self.assumption(link, compared, "an assumption")
        if problem:
            link = replace(link, obstacle=Obstacle.CONDITION)
            return replace(read_so(link, compared), status=UNREAD, why=problem)
        before = self.memory.lines.get(head.name, 0) if head is not None else 0
        if n == 0 and head is None and relation == "==":
            self.memory.withheld = self.drawn_from(compared)
        found = claim(self.memory, link, n, said, compared, (left, right), under, head, signed)
        self.memory.withheld = frozenset()
        equation = equation_for(self.stated, head.name) if head is not None else None
        if head is None or equation is None or found.otherwise[0] != DEFINED:
            return found
        if equation.line <= before:
            return found
        why = "defined differently before; this definition holds from here on"
        named = replace(link, read_as=f"{head.name} == {right.tree}", sides=compared)
        return self.solution(named, head, right.tree, under, why) or found

    def small_beside(
        self, link: Link, left: Expr, relation: str, right: Expr, under: Under
    ) -> Link | None:
        """Return the link of ``f \\ll g`` in one variable along a path, which is f = o(g).

        Of two symbols, or of a symbol and a number, it is a condition; then the answer is None.
        """
        small, large = (left, right) if relation == "<<" else (right, left)
        names = symbols(small) | symbols(large)
        if len(names) != 1 or not elementary(small, large) or not symbols(large):
            return None
        if small.op in ("symbol", "number") and large.op in ("symbol", "number"):
            return None
        path = self.memory.likely_path(names, under)
        if not path:
            return None
        text = f"{small} == o({large}) as {path}"
        why = "a condition that does not say by how much; it is not used"
        link = read_so(link, (left, relation, right))
        return replace(
            link,
            claims=(Attempt(text, "", text),),
            firm=False,
            unknown=True,
            otherwise=(ASSUMED, why),
        )

    def drawn_from(self, compared: Compared) -> frozenset[str]:
        """Return the symbols that later chains of the display determine from an equality.

        The values ``A = b`` behind ``3A = 3b`` prove nothing about it.
        """
        names = symbols(compared[0]) | symbols(compared[2])
        new = self.memory.ahead.keys() - self.memory.functions.keys()
        later = {n for n in new & names if self.places_ahead.get(n, 0) > self.position}
        return frozenset(n for n in later if symbols(self.memory.ahead[n]) <= names)

    def is_of_defined(self, said: Said) -> bool:
        """Whether a chain bounds a symbol that has a definition, so that it is true or false."""
        heads = (self.memory.head([t for t in term if t not in SIGNS]) for term in said.terms)
        return any(head and head.name in self.memory.functions for head in heads)

    def interval_or_limit(self, link: Link, said: Said, under: Under) -> Link:
        """Return the link of a membership in an interval, or of a limit."""
        found = self.memory.condition(said)
        if found is not None and said.ops[0] == "\\in":
            self.memory.lasting += found[0]
            read_as = chained(found[0]) or " ".join(said.tokens)
            return replace(link, status=ASSUMED, why="a condition", read_as=read_as)
        path = self.memory.likely_path(self.memory.spoken_of(said), under)
        if found is not None and path and len(said.ops) == 1:
            name, end = path.split(" -> ")
            side = {"+": ", 1", "-": ", -1"}.get(end[-1:], "")
            value = found[2].split(" -> ")[1]
            text = (
                f"limit({found[2].split(' -> ')[0]}, {name}, {end.rstrip('+-')}{side}) == {value}"
            )
            return replace(link, read_as=text, claims=(Attempt(text, "", text),), firm=False)
        return replace(link, status=UNREAD, why="the path of the limit is not understood")

    def is_new(self, head: Head, value: Expr, under: Under) -> bool:
        """Whether ``head = value`` is a definition: the head is new and not part of the value."""
        if under.noted and under.kind == prose.SOLVE:
            return False
        if under.noted and under.kind == prose.CLAIM:
            known = (
                {name for name, _ in under.sources}
                | self.memory.functions.keys()
                | names_in(under.given)
            )
            return not head.derived and head.name not in known
        if under.kind == prose.DEFINE and under.noted:
            return True
        base = {head.name, head.base} | {n for n in symbols(value) if base_of(n) == head.base}
        if not base.isdisjoint(symbols(value) | unknown_in(value)):
            return False
        if head.derived:
            return head.base not in self.memory.functions and head.name not in self.memory.functions
        return head.name not in self.memory.functions

    def definition(self, link: Link, head: Head, value: Expr, several: bool, under: Under) -> Link:
        """Return the link that defines a symbol or function, which is remembered."""
        shown = (
            head.name
            if head.derived or not head.parameters
            else f"{head.name}({', '.join(head.parameters)})"
        )
        link = replace(link, sides=(symbol(head.name), "==", value), read_as=f"{shown} == {value}")
        if any(node.op in ("O", "o") for node in outermost(value)):
            return self.expansion(link, head, "==", value, under)
        constants = sorted(
            name
            for name in symbols(value) - self.memory.seen - {*head.parameters}
            if CONSTANTS.fullmatch(name)
        )
        of_some = not names_in(under.passing).isdisjoint(head.parameters)
        if several or of_some:  # it holds for some arguments only
            self.memory.undefine(head.name)
        elif symbols(value) or under.noted:
            self.memory.define(head, value, under.passing)
        self.memory.seen |= symbols(value) | {head.name}
        if constants and head.parameters and not under.noted:
            if found := self.solution(link, head, value, under, "an ansatz"):
                return replace(found, otherwise=(ASSUMED, "an ansatz with free constants"))
            why = f"an ansatz, with the free constants {', '.join(constants)}"
            return replace(link, status=ASSUMED, why=why)
        if under.kind == prose.ASSUME:
            return replace(link, status=ASSUMED, why="an assumption")
        why = "a definition; it is substituted later if that decides a link"
        if not several and (found := self.solution(link, head, value, under, why)):
            return found
        return replace(
            link, status=DEFINED, why="one of several values of its left side" if several else why
        )

    def approximation(self, link: Link, said: Said, value: Expr, under: Under) -> Link | None:
        """Return the link of an approximation of a symbol that is defined nowhere, else None."""
        head = self.memory.head(said.terms[0])
        if head is None or head.derived or head.name in self.memory.functions:
            return None
        if head.name in symbols(value) or head.name in self.memory.told:
            return None
        link = replace(link, sides=None, read_as=f"{head.name} ~ {value}")
        if head.base in self.equations:
            return self.expansion(link, head, "~", value, under)
        why = f"an approximation of {head.name}, which is defined nowhere"
        return replace(link, status=ASSUMED, why=why)

    def solution(self, link: Link, head: Head, value: Expr, under: Under, why: str) -> Link | None:
        """Return the link of a solution, whose claim is that it solves the equation before it."""
        equation = equation_for(self.stated, head.name)
        if equation is None or head.derived or not symbols(value) or under.noted:
            return None
        if head.name not in self.memory.functions and not head.parameters:
            return None

        varying = self.memory.dependent.keys() & symbols(value) - {*head.parameters}
        if varying - {head.name}:
            return None  # what it depends on is differentiated elsewhere, so it is no constant
        fixed = symbols(value) | equation.names

        def read(term: Sequence[str]) -> Expr:
            tree = read_term(term, self.memory.author).tree
            return self.memory.under_binders(tree, self.memory.known(under), fixed)

        found = residual(read, equation, head.name, value)
        if found is None or {node.op for node in outermost(found[0], found[2])} - {"derivative"}:
            return None
        left, _, right = found
        given = chained(about(symbols(left) | symbols(right), under.given))
        text = f"{left} == {right}" + (f" given {given}" if given else "")
        how = f"put into the equation of line {equation.line}"
        complete = is_complete(equation, head.name, value)
        called = is_called_solution(self.words)
        asked = Attempt(text, how, link.read_as, sides=found)
        at = equation.display, equation.shown, equation.line
        solves = Solves(*at, complete, called, (DEFINED, why))
        points = [one for one in self.values if one.name == head.name]
        beside = tuple(at_points(equation, points, head.parameters, value, self.read_value))
        solves = solves._replace(beside=beside)
        return replace(link, claims=(asked,), otherwise=(DEFINED, why), solves=solves)

    def expansion(self, link: Link, head: Head, relation: str, value: Expr, under: Under) -> Link:
        """Return the link of an expansion; that of a quantity with an equation is a claim."""
        if relation == "~" and value.op == "+" and DOTS in value.args:
            value = without_dots(value)
        line = self.equations.get(head.base)
        if line is None:
            return replace(link, status=DEFINED, why="a definition up to the order given")
        equation = equation_for(self.stated, head.name)
        names = symbols(value) - NO_VARIABLES
        path = self.memory.path_for(names, under) or usual_path(value)
        path = path or self.memory.likely_path(names, under)
        if equation is not None and path:
            asked = tuple(expansion_claims(equation, head.name, relation, value, path))
            if asked:
                told = f"for which line {equation.line} states an equation"
                why = f"an expansion of {head.name}, {told}"
                complete = is_complete(equation, head.name, value)
                fallback = Verdict.UNDECIDED.value, why
                at = equation.display, equation.shown, equation.line
                solves = Solves(*at, complete, True, fallback)
                return replace(link, claims=asked, otherwise=fallback, solves=solves)
        why = f"an expansion of {head.base}, for which line {line} states an equation: not checked"
        return replace(link, status=Verdict.UNDECIDED.value, why=why)

    def read_value(self, term: Sequence[str]) -> Expr:
        """Return the expression that tokens stand for.

        Raises:
            InputError: they cannot be read.
        """
        return read_term(term, self.memory.author).tree

    def initial_value(self, link: Link, term: Sequence[str], value: Sequence[str]) -> Link | None:
        """Return the link of a value at a point, ``x(0) = 0`` or ``\\dot{x}(0) = v``, else None.

        It belongs to an equation for the function, unless the function is defined.
        """
        bare = [token for token in term if token not in ("{", "}")]
        accents = [token for token in bare if token in ("\\dot", "\\ddot", "'")]
        rest = [token for token in bare if token not in accents]
        if len(rest) != 4 or rest[1] != "(" or rest[3] != ")" or not rest[2][0].isdigit():
            return None
        head = self.memory.head([rest[0]])
        if head is None or rest[0] == "\\pi":
            return None
        equation = equation_for(self.stated, head.name)
        line = equation.line if equation is not None else -1
        if head.name in self.memory.functions and line < self.memory.lines.get(head.name, 0):
            return None
        known = head.name in self.equations or head.name in self.memory.dependent
        if not (accents or known or head.name in self.memory.called):
            return None
        order = sum({"\\ddot": 2}.get(token, 1) for token in accents)
        number = link.display.number
        self.values.append(Value(head.name, order, rest[2], number, value, link.shown))
        why = f"a value of {head.name} at a point, which belongs to an equation for it"
        try:
            point, stands_for = self.read_value([rest[2]]), self.read_value(value)
        except InputError:
            return replace(link, status=EQUATION, why=why)
        at_point = head.name, order, point, stands_for
        return replace(link, status=EQUATION, why=why, value=at_point)

    def assumption(self, link: Link, compared: Compared, why: str) -> Link:
        """Return the link of a comparison that is assumed, as a condition on what follows."""
        finite = not {compared[0], compared[2]} & {INFINITY, -INFINITY}
        is_condition = compared[1] in NEGATED and compared[1] != "=="
        if is_condition and finite and elementary(compared[0], compared[2]):
            self.memory.lasting.append(compared)
        return replace(read_so(link, compared), status=ASSUMED, why=why)

    def piece(self, tokens: Sequence[str], said: Said) -> Piece | str:
        """Return a term as an expression, or the reason why it cannot be read."""
        if "hot" in tokens:
            return "the text does not say how small the terms of higher order are"
        if any(tuple(tokens[n : n + 3]) == ("{", ",", "}") for n in range(len(tokens))):
            return "a number with one comma, such as 1,000, may be a decimal or a list"
        if WORDS in tokens:
            return f"the words {(said.words or ('in it',))[0]!a} are not understood"
        try:
            lone = len(said.ops) == 1 and self.memory.head(said.terms[0]) is not None
            tokens = with_primed_variables(without_units(tokens) if lone else tokens)
            if self.memory.counts_derivatives:
                tokens = with_derivatives_counted(tokens)
            if said.either and tokens[:1] in (("\\pm",), ("\\mp",)):
                tokens = tokens[1:]
            found = read_term(tokens, self.memory.author)
            if name := _times_zero(tokens, found.tree):
                return f"{name}(0) may be the value of {name} at 0, which the text does not state"
            return found
        except AmbiguityError as error:
            return TwoReadings(plain(str(error)))
        except InputError as error:
            return plain(str(error))


def _times_zero(tokens: Sequence[str], tree: Expr) -> str:
    """Return the name before ``(0)`` that was read as a factor of 0, as in ``x(0)/x_c``; nobody
    writes such a product."""
    for at in range(1, len(tokens) - 2):
        name = tokens[at - 1].lstrip("\\")
        valued = tuple(tokens[at : at + 3]) == ("(", "0", ")") and is_letter(tokens[at - 1])
        if valued and name != "pi" and re.search(rf"(?<![\w.])0\*{name}\b", str(tree)):
            return name
    return ""
