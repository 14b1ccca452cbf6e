"""Conditions, domains of definition, sample points, and evaluation in balls."""
