"""The statuses of a manuscript as a page, and as marks for its own margin."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from html import escape
from itertools import groupby

from tresym.ledger.latex_source import DISPLAYS
from tresym.manuscript.deciding import STATUSES, Row
from tresym.manuscript.kinds_in_prose import REAL
from tresym.manuscript.printed import as_mathml
from tresym.manuscript.source import Display
from tresym.manuscript.suspects import attention, failing, grouped_by_reason, printed
from tresym.reals.language.parsing import parse_claim
from tresym.reals.language.typesetting import to_mathml
from tresym.reals.numbers.exact import InputError

_WORST = (
    "REFUTED",
    "SUSPECT",
    "UNREAD",
    "UNDECIDED",
    "EQUATION",
    "ASSUMED",
    "ENCLOSED",
    "PROVED",
    "DEFINED",
)
_STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem;
  color: #222; overflow-wrap: break-word }
section { border-left: 4px solid #bbb; margin: 1.5rem 0; padding: 0 1rem }
section.REFUTED, section.SUSPECT { border-color: #c00 }
section.PROVED, section.ENCLOSED { border-color: #080 }
section.UNDECIDED, section.UNREAD { border-color: #c80 }
h1 { font-size: 1.6rem } h2 { font-size: 1rem; margin: 0 } .why { color: #555 }
.status { font-weight: 600 } .REFUTED > .status, .SUSPECT > .status { color: #b00 }
#attention { background: #fff4f0; padding: .5rem 1rem } #attention h2 { font-size: 1.1rem }
ul { padding-left: 1.2rem } li { margin: .5rem 0; overflow-x: auto }
section > ul { list-style: none; padding: 0 }
.formula, .wide { overflow-x: auto; padding: .4rem 0 } pre { margin: 0; font-size: .85rem }
table { border-collapse: collapse } td, th { padding: .1rem .6rem .1rem 0; text-align: left;
  vertical-align: top }
math { font-size: 1.15em } code { overflow-wrap: anywhere; font-size: .85em }
merror { background: none; border: 0; color: #777; font-size: .8em } summary { cursor: pointer }
"""
_MEANING = (
    "A link is one relation of a display: <code>a = b = c</code> has two links, "
    "<code>a = b</code> and <code>b = c</code>."
)
MOST_PLACES = 12
"""The most places that are named for a symbol or a reason."""


def page(rows: Sequence[Row], name: str) -> str:
    """Return an HTML page: what to look at, why links were not decided, every display in order, as
    its author wrote it, with the status of its links, and the kinds of the symbols."""
    counts = Counter(row.status for row in rows)
    summary = ", ".join(f"{counts[s]} {s}" for s in STATUSES if counts[s])
    title = escape(name)
    number = len({row.link.display.number for row in rows})
    body = "\n".join((*_attention(rows, name), *_reasons(rows), *_sections(rows)))
    return (
        f'<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n{MARK}\n'
        f"<title>{title}</title>\n"
        f'<meta name="viewport" content="width=device-width">\n<style>{_STYLE}</style>\n'
        f"<h1>{title}</h1>\n<p>{number} displays, {len(rows)} links: {summary}</p>\n"
        f'<p class="why">{_MEANING}</p>\n{body}\n{_symbols(rows)}\n</html>\n'
    )


def _symbols(rows: Sequence[Row]) -> str:
    """Return the table of symbols with their kinds and the evidence for these."""
    found: dict[tuple[str, str, str], list[int]] = {}
    for row in rows:
        for known in row.link.symbols:
            places = found.setdefault(known, [])
            if row.link.display.number not in places:
                places.append(row.link.display.number)
    plain = dict.fromkeys(name for name, kind, words in sorted(found) if kind == REAL and not words)
    told = sorted(known for known in found if known[1] != REAL or known[2])
    lines = [
        f"<tr><td>{escape(name)}</td><td>{escape(kind)}</td><td>{escape(words)}</td>"
        f"<td>{_places(found[name, kind, words])}</td></tr>"
        for name, kind, words in told
    ]
    table = (
        '<div class="wide"><table>\n'
        "<tr><th>symbol</th><th>kind</th><th>evidence</th><th>displays</th></tr>\n"
        + "\n".join(lines)
        + "\n</table></div>\n"
    )
    names = escape(", ".join(plain)) or "none"
    return (
        "<details>\n<summary>Kinds of symbols</summary>\n"
        f"<p>Taken to be real numbers by default: {names}.</p>\n"
        f"{table if lines else ''}</details>"
    )


