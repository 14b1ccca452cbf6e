"""``tresym paper``: check the displays of a manuscript of your own."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from tresym.commands.claims_file import ENDING
from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_options,
    add_output,
    deliver,
    parse_seconds,
)
from tresym.output import bold, colour_wanted, dim, show_progress
from tresym.reals.notebook import abbreviated
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause

if TYPE_CHECKING:
    from pathlib import Path

    from tresym.manuscript.deciding import Row
    from tresym.manuscript.settings import Settings


def add(commands: Commands) -> None:
    """Add `tresym paper` to the command line."""
    parser = commands.add_parser(
        "paper",
        help="check the displayed formulas of a manuscript",
        description="Read every display of a manuscript's LaTeX and give each equality or "
        "inequality (link) in it a status: PROVED, ENCLOSED, REFUTED, SUSPECT (it "
        "fails as it was read), UNDECIDED, DEFINED, ASSUMED, EQUATION or UNREAD. Comments "
        "such as '% tresym: given a > 0' add information.",
        epilog="Exit status: 1 if a formula is REFUTED, with --suspects also if one is "
        "SUSPECT, with --strict also if one is UNDECIDED or UNREAD; 2 if the file cannot be "
        "read.",
    )
    parser.add_argument(
        "papers",
        nargs="*",
        metavar="MANUSCRIPT.tex",
        help="LaTeX sources (default: the files named in tresym.toml)",
    )
    add_options(
        parser,
        ("--notes FILE", "a file of directives, by display number and hash"),
        ("--html DIR", "write an HTML page with every display and how it was read"),
        ("--claims FILE.tresym", "write the formulas as a file of claims, for you to complete"),
        (
            "--marks FILE",
            "write the marks for the margin to FILE, and tresym.sty to the same folder",
        ),
        ("--all", "show every link; without this option, a long report is shortened to one screen"),
        ("--suspects", "count SUSPECT as a failure"),
    )
    parser.add_argument(
        "--no-suggest",
        dest="suggest",
        action="store_false",
        help="do not search for misprints and for true statements close to them",
    )
    parser.add_argument("--root", metavar="DIR", help="the project's top folder, for \\input")
    parser.add_argument(
        "--strict", action="store_true", help="count SUSPECT, UNDECIDED and UNREAD as failures"
    )
    parser.add_argument("--limit", metavar="SECONDS", help="processor time for each claim (5)")
    parser.add_argument(
        "--format",
        choices=("text", "json", "github", "sarif", "junit"),
        default="text",
        help="the format of the report",
    )
    add_options(
        parser,
        ("--baseline FILE", "a file of known problems: report only new problems"),
        ("--update-baseline", "write the current problems to FILE"),
        ("--no-cache", "do not use cached answers"),
        ("--clear-cache", "delete the cached answers"),
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from pathlib import Path

    from tresym.checking.answer_cache import cached_answers, clear_cache
    from tresym.manuscript.reports import baseline_text, new_since, problems, read_baseline
    from tresym.manuscript.source import NoDisplayError
    from tresym.output import write_text

    if args.clear_cache:
        print(clear_cache(), file=sys.stderr)
        if not args.papers:
            return 0
    papers, settings = _manuscripts(args)
    kind = "json" if args.json else args.format
    baseline = args.baseline or (str(settings.folder / settings.baseline) * bool(settings.baseline))
    if args.update_baseline and not baseline:
        raise InputError("paper: --update-baseline writes the file that --baseline names")
    known = None if args.update_baseline or not baseline else read_baseline(Path(baseline))
    if args.update_baseline and Path(baseline).exists() and not args.force:
        read_baseline(Path(baseline))  # refuses to replace another kind of file
    _check_places(args)
    limit = parse_seconds(args.limit or settings.limit)
    found = []
    lost: InputError | None = None
    with cached_answers(not args.no_cache):
        for paper in papers:
            try:
                rows = _rows(args, paper, settings, limit)
            except InputError as error:
                if len(papers) == 1 or args.update_baseline:
                    raise
                print(f"tresym: {error}", file=sys.stderr)
                lost = lost or (None if isinstance(error, NoDisplayError) else error)
                continue
            found.append((rows, paper))
            if _interrupted(rows):
                _show(args, kind, found, [], False)
                raise KeyboardInterrupt
    marked = [mark for rows, paper in found for mark in problems(rows, paper)]
    if args.update_baseline:
        write_text(baseline, baseline_text(marked))
        print(f"{baseline}: {len(marked)} problems", file=sys.stderr)
        return 0
    new = [row for row, _ in marked] if known is None else new_since(marked, known)
    _show(args, kind, found, new, known is not None)
    bad = {"REFUTED"} | ({"SUSPECT"} if args.suspects else set())
    bad |= {"SUSPECT", "UNDECIDED", "UNREAD"} if args.strict or settings.strict else set()
    if lost is not None or not found:
        return 2
    return UNEXPECTED if any(row.status in bad for row in new) else 0


def _manuscripts(args: argparse.Namespace) -> tuple[list[Path], Settings]:
    """Return the manuscripts of the command line, or else of the settings; and the settings."""
    from pathlib import Path

    from tresym.manuscript.settings import settings_for

    for name in args.papers:
        if name.endswith(ENDING):
            raise InputError(f"paper: to verify a file of claims, use: tresym verify {name}")
    papers = [Path(name) for name in args.papers]
    settings = settings_for(papers[0].parent if papers else Path())
    papers = papers or settings.manuscripts()
    if not papers:
        raise InputError("paper: name a manuscript, or set files in tresym.toml")
    if len(papers) > 1 and (args.notes or args.html or args.marks or args.claims):
        raise InputError("paper: --notes, --html, --claims and --marks are for one manuscript")
    return papers, settings


def _rows(args: argparse.Namespace, paper: Path, settings: Settings, limit: float) -> list[Row]:
    """Return the rows of one manuscript."""
    from pathlib import Path

    from tresym.manuscript.deciding import decided
    from tresym.manuscript.directives import with_notes
    from tresym.manuscript.links import read_links
    from tresym.manuscript.settings import with_settings
    from tresym.manuscript.source import Missing, read_manuscript
    from tresym.manuscript.suspects import proofread

    events = read_manuscript(paper, None if args.root is None else Path(args.root))
    events = with_settings(events, settings)
    if args.notes is not None:
        events = with_notes(events, Path(args.notes))
    for outside, why in ((False, "not found"), (True, "outside the project, see --root")):
        lacking = (e for e in events if isinstance(e, Missing) and not (e.guessed or e.why))
        found = (e.name for e in lacking if e.outside == outside)
        if names := [name[:100] for name in found]:
            print(f"{why}; left out: {', '.join(names[:5])}", file=sys.stderr)
    for broken in [one for one in events if isinstance(one, Missing) and one.why][:5]:
        print(f"{broken.name[:100]}: {broken.why[:200]}", file=sys.stderr)
    for event in events:
        if isinstance(event, Missing) and event.guessed:
            print(
                f"{event.name[:100]}: read as Latin-1, as it is not UTF-8 and declares no "
                "encoding; save it as UTF-8 or add \\usepackage[latin1]{inputenc}",
                file=sys.stderr,
            )
    rows = decided(read_links(events), limit, progress=_counter(), keep=True)
    return proofread(rows) if args.suggest and not _interrupted(rows) else rows


def _interrupted(rows: list[Row]) -> bool:
    return any(row.cause is Cause.INTERRUPTED for row in rows)


def _show(
    args: argparse.Namespace,
    kind: str,
    found: list[tuple[list[Row], Path]],
    new: list[Row],
    compared: bool,
) -> None:
    """Write or print the report; with a baseline, only new problems are included."""
    from tresym.manuscript.reports import PROBLEMS, report

    fresh = {id(row) for row in new}
    text, shown = "", []
    for rows, paper in found:
        kept = [r for r in rows if not compared or r.status not in PROBLEMS or id(r) in fresh]
        shown += [(row, paper) for row in kept]
        if kind == "text":
            colour = colour_wanted() and args.path is None
            text += as_text(kept, colour, paper.name, args.all or args.path is not None)
        elif kind == "json":
            several = len(found) > 1
            for row in kept:
                line = row.as_json()
                line["file"] = line["file"] or (str(paper) if several else None)
                text += json.dumps(line, ensure_ascii=False) + "\n"
    deliver(text if kind in ("text", "json") else report(kind, shown), args.path)
    for rows, paper in found:
        _write_pages(args, paper, rows)
        print(f"{paper}: " * (len(found) > 1) + summary(rows), file=sys.stderr)
    if compared:
        known = sum(row.status in PROBLEMS for rows, _ in found for row in rows) - len(new)
        print(f"{len(new)} new problems, {known} in the baseline", file=sys.stderr)


def _check_places(args: argparse.Namespace) -> None:
    """Check before any work that the page and the marks replace no file of the user's."""
    from pathlib import Path

    from tresym.output import check_replaceable, make_folder

    if args.html is not None:
        make_folder(args.html)
        check_replaceable([str(Path(args.html) / "index.html")], args.force)
    if args.claims is not None:
        if not args.claims.endswith(ENDING):
            raise InputError(
                f"paper: --claims writes a file of claims: name it {args.claims}{ENDING}"
            )
        check_replaceable([args.claims], args.force)
    if args.marks is not None:
        check_replaceable([str(Path(args.marks).with_name("tresym.sty"))], args.force)


