"""Drive coqtop: send text sentence by sentence, and stop at the first error."""

from __future__ import annotations

import os
import re
import select
import signal
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from shutil import rmtree

from tresym.checking.cache_folder import cache_folder
from tresym.reals.resource_limits import processor_time

SENTENCE_SECONDS = 4
TEXT_SECONDS = 20.0
HEAD = """Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Tresym.
Open Scope R_scope.
"""
_DONE = "Check (fun v_done : Prop => v_done)."
_SENTENCE = re.compile(r".*?\.(?=\s|$)", re.DOTALL)
_BRACES = re.compile(r"^(?:[\s{}]|\d+ *:)+")
_LEMMA = re.compile(r"^\s*(?:Lemma|Theorem|Corollary)\s+([\w']+)", re.MULTILINE)


@cache
def prelude() -> str:
    """Return the text of ``Tresym.v``."""
    return files("tresym.coq").joinpath("Tresym.v").read_text(encoding="utf-8")


@cache
def library(lemmas: str = "") -> tuple[str, ...]:
    """Return the options with which Coq finds ``Tresym.v`` and ``lemmas`` (as ``Racket.v``)."""
    found: tuple[str, ...] = ()
    for name, text in (("Tresym.v", prelude()), ("Racket.v", lemmas)):
        found = (*found, "-Q", str(_compiled(name, text, found)), "")
    return found


@cache
def axioms(lemmas: str = "") -> str:
    """Return what ``Print Assumptions`` says of all lemmas of the library, asked once for each."""
    options = library(lemmas)
    kept = Path(options[-2], "axioms.txt")
    with suppress(OSError):
        return kept.read_text(encoding="utf-8")
    names = _LEMMA.findall(f"{prelude()}\n{lemmas}")
    whole = ", ".join(f"@{name}" for name in names)
    text = f"{HEAD}Require Import Racket.\nDefinition all := ({whole}).\n"
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "all.v").write_text(text + "Print Assumptions all.\n", encoding="utf-8")
        command = ["coqc", "-q", *options, "all.v"]
        done = subprocess.run(
            command, cwd=folder, capture_output=True, text=True, check=True, timeout=1800
        )
    with suppress(OSError):
        kept.write_text(done.stdout, encoding="utf-8")
    return done.stdout


def declares(script: str) -> bool:
    """Return whether a script has a sentence that is no tactic, so that it could assume something.

    Tactics begin with a small letter, ``Axiom``, ``Admitted`` and all other commands do not.
    """
    begins = (_BRACES.sub("", sentence) for sentence in re.split(r"\.(?=[\s{}]|$)", script))
    return any(not sentence[:1].islower() for sentence in begins if sentence)


_KEPT: list[tempfile.TemporaryDirectory[str]] = []
"""Folders of this process, for where there is no cache."""


def _compiled(name: str, text: str, options: tuple[str, ...]) -> Path:
    """Return the folder with a compiled file, which the user's cache keeps: it takes long."""
    key = sha256("\0".join((version(), *options, text)).encode()).hexdigest()[:20]
    try:
        kept = Path(cache_folder() or os.devnull, "coq", key)
        kept.parent.mkdir(parents=True, exist_ok=True)
        made = None if kept.is_dir() else Path(tempfile.mkdtemp(dir=kept.parent))
    except OSError:
        _KEPT.append(tempfile.TemporaryDirectory())
        return _compile(name, text, options, Path(_KEPT[-1].name))
    if made is not None:
        try:
            _compile(name, text, options, made)
            with suppress(OSError):  # another process was quicker
                made.rename(kept)
        finally:
            rmtree(made, ignore_errors=True)
    return kept


def _compile(name: str, text: str, options: tuple[str, ...], folder: Path) -> Path:
    (folder / name).write_text(text, encoding="utf-8")
    command = ["coqc", "-q", *options, "-Q", ".", "", name]
    subprocess.run(command, cwd=folder, capture_output=True, check=True, timeout=1800)
    return folder


