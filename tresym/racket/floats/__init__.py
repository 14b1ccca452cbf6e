"""Flips of arrays of starts and shapes, in floating point."""
