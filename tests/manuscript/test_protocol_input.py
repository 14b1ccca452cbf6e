"""`tresym lsp` beside a client that sends anything: it goes on, ends cleanly and obeys signals."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hangs import HANGS

from tresym.manuscript.protocol_input import LARGEST, ProtocolInput

pytest.importorskip("pygls")
ROOT = Path(__file__).parents[2]
GOOD = b'{"jsonrpc": "2.0"}'


def framed(body: bytes, length: int | None = None) -> bytes:
    return b"Content-Length: %d\r\n\r\n%s" % (len(body) if length is None else length, body)


def bodies(*parts: bytes) -> list[bytes]:
    left = iter((*parts, b""))
    stream, found = ProtocolInput(lambda: next(left)), []
    while line := stream.readline():
        assert stream.readline() == b"\r\n"
        found.append(stream.read(int(line.split(b":")[1])))
    return found


@pytest.mark.parametrize(
    "before",
    [
        b"",
        b"\0\0junk\r\n",
        b"Content-Length: x\r\n\r\n",
        b"Content-Length: 99999999999\r\n\r\n{}",
        framed(GOOD, 5),
        framed(GOOD, 400),
        framed(b"[1, 2]"),
        framed(b"\xff\xfe"),
        framed(b"[" * 200_000),
        b"content-length: 3\r\nContent-Type: x\r\n\r\n{x}",
    ],
)
def test_what_is_no_message_is_skipped(before: bytes) -> None:
    found = bodies(before + framed(GOOD), framed(GOOD))
    assert found[-2:] == [GOOD, GOOD]
    assert set(found) == {GOOD}


def test_messages_may_come_in_pieces() -> None:
    text = framed(GOOD) + framed(b'{"a": "Content-Length: 3\\r\\n"}')
    assert len(bodies(*(text[n : n + 1] for n in range(len(text))))) == 2
    assert bodies(b"Content-Length: %d\r\n\r\n" % (LARGEST + 1), framed(GOOD)) == [GOOD]


@pytest.fixture
def server() -> Iterator["subprocess.Popen[bytes]"]:
    command = [sys.executable, "-m", "tresym", "lsp"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment, cwd=ROOT
    ) as process:
        yield process
        process.kill()


def send(process: "subprocess.Popen[bytes]", value: dict[str, Any], before: bytes = b"") -> None:
    assert process.stdin is not None
    process.stdin.write(before + framed(json.dumps({"jsonrpc": "2.0"} | value).encode()))
    process.stdin.flush()


def answer(process: "subprocess.Popen[bytes]", number: int) -> dict[str, Any]:
    assert process.stdout is not None
    while True:
        length = 0
        while (line := process.stdout.readline()) not in (b"\r\n", b""):
            if line.lower().startswith(b"content-length"):
                length = int(line.split(b":")[1])
        value: dict[str, Any] = json.loads(process.stdout.read(length))
        if value.get("id") == number:
            return value


ASKED = {"id": 1, "method": "initialize", "params": {"processId": None, "capabilities": {}}}


@pytest.mark.slow
def test_a_clean_end_has_status_zero_after_junk(server: "subprocess.Popen[bytes]") -> None:
    send(server, ASKED, b"\0junk\r\nContent-Length: 99999999999\r\n\r\n")
    assert "capabilities" in answer(server, 1)["result"]
    send(server, {"method": "initialized", "params": {}})
    send(server, {"id": 2, "method": "shutdown"}, framed(b"{nonsense"))
    assert answer(server, 2)["result"] is None
    send(server, {"method": "exit"})
    assert server.wait(HANGS) == 0


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs signals of POSIX")
def test_a_signal_ends_it_while_the_editor_keeps_the_pipe_open(
    server: "subprocess.Popen[bytes]",
) -> None:
    send(server, ASKED)
    answer(server, 1)
    server.send_signal(signal.SIGTERM)
    assert server.wait(HANGS) == 128 + signal.SIGTERM
