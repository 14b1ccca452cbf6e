"""Read a file of claims: one statement a line, with sections and prose between the statements.

The kinds of lines are, in the order in which they are tried:

======================================== ===================================================
``# Title``, ``## Section``              the title of the paper, and the titles of its sections
``@author NAME``, ``@abstract WORDS``    an author, the abstract
``@reference KEY WORDS``                 a work, which prose cites as ``[KEY]``
``% words``                              a comment, which appears in no document
``> words``                              prose, whatever it looks like
``M, e real; given 0 <= e < 1``          variables (real, integer, natural, positive), conditions
``u := EXPRESSION``, ``K(k) := …``       a definition of a quantity or of a function
``let two: a := x/y, x ~= 0.12``         definitions and conditions for claims ``… using two``
``assume law: CLAIM``                    an assumption, in force for all that follows
``use u, label from OTHER``              what the file OTHER.tresym defines and claims
``table LABEL: at e == 1/10, 1/100``     a table of errors of the claim LABEL
``chart LABEL``                          a chart of the error of the claim LABEL
``label: CLAIM``                         a claim, see :class:`PaperClaim`
anything else                            prose
======================================== ===================================================

Labels may be as in print: ``eq 1``, ``(3)``, ``Lemma 1.``, ``α``; they become one word, such as
``eq-1``. A line of prose with a relation in it, or one that looks like a declaration, is a problem
unless it begins with ``>``: nothing that was meant as a claim becomes prose in silence.

A variable of an earlier section may be declared again, and is then another variable; what stands
before the first section holds for the whole file. After a label, the place in print may stand in
brackets: ``d34 (34): …``. Words in square brackets behind a step of a derivation are not judged.

A line that begins with spaces continues the statement before it. A claim is written as for
``tresym check`` and may end in clauses, in any order: ``given CONDITIONS``, ``as PATH``,
``on REGION``, ``at x == 1/5, y == 1``, ``using LABEL, LABEL``, ``expect refuted`` and ``quoted from
(Author year)``. In a claim ``u ~= 1.1853`` the number is u rounded to the digits that are printed,
and ``a == b <= c`` is a derivation whose steps are decided one by one. A claim may be made of
others (:mod:`tresym.reals.language.compound`), and of labels: ``both: first and second``.

Every line that cannot be read gives one :class:`Problem`, and the other lines are read.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from tresym.papers.definitions import (
    Definition,
    as_called,
    define,
    expanded,
    names_in,
)
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import outermost
from tresym.reals.language.brackets import places, split
from tresym.reals.language.calls import INFINITY, INTEGERS, KNOWN
from tresym.reals.language.claims import UNIFORMLY, Written
from tresym.reals.language.comparisons import spread
from tresym.reals.language.compound import (
    SHAPES,
    Compound,
    Count,
    Formula,
    Leaf,
    Together,
    bound_names,
    comparisons_of,
    is_compound,
    leaves,
    mapped,
    read_compound,
    under,
)
from tresym.reals.language.differential_notation import with_differential_notation
from tresym.reals.language.expression import (
    DOTS,
    ORDERS,
    ZERO,
    Expr,
    add,
    apply,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.latex_tokens import GREEK
from tresym.reals.language.parsing import as_written, parse_claim, parse_given, sequences_of
from tresym.reals.language.paths import Path as LimitProcess
from tresym.reals.language.paths import read_path
from tresym.reals.language.readings import read_as
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError, parse_number
from tresym.reals.signs.definedness import undefined

MAX_BYTES = 2_000_000
"""The largest file that is read."""
MAX_DIGITS = 1000
"""The most digits of a table."""
DIGITS = 10
"""The digits of a table that states none."""
RESERVED = KNOWN | ORDERS | {"E", "I", "pi", "oo", "gamma", "EulerGamma", "Catalan", "GoldenRatio"}
RESERVED |= {
    *SHAPES,
    "sum",
    "product",
    "integral",
    "limit",
    "root",
    "at",
    "factorial",
    "binomial",
    "ZZ",
}
"""Names that the grammar knows, so that a file cannot give them another meaning."""
KINDS = {"real": (), "integer": (("in", INTEGERS),), "positive": ((">", ZERO),)}
KINDS["natural"] = (("in", INTEGERS), (">=", number(1)))

_NAME = r"[A-Za-z]\w*"
_HEADER = re.compile(r"@(\w+)\s*(.*)", re.DOTALL)
_HEADING = re.compile(r"(#{1,3})\s*(.*)")
_WORD = re.compile(_NAME)
_DECLARED = re.compile(
    rf"({_NAME}(?:\s*,\s*{_NAME})*)\s+({'|'.join(KINDS)})\s*(?:[;,]?\s*given\s+(.+?))?\s*;?"
)
_AND_GIVEN = re.compile(r";\s*(?:given\s)?")
_GIVEN = re.compile(r"given\s+(.+)")
DEFINED = re.compile(rf"({_NAME})\s*(?:\(([^()]*)\))?\s*:=\s*(.*)")
_DRAWN = re.compile(r"(table|chart)\s+([A-Za-z][\w-]*)\s*(?::\s*(.*))?")
_PLACE = r"(?:\s*\((\w[\w.]*)\)|\s*\[([^\]]*)\])?"
_STATED = rf"([A-Za-z][\w-]*){_PLACE}\s*:(?!=)\s*(.*)"
_CLAIM, _ASSUME, _LET = (re.compile(word + _STATED) for word in ("", r"assume\s+", r"let\s+"))
_OTHER_LABEL = re.compile(
    r"(\(?[^\W\d_][\w'-]*(?:[.\s]\s*[\w-]+)*\)?|\(?\d[\w.]*\)?)"
    r"(?:\s*:(?!=)|(?<=\d)\.\s)\s*(.*)"
)
"""A label as in print: ``eq 1``, ``(3)``, ``Lemma 1.``, ``α``, ``erfc.large``."""
_DECLARES = re.compile(
    r"(?:(?:let|assume|suppose|for all|for every)\s+)?"
    r"[A-Za-z](?:_?\d+)?(?:\s*,\s*[A-Za-z](?:_?\d+)?)*"
    r"(?:\s+(?:is|are|be|in|an?))*\s+(?:real|integer|natural|positive|NN|ZZ|RR|N|Z|R)s?"
    r"(?:\s+numbers?)?\s*[.;,]?(?:\s*given\b.*)?",
    re.IGNORECASE,
)
_RELATION = re.compile(r"[<>=≤≥≠~∼→≈]|->")
_UNLABELLED = re.compile(r"==|<=|>=|!=|:=|~=|->|[<>=~≤≥≠≈∼→]")
_ASSUMED = re.compile(r"(?:let|assume|suppose)\s+(?:that\s+)?([^:]*(?:[<>=≤≥≠]).*)", re.IGNORECASE)
_LETTER_E = re.compile(r"(?<![\w.])e(?!\w)")
_QUOTED = re.compile(r"\$[^$]*\$|`[^`]*`")
CLAUSE = r"\s(?:given|as|at(?!\s+some\s+point\b)|on|using|expect|instead|quoted\s+from)\s+"
_USE = re.compile(
    r"use\s+([A-Za-z][\w-]*(?:\s*,\s*[A-Za-z][\w-]*)*)\s+from\s+([\w-]+)(?:\.tresym)?"
)
_STANDS_AT = re.compile(r"\s{2,}\((\w[\w.]*)\)$")
_REASON = re.compile(
    r"(\S*)\s+\[[^\[\]]*\](?=\s*(?:$|[<>=!]=?\s|(?:and|given|as|at|on|using|expect|instead|quoted)\s))"
)
"""Words behind a step of a derivation; behind the word "in" they are an interval."""
_ROUNDED = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_USUAL = re.compile(r"[A-Za-z](?:_?\d+)?(?:_[A-Za-z0-9]*)?")
"""Variables that need no declaration: single letters, with an index or not."""


class Problem(NamedTuple):
    """What is wrong with a line of a file.

    Attributes:
        line, column: where, from 1.
        message: what is wrong and what to write instead.
    """

    line: int
    column: int
    message: str


class Value(NamedTuple):
    """A condition ``name == value`` of a clause ``at``."""

    name: str
    value: Expr


class Required(NamedTuple):
    """A declared condition that must hold in an interval, or near the end of a path."""

    link: Compared
    given: tuple[Compared, ...]
    path: str | None = None


@dataclass(frozen=True)
class PaperClaim:
    """A claim of a file, as it is written and as it is decided.

    Attributes:
        label: its name.
        line: where it stands in the file, from 1.
        text: the line as it is written, without the label.
        shown: the comparisons as written, with the names of definitions.
        links: the comparisons that are decided, with the definitions put in; for a derivation one
            for each step. All of them are claimed.
        given: its own conditions, as written.
        conditions: all conditions under which it is decided: its own, and the declared ones about
            its variables.
        path: the limit process of an asymptotic claim, such as ``e -> 0+``.
        at: the values of its clause ``at``.
        near_end: the conditions on the variable of the path. They must hold near the end of the
            path, and are then left out.
        must_hold: the declared conditions without variables once the values of ``at`` are put in.
        uses: the labels of claims above whose formulas are used.
        rests_on: the names of the definitions that stand in the claim.
        expect_refuted: whether the file says that the claim is false.
        source: whom the claim is quoted from; "" for the paper's own.
        rounded: the number as printed, for ``~=``.
        uniformly: whether an order is claimed with one constant for all its parameters.
        on: the region for which the constant of an order is claimed.
        whole: a claim that is made of claims, which then has no links.
        said: its formula as written, with the names of definitions.
        joined: the labels of claims that are claimed again, as in ``both: first and other``.
        required: declared conditions that must hold where such a claim speaks.
        place: where it stands in print, such as the number of an equation.
        assumed: whether it is assumed, and not judged.
        restricted: the labels of assumptions that relate its variables without being conditions,
            as the value of an integral does: at a point that refutes it they need not hold.
        instead: the labels of claims that hold instead of a false one.
    """

    label: str
    line: int
    text: str
    shown: tuple[Compared, ...]
    links: tuple[Compared, ...]
    given: tuple[Compared, ...] = ()
    conditions: tuple[Compared, ...] = ()
    path: str | None = None
    at: tuple[Value, ...] = ()
    near_end: tuple[Compared, ...] = ()
    must_hold: tuple[Compared, ...] = ()
    uses: tuple[str, ...] = ()
    rests_on: tuple[str, ...] = ()
    expect_refuted: bool = False
    source: str = ""
    rounded: str = ""
    uniformly: bool = False
    on: tuple[Compared, ...] = ()
    whole: Compound | None = None
    said: Formula | None = None
    joined: tuple[str, ...] = ()
    required: tuple[Required, ...] = ()
    place: str = ""
    assumed: bool = False
    restricted: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()

    @property
    def kind(self) -> str:
        """What it is, in one word."""
        if self.assumed:
            return "assumption"
        return "derivation" if self.is_derivation else "claim"

    @property
    def asked(self) -> tuple[tuple[str, str, str | None], ...]:
        """What is decided of the claim: texts with conditions and path, as for ``tresym check``."""
        if self.whole is not None:
            return ((str(self.whole), "", None),)
        given = chained(self.conditions)
        return tuple((self.asserted(link), given, self.path) for link in self.links)

    @property
    def comparisons(self) -> tuple[Compared, ...]:
        """What is claimed at points: the links, or those of all parts of a conjunction."""
        whole = self.whole
        if whole is None or not isinstance(whole.formula, Together):
            return self.links
        parts = [part for part in whole.formula.parts if isinstance(part, Written)]
        if len(parts) < len(whole.formula.parts) or any(part.path for part in parts):
            return ()
        return tuple(link for part in parts for link in part.comparisons)

    @property
    def meanings(self) -> tuple[str, ...]:
        """What is claimed, without conditions, with the definitions put in."""
        parts = [chained((link,)) for link in self.links]
        return (*parts, *(() if self.whole is None else (str(self.whole),)), *self.joined)

    def asserted(self, link: Compared) -> str:
        """Return a comparison of the claim as text for ``tresym check``."""
        text = chained((link,)) + (" uniformly" if self.uniformly else "")
        return f"{text} on {chained(self.on)}" if self.on else text

    @property
    def is_derivation(self) -> bool:
        """Whether the claim is a chain of several relations."""
        return len(self.links) > 1

    @property
    def has_parameters(self) -> bool:
        """Whether the claim is an order or a limit with variables besides that of its path."""
        if self.path is None:
            return False
        names = frozenset().union(*map(_names, self.links)) - {INFINITY.args[0]}
        return bool(names - {read_path(self.path).name})

    @property
    def asymptotic(self) -> tuple[Expr, Expr, Expr | None] | None:
        """The exact side, the approximation and the order's comparison function, if it has them."""
        if len(self.links) != 1:
            return None
        left, relation, right = self.links[0]
        if relation not in ("==", "~", "<=", "<"):
            return None
        right = spread(right)
        terms = right.args if right.op == "+" else (right,)
        orders = [term for term in terms if term.op in ORDERS]
        if relation in ("<=", "<"):
            return (*_difference(left), right) if left.op == "abs" else None
        rest = add(*(term for term in terms if term not in orders)) if orders else right
        return left, rest, orders[0].args[0] if orders else None


