"""Proofs of equations found step by step: Coq is asked after each step whether it holds.

The innermost function is taken first, while what it is taken of is a rational function of real
numbers that have names. It is written by these names, or gets one: a root, an exponential, a sine
and a cosine are bound by one equation each, an inverse function by its sine and cosine. What equals
what is seen from values at a few points; where the sign of something decides and is not constant
there, the proof goes on in cases. What is left at the end is an equation for ``field``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from fractions import Fraction
from math import isqrt, lcm
from typing import NamedTuple

from flint import arb, fmpq

from tresym.coq.equations import exchanged, is_root, nodes, primes, unfolded
from tresym.coq.quotients import LEAVES, Quotients
from tresym.coq.statement import Theorem, term
from tresym.reals.language.expression import (
    HALF,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    fresh,
    multiply,
    number,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import bound
from tresym.reals.places.values import evaluate

SPECIAL = {
    PI / 3: (3, number(Fraction(3, 4)), number(Fraction(1, 4))),
    PI / 4: (4, HALF, HALF),
    PI / 6: (6, number(Fraction(1, 4)), number(Fraction(3, 4))),
}
"""Parts of π with the squares of their sine and cosine."""
POINTS, SPLITS, STEPS, MULTIPLE = 14, 4, 300, 12
Ask = Callable[[str], bool]


class StuckError(Exception):
    """No next step was found."""


class _AgainError(Exception):
    """A base was chosen too coarse; it is known now which is fine enough."""


class _CasesError(Exception):
    """The proof goes on in cases, by the sign of the first argument; by three where it says so."""


class Turned(NamedTuple):
    """A base angle: its sine and cosine, and the name of the fact that says so."""

    sine: Expr
    cosine: Expr
    label: str


def stepwise(theorem: Theorem, ask: Ask, begin: Callable[[], None]) -> str | None:
    """A proof of an equation, None where none was found.

    Args:
        ask: whether Coq accepts a sentence.
        begin: begins the proof anew.
    """
    finest: dict[object, int] = {}
    for _ in range(8):
        begin()
        try:
            with ball_precision():
                proof = _Steps(theorem, ask, finest)
                proof.must("intros; saturate; spell.")
                proof.go_on()
        except _AgainError:
            continue
        except (StuckError, InputError, OverflowError, RecursionError, ZeroDivisionError):
            return None
        return "\n".join(proof.lines)
    return None


def spelled(e: Expr) -> Expr:
    """``e`` as ``spell`` of Tresym.v leaves it."""
    if e.op in LEAVES:
        return e
    args = tuple(map(spelled, e.args))
    u = args[0]
    match e.op:
        case "abs":
            return Expr("abs", args)
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


class _Steps:
    """A proof in the making."""

    def __init__(self, theorem: Theorem, ask: Ask, finest: dict[object, int]) -> None:
        self.ask, self.finest = ask, finest
        self.lines: list[str] = []
        self.count, self.splits = 0, 0
        self.taken = set(theorem.variables)
        self.sides = [spelled(theorem.left), spelled(theorem.right)]
        self.done: set[Expr] = set()
        self.quotients = Quotients()
        self.bound: dict[str, str] = {}  # of a name that has an equation, its label
        self.turns: dict[Expr, Turned] = {}  # of base angles
        self.is_arc_tangent: dict[Expr, bool] = {}  # names of inverse functions, all base angles
        self.exponents: dict[Expr, Expr] = {}  # exponent: name of the exponential
        self.roots: dict[tuple[Expr, int], Expr] = {}
        self.logarithms: dict[Expr, Expr] = {}  # of what: name
        bounds = tuple(bound(*part) for part in theorem.defined if symbols(part[0]))
        known = Given(theorem.given + bounds)
        self.points: list[dict[str, arb | fmpq]] = [
            dict(point) for point in known.points(theorem.variables, POINTS)
        ]

    # What is said to Coq.

    def say(self, sentence: str) -> bool:
        """One sentence; it is kept where Coq accepts it."""
        self.count += 1
        if self.count > STEPS:
            raise StuckError
        held = self.ask(sentence)
        if held:
            self.lines.append(sentence)
        return held

    def must(self, *sentences: str) -> None:
        """The first of the sentences that Coq accepts."""
        if not any(map(self.say, sentences)):
            raise StuckError

    def label(self, letter: str) -> str:
        """A label not used before."""
        self.count += 1
        return f"{letter}_{self.count}"

    @property
    def by_field(self) -> str:
        """The tactic for equations of rational functions of the names."""
        known = f" [{' '.join(self.bound.values())}]" if self.bound else ""
        away = f"away ltac:(fun _ => ring{known})"
        return f"first [ring{known} | field{known}; {away} | unfold Rdiv; field{known}; {away}]"

    def put(self, old: Expr, new: Expr) -> None:
        """``old`` replaced in both sides, powers of a root with it."""
        degree = _degree(old) if is_root(old) else 0

        def walk(e: Expr) -> Expr:
            if e == old:
                return new
            if e.op in LEAVES:
                return e
            if degree and is_root(e) and e.args[0] == old.args[0] and _degree(e) == degree:
                n = 1 if e.op == "cbrt" else int(e.args[1].args[0].p)
                return new if n == 1 else Expr("^", (new, number(n)))
            return Expr(e.op, tuple(map(walk, e.args)))

        self.sides = list(map(walk, self.sides))

    def equation(self, old: Expr, new: Expr, *proofs: str) -> bool:
        """That ``old = new``, put into all that there is."""
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
        """The same, without which there is no next step."""
        if not self.equation(old, new, *proofs):
            raise StuckError

    def named(self, e: Expr) -> Expr:
        """A name for ``e``; what it is a name of is kept out of the way of the tactics."""
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
        """The tactic that writes what the name is a name of."""
        return f"unfold same in D_{name.args[0]}; rewrite <- D_{name.args[0]}"

    def fact(self, says: str, *proofs: str) -> bool:
        """A fact among the premises, if it can be shown in one of the ways."""
        name = self.label("F")
        return any(self.say(f"assert ({name} : {says}) by ({proof}).") for proof in proofs)

    def is_above(self, e: Expr, strict: bool = True) -> bool:
        """Whether Coq shows that ``e`` is above zero; it is among the premises then."""
        if e.op == "number":
            return bool(e.args[0] > 0)
        return self.fact(f"0 {'<' if strict else '<='} {term(e)}", "plainly", "in_numbers", "nra")

    def are_above(
        self, u: Expr, factors: list[tuple[Expr, int]], strict: bool = True
    ) -> Expr | None:
        """That factors of ``u`` are above zero; the first that is not shown to be."""
        left = [f for f, _ in factors if f.op != "number"]
        for way in ("plainly", "in_numbers", "rest", "nra"):
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
        return left[0] if left else None

    # What the values at the points say.

    def values(self, e: Expr) -> list[arb]:
        """The values at the points."""
        return [evaluate(e, point) for point in self.points]

    def sign(self, e: Expr) -> int | None:
        """The sign at the points, None where it varies; 0 where all are zero."""
        values = self.values(e)
        if all(_is_zero(v) for v in values):
            return 0
        if all(v > 0 or _is_zero(v) for v in values):
            return 1
        return -1 if all(v < 0 or _is_zero(v) for v in values) else None

    def equal(self, x: Expr, y: Expr) -> bool:
        """Whether the values agree."""
        return self.sign(x - y) == 0

    # The walk.

    def go_on(self) -> None:
        """What is left of the proof."""
        if not self.points:
            return self.must("exfalso; absurd_.")
        while (node := self.next()) is not None:
            try:
                self.step(node)
            except _CasesError as cases:
                return self.in_cases(*cases.args)
        return self.must(f"{self.by_field}.")

    def next(self) -> Expr | None:
        """The smallest part that is to be written by names."""
        found: Expr | None = None
        for e in nodes(self.sides):
            plain = e.op in ("+", "*", *LEAVES) or (
                e.op == "^"
                and not is_root(e)
                and (e.args[1].args[0] > 0 or e.args[0].op in ("symbol", "pi"))
            )
            smaller = found is None or (e.size, str(e)) < (found.size, str(found))
            if not plain and e not in self.done and smaller:
                found = e
        return found

    def step(self, e: Expr) -> None:
        """One part written by names."""
        u = e.args[0]
        better = self.quotients.canonical(u)
        if better != u and self.equation(u, better, self.by_field):
            e, u = Expr(e.op, (better, *e.args[1:])), better
        match e.op:
            case "abs" | "sign":
                self.of_sign(e, u)
            case "exp":
                self.exponential(e, u)
            case "sin" | "cos":
                self.trigonometric(e, u)
            case "log":
                self.logarithm(e, u)
            case "asin" | "acos" | "atan":
                self.inverse_function(e, u)
            case _ if is_root(e):
                self.root(u, _degree(e), e.op == "cbrt")
            case _:
                self.done.add(e)

    def in_cases(self, u: Expr, three: bool) -> None:
        """The proof in cases, by the sign of ``u``."""
        self.splits += 1
        if self.splits > SPLITS:
            raise StuckError
        name, values = self.label("S"), self.values(u)
        text = term(u, 3)
        if three:
            self.must(f"destruct (Rtotal_order 0 {text}) as [{name} | [{name} | {name}]].")
        else:
            self.must(f"destruct (Rle_or_lt 0 {text}) as [{name} | {name}].")
        for want in (1, 0, -1) if three else (1, -1):
            case = copy(self)
            for key, value in vars(self).items():
                if isinstance(value, dict | set) and key != "finest":
                    setattr(case, key, copy(value))
            case.quotients = Quotients()
            case.quotients.powers = dict(self.quotients.powers)
            kept = zip(self.points, values, strict=True)
            case.points = [dict(p) for p, v in kept if (v > 0 if want > 0 else v < 0)]
            self.must("{")
            if want or not case.at_zero(u, name, self.points):
                case.go_on()
            self.must("}")
            self.count = case.count

    def at_zero(self, u: Expr, name: str, points: list[dict[str, arb | fmpq]]) -> bool:
        """The case where ``u = 0``, if it ends at once; a variable is zero in it otherwise."""
        if self.say("exfalso; absurd_."):
            return True
        _, factors = self.quotients.factors(u)
        zeros = [f for f, n in factors if n > 0 and f.op == "symbol"]
        if len(zeros) != 1 or len(factors) != 1 or zeros[0].args[0].startswith("n"):
            raise StuckError
        x = zeros[0]
        self.must(f"assert ({name}z : {term(x)} = 0) by (first [lra | nra]); subst {term(x)}.")
        self.put(x, ZERO)
        self.points = [dict(point) | {x.args[0]: fmpq(0)} for point in points]
        return False

    # Absolute values and signs.

    def of_sign(self, e: Expr, u: Expr) -> None:
        """An absolute value or a sign."""
        sign = self.sign(u)
        if u == ZERO:
            return self.exchange(e, ZERO, "apply sign_zero", "apply Rabs_R0")
        strict = e.op == "sign"
        if not sign or not self.is_above(u if sign > 0 else -u, strict):
            raise _CasesError(u, strict)
        if strict:
            law = "sign_pos" if sign > 0 else "sign_neg"
            return self.exchange(e, number(sign), f"apply {law}; lra")
        law = "Rabs_pos_eq" if sign > 0 else "Rabs_left1"
        proof = f"rewrite {law} by lra; {self.by_field}"
        return self.exchange(e, u if sign > 0 else -u, proof)

    # Exponentials.

    def exponential(self, e: Expr, u: Expr) -> None:
        """By exponentials of a few exponents, and by what the exponents are logarithms of."""
        if u == ZERO:
            return self.exchange(e, ONE, "apply exp_0")
        inner = {name: v for v, name in self.logarithms.items()}
        bases: list[Expr] = []
        values: list[Expr] = []
        counts: list[int] = []
        labels: list[str] = []
        for base, c in self.quotients.parts(u):
            if base in inner:
                q, n, v = int(c.q), int(c.p), inner[base]
                b = base / number(q)
                value, label = self.of_logarithm(base, b, v, q)
            else:
                unit = self.unit("exp", base, int(c.q))
                b, n = base / number(unit), int(c * unit)
                value, label = self.base_exponential(b)
            bases, values, counts = [*bases, b], [*values, value], [*counts, n]
            labels.append(label)
        if not self.has(e):
            return None  # it was the base itself
        total, given = _sum(counts, bases)
        product = " * ".join(
            f"exp v'{j} ^ {n}" if n > 0 else f"/ (exp v'{j} ^ {-n})" for j, n in enumerate(counts)
        )
        law, binder = self.label("L"), " ".join(f"v'{j}" for j in range(len(bases)))
        self.must(
            f"assert ({law} : forall {binder} : R, exp ({_sum(counts)[0]}) = {product}) by "
            "(intros; exponents)."
        )
        known = "; ".join(f"rewrite ?{label}" for label in labels)
        new = multiply(*(value**n for value, n in zip(values, counts, strict=True)))
        return self.exchange(
            e,
            new,
            f"transitivity (exp ({total})); [f_equal; {self.by_field} | "
            f"rewrite ({law} {given}); unfold same in *; {known}; {self.by_field}]",
        )

    def has(self, e: Expr) -> bool:
        """Whether it stands in a side."""
        return e in nodes(self.sides)

    def base_exponential(self, b: Expr) -> tuple[Expr, str]:
        """The exponential of a base exponent, by name."""
        if b not in self.exponents:
            name = self.exponents[b] = self.named(Expr("exp", (b,)))
            back, text = self.back(name), term(name)
            self.must(f"assert (0 < {text}) by ({back}; apply exp_pos).")
            self.fact(f"1 + {term(b)} <= {text}", f"{back}; apply exp_ineq1_le")
            self.fact(f"(1 - {term(b, 2)}) * {text} <= 1", f"{back}; apply exp_below")
        name = self.exponents[b]
        return name, f"D_{name.args[0]}"

    def of_logarithm(self, base: Expr, b: Expr, v: Expr, q: int) -> tuple[Expr, str]:
        """exp(ln(v)/q), and the name of the equation."""
        value = v if q == 1 else self.root_of(v, q)
        label, back = self.label("X"), self.back(base)
        proof = f"{back}; apply exp_ln; signed"
        if q != 1:
            proof = (
                f"replace {term(b, 3)} with (/ INR {q} * {term(base)}) by (simpl; field); {back}; "
                f"apply exp_part; [lia | signed | signed | {self.by_field}]"
            )
        self.must(f"assert ({label} : exp {term(b, 3)} = {term(value)}) by ({proof}).")
        return value, label

    def unit(self, kind: str, base: Expr, q: int) -> int:
        """What the base is divided by: it is as fine as it was ever asked for."""
        old = self.finest.get((kind, base), 1)
        new = self.finest[kind, base] = lcm(old, q)
        table = self.exponents if kind == "exp" else self.turns
        if new != old and base / number(old) in table:
            raise _AgainError
        return new

    # Angles.

    def trigonometric(self, e: Expr, u: Expr) -> None:
        """By the sines and cosines of a few angles."""
        if u == ZERO:
            value = ZERO if e.op == "sin" else ONE
            return self.exchange(e, value, f"apply {e.op}_0")
        atoms, quarters = [], 0
        for base, c in self.quotients.parts(u):
            if base == PI and (2 * c).q == 1:
                quarters = int((2 * c).p)
            else:
                unit = self.unit("turn", base, int(c.q))
                atoms.append((base / number(unit), int(c * unit)))
        found = self.turned(u, atoms, quarters)
        if not self.has(e):
            return None  # it was the base itself
        part = "proj1" if e.op == "sin" else "proj2"
        return self.exchange(
            e, found.sine if e.op == "sin" else found.cosine, f"exact ({part} {found.label})"
        )

    def turned(self, u: Expr, atoms: list[tuple[Expr, int]], quarters: int) -> Turned:
        """Sine and cosine of ``u``, a sum of multiples of base angles and of quarter turns."""
        if sum(abs(n) for _, n in atoms) + abs(quarters) > MULTIPLE:
            raise StuckError
        pairs = [self.base_angle(b) for b, _ in atoms]
        if not quarters and [n for _, n in atoms] == [1] and atoms[0][0] == u:
            return pairs[0]
        texts = [(f"sin v'{j}", f"cos v'{j}", n) for j, (_, n) in enumerate(atoms)]
        written = _addition_text(texts, quarters)
        s, c = _addition([(p.sine, p.cosine, n) for p, (_, n) in zip(pairs, atoms, strict=True)])
        for _ in range(quarters % 4):
            s, c = c, -s
        s, c = self.quotients.canonical(s), self.quotients.canonical(c)
        counts, bases = [n for _, n in atoms], [b for b, _ in atoms]
        total, given = _sum(counts, bases, quarters)
        names = " ".join(f"v'{j}" for j in range(len(atoms)))
        known = "; ".join(f"rewrite ?(proj1 {p.label}), ?(proj2 {p.label})" for p in pairs)
        shown = []
        for f, text in zip(("sin", "cos"), written, strict=True):
            law, binder = self.label("L"), f"forall {names} : R, " if names else ""
            self.must(
                f"assert ({law} : {binder}{f} ({_sum(counts, None, quarters)[0]}) = {text}) by "
                "(intros; turns)."
            )
            shown.append(
                f"transitivity ({f} ({total})); [f_equal; {self.by_field} | "
                f"rewrite ({law} {given}); {known or 'idtac'}; {self.by_field}]"
            )
        label = self.label("T")
        says = f"(sin {term(u, 3)} = {term(s)}) (cos {term(u, 3)} = {term(c)})"
        self.must(f"assert ({label} : both {says}) by (split; [{shown[0]} | {shown[1]}]).")
        return Turned(s, c, label)

    def base_angle(self, b: Expr) -> Turned:
        """Sine and cosine of a base angle, by names."""
        if b in self.turns:
            return self.turns[b]
        if b in SPECIAL:
            return self.special_angle(b, *SPECIAL[b])
        s, c = self.named(Expr("sin", (b,))), self.named(Expr("cos", (b,)))
        label, square = self.label("T"), self.label("R")
        self.must(
            f"assert ({square} : {term(s)} ^ 2 = 1 - {term(c)} ^ 2) by "
            f"({self.back(s)}; {self.back(c)}; apply sin_square)."
        )
        self.bound[s.args[0]] = square
        self.quotients.powers[s.args[0]] = (2, 1 - c**2)
        says = f"(sin {term(b, 3)} = {term(s)}) (cos {term(b, 3)} = {term(c)})"
        self.must(f"assert ({label} : both {says}) by (unfold same in *; split; assumption).")
        self.turns[b] = Turned(s, c, label)
        for name in (s, c):
            if self.sign(name) == 1:
                proof = "pose proof pi_between; first [apply cos_gt_0; lra | apply sin_gt_0; lra]"
                self.fact(f"0 < {term(name)}", f"{self.back(name)}; {proof}")
        return self.turns[b]

    def special_angle(self, b: Expr, n: int, s: Expr, c: Expr) -> Turned:
        """A third, a quarter or a sixth of π, whose sine and cosine have values."""
        s, c = (self.root_of(self.quotients.canonical(x), 2) for x in (s, c))
        label, says = (
            self.label("T"),
            f"(sin {term(b, 3)} = {term(s)}) (cos {term(b, 3)} = {term(c)})",
        )
        self.must(
            f"assert ({label} : both {says}) by (replace {term(b, 3)} with (PI / {n}) by field; "
            f"apply turn_special_{n}; [signed | signed | {self.by_field} | {self.by_field}])."
        )
        self.turns[b] = Turned(s, c, label)
        return self.turns[b]

    def inverse_function(self, e: Expr, u: Expr) -> None:
        """By an angle that has a name, or by a new name."""
        if u == ZERO and e.op != "acos":
            return self.exchange(e, ZERO, f"apply {e.op}_0")
        if e.op == "acos":
            asin = Expr("asin", (u,))
            new = Expr("+", (Expr("*", (HALF, PI)), Expr("*", (MINUS_ONE, asin))))
            return self.exchange(e, new, "rewrite acos_asin by (split; signed); field")
        for angle, atoms, quarters, halved in self.like(e):
            for g, _ in atoms:
                self.sided(g)
            found = self.turned(angle, atoms, quarters)
            known = f"rewrite ?(proj1 {found.label}), ?(proj2 {found.label})"
            law = "half_angle" if halved else "atan_unique" if e.op == "atan" else "asin_unique"
            theta = angle / 2 if halved else angle
            proof = f"apply {law}; [lra | {known}; {self.by_field}]"
            if halved:
                proof = f"replace {term(theta, 3)} with ({term(angle)} / 2) by field; {proof}"
            if self.equation(e, theta, proof):
                return None
        if e.op == "atan":
            self.jumps(e, u)
        return self.inverse_name(e, u)

    def sided(self, g: Expr) -> None:
        """The sign of an arc tangent, if it is constant."""
        sign, back = self.sign(g), self.back(g)
        if sign and self.is_arc_tangent[g]:
            says = f"0 < {term(g)}" if sign > 0 else f"{term(g)} < 0"
            self.fact(says, f"{back}; apply atan_{'above' if sign > 0 else 'below'}; signed")

    def jumps(self, e: Expr, u: Expr) -> None:
        """Cases by the sign of a factor, where there is an angle like this one for one sign."""
        for f, _ in self.quotients.factors(u)[1]:
            if self.sign(f) is None:
                above = copy(self)
                kept = zip(self.points, self.values(f), strict=True)
                above.points = [point for point, v in kept if v > 0]
                if next(above.like(e), None) is not None:
                    raise _CasesError(f, True)

    def like(self, e: Expr) -> Iterator[tuple[Expr, list[tuple[Expr, int]], int, bool]]:
        """Angles with the same values, or twice them: multiples of base angles and of π/2."""
        for halved in (False, True) if e.op == "atan" else (False,):
            for g in [ZERO, *self.is_arc_tangent]:
                for n in (1, -1, 2, -2) if g != ZERO else (0,):
                    for k in (0, 1, -1, 2, -2) if n else (1, -1):
                        angle = g * n + PI * number(Fraction(k, 2)) if k else g * n
                        if self.equal(angle, e * 2 if halved else e):
                            yield angle, [(g, n)] if n else [], k, halved

    def inverse_name(self, e: Expr, u: Expr) -> None:
        """A new name for an inverse function, with its sine, cosine and bounds."""
        op = e.op
        square = 1 + u**2 if op == "atan" else 1 - u**2
        root = self.root_of(self.quotients.canonical(square), 2)
        name = self.named(e)
        s, c = (u / root, 1 / root) if op == "atan" else (u, root)
        label, called, text = self.label("T"), f"D_{name.args[0]}", term(u, 3)
        within = "" if op == "atan" else "split; signed | "
        self.must(
            f"assert ({label} : both (sin {term(name)} = {term(s)}) (cos {term(name)} = {term(c)}))"
            f" by (pose proof (turn_{op} {text} {term(root, 3)}) as T; unfold same in {called}; "
            f"rewrite {called} in T; destruct T as [A B]; [{within}signed | {self.by_field} | "
            f"rewrite A, B; split; {self.by_field}])."
        )
        sign = "<" if op == "atan" else "<="
        self.must(
            f"assert (- PI / 2 {sign} {term(name)} {sign} PI / 2) by ({self.back(name)}; "
            f"pose proof ({op}_bound {text}); lra); pose proof pi_between."
        )
        self.turns[name] = Turned(s, c, label)
        self.is_arc_tangent[name] = op == "atan"

    # Roots.

    def root(self, u: Expr, q: int, odd: bool) -> None:
        """By roots of irreducible factors."""
        e = _root(u, q, odd)
        if u == ZERO:
            return self.exchange(e, ZERO, "apply sqrt_0", "apply root_zero")
        value = self.root_of(u, q)
        if self.has_root(u, q):
            proofs = {2: "apply sqrt_unique; [", 3: "apply root_unique_3; ["}
            proof = proofs.get(q, "apply root_unique_le; [lia | ")
            self.exchange(e, value, f"{proof}{'' if q == 3 else 'signed | '}{self.by_field}]")
        return None

    def has_root(self, u: Expr, q: int) -> bool:
        """Whether such a root stands in a side."""
        return any(is_root(e) and e.args[0] == u and _degree(e) == q for e in nodes(self.sides))

    def signed_factors(self, u: Expr, even: bool, three: bool) -> list[tuple[Expr, int]]:
        """Factors with their powers, primes among them; what is known to be so is positive.

        Where the sign of one decides on which side it is taken, and varies, there are cases.
        """
        constant, factors = self.quotients.factors(u)
        if constant == 0:
            raise StuckError
        negative = constant < 0
        found: list[tuple[Expr, int]] = []
        together: list[Expr] = []
        for f, n in factors:
            sign = self.sign(f)
            if sign is None and even:
                if n % 2 == 0 or (n < 0 and not three):
                    raise _CasesError(f, three)
                together.append(f**n)
                continue
            if sign == -1:
                negative ^= n % 2 == 1
                f = self.quotients.canonical(-f)
            found.append((f, n))
        if together:
            product = multiply(MINUS_ONE if negative else ONE, *together)
            found.append((self.quotients.canonical(product), 1))
        elif negative:
            found.append((MINUS_ONE, 1))
        for p, side in ((int(abs(constant).p), 1), (int(abs(constant).q), -1)):
            found += [(number(b), side * n) for b, n in (primes(p) if p < 10**9 else [(p, 1)])]
        return found

    def root_of(self, u: Expr, q: int) -> Expr:
        """The value of a root, by names."""
        values = []
        factors = self.signed_factors(u, q % 2 == 0, three=False)
        if q == 2 and len(factors) == 1 and (simpler := self.denested(*factors[0])) is not None:
            return simpler
        if q % 2 == 0 and len(factors) > 1:
            self.are_above(u, factors)
        for f, n in factors:
            if f == MINUS_ONE:
                if q % 2 == 0:
                    raise StuckError
                values.append(f)
                continue
            degree = q if q % 2 and self.sign(f) != 1 else self.fine(f, q)
            n *= degree // q
            values.append(f ** (n // degree) if n % degree == 0 else self.base_root(f, degree) ** n)
        return self.quotients.canonical(multiply(*values))

    def denested(self, f: Expr, n: int) -> Expr | None:
        """The root of A + B·√r as √P ± √Q, where A² − B²·r is a square."""
        parts = dict(self.quotients.parts(f))
        a = parts.pop(ONE, fmpq(0))
        if n != 1 or len(parts) != 1 or symbols(f) - set(self.quotients.powers):
            return None
        ((root, b),) = parts.items()
        square = dict(self.quotients.parts(root**2))
        d = a**2 - b**2 * square.get(ONE, fmpq(0))
        if (
            set(square) != {ONE}
            or d <= 0
            or not (isqrt(d.p) ** 2 == d.p and isqrt(d.q) ** 2 == d.q)
        ):
            return None
        w = fmpq(isqrt(d.p), isqrt(d.q))
        low, high = ((a + side * w) / 2 for side in (-1, 1))
        if low <= 0:
            return None
        return self.root_of(number(high), 2) + (1 if b > 0 else -1) * self.root_of(number(low), 2)

    def fine(self, f: Expr, q: int) -> int:
        """The degree of the root of a factor: as high as it was ever asked for."""
        old = self.finest.get(f, 1)
        new = self.finest[f] = lcm(old, q)
        if new != old and (f, old) in self.roots:
            raise _AgainError
        return new

    def base_root(self, f: Expr, q: int) -> Expr:
        """The name of a root, with what binds it."""
        if (f, q) in self.roots:
            return self.roots[f, q]
        if q % 2 == 0 and not (self.is_above(f) or self.is_above(f, strict=False)):
            raise _CasesError(f, False)
        name = self.named(_root(f, q, q == 3))
        text, back, relation = term(name), self.back(name), self.label("R")
        law = {2: "apply pow2_sqrt; signed", 3: "apply root_3_pow"}.get(
            q, "apply root_pow; [signed | lia]"
        )
        self.must(f"assert ({relation} : {text} ^ {q} = {term(f)}) by ({back}; {law}).")
        self.bound[name.args[0]] = relation
        self.quotients.powers[name.args[0]] = (q, f)
        strict, weak = ("sqrt_lt_R0", "sqrt_pos") if q == 2 else ("root_lt", "root_le")
        known = (q % 2 == 0 or self.sign(f) == 1) and (
            self.fact(f"0 < {text}", f"{back}; apply {strict}; signed")
            or self.fact(f"0 <= {text}", f"{back}; apply {weak}; signed", f"{back}; apply {weak}")
        )
        if q % 2 and not known:
            self.fact(f"{text} <> 0", f"{back}; apply root_nonzero; side")
        self.roots[f, q] = name
        return name

    # Logarithms.

    def logarithm(self, e: Expr, u: Expr) -> None:
        """By logarithms of irreducible factors."""
        factors = self.signed_factors(u, even=True, three=True)
        if sum(abs(n) for _, n in factors) > 2 * MULTIPLE:
            raise StuckError
        hidden = self.are_above(u, factors)
        if hidden is not None:
            raise _CasesError(hidden, True)
        terms, known = [], []
        for f, n in factors:
            value, label = self.logarithm_of(f)
            terms.append(value * n)
            known.append(f"rewrite ?{label}")
        if self.has(e):
            flat = [
                f if n > 0 else Expr("^", (f, MINUS_ONE)) for f, n in factors for _ in range(abs(n))
            ]
            into = f"replace {term(u, 3)} with ({_nested(flat)}) by ({self.by_field})"
            self.exchange(
                e,
                add(*terms),
                f"{into}; split_logs; {'; '.join(known) or 'rewrite ln_1'}; {self.by_field}",
            )

    def logarithm_of(self, f: Expr) -> tuple[Expr, str]:
        """The logarithm of a factor, and the name of the equation that says so."""
        label, says = self.label("K"), f"ln {term(f, 3)} ="
        for b, name in self.exponents.items():
            if name == f:
                self.must(f"assert ({label} : {says} {term(b)}) by ({self.back(f)}; apply ln_exp).")
                return b, label
        for (v, q), name in self.roots.items():
            if name == f:
                inner, other = self.logarithm_of(v)
                value = inner / q
                self.must(
                    f"assert ({label} : {says} {term(value)}) by (apply (ln_of_root {q} _ "
                    f"{term(v, 3)}); [lia | signed | {self.by_field} | "
                    f"rewrite {other}; simpl; field])."
                )
                return value, label
        for g, name in self.logarithms.items():
            for m, n in ((1, 1), (1, -1), (1, 2), (1, -2), (2, 1), (2, -1)):
                if f == g and (m, n) == (1, 1):
                    return name, f"D_{name.args[0]}"
                value = name * number(Fraction(n, m))
                if not self.equal(value, Expr("log", (f,))):
                    continue
                law = "ln_like" if n > 0 else "ln_unlike"
                if self.say(
                    f"assert ({label} : {says} {term(value)}) by (apply ({law} {m} {abs(n)} _ "
                    f"{term(g, 3)}); [lia | signed | signed | {self.by_field} | "
                    f"unfold same in *; rewrite D_{name.args[0]}; simpl; field])."
                ):
                    return value, label
        name = self.logarithms[f] = self.named(Expr("log", (f,)))
        return name, f"D_{name.args[0]}"


def _degree(e: Expr) -> int:
    """The degree of a root."""
    return 3 if e.op == "cbrt" else int(e.args[1].args[0].q)


def _root(u: Expr, q: int, odd: bool) -> Expr:
    return Expr("cbrt", (u,)) if odd else Expr("^", (u, number(Fraction(1, q))))


def _is_zero(v: arb) -> bool:
    """Whether it is zero, as far as it is known."""
    return bool(v.is_finite() and v.contains(0) and v.rad() < arb("1e-20"))


def _sum(counts: list[int], bases: list[Expr] | None = None, quarters: int = 0) -> tuple[str, str]:
    """A sum of multiples, written out, and the bases; variables where there are no bases."""
    names = [f"v'{j}" if bases is None else f"({term(bases[j])})" for j in range(len(counts))]
    each = zip([*names, "(PI / 2)"], [*counts, quarters], strict=True)
    parts = [name if n > 0 else f"- {name}" for name, n in each for _ in range(abs(n))]
    return " + ".join(parts) or "0", " ".join(names)


def _addition_text(atoms: list[tuple[str, str, int]], quarters: int) -> tuple[str, str]:
    """The sine and cosine of a sum of multiples, as text."""
    sine, cosine = "0", "1"
    for s, c, n in atoms:
        s = s if n > 0 else f"(- {s})"
        for _ in range(abs(n)):
            sine, cosine = f"({sine} * {c} + {cosine} * {s})", f"({cosine} * {c} - {sine} * {s})"
    for _ in range(quarters % 4):
        sine, cosine = cosine, f"(- {sine})"
    return sine, cosine


def _addition(atoms: list[tuple[Expr, Expr, int]]) -> tuple[Expr, Expr]:
    """The same as expressions."""
    sine, cosine = ZERO, ONE
    for s, c, n in atoms:
        s = s if n > 0 else -s
        for _ in range(abs(n)):
            sine, cosine = sine * c + cosine * s, cosine * c - sine * s
    return sine, cosine


def _nested(factors: list[Expr]) -> str:
    """A product with brackets to the right."""
    if not factors:
        return "1"
    first, *rest = factors
    return f"{term(first, 3)} * ({_nested(rest)})" if rest else term(first, 3)
