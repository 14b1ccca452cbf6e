"""Bounds and orders in balls: boxes, and expansions with certified remainders."""