def _difference(left: Expr) -> tuple[Expr, Expr]:
    """|A − B| as A and B: the first term, and the others with the opposite sign."""
    inner = left.args[0]
    terms = inner.args if inner.op == "+" else (inner,)
    return terms[0], -add(*terms[1:]) if terms[1:] else ZERO


class Prose(NamedTuple):
    """A paragraph of words."""

    line: int
    text: str


class Section(NamedTuple):
    """The title of a section."""

    line: int
    title: str


class Declaration(NamedTuple):
    """Variables of one kind, and conditions on them."""

    line: int
    names: tuple[str, ...]
    kind: str
    given: tuple[Compared, ...]


class Drawn(NamedTuple):
    """A table or a chart of a claim.

    Attributes:
        kind: ``"table"`` or ``"chart"``.
        label: of the claim.
        at: for each variable the values at which it is shown.
        digits: the digits that are printed.
    """

    line: int
    kind: str
    label: str
    at: tuple[tuple[str, tuple[Expr, ...]], ...]
    digits: int


class Let(NamedTuple):
    """Definitions and conditions that are put in where a claim says ``using LABEL``."""

    line: int
    label: str
    definitions: tuple[Definition, ...]
    given: tuple[Compared, ...]
    place: str = ""


Item = Prose | Section | Declaration | Definition | PaperClaim | Drawn | Let


