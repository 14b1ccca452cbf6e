"""Pages of the ledger: one for each claim, and one that lists them all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from html import escape
from typing import Any

import tresym
from tresym.report.typesetting.markdown import escaped, finding, sentence
from tresym.report.typesetting.statements import conditions, display, in_dollars, of_record, stated
from tresym.site import graph
from tresym.site.markdown import badge, chain, inline, link, statement, titled

Record = dict[str, Any]

SHARP = Fraction(1, 10**15)
"""How narrow a ball is about a constant that was typed."""
ANNOTATED = "the-paper.md"
"""The page that goes through the paper; a hyphen is in no label."""
AXIOMS = "quoted-theorems.md"
"""The page of the theorems that are quoted; a hyphen is in no label."""


def pages(ledger: Record, seconds: dict[str, float]) -> Iterator[tuple[str, str]]:
    """Every page as its name and its text.

    Args:
        ledger: as `tresym.report.pages.site_data.record` makes it.
        seconds: saved cost of judging, by label; claims without one show none.
    """
    yield "index.md", index(ledger)
    yield ANNOTATED, annotated(ledger)
    yield AXIOMS, axioms(ledger)
    order = [(label, part["title"]) for part in ledger["parts"] for label in part["claims"]]
    titles = dict(order)
    placed = list(titles)
    for label in ledger["claims"]:
        text = page(label, ledger, titles.get(label), seconds.get(label))
        beside = _beside(label, placed, ledger["claims"]) if label in titles else ""
        yield f"{label}.md", text + beside


def index(ledger: Record) -> str:
    """Every claim with its verdict, place and statement, in the order of the proofs."""
    total = sum(ledger["counts"].values())
    counts = ", ".join(f"{n} {badge(name)}" for name, n in ledger["counts"].items() if n)
    lines = [
        "# The ledger",
        f"{total} claims: {counts}. A claim without a place in the paper is a lemma of the proofs. "
        f"{_resting(ledger)[0]} of them rest on {_resting(ledger)[1]}. What a letter stands for is "
        "in the [table of symbols](/pages/symbols.md).",
    ]
    for part in ledger["parts"]:
        lines.append(f"## {part['title'][:1].upper()}{part['title'][1:]}")
        lines.append("::::{container} ledger")
        lines += [_item(label, ledger["claims"][label]) for label in part["claims"]]
        lines.append("::::")
    return "\n\n".join(lines) + "\n"


def annotated(ledger: Record) -> str:
    """The paper from its abstract to its references: what each sentence and display got."""
    claims: dict[str, Record] = ledger["claims"]
    placed = sorted(
        (c["line"], n, label) for n, (label, c) in enumerate(claims.items()) if c["place"]
    )
    lines = [
        "# The paper, annotated",
        f"The {len(placed)} statements of the paper in the order in which they stand there, each "
        "with its verdict; what is read more sharply than it is printed says so. The lemmas "
        "between them are in [the ledger](index.md). The paper: "
        "[Physica D 338 (2017) 17](https://doi.org/10.1016/j.physd.2016.07.010), "
        "[arXiv:1606.08237](https://arxiv.org/abs/1606.08237).",
    ]
    part = ""
    for _, _, label in placed:
        claim = claims[label]
        section = _section(claim["place"])
        if section != part:
            part = section
            lines += [f"## {section[:1].upper()}{section[1:]}", _counted(section, claims.values())]
        lines.append(_annotation(label, claim))
    return "\n\n".join(lines) + "\n"


def _section(place: str) -> str:
    """The section of a place; theorem and remark are Section 6's."""
    first = place.split(", ")[0]
    return "Sect. 6" if first.startswith(("Theorem", "Remark")) else first


def _counted(section: str, claims: Iterable[Record]) -> str:
    found = Counter(c["verdict"] for c in claims if c["place"] and _section(c["place"]) == section)
    return ", ".join(f"{n} {badge(name)}" for name, n in found.most_common()) + "."


def _annotation(label: str, claim: Record) -> str:
    """A statement at its place, and what is true instead where it is refuted."""
    place = claim["place"].removeprefix(f"{_section(claim['place'])}, ")
    quote = f" “{sentence(claim['quote'])}”\\\n" if claim["quote"] else "\\\n"
    true = ", ".join(map(link, claim["amended_by"]))
    instead = f"\\\nTrue instead: {true}." if true else ""
    head = f"[{place}]{{.place}} {titled(label, claim)}"
    return f"{head}{quote}{inline(claim)}{instead}"


def _resting(ledger: Record) -> tuple[int, str]:
    """How many claims rest on theorems that are quoted, and how many these are."""
    resting = sum(bool(claim["axioms"]) for claim in ledger["claims"].values())
    return resting, f"[{len(ledger['axioms'])} theorems]({AXIOMS}) that are quoted and not proved"


