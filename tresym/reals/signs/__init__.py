"""Prove the sign of an expression under conditions, by exact methods."""