@dataclass
class Header:
    """What stands at the head and at the end of a paper beside its title.

    Attributes:
        authors: their names.
        abstract: the abstract, its paragraphs separated by line breaks.
        references: the works that are cited, by key.
    """

    authors: list[str] = field(default_factory=list)
    abstract: str = ""
    references: dict[str, str] = field(default_factory=dict)

    def add(self, kind: str, words: str) -> None:
        """Read one line of the header.

        Raises:
            InputError: there is no such line, or its words are missing.
        """
        if kind not in ("author", "abstract", "reference"):
            raise InputError(
                f"'@{kind}' is not known: write @author NAME, @abstract WORDS or "
                f"@reference KEY WORDS; begin a line of prose with >"
            )
        if not words:
            raise InputError(f"@{kind} needs words after it")
        if kind == "author":
            self.authors.append(words)
        elif kind == "abstract":
            self.abstract = f"{self.abstract}\n{words}".strip()
        else:
            key, _, work = words.partition(" ")
            if not work.strip():
                raise InputError("a reference needs a key and words: @reference Olver1974 F. W. …")
            if key in self.references:
                raise InputError(f"{key} is the key of another reference already")
            self.references[key] = work.strip()


@dataclass(frozen=True)
class OwnPaper:
    """A file of claims as it was read.

    Attributes:
        name: the name of the file.
        title: its title; the name of the file if it states none.
        items: its statements and its prose in order.
        problems: what could not be read.
        header: authors, abstract and references.
    """

    name: str
    title: str
    items: tuple[Item, ...]
    problems: tuple[Problem, ...]
    header: Header = field(default_factory=Header)

    @cached_property
    def claims(self) -> Mapping[str, PaperClaim]:
        """The claims by their labels, in order."""
        return {item.label: item for item in self.items if isinstance(item, PaperClaim)}

    @cached_property
    def definitions(self) -> Mapping[str, Definition]:
        """The definitions by their names, in order."""
        return {item.name: item for item in self.items if isinstance(item, Definition)}

    def chosen(self, labels: Iterable[str]) -> tuple[PaperClaim, ...]:
        """Return the claims of these labels, or all if there are none.

        Raises:
            InputError: a label that no claim has.
        """
        found = []
        for label in dict.fromkeys(labels):
            label = label if label in self.claims else label_of(label)
            if label not in self.claims:
                raise InputError(
                    f"{self.name}: no claim is labelled {label}{near(label, self.claims)}"
                )
            found.append(self.claims[label])
        return tuple(found) or tuple(self.claims.values())

    def drawn(self, kind: str, label: str | None = None) -> tuple[Drawn, ...]:
        """Return the tables or charts that the file asks for, of one claim or of all."""
        return tuple(
            item
            for item in self.items
            if isinstance(item, Drawn) and item.kind == kind and label in (None, item.label)
        )


def read_file(path: str | Path, files: tuple[str, ...] = ()) -> OwnPaper:
    """Read a file of claims, and those that it uses.

    Raises:
        InputError: there is no such file, or it is not text.
    """
    try:
        with Path(path).open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise InputError(f"{path}: no such file") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    if len(data) > MAX_BYTES:
        raise InputError(f"{path}: a file of claims has at most {MAX_BYTES} bytes")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise InputError(f"{path}:{line}: this is not UTF-8 text") from None
    if "\0" in text:
        raise InputError(f"{path}: this is not a text file")
    return read_paper(text, Path(path).name, Path(path).parent, files)


def read_paper(
    text: str,
    name: str = "paper.tresym",
    folder: Path | None = None,
    files: tuple[str, ...] = (),
) -> OwnPaper:
    """Read the text of a file of claims.

    Args:
        text: the text.
        name: the name of the file.
        folder: where the files are that it uses.
        files: the names of the files that use this one.

    Example:
        >>> found = read_paper("a real\\nsquare: a**2 >= 0\\nwrong line: a** >= 0")
        >>> list(found.claims), [problem.line for problem in found.problems]
        (['square'], [3])
    """
    return Reader(name, folder, files).read(text)


class _OneNameError(InputError):
    """One name of a declaration is refused; the others are declared."""


