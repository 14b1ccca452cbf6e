"""A language server for manuscripts: diagnostics, hover and quick fixes in any editor.

It implements the Language Server Protocol (version 3.17) with pygls. After a change and a short
pause the text is checked in a separate process (``editor_rows``), which has loaded its modules
before; a check that is outdated is ended.
"""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import sys
import tempfile
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from lsprotocol import types
from pygls import uris
from pygls.lsp.server import LanguageServer

import tresym
from tresym.checking.kept_rows import cache_file
from tresym.manuscript.protocol_input import ProtocolInput

PAUSE = 0.1
"""Seconds without a change after which the text is checked."""
LONGEST_LINE = 1 << 28
"""Bytes of an answer at most; the last one has all rows of a text."""
_SEVERITY = {
    "REFUTED": types.DiagnosticSeverity.Error,
    "UNREADABLE": types.DiagnosticSeverity.Error,
    "SUSPECT": types.DiagnosticSeverity.Warning,
    "UNDECIDED": types.DiagnosticSeverity.Information,
}
_CLOSING = {"brackets": r"\]", "dollars": "$$"}
_OPENING = {"brackets": r"\[", "dollars": "$$"}
CLAIM = "claim"
"""The kind of the rows of a file of claims, each of which stands on one line."""
_KEPT = re.compile(r"\\label\s*\{[^{}]*\}")


@dataclass
class _Document:
    """An open manuscript with the rows of its last check."""

    text: str = ""
    rows: list[dict[str, Any]] = field(default_factory=list)
    task: asyncio.Task[None] | None = None


