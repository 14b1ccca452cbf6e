"""Benchmarks: every workload times its contenders in one interleaved run."""