class Reader:
    """Read the lines of a file from top to bottom; what is declared holds from there on."""

    clause = CLAUSE
    """The words that begin a clause of a claim."""

    def __init__(self, name: str, folder: Path | None = None, files: tuple[str, ...] = ()) -> None:
        self.name = name
        self.title = ""
        self.header = Header()
        self.items: list[Item] = []
        self.problems: list[Problem] = []
        self.declared: dict[str, int] = {}
        self.given: list[Compared] = []
        self.definitions: dict[str, Definition] = {}
        self.used: dict[str, int] = {}
        """Where a variable or a function stands first."""
        self.claims: dict[str, PaperClaim] = {}
        self.failed: dict[str, int] = {}
        """Names and labels of lines that could not be read, whose uses need no second message."""
        self.lets: dict[str, Let] = {}
        self.assumed: dict[Compared, str] = {}
        """The assumptions in force, with their labels."""
        self.put_in: dict[Expr, Expr] = {}
        """Integrals and sums whose values are assumed."""
        self.replaced_in_claim: set[Expr] = set()
        """Those of them that stand in the claim which is read."""
        self.section = 0
        self.section_of: dict[str, int] = {}
        self.stale: dict[str, str] = {}
        """Definitions with a variable that is another one by now, and why."""
        self.taken: dict[tuple[str, str], int] = {}
        self.folder = folder
        self.files = files

    def read(self, text: str) -> OwnPaper:
        for line, statement in statements_of(text):
            try:
                self._statement(line, statement)
            except _OneNameError as error:
                self._problem(line, "", str(error), text)
            except InputError as error:
                self._problem(line, statement, str(error), text)
        self._need_labels(text)
        self.problems.sort()
        title = self.title or Path(self.name).stem
        problems = tuple(self.problems)
        return OwnPaper(self.name, title, tuple(self.items), problems, self.header)

    def _problem(self, line: int, statement: str, message: str, text: str) -> None:
        match = DEFINED.fullmatch(statement) or _CLAIM.match(statement)
        names = [match[1]] if match else []
        if declared := _DECLARED.fullmatch(statement) or _GIVEN.fullmatch(statement):
            names = _WORD.findall(declared[0])
        for name in names:
            if name not in {*self.definitions, *self.claims} and (
                declared or name not in self.declared
            ):
                self.failed.setdefault(name, line)
        first = text.split("\n")[line - 1]
        column = len(first) - len(first.lstrip()) + 1
        quoted = re.search(r"'([^']+)'", message)
        words = [quoted[1]] if quoted else []
        words += [message.split()[0].rstrip(":,")] if message.split() else []
        for word in words:
            stands = first.find(word)
            if stands >= 0:
                column = stands + 1
                break
        self.problems.append(Problem(line, column, message))

    def _need_labels(self, text: str) -> None:
        """Every table and every chart needs its claim, which may stand below it."""
        for item in list(self.items):
            if isinstance(item, Drawn) and item.label not in self.claims:
                self.items.remove(item)
                if item.label not in self.failed:
                    why = f"no claim is labelled {item.label}{near(item.label, self.claims)}"
                    self._problem(item.line, item.label, f"{item.kind}: {why}", text)

    def _statement(self, line: int, text: str) -> None:
        if match := _HEADER.fullmatch(text):
            self.header.add(match[1], match[2])
        elif match := _HEADING.fullmatch(text):
            if not match[2]:
                raise InputError("a heading needs a title: # Title, or ## Section")
            if len(match[1]) == 1 and not self.title:
                self.title = match[2]
            else:
                self.items.append(Section(line, match[2]))
                self.section += 1
        elif text.startswith(">"):
            self._prose(line, text[1:].strip())
        elif match := _DECLARED.fullmatch(text):
            self._declare(line, match[1], match[2], match[3] or "")
        elif match := _GIVEN.fullmatch(text):
            self._conditions(line, (), "", match[1])
        elif match := DEFINED.fullmatch(text):
            self._define(line, match[1], match[2], match[3])
        elif match := _DRAWN.fullmatch(text):
            self.items.append(_drawn(line, match[1], match[2], match[3] or ""))
        elif match := _LET.fullmatch(text):
            self._let(line, match[1], match[2] or match[3] or "", match[4])
        elif match := _ASSUME.fullmatch(text):
            self._claim(line, match[1], match[4], match[2] or match[3] or "", assumed=True)
        elif match := _USE.fullmatch(text):
            self._use(line, re.split(r"\s*,\s*", match[1]), match[2])
        elif match := _CLAIM.fullmatch(text):
            self._claim(line, match[1], match[4], match[2] or match[3] or "")
        elif (match := _OTHER_LABEL.fullmatch(text)) and _is_formula(match[2]):
            self._claim(line, label_of(match[1]), match[2])
        elif _DECLARES.fullmatch(text):
            raise InputError(
                f"'{text[:60]}' looks like a declaration: write 'x real', 'n integer' or "
                f"'n natural'; begin a line of prose with >, as in > {text[:20]}"
            )
        elif match := _ASSUMED.fullmatch(text):
            raise InputError(
                f"'{match[1]}' looks like a condition: write given {match[1]}; begin a line of "
                f"prose with >, as in > {text[:20]}"
            )
        elif unlabelled := _UNLABELLED.search(_QUOTED.sub("", text)):
            raise InputError(
                f"the line contains '{unlabelled[0]}' but has no label: write a claim as "
                f"label: {text[:60]}; begin a line of prose with >, as in > {text[:20]} …"
            )
        elif _is_comparison(text):
            raise InputError(
                f"'{text[:60]}' has no label: write a condition as given {text[:60]}, and a claim "
                f"as label: {text[:60]}"
            )
        else:
            self._prose(line, text)

    def _prose(self, line: int, text: str) -> None:
        last = self.items[-1] if self.items else None
        if isinstance(last, Prose) and last.line + last.text.count("\n") + 1 == line:
            self.items[-1] = Prose(last.line, f"{last.text}\n{text}")
        else:
            self.items.append(Prose(line, text))

    def _declare(self, line: int, written: str, kind: str, given: str) -> None:
        names: list[str] = []
        refused: list[InputError] = []
        for name in (name.strip() for name in written.split(",")):
            try:
                self._need_new(name)
                names.append(name)
            except InputError as error:
                refused.append(error)
        self._conditions(line, tuple(names), kind, given)
        if refused:
            raise _OneNameError(str(refused[0]))

    def _conditions(self, line: int, names: tuple[str, ...], kind: str, given: str) -> None:
        given = ", ".join(filter(None, (part.strip() for part in _AND_GIVEN.split(given))))
        written = tuple(parse_given(plain(self._called(given))))
        known = {*self.declared, *names, *self.definitions}
        for side in (side for link in written for side in link[::2]):
            self._need_known(symbols(side) - {INTEGERS.args[0]}, known)
            self._uses(line, side)
        own = tuple((symbol(name), *rest) for name in names for rest in KINDS.get(kind, ()))
        self.declared |= dict.fromkeys(names, line)
        self.section_of |= dict.fromkeys(names, self.section)
        self.given += [*own, *(self._expanded(link) for link in written)]
        self.items.append(Declaration(line, names, kind, written))

    def _need_new(self, name: str) -> None:
        if name in RESERVED:
            raise InputError(
                f"{name} has a meaning of its own in claims, so it cannot be defined or declared: "
                f"use another name, such as {name}0 or {name}_1"
            )
        if name in self.declared and 0 < self.section_of.get(name, 0) < self.section:
            self._forget(name)
        if name in self.declared:
            raise InputError(f"{name} is declared on line {self.declared[name]} already")
        if name in self.definitions:
            line = self.definitions[name].line
            raise InputError(f"{name} is defined on line {line} already: use another name")

    def _need_known(self, names: Iterable[str], more: Iterable[str] = ()) -> None:
        """Every name is declared, defined, or one of the usual letters."""
        known = {*self.declared, *self.definitions, *more}
        for name in sorted(names):
            if name in self.stale:
                raise InputError(f"{name} contains {self.stale[name]}: define {name} again")
            if name in self.failed and name not in self.claims:
                raise InputError(f"{name} stands on line {self.failed[name]}, which is not read")
            if name not in known and not _USUAL.fullmatch(name) and name.rstrip("_") not in GREEK:
                raise InputError(
                    f"{name} is not declared{near(name, known)}: write the line '{name} real' "
                    f"above, or write * between the factors of a product"
                )

    def _expanded(self, link: Compared) -> Compared:
        left, relation, right = link
        if relation == "in":
            return link
        return self._put(left), relation, self._put(right)

    def _put(self, e: Expr) -> Expr:
        """An expression with definitions and assumed values put in."""
        e = expanded(e, self.definitions)
        if not self.put_in or not e.hidden:
            return e
        self.replaced_in_claim |= {node for node in outermost(e) if node in self.put_in}
        return replaced(e, self.put_in)

    def _define(self, line: int, name: str, arguments: str | None, text: str) -> None:
        self._need_new(name)
        if name in self.used:
            raise InputError(f"{name} is used on line {self.used[name]}, above its definition")
        place = _STANDS_AT.search(text)
        text = text[: place.start()] if place else text
        made = self._definition(line, name, arguments, text)
        self.definitions[name] = replace(made, place=place[1] if place else "")
        self.items.append(self.definitions[name])

    def _definition(self, line: int, name: str, arguments: str | None, text: str) -> Definition:
        if not text:
            raise InputError(f"{name} := needs an expression after it")
        parameters = tuple(a.strip() for a in arguments.split(",")) if arguments is not None else ()
        for parameter in parameters:
            if not re.fullmatch(_NAME, parameter) or parameter in RESERVED:
                raise InputError(
                    f"'{parameter}' cannot be the argument of a function: use a letter"
                )
        written = as_written(plain(self._called(text)))
        self._need_known(symbols(written) - {*parameters} - {INFINITY.args[0], DOTS.args[0]})
        if name in names_in(written) - {*parameters}:
            raise InputError(
                f"{name} stands in its own definition: define a solution of an equation by "
                f"{name} := root(f, x, a, b), the zero of f between a and b"
            )
        inside = {n: d for n, d in self.definitions.items() if n not in parameters}
        made = define(line, name, parameters, text, written, inside)
        self._need_functions((made.expression,))
        self._uses(line, written, parameters)
        return replace(made, given=self._about(made.expression, ()))

    def _uses(self, line: int, e: Expr, bound: tuple[str, ...] = ()) -> None:
        """What stands in a claim, a condition or a definition cannot be defined below it."""
        for name in names_in(e) - {*bound}:
            self.used.setdefault(name, line)

    def _called(self, text: str) -> str:
        """The text with defined functions under names that the grammar takes for functions."""
        for name, why in self.stale.items():
            if re.search(rf"(?<![\w\\]){re.escape(name)}\s*\(", text):
                raise InputError(f"{name} contains {why}: define {name} again")
        for name, line in self.failed.items():
            if re.search(rf"(?<![\w\\]){re.escape(name)}\s*\(", text):
                raise InputError(f"{name} stands on line {line}, which is not read")
        return as_called(text, (d.name for d in self.definitions.values() if d.parameters))

    def _need_functions(self, trees: Iterable[Expr]) -> None:
        for tree in trees:
            for name in sorted(symbols(tree) & {*self.definitions}):
                if self.definitions[name].parameters:
                    raise InputError(
                        f"{name} is a function: write {self.definitions[name].head}, and its "
                        f"square as {self.definitions[name].head}**2"
                    )
            for node in functions(tree):
                name = node.args[0].args[0]
                if name in self.definitions or name in self.declared:
                    raise InputError(
                        f"{name} is no function: write {name}*(…) for a product, or define "
                        f"{name}(x) := …"
                    )
                if name.startswith("fn_") and name[3:] in self.definitions:
                    raise InputError(f"{name[3:]} is used with another number of arguments")

    def _about(self, e: Expr, more: Iterable[Compared]) -> tuple[Compared, ...]:
        """The declared conditions about the variables of ``e``, and about those of conditions."""
        return _connected(symbols(e), self.given, more)

    def _claim(
        self, line: int, label: str, written: str, place: str = "", assumed: bool = False
    ) -> None:
        self._need_new_label(label)
        text, clauses = clauses_of(_REASON.sub(_without_reason, written), self.clause)
        lets = self._lets_in(clauses)
        self.replaced_in_claim = set()
        with self._within(lets):
            self._claimed(line, label, written, text, clauses, place, assumed)

    def _claimed(
        self,
        line: int,
        label: str,
        written: str,
        text: str,
        clauses: dict[str, str],
        place: str,
        assumed: bool,
    ) -> None:
        text, joined = self._joined(text)
        if not joined and not _RELATION.search(text) and not is_compound(text):
            raise InputError(
                f"{label}: no relation such as == <= ~ -> follows, so this is not a claim; "
                f"write prose that begins with a word and a colon as > {label}: …"
            )
        uses = tuple(
            used
            for part in filter(None, map(str.strip, clauses.get("using", "").split(",")))
            for used in ((label_of(part),) if label_of(part) in self.claims else part.split())
        )
        for used in uses:
            if used not in self.claims:
                raise InputError(
                    f"no claim above this line is labelled '{used}'{near(used, self.claims)}"
                )
        instead = tuple(filter(None, map(str.strip, clauses.get("instead", "").split(","))))
        for other in instead:
            if other not in self.claims:
                raise InputError(f"no claim above this line is labelled '{other}'")
        source, expect = clauses.get("quoted from", ""), clauses.get("expect", "")
        if expect.lower() not in ("", "refuted"):
            raise InputError(f"'{expect}': only 'expect refuted' can be expected of a claim")
        if text:
            claim = self._formula(label, line, text, clauses)
        else:
            claim = PaperClaim(label, line, text, (), ())
        claim = replace(
            claim,
            text=written,
            uses=tuple(dict.fromkeys((*uses, *joined, *self._assumptions(claim)))),
            joined=joined,
            place=place,
            assumed=assumed,
            restricted=() if assumed else self._restrictions(claim),
            instead=instead,
            expect_refuted=bool(expect),
            source=source.strip().strip("()"),
        )
        cited = tuple(link for used in uses for link in self._cited(claim, self.claims[used]))
        if cited and claim.whole is not None:
            whole = claim.whole
            formula = under(whole.formula, lambda part: (*next(leaves(part)).given, *cited))
            claim = replace(claim, whole=whole._replace(formula=formula, given=_common(formula)))
        claim = replace(claim, conditions=(*claim.conditions, *cited))
        for task in claim.links:
            read(claim.asserted(task), chained(claim.conditions), claim.path)
        if claim.whole is not None:
            read_compound(str(claim.whole))
        if assumed:
            self._assume(claim)
        self.claims[label] = claim
        self.items.append(claim)

    def _need_new_label(self, label: str) -> None:
        for known in (self.claims, self.lets):
            if label in known:
                raise InputError(f"{label} is the label of line {known[label].line} already")

    def _let(self, line: int, label: str, place: str, written: str) -> None:
        """Definitions and conditions that are put in only where a claim says so."""
        self._need_new_label(label)
        made: dict[str, Definition] = {}
        given: list[Compared] = []
        for part in (part.strip() for part in split(written, ",")):
            match = DEFINED.fullmatch(part)
            with self._within([Let(line, label, tuple(made.values()), ())]):
                if match is None:
                    links = parse_given(plain(self._called(part)))
                    for side in (side for link in links for side in link[::2]):
                        self._need_known(symbols(side) - {INTEGERS.args[0]})
                        self._uses(line, side)
                    given += links
                    continue
                if match[1] in RESERVED or match[1] in self.definitions:
                    raise InputError(f"'{match[1]}' has another meaning already: use another name")
                if any(link[1] == "in" and match[1] in symbols(link[0]) for link in self.given):
                    raise InputError(f"'{match[1]}' is declared as an integer: use another name")
                made[match[1]] = self._definition(line, match[1], match[2], match[3])
        self.lets[label] = Let(line, label, tuple(made.values()), tuple(given), place)
        self.items.append(self.lets[label])

    def _lets_in(self, clauses: dict[str, str]) -> list[Let]:
        """The lines ``let`` that a claim names after using or given; the names are taken out."""
        found: dict[str, Let] = {}
        for word in ("using", "given"):
            parts = [part.strip() for part in split(clauses.get(word, ""), ",")]
            found |= {part: self.lets[part] for part in parts if part in self.lets}
            rest = ", ".join(part for part in parts if part and part not in self.lets)
            if word in clauses:
                clauses[word] = rest
        links = [chained(let.given) for let in found.values() if let.given]
        if links:
            clauses["given"] = ", ".join(filter(None, (clauses.get("given", ""), *links)))
        return list(found.values())

    @contextmanager
    def _within(self, lets: Iterable[Let]) -> Iterator[None]:
        """Read with the definitions of lines ``let``, which hold for conditions, too."""
        kept = self.definitions, self.given
        own = {made.name: made for let in lets for made in let.definitions}
        try:
            if own:
                put = {name: made.expression for name, made in own.items() if not made.parameters}
                known = {name: _with_put_in(made, put) for name, made in self.definitions.items()}
                self.definitions = {**known, **own}
                self.given = [self._expanded(link) for link in self.given]
            yield
        finally:
            added = self.given[len(kept[1]) :]
            self.definitions, self.given = kept
            self.given += added

    def _assume(self, claim: PaperClaim) -> None:
        """Let an assumption hold for all that follows: a condition, or the value of an integral."""
        if not claim.links or claim.given or claim.path or claim.at or claim.expect_refuted:
            raise InputError(
                f"'{claim.label}' is assumed for all that follows, so it is a comparison without "
                "clauses: declare its conditions above"
            )
        for link in claim.links:
            left, relation, right = link
            try:
                parse_given(chained((link,)))
            except InputError:
                if relation != "==" or left.op not in ("integral", "sum", "product", "limit"):
                    raise InputError(
                        f"'{claim.label}' is no condition: an assumption is a comparison of "
                        "elementary expressions, or gives the value of an integral or a sum"
                    ) from None
                self.put_in[left] = right
                self.assumed[link] = claim.label
            else:
                self.given.append(link)
                self.assumed[link] = claim.label

    def _assumptions(self, claim: PaperClaim) -> list[str]:
        """The labels of the assumptions that are conditions of a claim, or put into it."""
        put = {value.name: expanded(value.value, self.definitions) for value in claim.at}
        said, used = {*claim.conditions, *claim.must_hold}, {*self.replaced_in_claim}
        found = []
        for link, label in self.assumed.items():
            left, relation, right = self._expanded(link)
            fixed = substitute(left, put), relation, substitute(right, put)
            ways = link, (left, relation, right), fixed
            if not said.isdisjoint(ways) or link[0] in used:
                found.append(label)
        return found

    def _restrictions(self, claim: PaperClaim) -> tuple[str, ...]:
        """The labels of assumed values of integrals and sums that relate variables of a claim."""
        links = [*claim.links, *claim.conditions]
        if claim.whole is not None:
            links += [link for leaf in leaves(claim.whole.formula) for link in comparisons_of(leaf)]
        names = frozenset().union(*map(_names, links))
        return tuple(
            label
            for link, label in self.assumed.items()
            if link[0] in self.put_in and _names(self._expanded_once(link)) & names
        )

    def _expanded_once(self, link: Compared) -> Compared:
        """An assumption with the definitions put in that hold where a claim is read."""
        left, relation, right = link
        return expanded(left, self.definitions), relation, expanded(right, self.definitions)

    def _use(self, line: int, names: Iterable[str], file: str) -> None:
        """Take definitions and claims from another file of the same folder, with what they need."""
        if self.folder is None:
            raise InputError(f"use … from {file}: a text without a folder uses no other file")
        if file in (*self.files, Path(self.name).stem):
            raise InputError(f"{file} uses this file: files cannot use one another in a circle")
        other = read_file(self.folder / f"{file}.tresym", (*self.files, Path(self.name).stem))
        if other.problems:
            problem = other.problems[0]
            raise InputError(f"{file}.tresym, line {problem.line}: {problem.message}")
        for name in names:
            if name not in other.definitions and name not in other.claims:
                known = [*other.definitions, *other.claims]
                raise InputError(f"{name} is not in {file}.tresym{near(name, known)}")
            self._take(line, name, other)

    def _take(self, line: int, name: str, other: OwnPaper) -> None:
        taken = self.taken.get((other.name, name))
        if taken is not None:
            return
        self.taken[other.name, name] = line
        if name in other.definitions:
            made = other.definitions[name]
            for inner in sorted(names_in(made.written) & {*other.definitions}):
                self._take(line, inner, other)
            self._need_new(name)
            self._conditions_from(line, made.given)
            self.definitions[name] = replace(made, line=line)
            self.items.append(self.definitions[name])
            return
        claim = other.claims[name]
        for inner in (*claim.rests_on, *claim.uses):
            if inner in other.definitions or inner in other.claims:
                self._take(line, inner, other)
        self._need_new_label(name)
        self.claims[name] = replace(claim, line=line)
        self.items.append(self.claims[name])

    def _conditions_from(self, line: int, given: Iterable[Compared]) -> None:
        """Take over the conditions of a definition of another file."""
        new = tuple(link for link in given if link not in self.given)
        if new:
            self.given += new
            self.items.append(Declaration(line, (), "", new))

    def _forget(self, name: str) -> None:
        """Let a variable of an earlier section be another one from here on."""
        at = self.declared.pop(name)
        self.given = [link for link in self.given if name not in _names(link)]
        for link in [link for link in self.assumed if name in _names(link)]:
            self.put_in.pop(link[0], None)
            del self.assumed[link]
        for other in [d for d in self.definitions.values() if name in names_in(d.written)]:
            if name not in other.parameters:
                why = f"the variable {name} of line {at}, which was declared again since"
                self.stale[other.name] = why
        self.used.pop(name, None)

    def _joined(self, text: str) -> tuple[str, tuple[str, ...]]:
        """A formula without the parts that are labels of claims above, and these labels."""
        parts = [part.strip() for part in split(text, r"\band\b")]
        known = [part for part in parts if part in self.claims]
        names = {*self.declared, *self.definitions}
        if not known or any(part in names for part in known):
            return text, ()
        for label in known:
            if self.claims[label].expect_refuted:
                raise InputError(f"'{label}' is expected to be refuted, so it cannot be claimed")
        return " and ".join(part for part in parts if part not in known), tuple(known)

    def _cited(self, claim: PaperClaim, used: PaperClaim) -> tuple[Compared, ...]:
        """The formulas of a claim that is used, which must hold under the same conditions."""
        if used.path is not None:
            raise InputError(f"'{used.label}' is asymptotic: only claims at points can be used")
        if used.expect_refuted:
            raise InputError(f"'{used.label}' is expected to be refuted, so it cannot be used")
        for link in used.conditions:
            if link not in claim.conditions:
                shown = chained((link,))
                raise InputError(
                    f"'{used.label}' holds given {shown}: add this condition to the claim"
                )
        where = Given(tuple(c for c in claim.conditions if c[1] not in ("==", "in"))).unfolded()
        links = used.comparisons
        if not links:
            raise InputError(f"'{used.label}' is no comparison: only comparisons can be used")
        for link in links:
            parse_given(chained((link,)))
            for side in link[::2]:
                gap = undefined(side, where)
                if gap is not None:
                    raise InputError(
                        f"'{used.label}' says nothing where {side} has no value, which is not "
                        f"excluded here ({gap}): add a condition to the claim"
                    )
        return links

    def _formula(self, label: str, line: int, text: str, clauses: Mapping[str, str]) -> PaperClaim:
        """The formula of a claim, with its conditions, its path and the values of its variables."""
        uniformly = UNIFORMLY.search(text) is not None
        called, said = with_differential_notation(
            self._called(UNIFORMLY.sub("", text)), self._called(clauses.get("given", ""))
        )
        if is_compound(called):
            return self._made_of_claims(label, line, called, said, clauses)
        rounded = ""
        in_words: tuple[Compared, ...] = ()
        if "~=" in called or "≈" in called:
            left, rounded = _rounded(called)
            comparisons = [(as_written(plain(left)), "~=", number(parse_number(rounded)))]
        else:
            comparisons, in_words = _compared(called, sequences_of(said))
            known = {*self.declared, *self.definitions, *re.findall(_NAME, said)}
            known |= set(re.findall(_NAME, clauses.get("as", "").partition("->")[0]))
            if "e" in known and _LETTER_E.search(called):
                read_e = any("e" in symbols(side) for link in comparisons for side in link[::2])
                if not read_e:
                    raise InputError(
                        "two readings remain: e is a variable here, so write exp(x) or E**x for "
                        "the exponential function, or the variable e by another name"
                    )
        given = tuple(parse_given(plain(said)))
        given = (*in_words, *given)
        path = read_path(clauses["as"]) if "as" in clauses else None
        region = tuple(parse_given(plain(self._called(clauses.get("on", "")))))
        values = tuple(_values(clauses["at"])) if "at" in clauses else ()
        trees = [side for link in (*comparisons, *given, *region) for side in link[::2]]
        trees += [value for _, value in values]
        if path is not None and path.name in {value.name for value in values}:
            raise InputError(f"'{path.name}' is the variable of the path, so it has no fixed value")
        for tree in trees:
            self._uses(line, tree)
        own = {INFINITY.args[0], DOTS.args[0], INTEGERS.args[0]}
        self._need_known(frozenset().union(*map(symbols, trees), (v.name for v in values)) - own)
        links = tuple(self._expanded(link) for link in comparisons)
        conditions = tuple(self._expanded(link) for link in given)
        self._need_functions(side for link in (*links, *conditions) for side in link[::2])
        about = add(*(side for link in links for side in link[::2] if side.op not in own))
        about_names = symbols(about) | ({path.name} if path else frozenset())
        about_names |= {value.name for value in values}
        everything = _connected(about_names, self.given, conditions)
        put = {value.name: expanded(value.value, self.definitions) for value in values}
        links, everything, must = _put_in(links, everything, put)
        near = _near_the_end(path, everything)
        links = tuple(_rounding(link, rounded) for link in links) if rounded else links
        names = frozenset().union(*map(names_in, trees))
        rests = tuple(name for name in self.definitions if name in names)
        return PaperClaim(
            label,
            line,
            text,
            tuple(comparisons),
            links,
            given,
            tuple(c for c in everything if c not in near),
            None if path is None else str(path),
            values,
            near,
            must,
            rests_on=rests,
            rounded=rounded,
            uniformly=uniformly,
            on=tuple(self._expanded(link) for link in region),
        )

    def _made_of_claims(
        self, label: str, line: int, called: str, conditions: str, clauses: Mapping[str, str]
    ) -> PaperClaim:
        """A claim that is made of claims: each part under the conditions about its variables."""
        region = self._called(clauses.get("on", ""))
        text = called + (f" given {conditions}" if conditions else "")
        whole = read_compound(text + (f" on {region}" if region else ""), "", clauses.get("as"))
        if whole is None:
            raise InputError(f"'{called}' is not read as a claim")
        parts = list(leaves(whole.formula))
        values = tuple(_values(clauses["at"])) if "at" in clauses else ()
        links = [link for part in parts for link in (*comparisons_of(part), *part.given)]
        trees = [side for link in links for side in link[::2]] + [value for _, value in values]
        bound = tuple(part.name for part in parts if isinstance(part, Count))
        for tree in trees:
            self._uses(line, tree, bound)
        names = frozenset().union(*map(symbols, trees), (v.name for v in values))
        self._need_known(names - {INFINITY.args[0], DOTS.args[0], INTEGERS.args[0]}, bound)
        for name in (name for part in parts for name in bound_names(part)):
            if name in self.definitions:
                at = self.definitions[name].line
                raise InputError(f"{name} is defined on line {at}: use another letter here")
        formula = mapped(whole.formula, self._put)
        self._need_functions(
            side for part in leaves(formula) for link in comparisons_of(part) for side in link[::2]
        )
        required: list[Required] = []
        must: list[Compared] = []

        def found(part: Formula) -> tuple[Compared, ...]:
            return self._conditions_of(part, values, required, must)

        formula = under(formula, found)
        if put := {value.name: expanded(value.value, self.definitions) for value in values}:
            if any(name in put for part in parts for name in bound_names(part)):
                raise InputError("a variable that a claim names as its own has no fixed value")
            if not any(_is_differentiated(part) for part in leaves(formula)):
                formula = mapped(formula, lambda e: substitute(e, put))
                formula = under(formula, lambda part: tuple(
                    c for c in next(leaves(part)).given if _names(c)
                ))  # fmt: skip
        names = frozenset().union(*map(names_in, trees))
        on = tuple(self._expanded(link) for link in whole.on)
        common = _common(formula)
        given = tuple(dict.fromkeys(c for part in leaves(formula) for c in part.given))
        return PaperClaim(
            label,
            line,
            called,
            (),
            (),
            whole.given,
            given,
            None if whole.path is None else str(whole.path),
            values,
            must_hold=tuple(dict.fromkeys(must)),
            rests_on=tuple(name for name in self.definitions if name in names),
            whole=Compound(formula, common, whole.path, on, called),
            said=whole.formula,
            required=tuple(dict.fromkeys(required)),
        )

    def _conditions_of(
        self,
        part: Formula,
        values: tuple[Value, ...],
        required: list[Required],
        must: list[Compared],
    ) -> tuple[Compared, ...]:
        """The conditions of a part: its own and the declared ones; and what these require."""
        inner = list(leaves(part))
        own = inner[0].given
        links = (link for leaf in inner for link in comparisons_of(leaf))
        names = frozenset().union(*map(_names, links))
        everything = _connected(names, self.given, own)
        put = {value.name: expanded(value.value, self.definitions) for value in values}
        leaf = inner[0]
        kept = everything
        if isinstance(leaf, Count):
            about = [c for c in everything if leaf.name in _names(c)]
            kept = tuple(c for c in everything if c not in about)
            inside = tuple(
                link
                for link, end in (
                    ((leaf.low, "<", symbol(leaf.name)), leaf.low),
                    ((symbol(leaf.name), "<", leaf.high), leaf.high),
                )
                if end not in (INFINITY, -INFINITY)
            )
            required += [Required(link, (*kept, *inside)) for link in about]
        elif isinstance(leaf, Written) and leaf.path is not None:
            near = _near_the_end(leaf.path, everything)
            kept = tuple(c for c in everything if c not in near)
            plain_ = tuple(c for c in kept if c[1] != "==" and not (c[0].hidden or c[2].hidden))
            required += [Required(link, plain_, str(leaf.path)) for link in near]
        if put:
            fixed = tuple((symbol(name), "==", x) for name, x in put.items() if name in names)
            for left, relation, right in kept:
                link = substitute(left, put), relation, substitute(right, put)
                if not _names(link):
                    must.append(link)
            kept = (*kept, *fixed) if any(map(_is_differentiated, inner)) else kept
        return kept


