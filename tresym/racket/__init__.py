"""The freely rotating rigid body of the paper: formulas, motion and flip.

``formulas`` holds each formula of the paper once; it runs in floats, mpmath, balls and SymPy.
``body`` turns moments of inertia into the shape (a, b), ``motion`` integrates the motion, and
``flip`` computes the flip defect: ``flip.model_selection`` picks the cheapest model that delivers
the requested digits.
"""
