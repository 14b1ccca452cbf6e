"""``tresym mcp``: let an agent or an assistant check formulas, over the Model Context Protocol."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import wraps
from typing import Any

from tresym.commands.parser import Commands, parse_seconds
from tresym.reals.numbers.exact import InputError

LONGEST = 2_000_000
"""Characters of a manuscript that a client may send."""

MOST_CLAIMS = 200
"""Claims that a client may ask at once."""
MOST = 20
"""Entries of the atlas that are returned at once."""

INSTRUCTIONS = """\
tresym decides mathematical statements about real numbers. Verdicts: PROVED (exact procedure),
ENCLOSED (interval arithmetic), REFUTED (with a counterexample, and often a true statement instead),
UNDECIDED (never a pass). Write claims as in Python with == for equality, for example
'exp(x) >= 1 + x', 'sin(x) == x - x**3/6 + O(x**5) as x -> 0', 'integral(x**2, x, 0, 1) == 1/3'."""


def add(commands: Commands) -> None:
    """Add `tresym mcp` to the command line."""
    parser = commands.add_parser(
        "mcp",
        help="a server for agents: check claims and manuscripts over the Model Context Protocol",
        description="A server of the Model Context Protocol on standard input and output, to be "
        "started by an agent or a chat client. Its tools are check, check_many, verify, explain, "
        "table, paper and atlas; they answer with the JSON of the command line. It needs the "
        "extra tresym[mcp].",
    )
    parser.add_argument("--limit", default="5", metavar="SECONDS", help="for each claim (5)")


def run(args: argparse.Namespace) -> int:
    """Serve until the client disconnects, and return the exit status."""
    limit = parse_seconds(args.limit)
    try:
        from mcp.server.mcpserver import MCPServer
    except ImportError:
        raise InputError("mcp: the package mcp is missing: pip install 'tresym[mcp]'") from None
    import tresym

    server = MCPServer("tresym", instructions=INSTRUCTIONS, version=tresym.__version__)
    for tool in _tools(limit):
        server.tool()(_told(tool))
    server.run("stdio")
    return 0


def _told(tool: Callable[..., Any]) -> Callable[..., Any]:
    """Return a tool whose bad input the client sees as an error, with its message."""
    from mcp.server.mcpserver.exceptions import ToolError

    @wraps(tool)
    def answered(*args: Any, **named: Any) -> Any:
        try:
            return tool(*args, **named)
        except InputError as error:
            raise ToolError(str(error)) from None

    return answered


def _tools(limit: float) -> list[Any]:
    """Return the tools as functions, whose names and docstrings the client sees."""

    def check(claim: str, given: str = "", path: str = "") -> dict[str, Any]:
        """Decide a claim: an identity, an inequality, a limit, an order, an integral or a sum.

        Args:
            claim: text such as "exp(x) >= 1 + x", or LaTeX.
            given: conditions, such as "a > 0, 0 < b <= 1, n integer".
            path: for limits and orders, such as "x -> 0+", unless the claim says "as x -> 0+".
        """
        from dataclasses import replace

        from tresym.checking.time_limited import Task, check_within
        from tresym.reals.language.readings import need_variables
        from tresym.reals.verdict import Verdict
        from tresym.repair import suggestions

        need_variables(claim, given, path or None)
        answer = check_within(Task(claim, given, path or None), limit)
        if answer.verdict is Verdict.REFUTED:
            asked = [(answer.read_as, (), False, True)]
            answer = replace(answer, instead=next(suggestions(asked, 1)))
        return answer.as_json()

    def check_many(claims: list[str], given: str = "") -> list[dict[str, Any]]:
        """Decide several claims; what cannot be read has the key "error" in its place.

        Args:
            claims: texts as for check, each with its own conditions and limit process.
            given: conditions of all of them.
        """
        found = []
        for claim in claims[:MOST_CLAIMS]:
            try:
                found.append(check(claim, given))
            except InputError as error:
                found.append({"statement": claim, "error": str(error)})
        return found

    def verify(text: str) -> dict[str, Any]:
        """Verify a file of claims: definitions, conditions and labelled claims, one a line.

        Args:
            text: the text of the file, such as "a real; given a > 0" and "square: a**2 > 0".
        """
        from tresym.papers.reading import read_paper
        from tresym.papers.verification import verify_paper

        if len(text) > LONGEST:
            raise InputError(f"the file has more than {LONGEST} characters")
        return verify_paper(read_paper(text), limit=limit).as_json()

    def explain(claim: str, given: str = "", path: str = "") -> str:
        """Explain the verdict on a claim in Markdown: lemma, steps, constant, counterexample.

        Args:
            claim: the claim, as for check.
            given: its conditions.
            path: the limit process, unless the claim says it.
        """
        from tresym.report.pages.explanation import explain as explained

        return explained(claim, given, path or None, limit).markdown()

    def table(
        exact: str, approx: str, path: str, given: str = "", at: str = "", digits: int = 30
    ) -> dict[str, Any]:
        """Compare an approximation with the exact expression: certified errors and a constant.

        Args:
            exact: the exact expression, such as "2/pi*elliptic_k(m)"; integrals and roots too.
            approx: the approximation, such as "1 + m/4".
            path: where the approximation holds, such as "m -> 0+".
            given: values of parameters, such as "M == 1".
            at: points, such as "1/10, 1/100"; empty for points chosen along the path.
            digits: certified digits of each number.
        """
        import tresym

        points = [point.strip() for point in at.split(",")] if at.strip() else []
        value: dict[str, Any] = tresym.error_table(
            exact, approx, path, points, given, digits
        ).as_json()
        return value

    def paper(latex: str) -> list[dict[str, Any]]:
        """Check the displayed formulas of a LaTeX manuscript, one answer for each relation.

        Args:
            latex: the source, or a part of it with its displays and the text around them.
        """
        from pathlib import Path
        from tempfile import TemporaryDirectory

        from tresym.manuscript.deciding import decided
        from tresym.manuscript.links import read_links
        from tresym.manuscript.source import read_manuscript

        if len(latex) > LONGEST:
            raise InputError(f"the manuscript has more than {LONGEST} characters")
        with TemporaryDirectory() as folder:
            source = Path(folder) / "manuscript.tex"
            source.write_text(latex, encoding="utf-8")
            links = read_links(read_manuscript(source))
            return [row.as_json() for row in decided(links, limit)]

    def atlas(words: str) -> list[dict[str, Any]]:
        """Look up classical expansions and bounds with proved constants.

        Args:
            words: the name of an entry, or words such as "erfc bound", "gamma large", "Mills".
        """
        from tresym.entries.lookup import found
        from tresym.entries.reading import entries

        named = [entry for entry in entries() if entry.name == words.strip()]
        return [entry.as_json() for entry in (named or found(words))[:MOST]]

    return [check, check_many, verify, explain, table, paper, atlas]
