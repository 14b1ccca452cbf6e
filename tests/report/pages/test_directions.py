"""A number after "more than" or "at most" is rounded to the side that keeps the sentence true."""

import re
from pathlib import Path

import pytest
from flint import arb
from tresym.proofs.page_numbers import named_numbers
from tresym.proofs.tables import rounded_to

from tresym.ledger.paper import file_of
from tresym.reals.numbers.arithmetic import ball_precision

ROOT = Path(__file__).parents[3]
TEMPLATES = sorted(file_of("article").rglob("*.tex"))
PAGES = [*sorted((ROOT / "docs" / "pages").glob("*.md")), ROOT / "README.md"]
UP = ("at most", "less than", "smaller than", "within", "no more than", "fewer than", "up to")
DOWN = ("at least", "more than", "larger than", "greater than", "exceeds", "no less than", "above")
_WORD = re.compile(rf"\b({'|'.join(map(re.escape, (*UP, *DOWN)))})\b", re.IGNORECASE)
_PLACEHOLDER = re.compile(r"\{\{\s*(?:(number|value)\s+)?([\w-]+)((?:\s+\w+)*)\s*\}\}")
_AFTER = re.compile(
    r"^[^.;{]{0,30}?\b(or (?:more|larger|above|less|smaller|fewer|below)|at (?:least|most))\b"
    r"(?! \$?\{\{)"
)
_SIGN = re.compile(r"(<|>|\\leq?|\\geq?|≤|≥)\s*\$?\s*$")
NEAR = 90
"""How many letters after such words a placeholder belongs to them."""


def undirected(text: str) -> list[str]:
    """The numbers after words of inequality that are not rounded to the safe side."""
    flat, found = " ".join(text.split()), []
    for word in _WORD.finditer(flat):
        rest = re.split(r"\.\s|;|\\end", flat[word.end() : word.end() + NEAR])[0]
        for placeholder in _PLACEHOLDER.finditer(rest):
            kind, name, args = placeholder.groups()
            if name == "end" or (kind is None and args):
                continue  # a formula, a verdict, or an exact constant
            wanted = "up" if word[1].lower() in UP else "down"
            if _way(placeholder) != wanted:
                found.append(f"{word[1]} … {placeholder[0]}")
    for placeholder in _PLACEHOLDER.finditer(flat):
        kind, name, args = placeholder.groups()
        if name == "end" or (kind is None and args):
            continue
        after = _AFTER.match(flat[placeholder.end() :])
        sign = _SIGN.search(flat[: placeholder.start()])
        more = ("more", "larger", "above", "least")
        if after and _way(placeholder) != ("down" if after[1].endswith(more) else "up"):
            found.append(f"{placeholder[0]} … {after[1]}")
        if sign and _way(placeholder) != (
            "down" if sign[1] in (">", "≥", r"\ge", r"\geq") else "up"
        ):
            found.append(f"{sign[1]} {placeholder[0]}")
    return found


def _way(placeholder: re.Match[str]) -> str:
    """The direction in which the number of a placeholder is rounded; empty without one."""
    kind, name, args = placeholder.groups()
    return (args.split() or [""])[-1] if kind else name.rpartition("_")[2]


@pytest.mark.parametrize("path", [*TEMPLATES, *PAGES], ids=lambda path: path.name)
def test_numbers_in_inequalities_have_a_direction(path: Path) -> None:
    assert undirected(path.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("misses half a turn by more than {{number floor_misses}} degrees", 1),
        ("misses half a turn by more than {{number floor_misses up}} degrees", 1),
        ("misses half a turn by more than {{number floor_misses down}} degrees", 0),
        ("at most {{value eps0_str_exact 3}}", 1),
        ("at most {{value eps0_str_exact 3 up}}", 0),
        ("Every body has at least {{ floor_degrees }} degrees.", 1),
        ("Every body has at least {{ floor_degrees_down }} degrees.", 0),
        ("larger than $2\\arctan e^{-\\pi} = {{number floor}}$", 1),
        ("is at most one. The value is {{number floor}}", 0),
        ("at most ${{constant one_line 1 percent}}$", 0),
        ("at most that of {{verdict one_line}} the root", 0),
        ("misses half a turn by {{number floor_misses}} degrees or more", 1),
        ("misses half a turn by {{number floor_misses down}} degrees or more", 0),
        ("an error of {{value eps0_str_exact 3}} at most", 1),
        ("an error of {{value eps0_str_exact 3 up}} at most", 0),
        ("it is {{number floor}}. At most one", 0),
        ("$\\epsilon_0 > {{number floor}}$", 1),
        ("$\\epsilon_0 > {{number floor down}}$", 0),
        ("$\\gamma \\ge {{value upper_level_exact 3}}$", 1),
    ],
)
def test_a_missing_direction_is_noticed(text: str, count: int) -> None:
    assert len(undirected(text)) == count


def test_both_sides_are_bounds() -> None:
    with ball_precision(128):
        floor = 2 * (-arb.pi()).exp().atan()
        found = named_numbers()
        assert found["floor_down"] == "0.0863740"
        assert found["floor_up"] == "0.0863741"
        assert arb(found["floor_down"]) < floor < arb(found["floor_up"])
        misses = 360 * floor / arb.pi()
        assert arb(found["floor_misses_down"]) < misses < arb(found["floor_misses_up"])
        assert rounded_to(-misses, 3, "down") == "-9.90"
        assert rounded_to(-misses, 3, "up") == "-9.89"
        assert rounded_to(arb("9.999"), 2, "up") == "10.0"
        assert rounded_to(1000 * misses, 2, "down") == "9800"
