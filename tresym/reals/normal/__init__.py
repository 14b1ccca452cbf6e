"""Exact normal form: the difference of equal expressions reduces to 0."""
