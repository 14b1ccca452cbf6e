"""The names in which the files of ``proofs/`` write claims and evidence.

Every module there imports all of these names, and the paper's symbols from
`tresym.racket.notation`.
"""

# fmt: off
# ruff: isort: skip_file

from __future__ import annotations

import sympy
from flint import arb, fmpq
from sympy import (
    Abs, Basic, Derivative, Equivalent, Expr, Function, Ge, Gt, ImmutableMatrix, Integer, Integral,
    Le, Lt, Ne, Rational, Subs, Symbol, Tuple, acos, asin, asinh, atan, atanh, cos, cosh,
    diff, exp, eye, log, oo, pi, sin, sinh, sqrt, tan, tanh,
)

from tresym.ledger.certificates import certificate
from tresym.ledger.claim import (
    Claim, Counterexample, Definition, Dominated, Fault, FromSlope, FromTheEdge,
    ImplicitFunction, InfimumBy, Instance, Monotone, MonotoneOf, Printed,
    Root, RootBound, RootMonotone, all_of, at, display, equal, equations,
    follows, in_words, jointly, label_claims, line, parts_of,
)
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, On, Reading, Shown
from tresym.ledger.evidence.decided import Decided, InVariables
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.evidence.allowed_evidence import Meant
from tresym.ledger.reasons import (
    adding, algebra, applying, changing_variable, citing, collecting, cutting,
    differentiating_integral, differentiation, evaluating, exponentials, integrating, inverses,
    multiplying, roots, substituting, trigonometry,
)
from tresym.ledger.statements import (
    AtMostOne, ExactlyOne, Infimum, Rounds,
    StrictlyDecreasing, StrictlyIncreasing, TheRoot, Under, order,
)
from tresym.reals.balls.branch_and_bound import Bound, box
from tresym.reals.verdict import Verdict

__all__ = [
    "Abs", "Asymptotics", "AtMostOne", "Basic", "Bound", "Boxes", "Charted", "Claim",
    "Counterexample", "Decided", "Definition", "Denied", "Derivative",
    "Dominated", "Equivalent", "Evaluated", "ExactlyOne", "Expr", "Fault", "FromSlope",
    "FromTheEdge", "Function", "Ge", "Gt", "ImmutableMatrix", "ImplicitFunction",
    "InVariables", "Infimum", "InfimumBy", "Instance", "Integer", "Integral", "Le", "Lt",
    "Meant", "Monotone", "MonotoneOf", "Ne", "On", "Printed", "Rational",
    "Reading", "Root", "RootBound", "RootMonotone", "Rounds", "Shown",
    "StrictlyDecreasing", "StrictlyIncreasing", "Subs", "Symbol", "TheRoot",
    "Tuple", "Under", "Verdict", "acos", "adding", "algebra",
    "all_of", "applying", "arb", "asin", "asinh", "at", "atan", "atanh", "box", "certificate",
    "changing_variable", "citing", "collecting", "cos", "cosh", "cutting", "diff",
    "differentiating_integral", "differentiation", "display", "equal", "equations", "evaluating",
    "exp", "exponentials", "eye", "fmpq", "follows", "in_words", "integrating",
    "inverses", "jointly", "label_claims", "line", "log", "multiplying", "oo", "order",
    "parts_of", "pi", "roots", "sin", "sinh", "sqrt", "substituting", "sympy", "tan",
    "tanh", "trigonometry",
]
