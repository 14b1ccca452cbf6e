"""Exact numbers and ball arithmetic, on which everything else is built."""
