"""Prove the sign of an expression under conditions, by exact methods.

``sign.sign`` is the entry point. It tries the methods in ``sign.METHODS``, cheapest first: rules
by structure, the normal form, concavity, polynomials on semialgebraic sets, Taylor's theorem.
``definedness`` and ``closure`` show that an argument about interior points reaches the others.
"""
