"""Decide asymptotic statements: limits, O, o and ~ along a path, and what holds eventually.

`path_claims` decides limits and what holds eventually, `order_claims` decides O, o and ~; both read
explicit functions off their expansions (`tresym.reals.expansions`). `integral_limits` takes limits
of integrals.
"""
