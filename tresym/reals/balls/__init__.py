"""Bounds in ball arithmetic: branch and bound, slopes, Taylor enclosures.

``branch_and_bound.decide_bound`` decides an inequality on a product of intervals by subdivision.
On each box the expression is bounded by interval evaluation, by its gradient, or by Taylor's
theorem.
"""
