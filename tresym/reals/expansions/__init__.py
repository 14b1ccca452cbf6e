"""Expand explicit functions at a point or at infinity: Gruntz's algorithm, remainders certified.

`gruntz` rewrites a function in its most rapidly varying subexpression, `scale` orders these
subexpressions, `expansions` expands in them with enclosed remainders. `leading_terms` and
`limit_values` read limits and orders of growth off the expansions. `laurent` expands at 0 with
rational coefficients.

Source: D. Gruntz, On Computing Limits in a Symbolic Manipulation System, ETH Zürich, 1996.
"""
