"""Seeded faults: false statements that pass if a guard of the judge is missing.

They are judged together with the mutants. If one is accepted, the guard that should refuse it is
missing.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import arb, fmpq
from sympy import Gt, Integer, Integral, Rational, Symbol, pi, sqrt

from tresym.ledger.claim import (
    Chain,
    Claim,
    Counterexample,
    Definition,
    Printed,
    by,
    equal,
    step,
)
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.reasons import (
    changing_variable,
    citing,
    collecting,
    integrating,
    roots,
    substituting,
)
from tresym.ledger.statements import Rounds
from tresym.reals.balls.branch_and_bound import Bound, box

t, u, v = (Symbol(name, real=True) for name in "tuv")
HALF = Rational(1, 2)


def planted() -> Iterator[Claim]:
    """Return the false claims, each with evidence that only one guard of the judge refuses."""
    yield from _of_integrals()
    yield from _of_definitions()
    yield from _of_evidence()


def _of_integrals() -> Iterator[Claim]:
    whole = Integral(2 * t, (t, 0, 1))
    freed = equal(whole, Integral(t, (v, 0, 2)))
    yield Claim("planted: a variable set free", freed, by(changing_variable(2 * t)))
    parts = Integral(t, (u, 0, 1)) + Integral(u, (u, 0, 1))
    caught = equal(parts, Integral(2 * t, (t, 0, 1)))
    yield Claim("planted: a symbol caught", caught, by(collecting()))
    half = Claim("planted: t is 1/2", equal(t, HALF), Definition())
    shown = (step(5 * HALF, substituting(half)),)
    bound = Claim("planted: t below 3", Gt(3 - t, 0, evaluate=False), shown)
    pole = equal(Integral(1 / (3 - t) ** 2, (t, 0, 10)), -Rational(10, 21))
    yield Claim("planted: across a pole", pole, by(integrating(1 / (3 - t), bound)))
    sign = Gt(Integral(3 - t, (t, 0, 10)), 0, evaluate=False)
    yield Claim("planted: a bound inside", sign, (step(sign.args[0], citing(bound)),))
    below = Gt(3 - t, 0, evaluate=False)
    yield Claim("planted: against a bound", below, (step(3 - t, citing(bound)),), given=(t > 5,))


def _of_definitions() -> Iterator[Claim]:
    one, two = (Claim(f"planted: t is {n}", equal(t, n), Definition()) for n in (1, 2))
    steps: Chain = (step(t, substituting(one)), step(None, substituting(two)))
    yield Claim("planted: defined twice", equal(1, 2), steps)
    area = Integral(2 * u, (u, 0, t))
    put_in = Definition("so it is")
    four = Claim("planted: an area of 4", equal(area, 4), put_in, given=(t > 0,))
    three = Claim("planted: t is 3", equal(t, 3), Definition())
    steps = (
        step(area, substituting(four)),
        step(t**2, integrating(u**2)),
        step(None, substituting(three)),
    )
    yield Claim("planted: an area twice", equal(4, 9), steps, given=(t > 0,))
    to_and_fro = (
        Claim("planted: t by u", equal(t, u + 1), Definition()),
        Claim("planted: u by t", equal(u, t + 1), Definition()),
    )
    steps = tuple(step(e, substituting(c)) for e, c in zip((u + 1, t + 2), to_and_fro, strict=True))
    yield Claim("planted: a circle", equal(t, t + 2), steps)
    square = Claim("planted: u by t squared", equal(u, t**2), Definition())
    steps = (step(u, integrating(u * t)), step(None, substituting(square)))
    yield Claim("planted: a constant of what is bound", equal(Integral(u, (t, 0, 1)), t**2), steps)
    none = equal(u, Integral(1 / v, (v, -1, 1)))
    yield Claim("planted: what does not exist", none, Definition())
    right = Claim("planted: t above 0", equal(sqrt(t**2) * u, t * u), by(roots), given=(t > 0,))
    says = equal(sqrt(t**2) * u, t * u)
    yield Claim("planted: a condition unsaid", says, by(substituting(right)), given=(t < 0,))


def _of_evidence() -> Iterator[Claim]:
    false = equal(Integer(0), Integer(1))
    true = Gt(t**2 + 1, 0, evaluate=False)
    yield Claim("planted: another formula", false, Decided(), means=true)
    square = Bound(lambda x, m: x * x, box(("1", "2")))
    yield Claim("planted: another bound", Gt(u, 100, evaluate=False), Boxes((square,), ("u",), "…"))
    always = Bound(lambda x, m: arb(1), box(("1", "2")))
    yield Claim("planted: no bound", "x < 0 for 1 <= x <= 2", Boxes((always,), ("x",), "…"))
    wide = Rounds(pi, "4.00", 1000)
    yield Claim("planted: nearly π", "π = 4.00", Printed(), means=wide)
    point, below = Counterexample({"t": fmpq(1, 10)}), 400 * t**2 <= 1
    says = "400t² is smooth at 0"
    yield Claim("planted: no smoothness", says, point, given=(t**2 <= 1,), means=below)
