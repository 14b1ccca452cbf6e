"""Read the entries of the atlas and their stored answers.

A line of ``special.txt`` and the other files is an entry of six fields, divided by ``;;``: its
name, its title, the claim, an edit of the claim that makes it false (a misprint met in practice),
the region on which its bound is asked for, and its source. Example:

    stirling ;; Stirling's formula ;; factorial(n) ~ sqrt(2*pi*n)*(n/E)**n as n -> oo
    ;; 2*pi*n => pi*n ;; n >= 1 ;; DLMF 5.11.7

A claim with O has also a *bound*: the inequality ``abs(left - main terms) <= C*abs(gauge)`` on the
region, in which C is a number. The same inequality with a smaller number is its *floor*, which is
false. What is decided for the four claims is found in ``answers.json``, under their texts: an entry
whose text was changed has no answer until it is decided again.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.resources import files
from shlex import quote
from typing import Any, NamedTuple

from tresym.reals.language.claims import parts_of
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

SUBJECTS = {
    "elementary": "Elementary functions",
    "gamma": "Gamma function, factorials and binomial coefficients",
    "error": "Error functions and normal tails",
    "expint": "Exponential, sine and cosine integrals, incomplete gamma functions",
    "bessel": "Bessel and Airy functions",
    "elliptic": "Elliptic integrals",
    "zeta": "Zeta function and polylogarithms",
    "integrals": "Integrals with a large or small parameter",
    "sums": "Sums and products",
    "recurrences": "Sequences and recurrences",
    "roots": "Roots of equations",
    "odes": "Differential equations",
    "schemes": "Numerical schemes",
    "inequalities": "Inequalities",
}
"""The files of entries, in the order of the pages, with what each is about."""


class Decided(NamedTuple):
    """What was found for a claim, of which only a few words are kept.

    Attributes:
        claim: the claim, in the grammar of text.
        verdict: PROVED, ENCLOSED, REFUTED or UNDECIDED.
        why: what decided, or the lemma.
        constant: bounds of the constant of an order, if the answer has one.
        region: where the claim is certified, if the answer says so.
        witness: for REFUTED, the point, where the claim has no limit process.
        seconds: computing time.
    """

    claim: str
    verdict: Verdict
    why: str = ""
    constant: tuple[str, str] | None = None
    region: str = ""
    witness: str = ""
    seconds: float = 0.0

    @property
    def reason(self) -> str:
        """The verdict, what decided, and the witness."""
        at = f"; it fails at {self.witness}" if self.witness not in self.why else ""
        return f"{self.verdict.value}: {self.why}{at}" if self.why else f"{self.verdict.value}{at}"

    def as_json(self) -> dict[str, Any]:
        """Return the answer for JSON; empty fields are left out."""
        found: dict[str, Any] = {
            "claim": self.claim,
            "verdict": self.verdict.value,
            "why": self.why,
        }
        if self.constant:
            found["constant"] = list(self.constant)
        found |= {"region": self.region, "witness": self.witness}
        return {name: value for name, value in found.items() if value} | {"seconds": self.seconds}


@dataclass(frozen=True)
class Entry:
    """An entry of the atlas.

    Attributes:
        name: the permanent identifier.
        title: what it is called, or says, in a few words.
        subject: the file it stands in.
        claim: the statement, in the grammar of text.
        false: a false statement beside it that is met in practice.
        region: where its bound is asked for; empty for all values.
        source: where it stands.
        answer, neighbour: what was decided for the claim and for the false statement.
        bound, floor: for O, the decided inequality with a constant, and the refuted one with a
            smaller constant.
    """

    name: str
    title: str
    subject: str
    claim: str
    false: str
    region: str
    source: str
    answer: Decided | None = field(default=None, repr=False)
    neighbour: Decided | None = field(default=None, repr=False)
    bound: Decided | None = field(default=None, repr=False)
    floor: Decided | None = field(default=None, repr=False)

    @property
    def constant(self) -> tuple[str, str] | None:
        """The smallest constant of the bound on the region, as an interval from both sides."""
        if self.bound is None or self.floor is None:
            return None
        return number_of(self.floor.claim), number_of(self.bound.claim)

    @property
    def quoted(self) -> tuple[str, str, str] | None:
        """The constant that is worth quoting, as an interval, and the region on which it holds.

        It is that of the bound, else that of the answer if its ends differ by at most a factor 2.
        """
        if self.constant:
            return *self.constant, self.region
        if self.answer is None or self.answer.constant is None:
            return None
        low, high = self.answer.constant
        return (low, high, self.answer.region) if float(high) <= 2 * float(low) else None

    def as_json(self) -> dict[str, Any]:
        """Return the entry for JSON."""
        found: dict[str, Any] = {
            "name": self.name,
            "title": self.title,
            "subject": SUBJECTS[self.subject],
            "claim": self.claim,
            "source": self.source,
            "constant": list(self.quoted[:2]) if self.quoted else None,
            "region": self.quoted[2] if self.quoted else None,
        }
        for part in ("answer", "bound", "floor", "neighbour"):
            decided: Decided | None = getattr(self, part)
            found[part] = None if decided is None else decided.as_json()
        return found

    def __str__(self) -> str:
        lines = [f"{self.name}: {self.title}", f"  {self.claim}"]
        if self.answer:
            lines.append(f"  {self.answer.reason}")
        _, given, path, _ = parts_of(self.claim)
        if given:
            lines.append(f"  conditions {given}")
        if path:
            lines.append(f"  limit      {path}")
        if self.bound and self.floor:
            lines.append(f"  bound      {self.bound.claim} ({self.bound.verdict.value})")
        if self.quoted:
            low, high, region = self.quoted
            at = self.floor.witness if self.floor else ""
            too_small = f"; {low} is too small at {at}" if at else ""
            lines.append(
                f"  constant   between {low} and {high} for {region or 'all values'}{too_small}"
            )
        if self.neighbour:
            lines.append(f"  but not    {self.false}\n             {self.neighbour.reason}")
        lines.append(f"  source     {self.source}")
        lines.append(f"  tresym check {quote(self.claim)}")
        lines.append(f"  tresym explain {quote(self.claim)}")
        return "\n".join(lines)


_NUMBER = re.compile(r"<= \(([\d./]+)\)\*")


def number_of(claim: str) -> str:
    """Return the constant that stands in a bound.

    Example:
        >>> number_of("abs(sin(x) - x) <= (1/6)*abs(x**3)")
        '1/6'
    """
    found = _NUMBER.search(claim)
    return found[1] if found else ""


def remainder(claim: str) -> tuple[str, str] | None:
    """Return the error of a claim with O, and what O compares it with; None without one O.

    Example:
        >>> remainder("erfc(x) == exp(-x**2)/x*(1 + O(1/x**2)) as x -> oo")
        ('erfc(x) - (exp(-x**2)/x*(1))', '(exp(-x**2)/x)*(1/x**2)')
    """
    found = sides(claim)
    if found is None:
        return None
    left, main, gauge = found
    return (f"{left} - ({main})", gauge) if main else (left, gauge)


def sides(claim: str) -> tuple[str, str, str] | None:
    """Return the left side, the terms before O, and what O compares with; None without one O.

    Example:
        >>> sides("sin(x) == x + O(x**3) as x -> 0")
        ('sin(x)', 'x', 'x**3')
    """
    left, sign, right = parts_of(claim)[0].partition(" == ")
    start = right.find("O(")
    if not sign or start < 0 or right.find("O(", start + 1) >= 0:
        return None
    end = _closing(right, start + 1)
    gauge, before, after = right[start + 2 : end], right[:start].rstrip(), right[end + 1 :]
    main = before.removesuffix("+").rstrip()
    if not after.strip():
        return left, main, gauge
    opening = _opening(before)
    factor = before[:opening].rstrip() if opening is not None else ""
    if after.strip() != ")" or not factor.endswith("*") or before.endswith("(") or _is_sum(factor):
        return None
    return left, f"{main})", f"({factor[:-1]})*({gauge})"


def _closing(text: str, start: int) -> int:
    """Return where the bracket that opens at ``start`` is closed."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise InputError("a bracket is not closed")


