"""`tresym mcp` with a real client of the protocol, over standard input and output."""

import asyncio
import json
import os
import sys
from typing import Any

import pytest

from tresym.commands import main

mcp = pytest.importorskip("mcp")
pytestmark = pytest.mark.slow


def called(*calls: tuple[str, dict[str, Any]]) -> tuple[set[str], list[Any]]:
    """Start a server, and return the names of its tools and the answers to the calls."""

    async def play() -> tuple[set[str], list[Any]]:
        server = mcp.StdioServerParameters(
            command=sys.executable,
            args=["-m", "tresym", "mcp", "--limit", "60"],
            env={**os.environ},
        )
        async with mcp.Client(server) as client:
            tools = {tool.name for tool in (await client.list_tools()).tools}
            answers = []
            for name, arguments in calls:
                found = await client.call_tool(name, arguments)
                text = found.content[0].text if found.content else ""
                if found.is_error:
                    answers.append({"is_error": text})
                elif name == "explain":
                    answers.append(text)
                else:
                    answers.append(found.structured_content or json.loads(text))
            return tools, answers

    return asyncio.run(play())


def test_claims_and_manuscripts_are_answered_as_on_the_command_line() -> None:
    tools, answers = called(
        ("check", {"claim": "exp(x) >= 1 + x"}),
        ("check", {"claim": "sin(2*x) == sin(x)*cos(x)"}),
        ("check", {"claim": "sqrt(x**2) == x", "given": "x > 0"}),
        ("check", {"claim": "((("}),
        ("table", {"exact": "tan(x)", "approx": "x", "path": "x -> 0", "at": "1/10, 1/100"}),
        ("table", {"exact": "1/x", "approx": "x", "path": "nowhere"}),
        ("paper", {"latex": r"For all real $x$: \[ (x+1)^2 = x^2 + 2x + 1. \]"}),
        ("check_many", {"claims": ["exp(x) > 0", "(((", "x > 0"], "given": "x < 1"}),
        ("verify", {"text": "a real; given a > 0\nsquare: a**2 > 0"}),
        ("explain", {"claim": "sin(x) ~ x as x -> 0"}),
    )
    assert tools == {"check", "check_many", "verify", "explain", "table", "paper", "atlas"}
    proved, refuted, conditional, unread, table, no_table, rows, many, paper, why = answers
    assert proved["verdict"] in ("PROVED", "ENCLOSED")
    assert refuted["verdict"] == "REFUTED"
    assert refuted["witness"]
    assert "2*sin(x)*cos(x)" in json.dumps(refuted["instead"])
    assert conditional["verdict"] == "PROVED"
    assert "parenthesis" in unread["is_error"]
    assert [row.get("verdict") for row in many["result"]] == ["PROVED", None, "REFUTED"]
    assert many["result"][1]["error"]
    assert [row["verdict"] for row in paper["claims"]] == ["PROVED"]
    assert "**Verdict.** ENCLOSED" in why
    assert [row["at"] for row in table["rows"]] == [{"x": "1/10"}, {"x": "1/100"}]
    assert table["claim"]["verdict"] == "ENCLOSED"
    assert "write a path like x -> 0+" in no_table["is_error"]
    assert [row["status"] for row in rows["result"]] == ["PROVED"]


def test_a_missing_package_is_named_in_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "mcp.server.mcpserver", None)
    assert main(["mcp"]) == 2
    assert "pip install 'tresym[mcp]'" in capsys.readouterr().err