class ManuscriptServer(LanguageServer):
    """The server; ``limit`` is the seconds for each claim."""

    def __init__(self, limit: float) -> None:
        super().__init__("tresym", tresym.__version__)
        self.limit = limit
        self.documents: dict[str, _Document] = {}
        self.prepared: asyncio.Task[asyncio.subprocess.Process] | None = None
        self.checks: set[int] = set()
        self.asked_to_end = self.left = False
        self.environment = dict(os.environ)
        if cache_file() is None:  # without a cache, each check would decide everything again
            self.environment["TRESYM_CACHE"] = tempfile.mkdtemp(prefix="tresym")

    def changed(self, uri: str) -> None:
        """Check a manuscript again, after a pause without changes."""
        document = self.documents.setdefault(uri, _Document())
        if document.task is not None:
            document.task.cancel()
        document.task = asyncio.get_running_loop().create_task(self._look(uri, document))

    def closed(self, uri: str) -> None:
        """Forget a manuscript."""
        document = self.documents.pop(uri, None)
        if document is not None and document.task is not None:
            document.task.cancel()
        self._publish(uri, [])

    async def _look(self, uri: str, document: _Document) -> None:
        await asyncio.sleep(PAUSE)
        now = self.workspace.get_text_document(uri)
        text, version = now.source, now.version
        path = uris.to_fs_path(uri) or "manuscript.tex"
        unread: list[dict[str, Any]] = []
        if path.endswith(".tresym"):
            unread = await self._show_unread(uri, path, text, version)
        asked = json.dumps({"path": path, "text": text, "limit": self.limit})
        process = await self._process()
        try:
            document.text, document.rows = text, unread
            found = await self._answer(process, asked, uri, document, version)
        finally:
            self.checks.discard(process.pid)
            if process.returncode is None:
                with suppress(ProcessLookupError):
                    process.kill()
        document.text, document.rows = text, found.get("rows", [])
        diagnostics = self._diagnostics(document)
        if "error" in found:
            diagnostics.append(_at(0, 0, found["error"], types.DiagnosticSeverity.Information))
        self._publish(uri, diagnostics, version)

    async def _answer(
        self,
        process: asyncio.subprocess.Process,
        asked: str,
        uri: str,
        document: _Document,
        version: int | None,
    ) -> dict[str, Any]:
        """Ask a process for the rows of a text, and show the claims that fail as they come."""
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(asked.encode())
        process.stdin.close()
        while line := await process.stdout.readline():
            found: dict[str, Any] = json.loads(line)
            if "row" not in found:
                return found
            document.rows.append(found["row"])
            if found["row"]["status"] in _SEVERITY:
                self._publish(uri, self._diagnostics(document), version)
        return {"error": "the manuscript could not be checked"}

    def _diagnostics(self, document: _Document) -> list[types.Diagnostic]:
        own = [row for row in document.rows if not row["file"]]
        return [self._diagnostic(row, document.text) for row in own if row["status"] in _SEVERITY]

    async def _show_unread(
        self, uri: str, path: str, text: str, version: int | None
    ) -> list[dict[str, Any]]:
        """Show the lines that cannot be read at once, before the claims are decided."""
        from tresym.papers.editor_rows import unread_rows

        file = Path(path)
        rows = await asyncio.to_thread(unread_rows, file.name, text, file.parent)
        if rows:
            self._publish(uri, [self._diagnostic(row, text) for row in rows], version)
        return rows

    async def _process(self) -> asyncio.subprocess.Process:
        """Return a process that waits for a text, and prepare the next one."""
        first = self.prepared or self._begun()
        self.prepared = None
        process = await first
        if process.returncode is not None:  # it was ended while it waited
            process = await self._begun()
        self.prepared = self._begun()
        return process

    def prepare(self) -> None:
        """Start the process that checks the first text."""
        if self.prepared is None:
            self.prepared = self._begun()

    def _begun(self) -> asyncio.Task[asyncio.subprocess.Process]:
        async def begin() -> asyncio.subprocess.Process:
            process = await asyncio.create_subprocess_exec(
                sys.executable,
                *("-m", "tresym.manuscript.editor_rows"),
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.DEVNULL,
                limit=LONGEST_LINE,
                env=self.environment,
            )
            self.checks.add(process.pid)
            return process

        return asyncio.get_running_loop().create_task(begin())

    def end_checks(self) -> None:
        """Kill the processes that check or wait for a text."""
        for pid in self.checks:
            with suppress(OSError):
                os.kill(pid, getattr(signal, "SIGKILL", signal.SIGTERM))

    def _diagnostic(self, row: dict[str, Any], text: str) -> types.Diagnostic:
        first, last = display_lines(row, text)
        found = _at(first, last, said_of(row), _SEVERITY[row["status"]])
        found.code = row["status"]
        return found

    def _publish(
        self, uri: str, diagnostics: list[types.Diagnostic], version: int | None = None
    ) -> None:
        self.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(uri, diagnostics, version=version)
        )

    def rows_at(self, uri: str, line: int) -> list[dict[str, Any]]:
        """Return the rows of the display at a line, from 0, in the text that was checked."""
        document = self.documents.get(uri)
        if document is None:
            return []
        found = []
        for row in document.rows:
            first, last = display_lines(row, document.text)
            if not row["file"] and first <= line <= last:
                found.append(row)
        return found


def _at(
    first: int, last: int, message: str, severity: types.DiagnosticSeverity
) -> types.Diagnostic:
    """Return a diagnostic for whole lines."""
    span = types.Range(types.Position(first, 0), types.Position(last, 10_000))
    return types.Diagnostic(span, message, severity=severity, source="tresym")


def display_lines(row: dict[str, Any], text: str) -> tuple[int, int]:
    """Return the first and the last line of a row's display, from 0."""
    lines = text.split("\n")
    first = min(max(row["line"] - 1, 0), len(lines) - 1)
    kind = row["kind"]
    if kind == CLAIM:
        return first, first
    end = _CLOSING.get(kind, f"\\end{{{kind}}}")
    opening = _OPENING.get(kind, "")
    for n in range(first, min(first + 200, len(lines))):
        line = lines[n]
        if n == first and opening:
            line = line.partition(opening)[2]
        if end in line:
            return first, n
    return first, first


