"""Every kind of statement read back: a reader of propositions that shares nothing with the printer.

A printed statement is read into connectives and relations, and what it says is built from the
claim's theorem beside it. Names, free and bound, have values; a term is its value in balls, and a
function under an integral or a derivative is its value at the value of its variable. The two have
to be the same, connective by connective, and number by number.
"""

import re
from functools import reduce
from hashlib import sha256
from itertools import chain
from pathlib import Path
from typing import Any

import pytest
from cases import cases
from coq_terms import Terms
from flint import arb

from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.claim_export import theorems
from tresym.coq.ledger_statements import Joint, theorem_of
from tresym.coq.statement import NotExportedError, Theorem, variable
from tresym.coq.theorem_trees import Every, Fails, Formula, One, Some, Wherever, values_of
from tresym.ledger.paper import all_claims
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT
from tresym.reals.language.expression import Expr, instantiate, replaced, symbol, symbols
from tresym.reals.language.formula import Conjunction, Equivalence
from tresym.reals.numbers.arithmetic import ball_precision

SIGNS = {"=": "==", "<>": "!="}
BINDERS = {"RInt": "integral", "Derive": "derivative"}
SAID = {"is_RInt": "integral", "is_derive": "derivative", "is_root": "root"}


def value_of(name: str) -> arb:
    """A number between 0.1 and 0.9 for each name of Coq's."""
    return arb(int(sha256(name.encode()).hexdigest()[:12], 16)) / 16**12 * arb("0.8") + arb("0.1")


def bound_value(depth: int) -> arb:
    return value_of(f"bound {depth}")


def mark(kind: str, inner: arb, args: list[arb]) -> arb:
    """What stands for an integral, a derivative, a value: it depends on all its parts."""
    return value_of(kind) + 3 * inner + sum(((5 + k) * x for k, x in enumerate(args)), arb(0))


class Reader(Terms):
    """Coq's grammar of propositions, as far as statements use it."""

    def __init__(self, text: str) -> None:
        super().__init__(text, {})
        self.depth = 0

    def named(self, name: str) -> arb:
        return self.at.get(name, value_of(name))

    # Propositions.

    def proposition(self) -> Any:
        if self.peek() in ("forall", "exists"):
            kind = self.take()
            kind += self.take() if self.peek() == "!" else ""
            names = []
            while self.peek() != ":":
                names.append(self.take())
            self.take(), self.take("R"), self.take(",")
            return (kind, tuple(names), self.proposition())
        first = self.conjunction()
        if self.peek() == "->":
            self.take()
            return ("->", first, self.proposition())
        if self.peek() == "<->":
            self.take()
            return ("<->", first, self.conjunction())
        return first

    def conjunction(self) -> Any:
        parts = [self.unit()]
        while self.peek() == "/\\":
            self.take()
            quantified = self.peek() in ("forall", "exists")
            parts.append(self.proposition() if quantified else self.unit())
        return conjoined(parts)

    def unit(self) -> Any:
        if self.peek() == "~":
            self.take()
            return ("~", self.unit())
        if self.peek() == "True":
            self.take()
            return conjoined([])
        if self.peek() in SAID:
            kind = SAID[self.take()]
            inner = self.function()
            *args, value = (self.atom() for _ in range(2 if kind == "derivative" else 3))
            return ("said", mark(kind, inner, args), value)
        start = self.place
        if self.peek() == "(":
            try:
                self.take()
                found = self.proposition()
                self.take(")")
            except AssertionError:
                self.place = start
            else:
                if self.peek() not in (*SIGNS, *"<>+-*/^", "<=", ">="):
                    return found
                self.place = start
        left = self.sum()
        sign = self.take(*SIGNS, "<", ">", "<=", ">=")
        return (SIGNS.get(sign, sign), left, self.sum())

    # Terms.

    def application(self) -> arb:
        if (name := self.peek()) in BINDERS:
            self.take()
            inner = self.function()
            return mark(
                BINDERS[name], inner, [self.atom() for _ in range(2 if name == "RInt" else 1)]
            )
        if name == "(" and self.peek(1) == "fun":
            before, start = self.depth, self.place
            inner, count = self.function(), 0
            while self.tokens[start + 2 + count] != ":":
                count += 1
            assert before == self.depth
            return mark("at", inner, [self.atom() for _ in range(count)])
        return super().application()

    def function(self) -> arb:
        """The value of a function at the values of its variables."""
        self.take("("), self.take("fun")
        names = []
        while self.peek() != ":":
            names.append(self.take())
        self.take(":"), self.take("R"), self.take("=>")
        kept = dict(self.at)
        for k, name in enumerate(names):
            self.at[name] = bound_value(self.depth + k)
        self.depth += len(names)
        value = self.sum()
        self.depth -= len(names)
        self.at = kept
        self.take(")")
        return value

    def atom(self) -> arb:
        if self.peek() == "(" and self.peek(1) == "fun":
            return self.application()
        return super().atom()


