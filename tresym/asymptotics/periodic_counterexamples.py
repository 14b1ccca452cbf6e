"""What oscillating functions do again and again as a variable tends to infinity.

If the arguments of all sines and cosines are of the first degree, with slopes of rational ratios,
they have a common period P. At c + nP each has the value that it has at c, and what is left does
not oscillate. A claim that fails there from some n on is false on every neighbourhood of the end,
and a function with different limits for two values of c has none.
"""

from __future__ import annotations

from flint import arb

from tresym.reals.decisions.answer import Answer, exact_text
from tresym.reals.decisions.waves import with_fixed_waves
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.expansions.leading_terms import sign_towards
from tresym.reals.language.expression import (
    Expr,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict


def failure_where_waves_return(difference: Expr, relation: str, path: Path) -> Answer | None:
    """Return a refutation at points to which the waves of a difference return, or None."""
    u = symbol("_u")
    if path.point is not None and symbols(path.point):
        return None
    for side in path.sides:
        along = side * u if path.point is None else path.point + side / u
        e = substitute(difference, {path.name: along})
        if symbols(e) != {"_u"}:
            return None
        for c, period, fixed in with_fixed_waves(e, "_u", Given()):
            found = sign_towards(fixed, "_u", None, 1)
            if found is None or stands(arb(found[0]), relation):
                continue
            with ball_precision():
                n = (1 / found[1] / evaluate(period, {})).upper().fmpq().ceil() + 1
            where = exact_text(substitute(along, {"_u": c + number(n) * period}))
            why = (
                f"it fails at {path.name} = {where} and again and again towards the end of the "
                "path, where the sines and cosines have the same values"
            )
            return Answer(Verdict.REFUTED, why, witness={path.name: where})
    return None
