"""Stand-ins for the search for true claims near refuted ones, which other processes can find."""

from collections.abc import Iterable, Iterator


def alternatives(*_: object) -> tuple[()]:
    """Suggest nothing."""
    return ()


def suggestions(claims: Iterable[object], *_: object) -> Iterator[tuple[()]]:
    """Suggest nothing for each claim."""
    return (() for _ in claims)
