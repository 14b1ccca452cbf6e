"""Benchmarks: every workload times its contenders in one interleaved run.

A workload is a module that names its contenders, its scenes and a check of every answer. ``run``
measures them in alternating rounds and keeps medians, ratios and the spread; ``workloads`` saves
the result as JSON in ``docs/measurements``, from which ``report.charts`` draws. ``tresym bench``
is the command.
"""