def _near_the_end(path: LimitProcess | None, given: Iterable[Compared]) -> tuple[Compared, ...]:
    """The conditions on the variable of a path, which the path itself must satisfy near its end.

    Where an equation determines another variable, as in ``x == n*pi + o(1) given tan(x) == x, n*pi
    < x``, the conditions that relate the two select the solution, and stay.
    """
    if path is None:
        return ()
    given = tuple(given)
    unknown = frozenset().union(*(_names(link) for link in given if link[1] == "==")) - {path.name}
    return tuple(
        link
        for link in given
        if path.name in _names(link) and link[1] not in ("in", "==") and not _names(link) & unknown
    )


def _with_put_in(made: Definition, put: Mapping[str, Expr]) -> Definition:
    """A definition with expressions put in for its variables, but not for its arguments."""
    free = {name: e for name, e in put.items() if name not in made.parameters}
    taken = {name for e in free.values() for name in symbols(e)}
    if taken & {*made.parameters} and symbols(made.expression) & free.keys():
        raise InputError(f"'{made.name}' has an argument of the same name: rename it")
    return replace(made, expression=substitute(made.expression, free))


def _without_reason(match: re.Match[str]) -> str:
    return match[0] if match[1] in ("in", "∈") else match[1]


def _common(formula: Formula) -> tuple[Compared, ...]:
    """The conditions of a formula if all of its parts have the same; else none."""
    given = {leaf.given for leaf in leaves(formula)}
    return given.pop() if len(given) == 1 else ()