def _opening(text: str) -> int | None:
    """Return where the last bracket opens that the text does not close; None if there is none."""
    depth = 0
    for place in range(len(text) - 1, -1, -1):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 1:
            return place
    return None


def _is_sum(text: str) -> bool:
    """Whether a plus or minus sign stands outside all brackets."""
    depth, inside = 0, []
    for sign in text:
        depth += {"(": 1, ")": -1}.get(sign, 0)
        inside.append(depth > 0)
    return any(sign in "+-" and not covered for sign, covered in zip(text, inside, strict=True))


def inequality(entry: Entry, constant: str) -> str | None:
    """Return the bound of an entry with a constant; None if its claim has no O, or equations."""
    _, given, _, _ = parts_of(entry.claim)
    found = remainder(entry.claim)
    if found is None or "==" in given:
        return None
    error, gauge = found
    under = ", ".join(part for part in (entry.region, given) if part)
    claim = f"abs({error}) <= ({constant})*abs({gauge})"
    return f"{claim} given {under}" if under else claim


def written() -> Iterator[Entry]:
    """Yield the entries as they are written, without answers.

    Raises:
        InputError: a line has not six fields, its edit does not occur, or a name occurs twice.
    """
    seen: set[str] = set()
    for subject in SUBJECTS:
        text = files("tresym.entries").joinpath(f"{subject}.txt").read_text(encoding="utf-8")
        for line in text.splitlines():
            if not line.strip() or line.startswith("#"):
                continue
            fields = [part.strip() for part in line.split(";;")]
            if len(fields) != 6:
                raise InputError(f"atlas: {line[:60]} has {len(fields)} fields, not 6")
            name, title, claim, edit, region, source = fields
            old, _, new = edit.partition(" => ")
            if name in seen or old not in claim or not new:
                raise InputError(f"atlas: {name} occurs twice, or its edit does not fit")
            seen.add(name)
            false = claim.replace(old, new, 1)
            yield Entry(name, title, subject, claim, false, region, source)


