"""The theorems that the proofs quote, each once; a claim whose evidence applies one names it."""

from tresym.ledger.axioms import RUDIN, RULES, Axiom

DOUBLE_SERIES = Axiom(
    "exchange of double sums",
    "A double series that converges absolutely has one sum in whatever order, so that power series "
    "may be multiplied, and put into each other where their absolute values stay inside.",
    RUDIN + "8.3",
    r"\sum_i \sum_j a_{ij} = \sum_j \sum_i a_{ij}",
)

MOTION = Axiom(
    "existence and continuity of solutions",
    "A smooth system of differential equations has exactly one solution through each start. It is "
    "continuous in time and in the start, and goes on for as long as it stays in a closed bounded "
    "region in which the system is smooth.",
    "P. Hartman, Ordinary Differential Equations (1964), Theorems II.1.1, II.3.1 and V.2.1",
)
"""What a sentence on a motion needs besides its formulas, which are about single points of it."""

INVERSE_FUNCTION = Axiom(
    "derivative of the inverse function",
    "A function with a positive derivative has an inverse, whose derivative is the reciprocal; a "
    "composed function is differentiated by the chain rule.",
    RUDIN + "5.5, and Exercise 5.2",
    r"\frac{d\theta}{d\phi} = \frac{d\theta}{dt}\Big/\frac{d\phi}{dt}",
)

AMPLITUDE = Axiom(
    "Jacobi's amplitude",
    "sn and cn are the sine and cosine of the amplitude, whose derivative is dn = √(1 − k² sn²).",
    "NIST Digital Library of Mathematical Functions, 22.16.1 and 22.16.3",
    r"\operatorname{sn}(u, k) = \sin\operatorname{am}(u, k),\quad "
    r"\frac{d}{du}\operatorname{am}(u, k) = \operatorname{dn}(u, k)",
)

(IMPLICIT_FUNCTION,) = (axiom for axiom in RULES if axiom.name == "implicit function theorem")
"""The same theorem as the judge's rule, where a sentence applies it to functions of its own."""
