"""Write the pages of the ledger: one for each claim, and one that lists them all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from html import escape
from typing import Any

from tresym import release
from tresym.report.charts.common import time_text
from tresym.report.typesetting.markdown import escaped, finding, sentence
from tresym.report.typesetting.statements import conditions, display, in_dollars, of_record, stated
from tresym.site import graph, search
from tresym.site.markdown import badge, chain, inline, link, statement, titled

Record = dict[str, Any]

SHARP = Fraction(1, 10**15)
"""A ball narrower than this is shown as the short decimal that it contains."""
ANNOTATED = "the-paper.md"
"""The page that follows the paper; it cannot clash with a label, as labels have no hyphens."""
AXIOMS = "quoted-theorems.md"
"""The page of the quoted theorems."""


def pages(ledger: Record, seconds: dict[str, float]) -> Iterator[tuple[str, str]]:
    """Yield every page as its file name and its text.

    Args:
        ledger: as :func:`tresym.report.pages.site_data.record` makes it.
        seconds: saved times of the verdicts, by label; a claim without one shows none.
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
    """Write the list of all claims with verdict, place and statement, in the order of proofs."""
    total = sum(ledger["counts"].values())
    counts = ", ".join(f"{n} {badge(name)}" for name, n in ledger["counts"].items() if n)
    lines = [
        "# The ledger",
        f"{total} claims: {counts}. A claim without a place in the paper is a lemma of the proofs. "
        f"{_resting(ledger)[0]} of them depend on {_resting(ledger)[1]}. Symbols are explained in "
        "the [table of symbols](/pages/symbols.md).",
    ]
    for part in ledger["parts"]:
        lines.append(f"## {part['title'][:1].upper()}{part['title'][1:]}")
        lines.append("::::{container} ledger")
        lines += [_item(label, ledger["claims"][label]) for label in part["claims"]]
        lines.append("::::")
    return "\n\n".join(lines) + "\n"


