"""Decide what the solution of an equation y' = f(t, y) is close to for large times.

Example: the solution of y' = t − y², y(0) = 0 is close to the curve t = y², since y' is positive
below it and negative above it: y ~ √t as t → ∞. For f a polynomial in y and an explicit function Y
with the residual R = Y' − f(t, Y), the difference D = y − Y satisfies

    D' = −q D − R,   q(t, y) = −(f(t, Y) − f(t, y))/(Y − y).

If q >= m(t) > 0 wherever y may be, an error g(t) that varies slowly, g' = o(m g), bounds D if it
bounds R/m: then K g is above |D| for large K (comparison of solutions). Where y may be is found by
a constant c that the solution does not cross: f(t, c) >= 0 keeps it above c, f(t, c) <= 0 below.

Source: J. K. Hale, *Ordinary Differential Equations*, 1980, theorem I.6.1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.differential_problem import OpenError, Problem
from tresym.asymptotics.explicit_claims import curve_of_claim
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    fresh,
    is_polynomial,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = "comparison of solutions with a curve that attracts them (Hale 1980, theorem I.6.1)"
HIGHEST = 5
LATER = (1, 3, 20)
"""Times from which on the solution is compared."""
ROUNDS = 3


class _Region(NamedTuple):
    """Where the solution is: above the bound or below it; everywhere if there is none."""

    bound: Expr | None
    side: int


def decide_attracted(
    claim: Comparison, problem: Problem, statement: Statement, decided: Decide
) -> Answer:
    """Decide a claim about the solution of one equation as the time tends to infinity.

    Raises:
        OpenError: what is missing.
    """
    if len(problem.right) != 1 or claim.relation not in ("O", "o", "->", "~"):
        raise OpenError("no explicit solution was found")
    work = _Attraction(problem, statement, decided)
    plain = replace(claim, relation="==") if claim.relation == "~" else claim
    y = curve_of_claim(plain, problem)[work.y]
    gauge = {"~": y, "->": ONE}.get(claim.relation, claim.right)
    relation = "O" if claim.relation == "O" else "o"
    reason = "no region was found that the solution does not leave"
    for region in work.regions():
        try:
            work.show(y, relation, gauge, region)
        except OpenError as error:
            reason = str(error)
        else:
            return Answer(Verdict.PROVED, work.why(y, region), lemma=LEMMA)
        for true in work.curves(region):
            explicit = {
                "~": Comparison(true, "~", y),
                "->": Comparison(true - y, "o", ONE),
            }.get(claim.relation, Comparison(true - y, relation, gauge))
            found = decided(explicit, work.late)
            if found.verdict is not Verdict.REFUTED:
                continue
            try:
                work.show(true, "o", true if claim.relation == "~" else gauge, region)
            except OpenError:
                continue
            why = f"{work.why(true, region)}: {found.why}"
            witness = {k: v for k, v in (found.witness or {}).items() if k != work.t}
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=LEMMA)
    raise OpenError(f"no explicit solution was found, and {reason}")


class _Attraction:
    def __init__(self, problem: Problem, statement: Statement, decided: Decide) -> None:
        self.problem, self.decided, self.t = problem, decided, problem.time
        ((self.y, self.right),) = problem.right.items()
        links = statement.given.comparisons
        fixed = tuple(x for x in links if self.t not in symbols(x[0]) | symbols(x[2]))
        self.given = Given(fixed)
        t = symbol(self.t)
        self.after = self.given & Given(((t, ">=", problem.start),))
        self.late = Statement((), self.given, Path(self.t, None, (1,)), "")
        if not is_polynomial(self.right, self.y):
            raise OpenError(f"no explicit solution was found: {self.right} is no polynomial")
        self.factors: list[Expr] = []
        e = self.right
        for k in range(HIGHEST + 1):
            self.factors.append(tidied(normal_form(substitute(e, {self.y: ZERO}), self.given)))
            e = tidied(normal_form(differentiate(e, self.y) / number(fmpq(k + 1)), self.given))
        if e != ZERO:
            raise OpenError(f"no explicit solution was found, and the degree is beyond {HIGHEST}")
        if any(continuous_on(c, self.after, proof) is not None for c in self.factors):
            raise OpenError("the equation is not shown to be smooth after the initial point")
        self.z = fresh("z", {self.y, self.t, *symbols(self.right)})

    def regions(self) -> Iterator[_Region]:
        """Yield regions that the solution does not leave while it exists."""
        start = self.problem.values[self.y]
        for bound in dict.fromkeys((ZERO, start, ONE, -ONE)):
            for side in (1, -1):
                begins = sign(side * (start - bound), self.given, ">=") in PROVING[">="]
                flow = side * substitute(self.right, {self.y: bound})
                if begins and sign(flow, self.after, ">=") in PROVING[">="]:
                    yield _Region(bound, side)

    def rate(self, curve: Expr) -> Expr:
        """Return q as a polynomial in y."""
        y, total = symbol(self.y), ZERO
        for k, c in enumerate(self.factors):
            for j in range(k):
                power = (curve**j if j else ONE) * (y ** (k - 1 - j) if k - 1 - j else ONE)
                total = total - c * power
        return total

    def inside(self, e: Expr, region: _Region) -> tuple[Expr, Given]:
        """Return an expression with y = c ± z, and the condition on z."""
        z = symbol(self.z)
        assert region.bound is not None
        there = tidied(
            normal_form(substitute(e, {self.y: region.bound + region.side * z}), self.given)
        )
        return there, Given(((z, ">=", ZERO),))

    def show(self, y: Expr, relation: str, gauge: Expr, region: _Region) -> None:
        """Show y = Y + O(g) or o(g).

        Raises:
            OpenError: what is missing.
        """
        assert region.bound is not None
        away, beyond = self.inside(self.rate(region.bound), region)
        if sign(away, self.after & beyond, ">=") not in PROVING[">="]:
            raise OpenError("the solution is not shown to exist for all later times")
        rate, beyond = self.inside(self.rate(y), region)
        least = tidied(substitute(rate, {self.z: ZERO}))
        t = symbol(self.t)
        for first in LATER:
            late = self.after & Given(((t, ">=", number(first)),)) & beyond
            if sign(rate - least, late, ">=") in PROVING[">="]:
                break
        else:
            raise OpenError("the rate of attraction is not bounded below")
        slope = tidied(differentiate(y, self.t))
        residual = tidied(normal_form(slope - substitute(self.right, {self.y: y}), late))
        if is_zero(residual, late):
            residual = ZERO
        size = least * gauge
        for needed in (
            Comparison(least, ">", ZERO),
            Comparison(1 / t, "O", least),
            Comparison(gauge, "!=", ZERO),
            Comparison(tidied(differentiate(gauge, self.t)), "o", size),
            Comparison(residual, relation, size),
        ):
            if needed.relation in ("o", "O") and needed.left == ZERO:
                continue
            try:
                found = self.decided(needed, self.late)
            except InputError:
                found = None
            if not found:
                shown = f"{needed.left} {needed.relation} {needed.right}"
                raise OpenError(f"{shown} is not shown for large {self.t}")

    def curves(self, region: _Region) -> Iterator[Expr]:
        """Yield approximations: zeros of f(t, Y) = Y₀', for equations of degree 1 and 2."""
        degree = max((k for k, c in enumerate(self.factors) if c != ZERO), default=0)
        if degree not in (1, 2):
            return
        c, b, a = self.factors[:3]
        slope: Expr = ZERO
        half = number(fmpq(1, 2))
        for _ in range(ROUNDS):
            if degree == 1:
                y = (slope - c) / b
            else:  # the root at which the slope by y is negative
                y = (-b - (b**2 - 4 * a * (c - slope)) ** half) / (2 * a)
            y = tidied(y)
            whole = tidied(normal_form(y, self.after & Given(((symbol(self.t), ">", ONE),))))
            y = min(y, whole, key=lambda e: len(str(e)))
            yield y
            slope = differentiate(y, self.t)

    def why(self, y: Expr, region: _Region) -> str:
        """Return the reason in words."""
        word = "above" if region.side > 0 else "below"
        return (
            f"the solution stays {word} {region.bound}, where the curve {self.y} = {y} attracts "
            "all solutions"
        ).replace(f"{self.y} =", "y =")
