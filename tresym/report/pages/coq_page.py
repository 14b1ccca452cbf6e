"""Proofs in Coq: the mark of a claim, and the page that lists which claims Coq proves."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from typing import Any

from tresym.coq import export
from tresym.coq.coqtop import prelude
from tresym.coq.definedness import satisfiable
from tresym.coq.export import Entry, entries, stored
from tresym.coq.ledger_statements import Joint, name_of, relations
from tresym.coq.statement import Theorem
from tresym.ledger.claim import Claim
from tresym.ledger.paper import sections
from tresym.ledger.verification import Row
from tresym.reals.language.formula import Conjunction, Relation
from tresym.reals.verdict import Verdict
from tresym.report.typesetting.titles import shown_name

STATEMENTS = ("coq.export.statements", "coq.export.possible", "coq.ledger_statements.theorem_of")
"""The functions that write the statements which Coq proves."""
_LINES = re.DOTALL | re.MULTILINE
LIBRARY = {
    "PI": ("the number π", "Coq's `Reals`"),
    "sqrt": ("the square root; 0 for negative numbers", "Coq's `Reals`"),
    "Rabs": ("the absolute value", "Coq's `Reals`"),
    "exp": ("the exponential function", "Coq's `Reals`"),
    "ln": ("the natural logarithm; 0 for numbers that are not positive", "Coq's `Reals`"),
    "Rpower": ("`Rpower x y` is `exp (y * ln x)`", "Coq's `Reals`"),
    "sin": ("the sine", "Coq's `Reals`"),
    "cos": ("the cosine", "Coq's `Reals`"),
    "tan": ("`sin x / cos x`", "Coq's `Reals`"),
    "asin": ("the inverse sine, from −π/2 to π/2", "Coq's `Reals`"),
    "acos": ("the inverse cosine, from 0 to π", "Coq's `Reals`"),
    "atan": ("the inverse tangent, between −π/2 and π/2", "Coq's `Reals`"),
    "sinh": ("the hyperbolic sine", "Coq's `Reals`"),
    "cosh": ("the hyperbolic cosine", "Coq's `Reals`"),
    "tanh": ("`sinh x / cosh x`", "Coq's `Reals`"),
    "arcsinh": ("the inverse hyperbolic sine", "Coq's `Reals`"),
    "sign": ("−1, 0 or 1", "Coquelicot"),
    "is_derive": ("`is_derive f x l`: f has the derivative l at x", "Coquelicot"),
    "is_RInt": ("`is_RInt f a b l`: f has the Riemann integral l from a to b", "Coquelicot"),
    "RInt": ("the value of a Riemann integral that exists", "Coquelicot"),
    "Derive": ("the value of a derivative that exists", "Coquelicot"),
    "filterlim": ("`filterlim f F G`: f tends to G as its argument tends to F", "Coquelicot"),
    "is_lim": ("`is_lim f x l`: f(t) tends to l as t tends to x", "Coquelicot"),
}
"""Functions and relations of Coq's libraries that statements use: meaning and library."""


@lru_cache(maxsize=4)
def found(labels: tuple[str, ...] | None = None) -> dict[str, Entry]:
    """Return what is known in Coq about each claim, by label.

    Args:
        labels: the claims wanted; None means all.
    """
    return entries(stored(), labels)


@cache
def _rows() -> dict[str, Any]:
    """Return what is stored of each proof; reading it takes as long as showing a claim."""
    rows: dict[str, Any] = stored()["claims"]
    return rows


def mark(row: Row, known: dict[str, Entry]) -> dict[str, Any] | None:
    """Return the theorem of a claim and its status, with the theorems that the claim quotes.

    Returns:
        None if Coq has proved nothing about the claim, or its verdict is not the expected one.
    """
    entry = known.get(row.claim.label)
    if entry is None or entry.theorem is None or entry.status == "none" or not row.as_expected:
        return None
    return {
        "theorem": entry.theorem.name,
        "status": entry.status,
        "checked": entry.checked,
        "quoted": [axiom.name for axiom in row.claim.axioms],
    }


