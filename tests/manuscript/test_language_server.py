"""`tresym lsp` with a client of the protocol: diagnostics, hover, quick fixes."""

import asyncio
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest
from hangs import HANGS
from lsprotocol import types
from pygls.lsp.client import LanguageClient

from tresym.manuscript.language_server import display_lines, quick_fixes

PAPER = r"""\documentclass{article}
\begin{document}
We have the identity
\[ \sin 2x = 3 \sin x\cos x . \]
We have
\begin{equation} (x+1)^2 = x^2 + 2x + 1 \label{a} \end{equation}
\end{document}
"""
RIGHT = PAPER.replace("3 \\sin", "2 \\sin")


class Editor:
    """A client that waits for diagnostics."""

    def __init__(self, uri: str) -> None:
        self.uri, self.version = uri, 0
        self.versions: list[int | None] = []
        self.client = LanguageClient("editor", "1")
        self.found: asyncio.Queue[list[types.Diagnostic]] = asyncio.Queue()

        @self.client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def published(params: types.PublishDiagnosticsParams) -> None:
            self.versions.append(params.version)
            self.found.put_nowait(list(params.diagnostics))

    async def start(self, text: str) -> None:
        await self.client.start_io(sys.executable, "-m", "tresym", "lsp", "--limit", "60")
        await self.client.initialize_async(
            types.InitializeParams(capabilities=types.ClientCapabilities())
        )
        self.client.initialized(types.InitializedParams())
        item = types.TextDocumentItem(self.uri, "latex", 0, text)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))

    async def diagnostics(self) -> list[types.Diagnostic]:
        return await asyncio.wait_for(self.found.get(), HANGS)

    def change(self, text: str) -> None:
        self.version += 1
        document = types.VersionedTextDocumentIdentifier(self.version, self.uri)
        whole = [types.TextDocumentContentChangeWholeDocument(text)]
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(document, whole))

    async def hover(self, line: int) -> str:
        document = types.TextDocumentIdentifier(self.uri)
        params = types.HoverParams(document, types.Position(line, 3))
        found = await asyncio.wait_for(self.client.text_document_hover_async(params), HANGS)
        return "" if found is None else found.contents.value  # type: ignore[union-attr]

    async def fixes(self, line: int) -> dict[str, types.TextEdit]:
        document = types.TextDocumentIdentifier(self.uri)
        place = types.Range(types.Position(line, 0), types.Position(line, 1))
        params = types.CodeActionParams(document, place, types.CodeActionContext([]))
        found = await asyncio.wait_for(self.client.text_document_code_action_async(params), HANGS)
        return {
            action.title: action.edit.changes[self.uri][0]  # type: ignore[union-attr,index]
            for action in found or ()
        }

    async def stop(self) -> None:
        await self.client.shutdown_async(None)
        self.client.exit(None)
        await self.client.stop()


def with_editor(
    tmp_path: Path, text: str, scene: Callable[[Editor], Awaitable[None]], name: str = "m.tex"
) -> None:
    async def play() -> None:
        editor = Editor((tmp_path / name).as_uri())
        try:
            await editor.start(text)
            await scene(editor)
        finally:
            await editor.stop()

    asyncio.run(asyncio.wait_for(play(), HANGS))


def applied(text: str, edit: types.TextEdit) -> str:
    lines = text.split("\n")
    start, end = edit.range.start, edit.range.end
    before = "\n".join([*lines[: start.line], lines[start.line][: start.character]])
    after = "\n".join([lines[end.line][end.character :], *lines[end.line + 1 :]])
    return before + edit.new_text + after


