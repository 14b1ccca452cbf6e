"""The ledger: the claims of a paper, their evidence, and the judge of both.

``claim`` defines a claim as a frozen value, ``paper`` loads the claims of ``tresym.proofs``,
``judge`` gives the verdict on one claim by the checker of its kind of evidence (``evidence``),
and ``verification`` judges all claims after those they depend on. ``counterexamples`` then tries
to falsify each pass. The numbers and formulas themselves are decided by :mod:`tresym.reals`.
"""
