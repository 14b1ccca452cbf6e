"""Read the line of a claim with a change, in the place where it stands in its file.

A claim of a paper is a line such as ``d40 (40): u == 2*x given shape using d08``. What the line
means depends on all that stands above it: declarations, abbreviations, conditions with a name,
other claims. It is read again with a change, ``u == 3*x`` say, without reading the rest again::

    line = lines_of(path, others)["d40"]
    false = line.read(line.text.replace("2", "3"))

Instead of a claim that it uses another one may stand, the definition d08 with a change.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tresym.papers.ledger_claims import PartReader
from tresym.papers.reading import clauses_of, labelled, statements_of
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.ledger.claim import Claim


@dataclass(frozen=True)
class Line:
    """The line of a claim, and all that was read above it.

    Attributes:
        label: the label of the claim.
        number: the number of the line.
        name: the label with its place, as it stands before what is said: ``let d08 (8):``.
        text: what is said, with all clauses.
        below: the remarks below it, such as ``> constant: 2``, with their numbers.
    """

    label: str
    number: int
    name: str
    text: str
    below: tuple[tuple[int, str], ...]
    above: PartReader

    @property
    def clause(self) -> str:
        """The pattern of the words that begin a clause."""
        return self.above.clause

    @property
    def clauses(self) -> Mapping[str, str]:
        """The clauses of what is said, by their words."""
        return clauses_of(self.text, self.clause)[1]

    def conditions(self, name: str) -> tuple[Any, ...]:
        """Return the conditions that have a name here; none if it is no such name."""
        return self.above.named.get(name, ())

    def read(
        self,
        text: str | None = None,
        instead: Mapping[str, Claim] | None = None,
        conditions: Mapping[str, tuple[Any, ...]] | None = None,
    ) -> Claim:
        """Return the claim that the line states.

        Args:
            text: what is said; what the file says if None.
            instead: claims that stand in place of those with their labels.
            conditions: conditions in place of those with their names.

        Raises:
            InputError: the line cannot be read. A remark that no longer fits is left out.
        """
        reader = self.above.forked()
        for name, claim in reader.stated.items() if instead else ():
            reader.stated[name] = instead.get(claim.label, claim) if instead else claim
        reader.named |= conditions or {}
        reader.state(self.number, f"{self.name} {self.text if text is None else text}")
        for number, remark in self.below:
            with suppress(InputError):
                reader.state(number, remark)
        return reader.finished(self.label)


def lines_of(path: Path, others: Callable[[str], Mapping[str, Any]]) -> dict[str, Line]:
    """Return the lines of the claims of a file by label, in order.

    Args:
        path: the file.
        others: returns what another part of the paper names.

    Raises:
        InputError: a line that cannot be read.

    Example:
        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Path(folder) / "squares.tresym"
        ...     _ = path.write_text("x := a + b\\nsquare: x**2 >= 0 given a > 0")
        ...     line = lines_of(path, lambda name: {})["square"]
        ...     line.text, line.read("x**2 > 1 given a > 0")
        ('x**2 >= 0 given a > 0', Claim(square: (a + b)**2 > 1))
    """
    written = path.read_text(encoding="utf-8")
    reader = PartReader(path, others, written)
    found: dict[str, Line] = {}
    begun: tuple[int, str, str, PartReader] | None = None
    below: list[tuple[int, str]] = []

    def finish() -> None:
        reader.finish()
        for label, (first, _) in list(reader.lines.items())[-1:]:
            if begun is not None and first == begun[0]:
                found[label] = Line(label, *begun[:3], tuple(below), begun[3])

    for number, text in statements_of(written):
        match = labelled(text)
        if match is not None:
            finish()
            name = text[: match.start(4)].rstrip()
            begun, below = (number, name, match[4], reader.forked()), []
        reader.state(number, text)
        if match is None and reader.reaches(number):
            below.append((number, text))
    finish()
    return found