def axioms(ledger: Record) -> str:
    """The theorems that are quoted, each with what rests on it, and those of the judge's rules."""
    lines = [
        "---\norphan: true\n---\n\n# Quoted theorems",
        f"{len(ledger['axioms'])} theorems are quoted and not proved. Each is named by the claims "
        f"whose evidence applies it, and listed by every claim above them: {_resting(ledger)[0]} "
        "in all.",
    ]
    for name, axiom in ledger["axioms"].items():
        lines += [f"## {sentence(name[:1].upper() + name[1:])}", *_quoted(axiom)]
        lines.append("Claims that rest on it: " + ", ".join(map(link, axiom["claims"])) + ".")
    lines += [
        "## In the rules of the judge",
        "A step of a chain is right by these, so that any claim may rest on them.",
    ]
    for name, axiom in ledger["rules"].items():
        lines += [f"### {sentence(name[:1].upper() + name[1:])}", *_quoted(axiom)]
        lines.append(f"Applied by: {sentence(axiom['rule'])}.")
    return "\n\n".join(lines) + "\n"


def _quoted(axiom: Record) -> Iterator[str]:
    yield sentence(axiom["says"])
    if axiom["formula"]:
        yield display(axiom["formula"])
    yield sentence(f"{axiom['source']}.")


def _item(label: str, claim: Record) -> str:
    place = f" [{claim['place']}]{{.place}}" if claim["place"] else ""
    coq = " [Coq]{.mark .coq}" if claim["coq"] and not claim["coq"]["premises"] else ""
    axioms = " [quoted theorem]{.mark .axioms}" if claim["axioms"] else ""
    kind = f" [{claim['kind']}]{{.kind}}"
    return f"{titled(label, claim)}{place}{coq}{axioms}{kind}\\\n{inline(claim)}"


def _beside(label: str, order: list[str], claims: dict[str, Record]) -> str:
    """Links to the claims before and after it, in the order of the proofs."""

    def named(other: str) -> str:
        return f"[{sentence(claims[other]['title'])}](/claims/{other}.md)"

    at = order.index(label)
    before = [f"← {named(order[at - 1])}"] if at else []
    after = [f"{named(order[at + 1])} →"] if at + 1 < len(order) else []
    return "\n" + " · ".join([*before, "[the ledger](index.md)", *after]) + "\n"


def _cited(label: str, claim: Record) -> str:
    """What the buttons of the page copy: its formula in LaTeX, and an entry for BibTeX."""
    formula = claim["formula"] or ", \\quad ".join(claim["means"])
    entry = "\n".join(
        [
            f"@misc{{tresym-{label},",
            "  author = {The tresym contributors},",
            f"  title = {{Claim {label} ({claim['verdict']}) on the tennis racket effect}},",
            f"  note = {{tresym {tresym.__version__}, checked by: tresym verify {label}}},",
            "}",
        ]
    )
    data = f'data-latex="{escape(formula or "")}" data-bibtex="{escape(entry)}"'
    return f'```{{raw}} html\n<div class="copied-from" {data}></div>\n```'


def page(label: str, ledger: Record, title: str | None, seconds: float | None) -> str:
    """The page of one claim."""
    claims = ledger["claims"]
    claim = claims[label]
    sections = [
        f"---\norphan: true\n---\n\n# {escaped(claim['title'])}",
        f"`{label}`",
        _heading(claim, title),
        *_printed(claim),
        *_decided(claim),
        *_truth(claim, claims),
        *_proof(claim),
        *_numbers(claim),
        *_axioms(claim, ledger["axioms"]),
        *_coq(claim),
        *_graph(label, claims),
        *_relations(claim, claims),
        *_symbols(claim),
        *_cost(claim, seconds),
        _cited(label, claim),
        f"```sh\ntresym verify {label}\ntresym derive {_if_refuted(claim)}{label}\n```",
    ]
    return "\n\n".join(sections) + "\n"


def _heading(claim: Record, title: str | None) -> str:
    where = f"the paper's {claim['place']}" if claim["place"] else "a lemma of the proofs"
    part = f"\\\n[{sentence(title)}](index.md)" if title else ""
    return f"{claim['kind'].capitalize()}, {where}{part}"


def _printed(claim: Record) -> Iterator[str]:
    """The paper's own words, where it is refuted, or read more strictly than it is printed."""
    if claim["paper_says"]:
        yield f"The paper: {sentence(claim['paper_says'])} We read it more strictly:"
    elif claim["quote"]:
        yield f"The paper: “{sentence(claim['quote'])}”."


def _decided(claim: Record) -> Iterator[str]:
    """What it says, the formula that is decided, the verdict, and where that holds."""
    found = of_record(claim)
    yield from stated(found)
    if found.means:
        yield "Decided as"
        yield from map(display, found.means)
    elif claim["conjunction"]:
        yield f"Decided as the conjunction of {', '.join(map(link, claim['conjunction']))}."
    elif found.says and not claim["formal"]:
        yield "The reader must judge that the evidence supports this sentence."
    given = conditions(found, in_dollars, sentence, link)
    yield f"{badge(claim['verdict'])} {given}".strip()
    yield from _uses_where_it_holds(claim)


def _if_refuted(claim: Record) -> str:
    return "--refuted " if claim["verdict"] == "REFUTED" else ""


