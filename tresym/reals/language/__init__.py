"""Expressions as trees, and how they are read from text, LaTeX and SymPy."""
