"""Flips for arrays of starts and shapes, in floating point."""
