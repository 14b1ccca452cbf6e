"""The paper's displays, theorems, tables and figures against the claims that answer them."""

from tresym.ledger.audit.coverage import (
    Audit,
    Entry,
    PieceRow,
    Text,
    Transcription,
    audit,
    entry_of,
    load_index,
)
from tresym.ledger.audit.source import Piece, Source, read_source, scan

__all__ = [
    "Audit",
    "Entry",
    "Piece",
    "PieceRow",
    "Source",
    "Text",
    "Transcription",
    "audit",
    "entry_of",
    "load_index",
    "read_source",
    "scan",
]
