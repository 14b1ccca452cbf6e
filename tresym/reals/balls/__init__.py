"""Bounds in ball arithmetic: branch and bound, slopes, Taylor enclosures."""
