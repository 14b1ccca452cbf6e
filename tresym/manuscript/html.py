"""The statuses of a manuscript as a page, and as marks for its own margin."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from html import escape
from itertools import groupby

from tresym.ledger.latex_source import DISPLAYS
from tresym.manuscript.deciding import STATUSES, Row
from tresym.manuscript.kinds_in_prose import REAL
from tresym.manuscript.suspects import attention, printed
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
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
section { border-left: 4px solid #bbb; margin: 1.5rem 0; padding: 0 1rem }
section.REFUTED, section.SUSPECT { border-color: #c00 }
section.PROVED, section.ENCLOSED { border-color: #080 }
section.UNDECIDED, section.UNREAD { border-color: #c80 }
h2 { font-size: 1rem; margin: 0 } .status { font-weight: 600 } .why { color: #555 }
#attention { background: #fff4f0; padding: .5rem 1rem }
table { border-collapse: collapse } td, th { padding: .1rem .6rem; text-align: left }
math { font-size: 1.2em } code { overflow-wrap: anywhere }
"""


def page(rows: Sequence[Row], name: str) -> str:
    """Return an HTML page with every display in order, link by link, typeset as it was read."""
    counts = Counter(row.status for row in rows)
    summary = ", ".join(f"{counts[s]} {s}" for s in STATUSES if counts[s])
    title = escape(name)
    body = "\n".join((*_attention(rows, name), *_sections(rows)))
    return (
        f'<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n{MARK}\n'
        f"<title>{title}</title>\n"
        f'<meta name="viewport" content="width=device-width">\n<style>{_STYLE}</style>\n'
        f"<h1>{title}</h1>\n<p>{len(rows)} links: {summary}</p>\n{_symbols(rows)}\n"
        f"{body}\n</html>\n"
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
        f"<td>{', '.join(_place(n) for n in found[name, kind, words][:12])}</td></tr>"
        for name, kind, words in told
    ]
    table = (
        "<table>\n<tr><th>symbol</th><th>kind</th><th>evidence</th><th>displays</th></tr>\n"
        + "\n".join(lines)
        + "\n</table>\n"
    )
    names = escape(", ".join(plain)) or "none"
    return (
        "<details open>\n<summary>Kinds of symbols</summary>\n"
        f"<p>Taken to be real numbers by default: {names}.</p>\n"
        f"{table if lines else ''}</details>"
    )


def _place(number: int) -> str:
    return f'<a href="#display-{number}">{number}</a>'


def _sections(rows: Sequence[Row]) -> Iterator[str]:
    for number, links in groupby(rows, key=lambda row: row.link.display.number):
        found = list(links)
        display = found[0].link.display
        label = f" ({', '.join(display.labels)})" if display.labels else ""
        file = f"{display.file}, " if display.file else ""
        heading = f"Display {number}{label}, {file}line {display.line}"
        yield (
            f'<section class="{worst(found)}" id="display-{number}">\n<h2>{escape(heading)}</h2>\n'
            + "\n".join(map(_link, found))
            + "\n</section>"
        )


def _attention(rows: Sequence[Row], name: str) -> Iterator[str]:
    """Yield the section of the problems, which comes first."""
    found = attention(rows)
    if not found:
        return
    heading = f"Formulas to look at: {len(found)}"
    yield f'<section id="attention" class="REFUTED">\n<h2>{heading}</h2>\n<ul>'
    for row in found:
        display = row.link.display
        place = escape(f"{display.file or name}:{display.line}")
        text = f'<li><a href="#display-{display.number}">{place}</a> '
        text += f'<span class="status">{row.status}</span> <code>{escape(printed(row.link))}</code>'
        text += f"<br>Read as <code>{escape(row.refuted or row.link.read_as)}</code>"
        yield text + _findings(row) + "</li>"
    yield "</ul>\n</section>"


def _findings(row: Row) -> str:
    """Return the reason of a row, its counterexample and its suggestions."""
    text = f'<br><span class="why">{escape(row.why)}</span>'
    if row.witness is not None:
        values = ", ".join(f"{name} = {value}" for name, value in row.witness.items())
        text += f"<br>Witness: {escape(values or 'the constants themselves')}"
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
    link = row.link
    formula = to_mathml([link.sides]) if link.sides else f"<p><code>{escape(link.shown)}</code></p>"
    text = f'<p><span class="status">{row.status}</span>'
    if link.read_as:
        text += f" <code>{escape(link.read_as)}</code>"
    text += _findings(row)
    return f"{formula}\n{text}</p>"


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
