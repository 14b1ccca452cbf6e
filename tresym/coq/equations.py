"""Prove equations in Coq: name every non-rational part, then use ``field``.

Angles and exponents are written as integer multiples of a few base angles and exponents, by the
addition theorems. A sine and cosine of one angle are related by one polynomial equation
(sin² + cos² = 1), a root and its radicand by another; the leading monomials of these equations are
pairwise coprime, so they form a Gröbner basis, and reduction by ``field`` gives a normal form.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import lcm

from flint import Ordering, fmpq, fmpq_mpoly_ctx

from tresym.coq.linear_dependence import as_expression, expanded, whole_basis, without_squares
from tresym.coq.statement import Theorem, term
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.functions.table import names
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    HALF,
    ONE,
    PI,
    Expr,
    add,
    factors_in,
    multiply,
    number,
    power,
    symbols,
)
from tresym.reals.signs.sign import sign

LEAVES = ("number", "symbol", "pi")
OPAQUE = names(lambda row: "inverses" in row.theory) | {"log"}
MAX_MULTIPLE = 24
MAX_ANGLES = 3


def equation_proofs(theorem: Theorem) -> Iterator[str]:
    """Yield proofs of an equation, or of the value of a derivative, to try."""
    yield Script(theorem).text()
    yield Script(theorem, splits=False).text()


def nodes(expressions: Iterable[Expr]) -> list[Expr]:
    """Return all subexpressions, without repetition."""
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
    """Return ``e`` as the tactic ``laws`` of ``Tresym.v`` rewrites it."""
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
    """Write ``e`` as numerator and denominator, as a rational function of its other parts."""
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
            bottoms |= Counter(_repeated_factors(q))
        bottom = multiply(*bottoms.elements())
        tops = [
            multiply(p, *(bottoms - Counter(_repeated_factors(q))).elements()) for p, q in parts
        ]
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


def _repeated_factors(e: Expr) -> list[Expr]:
    """Return the factors of a product, with powers expanded."""
    found: list[Expr] = []
    for arg in factors_in(e):
        whole = arg.op == "^" and arg.args[1].op == "number" and arg.args[1].args[0].q == 1
        if whole and 0 < arg.args[1].args[0] <= 50:
            found += [arg.args[0]] * int(arg.args[1].args[0].p)
        elif arg != ONE:
            found.append(arg)
    return found


def inner(e: Expr, operations: Iterable[str]) -> bool:
    """Return whether one of these operations occurs inside ``e``."""
    return any(part.op in operations for arg in e.args for part in nodes([arg]))


class Script:
    """The script of a proof of an equation, under construction."""

    def __init__(self, theorem: Theorem, splits: bool = True) -> None:
        self.splits = splits
        self.theorem = theorem
        self.lines: list[str] = ["intros; saturate."]
        self.relations: list[str] = []
        self.count = 0
        self.names: list[str] = []
        self.after: list[str] = []
        self.late: list[tuple[Expr, int, str]] = []
        bounds = tuple(bound(*part) for part in theorem.defined if symbols(part[0]))
        self.known = Given((*(c for c in theorem.given if c[1] != "=="), *bounds))
        self.angles: list[Expr] = []
        self.exponents: list[Expr] = []

    def fresh(self, letter: str) -> str:
        """Return a fresh name."""
        self.count += 1
        return f"{letter}_{self.count}"

    def add(self, line: str) -> None:
        """Add a sentence."""
        self.lines.append(line)

    def text(self) -> str:
        """Return the complete script."""
        t = self.theorem
        parts = [t.left, t.right, *(e for e, _ in t.defined)]
        parts += [e for x, _, y in t.given for e in (x, y)]
        if t.by is not None:
            parts.append(differentiate(t.left, t.by))
            self.add("eapply d_eq; [derive; hard |]; tidy.")
            for e in nodes([t.left]):
                if e.op in ("asin", "acos", "asinh"):
                    self.written_roots(e)
        self.equations()
        for e, relation in t.defined:
            if relation == "!=" and e.op == "+" and self.positive(e):
                self.add(f"try (assert (0 < {term(e)}) by (first [positive | facts; nra])).")
        self.add("laws.")
        self.prepared(parts)
        for line in self.after:
            self.add(line)
        known = f" [{' '.join(self.relations)}]" if self.relations else ""
        self.add(f"field{known}.")
        self.add(f"all: try side. all: try (sides ltac:(fun _ => ring{known})). all: try nra.")
        return "\n".join(self.lines)

    def equations(self) -> None:
        """Use the equations among the premises, each to eliminate its highest power."""
        for x, relation, y in self.theorem.given:
            if relation != "==":
                continue
            try:
                terms = expanded(unfolded(x - y))
            except OverflowError:
                continue
            fit = [m for m, c in terms.items() if abs(c) == 1 and len(m) == 1]
            if not fit or any(n < 0 for m in terms for _, n in m):
                continue
            first = max(fit, key=lambda m: max(n for _, n in m))
            others = as_expression({m: -c / terms[first] for m, c in terms.items() if m != first})
            if {part for part, _ in first} & {*nodes([others])}:
                continue
            use = self.fresh("R")
            text = term(as_expression({first: terms[first] / terms[first]}))
            self.add(f"assert ({use} : {text} = {term(others)}) by (laws; lra).")
            self.relations.append(use)

    def written_roots(self, e: Expr) -> None:
        """Rewrite the root in the derivative of an inverse function as the claim writes it."""
        u = e.args[0]
        square = Expr("^", (u, number(2)))
        signed = square if e.op == "asinh" else Expr("*", (number(-1), square))
        raw = Expr("+", (signed, ONE))
        folded = u**2 + 1 if e.op == "asinh" else 1 - u**2
        if term(raw) != term(folded):
            self.add(
                f"try (replace (sqrt {term(raw, 3)}) with (sqrt {term(folded, 3)}) by "
                "(f_equal; field; side))."
            )

    def prepared(self, parts: Iterable[Expr]) -> None:
        """Introduce facts and names for all non-rational parts."""
        self.tops(self.theorem)
        whole = self.logarithms(self.signs([unfolded(e) for e in parts]))
        every = nodes(whole)
        every.sort(key=lambda e: (-e.size, str(e)))
        self.roots([e for e in every if is_root(e)])
        opaque = [e for e in every if e.op in OPAQUE or e.op == "sign"]
        outer = [e for e in opaque if inner(e, ("sin", "cos", "exp"))]
        for e in outer:
            self.opaque(e)
        exponential_first = not any(inner(e, ("exp",)) for e in every if e.op in ("sin", "cos"))
        for phase in (True, False) if exponential_first else (False, True):
            if phase:
                self.exponentials(every)
            else:
                self.trigonometry(every)
        self.bases()
        for e in opaque:
            if e not in outer:
                self.opaque(e)
        if self.names:
            self.add(f"clearbody {' '.join(dict.fromkeys(self.names))}.")

    def signs(self, whole: list[Expr]) -> list[Expr]:
        """Substitute the signs that the premises determine."""
        for e in nodes(whole):
            found = sign(e.args[0], self.known) if e.op == "sign" else None
            if found in ("+", "-"):
                law, value = ("sign_pos", 1) if found == "+" else ("sign_neg", -1)
                self.add(f"try rewrite ({law} {term(e.args[0], 3)}) in * by first [side | nra].")
                whole = [exchanged(part, {e: number(value)}) for part in whole]
        return whole

    def positive(self, e: Expr) -> bool:
        """Return whether the premises show ``e > 0``."""
        return sign(e, self.known) == "+"

    def split(self, u: Expr) -> list[tuple[Expr, int]] | None:
        """Return the positive factors of ``u`` with their powers; None if one may be negative."""
        if not self.splits:
            return None
        top, bottom = quotient(u)
        powers: Counter[Expr] = Counter(_repeated_factors(top))
        powers.subtract(Counter(_repeated_factors(bottom)))
        found = []
        for factor, n in powers.items():
            if factor.op == "number":
                if factor.args[0] <= 0 or factor.args[0].p >= 10**6:
                    return None
                found += [(number(p), n * k) for p, k in primes(int(factor.args[0].p))]
            elif n:
                found.append((factor, n))
        total: Counter[Expr] = Counter()
        for factor, n in found:
            inside = Counter(_repeated_factors(fewest_terms(factor)))
            for part, k in ((p, k * m) for f, m in inside.items() for p, k in irreducible(f)):
                if part.op == "number" and part.args[0].q != 1:
                    return None
                shown = part.op == "number" or self.positive(part)
                other = as_expression({m: -c for m, c in expanded(part).items()})
                if not shown and not self.positive(other):
                    return None
                total[part if shown else other] += n * k
        return [(f, n) for f, n in total.items() if n]

    def in_factors(self, e: Expr) -> Expr:
        """Write a polynomial as a product of factors, those known to be positive as such."""
        found = [ONE]
        for part, n in irreducible(e):
            other = as_expression({m: -c for m, c in expanded(part).items()})
            flipped = part.op == "+" and n % 2 and sign(part, self.known) in ("-", "<=0")
            found.append(
                Expr("^", (other if flipped else part, number(n)))
                if n > 1
                else other
                if flipped
                else part
            )
            found += [number(-1)] if flipped else []
        product = multiply(*found)
        try:
            same = expanded(product) == expanded(e)
        except OverflowError:
            return e
        return product if same else multiply(number(-1), product)

    def logarithms(self, whole: list[Expr]) -> list[Expr]:
        """Write logarithms of products as sums."""
        for e in nodes(whole):
            if e.op != "log" or inner(e, ("log",)):
                continue
            factors = self.split(e.args[0])
            if factors is None or len(factors) + sum(abs(n) != 1 for _, n in factors) < 2:
                continue
            if any(abs(n) > 6 for _, n in factors):
                continue
            flat = [f if n > 0 else _inverse(f) for f, n in factors for _ in range(abs(n))]
            sum_ = Expr("+", tuple(Expr("*", (number(n), Expr("log", (f,)))) for f, n in factors))
            sum_ = sum_ if len(factors) > 1 else sum_.args[0]
            use = self.fresh("E")
            self.add(
                f"assert ({use} : {term(e)} = {term(sum_)}) by "
                f"(replace {term(e.args[0], 3)} with ({_nested(flat)}) by (field; side); logs)."
            )
            self.add(f"try rewrite {use} in *.")
            whole = [exchanged(part, {e: sum_}) for part in whole]
        return whole

    def roots(self, found: list[Expr]) -> None:
        """Write all roots in terms of the roots of a few radicands; add the equations for these."""
        asked = [as_root(e) for e in found]
        if len(dict.fromkeys(asked)) == 1 and not self.divides(asked[0][0]):
            u, q, _ = asked[0]
            self.canonical(u, q, asked[0][2])
            return
        degree: dict[Expr, int] = {}
        split: dict[tuple[Expr, int, bool], list[tuple[Expr, int]]] = {}
        keys: dict[object, Expr] = {}
        for u, q, odd in dict.fromkeys(asked):
            factors = self.split(u)
            if factors is None:
                if not odd and (q == 2 or self.positive(u)):
                    factors = [(u, 1)]
                else:
                    self.canonical(u, q, odd)
                    continue
            merged = []
            for f, n in factors:
                f = keys.setdefault(_key(f), f)
                merged.append((f, n))
                degree[f] = lcm(degree.get(f, 1), q)
            split[u, q, odd] = merged
        for f, q in degree.items():
            self.canonical(f, q, False)
        for (u, q, _), factors in split.items():
            if factors == [(u, 1)] and degree[u] == q:
                continue
            product = [
                Expr("^", (_root(f, degree[f]), number(n * (degree[f] // q)))) for f, n in factors
            ]
            value = product[0] if len(product) == 1 else Expr("*", tuple(product))
            use = self.fresh("E")
            law = "sqrt_unique" if q == 2 else "root_unique"
            self.add(
                f"assert ({use} : {term(_root(u, q))} = {term(value)}) by (apply {law}; "
                f"{'[' if q == 2 else '[lia | '}positive_root | {self.by_field()}])."
            )
            self.add(f"try rewrite {use} in *.")
        for u, q, name in self.late:
            self.add(f"set ({name} := {term(_root(u, q))}) in *.")
            self.names.append(name)

    def divides(self, u: Expr) -> bool:
        """Return whether a radicand has a denominator, or is shorter by sines and cosines."""
        top, bottom = quotient(u)
        return bottom.op != "number" or fewest_terms(top) != top

    def by_field(self) -> str:
        """The tactic for the equation that remains, with the equations of the roots."""
        known = f" [{' '.join(self.relations)}]" if self.relations else ""
        sides = nodes([self.theorem.left, self.theorem.right])
        angles = dict.fromkeys(e.args[0] for e in sides if e.op in ("sin", "cos"))
        squares = [f"(sin_square {term(u, 3)})" for u in angles]
        last = f" | field [{' '.join([*self.relations, *squares])}]; side" if squares else ""
        return f"first [field{known}; side | trigonometric; field{known}; side{last}]"

    def canonical(self, u: Expr, q: int, odd: bool) -> None:
        """Return the equation of a root that gets its name later."""
        name = self.fresh("g")
        self.late.append((u, q, name))
        self.root(Expr("cbrt", (u,)) if odd else _root(u, q), u, q, name)

    def tops(self, t: Theorem) -> None:
        """Add that a numerator is not 0 where the quotient is not 0."""
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
        """Introduce a name for a sign, a logarithm or an inverse function."""
        name = self.fresh("g")
        if e.op == "sign":
            relation = self.fresh("R")
            self.add(f"assert ({relation} : {term(e)} ^ 2 = 1) by (apply sign_square; side).")
            self.relations.append(relation)
        text = term(e)
        self.add(f"set ({name} := {text}) in *.")
        self.names.append(name)

    def root(self, e: Expr, u: Expr, q: int, name: str) -> None:
        """Add the equation of a root and that it is positive."""
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
        """Write sines and cosines in terms of those of a few base angles."""
        angles = [e.args[0] for e in every if e.op in ("sin", "cos")]
        if not angles:
            return
        turns = {u: quarters(u) for u in angles}
        bases, whole = whole_basis([v for v, _ in turns.values()])
        self.angles = bases
        for u in dict.fromkeys(angles):
            v, n = turns[u]
            if u not in bases:
                self.multiple(u, bases, whole[v], n)

    def multiple(self, u: Expr, bases: list[Expr], c: list[int], quarters: int) -> None:
        """Return the sine and cosine of u = Σ c·base + quarters·π/2."""
        names = [f"p{j}" for j, n in enumerate(c) if n]
        atoms = [(f"p{j}", n) for j, n in enumerate(c) if n]
        total = " + ".join(_repeated(name, n) for name, n in atoms) or "0"
        shift = (" + PI / 2" if quarters > 0 else " + - (PI / 2)") * abs(quarters)
        sine, cosine = _addition(atoms)
        sine, cosine = _turned(sine, cosine, quarters)
        total += shift
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
        """Write exponentials in terms of those of a few base exponents."""
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
                self.add(f"try rewrite (exp_ln {term(log.args[0], 3)}) in * by side.")

    def bases(self) -> None:
        """Introduce names for the sine, cosine or exponential of the bases."""
        for b in self.exponents:
            name = self.fresh("g")
            self.add(f"pose proof (exp_pos {term(b, 3)}).")
            self.add(f"set ({name} := exp {term(b, 3)}) in *.")
            self.names.append(name)
        for b in self.angles:
            relation, s, c = self.fresh("R"), self.fresh("g"), self.fresh("g")
            b_text = term(b, 3)
            self.add(f"pose proof (sin_square {b_text}) as {relation}.")
            self.relations.append(relation)
            self.add(f"set ({s} := sin {b_text}) in *; set ({c} := cos {b_text}) in *.")
            self.names += [s, c]


def _root(u: Expr, q: int) -> Expr:
    return Expr("^", (u, number(Fraction(1, q))))


def as_root(e: Expr) -> tuple[Expr, int, bool]:
    """Return the radicand, the degree, and whether the root is defined for all numbers."""
    return (e.args[0], 3, True) if e.op == "cbrt" else (e.args[0], int(e.args[1].args[0].q), False)


def _key(e: Expr) -> object:
    """Return a key that is equal for radicands equal as polynomials modulo sin² + cos² = 1."""
    try:
        terms = expanded(e)
        for _ in range(6):
            found = [(m, part) for m in terms for part, n in m if part.op == "sin" and n >= 2]
            if not found:
                break
            m, part = found[0]
            c, rest = terms.pop(m), dict(m)
            rest[part] -= 2
            low = frozenset((p, n) for p, n in rest.items() if n)
            cosine = Expr("cos", part.args)
            rest[cosine] = rest.get(cosine, 0) + 2
            high = frozenset((p, n) for p, n in rest.items() if n)
            terms[low] = terms.get(low, Fraction(0)) + c
            terms[high] = terms.get(high, Fraction(0)) - c
        return frozenset((m, c) for m, c in terms.items() if c)
    except OverflowError:
        return e


def fewest_terms(e: Expr) -> Expr:
    """Eliminate the squares of sines, or of cosines, if that makes the sum shorter."""
    angles = list(dict.fromkeys(f.args[0] for f in nodes([e]) if f.op in ("sin", "cos")))
    if e.op != "+" or not 0 < len(angles) <= MAX_ANGLES:
        return e
    try:
        terms = expanded(e)
        best = min(without_squares(terms, angles), key=len)
    except OverflowError:
        return e
    return as_expression(best) if len(best) < len(terms) else e


def irreducible(e: Expr) -> list[tuple[Expr, int]]:
    """Factor a sum as a polynomial in its parts, up to signs; or return the sum itself."""
    if e.op != "+":
        return [(e, 1)]
    try:
        terms = expanded(e)
    except OverflowError:
        return [(e, 1)]
    parts = sorted({part for m in terms for part, _ in m}, key=str)
    if any(n < 0 for m in terms for _, n in m):
        return [(e, 1)]
    context = fmpq_mpoly_ctx.get([f"x{k}" for k in range(len(parts))], Ordering.lex)
    place = {part: k for k, part in enumerate(parts)}
    rows = {}
    for m, c in terms.items():
        row = [0] * len(parts)
        for part, n in m:
            row[place[part]] = n
        rows[tuple(row)] = fmpq(c.numerator, c.denominator)
    constant, factors = context.from_dict(rows).factor()
    if sum(int(n) for _, n in factors) < 2:
        return [(e, 1)]
    found = []
    for p, n in factors:
        back = {
            frozenset((part, int(k)) for part, k in zip(parts, row, strict=True) if k): Fraction(
                int(c.p), int(c.q)
            )
            for row, c in p.to_dict().items()
        }
        found.append((as_expression(back), int(n)))
    if abs(constant) != 1:
        found.append((number(abs(constant)), 1))
    return found


def primes(n: int) -> list[tuple[int, int]]:
    """Return the prime factorisation of ``n``."""
    found, p = [], 2
    while n > 1:
        k = 0
        while n % p == 0:
            n, k = n // p, k + 1
        if k:
            found.append((p, k))
        p = p + 1 if p * p <= n else max(n, p + 1)
    return found


def _nested(factors: list[Expr]) -> str:
    """Return a product with parentheses to the right."""
    first, *rest = factors
    return f"{term(first, 3)} * ({_nested(rest)})" if rest else term(first, 3)


def exchanged(e: Expr, values: dict[Expr, Expr]) -> Expr:
    """Replace parts of ``e`` without simplifying."""
    if e in values:
        return values[e]
    if e.op in LEAVES:
        return e
    return Expr(e.op, tuple(exchanged(arg, values) for arg in e.args))


def is_root(e: Expr) -> bool:
    """Return whether ``e`` is a root or a power of one."""
    return e.op == "cbrt" or (
        e.op == "^" and e.args[1].op == "number" and bool(e.args[1].args[0].q != 1)
    )


def quarters(u: Expr) -> tuple[Expr, int]:
    """Write ``u`` as v + n·π/2 where v has no such term."""
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
    """Return n times the name, written as a sum."""
    if abs(n) > MAX_MULTIPLE:
        raise OverflowError
    one = name if n > 0 else f"- {name}"
    return "(" + " + ".join([one] * abs(n)) + ")"


def _addition(atoms: list[tuple[str, int]]) -> tuple[str, str]:
    """Return the sine and cosine of a sum of multiples by the addition theorems."""
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
