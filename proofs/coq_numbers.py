"""Write Numbers.v: one root for every shape, the bound for rigid bodies, seven 50-digit values."""

from __future__ import annotations

from fractions import Fraction
from importlib.resources import files

from flint import arb, fmpq

from tresym.coq.statement import term, variable
from tresym.racket.body import NAMED_BODIES
from tresym.racket.flip.separatrix import enclose_phase, solve
from tresym.reals.language.expression import number
from tresym.reals.numbers.arithmetic import ball_precision

DIGITS = 50
DIGITS_OF_ROOTS = 30
"""The digits of the root of a shape at which an existential statement holds."""
BITS, PRECISION = 260, 240
HEAD = """Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Tresym.
Open Scope R_scope.
"""


def numbers() -> str:
    """Return the text of ``Numbers.v``."""
    text = files("tresym.coq").joinpath("Numbers.v").read_text(encoding="utf-8")
    first, rest = text.split("\n\nSection", 1)
    bodies = "".join(of_body(name) for name in NAMED_BODIES)
    return f"{first}\n\n{HEAD}\nSection{rest}\n{bodies}"


def of_body(name: str) -> str:
    """Return the statement for one body: every solution of the equation has these digits."""
    shape = NAMED_BODIES[name].shape
    defect = solve(shape.a, shape.b, DIGITS + 4).defect
    with ball_precision(BITS):
        a, b = arb(shape.a), arb(shape.b)
        k, r = (a * b).sqrt(), (b / a).sqrt()
        phase = k * enclose_phase(k, r, BITS)
    low, high = (_decimal(phase, up) for up in (-1, 1))
    near = _decimal(defect, 0)
    a, b = (term(number(x), 3) for x in (shape.a, shape.b))
    label = variable("eps0_" + name.replace("-", "_")).removeprefix("v_")
    return f"""
(* {NAMED_BODIES[name].title} *)
Theorem {label} : forall T : R,
  0 < T ->
  T - sqrt ({a} * {b}) * (PI + atan (sqrt ({b} / {a}) * tanh T)) = 0 ->
  Rabs (defect {a} {b} T
    - {near}) <= 1 / 10 ^ {DIGITS}.
Proof.
  intros T P E.
  assert (I : {low} < T < {high}).
  {{ apply (between (sqrt ({a} * {b})) (sqrt ({b} / {a}))); first
      [ assumption
      | lra
      | rewrite product_of_roots; lra
      | unfold excess; rewrite tanh_exp; interval with (i_prec {PRECISION})
      | apply sqrt_lt_R0; lra ]. }}
  unfold defect, sinh; interval with (i_prec {PRECISION}).
Qed.
"""


def _decimal(x: arb, up: int) -> str:
    """Return the midpoint of a ball in decimals, shifted slightly beyond its radius."""
    digits = DIGITS + 6
    scale = fmpq(10) ** digits
    middle = fmpq(*_quotient(x)) * scale
    whole = int((middle + fmpq(1, 2)).floor()) + 2 * up
    return f"({whole} / 10 ^ {digits})"


def _quotient(x: arb) -> tuple[int, int]:
    """Return the midpoint of a ball as a fraction."""
    man, exp = x.mid().man_exp()
    f = Fraction(int(man)) * Fraction(2) ** int(exp)
    return f.numerator, f.denominator


def between(a: fmpq, b: fmpq) -> tuple[str, str]:
    """Return two decimals between which the defect of a shape lies."""
    man, exp = solve(a, b, DIGITS_OF_ROOTS).defect.mid().man_exp()
    middle = Fraction(int(man)) * Fraction(2) ** int(exp)
    places = DIGITS_OF_ROOTS - 4
    while middle * 10**places < 10 ** (DIGITS_OF_ROOTS - 6):
        places += 1
    low = int(middle * 10**places) - 1
    return f"({low} / 10 ^ {places})", f"({low + 3} / 10 ^ {places})"
