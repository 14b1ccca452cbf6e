"""Expression trees, and parsers for text, LaTeX and SymPy.

Reading goes one way, from notation to what a claim states:

=========  ==========================================================================
notation   ``unicode_input`` signs of print; ``sentences`` and ``spelling`` write what
           people type in the strict grammar
tokens     ``latex_tokens``, ``spelling_tokens``; a place in them ``latex_cursor``, ``typed_text``
trees      ``parsing`` of the strict grammar, ``latex_grammar`` of LaTeX, ``sympy``;
           ``operators`` builds integrals, sums and limits for all of them
claims     ``claims`` with conditions and ``paths``; ``comparisons`` what they state
=========  ==========================================================================

``expression`` defines the trees, ``formula`` relations between them, and ``binders`` the nodes
that bind a variable.
"""
