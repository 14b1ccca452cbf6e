"""Documents, figures and charts generated from the ledger and from computations.

``typesetting`` writes formulas, conditions and findings as text or LaTeX. ``figures`` and
``charts`` draw, and ``pages`` builds the documents in ``docs/generated``; ``pages.documents`` is
the entry point of ``tresym docs``.
"""