def said_of(row: dict[str, Any]) -> str:
    """Return the message on a row, in a few lines."""
    parts = [f"{row['read_as'] or row['latex']}: {row['why']}"]
    if row["witness"]:
        values = ", ".join(f"{name} = {value}" for name, value in row["witness"].items())
        parts.append(f"It fails at {values}.")
    parts += [f"True instead: {one['claim']} ({one['edit']})" for one in row["instead"][:1]]
    return "\n".join(parts)


def hover_text(rows: list[dict[str, Any]]) -> str:
    """Return how a display was read, with the status of each link, in Markdown."""
    parts = []
    for row in rows:
        read = row["read_as"] or row["latex"]
        parts.append(f"**{row['status']}** `{read}`\n\n{row['why']}")
        if row["witness"]:
            values = ", ".join(f"`{name} = {value}`" for name, value in row["witness"].items())
            parts.append(f"fails at {values}")
    kinds = dict.fromkeys(kind for row in rows for kind in row["kinds"])
    parts += [", ".join(kinds)] if kinds else []
    return "\n\n".join(parts)


def quick_fixes(rows: list[dict[str, Any]], uri: str, text: str) -> list[types.CodeAction]:
    """Return the quick fixes for a display that is refuted, suspect or undecided."""
    found: list[types.CodeAction] = []
    for row in rows:
        if row["status"] not in _SEVERITY:
            continue
        if row["kind"] == CLAIM:
            found += _claim_fixes(row, uri, text)
            continue
        first, _ = display_lines(row, text)
        for latex in row["replacements"]:
            edit = _replaced(row, text, latex)
            if edit is not None:
                found.append(_action(f"Replace by {latex}", uri, edit))
        notes = {"This is an equation to be solved": "solve", "This is a definition": "define"}
        notes |= {
            f"Let {name} be an operator": f"let {name} operator"
            for name in row["symbols"]
            if len(name) == 1
        }
        for title, note in notes.items():
            found.append(_action(title, uri, _inserted(text, first, note)))
    return list({action.title: action for action in found}.values())


def _claim_fixes(row: dict[str, Any], uri: str, text: str) -> list[types.CodeAction]:
    """Return for a refuted claim of a file the claims that hold instead; the clauses stay."""
    lines = text.split("\n")
    first = min(max(row["line"] - 1, 0), len(lines) - 1)
    match = re.match(r"[^:]*:(?!=)\s*", lines[first])
    last = first
    while last + 1 < len(lines) and lines[last + 1][:1] in (" ", "\t") and lines[last + 1].strip():
        last += 1
    if match is None:
        return []
    written = " ".join([lines[first][match.end() :], *map(str.strip, lines[first + 1 : last + 1])])
    clauses = re.search(r"\s(?:as|on|at)\s.*$", re.sub(r"\sexpect\s+refuted\b", "", written))
    start, end = types.Position(first, match.end()), types.Position(last, 10_000)
    found = []
    for one in row["instead"]:
        given = f" given {one['given']}" if one["given"] else ""
        path = "" if " as " in one["claim"] or clauses is None else clauses[0].rstrip()
        path = re.sub(r"\sgiven\s.*?(?=\s(?:as|on|at)\s|$)", "", path)
        edit = types.TextEdit(types.Range(start, end), f"{one['claim']}{given}{path}")
        found.append(_action(f"Replace by {one['claim']}{given}", uri, edit))
    return found


def _action(title: str, uri: str, edit: types.TextEdit) -> types.CodeAction:
    return types.CodeAction(
        title,
        kind=types.CodeActionKind.QuickFix,
        edit=types.WorkspaceEdit(changes={uri: [edit]}),
    )


