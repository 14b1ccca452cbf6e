"""Errors planted in manuscripts: how many of them ``tresym paper`` tells.

``python tests/planted_errors.py FILE.tex ...`` changes one place of one display at a time (a sign,
a coefficient, an exponent, a factor, a function or an inequality), checks the displays around it
again, and prints what became of the link: told (REFUTED or SUSPECT), listed (it fails somewhere),
silent, or kept (still PROVED or ENCLOSED: to be read by hand, since some changes change nothing).
``--in judged`` plants in links that pass, ``asymptotic`` in those of them that state an asymptotic
behaviour, ``anywhere`` in any link. The seed determines what is planted.
"""

from __future__ import annotations

import argparse
import random
import re
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tresym import repair
from tresym.checking.answer_cache import cached_answers
from tresym.manuscript import suspects
from tresym.manuscript.classification import Link
from tresym.manuscript.deciding import PASSES, Row, decided
from tresym.manuscript.links import read_links
from tresym.manuscript.source import Display, Event, read_manuscript
from tresym.manuscript.suspects import attention, failing, proofread

LIMIT = 2.0
NEAR = 2
"""The displays before and behind a planted error that are decided again."""
_TOKEN = re.compile(
    r"\\(?:label|text\w*|mathrm|operatorname|begin|end|tag|ref|eqref|mbox|intertext|qq)\*?\s*"
    r"\{[^{}]*\}|\\\\(?:\[[^]]*\])?|\\[a-zA-Z]+|\\.|\d+\.\d+|\d+|\s+|."
)
_SWAPPED = {
    **{"<": ">", ">": "<", "\\le": "\\ge", "\\leq": "\\geq", "\\ge": "\\le", "\\geq": "\\leq"},
    **{"\\sin": "\\cos", "\\cos": "\\sin", "\\sinh": "\\cosh", "\\cosh": "\\sinh"},
}
_ASYMPTOTIC = re.compile(
    r"\\(?:sim|simeq|approx|asymp|[cl]?dots)(?![a-zA-Z])|(?:O|\{O\})\s*(?:\\left)?\s*\("
)


class Planted(NamedTuple):
    """A display with an error: the kind of the change, what was changed, and the new text."""

    kind: str
    change: str
    text: str


def errors_in(text: str) -> Iterator[Planted]:
    """Yield the display with each possible error, in order."""
    tokens = _TOKEN.findall(text)

    def changed(n: int, kind: str, new: str) -> Planted:
        around = "".join(tokens[max(n - 4, 0) : n + 5]).strip()
        return Planted(
            kind, f"{tokens[n]} -> {new} in {around}", "".join((*tokens[:n], new, *tokens[n + 1 :]))
        )

    for n, token in enumerate(tokens):
        before = next((t for t in reversed(tokens[:n]) if not t.isspace()), "")
        behind = next((t for t in tokens[n + 1 :] if not t.isspace()), "")
        group = before == "{" and "".join(tokens[:n]).rstrip()[-2:-1]
        if token in ("+", "-"):
            binary = before not in ("", "=", "(", "{", "&", "^", "_", "[", "\\left", "\\pm")
            if binary and behind not in ("\\dots", "\\ldots", "\\cdots"):
                yield changed(n, "sign", "-" if token == "+" else "+")
            elif token == "-" and not binary:
                yield changed(n, "sign", " ")
        elif token.isdigit() and token != "0":
            if before == "^" or (group == "^" and behind == "}"):
                yield changed(n, "exponent", str(int(token) + 1))
            elif before != "_" and group != "_":
                yield changed(n, "coefficient", str(int(token) + 1))
        elif token in _SWAPPED:
            yield changed(n, "relation" if token[-1] in "<>eq" else "function", _SWAPPED[token])
        elif re.fullmatch(
            r"[a-zA-Z]|\\(?:frac|sin|cos|exp|sqrt|ln|log|alpha|epsilon|pi)", token
        ) and before in ("=", "+", "-", "&"):
            yield changed(n, "factor", f"2{token}")


def links_of(events: Sequence[Event], n: int, text: str) -> tuple[list[Event], list[Link]]:
    """Return the manuscript with another text of a display, and the links around it."""
    shown = events[n]
    assert isinstance(shown, Display)
    changed = [*events[:n], replace(shown, text=text), *events[n + 1 :]]
    near = (shown.number - NEAR, shown.number + NEAR)
    links = [x for x in read_links(changed) if near[0] <= x.display.number <= near[1]]
    return changed, links


def settled(link: Link, undecided: dict[tuple[int, int], Row]) -> Link:
    """Return a link of another display without its claims, if they took long and led to nothing."""
    row = undecided.get((link.display.number, link.number))
    if row is None or row.fails_at is not None:
        return link
    return replace(link, claims=(), otherwise=(row.status, row.why))


def rows_of(links: Sequence[Link]) -> list[Row]:
    """Return the links with their statuses."""
    return proofread(decided(links, LIMIT, 1), 5.0, 1)


