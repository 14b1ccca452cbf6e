"""The audit: which claims answer each display, theorem, table and figure of a paper.

Every line of the running text that contains a formula, or a word about the motion, must also be
answered by claims. Quotations in claims are compared word by word (`tresym.ledger.audit.quotes`).

The index contains, for each piece of the paper, its place and the hash of the text that the claims
were written against, but not the text itself. A piece that was changed, removed or added is
reported.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field
from difflib import SequenceMatcher
from enum import Enum
from pathlib import Path
from typing import Any

from tresym.ledger.audit.quotes import Quote
from tresym.ledger.audit.source import Piece, scan
from tresym.ledger.audit.transcription import Reading, differing, functions_of, unmet
from tresym.ledger.claim import Claim
from tresym.ledger.latex_source import read_source
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_author import Function
from tresym.reals.numbers.exact import InputError


class Text(Enum):
    """Whether a piece of the paper agrees with the text that the claims were written against."""

    SAME = "same"
    ALTERED = "altered"
    MISSING = "missing"
    ADDED = "added"


class Transcription(Enum):
    """Whether the claims state what the display states."""

    EQUAL = "equal"
    """Read from the LaTeX; every relation agrees in ball arithmetic with one of a claim."""
    AS_READ = "equal as read"
    """The same, but with an interpretation that differs from the printed text; see the note."""
    DIFFERS = "differs"
    SENTENCE = "sentence"
    """Not comparable as printed, for the reason in the index; the index transcribes it again."""
    NOT_READ = "not read"
    NOT_A_FORMULA = ""
    """Not a display (a theorem, table, …), or there is no claim or no unaltered text."""


@dataclass(frozen=True)
class Entry:
    """A piece of the paper as listed in the index."""

    kind: str
    label: str
    line: int
    end: int
    sha256: str
    number: int | None = None
    reading: Reading = field(default_factory=Reading)
    answers: tuple[str, ...] = ()
    """For a line of the text: labels of the claims that answer it; all of them must exist."""
    no_claim: str = ""
    """For a line of the text: why it needs no claim."""


@dataclass(frozen=True)
class PieceRow:
    """The finding on one piece; ``line`` is its line in the audited file, if it occurs there."""

    kind: str
    label: str
    number: int | None
    line: int | None
    text: Text
    claims: tuple[str, ...]
    transcription: Transcription
    note: str = ""
    no_claim: str = ""

    @property
    def good(self) -> bool:
        """Whether the piece is unaltered, answered if needed, and not contradicted."""
        bad = (Transcription.DIFFERS, Transcription.NOT_READ)
        answered = bool(self.claims or self.no_claim)
        return self.text is Text.SAME and answered and self.transcription not in bad


@dataclass(frozen=True)
class Audit:
    """The rows of an audit: displays in file order, then theorems, remarks, tables and figures."""

    paper: str
    rows: tuple[PieceRow, ...]

    @property
    def complete(self) -> bool:
        """Whether every piece is unaltered, answered by claims and correctly transcribed."""
        return all(row.good for row in self.rows)

    def count(self, kind: str | None = None) -> tuple[int, int]:
        """Return the numbers of good rows and of all rows.

        Args:
            kind: a kind of piece, or None for the displays.
        """
        chosen = [
            r for r in self.rows if (r.number is not None if kind is None else r.kind == kind)
        ]
        return sum(row.good for row in chosen), len(chosen)

    @property
    def read(self) -> int:
        """The number of displays that were read from the LaTeX itself and agree with a claim."""
        agree = (Transcription.EQUAL, Transcription.AS_READ)
        return sum(row.transcription in agree for row in self.rows)

    @property
    def read_otherwise(self) -> int:
        """The number of these displays that agree only by an interpretation in the index."""
        return sum(row.transcription is Transcription.AS_READ for row in self.rows)

    def as_json(self) -> dict[str, Any]:
        """Return the audit as `tresym audit --json` prints it."""
        rows = [
            {**asdict(row), "text": row.text.value, "transcription": row.transcription.value}
            for row in self.rows
        ]
        return {
            "paper": self.paper,
            "complete": self.complete,
            "read": self.read,
            "read_otherwise": self.read_otherwise,
            "rows": rows,
        }

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of pieces other than displays, in order."""
        return tuple(dict.fromkeys(row.kind for row in self.rows if row.number is None))


def load_words(path: Path) -> tuple[str, ...]:
    """Return the beginnings of words that mark a line as a statement about the motion."""
    return tuple(json.loads(path.read_text(encoding="utf-8")).get("words", ()))


def load_index(path: Path) -> tuple[Entry, ...]:
    """Return the index: displays in order, then other pieces, then lines of the text."""
    data = json.loads(path.read_text(encoding="utf-8"))
    entries = []
    for item in (*data["displays"], *data["others"]):
        reading = Reading(
            item.pop("reads", {}),
            item.pop("functions", {}),
            item.pop("variable", ""),
            item.pop("sentence", ""),
            tuple(item.pop("again", ())),
        )
        entries.append(Entry(**item, reading=reading))
    return (*entries, *map(_line, data.get("text", ())))


def _line(item: dict[str, Any]) -> Entry:
    """Judge a line of the running text: the claims that answer it, or why it needs none."""
    n, answers = item["line"], tuple(item.get("answers", ()))
    why = item.get("no_claim", "")
    return Entry("text", f"line{n}", n, n, item["sha256"], answers=answers, no_claim=why)


