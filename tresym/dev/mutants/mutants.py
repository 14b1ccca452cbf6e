"""Make false variants of claims, which no evidence may prove, from the lines that state them.

This is mutation testing of the verifier. The line of a claim is changed at one place
(:mod:`tresym.dev.mutants.slips`) and read again where it stands in its file; its evidence is used
as it is written.

- A step inside a derivation ``a == b == c`` is changed where it stands: the claim ``a == c`` may
  still be true, but must not hold by these steps.
- A definition cannot be false. It is changed, and claims that use it are read with the changed
  definition; so are claims that use an assumption, or a root by the equation whose root it is.
- In a claim made of others one of them is changed at a time.
- A claim that is refuted at a point is changed with its point, which must not refute what is true,
  and without it.

Whether a variant is false is another question, which :mod:`tresym.dev.mutants.report` asks: 2 < 3
is a variant of 1 < 3, and true.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

from tresym.dev.mutants.slips import Place as PlaceOfText
from tresym.dev.mutants.slips import Slip, in_turn, slips, without
from tresym.ledger import paper
from tresym.ledger.claim import AllOf, Claim, Definition, Root
from tresym.ledger.evidence.refutation import Denied
from tresym.papers.changed_lines import Line, lines_of
from tresym.reals.numbers.exact import InputError

DEPENDENTS = 3
"""Claims that are judged with a changed definition."""


@dataclass(frozen=True)
class Mutant:
    """A variant of the claim with this label by one change at one place.

    Attributes:
        label: the label of the claim.
        place: where it is changed.
        change: the change in words.
        claim: the changed claim, or one that uses it.
        step: the changed step of a derivation alone; None if the claim itself is changed.
        part: the changed claim of a claim made of others.
    """

    label: str
    place: str
    change: str
    claim: Claim
    step: Claim | None = None
    part: Mutant | None = None


class Place(NamedTuple):
    """A place of a claim, and the variants that differ there; each change may give several."""

    name: str
    mutants: Iterator[tuple[Mutant, ...]]


def places_of(
    claim: Claim,
    dependents: tuple[Claim, ...] = (),
    made: Callable[[Claim], Iterable[tuple[Mutant, ...]]] | None = None,
) -> list[Place]:
    """Return the places of a claim that can be changed; the same ones in every run.

    Args:
        claim: the claim.
        dependents: for a definition, claims that use it.
        made: the false variants of the parts of a claim made of others; all variants if None.
    """
    line = line_of(claim.label)
    if isinstance(claim.proof, AllOf | Denied):
        each = made or (lambda part: in_turn(place.mutants for place in places_of(part)))
        parts = dict.fromkeys(claim.proof.claims)
        return [Place(f"part {p.label}", _with_part(line, p, each(p))) for p in parts]
    if isinstance(claim.proof, Root):
        unique = line_of(claim.proof.unique.label)
        return _of_definition(claim, dependents, unique)
    if isinstance(claim.proof, Definition):
        return _of_definition(claim, dependents, line)
    return [Place(place.name, _changed(claim, line, place)) for place in slips(line)]


def why_few(claim: Claim, dependents: tuple[Claim, ...] = ()) -> str:
    """Return why a claim has fewer false variants than wanted."""
    if isinstance(claim.proof, Definition | Root) and not _asked(dependents):
        return "nothing is proved by this definition directly"
    return "of no other change it is seen that it is false"


def line_of(label: str) -> Line:
    """Return the line of a claim of the paper."""
    of = paper.racket()
    modules = of.modules if of.written_in is None else of.written_in((label,))
    found = (_lines(of, module) for module in modules)
    return next(lines[label] for lines in found if label in lines)


@cache
def _lines(of: paper.Paper, module: str) -> Mapping[str, Line]:
    return lines_of(of.source_of(module), of.named)


def _changed(of: Claim, line: Line, place: PlaceOfText) -> Iterator[tuple[Mutant, ...]]:
    for slip in place.slips:
        try:
            claim = line.read(slip.text, conditions=slip.conditions)
            step = line.read(slip.step) if slip.step else None
        except InputError:
            continue
        if not slip.step and (claim.statement, claim.given) == (of.statement, of.given):
            continue  # another way to write the same
        found = (claim, *_plain(line, slip))
        yield tuple(Mutant(line.label, place.name, slip.says, each, step) for each in found)


def _plain(line: Line, slip: Slip) -> tuple[Claim, ...]:
    """What is said to be refuted at a point, claimed without it."""
    if "expect" not in line.clauses:
        return ()
    try:
        text = without(line, slip.text, "expect", "at", "instead")
        return (line.read(text, conditions=slip.conditions),)
    except InputError:
        return ()


def _with_part(
    line: Line, part: Claim, changed: Iterable[tuple[Mutant, ...]]
) -> Iterator[tuple[Mutant, ...]]:
    """Yield a claim made of others with one of them changed."""
    for mutant, *_ in changed:
        try:
            whole = line.read(instead={part.label: mutant.claim})
        except InputError:
            continue
        yield (Mutant(line.label, f"part {part.label}", mutant.change, whole, part=mutant),)


def _asked(dependents: tuple[Claim, ...]) -> tuple[Claim, ...]:
    """Return claims that prove something about a definition that they use."""
    left_out = AllOf | Denied | Definition | Root
    return tuple(d for d in dependents if not isinstance(d.proof, left_out))[:DEPENDENTS]


def _of_definition(claim: Claim, dependents: tuple[Claim, ...], changed: Line) -> list[Place]:
    """Return the claims that use a definition, as places where its changes show.

    ``changed`` is the line of the definition, or of the claim that names the root.
    """
    return [
        Place(f"in {dependent.label}", _redefined(claim, dependent, changed))
        for dependent in _asked(dependents)
    ]


def _redefined(claim: Claim, dependent: Claim, line: Line) -> Iterator[tuple[Mutant, ...]]:
    sides = [place.slips for place in slips(line) if not place.name.startswith("condition")]
    for slip in in_turn(reversed(sides)):
        try:
            others = {line.label: line.read(slip.text)}
            if line.label != claim.label:
                others[claim.label] = line_of(claim.label).read(instead=others)
            mutant = line_of(dependent.label).read(instead=others)
        except InputError:
            continue
        yield (Mutant(claim.label, f"in {dependent.label}", slip.says, mutant),)
