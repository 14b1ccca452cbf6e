"""The exact normal form: a real expression as a fraction in generators that are as free as known.

Every rewriting holds at each real point where the expression is defined and no factor met on the
way vanishes. Such points are dense in the open part of the domain, and elementary functions are
continuous, so a difference that reduces to zero is zero there.

- sin, cos, …: t = tan(angle/2) for each angle of a rational basis of the angles met.
- exp, powers: y = exp(exponent) for each exponent of a rational basis of the exponents met.
- roots, abs: |f|^(1/n) for each irreducible factor f, and a sign σ_f with σ_f² = 1. That a radicand
  is positive is a linear equation over GF(2) between the σ; what it decides is used in a new pass.
- log: log|f| for each irreducible factor f. asin and acos through atan; the hyperbolic functions
  through exp and log.
- A function outside the allowed theories is an opaque generator of its normalised argument.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import comb, lcm

from flint import arb, fmpq, fmpq_mat, fmpz, fmpz_poly

from tresym.identity.expression import Expr
from tresym.identity.given import Given
from tresym.identity.monotone import same_sign
from tresym.identity.ring import (
    Fraction,
    Generator,
    Poly,
    TooLargeError,
    UndefinedError,
    small_factor,
)
from tresym.identity.signs import MAX_DEPTH, AgainError, SignedRing

ALL_THEORIES = frozenset({"roots", "trigonometry", "exponentials", "inverses"})

_THEORY: dict[str, frozenset[str]] = (
    {name: frozenset({"roots"}) for name in ("abs", "sign", "cbrt")}
    | {
        name: frozenset({"exponentials"})
        for name in ("exp", "log", "sinh", "cosh", "tanh", "coth", "sech", "csch")
    }
    | {name: frozenset({"trigonometry"}) for name in ("sin", "cos", "tan", "cot", "sec", "csc")}
    | {name: frozenset({"inverses"}) for name in ("asin", "acos", "atan")}
    | {name: frozenset({"inverses"}) for name in ("asinh", "acosh", "atanh")}
)

MAX_PASSES = 40
MAX_HALF_TURN = 240
MAX_MULTIPLE = 96
MAX_PRIME_BITS = 160
CONJUGATE_TERMS = 10
MAX_FACTOR_TERMS = 1000

Factors = dict[str, tuple[Poly, fmpq]]


class Field(SignedRing):
    """Normal forms under ``given`` with the functions of ``theories`` known."""

    def __init__(
        self,
        given: Given,
        theories: frozenset[str] = ALL_THEORIES,
        size: int = 24,
        points: Callable[[], Sequence[Mapping[str, fmpq]]] = tuple,
    ):
        """The arguments of the base class, and what may be used beyond algebra."""
        super().__init__(given, size, points)
        self.theories = theories
        self._memo: dict[Expr, Fraction] = {}
        self._factored: dict[str, tuple[fmpz, list[tuple[Poly, int]]]] = {}
        self._orders: dict[str, int] = {}
        self._half_turn = 1
        self._basis: dict[str, list[Fraction]] = {"exp": [], "tan": [], "turn": []}
        self._units: dict[str, list[int]] = {"exp": [], "tan": [], "turn": []}

    def normal(self, *expressions: Expr) -> list[Fraction]:
        """The normal forms of ``expressions``, on the domain of all of them and under ``given``.

        Raises:
            UndefinedError: one of them is nowhere defined.
            TooLargeError: a normal form outgrew its bounds.
        """
        for _ in range(MAX_PASSES):
            self._memo.clear()
            self.begin_pass()
            try:
                for condition in self.given.beyond_box:
                    value = self._walk(condition.expression)
                    if condition.relation != "!=":
                        self._require_positive(value, strict=condition.relation == ">")
                result = [self._walk(e) for e in expressions]
            except AgainError:
                continue
            except (TooLargeError, UndefinedError):
                if not self.learn():
                    raise
                continue
            if not self.learn() or self._are_equal(result):
                return result
        raise TooLargeError("the normal form did not settle")

    def _are_equal(self, values: list[Fraction]) -> bool:
        """Whether ``values`` are two equal ones, which nothing that is learnt can change."""
        return len(values) == 2 and self.subtract(*values).num.is_zero()

    def _walk(self, node: Expr) -> Fraction:
        value = self._memo.get(node)
        if value is None:
            value = self._node(node)
            self._memo[node] = value
        return value

    def _node(self, node: Expr) -> Fraction:
        op, args = node.op, node.args
        if op == "number":
            return self.constant(args[0])
        if op == "symbol":
            return self._fraction(self.symbol(args[0]))
        if op == "pi":
            return self._fraction(self.generator("pi", None))
        if op == "^":
            return self._power(*args)
        values = [self._walk(arg) for arg in args]
        if op == "+":
            return self.sum(values)
        if op == "*":
            total = values[0]
            for value in values[1:]:
                total = self.multiply(total, value)
            return total
        if not _THEORY[op] <= self.theories:
            return self._opaque(op, values[0])
        return self._function(op, values[0])

    def _function(self, name: str, x: Fraction) -> Fraction:
        simple: dict[str, Callable[[Fraction], Fraction]] = {
            "exp": self.exp,
            "log": self.log,
            "atan": self.atan,
            "asin": self._asin,
            "sign": self._sign_function,
            "asinh": self._asinh,
            "acosh": self._acosh,
            "atanh": self._atanh,
        }
        if name in simple:
            return simple[name](x)
        if name == "abs":
            return self.multiply(x, self._sign_function(x))
        if name == "cbrt":
            return self._root(x, fmpq(1, 3), signed=True)
        if name == "acos":
            return self.subtract(self.pi(fmpq(1, 2)), self._asin(x))
        if name in ("sin", "cos", "tan", "cot", "sec", "csc"):
            return self._quotient(name, *self._turn(x))
        y = self.exp(x)
        z = self.invert(y)
        half = self.constant(fmpq(1, 2))
        cosh = self.multiply(half, self.add(y, z))
        sinh = self.multiply(half, self.subtract(y, z))
        return self._quotient(_CIRCULAR[name], cosh, sinh)

    def _quotient(self, name: str, c: Fraction, s: Fraction) -> Fraction:
        """sin, cos, tan, … from cosine and sine (circular or hyperbolic)."""
        match name:
            case "sin":
                return s
            case "cos":
                return c
            case "tan":
                return self.divide(s, c)
            case "cot":
                return self.divide(c, s)
            case "sec":
                return self.invert(c)
            case _:
                return self.invert(s)

    def _fraction(self, generator: Generator) -> Fraction:
        return Fraction(self.variable(generator), self.one_poly)

    def pi(self, r: fmpq) -> Fraction:
        """r·π."""
        return self.multiply(self.constant(r), self._fraction(self.generator("pi", None)))

    def _opaque(self, name: str, *args: Fraction) -> Fraction:
        """A generator of which nothing is known but its arguments."""
        key = (name, *(arg.key for arg in args))
        return self._fraction(self.generator("opaque", key, (name, *args)))

    # Factors, signs, roots

    def factor(self, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
        """``p`` as an integer times powers of canonical factors (exponents may be negative)."""
        key = str(p)
        found = self._factored.get(key)
        if found is None:
            found = self._factor(p)
            self._factored[key] = found
        return found

    def _factor(self, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
        if p.is_constant():
            return p.leading_coefficient(), []
        if len(p) > MAX_FACTOR_TERMS:
            raise TooLargeError(f"the factors of a polynomial of {len(p)} terms")
        if len(p) == 1:
            ((monomial, value),) = p.terms()
            return value, [(self.variables[i], int(k)) for i, k in enumerate(monomial) if k]
        if p.total_degree() == 1:
            content = p.content()
            unit = content if p.leading_coefficient() > 0 else -content
            raw = [(p // self.context.constant(unit), 1)]
        else:
            unit, raw = small_factor(self, p)
        merged: dict[str, tuple[Poly, int]] = {}
        for factor, exponent in raw:
            if factor.leading_coefficient() < 0:
                factor = -factor
                unit = unit if exponent % 2 == 0 else -unit
            scale, parts = self._canonical(factor)
            unit *= scale**exponent
            for part, k in parts:
                name = str(part)
                merged[name] = (part, merged.get(name, (part, 0))[1] + k * exponent)
        return unit, [item for item in merged.values() if item[1]]

    def _canonical(self, f: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
        """An irreducible ``f`` by its norm and conjugate where a root makes factors ambiguous."""
        if len(f) == 1 or len(f) > CONJUGATE_TERMS or self.is_inverse(f):
            return fmpz(1), [(f, 1)]
        denested = self._denested(f)
        if denested is not None:
            return denested
        for position, degree, _ in self.relations:
            if degree != 2 or f.degrees()[position] != 1 or self.at(position).kind != "root":
                continue
            parts = self.split(f, position)
            if len(parts) != 2:
                continue
            x = self.variables[position]
            base = self.at(position).data[0]
            if parts[0].gcd(base) == base:
                square = self.reduce(x * x)
                sign = square // base
                rest = (parts[0] // base) * sign * x + parts[1]
                unit, inner = self.factor(rest)
                return unit, [(x, 1), *inner]
            if parts[0].leading_coefficient() * parts[1].leading_coefficient() > 0:
                continue
            conjugate = parts[0] - parts[1] * x
            norm = self.reduce(f * conjugate)
            if norm.is_zero() or self.is_mixed(norm) or norm.gcd(conjugate) != self.one_poly:
                continue
            unit, inner = self.factor(norm)
            if conjugate.leading_coefficient() < 0:
                conjugate, unit = -conjugate, -unit
            return unit, [*inner, (conjugate, -1)]
        return fmpz(1), [(f, 1)]

    def _settle(self, key: str) -> None:
        super()._settle(key)
        self._factored.clear()

    def _denested(self, f: Poly) -> tuple[fmpz, list[tuple[Poly, int]]] | None:
        """``p + q·A`` as ``(p + n + q·A)²/(2(p + n))`` where its norm ``p² − q²A²`` is ``n²``."""
        for position, degree, _ in self.relations:
            if (
                degree % 2
                or self.at(position).kind != "root"
                or f.degrees()[position] < degree // 2
            ):
                continue
            parts = self.split(f, position)
            if set(parts) != {0, degree // 2}:
                continue
            p, surd = parts[0], parts[degree // 2] * self.variables[position] ** (degree // 2)
            n = self._square_root(self.reduce(p**2 - surd**2))
            if n is None or (p + n).is_zero() or (p - n).is_zero():
                continue
            half = min((p + n, p - n), key=lambda s: (s.total_degree(), len(s), str(s)))
            if self.is_mixed(half):
                continue
            unit, factors = self.factor(half + surd)
            below, others = self.factor(half)
            number = fmpq(unit**2, 2 * abs(below))
            primes = [(self.context.constant(prime), k) for prime, k in self._primes(number.p)]
            primes += [(self.context.constant(prime), -k) for prime, k in self._primes(number.q)]
            squares = [(part, 2 * k) for part, k in factors]
            inverse = [(part, -k) for part, k in others]
            return fmpz(1 if below > 0 else -1), [*primes, *squares, *inverse]
        return None

    def _square_root(self, p: Poly) -> Poly | None:
        """A polynomial whose square is ``p``, or None."""
        if p.is_zero() or len(p) > CONJUGATE_TERMS:
            return None
        constant = p.is_constant()
        unit, parts = (p.leading_coefficient(), []) if constant else small_factor(self, p)
        if unit < 0 or not unit.is_square() or any(k % 2 for _, k in parts):
            return None
        result = self.context.constant(unit.isqrt())
        for part, k in parts:
            result = result * part ** (k // 2)
        return result

    def factors(self, x: Fraction) -> tuple[int, Factors]:
        """``x`` as a sign times powers of canonical factors, primes among them.

        Raises:
            UndefinedError: ``x`` is zero.
        """
        if x.num.is_zero():
            raise UndefinedError("a logarithm or negative power of zero")
        result: Factors = {}
        sign = 1
        for p, side in ((x.num, 1), (x.den, -1)):
            unit, parts = self.factor(p)
            sign = sign if unit > 0 else -sign
            for prime, k in self._primes(abs(unit)):
                parts = [*parts, (self.context.constant(prime), k)]
            for part, k in parts:
                key = str(part)
                old = result.get(key, (part, fmpq(0)))[1]
                result[key] = (part, old + side * k)
        return sign, {key: value for key, value in result.items() if value[1] != 0}

    @staticmethod
    def _primes(n: fmpz) -> list[tuple[fmpz, int]]:
        if n == 1:
            return []
        if n.bit_length() > MAX_PRIME_BITS:
            return [(n, 1)]
        return [(prime, int(k)) for prime, k in n.factor()]

    def _sign_function(self, x: Fraction) -> Fraction:
        if x.num.is_zero():
            return self.zero
        sign, parts = self.factors(x)
        product = self.context.constant(sign)
        for part, k in parts.values():
            if k.p % 2:
                product = product * self.sigma(part)
        return Fraction(self.reduce(product), self.one_poly)

    def sigma(self, f: Poly) -> Poly:
        """The sign of a factor; an arc tangent has the sign of its argument."""
        used = self.used(f)
        if len(f) == 1 and f.total_degree() == 1:
            generator = self.at(used[0])
            if generator.kind == "atan":
                return self._sign_function(generator.data[0]).num
            if generator.kind == "sign":
                return f
        inner = None if self.sign(f) else same_sign(self, f)
        if inner is not None:
            return self._sign_function(Fraction(inner, self.one_poly)).num
        return super().sigma(f)

    def _by_signs(self, x: Fraction) -> list[tuple[Fraction, Fraction]] | None:
        """``x`` as a sum of products of signs times what has none; None if it has none itself."""
        if any(self.at(i).kind == "sign" for i in self.used(x.den)):
            return None
        groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpz]] = {}
        signs = [i for i in self.used(x.num) if self.at(i).kind == "sign"]
        if not signs:
            return None
        for monomial, value in x.num.terms():
            powers = [int(k) for k in monomial]
            outer = tuple(k if i in signs else 0 for i, k in enumerate(powers))
            inner = tuple(0 if i in signs else k for i, k in enumerate(powers))
            groups.setdefault(outer, {})[inner] = value
        return [
            (
                Fraction(self.context.from_dict({outer: 1}), self.one_poly),
                self.make(self.context.from_dict(part), x.den),
            )
            for outer, part in groups.items()
        ]

    def _sign_content(self, x: Fraction) -> tuple[Fraction, Fraction] | None:
        """A product of signs that every term of ``x`` contains, and the rest; else None."""
        parts = self._by_signs(x)
        return parts[0] if parts is not None and len(parts) == 1 else None

    def _require_positive(self, x: Fraction, strict: bool = False) -> None:
        """Record that ``x`` is not negative on the domain; with ``strict``, that it is positive."""
        if x.num.is_zero():
            return
        sign, parts = self.factors(x)
        self.require_sign([(part, int(k.p)) for part, k in parts.values()], sign, strict)

    def require_sign(self, parts: list[tuple[Poly, int]], sign: int, strict: bool = False) -> None:
        """As in the base class, and of the arguments of inverse functions too."""
        for i, (part, k) in enumerate(parts):
            if k % 2 == 0 or (str(part) not in self.known_signs and self.sign(part)):
                continue
            inner = same_sign(self, part)
            if inner is not None and not inner.is_zero():
                outer, more = self.factors(Fraction(inner, self.one_poly))
                powers = [(f, int(n.p)) for f, n in more.values()]
                self.require_sign([*parts[:i], *powers, *parts[i + 1 :]], sign * outer, strict)
                break
        super().require_sign(parts, sign, strict)

    def _prove_sign(self, p: Poly, depth: int) -> int:
        found = super()._prove_sign(p, depth)
        inner = same_sign(self, p) if not found and depth < MAX_DEPTH else None
        return found if inner is None else self.product_sign(inner, depth + 1)

    def _power(self, base: Expr, exponent: Expr) -> Fraction:
        x = self._walk(base)
        r = self.rational(self._walk(exponent))
        if r is not None and r.q == 1:
            return self.power(x, int(r.p))
        if r is not None:
            if "roots" not in self.theories:
                return self._opaque("^", x, self.constant(r))
            return self._root(x, r)
        if "exponentials" not in self.theories:
            return self._opaque("^", x, self._walk(exponent))
        return self.exp(self.multiply(self._walk(exponent), self.log(x)))

    def _root(self, x: Fraction, r: fmpq, signed: bool = False) -> Fraction:
        """``x**r`` for ``x ≥ 0``; with ``signed``, the odd root that keeps the sign of ``x``."""
        if x.num.is_zero():
            if r < 0:
                raise UndefinedError("a negative power of zero")
            return self.zero
        sign, parts = self.factors(x)
        result = self.one
        if signed:
            result = self.constant(sign)
            for part in (part for part, k in parts.values() if k.p % 2):
                result = self.multiply(result, Fraction(self.sigma(part), self.one_poly))
        else:
            self._require_positive(x, strict=r < 0)
        for part, k in parts.values():
            result = self.multiply(result, self._absolute_power(part, k * r))
        return result

    def _absolute_power(self, f: Poly, r: fmpq) -> Fraction:
        """``|f|**r`` for a canonical factor ``f``."""
        if r == 0:
            return self.one
        used = self.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.variables[used[0]]:
            generator = self.at(used[0])
            if generator.kind == "sign":
                return self.one
            if generator.kind == "root" and r.q != 1:
                base, order = generator.data
                return self._absolute_power(base, r / order)
            if generator.kind == "exp" and r.q != 1:
                index, unit = generator.data[:2]
                return self._basis_exp([(index, r / unit)])
        whole = r.p // r.q
        rest = r - whole
        result = self.power(Fraction(f, self.one_poly), int(whole))
        if whole % 2:
            result = self.multiply(result, Fraction(self.sigma(f), self.one_poly))
        if rest != 0:
            order = self._order(f, int(rest.q))
            root = self._root_generator(f, order)
            k = int(rest.p * (order // rest.q))
            result = self.multiply(result, Fraction(root**k, self.one_poly))
        return result

    def _order(self, f: Poly, n: int) -> int:
        key = str(f)
        old = self._orders.get(key, 1)
        new = lcm(old, n)
        if new > 60:
            raise TooLargeError("a root of order beyond 60")
        self._orders[key] = new
        if new != old != 1:
            raise AgainError
        return new

    def _root_generator(self, f: Poly, order: int) -> Poly:
        key = (str(f), order)
        sign = self.sigma(f)
        if not self.known("root", key):
            generator = self.generator("root", key, (f, order))
            self.relate(generator, order, f * sign)
        return self.variable(self.generator("root", key))

    # Exponentials and logarithms

    def log(self, x: Fraction) -> Fraction:
        """``log x`` on ``x > 0``, as a sum over the factors of ``x``."""
        self._require_positive(x, strict=True)
        _, parts = self.factors(x)
        terms = []
        for part, k in parts.values():
            terms.append(self.multiply(self.constant(k), self._log_absolute(part)))
        return self.sum(terms)

    def _log_absolute(self, f: Poly) -> Fraction:
        used = self.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.variables[used[0]]:
            generator = self.at(used[0])
            if generator.kind == "sign":
                return self.zero
            if generator.kind == "root":
                base, order = generator.data
                inner = self.log_of_absolute(base)
                return self.multiply(self.constant(fmpq(1, order)), inner)
            if generator.kind == "exp":
                index, unit = generator.data[:2]
                return self.multiply(self.constant(fmpq(1, unit)), self._basis["exp"][index])
        return self._fraction(self.generator("log", str(f), (f,)))

    def log_of_absolute(self, p: Poly) -> Fraction:
        """``log|p|``."""
        _, parts = self.factors(Fraction(p, self.one_poly))
        return self.sum(
            [
                self.multiply(self.constant(k), self._log_absolute(part))
                for part, k in parts.values()
            ]
        )

    def exp(self, x: Fraction) -> Fraction:
        """``exp x``; rational multiples of logarithms turn back into powers."""
        parts = self._by_signs(x)
        if parts is not None:
            return self._exp_by_signs(parts)
        result = self.one
        rest, pieces = self.linear_part(x, "log")
        for generator, r in pieces:
            result = self.multiply(result, self._absolute_power(generator.data[0], r))
        return self.multiply(result, self._basis_exp(self._decompose("exp", rest)))

    def _exp_by_signs(self, parts: list[tuple[Fraction, Fraction]]) -> Fraction:
        """The exponential of a sum of ``s·w``, each cosh w + s sinh w where s is a sign."""
        result = self.one
        for sign, part in parts:
            y = self.exp(part)
            if not sign.num.is_one():
                z = self.invert(y)
                odd = self.multiply(sign, self.subtract(y, z))
                total = self.add(self.add(y, z), odd)
                y = self.multiply(self.constant(fmpq(1, 2)), total)
            result = self.multiply(result, y)
        return result

    def linear_part(self, x: Fraction, kind: str) -> tuple[Fraction, list[tuple[Generator, fmpq]]]:
        """Split off the rational multiples of generators of ``kind`` that ``x`` contains."""
        pieces = []
        for position in self.used(x.num):
            generator = self.at(position)
            if generator.kind != kind:
                continue
            ratio = fmpq(0)
            if x.den.is_constant():
                alone = tuple(int(i == position) for i in range(self.size))
                ratio = fmpq(x.num[alone], x.den.leading_coefficient())
            elif x.num.degrees()[position] == 1:
                ratio = self._share(x, position)
            if ratio != 0:
                pieces.append((generator, ratio))
        for generator, ratio in pieces:
            x = self.subtract(x, self.multiply(self.constant(ratio), self._fraction(generator)))
        return x, pieces

    def _share(self, x: Fraction, position: int) -> fmpq:
        """The rational multiple of a generator in ``x``, linear in it, off its proper fraction."""
        content = x.den.content()
        quotient, _ = divmod(x.num.derivative(position), x.den // content)
        return fmpq(quotient[(0,) * self.size], content)

    def _basis_exp(self, terms: Iterable[tuple[int, fmpq]]) -> Fraction:
        result = self.one
        for index, r in terms:
            unit = self._unit("exp", index, int(r.q))
            exponent = self._basis["exp"][index]
            generator = self.generator("exp", (index, unit), (index, unit, exponent))
            y = self._fraction(generator)
            result = self.multiply(result, self.power(y, int(r.p * (unit // r.q))))
        return result

    def _unit(self, kind: str, index: int, q: int) -> int:
        old = self._units[kind][index]
        if old % q:
            self._units[kind][index] = lcm(old, q)
            raise AgainError
        return old

    def _decompose(self, kind: str, x: Fraction) -> list[tuple[int, fmpq]]:
        """``x`` as a rational combination of the basis of its kind, which it may extend."""
        terms: list[tuple[int, fmpq]] = []
        if kind == "exp":
            for monomial, value in x.num.terms() if x.den.is_constant() else ():
                if not any(monomial):
                    r = fmpq(value, x.den.leading_coefficient())
                    x = self.subtract(x, self.constant(r))
                    terms.append((self._basis_index(kind, self.one), r))
        if x.num.is_zero():
            return terms
        basis = self._basis[kind]
        for index, element in enumerate(basis):
            if element.den == x.den:
                ratio = _proportion(x.num, element.num)
                if ratio is not None:
                    return [*terms, (index, ratio)]
        solution = self._combination(basis, x) if basis else None
        if solution is None:
            return [*terms, (self._basis_index(kind, x), fmpq(1))]
        return terms + [(index, r) for index, r in enumerate(solution) if r != 0]

    def _basis_index(self, kind: str, x: Fraction) -> int:
        basis = self._basis[kind]
        for index, element in enumerate(basis):
            if element.num == x.num and element.den == x.den:
                return index
        basis.append(x)
        self._units[kind].append(1)
        return len(basis) - 1

    def _combination(self, basis: list[Fraction], x: Fraction) -> list[fmpq] | None:
        """Rational coefficients with ``Σ c_i basis_i = x``, or None."""
        common = x.den
        for element in basis:
            common = common * (element.den // common.gcd(element.den))
        columns = [dict((item.num * (common // item.den)).terms()) for item in (*basis, x)]
        rows = sorted({monomial for column in columns for monomial in column})
        if not set(columns[-1]) <= {m for column in columns[:-1] for m in column}:
            return None
        matrix = fmpq_mat(
            [[fmpq(column.get(monomial, 0)) for column in columns] for monomial in rows]
        )
        reduced, _ = matrix.rref()
        n = len(basis)
        solution = [fmpq(0)] * n
        for i in range(len(rows)):
            pivot = next((j for j in range(n + 1) if reduced[i, j] != 0), None)
            if pivot == n:
                return None
            if pivot is not None:
                solution[pivot] = reduced[i, n]
        return solution

    # Angles

    def _turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Cosine and sine of ``x``."""
        result = (self.one, self.zero)
        parts = self._by_signs(x)
        if parts is not None:
            for sign, part in parts:
                c, s = self._turn(part)
                result = self._rotate(result, (c, self.multiply(s, sign)))
            return result
        rest, half_turns = self._split_pi(x)
        for sign, r in half_turns:
            c, s = self.turn_of_pi(r)
            result = self._rotate(result, (c, self.multiply(s, sign)))
        rest, inverses = self._split_atan(rest)
        for generator, sign, r in inverses:
            if (2 * r).q == 1 and abs(r) < 40:
                step = self._turn_of_atan(generator.data[0], half=r.q == 2)
                c, s = self._turn_power(step, int((r * r.q).p))
                result = self._rotate(result, (c, self.multiply(s, sign)))
            else:
                term = self.multiply(self.constant(r), self._fraction(generator))
                rest = self.add(rest, self.multiply(term, sign))
        if self._may_be_odd_turn(rest):
            return self._rotate(result, self._plain_turn(rest))
        for index, r in self._decompose("tan", rest):
            unit = self._unit("tan", index, int(r.q))
            angle = self._basis["tan"][index]
            t = self.variable(self.generator("tan", (index, unit), (index, unit, angle)))
            n = int(r.p * (unit // r.q))
            result = self._rotate(result, self._turn_of_half_tangent(t, n))
        return result

    def _rotate(
        self, x: tuple[Fraction, Fraction], y: tuple[Fraction, Fraction]
    ) -> tuple[Fraction, Fraction]:
        """The product of two complex numbers."""
        (a, b), (c, d) = x, y
        return (
            self.subtract(self.multiply(a, c), self.multiply(b, d)),
            self.add(self.multiply(a, d), self.multiply(b, c)),
        )

    def _turn_power(self, x: tuple[Fraction, Fraction], n: int) -> tuple[Fraction, Fraction]:
        c, s = x if n >= 0 else (x[0], self.negative(x[1]))
        result = (self.one, self.zero)
        for _ in range(abs(n)):
            result = self._rotate(result, (c, s))
        return result

    def _turn_of_half_tangent(self, t: Poly, n: int) -> tuple[Fraction, Fraction]:
        """Cosine and sine of nθ from t = tan(θ/2): (1 + it)^2n/(1 + t²)^n."""
        m = abs(n)
        if m > MAX_MULTIPLE:
            raise TooLargeError("a multiple of an angle beyond 96")
        real, imaginary = self.zero_poly, self.zero_poly
        for k in range(2 * m + 1):
            term = (-1) ** (k // 2) * comb(2 * m, k) * t**k
            if k % 2:
                imaginary = imaginary + term
            else:
                real = real + term
        den = (1 + t * t) ** m
        if n < 0:
            imaginary = -imaginary
        return self.make(real, den), self.make(imaginary, den)

    def _turn_of_atan(self, u: Fraction, half: bool) -> tuple[Fraction, Fraction]:
        """Cosine and sine of atan u, or of half of it."""
        square = self.add(self.one, self.power(u, 2))
        self._require_positive(square)
        c = self._root(square, fmpq(-1, 2))
        if not half:
            return c, self.multiply(u, c)
        middle = self.multiply(self.constant(fmpq(1, 2)), self.add(self.one, c))
        half_c = self._root(middle, fmpq(1, 2))
        s = self.multiply(self.multiply(u, c), self.constant(fmpq(1, 2)))
        return half_c, self.divide(s, half_c)

    def _may_be_odd_turn(self, x: Fraction) -> bool:
        """Whether an angle might be an odd multiple of π on a whole region.

        The tangent of its half would be infinite there. What is left of an angle is a constant
        that balls keep from such multiples, or varies.
        """
        used = {i for p in (x.num, x.den) for i in self.used(p)}
        if used and self.is_constant(x):
            return bool((self.ball(x) / arb.pi() / 2).cos_pi().contains(0))
        involved = self.involved(x.num) | self.involved(x.den)
        kinds = {self.at(i).kind for i in used | involved}
        if self.are_tied(used | involved) or kinds & {"opaque", "cos", "sin", "sign"}:
            return not self.varies(x)
        return False

    def _plain_turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Cosine and sine of ``x`` as generators with c² + s² = 1 and no more."""
        result = (self.one, self.zero)
        for index, r in self._decompose("turn", x):
            unit = self._unit("turn", index, int(r.q))
            data = (index, unit, self._basis["turn"][index])
            c, s = (self.generator(kind, (index, unit), data) for kind in ("cos", "sin"))
            self.relate(s, 2, self.one_poly - self.variable(c) ** 2)
            n = int(r.p * (unit // r.q))
            if abs(n) > MAX_MULTIPLE:
                raise TooLargeError("a multiple of an angle beyond 96")
            step = self._fraction(c), self._fraction(s)
            result = self._rotate(result, self._turn_power(step, n))
        return result

    def _split_atan(self, x: Fraction) -> tuple[Fraction, list[tuple[Generator, Fraction, fmpq]]]:
        """Split off arc tangents with a rational coefficient, or one that is ± by signs."""
        x, plain = self.linear_part(x, "atan")
        pieces = [(generator, self.one, r) for generator, r in plain]
        for monomial, value in x.num.terms() if x.den.is_constant() else ():
            used = [self.at(i) for i, k in enumerate(monomial) if k]
            inverses = [g for g in used if g.kind == "atan" and monomial[g.position] == 1]
            if len(inverses) != 1 or any(g.kind != "sign" for g in used if g != inverses[0]):
                continue
            sign = self.context.from_dict({tuple(map(int, monomial)): 1})
            sign = Fraction(sign // self.variable(inverses[0]), self.one_poly)
            r = fmpq(value, x.den.leading_coefficient())
            pieces.append((inverses[0], sign, r))
        for generator, sign, r in pieces[len(plain) :]:
            term = self.multiply(self.constant(r), self._fraction(generator))
            x = self.subtract(x, self.multiply(term, sign))
        return x, pieces

    def _split_pi(self, x: Fraction) -> tuple[Fraction, list[tuple[Fraction, fmpq]]]:
        """``x`` without its rational multiples of π and of π times signs, and those multiples."""
        if not self.known("pi", None):
            return x, []
        position = self.generator("pi", None).position
        pieces = []
        if not x.den.is_constant():
            r = self._share(x, position) if x.num.degrees()[position] == 1 else fmpq(0)
            return self.subtract(x, self.pi(r)), [(self.one, r)]
        for monomial, value in x.num.terms():
            others = [i for i, k in enumerate(monomial) if k and i != position]
            if monomial[position] == 1 and all(self.at(i).kind == "sign" for i in others):
                sign = self.context.from_dict({tuple(map(int, monomial)): 1})
                sign = Fraction(sign // self.variables[position], self.one_poly)
                pieces.append((sign, fmpq(value, x.den.leading_coefficient())))
        for sign, r in pieces:
            x = self.subtract(x, self.multiply(self.pi(r), sign))
        return x, pieces

    def turn_of_pi(self, r: fmpq) -> tuple[Fraction, Fraction]:
        """Cosine and sine of rπ."""
        if r == 0:
            return self.one, self.zero
        if 12 % int(r.q) == 0:
            return self._turn_power(self._twelfth(12 // int(r.q)), int(r.p % (2 * r.q)))
        return self._cyclotomic(r)

    def _cyclotomic(self, r: fmpq) -> tuple[Fraction, Fraction]:
        """Cosine and sine of rπ as polynomials in z = 2cos(π/M), of known minimal polynomial."""
        old = self._half_turn
        m = lcm(old, 2 * int(r.q))
        if m > MAX_HALF_TURN:
            raise TooLargeError(f"an angle of pi/{m}")
        self._half_turn = m
        if m != old != 1:
            raise AgainError
        generator = self.generator("cosine", m, (m,))
        z = self.variable(generator)
        minimal = fmpz_poly.cos_minpoly(2 * m)
        if not any(position == generator.position for position, _, _ in self.relations):
            tail = self.zero_poly
            for k in range(minimal.degree()):
                tail = tail - z**k * minimal[k]
            self.relate(generator, minimal.degree(), tail)
        k = int((r * m).p) % (2 * m)
        return self._chebyshev(z, k), self._chebyshev(z, m // 2 - k)

    def _chebyshev(self, z: Poly, k: int) -> Fraction:
        """The cosine of kπ/M from z = 2cos(π/M)."""
        low, high = self.context.constant(2), z
        for _ in range(abs(k)):
            low, high = high, self.reduce(z * high - low)
        return self.make(low, self.context.constant(2))

    def _twelfth(self, k: int) -> tuple[Fraction, Fraction]:
        """Cosine and sine of kπ/12 for k = 1, 2, 3, 4, 6, 12."""
        two, three = (self._root(self.constant(n), fmpq(1, 2)) for n in (2, 3))
        half, quarter = self.constant(fmpq(1, 2)), self.constant(fmpq(1, 4))
        six = self.multiply(two, three)
        match k:
            case 1:
                return (
                    self.multiply(quarter, self.add(six, two)),
                    self.multiply(quarter, self.subtract(six, two)),
                )
            case 2:
                return self.multiply(half, three), half
            case 3:
                return self.multiply(half, two), self.multiply(half, two)
            case 4:
                return half, self.multiply(half, three)
            case 6:
                return self.zero, self.one
            case _:
                return self.constant(-1), self.zero

    # Inverse functions

    def atan(self, u: Fraction) -> Fraction:
        """``atan u``, odd in u, with atan(1/u) = ±π/2 − atan u used to choose between the two."""
        if u.num.is_zero():
            return self.zero
        special = self._special_atan(u)
        if special is not None:
            return special
        if u.num.leading_coefficient() < 0:
            return self.negative(self.atan(self.negative(u)))
        signed = self._sign_content(u)
        if signed is not None:
            return self.multiply(signed[0], self.atan(signed[1]))
        if not self.is_mixed(u.num):
            inverse = self.invert(u)
            if self._rank(inverse) < self._rank(u):
                sign = self._sign_function(u)
                quarter = self.multiply(sign, self.pi(fmpq(1, 2)))
                return self.subtract(quarter, self.atan(inverse))
        return self._fraction(self.generator("atan", u.key, (u,)))

    def _rank(self, u: Fraction) -> tuple[bool, int, int, str]:
        """Least for the one of u and 1/u that is to be kept: where it can, it has no poles."""
        return not self.product_sign(u.den), len(u.den), int(u.den.total_degree()), str(u.den)

    def _special_atan(self, u: Fraction) -> Fraction | None:
        """``atan u`` where it is a multiple of π/12."""
        if not self.is_constant(u):
            return None
        value = self.ball(u).atan() * 12 / arb.pi()
        k = value.unique_fmpz()
        if k is None or abs(k) >= 6:
            return None
        c, s = self.turn_of_pi(fmpq(k, 12))
        if not self.subtract(u, self.divide(s, c)).num.is_zero():
            return None
        return self.pi(fmpq(k, 12))

    def _asin(self, u: Fraction) -> Fraction:
        below, above = self.subtract(self.one, u), self.add(self.one, u)
        if below.num.is_zero() or above.num.is_zero():
            return self.pi(fmpq(1 if below.num.is_zero() else -1, 2))
        self._require_positive(below)
        self._require_positive(above)
        c = self._root(self.multiply(below, above), fmpq(1, 2))
        if self.is_mixed(below.num) or self.is_mixed(above.num):
            # c may be 0 on a region; 1 + c is not
            half = self.atan(self.divide(u, self.add(self.one, c)))
            return self.multiply(self.constant(2), half)
        return self.atan(self.divide(u, c))

    def _asinh(self, u: Fraction) -> Fraction:
        square = self.add(self.one, self.power(u, 2))
        self._require_positive(square)
        return self.log(self.add(u, self._root(square, fmpq(1, 2))))

    def _acosh(self, u: Fraction) -> Fraction:
        below, above = self.subtract(u, self.one), self.add(u, self.one)
        if below.num.is_zero():
            return self.zero
        self._require_positive(below)
        self._require_positive(above)
        return self.log(self.add(u, self._root(self.multiply(below, above), fmpq(1, 2))))

    def _atanh(self, u: Fraction) -> Fraction:
        below, above = self.subtract(self.one, u), self.add(self.one, u)
        difference = self.subtract(self.log(above), self.log(below))
        return self.multiply(self.constant(fmpq(1, 2)), difference)


_CIRCULAR = {
    "sinh": "sin",
    "cosh": "cos",
    "tanh": "tan",
    "coth": "cot",
    "sech": "sec",
    "csch": "csc",
}


def _proportion(p: Poly, q: Poly) -> fmpq | None:
    """r with ``p = r·q``, or None."""
    if p.is_zero() or q.is_zero() or len(p) != len(q):
        return None
    a, b = p.leading_coefficient(), q.leading_coefficient()
    return fmpq(a, b) if p * b == q * a else None
