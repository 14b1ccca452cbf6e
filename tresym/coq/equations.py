"""Proofs of equations: every part that is no rational function gets a name, and ``field`` the rest.

Angles and exponents are whole multiples of a few, by the addition theorems; a sine and a cosine of
one angle, and a root and its radicand, are bound by one equation each, whose leading powers have
nothing in common. What ``field`` does with these equations is then a normal form.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction

from tresym.coq.linear import expanded, whole_basis
from tresym.coq.statement import Theorem, term
from tresym.reals.language.expression import (
    HALF,
    ONE,
    PI,
    Expr,
    add,
    differentiate,
    multiply,
    number,
    power,
)

LEAVES = ("number", "symbol", "pi")
OPAQUE = ("log", "asin", "acos", "atan", "asinh", "acosh", "atanh", "atan2")
MAX_MULTIPLE = 24


def equation_proofs(theorem: Theorem) -> Iterator[str]:
    """Proofs of an equation, or of a derivative, to try."""
    yield Script(theorem).text()


def nodes(expressions: Iterable[Expr]) -> list[Expr]:
    """All parts of the expressions, each once."""
    seen: dict[Expr, None] = {}
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node not in seen and node.op != "number":
            seen[node] = None
            if node.op not in LEAVES:
                stack.extend(node.args)
    return list(seen)


def unfolded(e: Expr) -> Expr:
    """``e`` as ``laws`` of Tresym.v leaves it, with sin, cos, exp, sign and what is opaque."""
    if e.op in LEAVES:
        return e
    args = tuple(map(unfolded, e.args))
    u = args[0]

    def f(name: str) -> Expr:
        return Expr(name, (u,))

    match e.op:
        case "^" if e.args[1].op != "number":
            return Expr("exp", (Expr("*", (args[1], f("log"))),))
        case "tan":
            return Expr("*", (f("sin"), _inverse(f("cos"))))
        case "cot":
            return Expr("*", (f("cos"), _inverse(f("sin"))))
        case "sec" | "csc":
            return _inverse(f("cos" if e.op == "sec" else "sin"))
        case "sinh" | "cosh" | "tanh" | "coth" | "sech" | "csch":
            plus = Expr("+", (f("exp"), _inverse(f("exp"))))
            minus = Expr("+", (f("exp"), Expr("*", (number(-1), _inverse(f("exp"))))))
            sinh, cosh = Expr("*", (minus, HALF)), Expr("*", (plus, HALF))
            return {
                "sinh": sinh,
                "cosh": cosh,
                "tanh": Expr("*", (minus, _inverse(plus))),
                "coth": Expr("*", (cosh, _inverse(sinh))),
                "sech": _inverse(cosh),
                "csch": _inverse(sinh),
            }[e.op]
        case "abs":
            return Expr("*", (f("sign"), u))
    return Expr(e.op, args)


def _inverse(e: Expr) -> Expr:
    return Expr("^", (e, number(-1)))


def quotient(e: Expr) -> tuple[Expr, Expr]:
    """A numerator and a denominator of ``e`` as a rational function of its other parts."""
    if e.op == "number":
        value = e.args[0]
        return number(int(value.p)), number(int(value.q))
    if e.op == "*":
        top, bottom = ONE, ONE
        for arg in e.args:
            p, q = quotient(arg)
            top, bottom = top * p, bottom * q
        return top, bottom
    if e.op == "+":
        parts = [quotient(arg) for arg in e.args]
        bottoms = Counter[Expr]()
        for _, q in parts:
            bottoms |= Counter(_factors(q))
        bottom = multiply(*bottoms.elements())
        tops = [multiply(p, *(bottoms - Counter(_factors(q))).elements()) for p, q in parts]
        return add(*tops), bottom
    if e.op == "^" and e.args[1].op == "number":
        r = e.args[1].args[0]
        p, q = quotient(e.args[0]) if r.q == 1 else (e.args[0], ONE)
        p, q = (p, q) if r > 0 else (q, p)
        if r.q != 1:
            p, q = (power(x, number(abs(r))) if x != ONE else x for x in (p, q))
        else:
            p, q = (power(x, number(abs(int(r.p)))) for x in (p, q))
        return p, q
    return e, ONE


def _factors(e: Expr) -> list[Expr]:
    """The factors of a product, powers written out."""
    found: list[Expr] = []
    for arg in e.args if e.op == "*" else (e,):
        whole = arg.op == "^" and arg.args[1].op == "number" and arg.args[1].args[0].q == 1
        if whole and 0 < arg.args[1].args[0] <= 50:
            found += [arg.args[0]] * int(arg.args[1].args[0].p)
        elif arg != ONE:
            found.append(arg)
    return found


def inner(e: Expr, operations: Iterable[str]) -> bool:
    """Whether an operation among those stands inside ``e``."""
    return any(part.op in operations for arg in e.args for part in nodes([arg]))


class Script:
    """The sentences of a proof of an equation."""

    def __init__(self, theorem: Theorem) -> None:
        self.theorem = theorem
        self.lines: list[str] = ["intros; saturate."]
        self.relations: list[str] = []
        self.count = 0
        self.names: list[str] = []
        self.after: list[str] = []
        self.done: set[Expr] = set()
        self.angles: list[Expr] = []
        self.exponents: list[Expr] = []

    def fresh(self, letter: str) -> str:
        """A name not used before."""
        self.count += 1
        return f"{letter}_{self.count}"

    def add(self, line: str) -> None:
        """One more sentence."""
        self.lines.append(line)

    def text(self) -> str:
        """The whole proof."""
        t = self.theorem
        parts = [t.left, t.right, *(e for e, _ in t.defined)]
        parts += [e for x, _, y in t.given for e in (x, y)]
        if t.by is not None:
            parts.append(differentiate(t.left, t.by))
            self.add("eapply d_eq; [derive; hard |]; tidy.")
            if any(e.op in ("asin", "acos", "asinh") for e in nodes([t.left])):
                self.add("join_roots.")
        self.add("laws.")
        self.prepared(parts)
        for line in self.after:
            self.add(line)
        known = f" [{' '.join(self.relations)}]" if self.relations else ""
        self.add(f"field{known}.")
        self.add(f"all: try side. all: try (sides ltac:(fun _ => ring{known})). all: try nra.")
        return "\n".join(self.lines)

    def prepared(self, parts: Iterable[Expr]) -> None:
        """Facts and names for everything in the parts."""
        self.tops(self.theorem)
        every = nodes(map(unfolded, parts))
        every.sort(key=lambda e: (-e.size, str(e)))
        special = [e for e in every if e.op in OPAQUE or is_root(e) or e.op == "sign"]
        for e in special:
            if inner(e, ("sin", "cos", "exp")):
                self.opaque(e)
        self.trigonometry(every)
        self.exponentials(every)
        for e in special:
            if not inner(e, ("sin", "cos", "exp")):
                self.opaque(e)
        self.bases()
        if self.names:
            self.add(f"clearbody {' '.join(dict.fromkeys(self.names))}.")

    def tops(self, t: Theorem) -> None:
        """That a quotient is not 0 says that its numerator is not."""
        for e, relation in t.defined:
            e = unfolded(e)
            top, bottom = quotient(e)
            if relation != ">=" and bottom.op != "number" and top.op != "number":
                self.add(
                    f"try (assert ({term(top)} <> 0) by (apply (top_nonzero {term(e, 3)} _ "
                    f"{term(bottom, 3)}); [first [assumption | apply Rgt_not_eq; assumption] | "
                    "field; side])); saturate."
                )

    def opaque(self, e: Expr) -> None:
        """A name for a root, a sign, a logarithm, an inverse function, and what binds it."""
        u = e.args[0]
        name = self.fresh("g")
        if e.op == "sign":
            relation = self.fresh("R")
            self.add(f"assert ({relation} : {term(e)} ^ 2 = 1) by (apply sign_square; side).")
            self.relations.append(relation)
        elif is_root(e):
            q = 3 if e.op == "cbrt" else int(e.args[1].args[0].q)
            e = e if e.op == "cbrt" else Expr("^", (u, number(Fraction(1, q))))
            if e in self.done:
                return
            self.done.add(e)
            self.root(e, u, q, name)
        text = term(e)
        self.add(f"set ({name} := {text}) in *.")
        self.names.append(name)

    def root(self, e: Expr, u: Expr, q: int, name: str) -> None:
        """The power of a root; that it is positive."""
        law = "sqrt_lt_R0" if q == 2 else "root_lt"
        self.add(f"try (assert (0 < {term(e)}) by (apply {law}; hard)).")
        if q != 2:
            self.add(f"try (assert ({term(e)} <> 0) by (apply root_nonzero; side)).")
        proof = {2: "apply pow2_sqrt; hard"}.get(q, "apply root_pow; [hard | lia]")
        proof = "apply root_3_pow" if e.op == "cbrt" else proof
        top, bottom = quotient(u)
        relation = self.fresh("R")
        if bottom == ONE or bottom.op == "number":
            self.add(f"assert ({relation} : {term(e, 3)} ^ {q} = {term(u)}) by ({proof}).")
            self.relations.append(relation)
            return
        new, whole, equal = self.fresh("g"), self.fresh("R"), self.fresh("Q")
        self.add(f"assert ({relation} : {term(e, 3)} ^ {q} = {term(u)}) by ({proof}).")
        self.add(f"pose ({new} := {term(e, 3)} * {term(bottom, 3)}).")
        self.add(
            f"assert ({equal} : {term(e)} = {new} * / {term(bottom, 3)}) by "
            f"(unfold {new}; field; side)."
        )
        self.add(
            f"assert ({whole} : {new} ^ {q} = {term(top, 3)} * {term(bottom, 3)} ^ {q - 1}) by "
            f"(unfold {new}; rewrite Rpow_mult_distr, {relation}; field; side)."
        )
        self.add(f"clearbody {new}; clear {relation}.")
        self.relations.append(whole)
        self.after.append(f"subst {name}.")

    def trigonometry(self, every: list[Expr]) -> None:
        """Sines and cosines by those of a few angles."""
        angles = [e.args[0] for e in every if e.op in ("sin", "cos")]
        if not angles:
            return
        turns = {u: _quarters(u) for u in angles}
        bases, whole = whole_basis([v for v, _ in turns.values()])
        self.angles = bases
        for u in dict.fromkeys(angles):
            v, quarters = turns[u]
            if u not in bases:
                self.multiple(u, bases, whole[v], quarters)

    def multiple(self, u: Expr, bases: list[Expr], c: list[int], quarters: int) -> None:
        """The sine and cosine of u = Σ c·base + quarters·π/2."""
        names = [f"p{j}" for j, n in enumerate(c) if n]
        atoms = [(f"p{j}", n) for j, n in enumerate(c) if n]
        total = " + ".join(_repeated(name, n) for name, n in atoms) or "0"
        shift = f" + {quarters} * (PI / 2)" if quarters > 0 else f" + - ({-quarters} * (PI / 2))"
        sine, cosine = _addition(atoms)
        sine, cosine = _turned(sine, cosine, quarters)
        total = total + (shift if quarters else "")
        for f, value in (("sin", sine), ("cos", cosine)):
            law, use = self.fresh("L"), self.fresh("E")
            binder = f"forall {' '.join(names)} : R, " if names else ""
            self.add(f"assert ({law} : {binder}{f} ({total}) = {value}) by (intros; angles).")
            given = " ".join(f"({term(b)})" for b, n in zip(bases, c, strict=True) if n)
            self.add(
                f"assert ({use} : {f} {term(u, 3)} = _) by "
                f"(refine (eq_trans _ ({law} {given})); f_equal; field; side)."
            )
            self.add(f"try rewrite {use} in *; clear {law}.")

    def exponentials(self, every: list[Expr]) -> None:
        """Exponentials by those of a few exponents."""
        found = [e.args[0] for e in every if e.op == "exp"]
        logs = [e for e in every if e.op == "log"]
        if not found:
            return
        inside = {part for u in found for monomial in expanded(u) for part, _ in monomial}
        bases, whole = whole_basis(found, [e for e in logs if e in inside])
        self.exponents = bases
        for u in dict.fromkeys(found):
            if u in bases:
                continue
            c = whole[u]
            names = [f"p{j}" for j, n in enumerate(c) if n]
            atoms = [(f"p{j}", n) for j, n in enumerate(c) if n]
            total = " + ".join(_repeated(name, n) for name, n in atoms) or "0"
            value = " * ".join(
                f"exp {name} ^ {n}" if n > 0 else f"/ (exp {name} ^ {-n})" for name, n in atoms
            )
            law, use = self.fresh("L"), self.fresh("E")
            binder = f"forall {' '.join(names)} : R, " if names else ""
            self.add(
                f"assert ({law} : {binder}exp ({total}) = {value or 1}) by (intros; exponents)."
            )
            given = " ".join(f"({term(b)})" for b, n in zip(bases, c, strict=True) if n)
            self.add(
                f"assert ({use} : exp {term(u, 3)} = _) by "
                f"(refine (eq_trans _ ({law} {given})); f_equal; field; side)."
            )
            self.add(f"try rewrite {use} in *; clear {law}.")
        for log in logs:
            if log in bases:
                self.add(f"rewrite (exp_ln {term(log.args[0], 3)}) in * by side.")

    def bases(self) -> None:
        """Names for sines, cosines and exponentials of the base."""
        for b in self.angles:
            relation, s, c = self.fresh("R"), self.fresh("g"), self.fresh("g")
            b_text = term(b, 3)
            self.add(f"pose proof (sin_square {b_text}) as {relation}.")
            self.relations.append(relation)
            self.add(f"set ({s} := sin {b_text}) in *; set ({c} := cos {b_text}) in *.")
            self.names += [s, c]
        for b in self.exponents:
            name = self.fresh("g")
            self.add(f"pose proof (exp_pos {term(b, 3)}).")
            self.add(f"set ({name} := exp {term(b, 3)}) in *.")
            self.names.append(name)


def is_root(e: Expr) -> bool:
    """Whether it is a root, or a power of one."""
    return e.op == "cbrt" or (
        e.op == "^" and e.args[1].op == "number" and bool(e.args[1].args[0].q != 1)
    )


def _quarters(u: Expr) -> tuple[Expr, int]:
    """``u`` as v + n·π/2 with v free of such a term."""
    try:
        v = expanded(u)
    except OverflowError:
        return u, 0
    c = v.get(frozenset(((PI, 1),)), Fraction(0))
    if c == 0 or (2 * c).denominator != 1:
        return u, 0
    n = int(2 * c)
    return u - number(Fraction(n, 2)) * PI, n


def _repeated(name: str, n: int) -> str:
    """n times the name, as a sum."""
    if abs(n) > MAX_MULTIPLE:
        raise OverflowError
    one = name if n > 0 else f"- {name}"
    return "(" + " + ".join([one] * abs(n)) + ")"


def _addition(atoms: list[tuple[str, int]]) -> tuple[str, str]:
    """The sine and cosine of a sum of multiples."""
    sine, cosine = "0", "1"
    for name, n in atoms:
        s = f"sin {name}" if n > 0 else f"(- sin {name})"
        for _ in range(abs(n)):
            if sine == "0":
                sine, cosine = s, f"cos {name}"
            else:
                sine, cosine = (
                    f"({sine} * cos {name} + {cosine} * {s})",
                    f"({cosine} * cos {name} - {sine} * {s})",
                )
    return sine, cosine


def _turned(sine: str, cosine: str, quarters: int) -> tuple[str, str]:
    for _ in range(quarters % 4):
        sine, cosine = cosine, f"(- {sine})"
    return sine, cosine
