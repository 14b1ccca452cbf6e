"""Bounds in balls: boxes cut in halves, slopes, and Taylor's theorem on intervals."""