def _inserted(text: str, line: int, note: str) -> types.TextEdit:
    """A directive on a line of its own before a display, or before it within its line."""
    before = text.split("\n")[line]
    opening = re.search(r"\\\[|\$\$|\\begin", before)
    column = opening.start() if opening else 0
    place = types.Position(line, len(before[:column].encode("utf-16-le")) // 2)
    own = "" if not before[:column].strip() else "\n"
    return types.TextEdit(types.Range(place, place), f"{own}% tresym: {note}\n")


def _replaced(row: dict[str, Any], text: str, latex: str) -> types.TextEdit | None:
    """The display with another formula; its labels and its last sign stay."""
    first, last = display_lines(row, text)
    lines = text.split("\n")
    kind = row["kind"]
    opening = _OPENING.get(kind, f"\\begin{{{kind}}}")
    closing = _CLOSING.get(kind, f"\\end{{{kind}}}")
    block = "\n".join(lines[first : last + 1])
    start = block.find(opening)
    stop = block.find(closing, start + len(opening))
    if start < 0 or stop < 0:
        return None
    start += len(opening)
    body = block[start:stop]
    labels = "".join(f" {label}" for label in _KEPT.findall(body))
    sign = re.search(r"[.,;]\s*$", _KEPT.sub("", body))
    new = f"{labels} {latex}{f' {sign[0].strip()}' if sign else ''} "
    span = types.Range(_position(block, start, first), _position(block, stop, first))
    return types.TextEdit(span, new)


def _position(block: str, at: int, first: int) -> types.Position:
    before = block[:at]
    line = before.rpartition("\n")[2]
    return types.Position(first + before.count("\n"), len(line.encode("utf-16-le")) // 2)


def serve(limit: float) -> int:
    """Serve on standard input and output until the editor leaves, and return the exit status.

    A signal ends the server at once, also while it waits for the editor.
    """
    made = server(limit)

    def end(number: int, _: object) -> None:
        made.end_checks()
        os._exit(128 + number)

    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), end)
    source = ProtocolInput(lambda: os.read(0, 1 << 16))
    with open(os.dup(1), "wb") as target, suppress(ValueError):  # the library closes its stream
        made.start_io(source, target)
    made.end_checks()
    return 1 if made.left and not made.asked_to_end else 0


def server(limit: float) -> ManuscriptServer:
    """The server with its features."""
    made = ManuscriptServer(limit)

    @made.feature(types.INITIALIZED)
    async def initialized(ls: ManuscriptServer, _: types.InitializedParams) -> None:
        ls.prepare()

    @made.feature(types.SHUTDOWN)
    def ends(ls: ManuscriptServer, _: None) -> None:
        ls.asked_to_end = True

    @made.feature(types.EXIT)
    def leaves(ls: ManuscriptServer, _: None) -> None:
        ls.left = True

    @made.feature(types.TEXT_DOCUMENT_DID_OPEN)
    async def opened(ls: ManuscriptServer, params: types.DidOpenTextDocumentParams) -> None:
        ls.changed(params.text_document.uri)

    @made.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    async def changed(ls: ManuscriptServer, params: types.DidChangeTextDocumentParams) -> None:
        ls.changed(params.text_document.uri)

    @made.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    async def closed(ls: ManuscriptServer, params: types.DidCloseTextDocumentParams) -> None:
        ls.closed(params.text_document.uri)

    @made.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(ls: ManuscriptServer, params: types.HoverParams) -> types.Hover | None:
        rows = ls.rows_at(params.text_document.uri, params.position.line)
        if not rows:
            return None
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, hover_text(rows)))

    @made.feature(types.TEXT_DOCUMENT_CODE_ACTION)
    async def fixes(ls: ManuscriptServer, params: types.CodeActionParams) -> list[types.CodeAction]:
        uri = params.text_document.uri
        text = ls.workspace.get_text_document(uri).source
        known = ls.documents.get(uri)
        if known is None or known.text != text:  # the lines are those of another text
            return []
        return quick_fixes(ls.rows_at(uri, params.range.start.line), uri, text)

    return made
