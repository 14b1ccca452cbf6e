r"""Messages of the Language Server Protocol from a client that may send anything.

A message is ``Content-Length: 27``, an empty line, and as many bytes of JSON. The library that
serves the protocol waits for ever behind a wrong length, and reads junk as the end of the input. So
it reads from :class:`ProtocolInput`, which passes on whole and valid messages alone: bytes that are
no message are skipped up to the next header, and a header inside a body says that the length before
it was wrong (within JSON text a line end is written ``\n``, so it cannot stand there otherwise).

Source: Language Server Protocol 3.17, "Base Protocol".
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable

LARGEST = 50_000_000
"""The most bytes of a message; a longer one is skipped."""
_HEADER = re.compile(
    rb"Content-Length:[ \t]*(\d{1,20})[ \t]*\r?\n(?:[!-~]+:[^\r\n]*\r?\n)*\r?\n", re.I
)
_OPENED = re.compile(rb"Content-Length:", re.I)
_LONGEST_HEADER = 4096


class ProtocolInput:
    """A stream for reading whose lines and bytes are those of valid messages.

    Args:
        read: returns some bytes of the client's, none at the end; it may wait.

    Example:
        >>> from tresym.manuscript.protocol_input import ProtocolInput
        >>> parts = iter([b"junk\x00 Content-Length: 2\r\n\r\n{}", b""])
        >>> stream = ProtocolInput(lambda: next(parts))
        >>> stream.readline(), stream.readline(), stream.read(2)
        (b'Content-Length: 2\r\n', b'\r\n', b'{}')
    """

    def __init__(self, read: Callable[[], bytes]) -> None:
        """Store where bytes come from."""
        self._more = read
        self._bytes = b""
        self._lines: list[bytes] = []
        self._body = b""
        self._ended = False

    def readline(self) -> bytes:
        """Return the next line of a header; nothing at the end of the input."""
        if not self._lines:
            body = self._message()
            if body is None:
                return b""
            self._body = body
            self._lines = [b"Content-Length: %d\r\n" % len(body), b"\r\n"]
        return self._lines.pop(0)

    def read(self, count: int) -> bytes:
        """Return the body of the message whose header was read."""
        found, self._body = self._body[:count], self._body[count:]
        return found

    def _message(self) -> bytes | None:
        """Return the body of the next valid message, or None at the end of the input."""
        while True:
            header = _HEADER.search(self._bytes)
            if header is None:
                opened = _OPENED.search(self._bytes)
                keep = opened.start() if opened else max(0, len(self._bytes) - 20)
                self._bytes = self._bytes[keep:][-_LONGEST_HEADER:]
                if not self._fill():
                    return None
                continue
            self._bytes = self._bytes[header.end() :]
            length = int(header[1])
            if length > LARGEST:
                continue
            while (wrong := _HEADER.search(self._bytes[:length])) is None:
                if len(self._bytes) >= length:
                    break
                if not self._fill():
                    return None
            end = wrong.start() if wrong is not None else length
            body = self._bytes[:end]
            if _is_message(body):
                self._bytes = self._bytes[end:]
                return body

    def _fill(self) -> bool:
        """Wait for more bytes, and return whether any came."""
        found = b"" if self._ended else self._more()
        self._ended = not found
        self._bytes += found
        return bool(found)


def _is_message(body: bytes) -> bool:
    try:
        return isinstance(json.loads(body), dict)
    except (ValueError, RecursionError):
        return False
