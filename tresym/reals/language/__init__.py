"""Expression trees, and parsers for text, LaTeX and SymPy."""
