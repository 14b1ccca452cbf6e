"""Exact numbers and ball arithmetic, on which everything else is built.

``exact`` turns text into rationals and balls into text. ``arithmetic`` has the four arithmetics
in which a formula runs, and is the only place where the working precision is set. ``factoring``
factors integers and polynomials and multiplies the factors again.
"""