def _is_differentiated(leaf: Leaf) -> bool:
    """Whether a derivative stands in a part, which is taken before its variable gets a value."""
    sides = (side for link in comparisons_of(leaf) for side in link[::2])
    return any(node.op in ("derivative", "nth") for node in outermost(*sides))


def statements_of(text: str) -> Iterator[tuple[int, str]]:
    """Yield the statements with their first lines: an indented line continues the one before."""
    found: list[tuple[int, str]] = []
    fresh = True
    for line, written in enumerate(text.split("\n"), 1):
        stripped = written.strip()
        if not stripped or stripped.startswith("%"):
            fresh = fresh or not stripped
            continue
        if written[0] in " \t" and not fresh:
            start, before = found[-1]
            found[-1] = start, f"{before} {stripped}"
        else:
            found.append((line, stripped))
        fresh = False
    yield from found


def _is_comparison(text: str) -> bool:
    """Whether a line is nothing but a comparison, such as ``g > 0``."""
    try:
        return bool(re.search("[<>=~]", text)) and bool(parse_claim(plain(text)))
    except InputError:
        return False


def _is_formula(text: str) -> bool:
    """Whether a relation stands in a text that is not quoted prose, and a formula before it."""
    formula, _ = clauses_of(text)
    return _RELATION.search(formula) is not None and _is_comparison(formula)


