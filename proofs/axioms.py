"""The theorems that the proofs quote, each once; a claim whose evidence applies one names it."""

from tresym.ledger.axioms import RUDIN, RULES, Axiom

DOUBLE_SERIES = Axiom(
    "exchange of double sums",
    "A double series that converges absolutely has one sum in whatever order, so that power series "
    "may be multiplied, and put into each other where their absolute values stay inside.",
    RUDIN + "8.3",
    r"\sum_i \sum_j a_{ij} = \sum_j \sum_i a_{ij}",
)

(IMPLICIT_FUNCTION,) = (axiom for axiom in RULES if axiom.name == "implicit function theorem")
"""The same theorem as the judge's rule, where a sentence applies it to functions of its own."""