def explained(row: Row, others: Sequence[Row]) -> str:
    """Return what speaks against an accusation, for developers."""
    link = row.link
    parts = [
        f"firm={link.firm} same={link.same} unknown={link.unknown} refuted={row.refuted[:150]!r}"
    ]
    if link.sides is not None:
        left, _, right = link.sides
        alone, constants = suspects._stands_alone(left, right), suspects._has_constants(left, right)
        parts.append(f"alone={alone} constants={constants}")
    parts.append(f"introduced={suspects.is_introduced(link)} may_be={suspects.may_be(row)}")
    parts.append("doubts=" + "; ".join(d.text for d in link.ground.doubts))
    parts.append("lead=" + suspects._words(suspects.prose.last_sentence(link.around[0]))[-160:])
    parts.append("trail=" + suspects._words(suspects.prose.first_sentence(link.around[1]))[:80])
    return "\n        ".join(" ".join(x.split()) for x in parts)


class Here:
    """Stands in for a pool of processes: a search for repairs is done at once, in this process."""

    def __init__(self, *_: object, **__: object) -> None:
        """Take what a pool takes."""

    def __enter__(self) -> Here:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def in_order(
        self, function: Callable[..., object], work: Iterable[tuple[object, ...]]
    ) -> Iterator[Future[object]]:
        """Do the work when its result is asked for."""
        for args in work:
            future: Future[object] = Future()
            future.set_result(function(*args))
            yield future


class Outcome(NamedTuple):
    """What became of a planted error."""

    file: str
    line: int
    planted: Planted
    shown: str
    outcome: str
    status: str
    why: str
    explained: str


def outcomes(file: Path, wanted: str, seed: str, most: int, each: int = 1) -> Iterator[Outcome]:
    """Plant errors in a file, and yield what became of each.

    Args:
        wanted: judged, asymptotic or anywhere.
        most: the largest number of links in which an error is planted.
        each: how many errors are planted in one link.
    """
    events = read_manuscript(file)
    rows = proofread(decided(read_links(events), LIMIT, 1), 5.0, 1)
    told_before = {(r.link.display.number, r.link.number) for r in attention(rows)}
    listed_before = {(r.link.display.number, r.link.number) for r in failing(rows)}
    chosen = [
        row
        for row in rows
        if wanted == "anywhere"
        or (row.status in PASSES and (wanted != "asymptotic" or _ASYMPTOTIC.search(row.link.shown)))
    ]
    undecided = {
        (one.link.display.number, one.link.number): one for one in rows if one.status == "UNDECIDED"
    }
    r = random.Random(f"{seed} {file.name}")
    r.shuffle(chosen)
    done = 0
    for row in chosen:
        if done >= most:
            return
        number = row.link.display.number
        n = next(k for k, e in enumerate(events) if isinstance(e, Display) and e.number == number)
        old = [(one.link.shown) for one in rows if one.link.display.number == number]
        tried = [*errors_in(events[n].text)]
        r.shuffle(tried)
        count = 0
        for planted in tried:
            if count >= each:
                break
            _, links = links_of(events, n, planted.text)
            own = [x for x in links if x.display.number == number]
            if len(own) != len(old):
                continue
            at = next((k for k, x in enumerate(own) if x.number == row.link.number), None)
            if at is None or own[at].shown == row.link.shown:
                continue
            found = rows_of(
                [x if x.display.number == number else settled(x, undecided) for x in links]
            )
            mine = [one for one in found if one.link.display.number == number]
            keys = lambda some: {  # noqa: E731
                (one.link.display.number, one.link.number) for one in some
            }
            told, listed = (
                keys(attention(found)) - told_before,
                keys(failing(found)) - listed_before,
            )
            touched = {(number, x.number) for x, o in zip(own, old, strict=True) if x.shown != o}
            status = mine[at].status
            if told & touched:
                outcome = "told"
            elif told:
                outcome = "told near"
            elif listed & touched:
                outcome = "listed"
            elif listed:
                outcome = "listed near"
            else:
                outcome = "kept" if status in PASSES else "silent"
            count += 1
            yield Outcome(
                file.name,
                row.link.display.line,
                planted,
                own[at].shown,
                outcome,
                status,
                mine[at].why,
                explained(mine[at], mine),
            )
        done += count > 0


def main(arguments: Sequence[str]) -> None:
    """Plant errors in files, and print what became of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--in", dest="wanted", default="judged")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--most", type=int, default=5, help="links for each file")
    parser.add_argument("--each", type=int, default=1, help="errors for each link")
    parser.add_argument("--explain", action="store_true", help="say what speaks against telling")
    asked = parser.parse_args(arguments)
    counts: Counter[str] = Counter()
    kinds: Counter[tuple[str, str]] = Counter()
    repair.Processes = Here  # type: ignore[misc,assignment]
    with cached_answers():
        for name in asked.files:
            for one in outcomes(Path(name), asked.wanted, asked.seed, asked.most, asked.each):
                counts[one.outcome] += 1
                kinds[one.planted.kind, one.outcome] += 1
                if one.outcome not in ("told", "told near"):
                    what = f"{one.planted.kind}: {one.planted.change}"
                    print(f"{one.outcome:7} {one.status:9} {one.file}:{one.line}  {what}")
                    print(f"        {one.shown[:160]}\n        {one.why[:200]}", flush=True)
                    if asked.explain:
                        print(f"        {one.explained}", flush=True)
    print(dict(counts), "of", counts.total())
    for kind in sorted({k for k, _ in kinds}):
        print(
            f"  {kind}: "
            + ", ".join(f"{n} {o}" for (k, o), n in sorted(kinds.items()) if k == kind)
        )


if __name__ == "__main__":
    main(sys.argv[1:])