def sentence(row: Row) -> str:
    """Return what Coq has proved about a claim, in a sentence; empty if nothing.

    Nothing is said about a claim whose verdict is not the expected one: it was changed, or it is
    refuted or undecided.
    """
    claim = row.claim
    entry = found((claim.label,))[claim.label]
    if entry.status == "none" or not row.as_expected:
        return ""
    what = "its refutation is proved" if claim.expect is Verdict.REFUTED else "proved"
    what = "only the claims it is derived from are proved" if entry.status == "parts" else what
    by = f" from {', '.join(entry.premises)}" if entry.premises else ""
    quoted = f"; quoted and not proved: {', '.join(a.name for a in claim.axioms)}"
    return f"{what} in Coq{by} ({entry.checked}){quoted if claim.axioms else ''}"


def shown(of: Row, known: dict[str, Entry]) -> dict[str, Any] | None:
    """Return :func:`mark` with the text, premises and assumptions of the theorem, for its page."""
    marked, label = mark(of, known), of.claim.label
    if marked is None:
        return None
    entry, row = known[label], _rows()[label]
    assert entry.theorem is not None
    text = f"Theorem {name_of(label)} :\n{export.stated(label, known)}."
    return marked | {
        "text": text if entry.closed else entry.theorem.text,
        "premises": list(entry.premises),
        "undefined": list(entry.undefined),
        "assumptions": row.get("assumptions", ""),
    }


def page() -> str:
    """Write the page that lists which claims Coq proves, with the reason where it does not."""
    known, store = found(), stored()
    return "\n".join(
        [
            *_counted(known, store),
            *_defined(known, store),
            *_vocabulary(known),
            *_made_by(),
            *_reasons(known),
        ]
    )


def _counted(known: dict[str, Entry], store: Mapping[str, Any]) -> Iterator[str]:
    """How many claims Coq proves, and what the proofs depend on."""
    claims = {claim.label: claim for _, stated in sections() for claim in stated}
    counts = Counter(entry.status for entry in known.values())
    proved = [label for label, entry in known.items() if entry.status == "proved"]
    kinds = Counter(store["claims"][label].get("assumptions", "") for label in proved)
    says = Counter(_form(claims[label], known[label]) for label in proved if label in claims)
    quoting = [label for label in proved if label in claims and claims[label].axioms]
    days = sorted({entry.checked for entry in known.values() if entry.checked})
    partial = (
        f"It proves {counts['partial']} more (marked *partial*) from premises that are not proved "
        "in Coq. "
    )
    derived = (
        f"For {counts['parts']} claims it proves only the claims from which they are derived, "
        "not the last step (marked *parts*). "
    )
    yield (
        f"Coq proves {counts['proved']} of the {len(known)} claims ({'; '.join(days)}). "
        f"{partial if counts['partial'] else ''}{derived if counts['parts'] else ''}"
        "The tables below give the reason wherever a proof is missing. A claim counts "
        "only while its statement, its proof, the lemmas it uses and Coq's version are those of "
        "that check; `tresym verify` compares their hashes."
    )
    yield ""
    yield "What the theorems say:"
    yield ""
    yield from (f"- {n}: {form}." for form, n in says.most_common())
    yield ""
    yield "What they rest on:"
    yield ""
    yield from (f"- {n} theorems: {text}." for text, n in kinds.most_common() if text)
    if quoting:
        yield (
            f"- {len(quoting)} of these claims also quote theorems that nothing here proves: the "
            f"formulas are proved, the quoted theorem is not ({', '.join(map(_code, quoting))})."
        )
    yield (
        f"- For {len(store['possible'])} sets of conditions Coq proves that some point satisfies "
        "them, so that no theorem holds only because its conditions contradict each other."
    )
    yield ""


def _code(label: str) -> str:
    return f"`{label}`"


def _is_premise(theorem: Theorem) -> bool:
    """Return whether each relation that a theorem concludes is one of its premises."""
    premises = [equation for _, equation in theorem.definitions]
    said = [*relations(theorem.says)]
    whole = isinstance(theorem.says, Relation | Conjunction)
    return whole and not theorem.exists and all(relation in premises for relation in said)