def label_of(printed: str) -> str:
    """Return a printed label as one word.

    Example:
        >>> label_of("Lemma 1"), label_of("(3)"), label_of("α"), label_of("erfc.large")
        ('Lemma-1', 'eq-3', 'alpha', 'erfc-large')
    """
    word = re.sub(r"[^A-Za-z0-9_]+", "-", plain(printed)).strip("-")
    return word if word[:1].isalpha() else f"eq-{word}"


def labelled(text: str) -> re.Match[str] | None:
    """Return how a statement with a label is read, or None; what it says is the fourth group."""
    return _LET.fullmatch(text) or _ASSUME.fullmatch(text) or _CLAIM.fullmatch(text)


def clauses_of(written: str, words: str = CLAUSE) -> tuple[str, dict[str, str]]:
    """Return the formula of a claim and its clauses by their words, which a pattern matches."""
    text = f"{written} "
    places_ = places(text, words)
    ends = [first for first, _ in places_[1:]] + [len(text)]
    formula = text[: places_[0][0]] if places_ else text
    found: dict[str, str] = {}
    for (first, start), end in zip(places_, ends if places_ else (), strict=True):
        part = text[start:end]
        name = " ".join(text[first:start].split())
        if name in found:
            raise InputError(f"'{name}' begins two clauses of the claim; join them by a comma")
        plain_part = UNIFORMLY.sub("", f" {part} ") if name in ("given", "as", "on") else part
        if plain_part.strip() != part.strip() and not UNIFORMLY.search(formula):
            formula = f"{formula.rstrip()} uniformly"
        found[name] = plain_part.strip()
        if not found[name]:
            raise InputError(f"'{name}' needs words after it")
    return formula.strip(), found