def _places(numbers: Sequence[int]) -> str:
    """Return links to displays, the first few if there are many."""
    shown = [f'<a href="#display-{n}">{n}</a>' for n in dict.fromkeys(numbers)]
    more = len(shown) - MOST_PLACES
    return ", ".join(shown[:MOST_PLACES]) + (f" and {more} more" if more > 0 else "")


def _reasons(rows: Sequence[Row]) -> Iterator[str]:
    """Yield the reasons why links were not read or not decided, the most common first."""
    found = grouped_by_reason(rows)
    if not found:
        return
    number = sum(len(same) for _, same in found)
    what = "1 link is" if number == 1 else f"{number} links are"
    yield "<details open>\n"
    yield f"<summary>Why {what} not decided</summary>\n"
    yield '<div class="wide"><table>\n<tr><th>links</th><th>reason</th><th>displays</th></tr>'
    for (status, reason), same in found:
        places = _places([row.link.display.number for row in same])
        yield (f"<tr><td>{len(same)}</td><td>{status}: {escape(reason)}</td><td>{places}</td></tr>")
    yield "</table></div>\n</details>"


def _sections(rows: Sequence[Row]) -> Iterator[str]:
    """Yield a section for each display: as it is printed, then its links."""
    for number, links in groupby(rows, key=lambda row: row.link.display.number):
        found = list(links)
        display = found[0].link.display
        label = f" ({', '.join(display.labels)})" if display.labels else ""
        file = f"{display.file}, " if display.file else ""
        heading = f"Display {number}{label}, {file}line {display.line}"
        yield (
            f'<section class="{worst(found)}" id="display-{number}">\n<h2>{escape(heading)}</h2>\n'
            f'<div class="formula">{_as_printed(display)}</div>\n<ul>\n'
            + "\n".join(map(_link, found))
            + "\n</ul>\n</section>"
        )


def _as_printed(display: Display) -> str:
    """Return a display as its author wrote it, typeset if it can be, else its source."""
    return as_mathml(display) or f"<pre>{escape(display.text.strip())}</pre>"


def _attention(rows: Sequence[Row], name: str) -> Iterator[str]:
    """Yield the section of what to look at, which comes first: accusations, then what fails."""
    accused, failed = attention(rows), failing(rows)
    if not accused and not failed:
        return
    yield f'<section id="attention" class="{"REFUTED" if accused else "UNDECIDED"}">'
    if accused:
        yield f"<h2>Formulas to look at: {len(accused)}</h2>\n<ul>"
        for row in accused:
            text = f'<li class="{row.status}">{_place(row, name)} '
            text += f'<span class="status">{row.status}</span>'
            line = replace(row.link.display, text=printed(row.link))
            text += f'<div class="formula">{_as_printed(line)}</div>'
            text += f"Read as <code>{escape(row.refuted or row.link.read_as)}</code>"
            yield text + _findings(row) + "</li>"
        yield "</ul>"
    if failed:
        yield f"<h2>Fails somewhere, and may be meant otherwise: {len(failed)}</h2>\n<ul>"
        for row in failed:
            values = "" if row.fails_at is None else f"fails at {_values(row.fails_at)}"
            text = f"<li>{_place(row, name)} <code>{escape(row.link.read_as)}</code>"
            yield f'{text}<br><span class="why">{escape(values or row.why)}</span></li>'
        yield "</ul>"
    yield "</section>"


def _place(row: Row, name: str) -> str:
    display = row.link.display
    place = escape(f"{display.file or name}:{display.line}")
    return f'<a href="#display-{display.number}">{place}</a>'


def _values(point: Mapping[str, str]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in point.items()) or "the constants"