def annotated(ledger: Record) -> str:
    """Write the page that follows the paper: each statement in its order, with its verdict."""
    claims: dict[str, Record] = ledger["claims"]
    placed = sorted(
        (c["line"], n, label) for n, (label, c) in enumerate(claims.items()) if c["place"]
    )
    lines = [
        "# The paper, annotated",
        f"The {len(placed)} statements of the paper in its order, each with its verdict. A note "
        "marks a statement that is read more strictly than it is printed. The lemmas that the "
        "proofs need are in [the ledger](index.md). The paper: "
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
    """The section of a place; theorems and remarks are in Section 6."""
    first = place.split(", ")[0]
    return "Sect. 6" if first.startswith(("Theorem", "Remark")) else first


def _counted(section: str, claims: Iterable[Record]) -> str:
    found = Counter(c["verdict"] for c in claims if c["place"] and _section(c["place"]) == section)
    return ", ".join(f"{n} {badge(name)}" for name, n in found.most_common()) + "."


def _annotation(label: str, claim: Record) -> str:
    """A statement with its place, and what is true instead if it is refuted."""
    place = claim["place"].removeprefix(f"{_section(claim['place'])}, ")
    quote = f" “{sentence(claim['quote'])}”\\\n" if claim["quote"] else "\\\n"
    true = ", ".join(map(link, claim["amended_by"]))
    instead = f"\\\nTrue instead: {true}." if true else ""
    head = f"[{place}]{{.place}} {titled(label, claim)}"
    return f"{head}{quote}{inline(claim)}{instead}"


def _resting(ledger: Record) -> tuple[int, str]:
    """How many claims depend on quoted theorems, and a link that says how many these are."""
    resting = sum(bool(claim["axioms"]) for claim in ledger["claims"].values())
    return resting, f"[{len(ledger['axioms'])} theorems]({AXIOMS}) that are quoted and not proved"


def axioms(ledger: Record) -> str:
    """Write the page of quoted theorems, with what depends on each, and of the rules of proof."""
    lines = [
        "---\norphan: true\n---\n\n# Quoted theorems",
        f"{len(ledger['axioms'])} theorems are quoted and not proved. {_resting(ledger)[0]} claims "
        "depend on them, directly or through other claims; the page of each claim says so.",
    ]
    for name, axiom in ledger["axioms"].items():
        lines += [f"## {sentence(name[:1].upper() + name[1:])}", *_quoted(axiom)]
        lines.append("Claims that depend on it: " + ", ".join(map(link, axiom["claims"])) + ".")
    lines += [
        "## Theorems behind the rules of proof",
        "The rules by which the steps of a proof are checked are sound by these textbook theorems, "
        "so any claim may depend on them.",
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
    proved = claim["coq"] and claim["coq"]["status"] == "proved"
    coq = " [Coq]{.mark .coq}" if proved else ""
    axioms = " [quoted theorem]{.mark .axioms}" if claim["axioms"] else ""
    kind = f" [{claim['kind']}]{{.kind}}"
    return f"{titled(label, claim)}{place}{coq}{axioms}{kind}\\\n{inline(claim)}"


def _beside(label: str, order: list[str], claims: dict[str, Record]) -> str:
    """Links to the claims before and after this one, in the order of the proofs."""

    def named(other: str) -> str:
        return f"[{sentence(claims[other]['title'])}](/claims/{other}.md)"

    at = order.index(label)
    before = [f"← {named(order[at - 1])}"] if at else []
    after = [f"{named(order[at + 1])} →"] if at + 1 < len(order) else []
    return "\n" + " · ".join([*before, "[the ledger](index.md)", *after]) + "\n"


def _cited(label: str, claim: Record) -> str:
    """The data that the buttons of the page copy: the formula in LaTeX, and a BibTeX entry."""
    name = claim["alias"] or label
    formula = claim["formula"] or ", \\quad ".join(claim["means"])
    entry = "\n".join(
        [
            f"@misc{{tresym-{label},",
            "  author = {The tresym contributors},",
            f"  title = {{Claim {name} ({claim['verdict']}) on the tennis racket effect}},",
            f"  year = {{{release.RELEASED[:4]}}},",
            f"  version = {{{release.described()}}},",
            f"  note = {{On {release.PAPER}; checked by: tresym verify {name}}},",
            "}",
        ]
    )
    data = f'data-latex="{escape(formula or "")}" data-bibtex="{escape(entry)}"'
    return f'```{{raw}} html\n<div class="copied-from" {data}></div>\n```'


def page(label: str, ledger: Record, title: str | None, seconds: float | None) -> str:
    """Write the page of one claim.

    Args:
        label: its label.
        ledger: as for :func:`pages`.
        title: the title of its part of the proofs, or None.
        seconds: the saved time of its verdict, or None.
    """
    claims = ledger["claims"]
    claim = claims[label]
    shown = claim["alias"] or label
    sections = [
        f"---\norphan: true\n---\n\n# {escaped(claim['title'])}",
        _named_as(label, claim),
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
        *_searched(label, shown),
        f"```sh\ntresym verify {shown}\ntresym derive {_if_refuted(claim)}{shown}\n```",
    ]
    return "\n\n".join(sections) + "\n"


def _named_as(label: str, claim: Record) -> str:
    """The readable name of a claim and its label, the file of its proof, and its data."""
    names = f"`{claim['alias']}`, also `{label}`" if claim["alias"] else f"`{label}`"
    at = claim["source"]
    file, first, last = at["file"], at["first"], at["last"]
    return (
        f"{names} · "
        f'<a href="../proofs/{file.rpartition(".")[0]}.html#L-{first}">'
        f"proofs/{file}, lines {first} to {last}</a> · "
        f'<a href="{label}.json">formula as data</a>'
    )


def _searched(label: str, name: str) -> Iterator[str]:
    """Words under which the search finds the page, which the page does not show."""
    words = [name.replace("_", " "), *search.words_that_lead_to(f"claims/{label}")]
    if name != label or len(words) > 1:
        yield f"```{{raw}} html\n<p hidden>{escape('; '.join(words))}</p>\n```"


def data(label: str, claim: Record) -> Record:
    """Return what the file ``LABEL.json`` beside the page of a claim holds.

    ``formula`` and ``given`` are the statement and its conditions as a file of claims writes them,
    ``latex`` and ``given_latex`` the same in LaTeX.
    """
    return {
        "label": label,
        "alias": claim["alias"],
        "title": claim["title"],
        "kind": claim["kind"],
        "verdict": claim["verdict"],
        "formula": claim["statement"],
        "given": claim["given_text"],
        "latex": claim["means"] or ([claim["formula"]] if claim["formula"] else []),
        "given_latex": claim["given"],
        "witness": claim["witness"],
        "value": claim["value"],
        "constant": claim["constant"],
        "uses": claim["uses"],
        "amended_by": claim["amended_by"],
        "source": claim["source"],
        "version": release.described(),
    }


def _heading(claim: Record, title: str | None) -> str:
    where = f"the paper's {claim['place']}" if claim["place"] else "a lemma of the proofs"
    part = f"\\\n[{sentence(title)}](index.md)" if title else ""
    return f"{claim['kind'].capitalize()}, {where}{part}"


def _printed(claim: Record) -> Iterator[str]:
    """The paper's own words, if the claim is refuted or read more strictly than printed."""
    if claim["paper_says"]:
        yield f"The paper: {sentence(claim['paper_says'])} Read more strictly, this says:"
    elif claim["quote"]:
        yield f"The paper: “{sentence(claim['quote'])}”."


def _decided(claim: Record) -> Iterator[str]:
    """The statement, the formula that is decided, the verdict, and the conditions."""
    found = of_record(claim)
    yield from stated(found)
    if found.means:
        yield "As a formula:"
        yield from map(display, found.means)
    elif claim["conjunction"]:
        yield f"This is the conjunction of {', '.join(map(link, claim['conjunction']))}."
    elif found.says and not claim["formal"]:
        yield (
            "No single formula expresses this sentence; please judge whether the evidence below "
            "supports it."
        )
    given = conditions(found, in_dollars, sentence, link)
    yield f"{badge(claim['verdict'])} {given}".strip()
    yield from _uses_where_it_holds(claim)


def _if_refuted(claim: Record) -> str:
    return "--refuted " if claim["verdict"] == "REFUTED" else ""


def _uses_where_it_holds(claim: Record) -> Iterator[str]:
    """The conditions of the claims used, which were verified; a conjunction lists them already."""
    asked = [
        f"{link(label)} for {_formulas(given)}" for label, given in claim["conditions"].items()
    ]
    if asked and not claim["parts"] and claim["chains"]:
        yield (
            f"The claims that it uses hold under conditions that are met here: {'; '.join(asked)}."
        )


def _formulas(conditions: list[str]) -> str:
    return ", ".join(f"${condition}$" for condition in conditions)


def _proof(claim: Record) -> Iterator[str]:
    yield "## Evidence"
    yield f"By {claim['evidence']}." if claim["evidence"] else ""
    for lines in claim["chains"]:
        yield chain(lines)
    if not claim["chains"]:
        yield f"Result: {_found(claim)}."
    if claim["verdict"] == "REFUTED" and claim["witness"]:
        point = ", ".join(f"{name} = {value}" for name, value in claim["witness"].items())
        yield f"**Witness.** {finding(point)}."
    if claim["note"]:
        yield sentence(claim["note"])


def _found(claim: Record) -> str:
    """The result of the check; if the claim follows from others, with links to them."""
    if parts := claim.get("follows_from"):
        return "follows from " + ", ".join(map(link, parts))
    return finding(claim["why"])


def _numbers(claim: Record) -> Iterator[str]:
    for name in ("value", "constant"):
        if claim[name]:
            yield f"{name.capitalize()}: {_ball(claim[name])}."
    if claim["region"]:
        yield f"Region: {finding(claim['region'])}."
    if claim["parameter"]:
        yield f"Parameter: {finding(claim['parameter'])}."


def _ball(ball: dict[str, str]) -> str:
    """A ball in decimal; if it is very narrow, the short decimal that it contains."""
    mid, rad = Fraction(ball["mid"]), Fraction(ball["rad"])
    short = f"{float(mid):.10g}"
    is_short = rad and rad < SHARP and abs(Fraction(short) - mid) <= rad
    text = short if is_short else f"{ball['mid']}, to within {ball['rad']}"
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
    """The quoted theorems that it depends on, directly or through other claims, with sources."""
    if claim["axioms"]:
        yield f"It depends on [quoted theorems]({AXIOMS}):"
        yield "\n".join(
            f"- {sentence(name)}: {sentence(known[name]['source'])}" for name in claim["axioms"]
        )
    elif claim["kind"] != "definition":
        yield "It depends on no quoted theorem."


def _coq(claim: Record) -> Iterator[str]:
    """The theorem that Coq proves about it, with its premises."""
    coq = claim["coq"]
    if coq is None:
        return
    yield "## [Proof in Coq](/pages/coq.md)"
    what = "the refutation" if claim["verdict"] == "REFUTED" else "this claim"
    if coq["status"] == "parts":
        what = "not this claim but those that it is derived from"
    rests = f"; {coq['assumptions']}" if coq["assumptions"] else ""
    if coq["premises"]:
        premises = ", ".join(map(link, coq["premises"]))
        rests = f", assuming {premises}, which are not proved in Coq"
    if coq["quoted"]:
        rests += f"; the claim also quotes, without proof: {', '.join(coq['quoted'])}"
    yield f"Coq has proved {what} ({coq['checked']}){rests}:"
    yield f"```coq\n{coq['text']}\n```"
    if coq["undefined"]:
        left = ", ".join(f"`{part}`" for part in coq["undefined"])
        yield f"It says nothing about points where one of these conditions fails: {left}."


def _symbols(claim: Record) -> Iterator[str]:
    """The symbols that it uses, each a link to its row in the table of symbols."""
    links = (
        f'<a href="../pages/symbols.html#{symbol["anchor"]}">{escape(symbol["letters"])}</a>'
        for symbol in claim["symbols"]
    )
    if claim["symbols"]:
        yield f"[Symbols](/pages/symbols.md): {', '.join(links)}."


def _cost(claim: Record, seconds: float | None) -> Iterator[str]:
    if seconds is not None:
        yield f"Judged in {time_text(seconds)} (saved measurement)."
