"""Hypothesis profiles: dev while writing, ci in every run, deep for long hunts.

All are seeded by the test itself (derandomised), or by the number of the chunk (see chunks.py), so
a failure is the same failure tomorrow.
"""

import os
from pathlib import Path

import chunks
import pytest
from hypothesis import HealthCheck, settings

_COMMON = {
    "deadline": None,
    "derandomize": True,
    "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much],
}
settings.register_profile("dev", max_examples=50, **_COMMON)
settings.register_profile("ci", max_examples=200, **_COMMON)
settings.register_profile(
    "deep", max_examples=1000 if chunks.IN_CHUNKS else 10_000, print_blob=True, **_COMMON
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))


TESTS = Path(__file__).parent
CORE = ("reals", "racket", "ledger")


# First, so that what is marked here can be chosen by ``-m quick``.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for item in items:
        inner = item.path.relative_to(TESTS)
        if inner.parts[0] in CORE and item.get_closest_marker("slow") is None:
            item.add_marker("quick")
    finished = chunks.done()
    if finished:
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid in finished])
        items[:] = [item for item in items if item.nodeid not in finished]


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.when == "call":
        chunks.record(report.nodeid, report.outcome, report.duration)