def _findings(row: Row) -> str:
    """Return the reason of a row, its counterexample and its suggestions."""
    text = f'<br><span class="why">{escape(row.why)}</span>'
    if row.witness is not None and not row.why.startswith("it fails at"):
        text += f"<br>Witness: {escape(_values(row.witness))}"
    for found in row.instead:
        given = f" given <code>{escape(found.given)}</code>" if found.given else ""
        text += f"<br>Instead: {_formula(found.claim)}{given}, {found.verdict} "
        text += f"(<mark>{escape(found.edit)}</mark>)"
    return text


def _formula(claim: str) -> str:
    """Return a claim in the grammar of ``tresym check``, typeset inline."""
    try:
        return to_mathml(parse_claim(claim), block=False)
    except InputError:
        return f"<code>{escape(claim)}</code>"


def _link(row: Row) -> str:
    """Return the item of a link: its status, how it was read, and why it has that status."""
    link = row.link
    read_as = link.read_as or link.shown
    text = f'<li class="{row.status}"><span class="status">{row.status}</span>'
    return f"{text} <code>{escape(read_as)}</code>{_findings(row)}</li>"


def worst(rows: Sequence[Row]) -> str:
    """Return the status of a display: the worst one of its links."""
    return min((row.status for row in rows), key=_WORST.index)


def marks(rows: Sequence[Row]) -> str:
    """Return the statuses for tresym.sty: one line per display, in order."""
    lines = []
    for number, links in groupby(rows, key=lambda row: row.link.display.number):
        found = list(links)
        lines.append(f"\\tresymstatus{{{number}}}{{{worst(found)}}}\n")
    return "% written by tresym paper --marks\n" + "".join(lines)


MARK = '<meta name="generator" content="tresym">'
"""Marks a page as written by tresym, so that a later run may replace it."""

STYLE = r"""\NeedsTeXFormat{LaTeX2e}
\ProvidesPackage{tresym}[marks in the margin: what tresym paper says of each display]
% \usepackage{tresym} and \tresymmarks{FILE} before \begin{document}, where FILE is what
% tresym paper MANUSCRIPT.tex --marks FILE has written.
\RequirePackage{xcolor,etoolbox,amsmath}
\newcounter{tresymdisplay}
\newcommand{\tresymstatus}[2]{\csgdef{tresym@#1}{#2}}
\newcommand{\tresymmarks}[1]{\InputIfFileExists{#1}{}{\PackageWarning{tresym}{no file #1}}}
\definecolor{tresymPROVED}{rgb}{0,.5,0}
\definecolor{tresymENCLOSED}{rgb}{0,.5,0}
\definecolor{tresymREFUTED}{rgb}{.8,0,0}
\definecolor{tresymSUSPECT}{rgb}{.8,0,0}
\definecolor{tresymUNDECIDED}{rgb}{.8,.5,0}
\definecolor{tresymUNREAD}{rgb}{.8,.5,0}
\definecolor{tresymDEFINED}{gray}{.5}
\definecolor{tresymASSUMED}{gray}{.5}
\definecolor{tresymEQUATION}{gray}{.5}
\newcommand{\tresymmark}{\stepcounter{tresymdisplay}\tresymshown}
\newcommand{\tresymshown}{%
  \ifcsdef{tresym@\arabic{tresymdisplay}}{%
    \edef\tresym@now{\csuse{tresym@\arabic{tresymdisplay}}}%
    \marginpar{\scriptsize\textcolor{tresym\tresym@now}{\tresym@now}}}{}}
\newcommand{\tresym@of}[1]{\csdef{tresym@of@#1}{}\BeforeBeginEnvironment{#1}{\tresymmark}}
\forcsvlist{\tresym@of}{DISPLAYS}
% \[ and displaymath are equation* by amsmath; $$ is no environment, and has its mark behind it.
\newcommand{\tresym@dollars}{\ifcsdef{tresym@of@\@currenvir}{}{%
  \stepcounter{tresymdisplay}\aftergroup\tresymshown}}
\AtBeginDocument{\everydisplay\expandafter{\the\everydisplay\tresym@dollars}}
\endinput
""".replace("DISPLAYS", ",".join(sorted(DISPLAYS - {"displaymath", "displaymath*"})))
"""The LaTeX package that sets the marks."""