@pytest.mark.slow
def test_a_misprint_is_shown_and_put_right_in_an_editor(tmp_path: Path) -> None:
    async def scene(editor: Editor) -> None:
        (wrong,) = await editor.diagnostics()
        assert (wrong.code, wrong.severity) == ("REFUTED", types.DiagnosticSeverity.Error)
        assert (wrong.range.start.line, wrong.range.end.line) == (3, 3)
        assert "sin(2*x) == 3*sin(x)*cos(x)" in wrong.message
        assert "**PROVED** `(x + 1)**2" in await editor.hover(5)
        hover = await editor.hover(3)
        assert "**REFUTED**" in hover
        assert "x: a real number" in hover
        assert await editor.hover(0) == ""
        fixes = await editor.fixes(3)
        assert {"This is an equation to be solved", "This is a definition"} <= fixes.keys()
        assert "Let x be an operator" in fixes
        (right,) = (edit for title, edit in fixes.items() if title.startswith("Replace by"))
        editor.change(applied(PAPER, right))
        assert await editor.diagnostics() == []
        editor.change(applied(PAPER, fixes["This is an equation to be solved"]))
        assert await editor.diagnostics() == []
        assert editor.versions == [0, 1, 2]

    with_editor(tmp_path, PAPER, scene)


@pytest.mark.slow
def test_only_the_last_of_quick_changes_is_looked_at(tmp_path: Path) -> None:
    async def scene(editor: Editor) -> None:
        for _ in range(20):
            editor.change(PAPER)
        editor.change("\\documentclass{article}\n\\begin{document}\n$$ x")
        (said,) = await editor.diagnostics()
        assert said.severity == types.DiagnosticSeverity.Information
        editor.change(RIGHT)
        assert await editor.diagnostics() == []
        assert editor.found.empty()

    with_editor(tmp_path, PAPER, scene)


ROW = {
    "line": 2,
    "kind": "equation",
    "status": "REFUTED",
    "replacements": ["x = x"],
    "symbols": ["x", "alpha"],
}


def test_labels_and_the_last_sign_stay_when_a_display_is_replaced() -> None:
    text = "a\n\\begin{equation} x = y, \\label{e}\n\\end{equation}\nb"
    assert display_lines(ROW, text) == (1, 2)
    fixes = {action.title: action.edit for action in quick_fixes([ROW], "u", text)}
    edit = fixes["Replace by x = x"].changes["u"][0]  # type: ignore[union-attr,index]
    assert applied(text, edit) == "a\n\\begin{equation} \\label{e} x = x , \\end{equation}\nb"
    assert "Let alpha be an operator" not in fixes


def test_a_display_within_a_line_gets_its_directive_before_it() -> None:
    row = ROW | {"kind": "brackets", "line": 1}
    text = "so \\[ x = y \\]"
    (edit,) = (
        action.edit.changes["u"][0]  # type: ignore[union-attr,index]
        for action in quick_fixes([row], "u", text)
        if action.title == "This is a definition"
    )
    assert applied(text, edit) == "so \n% tresym: define\n\\[ x = y \\]"


def test_a_row_whose_line_is_gone_breaks_nothing() -> None:
    assert display_lines(ROW | {"line": 99}, "one\ntwo") == (1, 1)
    assert quick_fixes([ROW | {"line": 99}], "u", "one\ntwo")


CLAIMS = """# Sines
x, e real; given 0 < e < 1
right: exp(x) >= 1 + x
wrong: sin(e) == e - e**3/5 + O(e**5)
  as e -> 0+
unread: sin(
"""


@pytest.mark.slow
def test_a_file_of_claims_is_put_right_in_an_editor(tmp_path: Path) -> None:
    async def scene(editor: Editor) -> None:
        (unread,) = await editor.diagnostics()  # at once, before any verdict
        assert (unread.code, unread.range.start.line) == ("UNREADABLE", 5)
        for _ in range(2):  # as soon as the claim is decided, and again when all are
            found = await editor.diagnostics()
            assert [(one.code, one.range.start.line) for one in found] == [
                ("UNREADABLE", 5),
                ("REFUTED", 3),
            ]
        fixes = await editor.fixes(3)
        (right,) = (edit for title, edit in fixes.items() if "e**3/6" in title)
        mended = applied(CLAIMS, right).replace("unread: sin(\n", "")
        assert "wrong: sin(e) == e - e**3/6 + O(e**5) as e -> 0+\n" in mended
        editor.change(mended)
        assert await editor.diagnostics() == []

    with_editor(tmp_path, CLAIMS, scene, "own.tresym")
