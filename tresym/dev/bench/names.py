"""List the workloads, in a module of their own so that ``--help`` loads nothing else."""

from __future__ import annotations

WORKLOADS = {
    "separatrix": "ε₀ to 50 digits: findroot on the printed equation and over quad, and tresym",
    "many": "a million ε₀ in float64: scipy's root finders over arrays and loops, and tresym",
    "turn": "F(ε, γ) to 50 digits, γ from 1e-2 to 1e-30, at 0 and at the turning point",
    "defect": "ε(γ) to 50 digits: findroot over quad and over R_F and R_J, and tresym",
    "flipmap": "the flip of one start among very many: scipy's and heyoka's solvers, and tresym",
    "identities": "deciding identities and false variants: simplify, equals, trigsimp, and tresym",
    "check": "`tresym check` on antiderivatives, false variants and random identities, and SymPy",
    "precision": "correct digits against time, 10 to 1000 digits and float64, in six scenes",
    "honesty": "the error that each method claims, and its true error",
    "atlas": "digits lost by each printed formula and by its stable form",
    "sweep": "seconds per row of a sweep in one process, on processes and on Dask; memory of long "
    "runs",
    "values": "integrals, roots and special functions to 50 digits: quad, findroot, functions of "
    "mpmath, and tresym",
    "deciders": "claims decided within a time, and how many wrongly: SymPy, Maxima, z3, numerical "
    "testing, and tresym",
    "scaling": "time against digits, starts (with memory) and claims",
}
"""What each workload measures, by name."""

MODULES = {name: f"tresym.dev.bench.{name}" for name in WORKLOADS}
"""The module of each workload; it has a ``WORKLOAD`` of :mod:`tresym.dev.bench.run`."""