def conjoined(parts: list[Any]) -> Any:
    """One conjunction of all parts, however they are put together."""
    flat = list(chain.from_iterable(p[1] if p[0] == "and" else [p] for p in parts))
    return flat[0] if len(flat) == 1 else ("and", flat)


# What a theorem says, by its tree.


def meant(e: Expr, depth: int = 0) -> arb:
    """The value of a term, with the same marks for what it binds variables in."""
    nodes = list(dict.fromkeys(outermost(e)))
    names = {node: symbol(f"[{k}]") for k, node in enumerate(nodes)}
    at = {name.args[0]: marked(node, depth) for node, name in names.items()}
    bare = replaced(e, names)
    for name in symbols(bare) - at.keys():
        at[name] = _named(name)
    return evaluate(bare, at)


def _named(name: str) -> arb:
    found = re.fullmatch(r"\[bound (\d+)\]", name)
    return bound_value(int(found[1])) if found else value_of(variable(name))


def marked(node: Expr, depth: int) -> arb:
    count = len(node.names)
    body = instantiate(node.args[0], tuple(symbol(f"[bound {depth + k}]") for k in range(count)))
    args = [meant(arg, depth) for arg in node.args[1:]]
    return mark(node.op, meant(body, depth + count), args)


def relation(left: Expr, sign: str, right: Expr) -> Any:
    return (sign, meant(left), meant(right))


def tree(f: Formula) -> Any:
    """A formula as the reader reads it."""
    if isinstance(f, Conjunction):
        return conjoined([tree(part) for part in f.parts])
    if isinstance(f, Equivalence):
        return ("<->", tree(f.first), tree(f.second))
    if isinstance(f, Wherever):
        return implied([relation(*c) for c in f.conditions], tree(f.says))
    if isinstance(f, One):
        return ("exists!", (variable(f.name),), tree(f.says))
    if isinstance(f, Fails):
        return ("~", tree(f.says))
    if isinstance(f, Some | Every):
        kind = "exists" if isinstance(f, Some) else "forall"
        return (kind, tuple(map(variable, f.names)), tree(f.says))
    bare, names = values_of(f)
    if not names:
        return relation(bare.left, bare.sign, bare.right)
    said = [("said", marked(node, 0), meant(name)) for node, name in names.items()]
    if f.sign == "==" and len(said) == 1:
        ((node, name),) = names.items()
        for side, other in ((bare.left, bare.right), (bare.right, bare.left)):
            if side == name and name.args[0] not in symbols(other):
                return ("said", marked(node, 0), meant(other))
    says = conjoined([*said, relation(bare.left, bare.sign, bare.right)])
    return ("exists", tuple(variable(name.args[0]) for name in names.values()), says)


def implied(premises: list[Any], says: Any) -> Any:
    return reduce(lambda rest, p: ("->", p, rest), reversed(premises), says)


def whole(t: Theorem) -> Any:
    """The theorem as the reader reads it."""
    premises = [implied([relation(*c) for c in given], tree(f)) for given, f in t.definitions]
    premises += [relation(*c) for c in t.given]
    for e, sign in t.defined:
        premises.append(
            ("!=", meant(e), arb(0)) if sign == "!=" else (sign.replace(">", "<"), arb(0), meant(e))
        )
    says = tree(t.says)
    body = conjoined([*premises, says]) if t.exists else implied(premises, says)
    kind = "exists" if t.exists else "forall"
    return (kind, tuple(map(variable, t.variables)), body) if t.variables else body


