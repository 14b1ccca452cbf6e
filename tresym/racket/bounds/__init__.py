"""Coordinates in which the margins of the bounds on ε₀ have no singular edge."""