def _write_pages(args: argparse.Namespace, paper: Path, rows: list[Row]) -> None:
    """Write the page and the marks if they are requested."""
    from pathlib import Path

    from tresym.manuscript import html
    from tresym.output import write_text

    if args.html is not None:
        write_text(str(Path(args.html) / "index.html"), html.page(rows, paper.name))
    if args.claims is not None:
        from tresym.manuscript.claims_file import claims_text

        write_text(args.claims, claims_text(rows, paper.name))
    if args.marks is not None:
        write_text(args.marks, html.marks(rows))
        write_text(str(Path(args.marks).with_name("tresym.sty")), html.STYLE)


SCREEN = 40
"""The lines of a report that is shown in full; a longer one is summed up."""
MOST_HINTS, MOST_REASONS = 10, 8
"""The lines about links that fail somewhere, and about reasons why links were not read."""


def as_text(rows: list[Row], colour: bool = False, name: str = "", every: bool = True) -> str:
    """Return the report as text: problems first, then the rest, then helpful directives.

    Args:
        colour: whether to use terminal colours.
        name: the name of the manuscript.
        every: whether to show every link; else a long report is one screen: what is wrong, what
            fails somewhere, and why links were not read.
    """
    from tresym.manuscript.suspects import attention

    first = attention(rows)
    rest = [row for row in rows if row not in first and row.status not in _QUIET]
    result = [line for row in first for line in _shown(row, colour, name)]
    full = [line for row in rest for line in _shown(row, colour, name)]
    result += full if every or len(full) <= SCREEN else _summed_up(rest, colour, name)
    for status in _QUIET:
        displays = [row.link.display.number for row in rows if row.status == status]
        if displays:
            links = "1 link" if len(displays) == 1 else f"{len(displays)} links"
            several = "display" if len({*displays}) == 1 else "displays"
            where = f"{links}: {several} {_ranges(displays)}"
            result.append(f"{bold(f'{status:<9}', colour)} {where}")
    return "\n".join(result) + "\n" + "".join(advice(rows))


