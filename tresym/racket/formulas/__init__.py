"""The paper's formulas, as printed and without cancellation, each written once for any arithmetic.

Every function takes the arithmetic ``m`` last: ``numpy``, ``mpmath.mp``, ``sympy`` or the balls of
:mod:`tresym.reals.numbers.arithmetic`. The modules import none of them.
"""
