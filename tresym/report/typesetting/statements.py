"""Quote a claim: its sentence or formula, always with its conditions.

For a conjunction the conditions that all parts share are listed once, and then, with the names of
the parts, those that only some parts have. Pages, article and terminal all take the text from here,
each in its own format.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from tresym.ledger.claim import AllOf, Claim, asked_by, jointly
from tresym.ledger.formulas import parts_of
from tresym.report.typesetting.conditions import gathered
from tresym.report.typesetting.finding_text import readable
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.latex import says_latex
from tresym.report.typesetting.markdown import scripted, sentence
from tresym.report.typesetting.plain_text import plain, script
from tresym.report.typesetting.titles import title

LONGEST_IN_A_LINE = 60
"""A system of more LaTeX characters is typeset with one equation below the other."""
LONGEST_IN_A_LIST = 220
"""A formula of more LaTeX characters is introduced by the title of its claim."""
MOST_PARTS = 3
"""Most sets of conditions that are listed without naming their parts."""
MOST_LETTERS = 30
"""The width of such a condition in letters; longer ones make sense only with their part."""
EACH_ITS_OWN = "Each part holds under its own hypotheses."


class Part(NamedTuple):
    """Conditions in LaTeX that only some parts of a conjunction have, and these parts' labels."""

    given: tuple[str, ...]
    labels: tuple[str, ...]


class Said(NamedTuple):
    """A claim as it is quoted; formulas are LaTeX."""

    says: str | None
    """The sentence, or None if the claim is a formula."""
    formula: str | None
    """The formula of the claim, or a formula shown beside its sentence."""
    given: tuple[str, ...]
    parts: tuple[Part, ...] = ()
    where: str = ""
    """The region where it holds, in words, if no condition gives it."""
    means: tuple[str, ...] = ()
    """The formulas that are decided for a sentence, unless it is a conjunction."""

    def as_record(self) -> dict[str, Any]:
        """Return it as JSON data for the saved ledger."""
        return self._asdict() | {"parts": [part._asdict() for part in self.parts]}


def said(claim: Claim) -> Said:
    """Return the statement of a claim with its conditions."""
    in_words = isinstance(claim.says, str)
    formula = claim.shown or (None if in_words else _joined(claim) or says_latex(claim.says))
    given, parts = _of_parts(claim) if not claim.given else (tuple(gathered(claim.given)), ())
    region = "" if given or parts else getattr(claim.proof, "region", "")
    says = str(claim.says) if in_words else None
    return Said(says, formula, given, parts, region, _meant(claim) if in_words else ())


def _joined(claim: Claim) -> str | None:
    """The formulas of the parts of a conjunction, whose conditions are listed beside them."""
    proof = claim.proof
    if not isinstance(proof, AllOf) or any(p.statement is None for p in proof.claims):
        return None
    whole = jointly(*proof.claims)
    if claim.says != whole["says"] or claim.given != whole.get("given", ()):
        return None
    quoted = [(part, said(part)) for part in proof.claims]
    return r",\quad ".join(q.formula or says_latex(part.statement or "") for part, q in quoted)


def _meant(claim: Claim) -> tuple[str, ...]:
    """The formulas that stand for a sentence."""
    if claim.statement is None or isinstance(claim.proof, AllOf):
        return ()
    return tuple(map(says_latex, parts_of(claim.statement)))


def of_record(record: dict[str, Any]) -> Said:
    """Return a statement from the data that :meth:`Said.as_record` made."""
    parts = (Part(tuple(p["given"]), tuple(p["labels"])) for p in record["parts"])
    given, where = tuple(record["given"]), record["where"]
    means = tuple(record["means"])
    return Said(record["says"], record["formula"], given, tuple(parts), where, means)


def _of_parts(claim: Claim) -> tuple[tuple[str, ...], tuple[Part, ...]]:
    """The conditions that all parts of a conjunction share, and the others with their parts."""
    asked = {label: gathered(given) for label, given in asked_by(claim).items()}
    if not isinstance(claim.proof, AllOf) or not asked:
        return (), ()
    shared = [c for c in next(iter(asked.values())) if all(c in given for given in asked.values())]
    rest: dict[tuple[str, ...], list[str]] = {}
    for label, given in asked.items():
        own = tuple(c for c in given if c not in shared)
        if own:
            rest.setdefault(own, []).append(label)
    return tuple(shared), tuple(Part(own, tuple(labels)) for own, labels in rest.items())


