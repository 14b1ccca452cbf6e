"""The names of the workloads, in a module of their own so that ``--help`` loads nothing else."""

from __future__ import annotations

WORKLOADS = {
    "separatrix": "ε₀ to 50 digits by findroot on the printed equation and over quad, and by ours",
    "many": "a million ε₀ in float64 by scipy's root finders over arrays and loops, and by ours",
    "turn": "F(ε, γ) to 50 digits, γ from 1e-2 to 1e-30, at 0 and at the turning point",
    "defect": "ε(γ) to 50 digits by findroot over quad and over R_F and R_J, and by ours",
    "flipmap": "the flip of one start among very many, by scipy's and heyoka's solvers and by ours",
    "identities": "deciding identities and false variants by simplify, equals, trigsimp and ours",
    "check": "claims of one's own (antiderivatives, mutants, random identities), and SymPy",
    "waiting": "what one waits for at the shell, whole processes from start to end",
    "precision": "true digits against time, 10 to 1000 digits and float64, in six scenes",
    "honesty": "the error that each method claims, and the error it has",
    "atlas": "digits lost by each printed formula and by its stable form",
    "sweep": "seconds a row of a sweep here, on processes and on Dask; long runs with their memory",
    "scaling": "time against digits, starts (with memory) and claims",
}
"""Each is a module of this package with a ``WORKLOAD`` of :mod:`tresym.bench.run`."""
