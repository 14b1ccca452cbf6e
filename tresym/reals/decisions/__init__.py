"""Decide claims at points: one decision method for each kind of statement.

A claim that was read becomes a `statement` (`claim_parsing`); `identity` explains the guarantee for
equalities, `inequalities` that for inequalities. Sums, integrals, integers, equations and unknown
functions each have a module that reduces a claim to simpler ones. `tresym.checking.dispatch` knows
the order in which they are asked.
"""