def _form(claim: Claim, entry: Entry) -> str:
    """Return what kind of statement the theorem of a claim is."""
    if claim.expect is Verdict.REFUTED:
        return "refutations: some point satisfies the conditions and violates the statement"
    if claim.kind == "definition":
        return "definitions: the defined value exists"
    if isinstance(entry.theorem, Joint):
        return "conjunctions of other theorems, which together are the claim"
    if isinstance(entry.theorem, Theorem) and _is_premise(entry.theorem):
        return "what their own definitions or assumptions state, so that nothing is left to prove"
    if isinstance(entry.theorem, Theorem) and entry.theorem.exists:
        return "existential: some inputs that round to the printed ones give the printed value"
    return "universal: for all values that satisfy the conditions"


def _defined(known: dict[str, Entry], store: Mapping[str, Any]) -> Iterator[str]:
    """How many premises of definedness are proved, and which ones are left."""
    every = {
        label: (whole, entry.undefined)
        for label, entry in known.items()
        if entry.status == "proved"
        and isinstance(whole := entry.theorem, Theorem)
        and not whole.exists
    }
    total = sum(len(whole.defined) for whole, _ in every.values())
    left = {label: parts for label, (_, parts) in every.items() if parts}
    remaining = sum(map(len, left.values()))
    bodies = {row["body"] for row in store["possible"].values()}
    without = [
        label
        for label in left
        if isinstance(whole := known[label].stronger or known[label].theorem, Theorem)
        and satisfiable(whole).body not in bodies
    ]
    yield "## Where a part is undefined"
    yield ""
    yield (
        f"The parts of the claims are defined under {total:,} conditions. Coq proves "
        f"{total - remaining:,} of them from the conditions of their claims. The other "
        f"{remaining} are premises of the {len(left)} theorems below, which say nothing about "
        "points where such a premise fails. For each of these theorems Coq proves that some point "
        "satisfies definitions, conditions and premises together"
        + (f", except {', '.join(f'`{label}`' for label in without)}." if without else ".")
    )
    yield ""
    yield "| claim | premises |"
    yield "|---|---|"
    for label, parts in left.items():
        yield f"| `{label}` | {', '.join(f'`{part}`' for part in parts)} |"
    yield ""


def _vocabulary(known: dict[str, Entry]) -> Iterator[str]:
    """The definitions that statements use, with their meaning."""
    said = " ".join(e.theorem.body for e in known.values() if isinstance(e.theorem, Theorem))
    words = set(re.findall(r"[A-Za-z_][\w']*", said))
    yield "## The language of the statements"
    yield ""
    yield "Statements use these functions and relations, and nothing else beside arithmetic:"
    yield ""
    yield "| name | meaning | where it is defined |"
    yield "|---|---|---|"
    for name, (meaning, place) in LIBRARY.items():
        if name in words:
            yield f"| `{name}` | {meaning} | {place} |"
    yield ""
    yield "tresym defines those that Coq and Coquelicot lack:"
    yield ""
    yield "```coq"
    for definition in re.findall(r"^\(\* .*? \*\)\nDefinition .*?\.$", prelude(), _LINES):
        if re.search(r"Definition (\w+)", definition)[1] in words:  # type: ignore[index]
            yield definition
    yield "```"
    yield ""


def _made_by() -> Iterator[str]:
    """How much code makes the statements."""
    from tresym.report.pages.trusted_code import trusted

    yield "## The code that makes the statements"
    yield ""
    yield (
        f"{trusted(STATEMENTS):,} lines of Python turn a claim into a statement, among them the "
        "classes of expressions and claims. They are counted by the names that they use, so that "
        "some of them are counted which are never called."
    )
    yield ""


def _reasons(known: dict[str, Entry]) -> Iterator[str]:
    for title, claims in sections():
        yield from (f"## {title}", "", "| claim | Coq | reason |", "|---|---|---|")
        for claim in claims:
            entry = known[claim.label]
            status = {"none": "not proved"}.get(entry.status, entry.status)
            yield f"| `{shown_name(claim.label)}` | {status} | {_cell(entry.why)} |"
        yield ""


def _cell(text: str) -> str:
    return " ".join(text.replace("|", r"\|").split())
