"""Exact numbers and balls: what everything else computes with."""
