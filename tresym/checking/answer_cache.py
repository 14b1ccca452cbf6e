"""Answers that were found before, in a file of the user's cache folder.

An answer is found again by the text of its claim, conditions and path, and by the version of the
code that decides: a hash of :mod:`tresym` and of the versions of the libraries under it. What was
decided is good for any limit of time; UNDECIDED only for the same one, and what was stopped, failed
or was interrupted is never stored. Rows are JSON, never pickles; :mod:`tresym.checking.kept_rows`
holds the file.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tresym.checking.cache_folder import version
from tresym.checking.kept_rows import Rows, cache_file
from tresym.checking.time_limited import CACHES
from tresym.reals.decisions.answer import Alternative, Answer, Obligation
from tresym.reals.numbers.exact import Decimal, InputError
from tresym.reals.verdict import Cause, Verdict


class AnswerCache:
    """The answers in a file."""

    def __init__(self, path: Path) -> None:
        """Open the file, which is made where it is missing."""
        self.rows = Rows(path)
        self.found = 0
        """How many answers were taken from it."""

    @property
    def reads_only(self) -> bool:
        """Whether the file cannot be written, so that nothing is added to it."""
        return self.rows.reads_only

    def get(self, claim: Any, given: Any, path: str | None, limit: float) -> Answer | None:
        """The answer to a claim, or nothing; or InputError, raised, where it was not read."""
        if not (isinstance(claim, str) and isinstance(given, str)):
            return None
        for key in _keys(claim, given, path, limit):
            text = self.rows.get(key)
            found = _answer(text) if text is not None else None
            if found is not None:
                self.found += 1
                return found
        return None

    def put(self, claim: Any, given: Any, path: str | None, limit: float, answer: Answer) -> None:
        """Keep an answer, unless it depends on the run."""
        if not (isinstance(claim, str) and isinstance(given, str)):
            return
        if answer.cause is not None and answer.cause.of_the_run:
            return
        always, within = _keys(claim, given, path, limit)
        key = within if answer.verdict is Verdict.UNDECIDED else always
        self.rows.put(key, json.dumps(answer.as_json() | {"line": None}))

    def close(self) -> None:
        """Drop what is too much, and close the file."""
        self.rows.close()


def _keys(claim: str, given: str, path: str | None, limit: float) -> tuple[bytes, bytes]:
    """The keys of what holds for any limit, and of what holds for this one."""
    asked = json.dumps([claim, given, path]).encode()
    always = hashlib.sha256(version() + asked)
    within = always.copy()
    within.update(repr(float(limit)).encode())
    return always.digest(), within.digest()


def _answer(text: str) -> Answer | None:
    """The answer of a row, if it can be read."""
    try:
        found = json.loads(text)
        del found["sharp"]  # which follows from the constant
        found["verdict"] = Verdict(found["verdict"])
        found["cause"] = Cause(found["cause"])
        if found["constant"] is not None:
            found["constant"] = Decimal(**found["constant"])
        if found["values"] is not None:
            one, other = found["values"]
            found["values"] = Decimal(**one), Decimal(**other)
        found["instead"] = tuple(Alternative(**one) for one in found["instead"])
        found["obligations"] = tuple(Obligation(**one) for one in found["obligations"])
        return Answer(**found)
    except (ValueError, TypeError, KeyError):
        return None


@contextmanager
def cached_answers(wanted: bool = True) -> Iterator[AnswerCache | None]:
    """Inside, answers are looked up in the user's cache and kept there."""
    path = cache_file() if wanted else None
    if path is None:
        yield None
        return
    opened = AnswerCache(path)
    CACHES.append(opened)
    try:
        yield opened
    finally:
        CACHES.remove(opened)
        opened.close()


def clear_cache() -> str:
    """Remove the file, what SQLite keeps beside it, and compiled lemmas; return a line about it.

    Raises:
        InputError: it cannot be removed.
    """
    path = cache_file()
    if path is None:
        return "there is no cache"
    try:
        for end in ("", "-wal", "-shm"):
            path.with_name(path.name + end).unlink(missing_ok=True)
        if (compiled := path.with_name("coq")).is_dir():
            shutil.rmtree(compiled)
    except OSError as error:
        raise InputError(f"{path}: cannot be removed ({error.strerror})") from None
    return f"{path}: cleared"
