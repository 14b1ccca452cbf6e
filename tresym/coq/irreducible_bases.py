"""Rewrite roots and logarithms in terms of irreducible factors, for proofs of equations."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import product
from math import isqrt, lcm
from operator import mul

from flint import arb, fmpq

from tresym.coq.equations import is_root, nodes, primes
from tresym.coq.proof_script import AgainError, CasesError, StuckError, Writing, degree_of, is_zero
from tresym.coq.statement import term
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    symbols,
)

MULTIPLE = 12
ONE_ = fmpq(1)


class Bases(Writing):
    """Roots and logarithms expressed by those of irreducible factors, with names."""

    # Roots.

    def root(self, u: Expr, q: int, odd: bool) -> None:
        """Express a root by roots of irreducible factors."""
        e = _root(u, q, odd)
        if u == ZERO:
            return self.exchange(e, ZERO, "apply sqrt_0", "apply root_zero")
        if q == 2 and self.of_square(e, u):
            return None
        value = self.root_of(u, q)
        if self.has_root(u, q):
            proofs = {2: "apply sqrt_unique; [", 3: "apply root_unique_3; ["}
            proof = proofs.get(q, "apply root_unique_le; [lia | ")
            self.exchange(e, value, f"{proof}{'' if q == 3 else 'signed | '}{self.by_field}]")
        return None

    def of_square(self, e: Expr, u: Expr) -> bool:
        """Write the square root of v²·w as |v|·√w if the sign of v varies."""
        _, factors = self.quotients.factors(u)
        within = [(f, n) for f, n in factors if self.sign(f) is None]
        rest = [f for f, _ in factors if (f, _) not in within]
        if not within or any(n % 2 for _, n in within) or not all(map(self.is_above, rest)):
            return False
        v = self.quotients.canonical(multiply(*(f ** (n // 2) for f, n in within)))
        w = self.root_of(self.quotients.canonical(u / v**2), 2)
        new = Expr("abs", (v,))
        return self.equation(
            e,
            new if w == ONE else Expr("*", (new, w)),
            f"rewrite (sqrt_square _ {term(v, 3)} {term(w, 3)}); [ring | signed | {self.by_field}]",
        )

    def has_root(self, u: Expr, q: int) -> bool:
        """Return whether such a root occurs in one of the sides."""
        return any(is_root(e) and e.args[0] == u and degree_of(e) == q for e in nodes(self.sides))

    def signed_factors(self, u: Expr, even: bool, three: bool) -> list[tuple[Expr, int]]:
        """Return the factors (primes included) with their powers; prove positivity if possible.

        If the sign of a factor matters and varies, the proof splits into cases.
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
                    raise CasesError(f, three)
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
        """Return the value of a root in terms of names."""
        values = []
        factors = self.signed_factors(u, q % 2 == 0, three=False)
        if q == 2 and len(factors) == 1 and (simpler := self.denested(*factors[0])) is not None:
            return simpler
        factors = self.by_cubes(factors)
        if q % 2 == 0 and len(factors) > 1:
            hidden = self.are_above(u, factors, ("plainly", "in_numbers", "rest"))
            if any(n != 1 for f, n in factors if f in hidden):
                self.are_above(u, factors)
            elif hidden:
                factors = [(f, n) for f, n in factors if f not in hidden]
                factors.append((self.quotients.canonical(multiply(*hidden)), 1))
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

    def by_cubes(self, factors: list[tuple[Expr, int]]) -> list[tuple[Expr, int]]:
        """Return the factors whose cube roots already have names."""
        names = dict[Expr, Expr]()
        for (f, degree), name in self.roots.items():
            if degree == 3:
                names |= {f: name, self.quotients.canonical(-f): self.quotients.canonical(-name)}
        found = Counter[Expr]()
        for f, n in factors:
            found[names.get(f, f)] += 3 * n if f in names else n
        return [(f, n) for f, n in found.items() if n]

    def denested(self, f: Expr, n: int) -> Expr | None:
        """Write the root of A + B·√r as √P ± √Q, if A² − B²·r is a square."""
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
        """Return the degree of the root of a factor: the highest that has been needed."""
        old = int(self.finest.get(f, ONE_).p)
        new = lcm(old, q)
        self.finest[f] = fmpq(new)
        if new != old and (f, old) in self.roots:
            raise AgainError
        return new

    def base_root(self, f: Expr, q: int) -> Expr:
        """Return the name of a root, introducing it with its equation if necessary."""
        if (f, q) in self.roots:
            return self.roots[f, q]
        if q % 2 == 0 and not (self.is_above(f) or self.is_above(f, strict=False)):
            raise CasesError(f, False)
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
        """Express a logarithm by logarithms of irreducible factors."""
        factors = self.signed_factors(u, even=True, three=True)
        if sum(abs(n) for _, n in factors) > 2 * MULTIPLE:
            raise StuckError
        hidden = self.are_above(u, factors)
        if hidden:
            raise CasesError(hidden[0], True)
        terms, known = [], []
        for f, n in factors:
            value, label = self.logarithm_of(f)
            terms.append(value * n)
            known.append(f"rewrite ?{label}")
        if self.has(e):
            flat = [
                f if n > 0 else Expr("^", (f, MINUS_ONE)) for f, n in factors for _ in range(abs(n))
            ]
            into = f"replace {term(u, 3)} with ({nested(flat)}) by ({self.by_field})"
            self.exchange(
                e,
                add(*terms),
                f"{into}; split_logs; {'; '.join(known) or 'rewrite ln_1'}; {self.by_field}",
            )

    def logarithm_of(self, f: Expr) -> tuple[Expr, str]:
        """Return the logarithm of a factor and the name of its equation."""
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
        if f in self.logarithms:
            name = self.logarithms[f]
            return name, f"D_{name.args[0]}"
        tied = self.tied(f, label)
        if tied is not None:
            return tied, label
        name = self.logarithms[f] = self.named(Expr("log", (f,)))
        return name, f"D_{name.args[0]}"

    def tied(self, f: Expr, label: str) -> Expr | None:
        """Express the logarithm of ``f`` by named logarithms, if a linear combination vanishes."""
        named = list(self.logarithms.items())[-4:]
        own, values = self.values(Expr("log", (f,))), [self.values(n) for _, n in named]
        for counts in sorted(product((0, 1, -1, 2, -2), repeat=len(named)), key=_length):
            sums = [sum(map(mul, counts, at), arb(0)) for at in zip(*values, strict=True)]
            for m in (1, 2) if any(counts) and sums else ():
                if not all(is_zero(m * v - s) for v, s in zip(own, sums, strict=True)):
                    continue
                value = add(*(n * c for (_, n), c in zip(named, counts, strict=True) if c)) / m
                up, down = (
                    [v for (v, _), c in zip(named, counts, strict=True) for _ in range(side * c)]
                    for side in (1, -1)
                )
                law, back = self.label("P"), "; ".join(self.back(n) for _, n in named)
                held = self.say(
                    f"assert ({label} : ln {term(f, 3)} = {term(value)}) by (assert ({law} : "
                    f"{nested([f] * m + down)} = {nested(up)}) by ({self.by_field}); "
                    f"apply (f_equal ln) in {law}; rewrite ?ln_1 in {law}; apart {law}; "
                    f"{back}; lra)."
                )
                return value if held else None
        return None


def _length(counts: tuple[int, ...]) -> int:
    return sum(map(abs, counts))


def _root(u: Expr, q: int, odd: bool) -> Expr:
    return Expr("cbrt", (u,)) if odd else Expr("^", (u, number(Fraction(1, q))))


def nested(factors: list[Expr]) -> str:
    """Return a product with parentheses to the right."""
    if not factors:
        return "1"
    first, *rest = factors
    return f"{term(first, 3)} * ({nested(rest)})" if rest else term(first, 3)
