"""Certified values: balls for integrals with singular ends, and for series, at exact points.

The evaluator is the one of :mod:`tresym.reals.domain.binder_values`; the modules here teach it
what balls alone cannot see, the behaviour at an end that is singular or infinite.
"""