def _summed_up(rows: list[Row], colour: bool, name: str) -> Iterator[str]:
    """Yield a line for each link that fails somewhere, then for each reason not to decide one."""
    from tresym.manuscript.suspects import failing as failing_somewhere
    from tresym.manuscript.suspects import grouped_by_reason

    failing = failing_somewhere(rows)
    for row in failing[:MOST_HINTS]:
        point = (row.fails_at or {}).items()
        at = ", ".join(f"{symbol} = {value}" for symbol, value in point)
        place = f"{row.link.display.file or name}:{row.link.display.line}"
        yield f"{bold('fails', colour)}     {place}  {abbreviated(row.link.read_as)[:100]}"
        if row.fails_at is None:
            yield f"  {dim('why     ', colour)} {row.why[:100]}"
        else:
            yield f"  {dim('at      ', colour)} {at[:100] or 'the constants themselves'}"
    if len(failing) > MOST_HINTS:
        yield f"          {len(failing) - MOST_HINTS} more fail somewhere (--all shows them)"
    ranked = grouped_by_reason([row for row in rows if row not in failing])
    for (status, reason), found in ranked[:MOST_REASONS]:
        place = f"{found[0].link.display.file or name}:{found[0].link.display.line}"
        links = "1 link" if len(found) == 1 else f"{len(found)} links"
        yield f"{bold(f'{status:<9}', colour)} {links}: {reason}, first at {place}"
    others = sum(len(found) for _, found in ranked[MOST_REASONS:])
    if others:
        yield f"          {others} links for {len(ranked) - MOST_REASONS} other reasons"
    yield "          (--all shows every link)"


