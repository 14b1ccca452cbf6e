"""Write the script of a proof of an equation: names, facts and values at points."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from flint import arb, fmpq

from tresym.coq.equations import exchanged, is_root, nodes, unfolded
from tresym.coq.rational_functions import LEAVES, Quotients
from tresym.coq.statement import Theorem, term
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound
from tresym.reals.functions.table import names
from tresym.reals.language.expression import (
    HALF,
    MINUS_ONE,
    ONE,
    Expr,
    fresh,
    multiply,
    number,
    symbol,
    symbols,
)

POINTS, LATER, STEPS = 10, 20, 300
"""Points that are looked at, near and then anywhere, and sentences at most."""
HYPERBOLIC = names(lambda row: row.family == "inverse hyperbolic")
Ask = Callable[[str], bool]


class StuckError(Exception):
    """No further step of the proof was found."""


class AgainError(Exception):
    """A base was too coarse; a finer one is now known, and the proof must be restarted."""


class CasesError(Exception):
    """The proof must split into cases by the sign of an expression; in three if the flag is set."""


def spelled(e: Expr, plainly: bool = False) -> Expr:
    """Return ``e`` as the tactic ``spell`` (or ``spell_plainly``) of ``Tresym.v`` rewrites it."""
    if e.op in LEAVES:
        return e
    args = tuple(spelled(arg, plainly) for arg in e.args)
    u = args[0]
    match e.op:
        case "abs":
            return Expr("abs", args)
        case _ if plainly and e.op in HYPERBOLIC:
            return Expr(e.op, args)
        case "asinh" | "acosh":
            one = ONE if e.op == "asinh" else MINUS_ONE
            under = Expr("+", (Expr("^", (u, number(2))), one))
            return Expr("log", (Expr("+", (u, Expr("^", (under, HALF)))),))
        case "atanh":
            other = Expr("+", (ONE, Expr("*", (MINUS_ONE, u))))
            whole = Expr("*", (Expr("+", (ONE, u)), Expr("^", (other, MINUS_ONE))))
            return Expr("*", (Expr("log", (whole,)), HALF))
    names = {arg: symbol(f"[{n}]") for n, arg in enumerate(args) if arg.op not in LEAVES}
    outer = unfolded(Expr(e.op, tuple(names.get(arg, arg) for arg in args)))
    return exchanged(outer, {name: arg for arg, name in names.items()})


class Turned(NamedTuple):
    """The sine and cosine of a base angle, and the name of the equation that relates them."""

    sine: Expr
    cosine: Expr
    label: str


class Writing:
    """A proof script under construction, with the facts and names known so far."""

    def __init__(
        self, theorem: Theorem, ask: Ask, finest: dict[object, fmpq], plainly: bool
    ) -> None:
        self.ask, self.finest = ask, finest
        self.lines: list[str] = []
        self.count, self.splits = 0, 0
        self.taken = set(theorem.variables)
        self.sides = [spelled(side, plainly) for side in (theorem.left, theorem.right)]
        self.done: set[Expr] = set()
        self.refused: set[tuple[str, str]] = set()
        self.quotients = Quotients()
        self.bound: dict[str, str] = {}  # of a name that has an equation, its label
        self.turns: dict[Expr, Turned] = {}  # of base angles
        self.is_arc_tangent: dict[Expr, bool] = {}  # names of inverse functions, all base angles
        self.inverses: dict[Expr, Expr] = {}  # what these are names of
        self.hyperbolics: dict[Expr, Expr] = {}  # names of inverse hyperbolic functions, the same
        self.exponents: dict[Expr, Expr] = {}  # exponent: name of the exponential
        self.roots: dict[tuple[Expr, int], Expr] = {}
        self.logarithms: dict[Expr, Expr] = {}  # of what: name
        bounds = tuple(bound(*part) for part in theorem.defined if symbols(part[0]))
        known = Given(theorem.given + bounds)
        self.points: list[dict[str, arb | fmpq]] = [
            dict(point)
            for start in (0, LATER)
            for point in known.points(theorem.variables, POINTS, start)
        ]

    # Sentences sent to Coq.

    def say(self, sentence: str) -> bool:
        """Send a sentence to Coq; keep it in the script if Coq accepts it."""
        self.count += 1
        if self.count > STEPS:
            raise StuckError
        held = self.ask(sentence)
        if held:
            self.lines.append(sentence)
        return held

    def must(self, *sentences: str) -> None:
        """Keep the first of the sentences that Coq accepts; raise StuckError if there is none."""
        if not any(map(self.say, sentences)):
            raise StuckError

    def label(self, letter: str) -> str:
        """Return a fresh label."""
        self.count += 1
        return f"{letter}_{self.count}"

    @property
    def by_field(self) -> str:
        """The tactic for equations between rational functions of the names."""
        known = f" [{' '.join(self.bound.values())}]" if self.bound else ""
        away = f"away ltac:(fun _ => ring{known})"
        return f"first [ring{known} | field{known}; {away} | unfold Rdiv; field{known}; {away}]"

    def put(self, old: Expr, new: Expr) -> None:
        """Replace ``old`` in both sides; for a root, also in its powers."""
        degree = degree_of(old) if is_root(old) else 0

        def walk(e: Expr) -> Expr:
            if e == old:
                return new
            if e.op in LEAVES:
                return e
            if degree and is_root(e) and e.args[0] == old.args[0] and degree_of(e) == degree:
                n = 1 if e.op == "cbrt" else int(e.args[1].args[0].p)
                return new if n == 1 else Expr("^", (new, number(n)))
            return Expr(e.op, tuple(map(walk, e.args)))

        self.sides = list(map(walk, self.sides))

    def equation(self, old: Expr, new: Expr, *proofs: str) -> bool:
        """Prove ``old = new`` and substitute it everywhere; return whether that succeeded."""
        name = self.label("E")
        for proof in proofs:
            if term(old) == term(new) or self.say(
                f"assert ({name} : {term(old)} = {term(new)}) by ({proof}); "
                f"put {name}; clear {name}; saturate."
            ):
                self.put(old, new)
                return True
        return False

    def exchange(self, old: Expr, new: Expr, *proofs: str) -> None:
        """Prove ``old = new`` and substitute it; raise StuckError if that fails."""
        if not self.equation(old, new, *proofs):
            raise StuckError

    def named(self, e: Expr) -> Expr:
        """Introduce a name for ``e``, hiding its meaning from the tactics."""
        name = symbol(fresh(f"n{len(self.taken)}", self.taken))
        self.taken.add(name.args[0])
        text, is_called = term(e, 3), f"D_{name.args[0]}"
        self.must(f"destruct (some_name {text}) as [{term(name)} {is_called}].")
        self.must(f"put {is_called}.")
        self.must(f"change (same {text} {term(name)}) in {is_called}.")
        for point, value in zip(self.points, self.values(e), strict=True):
            point[name.args[0]] = value
        self.put(e, name)
        return name

    def back(self, name: Expr) -> str:
        """Return the tactic that replaces a name by its meaning."""
        return f"unfold same in D_{name.args[0]}; rewrite <- D_{name.args[0]}"

    def fact(self, says: str, *proofs: str) -> bool:
        """Add a fact to the premises if one of the proofs succeeds; return whether it did."""
        name = self.label("F")
        for proof in proofs:
            if (says, proof) not in self.refused:
                if self.say(f"assert ({name} : {says}) by ({proof})."):
                    return True
                if "nra" in proof or "signed" in proof:  # it takes its time
                    self.refused.add((says, proof))
        return False

    def is_above(self, e: Expr, strict: bool = True) -> bool:
        """Return whether Coq proves ``e > 0`` (or ``>= 0``); if so, it becomes a premise."""
        if e.op == "number":
            return bool(e.args[0] > 0)
        return self.fact(f"0 {'<' if strict else '<='} {term(e)}", "plainly", "in_numbers", "nra")

    def are_above(
        self,
        u: Expr,
        factors: list[tuple[Expr, int]],
        ways: tuple[str, ...] = ("plainly", "in_numbers", "rest", "nra"),
    ) -> list[Expr]:
        """Prove that factors of ``u`` are positive; return those for which this failed."""
        left = [f for f, _ in factors if f.op != "number"]
        for way in ways:
            for f in list(left):
                proof = way
                if way == "rest" and left == [f]:
                    others = multiply(*(g**n for g, n in factors if g != f))
                    n = next(n for g, n in factors if g == f)
                    if n not in (1, -1):
                        continue
                    power = term(f) if n > 0 else f"/ {term(f, 3)}"
                    proof = (
                        f"{'' if n > 0 else 'apply positive_inverse; '}"
                        f"apply (factor_above _ {term(others, 3)}); [positive | "
                        f"replace ({power} * {term(others, 3)}) with {term(u, 3)} by "
                        f"({self.by_field}); assumption]"
                    )
                elif way == "rest":
                    continue
                if self.fact(f"0 < {term(f)}", proof):
                    left.remove(f)
        return left

    # Values at the sample points

    def values(self, e: Expr) -> list[arb]:
        """Return the values at the sample points."""
        return [evaluate(e, point) for point in self.points]

    def sign(self, e: Expr) -> int | None:
        """Return the sign at the sample points: 1, −1 or 0; None if it varies."""
        values = self.values(e)
        if all(is_zero(v) for v in values):
            return 0
        if all(v > 0 or is_zero(v) for v in values):
            return 1
        return -1 if all(v < 0 or is_zero(v) for v in values) else None

    def equal(self, x: Expr, y: Expr) -> bool:
        """Return whether two expressions agree at the sample points."""
        return self.sign(x - y) == 0

    def has(self, e: Expr) -> bool:
        """Return whether ``e`` occurs in one of the sides."""
        return e in nodes(self.sides)


def degree_of(e: Expr) -> int:
    """Return the degree of a root."""
    return 3 if e.op == "cbrt" else int(e.args[1].args[0].q)


def is_zero(v: arb) -> bool:
    """Return whether the ball contains zero and is narrow."""
    return bool(v.is_finite() and v.contains(0) and v.rad() < arb("1e-20"))