def same(x: Any, y: Any) -> int:
    """How many numbers are compared; fails where the two are not the same."""
    if isinstance(x, arb):
        assert isinstance(y, arb)
        if not x.is_finite() or not y.is_finite():
            return 0
        assert x.overlaps(y)
        return 1
    if isinstance(x, str):
        assert x == y
        return 0
    assert len(x) == len(y), (x, y)
    return sum(same(a, b) for a, b in zip(x, y, strict=True))


def read_back(text: str) -> Any:
    reader = Reader(text)
    found = reader.proposition()
    assert not reader.peek()
    return found


def test_every_statement_of_the_ledger_is_read_back() -> None:
    counts: dict[str, int] = {}
    with ball_precision(120):
        for claim in all_claims():
            try:
                t = theorem_of(claim)
            except NotExportedError:
                continue
            if not isinstance(t, Theorem):  # a conjunction, or the implicit function theorem
                continue
            counts[t.name] = same(read_back(t.body), whole(t))
    assert len(counts) > 500
    assert sum(n > 0 for n in counts.values()) > 0.97 * len(counts)


def test_joint_statements_name_their_parts() -> None:
    for claim in all_claims():
        try:
            t = theorem_of(claim)
        except NotExportedError:
            continue
        if isinstance(t, Joint):
            assert re.findall(r"says_\w+", t.body) == t.body.replace("/\\", "").split()
            assert len(t.body.split("/\\")) == len(t.parts)


def test_the_reader_tells_statements_apart() -> None:
    with ball_precision(120):
        one = read_back("forall x : R, x > 0 -> is_RInt (fun t : R => t * x) 0 1 (x / 2)")
        for other in (
            "forall x : R, x > 0 -> is_RInt (fun t : R => t + x) 0 1 (x / 2)",
            "forall x : R, x > 0 -> is_RInt (fun t : R => t * x) 0 2 (x / 2)",
            "forall x : R, x >= 0 -> is_RInt (fun t : R => t * x) 0 1 (x / 2)",
            "exists x : R, x > 0 /\\ is_RInt (fun t : R => t * x) 0 1 (x / 2)",
            "forall x : R, x > 0 -> is_root (fun t : R => t * x) 0 1 (x / 2)",
        ):
            try:
                same(one, read_back(other))
            except AssertionError:
                continue
            raise AssertionError(other)
        renamed = "forall x : R, x > 0 -> is_RInt (fun s : R => s * x) 0 1 (x / 2)"
        assert same(one, read_back(renamed)) > 3


# Orders and limits along a path, of ``test_orders.py``.


class PathReader(Reader):
    """The reader of propositions, with filters, limits and sequences."""

    def proposition(self) -> Any:
        if self.peek() in ("forall", "exists") and self._kind() == "nat":
            kind, names = self.take(), []
            while self.peek() != ":":
                names.append(self.take())
            self.take(), self.take("nat"), self.take(",")
            return (kind, tuple(names), self.proposition())
        return super().proposition()

    def _kind(self) -> str:
        place = self.place
        while self.tokens[place] != ":":
            place += 1
        return self.tokens[place + 1]

    def unit(self) -> Any:
        if self.peek() == "filterlim":
            self.take()
            inner, where = self.function(), self.filter()
            self.take("("), self.take("Rbar_locally")
            return ("limit", where, inner, self.extended())
        if self.peek() == "eventually" or self.peek(1) in FILTERS:
            return ("near", self.filter(), self.held())
        return super().unit()

    def held(self) -> Any:
        """A property of the variable of the path."""
        self.take("("), self.take("fun")
        name = self.take()
        self.take(":"), self.take("R", "nat"), self.take("=>")
        found = self.proposition()
        self.take(")")
        return (name, found)

    def function(self) -> Any:
        """A function of the variable of the path, at the value that its name has."""
        self.take("("), self.take("fun")
        name = self.take()
        self.take(":"), self.take("R", "nat"), self.take("=>")
        value = self.sum()
        self.take(")")
        return (name, value)

    def filter(self) -> Any:
        if self.peek() == "eventually":
            return (self.take(),)
        self.take("(")
        kind = self.take(*FILTERS)
        at = self.take() if self.peek() in ("p_infty", "m_infty") else self.atom()
        self.take(")")
        return (kind, at)

    def extended(self) -> Any:
        if self.peek() in ("p_infty", "m_infty"):
            found = self.take()
        else:
            self.take("("), self.take("Finite")
            found = self.atom()
            self.take(")")
        self.take(")")
        return found

    def factor(self) -> arb:
        if self.peek() in ("/", "-"):
            return super().factor()
        base = self.application()
        if self.peek() == "^":
            self.take()
            exponent = self.take()
            return base ** (int(exponent) if exponent.isdigit() else self.named(exponent))
        return base

    def application(self) -> arb:
        if self.peek() == "INR":
            self.take()
            return self.atom()
        return super().application()


