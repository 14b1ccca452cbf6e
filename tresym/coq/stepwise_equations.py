"""Prove equations step by step, asking Coq after every step.

Innermost functions are treated first, as soon as their arguments are rational functions of named
real numbers. Each is either expressed in existing names or gets a new one: a root, an exponential
and a sine–cosine pair satisfy one polynomial equation each, an inverse function is described by its
sine and cosine. Equalities are guessed from values at a few sample points and then proved. Where a
sign matters and is not constant at the points, the proof splits into cases. The remaining equation
is left to ``field``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from fractions import Fraction
from math import gcd

from flint import arb, fmpq

from tresym.coq.equations import is_root, nodes
from tresym.coq.irreducible_bases import MULTIPLE, Bases
from tresym.coq.proof_script import (
    HYPERBOLIC,
    AgainError,
    Ask,
    CasesError,
    StuckError,
    Turned,
    degree_of,
)
from tresym.coq.rational_functions import LEAVES, Quotients
from tresym.coq.statement import Theorem, term
from tresym.reals.language.expression import (
    HALF,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    multiply,
    number,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

SPECIAL = {
    PI / 3: (3, number(Fraction(3, 4)), number(Fraction(1, 4))),
    PI / 4: (4, HALF, HALF),
    PI / 6: (6, number(Fraction(1, 4)), number(Fraction(3, 4))),
}
"""Parts of π with the squares of their sine and cosine."""
SPLITS = 4
TURNING = ("exp", "sin", "cos")


def stepwise(theorem: Theorem, ask: Ask, begin: Callable[[], None]) -> str | None:
    """Return a proof of an equation, or None if none was found.

    Args:
        theorem: the theorem.
        ask: returns whether Coq accepts a sentence.
        begin: restarts the proof in Coq.
    """
    inside = {e.op for e in nodes([theorem.left, theorem.right])}
    for plainly in (True, False) if inside.intersection(HYPERBOLIC) else (False,):
        finest: dict[object, fmpq] = {}
        for _ in range(8):
            begin()
            try:
                with ball_precision():
                    proof = _Steps(theorem, ask, finest, plainly)
                    proof.must(f"intros; saturate; spell{'_plainly' if plainly else ''}.")
                    proof.go_on()
            except AgainError:
                continue
            except (StuckError, InputError, OverflowError, RecursionError, ZeroDivisionError):
                break
            return "\n".join(proof.lines)
    return None


class _Steps(Bases):
    """A proof under construction."""

    # The walk.

    def go_on(self) -> None:
        """Return the rest of the proof."""
        if not self.points:
            for g in self.is_arc_tangent:
                self.sided(g)
            return self.must("exfalso; absurd_.")
        self.said_at_first()
        while (node := self.next()) is not None:
            try:
                self.step(node)
            except CasesError as cases:
                return self.in_cases(*cases.args)
        return self.must(f"{self.by_field}.")

    def said_at_first(self) -> None:
        """State what later steps need: signs of products, and arguments of asin in their domain."""
        found = sorted(nodes(self.sides), key=lambda e: e.size)
        for e in found:
            if e.op in ("asin", "acos") and e.args[0].op not in LEAVES:
                self.fact(f"-1 <= {term(e.args[0])}", "lra")
                self.fact(f"{term(e.args[0])} <= 1", "lra")
        for e in found:
            if e.op == "sign":
                self.paired(e.args[0])
            if e.op == "atan":
                sine, cosine = (Expr(f, (e,)) for f in ("sin", "cos"))
                law = f"(sin_over_cos {term(e.args[0], 3)})"
                self.multiplied(sine, Expr("^", (cosine, MINUS_ONE)), e.args[0], law)

    def next(self) -> Expr | None:
        """Return the smallest part that is not yet expressed in names."""
        ready = self.ready()
        return min(
            ready, key=lambda e: (e.op == "sign", e.op == "abs", e.size, str(e)), default=None
        )

    def ready(self) -> list[Expr]:
        """Return a part whose arguments are all expressed in names."""
        left = [e for e in nodes(self.sides) if not _plain(e) and e not in self.done]
        return [e for e in left if not any(part in left for part in nodes(e.args))]

    def step(self, e: Expr) -> None:
        """Express one part in names."""
        u = e.args[0]
        better = self.quotients.canonical(u)
        if better != u and (e.op == "log" or (is_root(e) and e.op != "cbrt")):
            self.fact(f"0 {'<' if e.op == 'log' else '<='} {term(u)}", "plainly")
        if better != u and self.equation(u, better, self.by_field):
            e, u = Expr(e.op, (better, *e.args[1:])), better
        if e.op in TURNING:
            self.alike(u)
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
            case _ if e.op in HYPERBOLIC:
                self.hyperbolic(e, u)
            case _ if is_root(e):
                self.root(u, degree_of(e), e.op == "cbrt")
            case _:
                self.done.add(e)

    def alike(self, u: Expr) -> None:
        """Rewrite angles and exponents that equal ``u`` or −u in another form."""
        for v in dict.fromkeys(e.args[0] for e in self.ready() if e.op in TURNING):
            for same in (u, -u):
                if v not in (u, -u) and self.equal(v, same):
                    self.equation(v, same, self.by_field)

    def in_cases(self, u: Expr, three: bool) -> None:
        """Split the proof into cases by the sign of ``u``."""
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
            case.refused = set()
            case.quotients = Quotients()
            case.quotients.powers = dict(self.quotients.powers)
            pairs = zip(self.points, values, strict=True)
            case.points = [dict(p) for p, v in pairs if (v > 0 if want > 0 else v < 0)]
            self.must("{")
            if want or not case.at_zero(u, name, self.points):
                case.go_on()
            self.must("}")
            self.count = case.count

    def at_zero(self, u: Expr, name: str, points: list[dict[str, arb | fmpq]]) -> bool:
        """Prove the case ``u = 0`` if that is immediate; otherwise set a variable to zero."""
        if self.say("exfalso; absurd_."):
            return True
        saved_points, self.points = self.points, points
        zeros = [f for f, n in self.quotients.factors(u)[1] if n > 0 and self.sign(f) is None]
        self.points = saved_points
        if len(zeros) != 1 or zeros[0].op != "symbol":
            raise StuckError
        x = zeros[0]
        text, own = term(x), x.args[0]
        self.must(f"assert ({name}z : {text} = 0) by (first [lra | nra | vanish]); subst {text}.")
        self.put(x, ZERO)
        self.points = [dict(point) | {own: fmpq(0)} for point in points]
        if own in self.bound:
            relation, (q, by) = self.bound.pop(own), self.quotients.powers.pop(own)
            cosine = self.quotients.cosine(by) if q == 2 else None
            if cosine is not None:
                c = cosine.args[0]
                self.must(f"assert ({name}c : {c} ^ 2 = 1) by (clear - {relation}; nra).")
                self.bound[c], self.quotients.powers[c] = f"{name}c", (2, ONE)
                self.points = [p | {c: fmpq(1) if p[c] > 0 else fmpq(-1)} for p in self.points]
        return False

    # Absolute values and signs.

    def of_sign(self, e: Expr, u: Expr) -> None:
        """Eliminate an absolute value or a sign."""
        sign = self.sign(u)
        if u == ZERO:
            return self.exchange(e, ZERO, "apply sign_zero", "apply Rabs_R0")
        strict = e.op == "sign"
        if not sign or not self.is_above(u if sign > 0 else -u, strict):
            if self.paired(u):
                return None
            raise CasesError(u, strict)
        if strict:
            law = "sign_pos" if sign > 0 else "sign_neg"
            return self.exchange(e, number(sign), f"apply {law}; lra")
        law = "Rabs_pos_eq" if sign > 0 else "Rabs_left1"
        proof = f"rewrite {law} by lra; {self.by_field}"
        return self.exchange(e, u if sign > 0 else -u, proof)

    def paired(self, u: Expr) -> bool:
        """Simplify a product of the sign and the absolute value of ``u``, or of a root."""
        sign, absolute = Expr("sign", (u,)), Expr("abs", (u,))
        root = Expr("^", (absolute, number(Fraction(1, 3))))
        base, n = u.args if u.op == "^" else (u, ONE)
        square = Expr("^", (base, n * 2))
        of_square = f"{term(u, 3)} {term(square, 3)} ltac:(ring)"
        return (
            self.multiplied(sign, absolute, u, f"(sign_abs {term(u, 3)})")
            or self.multiplied(sign, Expr("^", (square, HALF)), u, f"(sign_sqrt {of_square})")
            or self.multiplied(sign, root, Expr("cbrt", (u,)), f"(sign_root 3 {term(u, 3)})")
        )

    def multiplied(self, one: Expr, other: Expr, new: Expr, law: str) -> bool:
        """Rewrite products of two given factors by a law; return whether any occurred."""
        products = [e for e in nodes(self.sides) if e.op == "*" and {one, other} <= {*e.args}]
        for e in sorted(products, key=lambda e: -e.size):
            rest = list(e.args)
            rest.remove(one)
            rest[rest.index(other)] = new
            value = rest[0] if len(rest) == 1 else Expr("*", tuple(rest))
            self.equation(e, value, f"factors {law} ({term(one)}) ({term(other)})")
        return bool(products)

    # Exponentials.

    def hyperbolic(self, e: Expr, u: Expr) -> None:
        """Express an inverse hyperbolic function by an existing or a new name."""
        for name, g in self.hyperbolics.items():
            v = g.args[0]
            for n in (1, -1) if e.op != "acosh" else ():
                if not self.equal(e, name * n):
                    continue
                odd = f"({'arcsinh' if g.op == 'asinh' else 'atanh'}_odd _ {term(v, 3)})"
                if g.op == e.op:
                    proof = f"f_equal; {self.by_field}"
                    if n < 0:
                        proof = f"rewrite {odd} by (first [{self.by_field} | split; signed]); ring"
                else:
                    x, y = (u, v * n) if e.op == "asinh" else (v * n, u)
                    root = self.root_of(self.quotients.canonical(1 + x**2), 2)
                    proof = (
                        f"rewrite {'<- ' if e.op == 'atanh' else ''}(arcsinh_atanh {term(x, 3)} "
                        f"{term(y, 3)} {term(root, 3)}) by (first [signed | {self.by_field}])"
                    )
                    if n < 0:
                        proof += f"; rewrite {odd} by (first [ring | split; signed])"
                    proof += "; ring"
                if self.equation(e, name * n, f"{self.back(name)}; {proof}"):
                    return
        name = self.named(e)
        self.hyperbolics[name] = e

    def exponential(self, e: Expr, u: Expr) -> None:
        """Write an exponential by a few base exponentials and by logarithms in its exponent."""
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
                unit = self.unit("exp", base, c)
                b, n = base * number(unit), int((c / unit).p)
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

    def base_exponential(self, b: Expr) -> tuple[Expr, str]:
        """Return the name of the exponential of a base exponent."""
        if b not in self.exponents:
            name = self.exponents[b] = self.named(Expr("exp", (b,)))
            back, text = self.back(name), term(name)
            self.must(f"assert (0 < {text}) by ({back}; apply exp_pos).")
            self.fact(f"1 + {term(b)} <= {text}", f"{back}; apply exp_ineq1_le")
            self.fact(f"(1 - {term(b, 2)}) * {text} <= 1", f"{back}; apply exp_below")
        name = self.exponents[b]
        return name, f"D_{name.args[0]}"

    def of_logarithm(self, base: Expr, b: Expr, v: Expr, q: int) -> tuple[Expr, str]:
        """Return exp(ln(v)/q) and the name of its equation."""
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

    def unit(self, kind: str, base: Expr, c: fmpq) -> fmpq:
        """Return the largest unit of the base of which all occurring multiples are multiples."""
        if base == PI or base in self.is_arc_tangent:
            c = fmpq(1, c.q)
        old = self.finest.get((kind, base), fmpq(0))
        new = fmpq(gcd(old.p * c.q, c.p * old.q), old.q * c.q)
        self.finest[kind, base] = new
        table = self.exponents if kind == "exp" else self.turns
        if new != old and old != 0 and base * number(old) in table:
            raise AgainError
        return new

    # Angles.

    def trigonometric(self, e: Expr, u: Expr) -> None:
        """Write a sine or cosine in terms of those of a few base angles."""
        if u == ZERO:
            value = ZERO if e.op == "sin" else ONE
            return self.exchange(e, value, f"apply {e.op}_0")
        atoms, quarters = [], 0
        for base, c in self.quotients.parts(u):
            if base == PI and (2 * c).q == 1:
                quarters = int((2 * c).p)
            else:
                unit = self.unit("turn", base, c)
                atoms.append((base * number(unit), int((c / unit).p)))
        found = self.turned(u, atoms, quarters)
        if not self.has(e):
            return None  # it was the base itself
        part = "proj1" if e.op == "sin" else "proj2"
        return self.exchange(
            e, found.sine if e.op == "sin" else found.cosine, f"exact ({part} {found.label})"
        )

    def turned(self, u: Expr, atoms: list[tuple[Expr, int]], quarters: int) -> Turned:
        """Return sine and cosine of ``u``, a sum of multiples of base angles and of π/2."""
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
        """Return sine and cosine of a base angle as names."""
        if b in self.turns:
            return self.turns[b]
        if b in self.inverses:
            return self.inverse_angle(b, self.inverses[b])
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
        """Return the exact sine and cosine of π/3, π/4 or π/6."""
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
        """Express an inverse function by an existing or a new angle."""
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
            within = "" if halved or e.op != "atan" else f"apply atan_unique_le; {proof[19:]}"
            within = within.replace("[lra |", f"[lra | rewrite (proj2 {found.label}); signed |")
            if self.equation(e, theta, proof, *filter(None, [within])):
                return None
        if e.op == "atan":
            self.jumps(e, u)
        return self.inverse_name(e, u)

    def sided(self, g: Expr) -> None:
        """Prove the sign of an inverse function, if it is constant."""
        back, law = self.back(g), "atan" if self.is_arc_tangent[g] else "asin"
        signs = {self.sign(g)} if self.points else {1, -1}
        for sign, says, way in ((1, f"0 < {term(g)}", "above"), (-1, f"{term(g)} < 0", "below")):
            if sign in signs and self.fact(says, f"{back}; apply {law}_{way}; signed"):
                return

    def jumps(self, e: Expr, u: Expr) -> None:
        """Distinguish the signs of a factor, if for one of them an angle like ``e`` is known."""
        for f, _ in self.quotients.factors(u)[1]:
            if self.sign(f) is None:
                above = copy(self)
                pairs = zip(self.points, self.values(f), strict=True)
                above.points = [point for point, v in pairs if v > 0]
                if next(above.like(e), None) is not None:
                    raise CasesError(f, True)

    def like(self, e: Expr) -> Iterator[tuple[Expr, list[tuple[Expr, int]], int, bool]]:
        """Return angles with equal values at the points, up to a factor 2 or multiples of π/2."""
        for halved in (False, True) if e.op == "atan" else (False,):
            for g in [ZERO, *self.is_arc_tangent]:
                for n in (1, -1, 2, -2) if g != ZERO else (0,):
                    for k in (0, 1, -1, 2, -2) if n else (1, -1):
                        angle = g * n + PI * number(Fraction(k, 2)) if k else g * n
                        if self.equal(angle, e * 2 if halved else e):
                            yield angle, [(g, n)] if n else [], k, halved

    def inverse_name(self, e: Expr, u: Expr) -> None:
        """Introduce a name for an inverse function, with its bounds."""
        op, name = e.op, self.named(e)
        sign = "<" if op == "atan" else "<="
        self.must(
            f"assert (- PI / 2 {sign} {term(name)} {sign} PI / 2) by ({self.back(name)}; "
            f"pose proof ({op}_bound {term(u, 3)}); lra); pose proof pi_between."
        )
        self.inverses[name] = e
        self.is_arc_tangent[name] = op == "atan"

    def inverse_angle(self, name: Expr, e: Expr) -> Turned:
        """Return the sine and cosine of a named inverse function."""
        op, u = e.op, e.args[0]
        square = 1 + u**2 if op == "atan" else 1 - u**2
        root = self.root_of(self.quotients.canonical(square), 2)
        s, c = (u / root, 1 / root) if op == "atan" else (u, root)
        label, called, text = self.label("T"), f"D_{name.args[0]}", term(u, 3)
        within = "" if op == "atan" else "split; signed | "
        self.must(
            f"assert ({label} : both (sin {term(name)} = {term(s)}) (cos {term(name)} = {term(c)}))"
            f" by (pose proof (turn_{op} {text} {term(root, 3)}) as T; unfold same in {called}; "
            f"rewrite {called} in T; destruct T as [A B]; [{within}signed | {self.by_field} | "
            f"rewrite A, B; split; {self.by_field}])."
        )
        self.turns[name] = Turned(s, c, label)
        return self.turns[name]


def _plain(e: Expr) -> bool:
    """Return whether ``e`` is already expressed in names."""
    return e.op in ("+", "*", *LEAVES) or (
        e.op == "^"
        and not is_root(e)
        and bool(e.args[1].args[0] > 0 or e.args[0].op in ("symbol", "pi"))
    )


def _sum(counts: list[int], bases: list[Expr] | None = None, quarters: int = 0) -> tuple[str, str]:
    """Write a sum of multiples and its bases; use variables if there are no bases."""
    names = [f"v'{j}" if bases is None else f"({term(bases[j])})" for j in range(len(counts))]
    each = zip([*names, "(PI / 2)"], [*counts, quarters], strict=True)
    parts = [name if n > 0 else f"- {name}" for name, n in each for _ in range(abs(n))]
    return " + ".join(parts) or "0", " ".join(names)


def _addition_text(atoms: list[tuple[str, str, int]], quarters: int) -> tuple[str, str]:
    """Return the sine and cosine of a sum of multiples as text."""
    sine, cosine = "0", "1"
    for s, c, n in atoms:
        s = s if n > 0 else f"(- {s})"
        for _ in range(abs(n)):
            sine, cosine = f"({sine} * {c} + {cosine} * {s})", f"({cosine} * {c} - {sine} * {s})"
    for _ in range(quarters % 4):
        sine, cosine = cosine, f"(- {sine})"
    return sine, cosine


def _addition(atoms: list[tuple[Expr, Expr, int]]) -> tuple[Expr, Expr]:
    """Return the sine and cosine of a sum of multiples as expressions."""
    sine, cosine = ZERO, ONE
    for s, c, n in atoms:
        s = s if n > 0 else -s
        for _ in range(abs(n)):
            sine, cosine = sine * c + cosine * s, cosine * c - sine * s
    return sine, cosine