def audit(
    paper: Path,
    claims: Iterable[Claim],
    index: Iterable[Entry],
    quotes: Iterable[Quote] = (),
    words: Sequence[str] = (),
) -> Audit:
    """Compare a paper with the index, the claims and their quotations.

    Args:
        paper: the LaTeX source.
        claims: the claims of the ledger.
        index: the pieces listed in the index.
        quotes: quotations in the claims.
        words: beginnings of words; a line of the text with one of them must be answered.

    Raises:
        InputError: the file cannot be read, or is not a well-formed LaTeX document.
    """
    text = read_source(paper)
    source = scan(text, str(paper), words)
    entries = tuple(index)
    answered = _answers(tuple(claims), entries)
    displays = [e for e in entries if e.number is not None]
    lines = [e for e in entries if e.kind == "text"]
    others = [e for e in entries if e.number is None and e.kind != "text"]
    pairs = [
        *_aligned(displays, source.displays),
        *_aligned(others, source.others),
        *_aligned(lines, source.text),
    ]
    functions = functions_of(
        p.text for e, p in pairs if p is not None and p.number and _text(e, p) is Text.SAME
    )
    rows = [_row(e, p, answered, functions) for e, p in pairs]
    rows += [_quoted(quote, text) for quote in quotes]
    return Audit(str(paper), tuple(rows))


def _answers(claims: tuple[Claim, ...], entries: tuple[Entry, ...]) -> dict[str, list[Claim]]:
    """Return the claims that answer each piece, by display number, label or line."""
    found: dict[str, list[Claim]] = {entry.label: [] for entry in entries}
    for claim in claims:
        for entry in entries:
            if _answers_to(claim, entry):
                found[entry.label].append(claim)
    return found


def _answers_to(claim: Claim, entry: Entry) -> bool:
    if claim.label == entry.label or claim.label in entry.answers:
        return True
    if claim.where is None:
        return False
    if claim.where.display is not None:
        return claim.where.display == entry.number
    return claim.where.line is not None and entry.line <= claim.where.line <= entry.end


def _aligned(
    known: Sequence[Entry], pieces: Sequence[Piece]
) -> list[tuple[Entry | None, Piece | None]]:
    """Align entries with pieces, so that one insertion does not shift everything after it."""
    matcher = SequenceMatcher(
        None, [e.sha256 for e in known], [p.sha256 for p in pieces], autojunk=False
    )
    pairs: list[tuple[Entry | None, Piece | None]] = []
    for tag, i, j, k, n in matcher.get_opcodes():
        left: list[Entry | None] = [*known[i:j]]
        right: list[Piece | None] = [*pieces[k:n]]
        if tag != "equal":
            longest = max(len(left), len(right))
            left += [None] * (longest - len(left))
            right += [None] * (longest - len(right))
        pairs.extend(zip(left, right, strict=True))
    return pairs


def _row(
    entry: Entry | None,
    piece: Piece | None,
    answered: dict[str, list[Claim]],
    functions: dict[str, Function],
) -> PieceRow:
    text = _text(entry, piece)
    known = entry or piece
    assert known is not None
    claims = answered.get(known.label, []) if entry else []
    transcription, note = Transcription.NOT_A_FORMULA, ""
    if entry and piece and text is Text.SAME and claims and entry.number is not None:
        transcription, note = _compare(piece.text, claims, functions, entry.reading)
    if text is Text.ALTERED:
        note = "its text is not the one that the claims were written against"
    elif text is Text.ADDED and known.kind == "text":
        note = "no claim answers it: the line is not one that the claims were written against"
    elif text is Text.SAME and entry and (gone := {*entry.answers} - {c.label for c in claims}):
        transcription, note = Transcription.DIFFERS, f"the claim {min(gone)} on it is missing"
    elif not claims and text is Text.SAME:
        note = entry.no_claim if entry and entry.no_claim else "no claim answers it"
    return PieceRow(
        known.kind,
        known.label,
        known.number,
        piece.line if piece else None,
        text,
        tuple(claim.label for claim in claims),
        transcription,
        note,
        entry.no_claim if entry else "",
    )


def _quoted(quote: Quote, paper: str) -> PieceRow:
    line, lost = quote.line_in(paper), quote.lost(paper)
    note = f"“{lost}” of the quote is not there" if lost and line else ""
    return PieceRow(
        "quote",
        quote.label,
        None,
        line,
        Text.SAME if line else Text.ALTERED,
        (quote.label,),
        Transcription.DIFFERS if note else Transcription.NOT_A_FORMULA,
        note if line else "the lines that it was taken from are altered",
    )


def _text(entry: Entry | None, piece: Piece | None) -> Text:
    if piece is None:
        return Text.MISSING
    if entry is None:
        return Text.ADDED
    return Text.SAME if entry.sha256 == piece.sha256 else Text.ALTERED


def _compare(
    text: str, claims: list[Claim], functions: dict[str, Function], reading: Reading
) -> tuple[Transcription, str]:
    try:
        chains = read_latex(text, reading.author(functions))
    except InputError as error:
        return Transcription.NOT_READ, str(error)
    if reading.sentence:
        other = differing(chains, reading.again)
        if other is not None:
            return Transcription.DIFFERS, f"the second transcription does not say {other}"
        return Transcription.SENTENCE, reading.sentence
    left = unmet(chains, claims, functions, reading.reads)
    if left:
        return Transcription.DIFFERS, f"no claim says {left[0]}"
    if reading.functions or (reading.reads and unmet(chains, claims, functions)):
        return Transcription.AS_READ, reading.otherwise
    return Transcription.EQUAL, ""
