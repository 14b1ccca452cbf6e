"""A paper: its claims, and what its documents need beside them.

A :class:`Paper` is a value that is given to :func:`tresym.ledger.verification.verify`. A package of
claims has one under the name ``PAPER``; everything but its name and its claims is optional. The
paper on the racket is taken where no other is given.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from tresym.ledger.claim import Claim
from tresym.reals.numbers.exact import InputError

QUOTED = re.compile("“([^”]*)”")
RACKET = "tresym.proofs"
"""The package of the paper on the racket."""
Parts = tuple[tuple[str, tuple[Claim, ...]], ...]
"""The parts of a paper in order: a title and the claims of each."""


class Correction(NamedTuple):
    """A printed statement that does not hold; listed once, however often it is printed."""

    title: str
    quote: str
    """A short quotation from the paper."""
    labels: tuple[str, ...]
    """The refuted claims that state it; the first one is the main one."""
    why: str = ""
    """Why it does not hold, if the note of the main claim does not say so."""


class Notation(NamedTuple):
    """How the symbols of a paper are written.

    Attributes:
        latex: the LaTeX of a symbol whose name does not say it, by its name.
        words: what a symbol is, in words, by its name; ``words_of_proofs`` are those that only
            proofs use.
        first: names of symbols whose functions stand first in a product.
    """

    latex: Mapping[str, str] = {}
    words: Mapping[str, str] = {}
    words_of_proofs: Mapping[str, str] = {}
    first: tuple[str, ...] = ()


def _nothing() -> Any:
    return {}


def _no_notation() -> Notation:
    return Notation()


def _no_corrections() -> tuple[Correction, ...]:
    return ()


@dataclass(frozen=True)
class Paper:
    """A paper whose claims are values of Python.

    The optional parts are functions, so that they are loaded when they are needed.

    Attributes:
        name: the name of its package, or any other.
        parts: returns the parts, or only those of the modules of these names.
        modules: the names of the modules of its claims, in order.
        written_in: returns the modules that contain one of these labels; all unless given.
        folder: where its index, its titles and its stored proofs are.
        corrections: the printed statements that do not hold, the most important ones first.
        notation: how its symbols are written.
        figures: a module with ``FIGURES``, ``picture`` and ``printed``.
        tables: a module with ``TABLES``, ``table`` and ``written``.
        numbers: the numbers that its documents quote by name.
        programs: the functions that are evaluated by programs of their own.
        coq_files: further files of Coq, by name.
        enclosed: for Coq, two decimals between which the root of a shape lies.
        named: returns what a module of it names, by name, or another that its files use.
        derivations: its main formulas derived by another system: for each a title and steps, which
            have a name in LaTeX, a result, and how it is found, in words.
    """

    name: str
    parts: Callable[..., Parts]
    modules: tuple[str, ...] = ()
    written_in: Callable[[Iterable[str]], tuple[str, ...]] | None = None
    folder: Path | None = None
    corrections: Callable[[], tuple[Correction, ...]] = _no_corrections
    notation: Callable[[], Notation] = _no_notation
    figures: Callable[[], Any] = _nothing
    tables: Callable[[], Any] = _nothing
    numbers: Callable[[], dict[str, str]] = _nothing
    programs: Callable[[], Mapping[str, Any]] = _nothing
    coq_files: Callable[[], Mapping[str, str]] = _nothing
    enclosed: Callable[..., tuple[str, str]] | None = None
    named: Callable[[str], Mapping[str, Any]] = lambda module: {}
    derivations: Callable[[], Iterable[tuple[str, Iterable[Any]]]] = tuple

    def all_claims(self, labels: Iterable[str] = ()) -> tuple[Claim, ...]:
        """Return the claims, each after the claims that it depends on.

        Args:
            labels: if given, only the modules that contain these claims and their dependencies are
                loaded. If empty, or if a label is not found, all modules are.
        """
        asked = set(labels)
        if asked and self.written_in is not None:
            found = _each_after_its_own(_claims(self.parts(self.written_in(asked))))
            if found and asked <= {claim.label for claim in found}:
                return found
        return _each_after_its_own(_claims(self.parts()))

    def sections(self) -> Parts:
        """Return the parts in order: a title and the claims of each."""
        return self.parts()

    def quotes(self, claims: Iterable[Claim]) -> dict[str, str]:
        """Return the passages of the paper that claims and corrections quote, by label."""
        own = {claim.label: " ".join(QUOTED.findall(claim.paper_says)) for claim in claims}
        by_label = {c.labels[0]: c.quote for c in self.corrections()}
        return by_label | {k: v for k, v in own.items() if v}

    def file_of(self, name: str) -> Path:
        """Return the path of a file in the folder of the paper.

        Raises:
            InputError: the paper has no folder.
        """
        if self.folder is None:
            raise InputError(f"{self.name}: this paper has no folder for {name}")
        return self.folder / name

    def source_of(self, module: str) -> Path:
        """Return the path of the file in which the claims of a module are written."""
        path = self.file_of(f"{module}.tresym")
        return path if path.is_file() else self.file_of(f"{module}.py")

    @cached_property
    def index(self) -> dict[str, Any]:
        """The displays, theorems, tables, figures and sections of the paper's source."""
        empty: dict[str, Any] = {"displays": [], "others": [], "sections": []}
        if self.folder is None or not self.file_of("index.json").is_file():
            return empty
        found: dict[str, Any] = json.loads(self.file_of("index.json").read_text(encoding="utf-8"))
        return found

    @cached_property
    def titles(self) -> Mapping[str, str]:
        """The titles of claims by label, from ``titles.txt`` in the folder."""
        return self._pairs("titles.txt")

    @cached_property
    def aliases(self) -> Mapping[str, str]:
        """The readable names of claims by label, from ``aliases.txt`` in the folder."""
        return self._pairs("aliases.txt")

    @cached_property
    def labels_by_alias(self) -> Mapping[str, str]:
        """The labels of claims by their readable names."""
        return {alias: label for label, alias in self.aliases.items()}

    def label_of(self, name: str) -> str:
        """Return the label of the claim with this readable name; a label is returned unchanged."""
        return self.labels_by_alias.get(name, name)

    def name_of(self, label: str) -> str:
        """Return the readable name of the claim with this label; the label if it has none."""
        return self.aliases.get(label, label)

    def _pairs(self, name: str) -> Mapping[str, str]:
        """Return the lines ``key: value`` of a file in the folder; nothing if there is no file."""
        if self.folder is None or not self.file_of(name).is_file():
            return {}
        lines = self.file_of(name).read_text(encoding="utf-8").splitlines()
        return dict(line.split(": ", 1) for line in lines if line and not line.startswith("#"))

    @cached_property
    def written(self) -> Notation:
        """The notation, loaded once."""
        return self.notation()