ORDERS = [
    claim
    for truth in ("TRUE", "FALSE")
    for claim in cases(str(Path(__file__).with_name("test_orders.py")), truth)
]
FILTERS = ("locally'", "at_right", "at_left", "Rbar_locally")


def path_theorem(claim: str) -> BoundTheorem:
    (found,) = theorems(read(claim))
    assert isinstance(found, BoundTheorem)
    return found


def end(claim: str, sequence: bool) -> Any:
    """The filter of the path of a claim."""
    path = read(claim).path
    assert path is not None
    if sequence:
        return ("eventually",)
    if path.point is None:
        return ("Rbar_locally", "p_infty" if path.sides[0] > 0 else "m_infty")
    kinds = {(1,): "at_right", (-1,): "at_left"}
    return (kinds.get(path.sides, "locally'"), meant(path.point))


def said(claim: str) -> Any:
    """What the last part of a theorem has to say, from the claim."""
    (found,), path = read(claim).comparisons, read(claim).path
    assert path is not None
    sequence = f"{path.name} in integers" in claim
    where, name = end(claim, sequence), variable(path.name)
    left = meant(found.left)
    if found.relation == LIMIT:
        ends = {INFINITY: "p_infty", -INFINITY: "m_infty"}
        value = ends[found.right] if found.right in ends else meant(found.right)
        return ("limit", where, (name, left), value)
    f, g = abs(left), abs(meant(found.right))
    c, k, eps = map(value_of, ("C", "c", "eps"))

    def near(held: Any) -> Any:
        return ("near", where, (name, held))

    every = ("forall", ("eps",))
    match found.relation:
        case "O":
            return ("exists", ("C",), near(("<=", f, c * g)))
        case "o":
            return (*every, ("->", ("<", arb(0), eps), near(("<=", f, eps * g))))
        case "~":
            gap = abs(left - meant(found.right))
            return (*every, ("->", ("<", arb(0), eps), near(("<=", gap, eps * g))))
        case "Theta":
            both = ("and", [("<=", k * g, f), ("<=", f, c * g)])
            return ("exists", ("c", "C"), ("and", [("<", arb(0), k), near(both)]))
        case "omega":
            return ("forall", ("C",), near(("<", c * g, f)))
    raise AssertionError(found.relation)


@pytest.mark.parametrize("claim", ORDERS)
def test_a_statement_says_what_the_claim_says(claim: str) -> None:
    with ball_precision(120):
        reader = PathReader(path_theorem(claim).body)
        found = reader.proposition()
        assert not reader.peek()
        while found[0] == "forall" and found[1] not in (("eps",), ("C",)):
            found = found[2]
        given = read(claim).given.comparisons
        for left, sign, right in given:
            assert same(found[1], (sign, meant(left), meant(right))) > 0
            found = found[2]
        while found[0] == "->":  # that parameters make sense
            found = found[2]
        last = found[1][-1] if found[0] == "and" else found
        assert same(last, said(claim)) > 0