@cache
def answers() -> dict[str, dict[str, Any]]:
    """Return the stored answers by the names of the entries."""
    place = files("tresym.entries").joinpath("answers.json")
    found: dict[str, dict[str, Any]] = json.loads(place.read_text(encoding="utf-8"))
    return found


def decided_of(stored: dict[str, Any] | None, claim: str | None = None) -> Decided | None:
    """Return a stored answer, if it is one to this claim."""
    if stored is None or (claim is not None and stored["claim"] != claim):
        return None
    low_high = stored.get("constant")
    return Decided(
        stored["claim"],
        Verdict(stored["verdict"]),
        stored.get("why", ""),
        (low_high[0], low_high[1]) if low_high else None,
        stored.get("region", ""),
        "" if " as " in stored["claim"] else stored.get("witness", ""),
        stored["seconds"],
    )


@cache
def entries() -> tuple[Entry, ...]:
    """Return the entries whose claim holds and whose neighbour is refuted, with their answers."""
    found = []
    for entry in written():
        stored = answers().get(entry.name, {})
        answer = decided_of(stored.get("answer"), entry.claim)
        neighbour = decided_of(stored.get("neighbour"), entry.false)
        if answer is None or neighbour is None or not answer.verdict.holds:
            continue
        if neighbour.verdict is not Verdict.REFUTED:
            continue
        bound, floor = (decided_of(stored.get(part)) for part in ("bound", "floor"))
        if bound and floor and not _belong(entry, bound, floor):
            bound = floor = None
        found.append(replace(entry, answer=answer, neighbour=neighbour, bound=bound, floor=floor))
    return tuple(found)


def _belong(entry: Entry, bound: Decided, floor: Decided) -> bool:
    """Whether a bound that holds, and one that is refuted, are those of this entry."""
    return (
        bound.verdict.holds
        and floor.verdict is Verdict.REFUTED
        and bound.claim == inequality(entry, number_of(bound.claim))
        and floor.claim == inequality(entry, number_of(floor.claim))
    )
