"""Compare the paper's displays, theorems, tables and figures with the claims about them.

``source`` parses the LaTeX of the paper. ``coverage`` lists the claims that answer each of its
parts, ``transcription`` compares the printed formula with the claim, and ``quotes`` compares
quotations.
"""
