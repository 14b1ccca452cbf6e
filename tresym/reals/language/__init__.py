"""Expression trees, and parsers for text, LaTeX and SymPy.

``expression`` defines the trees, ``formula`` relations between them, and ``binders`` the nodes
that bind a variable. ``parsing`` reads the text grammar, ``latex`` reads LaTeX, ``sympy``
converts; ``spelling`` and ``sentences`` translate what people type into the grammar.
"""