_QUIET = ("PROVED", "ENCLOSED", "DEFINED", "ASSUMED")
"""Statuses that need no attention."""


def _shown(row: Row, colour: bool, name: str) -> Iterator[str]:
    """A row with its reason, and what is true instead of it."""
    display = row.link.display
    label = f" ({display.labels[0]})" if display.labels else ""
    which = f"display {display.number}{label}, link {row.link.number}"
    where = f"{display.file or name}:{display.line}"
    yield f"{bold(f'{row.status:<9}', colour)} {where}" + dim(f"  {which}", colour)
    from tresym.manuscript.suspects import printed

    shown = [("printed", printed(row.link)[:200])]
    read_as = row.refuted if row.instead else row.link.read_as
    shown += [("read as", abbreviated(read_as)), ("why", row.why)]
    if row.witness is not None:
        values = ", ".join(f"{name} = {value}" for name, value in row.witness.items())
        shown.append(("witness", values or "the constants themselves"))
    shown += [("instead", str(found)) for found in row.instead]
    yield from (f"  {dim(f'{key:<8}', colour)} {text}" for key, text in shown if text)


def _ranges(numbers: list[int]) -> str:
    """Return numbers in order, with consecutive ones as a range: ``1, 3-5``."""
    parts: list[list[int]] = []
    for n in sorted(set(numbers)):
        if parts and n == parts[-1][-1] + 1:
            parts[-1].append(n)
        else:
            parts.append([n])
    shown = [f"{p[0]}-{p[-1]}" if len(p) > 2 else ", ".join(map(str, p)) for p in parts]
    return ", ".join(shown)


def summary(rows: list[Row]) -> str:
    """Return how many links have which status."""
    from tresym.manuscript.deciding import STATUSES

    counts = Counter(row.status for row in rows)
    displays = len({row.link.display.number for row in rows})
    parts = ", ".join(f"{counts[name]} {name}" for name in STATUSES if counts[name])
    return f"{displays} displays, {len(rows)} links: {parts}"


def advice(rows: list[Row]) -> list[str]:
    """Return the directives that would settle most links, with their displays."""
    found: dict[str, list[int]] = {}
    for row in rows:
        if row.obstacle is not None and row.status in ("EQUATION", "UNREAD", "UNDECIDED"):
            found.setdefault(row.obstacle.value, []).append(row.link.display.number)
    lines = []
    for note, displays in sorted(found.items(), key=lambda item: -len(item[1])):
        shown = ", ".join(map(str, dict.fromkeys(displays[:10])))
        links = "1 link" if len(displays) == 1 else f"{len(displays)} links"
        lines.append(f"{links}: {note} {shown}{', …' if len(displays) > 10 else ''}\n")
    return lines


def _counter() -> Callable[[int, int], None]:
    """Return a function that shows how many links are done, and the remaining time."""
    start = time.monotonic()

    def show(done: int, total: int) -> None:
        left = (time.monotonic() - start) / max(done, 1) * (total - done)
        show_progress(f"{done} of {total} links, {left:.0f} s left")

    return show
