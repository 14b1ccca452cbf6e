"""Decide approximations of weakly nonlinear oscillators on long times, by averaging.

Example: the solution of x'' + x + e*x**3 == 0, x(0) == 1, x'(0) == 0 is cos(t + 3*e*t/8) + O(e)
for all 0 <= t <= 1/e, but not cos(t) + O(e). A condition such as ``t <= 1/e`` ties the time to the
small parameter, so that a claim is meant for all of these times together.

For x'' + ω²x = e f(x, x', t, e), with f a polynomial in x, x' and sines and cosines of multiples of
ωt, an approximation is written with the slow time τ = e*t as

    Y = P(τ) cos(ωt) + Q(τ) sin(ωt) + O(e).

If f(Y, Y_t, t, 0) − 2 Y_{tτ} has no terms in cos(ωt) and sin(ωt), a bounded correction e Y₁ leaves
a residual O(e²), and Gronwall's lemma gives x = Y + O(e) for 0 <= t <= L/e. The terms are Fourier
coefficients, computed exactly. Since P and Q are determined by that and by the initial values, an
approximation in which they do not vanish is wrong by more than O(e) somewhere on the interval.
Equations y' = e f(y, t, e) are treated alike, with Y = P(τ) and the mean of f.

Source: J. A. Sanders, F. Verhulst and J. Murdock, *Averaging Methods in Nonlinear Dynamical
Systems*, 2007, theorem 2.8.1.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from flint import fmpq

from tresym.asymptotics.differential_problem import OpenError, Problem, Value, problem_of
from tresym.asymptotics.explicit_claims import curve_of_claim, nonzero_at
from tresym.asymptotics.explicit_solutions import solutions
from tresym.asymptotics.layer_problems import small_is_bounded
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    fresh,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = "averaging (Sanders, Verhulst and Murdock 2007, theorem 2.8.1)"
MOST = 9
"""The highest power of a sum of sines and cosines."""

Waves = dict[int, tuple[Expr, Expr]]
"""For each multiple of the frequency the factors of cosine and sine."""


def decide_slow_times(claim: Comparison, statement: Statement) -> Answer | None:
    """Decide an order on an interval of the length L/e; None if the conditions name none.

    Raises:
        OpenError: what is missing.
    """
    path = statement.path
    if path is None or path.point != ZERO or claim.relation not in ("O", "o", "->"):
        return None
    small = path.name
    tied = [x for x in statement.given.comparisons if small in symbols(x[0]) | symbols(x[2])]
    if all(len(symbols(x[0]) | symbols(x[2])) == 1 for x in tied):
        return None
    positive = statement.given & Given(((symbol(small), ">", ZERO),))
    problem = problem_of(replace(statement, given=positive))
    if path.name == problem.time or not problem.is_initial:
        return None
    if path.sides != (1,):
        raise OpenError(f"write {small} -> 0+: the interval depends on the sign of {small}")
    name = min(problem.state)[0]
    y = curve_of_claim(claim, problem)[problem.state[name, 0]]
    try:
        work = _Averaging(problem, statement, small)
        work.need_order(claim)
        found = work.answer(y)
        return found if found.verdict is not Verdict.REFUTED else work.with_truth(found)
    except ZeroDivisionError:
        raise OpenError(f"it is not shown to be smooth where {small} = 0") from None


def slow_terms(statement: Statement) -> Expr | None:
    """Return the solution on an interval of the length L/e up to O(e); None if there is none.

    Raises:
        OpenError: it is not found.
    """
    path = statement.path
    if path is None or path.point != ZERO or path.sides != (1,):
        return None
    given = statement.given.comparisons
    positive = statement.given & Given(((symbol(path.name), ">", ZERO),))
    problem = problem_of(replace(statement, given=positive))
    if not any({path.name, problem.time} <= symbols(x[0]) | symbols(x[2]) for x in given):
        return None
    try:
        return _Averaging(problem, statement, path.name).solution()
    except ZeroDivisionError:
        return None


class _Averaging:
    def __init__(self, problem: Problem, statement: Statement, small: str) -> None:
        self.problem, self.small, self.t = problem, small, problem.time
        orders = sorted(problem.state)
        if [k for _, k in orders] not in ([0], [0, 1]):
            raise OpenError("slow times are supported for one equation of first or second order")
        self.y = problem.state[orders[0]]
        self.v = problem.state[orders[1]] if len(orders) == 2 else ""
        taken = {self.y, self.v, small, self.t}.union(
            *(symbols(e) for x in statement.given.comparisons for e in x[::2])
        )
        self.tau = fresh("tau", taken)
        self.fixed, self.length = self._interval(statement)
        slow = symbol(self.tau)
        self.given = self.fixed & Given(((slow, ">=", ZERO), (slow, "<=", self.length)))
        self.right = problem.right[self.v or self.y]
        self.omega = self._frequency()

    def _interval(self, statement: Statement) -> tuple[Given, Expr]:
        """Return the conditions on parameters, and L of t <= L/e."""
        t, e = symbol(self.t), symbol(self.small)
        links: list[Compared] = []
        length: Expr | None = None
        start = False
        if self.problem.start != ZERO:
            raise OpenError("the initial point must be 0")
        for left, relation, right in statement.given.comparisons:
            names = symbols(left) | symbols(right)
            low, high = (left, right) if relation[0] == "<" else (right, left)
            if relation == "!=" and names & {self.t, self.small}:
                raise OpenError(f"the condition on {t} is not supported")
            if self.small in names and self.t in names:
                for factor in (t, t * e):
                    ratio = normal_form(low / factor, Given())
                    rest = normal_form(high * (e if factor == t else ONE) / ratio, Given())
                    if not (symbols(ratio) | symbols(rest)) & {self.t, self.small}:
                        if length is not None:
                            raise OpenError("there are two lengths of the interval")
                        if sign(ratio, Given(tuple(links)), ">") not in PROVING[">"]:
                            raise OpenError(f"it is not known whether {ratio} is positive")
                        length = tidied(rest)
                        break
                else:
                    raise OpenError(f"the condition on {t} and {e} must be {t} <= L/{e}")
            elif self.small in names:
                if names != {self.small} or small_is_bounded((left, relation, right), self.small):
                    raise OpenError("conditions on the small parameter are not supported")
            elif self.t in names:
                if high != t or sign(low, Given(tuple(links)), ">=") not in PROVING[">="]:
                    raise OpenError(f"the conditions on {t} must be 0 <= {t} <= L/{e}")
                start = True
            else:
                links.append((left, relation, right))
        fixed = Given(tuple(links))
        if not start:
            raise OpenError(f"say that {t} >= 0")
        if length is None or sign(length, fixed, ">") not in PROVING[">"]:
            raise OpenError("the interval is not shown to have a positive length")
        return fixed, length

    def _frequency(self) -> Expr:
        """Return ω of the unperturbed equation; 1 for an equation of first order."""
        flat = tidied(normal_form(substitute(self.right, {self.small: ZERO}), Given()))
        if not self.v:
            if flat != ZERO:
                raise OpenError(f"the derivative must be a multiple of {self.small}")
            return ONE
        square = tidied(-differentiate(flat, self.y))
        gap = flat + square * symbol(self.y)
        free = not symbols(square) & {self.y, self.v, self.t}
        if not free or not is_zero(gap, self.fixed):
            raise OpenError(f"for {self.small} = 0 the equation must be x'' = -w**2*x")
        if sign(square, self.fixed, ">") not in PROVING[">"]:
            raise OpenError(f"{square} is not shown to be positive")
        return tidied(normal_form(square ** number(fmpq(1, 2)), self.fixed))

    def need_order(self, claim: Comparison) -> None:
        """Require that the claim is y = Y + O(e), + o(1), or a limit."""
        if claim.relation == "->":
            return
        power = symbol(self.small) if claim.relation == "O" else ONE
        ratio = normal_form(claim.right / power, Given())
        known = not symbols(ratio) & {self.small, self.t}
        if not known or sign(ratio, self.fixed, "!=") not in PROVING["!="]:
            raise OpenError(
                f"on intervals of the length 1/{self.small} errors O({self.small}) and "
                "o(1) are supported"
            )

    # Fourier series with slow factors

    def waves(self, e: Expr, known: dict[str, Waves] | None = None) -> Waves:
        """Return an expression in t, e*t and e as a Fourier series.

        Raises:
            OpenError: it is none.
        """
        known = known or {}
        if e.op == "symbol" and e.args[0] in known:
            return known[str(e.args[0])]
        if not symbols(e) & ({self.t} | known.keys()):
            return {0: (e, ZERO)}
        if e.op == "+":
            return _sum([self.waves(arg, known) for arg in e.args])
        if e.op == "*":
            return self._product(list(e.args), known)
        if e.op == "^" and e.args[1].op == "number":
            base, c = e.args[0], e.args[1].args[0]
            if base == symbol(self.t) or c.q != 1 or not 0 < c <= MOST:
                return {0: (self._slow(e, known), ZERO)}
            whole = self.waves(base, known)
            total = whole
            for _ in range(int(c) - 1):
                total = _times(total, whole)
            return total
        if e.op in ("sin", "cos") and not symbols(e) & known.keys():
            return self._wave(e.op, e.args[0])
        return {0: (self._slow(e, known), ZERO)}

    def _product(self, factors: list[Expr], known: dict[str, Waves]) -> Waves:
        """Return a product, in which each factor t must meet a factor e."""
        times, smalls, rest = 0, 0, []
        for factor in factors:
            base, k = factor, 1
            if factor.op == "^" and factor.args[1].op == "number" and factor.args[1].args[0].q == 1:
                base, k = factor.args[0], int(factor.args[1].args[0])
            if base == symbol(self.t) and k > 0:
                times += k
            elif base == symbol(self.small) and k > 0:
                smalls += k
            else:
                rest.append(factor)
        if times > smalls:
            raise OpenError(f"{self.t} stands without {self.small} outside sines and cosines")
        slow: Expr = ONE
        if times:
            slow = slow * symbol(self.tau) ** times
        if smalls > times:
            slow = slow * symbol(self.small) ** (smalls - times)
        total: Waves = {0: (slow, ZERO)}
        for factor in rest:
            total = _times(total, self.waves(factor, known))
        return total

    def _slow(self, e: Expr, known: dict[str, Waves]) -> Expr:
        """Return an expression in the slow time."""
        if not symbols(e) & ({self.t} | known.keys()):
            return e
        if e.op in ("+", "*", "^"):
            if e.op == "^":
                return rebuild(e, tuple(self._slow(arg, known) for arg in e.args))
            found = self.waves(e, known)
            if set(found) != {0}:
                raise OpenError(f"{e} is not slow")
            return found[0][0]
        if e.op == "symbol":
            raise OpenError(f"{e} stands where only {self.small}*{self.t} is supported")
        if not symbols(e) & known.keys():
            found_ = [self._argument(arg) for arg in e.args]
            if all(fast == ZERO for fast, _ in found_):
                return rebuild(e, tuple(slow for _, slow in found_))
        raise OpenError(f"{e} is neither slow nor a sine or cosine")

    def _argument(self, e: Expr) -> tuple[Expr, Expr]:
        """Return the factor of t, and what is slow, of an argument."""
        if self.t not in symbols(e):
            return ZERO, e
        small, t = symbol(self.small), symbol(self.t)
        fast = tidied(substitute(differentiate(e, self.t), {self.small: ZERO}))
        if self.t in symbols(fast):
            raise OpenError(f"{e} is no multiple of {self.t}, but for multiples of {small * t}")
        slope = tidied(differentiate(e, self.t))
        if self.t not in symbols(slope):  # the argument is g(e)*t + h(e)
            start = substitute(e, {self.t: ZERO})
            at_zero = partial(substitute, mapping={self.small: ZERO})
            if all(continuous_on(at_zero(p), self.given, proof) is None for p in (slope, start)):
                change = at_zero(differentiate(slope, self.small))
                return fast, tidied(
                    normal_form(change * symbol(self.tau) + at_zero(start), self.given)
                )
        positive = self.given & Given(((small, ">", ZERO),))
        rest = substitute(e - fast * t, {self.t: symbol(self.tau) / small})
        slow = tidied(normal_form(rest, positive))
        gap = continuous_on(substitute(slow, {self.small: ZERO}), self.given, proof)
        if gap is not None:
            raise OpenError(f"{e} is not shown to be smooth in {small * t}: {gap}")
        return fast, slow

    def _wave(self, op: str, e: Expr) -> Waves:
        fast, slow = self._argument(e)
        ratio = normal_form(fast / self.omega, self.fixed)
        if ratio.op != "number" or ratio.args[0].q != 1:
            raise OpenError(f"{fast} is no multiple of the frequency {self.omega}")
        k = int(ratio.args[0])
        cos, sin = apply("cos", slow), apply("sin", slow)
        if slow == ZERO:
            cos, sin = ONE, ZERO
        first = (cos, -sin) if op == "cos" else (sin, cos)
        if k == 0:
            return {0: (first[0], ZERO)}
        return {k: first} if k > 0 else {-k: (first[0], -first[1])}

    # The answer

    def answer(self, y: Expr) -> Answer:
        """Decide whether Y is the solution up to O(e) on the interval."""
        at_zero = partial(substitute, mapping={self.small: ZERO})
        whole = self.waves(y)
        for pair in whole.values():
            for part in pair:
                gap = continuous_on(at_zero(part), self.given, proof)
                if gap is not None:
                    raise OpenError(f"{part} is not shown to be smooth: {gap}")
        flat = {k: (tidied(at_zero(c)), tidied(at_zero(s))) for k, (c, s) in whole.items()}
        own = 1 if self.v else 0
        for k, pair in flat.items():
            if k == own:
                continue
            for part, shape in zip(pair, ("cos", "sin"), strict=True):
                if is_zero(part, self.given):
                    continue
                return self._false(part, f"a term {shape}({k}*{self.omega}*{self.t})")
        p, q = flat.get(own, (ZERO, ZERO))
        known: dict[str, Waves] = {self.y: {own: (p, q)}}
        if self.v:
            known[self.v] = {1: (tidied(self.omega * q), tidied(-self.omega * p))}
        for e, what in ((p, 0), (self.omega * q, 1)):
            if what == 1 and not self.v:
                continue
            variable = self.v if what else self.y
            value = tidied(at_zero(self.problem.values[variable]))
            if symbols(value) & {self.small}:
                raise OpenError("the initial values must be smooth in the small parameter")
            there = tidied(substitute(e, {self.tau: ZERO}) - value)
            if not is_zero(there, self.fixed):
                at = nonzero_at(there, self.fixed)
                if at is None:
                    raise OpenError(f"it is not known whether {there} is 0")
                why = f"the initial {'slope' if what else 'value'} is wrong by {there}"
                witness = at if what else {**at, self.t: "0"}
                return Answer(Verdict.REFUTED, why, witness=witness, lemma=LEMMA, uniform=False)
        first = tidied(at_zero(differentiate(self.right, self.small)))
        self._need_polynomial()
        left = self.waves(first, known)
        rate = [differentiate(part, self.tau) for part in (p, q)]
        if self.v:
            bend = {1: (2 * self.omega * rate[1], -2 * self.omega * rate[0])}
        else:
            bend = {0: (rate[0], ZERO)}
        gap_ = _sum([left, {k: (-c, -s) for k, (c, s) in bend.items()}])
        for part in gap_.get(own, (ZERO, ZERO)):
            part = tidied(normal_form(part, self.given))
            if not self._vanishes(part):
                what_ = f"{self.small}*({part}) that grows with the time"
                return self._false(part, f"a secular term of the equation, {what_}")
        names = symbols(y) | symbols(self.right) | symbols(self.length)
        names -= {self.t, self.small, self.y, self.v, self.tau}
        why = (
            f"with {self.tau} = {self.small}*{self.t} the secular terms of the equation vanish, so "
            f"that the error is O({self.small}) for all 0 <= {self.t} <= "
            f"{tidied(self.length / symbol(self.small))}"
        )
        return Answer(Verdict.PROVED, why, lemma=LEMMA, uniform=None if names else True)

    def _vanishes(self, e: Expr) -> bool:
        from tresym.reals.decisions.equalities import decide_equality

        if is_zero(e, self.given):
            return True
        return decide_equality(e, ZERO, self.given).verdict is Verdict.PROVED

    def with_truth(self, answer: Answer) -> Answer:
        """Return a refutation that names the solution, if that is found and proved."""
        try:
            true = self.solution()
            known = true is not None and self.answer(true)
        except (OpenError, ZeroDivisionError, InputError):
            return answer
        if not known:
            return answer
        why = f"the solution is {true} + O({self.small}) on this interval: {answer.why}"
        return replace(answer, why=why)

    def solution(self) -> Expr | None:
        """Return r(τ) cos(ωt + φ(τ)), if the averaged equations for r and φ are solved; or None.

        They are solved where r is constant, or where φ is.
        """
        tau, half = symbol(self.tau), number(fmpq(1, 2))
        start = {
            n: tidied(substitute(e, {self.small: ZERO})) for n, e in self.problem.values.items()
        }
        first = tidied(substitute(differentiate(self.right, self.small), {self.small: ZERO}))
        slow = symbol(self.small) * symbol(self.t)
        if not self.v:
            known: dict[str, Waves] = {self.y: {0: (symbol(self.y), ZERO)}}
            mean = self.waves(first, known).get(0, (ZERO, ZERO))[0]
            found = self._integrated(mean, self.y, start[self.y])
            return None if found is None else substitute(found, {self.tau: slow})
        if self.t in symbols(first):
            return None
        wave, r, phase = "cos", start[self.y], ZERO
        if is_zero(r, self.fixed):
            wave, r = "sin", tidied(start[self.v] / self.omega)
        elif not is_zero(start[self.v], self.fixed):
            return None
        radius = symbol(self.y)
        turn = (
            {1: (ZERO, -self.omega * radius)} if wave == "cos" else {1: (self.omega * radius, ZERO)}
        )
        at = {1: (radius, ZERO) if wave == "cos" else (ZERO, radius)}
        c, s = self.waves(first, {self.y: at, self.v: turn}).get(1, (ZERO, ZERO))
        scale = half / self.omega
        own, across = (-s, -c) if wave == "cos" else (c, -s)
        rate = tidied(normal_form(own * scale, self.fixed))
        bend = tidied(normal_form(across * scale / radius, self.fixed))
        length = self._integrated(rate, self.y, r)
        if length is None:
            return None
        if not is_zero(bend, self.fixed):
            if not is_zero(rate, self.fixed):
                return None
            phase = tidied(normal_form(substitute(bend, {self.y: r}), self.fixed)) * tau
        y = length * apply(wave, self.omega * symbol(self.t) + phase)
        return tidied(substitute(y, {self.tau: slow}))

    def _integrated(self, rate: Expr, name: str, start: Expr) -> Expr | None:
        """Return the solution of an equation in the slow time."""
        if is_zero(rate, self.fixed):
            return start
        values = (Value(ZERO, name, start),)
        problem = Problem(self.tau, {name: rate}, values, {(name, 0): name})
        curve = next(iter(solutions(problem, self.fixed)), None)
        return None if curve is None else curve[name]

    def _false(self, part: Expr, what: str) -> Answer:
        at = nonzero_at(part, self.given)
        if at is None:
            raise OpenError(f"it is not shown that {part} vanishes")
        slow = at.pop(self.tau, None)
        where = f" at {self.small}*{self.t} = {slow}" if slow is not None else ""
        why = f"there is {what}, which is not 0{where}: on an interval of this length the error "
        why += f"is not O({self.small}), nor does it vanish"
        return Answer(Verdict.REFUTED, why, witness=at, lemma=LEMMA, uniform=False)

    def _need_polynomial(self) -> None:
        """Require that the equation is a polynomial in the functions, e, and sines and cosines."""
        marks = {n: {0: (symbol(n), ZERO)} for n in (self.y, self.v) if n}
        for k, (c, s) in self.waves(self.right, marks).items():
            for part in (c, s):
                names = {self.y, self.v, self.small}
                if not _is_polynomial(part, names):
                    raise OpenError(f"the factor {part} of a wave of order {k} is no polynomial")
                if self.tau in symbols(part):
                    raise OpenError("the equation must not contain the slow time")


def _is_polynomial(e: Expr, names: set[str]) -> bool:
    if not symbols(e) & names or e.op == "symbol":
        return True
    if e.op in ("+", "*"):
        return all(_is_polynomial(arg, names) for arg in e.args)
    if e.op == "^" and e.args[1].op == "number":
        c = e.args[1].args[0]
        return bool(c.q == 1 and c > 0) and _is_polynomial(e.args[0], names)
    return False


def _sum(terms: list[Waves]) -> Waves:
    total: Waves = {}
    for term in terms:
        for k, (c, s) in term.items():
            cos, sin = total.get(k, (ZERO, ZERO))
            total[k] = (cos + c, sin + s)
    return total


def _times(one: Waves, other: Waves) -> Waves:
    """Return the product of two Fourier series."""
    half = number(fmpq(1, 2))
    terms: list[Waves] = []
    for j, (a, b) in one.items():
        for k, (c, d) in other.items():
            if j == 0 or k == 0:  # the sine of 0 has no factor
                scale, wave = (a, (c, d)) if j == 0 else (c, (a, b))
                terms.append({j + k: (scale * wave[0], scale * wave[1])})
                continue
            ac, bd, ad, bc = a * c, b * d, a * d, b * c
            terms.append({j + k: (half * (ac - bd), half * (ad + bc))})
            cos, sin = half * (ac + bd), half * (bc - ad)
            if j == k:
                terms.append({0: (cos, ZERO)})
            else:
                terms.append({abs(j - k): (cos, sin if j > k else -sin)})
    return _sum(terms)