@cache
def version() -> str:
    """Return the version of the installed Coq."""
    done = subprocess.run(["coqc", "--version"], capture_output=True, text=True, check=True)
    match = re.search(r"version (\S+)", done.stdout)
    return match[1] if match else "?"


class Dialogue:
    """A coqtop process that has loaded ``Tresym.v`` and lemmas; it is restarted if it hangs."""

    def __init__(self, patience: int = SENTENCE_SECONDS, lemmas: str = "") -> None:
        self.patience = patience
        self.lemmas = lemmas
        self.process: subprocess.Popen[bytes] | None = None
        self.count = 0
        self.folder = tempfile.TemporaryDirectory()  # for the cache files of its arithmetic

    def __enter__(self) -> Dialogue:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()
        self.folder.cleanup()

    def end(self) -> None:
        """End the process."""
        if self.process is not None:
            self.process.kill()
            self.process.communicate()
        self.process = None

    def begin(self) -> None:
        """Start the process if it is not running."""
        if self.process is None:
            self.process = subprocess.Popen(
                ["coqtop", "-q", *library(self.lemmas)],
                cwd=self.folder.name,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            )
            self.said(HEAD + "Require Import Racket.\nSet Silent.\n", 120)

    def holds(self, sentence: str) -> bool:
        """Return whether Coq accepts the sentence; an error leaves its state unchanged."""
        answer = None if self.process is None else self.said(sentence, self.patience)
        if answer is None:
            self.end()
        return answer is not None and "Error:" not in answer

    def goal(self, body: str) -> str:
        """Return the sentence that begins the proof of a statement, under a name of its own."""
        self.count += 1
        return f"Theorem v_{self.count} :\n{body}."

    def proved(self, body: str) -> bool:
        """Return whether the last goal is a theorem now, and says this."""
        return self.holds(f"Check (v_{self.count} :\n{body}).")

    def accepts(self, text: str, seconds: float) -> bool:
        """Return whether Coq accepts the text without an error; its definitions remain in force.

        Args:
            text: sentences of Coq.
            seconds: CPU seconds for the whole text.
        """
        self.begin()
        assert self.process is not None
        begun = _worked(self.process.pid)
        for sentence in _SENTENCE.findall(text):
            if _worked(self.process.pid) - begun > seconds:
                self.said("Abort All.", 60)
                return False
            answer = self.said(sentence, self.patience)
            if answer is None:
                self.end()
                return False
            if "Error:" in answer:
                self.said("Abort All.", 60)
                return False
        return True

    def said(self, sentence: str, seconds: float) -> str | None:
        """Send a sentence and return Coq's answer; None if it hangs.

        Args:
            sentence: one sentence.
            seconds: CPU seconds after which Coq is interrupted; the answer then counts as an error.
        """
        assert self.process is not None
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(f"{sentence}\n{_DONE}\n".encode())
        self.process.stdin.flush()
        begun, start, found = _worked(self.process.pid), time.monotonic(), b""
        interrupted = False
        while b"v_done : Prop =>" not in found:
            ready, _, _ = select.select([self.process.stdout], [], [], 0.2)
            if ready:
                piece = os.read(self.process.stdout.fileno(), 65536)
                if not piece:
                    return None
                found += piece
                continue
            worked = _worked(self.process.pid) - begun
            if worked > 2 * seconds or time.monotonic() - start > 20 * seconds:
                return None
            if worked > seconds and not interrupted:
                self.process.send_signal(signal.SIGINT)
                interrupted = True
        return found.decode(errors="replace") + ("Error:" if interrupted else "")


def _worked(process: int) -> float:
    """Return the CPU seconds that a process has used; wall time where that cannot be asked for."""
    worked = processor_time(process)
    return time.monotonic() if worked is None else worked


def accepted(texts: Sequence[str]) -> list[bool]:
    """Return for each text whether Coq accepts it."""
    with Dialogue() as coq:
        return [coq.accepts(text, TEXT_SECONDS) for text in texts]
