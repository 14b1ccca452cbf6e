"""Limits and orders of growth by Gruntz's algorithm, with certified remainders.

`gruntz` rewrites a function in its most rapidly varying subexpression, `scale` orders these
subexpressions, `expansions` expands in them with enclosed remainders. `leading_terms` and
`limit_values` read answers off the expansions; `order_claims` and `path_claims` decide what a user
asks: O, o, ~, limits, and what holds eventually. `laurent` expands at 0 with rational coefficients.

Source: D. Gruntz, On Computing Limits in a Symbolic Manipulation System, ETH Zürich, 1996.
"""
