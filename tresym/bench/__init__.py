"""Benchmarks: each workload times its contenders in one interleaved run and reports ratios."""