def _compared(text: str, sequences: frozenset[str]) -> tuple[list[Compared], tuple[Compared, ...]]:
    """The comparisons of a claim, in text, LaTeX or with signs of print, and conditions in it."""
    try:
        return parse_claim(plain(text), sequences), ()
    except InputError:
        again = read_as(text)
        if not again or " as " in again:
            raise
        claim, _, given = again.partition(" given ")
        return parse_claim(claim), tuple(parse_given(given))


def _rounded(text: str) -> tuple[str, str]:
    """The two sides of ``u ~= 1.1853``."""
    left, *rest = re.split("~=|≈", text)
    right = rest[0].strip()
    if len(rest) > 1 or not _ROUNDED.fullmatch(right):
        raise InputError(
            f"'{right}' is not a decimal number: u ~= 1.1853 says that u rounds to these digits; "
            "for two quantities write a ~ b with a path, or abs(a - b) <= 0.005"
        )
    return left, right


def _rounding(link: Compared, rounded: str) -> Compared:
    """``u ~= 1.1853`` as the distance from the number, at most half a unit of its last digit."""
    left, _, right = link
    digits, _, exponent = rounded.lower().partition("e")
    places = len(digits.partition(".")[2]) - int(exponent or 0)
    unit = parse_number(f"0.5e{-places}")
    return apply("abs", left - right), "<=", number(unit)


def _values(text: str) -> Iterator[Value]:
    for left, relation, right in parse_given(plain(text)):
        if left.op != "symbol" or relation != "==":
            raise InputError(f"'{chained(((left, relation, right),))}': write at x == 1/5, y == 2")
        yield Value(str(left.args[0]), right)


def _names(link: Compared) -> frozenset[str]:
    return symbols(link[0]) | (symbols(link[2]) - {INTEGERS.args[0]})


def _connected(
    names: frozenset[str], declared: Iterable[Compared], own: Iterable[Compared]
) -> tuple[Compared, ...]:
    """Return a claim's own conditions, and the declared ones that concern its variables.

    A condition that relates one of its variables to another brings in the conditions on that one.
    """
    kept = list(own)
    names = names.union(*map(_names, kept))
    left = list(declared)
    while found := [link for link in left if _names(link) & names]:
        kept += found
        left = [link for link in left if link not in found]
        names = names.union(*map(_names, found))
    order = {id(link): n for n, link in enumerate((*declared, *own))}
    return tuple(dict.fromkeys(sorted(kept, key=lambda link: order[id(link)])))


def _put_in(
    links: tuple[Compared, ...], given: tuple[Compared, ...], values: Mapping[str, Expr]
) -> tuple[tuple[Compared, ...], tuple[Compared, ...], tuple[Compared, ...]]:
    """Put values in for variables; return also the conditions that have no variables then.

    A derivative is taken before its variable gets a value: the value is then a condition.
    """
    if not values:
        return links, given, ()

    def put(link: Compared) -> Compared:
        return substitute(link[0], values), link[1], substitute(link[2], values)

    changed = tuple(map(put, given))
    for x, relation, _ in changed:
        if relation == "in" and x.op == "number" and x.args[0].q != 1:
            raise InputError(f"'{x}' is not an integer, as its variable is declared to be")
    changed = tuple(link for link in changed if link[1] != "in" or link[0].op != "number")
    must = tuple(link for link in changed if not _names(link))
    left = tuple(link for link in changed if _names(link))
    nodes = (node for link in links for node in outermost(link[0], link[2]))
    if any(node.op in ("derivative", "nth") for node in nodes):
        return links, (*given, *((symbol(name), "==", x) for name, x in values.items())), must
    return tuple(map(put, links)), left, must


def _drawn(line: int, kind: str, label: str, text: str) -> Drawn:
    """Read ``at e == 1/10, 1/100; M == 1, 3; digits 50``."""
    at: list[tuple[str, tuple[Expr, ...]]] = []
    digits = DIGITS
    for part in filter(None, (part.strip() for part in text.split(";"))):
        words = part.removeprefix("at ").strip()
        if match := re.fullmatch(r"digits\s+(\d{1,9})", words):
            digits = int(match[1])
            if not 1 <= digits <= MAX_DIGITS:
                raise InputError(f"digits {match[1]}: give a number from 1 to {MAX_DIGITS}")
            continue
        name, equal, values = re.sub("={1,2}", "==", words, count=1).partition("==")
        if not equal or not re.fullmatch(_NAME, name.strip()):
            raise InputError(
                f"'{part}' is not read: write {kind} {label}: at x == 1/10, 1/100; digits 20"
            )
        several = tuple(as_written(plain(value)) for value in values.split(","))
        if any(symbols(value) for value in several):
            raise InputError(f"'{part}': the values must be numbers")
        at.append((name.strip(), several))
    return Drawn(line, kind, label, tuple(at), digits)


def near(word: str, known: Iterable[str]) -> str:
    close = get_close_matches(word, list(known), 1)
    return f" (did you mean {close[0]}?)" if close else ""


__all__ = ["OwnPaper", "PaperClaim", "Problem", "read_file", "read_paper"]
