"""Rational functions of names bound by equations, in lowest terms and factored.

A name may have an equation n**q = p, where p is a polynomial in older names. The leading monomials
of these equations are pairwise coprime, so they form a Gröbner basis, and what remains after
reduction is a normal form.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TypeAlias

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from tresym.coq.equations import is_root, nodes
from tresym.reals.language.expression import PI, ZERO, Expr, add, multiply, number, symbol

LEAVES = ("number", "symbol", "pi")
LONGEST, MOST, POWER = 60, 400, 60
Fraction: TypeAlias = tuple[fmpq_mpoly, fmpq_mpoly]
Factors: TypeAlias = tuple[fmpq, list[tuple[Expr, int]]]
_PI = "[pi]"


class Quotients:
    """The field of rational functions; ``powers`` contains the equations of the names."""

    def __init__(self) -> None:
        self.powers: dict[str, tuple[int, Expr]] = {}

    def fraction(self, e: Expr) -> Fraction | None:
        """Return numerator and denominator in lowest terms, or None if they are too long."""
        if any(part.op not in ("+", "*", "^", *LEAVES) or is_root(part) for part in nodes([e])):
            return None
        try:
            return self._fraction(e, self._ring(_names(e)))
        except OverflowError:
            return None

    def canonical(self, e: Expr) -> Expr:
        """Return ``e`` in lowest terms and factored; ``e`` itself if that is too long."""
        found = self.fraction(e)
        if found is None:
            return e
        top, bottom = found
        if top == 0:
            return ZERO
        names = top.context().names()
        constant, tops = top.factor()
        under, bottoms = bottom.factor()
        if len(tops) == 1 and tops[0][1] == 1 and not bottoms:
            return written(top / bottom.leading_coefficient(), names)
        up = [written(p, names) ** int(n) for p, n in tops]
        down = [written(p, names) ** int(n) for p, n in bottoms]
        result = multiply(number(constant / under), *up)
        return result / multiply(*down) if down else result

    def factors(self, e: Expr) -> Factors:
        """Return a constant and the irreducible factors with their powers."""
        found = self.fraction(e)
        if found is None:
            return fmpq(1), [(e, 1)]
        top, bottom = found
        names, powers = top.context().names(), Counter[Expr]()
        constant = fmpq(0) if top == 0 else fmpq(1)
        for p, side in ((top, 1), (bottom, -1)):
            if p != 0:
                c, parts = p.factor()
                constant = constant * c if side > 0 else constant / c
                for part, n in parts:
                    powers[written(part, names)] += side * int(n)
        for name, (q, by) in self.powers.items():
            cosine = self.cosine(by) if q == 2 else None
            if cosine is not None:
                constant *= self._squared(symbol(name), cosine, powers)
        return constant, [(f, n) for f, n in powers.items() if n]

    @staticmethod
    def cosine(e: Expr) -> Expr | None:
        """Return the c of 1 − c², or None if the expression has another form."""
        for part in e.args if e.op == "+" else ():
            for square in part.args if part.op == "*" else ():
                if square.op == "^" and square.args[0].op == "symbol" and 1 - square == e:
                    found: Expr = square.args[0]
                    return found
        return None

    def _squared(self, sine: Expr, c: Expr, powers: Counter[Expr]) -> int:
        """Replace (1 − c)(1 + c) by the square of a sine; return the remaining sign."""
        sign = 1
        for x, turned in ((1 - c, 1), (c - 1, -1)):
            low, high = self.canonical(x), self.canonical(c + 1)
            if powers[low] * powers[high] <= 0:
                continue
            n = min(powers[low], powers[high], key=abs)
            powers[low] -= n
            powers[high] -= n
            powers[sine] += 2 * n
            sign *= turned ** (n % 2)
        return sign

    def parts(self, e: Expr) -> list[tuple[Expr, fmpq]]:
        """Return a sum of base parts with rational coefficients."""
        found = self.fraction(e)
        if found is None:
            return [(e, fmpq(1))]
        top, bottom = found
        context = top.context()
        one, result = context.constant(1), []
        whole, left = divmod(top, bottom)
        for p, q in ((whole, one), (left, bottom)):
            for exponents, c in sorted(p.to_dict().items()):
                monomial = context.from_dict({exponents: fmpq(1)})
                g = monomial.gcd(q)
                up, down = exact(monomial, g), exact(q, g)
                lead = down.leading_coefficient()
                base = written(up, context.names())
                if down != lead:
                    base = base / written(down / lead, context.names())
                result.append((base, c / lead))
        return result

    def _ring(self, needed: Iterable[str]) -> fmpq_mpoly_ctx:
        names, stack = set[str](), [*needed]
        while stack:
            name = stack.pop()
            if name not in names:
                names.add(name)
                stack += _names(self.powers[name][1]) if name in self.powers else ()
        bound = [name for name in reversed(self.powers) if name in names]
        return fmpq_mpoly_ctx.get([*bound, *sorted(names.difference(bound))] or ["x"], Ordering.lex)

    def _fraction(self, e: Expr, context: fmpq_mpoly_ctx) -> Fraction:
        one = context.constant(1)
        match e.op:
            case "number":
                value = e.args[0]
                return context.constant(fmpq(int(value.p))), context.constant(fmpq(int(value.q)))
            case "symbol" | "pi":
                name = e.args[0] if e.args else _PI
                return context.gens()[context.names().index(name)], one
            case "+":
                top, bottom = context.constant(0), one
                for arg in e.args:
                    p, q = self._fraction(arg, context)
                    g = bottom.gcd(q)
                    rest = exact(q, g)
                    top, bottom = self._lowest(
                        top * rest + p * exact(bottom, g), bottom * rest, context
                    )
                return top, bottom
            case "*":
                top, bottom = one, one
                for arg in e.args:
                    p, q = self._fraction(arg, context)
                    top, bottom = self._lowest(top * p, bottom * q, context)
                return top, bottom
        n = int(e.args[1].args[0].p)
        p, q = self._fraction(e.args[0], context)
        if abs(n) > POWER:
            raise OverflowError
        p, q = (p, q) if n > 0 else (q, p)
        top, bottom = one, one
        for _ in range(abs(n)):
            top, bottom = self._lowest(top * p, bottom * q, context)
        return top, bottom

    def _lowest(self, top: fmpq_mpoly, bottom: fmpq_mpoly, context: fmpq_mpoly_ctx) -> Fraction:
        top, bottom = self._reduced(top, context), self._reduced(bottom, context)
        if bottom == 0:
            raise ZeroDivisionError
        g = top.gcd(bottom)
        top, bottom = exact(top, g), exact(bottom, g)
        if len(top) + len(bottom) > LONGEST:
            raise OverflowError
        return top, bottom

    def _reduced(self, p: fmpq_mpoly, context: fmpq_mpoly_ctx) -> fmpq_mpoly:
        """Reduce the powers of each name by its equation."""
        for k, name in enumerate(context.names()):
            if name not in self.powers or p.degrees()[k] < (q := self.powers[name][0]):
                continue
            value, bottom = self._fraction(self.powers[name][1], context)
            if bottom.total_degree() > 0:
                continue
            value = value / bottom.leading_coefficient()
            while p.degrees()[k] >= q:
                low: dict[tuple[int, ...], fmpq] = {}
                high: dict[tuple[int, ...], fmpq] = {}
                for m, c in p.to_dict().items():
                    if m[k] >= q:
                        high[(*m[:k], m[k] - q, *m[k + 1 :])] = c
                    else:
                        low[m] = c
                p = context.from_dict(low) + context.from_dict(high) * value
                if len(p) > MOST:
                    raise OverflowError
        return p


def exact(p: fmpq_mpoly, g: fmpq_mpoly) -> fmpq_mpoly:
    """Return p/g, which must divide exactly."""
    return divmod(p, g)[0] if g != 1 else p


def written(p: fmpq_mpoly, names: Iterable[str]) -> Expr:
    """Return a polynomial as an expression."""
    gens = [PI if name == _PI else symbol(name) for name in names]
    terms = []
    for exponents, c in sorted(p.to_dict().items(), reverse=True):
        powers = [x ** int(n) for x, n in zip(gens, exponents, strict=True) if n]
        terms.append(multiply(number(c), *powers))
    return add(*terms) if terms else ZERO


def _names(e: Expr) -> set[str]:
    return {
        part.args[0] if part.args else _PI for part in nodes([e]) if part.op in ("symbol", "pi")
    }
