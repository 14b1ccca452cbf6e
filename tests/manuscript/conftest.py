"""Claims of manuscripts are decided in the process of the test, not in one of their own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from typing import Any

import pytest

OWN_PROCESSES = ("test_attempts.py", "test_language_server.py", "test_ci.py", "test_examples.py")
"""Tests in which it matters that a claim has a process of its own."""


class Here:
    """Stands in for :class:`tresym.reals.processes.Processes`: what is asked is done at once."""

    def __init__(self, *_: Any, **__: Any) -> None:
        """Take what the other takes."""

    def __enter__(self) -> Here:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def submit(self, function: Callable[..., Any], *args: Any) -> Future[Any]:
        """Do one piece of work."""
        future: Future[Any] = Future()
        try:
            future.set_result(function(*args))
        except Exception as error:
            future.set_exception(error)
        return future

    def in_order(
        self, function: Callable[..., Any], work: Iterable[tuple[Any, ...]]
    ) -> Iterator[Future[Any]]:
        """Do the work when its result is asked for."""
        return (self.submit(function, *args) for args in work)


@pytest.fixture(scope="module", autouse=True)
def in_this_process(request: pytest.FixtureRequest) -> Iterator[None]:
    """A process for each display takes longer than most decisions."""
    with pytest.MonkeyPatch.context() as patch:
        if request.path.name not in OWN_PROCESSES:
            patch.setattr("tresym.checking.time_limited.Processes", Here)
            patch.setattr("tresym.repair.Processes", Here)
        yield