def conditions(
    found: Said,
    formula: Callable[[str], str],
    words: Callable[[str], str] = str,
    name: Callable[[str], str] | None = None,
) -> str:
    """Return the conditions as a sentence: ``Given a > 0; for eq_Euler also: 0 < θ < π.``

    Args:
        found: the claim.
        formula: converts a LaTeX formula.
        words: converts a sentence.
        name: converts the label of a part. With None, labels are left out, and so are conditions
            that another part has too; for more than a few parts it is only mentioned that they have
            their own conditions.

    Returns:
        An empty text if there are no conditions.
    """
    pieces = [_listed(found.given, formula)] if found.given else []
    ending = ""
    if found.where and found.where not in (found.says or ""):
        where = words(readable(found.where))
        if not set("<>=") & set(found.where):
            return f"For {where}."
        pieces.append(where)
    start = "for some parts also: " if pieces else "part by part: "
    if name is None and found.parts:
        sets = [{*part.given} for part in found.parts]
        widest = [p for p, own in zip(found.parts, sets, strict=True) if not _within(own, sets)]
        short = all(width(c) < MOST_LETTERS for part in widest for c in part.given)
        if len(widest) <= MOST_PARTS and short:
            pieces.append(start + "; ".join(_listed(part.given, formula) for part in widest))
        else:
            ending = "Each part also has its own hypotheses." if pieces else EACH_ITS_OWN
    elif name is not None:
        also = " also" if pieces else ""
        for part in found.parts:
            names = ", ".join(map(name, part.labels))
            pieces.append(f"for {names}{also}: {_listed(part.given, formula)}")
    return " ".join(filter(None, (f"Given {'; '.join(pieces)}." if pieces else "", ending)))


def _within(own: set[str], sets: list[set[str]]) -> bool:
    return any(own < other for other in sets)


def _listed(given: tuple[str, ...], formula: Callable[[str], str]) -> str:
    return ", ".join(map(formula, given))


def quoted(claim: Claim) -> str:
    """Return a claim as text within a line of Markdown."""
    return in_line(said(claim), title(claim.label))


def in_line(found: Said, name: str) -> str:
    """Return a statement within a line of Markdown; ``name``, if any, introduces a long formula."""
    if found.says:
        text = sentence(found.says)
    else:
        formula = f"{in_dollars(found.formula or '')}."
        named = name and len(formula) > LONGEST_IN_A_LIST
        text = f"{sentence(name)}: {formula}" if named else formula
    return " ".join(filter(None, (text, conditions(found, in_dollars, sentence))))


def on_lines(found: Said) -> str:
    """Return a statement in Markdown, with its formula on a line of its own."""
    return "\n\n".join(filter(None, (*stated(found), conditions(found, in_dollars, sentence))))


def stated(found: Said) -> Iterator[str]:
    """Yield the sentence and the formula in Markdown; the caller must add the conditions."""
    if found.says:
        yield sentence(found.says)
    if found.formula:
        yield display(found.formula)


def in_plain_text(found: Said) -> str:
    """Return a statement as plain text, for a terminal."""
    text = scripted(found.says, str, script) if found.says else f"{plain(found.formula or '')}."
    return " ".join(filter(None, (text, conditions(found, plain))))


def in_letters(text: str) -> str:
    """Return a finding as plain text, for a terminal."""
    return scripted(readable(text), str, script)


def in_dollars(formula: str) -> str:
    """Return a formula within a line of Markdown; the parts of a system follow each other."""
    parts = formula.replace("|", r"\vert ").split(r",\quad ")
    return ", ".join(f"${part.strip()}$" for part in parts)


def display(formula: str) -> str:
    """Return a displayed formula; a long system has a line for each of its parts."""
    formula = formula.strip()
    if len(formula) > LONGEST_IN_A_LINE:
        for joint in (r",\quad ", r" \iff "):
            parts = formula.split(joint)
            if len(parts) > 1 and r"\begin" not in formula:
                mark = r"\iff\quad " if "iff" in joint else ""
                lines = rf" \\ {mark}".join(parts)
                return f"$$\n\\begin{{gathered}}{lines}\\end{{gathered}}\n$$"
    return f"$$\n{formula}\n$$"
