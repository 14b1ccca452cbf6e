"""Exact normal form: the difference of equal expressions reduces to 0.

``field.Field`` writes an expression as a fraction of polynomials in independent generators:
roots, exponentials, logarithms (``powers``), tangents of half angles (``angles``) and inverse
functions. Factors and their signs (``factors``, ``sign_equations``, ``ranges``) make the form
unique on the domain, so that an identity holds exactly if the numerator of its difference is 0.
"""
