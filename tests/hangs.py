"""The one clock of the tests: it is there for what hangs."""

HANGS = 3600
"""Seconds after which a process counts as hung, far more than any takes on a loaded machine."""
