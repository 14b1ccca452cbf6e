"""Lists of claims: true ones, and false ones that are nearly true."""

from __future__ import annotations

from importlib.resources import files
from typing import NamedTuple


class Known(NamedTuple):
    """A claim of which it is known whether it is true."""

    truth: bool
    claim: str


class Pair(NamedTuple):
    """An antiderivative and its integrand, as text."""

    antiderivative: str
    integrand: str

    @property
    def claim(self) -> str:
        """That the derivative is the integrand."""
        return f"diff({self.antiderivative}, x) == {self.integrand}"


def pairs() -> list[Pair]:
    """The pairs of antiderivatives.txt."""
    return [Pair(*(side.strip() for side in line.split("|"))) for line in _lines("antiderivatives")]


def known(name: str) -> list[Known]:
    """The claims of inequalities.txt or orders.txt."""
    parts = (line.split(" | ", 1) for line in _lines(name))
    return [Known(truth == "true", claim) for truth, claim in parts]


def _lines(name: str) -> list[str]:
    text = files("tresym.dev.corpus").joinpath(f"{name}.txt").read_text(encoding="utf-8")
    return [line for line in text.splitlines() if line and not line.startswith("#")]