def _uses_where_it_holds(claim: Record) -> Iterator[str]:
    """The conditions of what is put in, which were shown; a conjunction has said them."""
    asked = [
        f"{link(label)} for {_formulas(given)}" for label, given in claim["conditions"].items()
    ]
    if asked and not claim["parts"] and claim["chains"]:
        yield f"The claims it uses are applied where they hold: {'; '.join(asked)}."


def _formulas(conditions: list[str]) -> str:
    return ", ".join(f"${condition}$" for condition in conditions)


def _proof(claim: Record) -> Iterator[str]:
    yield "## Evidence"
    yield f"By {claim['evidence']}." if claim["evidence"] else ""
    for lines in claim["chains"]:
        yield chain(lines)
    if not claim["chains"]:
        yield f"Found: {_found(claim['why'])}."
    if claim["verdict"] == "REFUTED" and claim["witness"]:
        point = ", ".join(f"{name} = {value}" for name, value in claim["witness"].items())
        yield f"**Witness.** {finding(point)}."
    if claim["note"]:
        yield sentence(claim["note"])


def _found(why: str) -> str:
    """What judging found; where that is the claims that it follows from, links to them."""
    _, follows, labels = why.partition("follows from ")
    return follows + ", ".join(map(link, labels.split(", "))) if follows else finding(why)


def _numbers(claim: Record) -> Iterator[str]:
    for name in ("value", "constant"):
        if claim[name]:
            yield f"{name.capitalize()}: {_ball(claim[name])}."
    if claim["region"]:
        yield f"Region: {finding(claim['region'])}."
    if claim["parameter"]:
        yield f"Parameter: {finding(claim['parameter'])}."


def _ball(ball: dict[str, str]) -> str:
    """A ball in decimal; a short number that it holds stands for one that is that narrow."""
    mid, rad = Fraction(ball["mid"]), Fraction(ball["rad"])
    short = f"{float(mid):.10g}"
    told = rad and rad < SHARP and abs(Fraction(short) - mid) <= rad
    text = short if told else f"{ball['mid']}, to within {ball['rad']}"
    return f"−{text[1:]}" if text.startswith("-") else text


def _truth(claim: Record, claims: dict[str, Record]) -> Iterator[str]:
    if claim["amended_by"]:
        yield "## True instead"
        yield "\n\n".join(_named(label, claims) for label in claim["amended_by"])
    if claim["amends"]:
        yield "## Corrects"
        yield "\n\n".join(_named(label, claims) for label in claim["amends"])


def _named(label: str, claims: dict[str, Record]) -> str:
    return f"{titled(label, claims[label])}\n\n{statement(claims[label])}"


def _graph(label: str, claims: dict[str, Record]) -> Iterator[str]:
    shown = graph.picture(label, claims)
    if shown:
        yield f"## Dependencies\n\n```{{raw}} html\n{shown}\n```"


def _relations(claim: Record, claims: dict[str, Record]) -> Iterator[str]:
    for title, key in (("What it uses", "uses"), ("What uses it", "used_by")):
        if claim[key]:
            yield f"## {title}"
            items = (f"- {titled(n, claims[n])}\\\n{inline(claims[n])}" for n in claim[key])
            yield "\n".join(items)


def _axioms(claim: Record, known: dict[str, Record]) -> Iterator[str]:
    """The theorems that it rests on, directly or not, with their sources."""
    if claim["axioms"]:
        yield f"It rests on [quoted theorems]({AXIOMS}):"
        yield "\n".join(
            f"- {sentence(name)}: {sentence(known[name]['source'])}" for name in claim["axioms"]
        )
    elif claim["kind"] != "definition":
        yield "It rests on no quoted theorem."


def _coq(claim: Record) -> Iterator[str]:
    """The theorem that Coq has proved of it, and what that rests on."""
    coq = claim["coq"]
    if coq is None:
        return
    yield "## [Proof in Coq](/pages/coq.md)"
    if coq["premises"]:
        premises = ", ".join(map(link, coq["premises"]))
        what = "that it is false" if claim["verdict"] == "REFUTED" else "it"
        yield f"Coq proves {what}, assuming {premises}, which are not proved in Coq:"
    else:
        rests = f"; {coq['assumptions']}" if coq["assumptions"] else ""
        what = "that it is false" if claim["verdict"] == "REFUTED" else "it as well"
        yield f"Coq proves {what}{rests}:"
    yield f"```coq\n{coq['text']}\n```"


def _symbols(claim: Record) -> Iterator[str]:
    """The symbols that it uses, each a link to its line in the table of symbols."""
    links = (
        f'<a href="../pages/symbols.html#{symbol["anchor"]}">{escape(symbol["letters"])}</a>'
        for symbol in claim["symbols"]
    )
    if claim["symbols"]:
        yield f"[Symbols](/pages/symbols.md): {', '.join(links)}."


def _cost(claim: Record, seconds: float | None) -> Iterator[str]:
    if seconds is not None:
        yield f"Judged in {seconds * 1000:.3g} ms (saved measurement)."
