"""The names of the workloads; a file of its own, as ``tresym --help`` shall load nothing else."""

from __future__ import annotations

WORKLOADS = {
    "separatrix": "ε₀ to 50 digits: findroot on the printed equation and over quad, and ours",
    "many": "a million ε₀ in float64: scipy's root finders over arrays and in a loop, and ours",
    "turn": "F(ε, γ) to 50 digits, γ from 1e-2 to 1e-30, at 0 and at the turning point",
    "defect": "ε(γ) to 50 digits: findroot over quad and over R_F and R_J, and ours",
    "flipmap": "the flip of very many starts: scipy's and heyoka's ODE solvers, and ours",
    "identities": "deciding identities and false variants: simplify, equals, trigsimp, and ours",
    "check": "claims of one's own: antiderivatives, mutants and random identities, and SymPy",
    "ledger": "a verdict on every claim, in a new process and in a warm one",
    "startup": "tresym flip from the shell",
    "precision": "true digits against time, 10 to 1000 digits and float64, in six scenes",
    "honesty": "the error that each method claims, and the error it has",
    "atlas": "digits lost by each printed formula and by its stable form",
    "sweep": "rows of a sweep: here, on processes, on Dask; long runs with their memory",
    "scaling": "time against digits, starts (with memory) and claims",
    "economy": "the rung of each table cell and figure panel, its cost, and the next one's",
}
"""Each is a module of this package with a function ``measure(keep)``."""
