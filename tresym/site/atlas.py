"""Write the pages of the atlas: one for each subject, and an index with a search field.

Everything is read from the stored answers, so that the pages are built in a second. Each entry has
a heading with a permanent address, such as ``atlas/error.html#atlas-mills-ratio``.
"""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from shlex import quote

from tresym import __version__
from tresym.entries.lookup import bibtex, related, text_of
from tresym.entries.reading import SUBJECTS, Decided, Entry, entries
from tresym.reals.language.readings import in_latex
from tresym.report.typesetting.markdown import escaped
from tresym.site.markdown import badge


def pages() -> Iterator[tuple[str, str]]:
    """Yield every page as its file name and its text."""
    known = entries()
    subjects = [name for name in SUBJECTS if any(entry.subject == name for entry in known)]
    yield "index.md", index(known, subjects)
    for subject in subjects:
        chosen = [entry for entry in known if entry.subject == subject]
        yield f"{subject}.md", "\n\n".join([f"# {SUBJECTS[subject]}", *map(section, chosen)]) + "\n"


def index(known: tuple[Entry, ...], subjects: list[str]) -> str:
    """Write the list of all entries, which a script narrows to those that words describe."""
    sharp = sum(entry.quoted is not None for entry in known)
    lines = [
        "# Atlas of asymptotics",
        f"{len(known)} expansions and bounds that people look up. Each is decided by tresym, with "
        "a false statement beside it that is met in practice and refuted. For "
        f"{sharp} of them the smallest constant on a natural region is enclosed from both sides. "
        "Every number stands in a claim with a verdict. From the command line: "
        "`tresym atlas mills-ratio`, `tresym atlas --search 'erfc large'`; from Python: "
        '`tresym.atlas("mills-ratio")`. With `--explain` the command decides the claim anew and '
        "explains the verdict step by step; with `--chart FILE` it draws the error of a claim with "
        "O against its proved bound.",
        "```{toctree}\n:maxdepth: 1\n\n" + "\n".join(subjects) + "\n```",
        '<div class="ledger-filter"><input type="search" id="atlas-search" '
        'placeholder="erfc, x → ∞, Mills" aria-label="Search the atlas">'
        '<span id="atlas-count" aria-live="polite"></span></div>',
    ]
    rows = []
    for entry in known:
        words = escape(text_of(entry), quote=True)
        address = f"{entry.subject}.html#atlas-{entry.name}"
        shown = f'<a href="{address}">{escape(entry.title)}</a>'
        shown += f"<br><code>{escape(entry.claim)}</code>"
        rows.append(f'<li data-words="{words}">{shown}</li>')
    return "\n\n".join([*lines, '<ul class="atlas">\n' + "\n".join(rows) + "\n</ul>"]) + "\n"


def section(entry: Entry) -> str:
    """Write an entry: formula, verdict, bound, neighbour, source, and what one copies."""
    assert entry.answer is not None
    assert entry.neighbour is not None
    parts = [f"(atlas-{entry.name})=\n## {escaped(entry.title)}", _display(entry.claim)]
    parts.append(f"{badge(entry.answer.verdict.value)} {escaped(entry.answer.why)}")
    if entry.constant and entry.bound and entry.floor:
        low, high = entry.constant
        where = f" for ${_conditions(entry.region)}$" if entry.region else " for all values"
        parts.append(
            f"**Constant.** The smallest C{where} lies between {low} and {high}. "
            f"{badge(entry.bound.verdict.value)} with C = {high}:"
        )
        bound = entry.bound.claim.partition(" given ")[0]
        parts.append(_display(bound.replace(f"({high})", "C", 1)))
    elif entry.quoted:
        low, high, region = entry.quoted
        where = f" for ${_conditions(region)}$" if region else ""
        parts.append(f"**Constant.** The smallest lies between {low} and {high}{where}.")
    parts.append(f"**But not** {_where(entry.neighbour)}")
    parts.append(_display(entry.false))
    parts.append(f"**Source.** {escaped(entry.source)}")
    said = quote(entry.claim)
    parts.append(f"```sh\ntresym check {said}\ntresym explain {said}\n```")
    parts.append(f"<details><summary>What fails</summary>{_failures(entry)}</details>")
    cited = escape(f"{in_latex(entry.claim)}\n\n{bibtex(entry, __version__)}")
    cited = cited.replace("{", "&#123;")  # two of them would be a substitution
    parts.append(f"<details><summary>LaTeX and BibTeX</summary><pre>{cited}</pre></details>")
    near = ", ".join(f"[{escaped(other.title)}](#atlas-{other.name})" for other in related(entry))
    parts.append(f"**Related.** {near}" if near else "")
    return "\n\n".join(part for part in parts if part)


def _failures(entry: Entry) -> str:
    """Say why the false statement fails, and where a smaller constant does."""
    assert entry.neighbour is not None
    told = [(entry.false, entry.neighbour.reason)]
    if entry.floor:
        told.append((entry.floor.claim, entry.floor.reason))
    lines = [f"<p><code>{escape(claim)}</code><br>{escape(reason)}</p>" for claim, reason in told]
    return "".join(lines).replace("{", "&#123;")


def _display(claim: str) -> str:
    shown = in_latex(claim)
    return f"$$\n{shown}\n$$" if shown else f"`{claim}`"


def _conditions(region: str) -> str:
    """Typeset a condition such as ``0 < x <= 1``."""
    return in_latex(region) or region


def _where(found: Decided) -> str:
    at = f" at {found.witness}" if found.witness else ""
    return f"({badge(found.verdict.value)}{escaped(at)}):"
