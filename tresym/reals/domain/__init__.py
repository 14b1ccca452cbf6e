"""Conditions, domains of definition, sample points, and evaluation in balls.

``conditions.Given`` holds the conditions of a claim and finds points that satisfy them.
``operation_domains`` is the one table of where each operation is defined, and ``evaluation``
computes an expression in any arithmetic, with NaN where it is not proved to be defined.
"""
