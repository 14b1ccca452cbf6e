"""Write the article in Markdown, for a wiki or a repository: the text of the LaTeX, converted.

LaTeX numbers sections, equations, theorems, figures and references when it runs; here they are
numbered in the same way, and references to them become these numbers.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping

from tresym.report.pages.fragments import for_markdown
from tresym.report.typesetting.markdown_from_latex import markdown_from_latex

_INSIDE = r"[^{}]*"
for _ in range(3):
    _INSIDE = rf"(?:[^{{}}]|\{{{_INSIDE}\}})*"
"""What may stand between braces, with braces nested three deep."""
_NUMBERED = re.compile(
    rf"\\(?P<level>section|subsection)\{{{_INSIDE}\}}"
    r"(?:\\label\{(?P<section>[^}]*)\})?"
    r"|\\begin\{equation\}\\label\{(?P<equation>[^}]*)\}"
    r"|\\begin\{(?:theorem|proposition|corollary)\}\\label\{(?P<theorem>[^}]*)\}"
    r"|\\label\{(?P<figure>fig:[^}]*)\}|\\label\{(?P<table>tab:[^}]*)\}"
    r"|\\bibitem\{(?P<reference>[^}]*)\}"
)
_HEADING = re.compile(
    rf"\\(?P<sub>(?:sub)?)section\{{(?P<head>{_INSIDE})\}}(?:\\label\{{[^}}]*\}})?"
)
_FIGURE = re.compile(
    r"\\begin\{figure\}.*?\\shown\{(?P<name>[\w-]+)\}\s*"
    rf"\\caption\{{(?P<caption>{_INSIDE})\}}"
    r"\\label\{(?P<label>[^}]*)\}\\end\{figure\}",
    re.DOTALL,
)
_THEOREM = re.compile(
    r"\\begin\{(?P<kind>theorem|proposition|corollary)\}\\label\{(?P<label>[^}]*)\}(?P<says>.*?)"
    r"\\end\{(?P=kind)\}",
    re.DOTALL,
)
_ABSTRACT = re.compile(r"\\begin\{abstract\}(.*?)\\end\{abstract\}", re.DOTALL)
_EQUATION = re.compile(
    r"\\begin\{equation\}\\label\{(?P<label>[^}]*)\}(?P<body>.*?)\\end\{equation\}", re.DOTALL
)
_LEFT_OUT = (
    r"\\author\{[^{}]*\}", r"\\date\{.*?\}\n", r"\\maketitle", r"\\noindent", r"\\medskip",
    r"\\end\{thebibliography\}", r"\\ifledger.*?\\fi",
    r"\\(?:begin|end)\{enumerate\}(?:\[[^\]]*\])?(?:\\small)?(?:\\raggedright)?",
    r"\\inmargin\{\w+\}\{\w\}\{[^{}]*\}", r"(?m:^%.*\n)",
)  # fmt: skip
_WORDS = (
    (rf"\\title\{{({_INSIDE})\}}", r"# \1"),
    (r"\\item\s*", "\n1. "),
    (rf"\\(?:sub)?section\*\{{({_INSIDE})\}}", r"\n### \1\n\n"),
    (rf"\\(?:textbf|paragraph)\{{({_INSIDE})\}}", r"**\1**"),
    (rf"\\emph\{{({_INSIDE})\}}", r"*\1*"),
    (r"\\href\{([^{}]*)\}\{([^{}]*)\}", r"[\2](\1)"),
    (r"\\url\{([^{}]*)\}", r"<\1>"),
    (r"\\textsuperscript\{\$?([^{}$]*)\$?([^{}$]*)\}", r"<sup>\1\2</sup>"),
    (r"\\begin\{thebibliography\}\{\w*\}", r"\n## References\n"),
    (r"\\begin\{gather\*\}", r"\\begin{equation*}\\begin{gathered}"),
    (r"\\end\{gather\*\}", r"\\end{gathered}\\end{equation*}"),
    (r"``|''", '"'),
    (r"(?<=\d)--(?=\d)", "–"),
    (r"\\small\b", ""),
)


def article_markdown(text: str, folder: str) -> str:
    """Return the article in Markdown.

    Args:
        text: the text of the article in LaTeX, in which tables are in Markdown already.
        folder: the folder of the figures, as SVG; an empty text for no figures.
    """
    numbers = _numbers(text)

    def figure(found: re.Match[str]) -> str:
        path = f"{folder}/{found['name']}.svg"
        number = numbers[found["label"]]
        picture = f"![Figure {number}]({path})\n\n" if folder else ""
        return f"\n\n{picture}**Figure {number}.** {found['caption']}\n\n" if folder else ""

    def theorem(found: re.Match[str]) -> str:
        kind = found["kind"].capitalize()
        return f"\n\n**{kind} {numbers[found['label']]}.** {found['says'].strip()}\n\n"

    for pattern in _LEFT_OUT:
        text = re.sub(pattern, "", text, flags=re.DOTALL)
    text = _ABSTRACT.sub(r"\1", _THEOREM.sub(theorem, _FIGURE.sub(figure, text)))
    text = _EQUATION.sub(_tagged(numbers), text)
    text = re.sub(
        r"\\label\{(tab:[^}]*)\}", lambda found: f"**Table {numbers[found[1]]}.**\n\n", text
    )
    text = re.sub(r"\\bibitem\{([^}]*)\}", lambda found: f"\n\n[{numbers[found[1]]}] ", text)
    text = _referred(text, numbers)
    text = _HEADING.sub(_numbered(Counter()), text)
    for pattern, instead in _WORDS:
        text = re.sub(pattern, instead, text)
    text = re.sub(r"\n[ \t]+", "\n", text)
    return for_markdown(markdown_from_latex(text, lambda _, letter: f"<sup>{letter}</sup>"))


def _numbers(text: str) -> dict[str, str]:
    """The numbers that LaTeX gives to the labels of a text."""
    counts: Counter[str] = Counter()
    found = {}
    for part in _NUMBERED.finditer(text):
        kind = part["level"] or part.lastgroup or ""
        counts[kind] += 1
        section = counts["section"]
        if kind == "section":
            counts["subsection"] = counts["equation"] = counts["theorem"] = 0
        alone = kind in ("section", "figure", "table", "reference")
        number = f"{counts[kind]}" if alone else f"{section}.{counts[kind]}"
        if label := part["section"] if part["level"] else part[kind]:
            found[label] = number
    return found


def _numbered(counts: Counter[str]) -> Callable[[re.Match[str]], str]:
    """A function that writes a heading with the number of its section."""

    def heading(found: re.Match[str]) -> str:
        level = found["sub"]
        counts[level] += 1
        if not level:
            counts["sub"] = 0
        number = f"{counts['']}.{counts['sub']}" if level else f"{counts['']}"
        return f"\n{'###' if level else '##'} {number} {found['head']}\n\n"

    return heading


def _tagged(numbers: Mapping[str, str]) -> Callable[[re.Match[str]], str]:
    """A function that writes a numbered equation with its number as a tag."""

    def equation(found: re.Match[str]) -> str:
        tag = rf"\tag{{{numbers[found['label']]}}}"
        return rf"\begin{{equation*}}{found['body'].rstrip()}{tag}" + "\n\\end{equation*}"

    return equation


def _referred(text: str, numbers: Mapping[str, str]) -> str:
    """The text with the number of each label that it refers to."""
    text = re.sub(r"\\eqref\{([^}]*)\}", lambda found: f"({numbers[found[1]]})", text)
    text = re.sub(r"\\ref\{([^}]*)\}", lambda found: numbers[found[1]], text)
    return re.sub(
        r"~?\s*\\cite\{([^}]*)\}",
        lambda found: f" [{', '.join(numbers[key] for key in found[1].split(','))}]",
        text,
    )
