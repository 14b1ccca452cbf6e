"""Claims with known truth, for tests and measurements.

``lists`` reads lists of claims from text files, and ``rewriting`` makes random identities by
exact rules.
"""