def _claims(parts: Parts) -> tuple[Claim, ...]:
    return tuple(claim for _, stated in parts for claim in stated)


def _each_after_its_own(claims: Iterable[Claim]) -> tuple[Claim, ...]:
    order: dict[Claim, None] = {}
    for claim in claims:
        order.update(dict.fromkeys((*claim.rests_on, claim)))
    return tuple(order)


def racket() -> Paper:
    """Return the paper on the racket."""
    found: Paper = import_module(RACKET).PAPER
    return found


def all_claims(labels: Iterable[str] = ()) -> tuple[Claim, ...]:
    """Return the claims of the paper on the racket, see :meth:`Paper.all_claims`."""
    return racket().all_claims(labels)


def sections() -> Parts:
    """Return the parts of the paper on the racket: a title and the claims of each."""
    return racket().sections()


def corrections() -> tuple[Correction, ...]:
    """Return the statements printed in the paper on the racket that do not hold."""
    return racket().corrections()


def quotes(claims: Iterable[Claim]) -> dict[str, str]:
    """Return the passages of the paper on the racket that claims and corrections quote."""
    return racket().quotes(claims)


def file_of(name: str) -> Path:
    """Return the path of a file in the folder of the paper on the racket."""
    return racket().file_of(name)


def index() -> dict[str, Any]:
    """Return the index of the paper on the racket."""
    return racket().index


def display_lines() -> dict[int | None, int]:
    """Return the line of the paper's source on which each display begins, by display number."""
    return {display["number"]: display["line"] for display in index()["displays"]}
