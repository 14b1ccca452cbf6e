"""The ledger as files of Coq, one for each part of the proofs, and an index of what is proved.

The proofs that Coq accepted are kept in ``coq.json`` beside the claims, each with a stamp of its
statement: a statement that has changed since is written without a proof, in a comment. A proof
that applies theorems which are not proved has them among its premises, and the claim is proved in
part.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

from tresym.coq.dialogue import Dialogue, prelude
from tresym.coq.ledger import Joint, name_of, stamp, stem, theorem_of
from tresym.coq.proving import Plan, candidates, plans
from tresym.coq.search import version
from tresym.coq.statement import NotExportedError, Theorem
from tresym.ledger.claim import Claim
from tresym.ledger.paper import all_claims, file_of
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError

STORE = "coq.json"
MOST, AT_ONCE, SECONDS = 8, 30, 900.0
MAKEFILE = """all: Makefile.coq
\t$(MAKE) -f Makefile.coq

Makefile.coq: _CoqProject
\tcoq_makefile -f _CoqProject -o Makefile.coq

.PHONY: all
"""


class Entry(NamedTuple):
    """What Coq has of a claim.

    Attributes:
        theorem: its statement, None where its kind is not exported yet.
        proof: lemmas and a script that Coq accepted, None where there is none.
        premises: labels of the claims whose theorems it applies and that are not proved.
        why: what is missing.
    """

    theorem: Theorem | Joint | None
    lemmas: str
    script: str | None
    premises: tuple[str, ...]
    why: str

    @property
    def status(self) -> str:
        """``proved``, ``partial`` where a premise is not proved, or ``none``."""
        return "none" if self.script is None else "partial" if self.premises else "proved"


def stored() -> dict[str, Any]:
    """The proofs that Coq accepted."""
    path = file_of(STORE)
    if not path.is_file():
        return {"coq": "", "claims": {}}
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def entries(store: Mapping[str, Any]) -> dict[str, Entry]:
    """The theorems of all claims with the proofs that are stored for these very statements."""
    found: dict[str, Entry] = {}
    for claim in all_claims():
        try:
            whole = theorem_of(claim)
        except NotExportedError as error:
            found[claim.label] = Entry(None, "", None, (), str(error))
            continue
        missing = [part.label for part in whole.parts] if isinstance(whole, Joint) else []
        missing = [label for label in missing if label in found and not found[label].theorem]
        if missing:
            why = f"{missing[0]} is not exported: {found[missing[0]].why}"
            found[claim.label] = Entry(None, "", None, (), why)
            continue
        kept = store["claims"].get(claim.label)
        if kept is None or kept["statement"] != stamp(whole):
            why = "no proof is stored for this statement"
            found[claim.label] = Entry(whole, "", None, (), why)
            continue
        open_ = tuple(used for used in kept["uses"] if found[used].status != "proved")
        if any(found[used].theorem is None for used in open_):
            found[claim.label] = Entry(
                whole, "", None, (), "its proof applies what is not exported"
            )
            continue
        why = f"{', '.join(open_)} not proved" if open_ else ""
        found[claim.label] = Entry(whole, kept["lemmas"], kept["script"], open_, why)
    return found


class Memory:
    """What Coq said before of these very texts, kept in a file: a search can be taken up again."""

    def __init__(self, path: Path | None) -> None:
        self.path = path
        self.known: dict[str, bool] = {}
        self.coq: Dialogue | None = None
        self.count = 0
        if path is not None and path.is_file():
            self.known = json.loads(path.read_text(encoding="utf-8"))

    def ask(self, texts: Mapping[str, str]) -> dict[str, bool]:
        """Of each text, by name, whether Coq accepts it."""
        keys = {name: _hash(text) for name, text in texts.items()}
        losing = _hash(prelude())
        known = {}
        for name, key in keys.items():
            if key in self.known:
                known[name] = True
            elif losing + key in self.known:
                known[name] = False
        todo = [name for name in texts if name not in known]
        self.coq = self.coq or Dialogue()
        for name in todo:
            self.count += 1
            ok = self.coq.accepts(texts[name].replace("@", str(self.count)))
            known[name] = ok
            self.known[keys[name] if ok else losing + keys[name]] = ok
        if self.path is not None and todo:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self.path.write_text(json.dumps(self.known), encoding="utf-8")
        return known


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:20]


def search(
    claims: Iterable[Claim],
    say: Callable[[str], object] = lambda _: None,
    memory: Memory | None = None,
) -> dict[str, Any]:
    """Find proofs anew, by asking Coq."""
    memory = memory or Memory(None)
    todo: dict[str, tuple[Theorem | Joint, list[Plan]]] = {}
    for claim in claims:
        try:
            whole = theorem_of(claim)
            whole.text  # noqa: B018
            todo[claim.label] = (whole, list(plans(claim, whole)))
        except NotExportedError:
            continue
    kept: dict[str, Any] = {}
    for n in range(2):
        rest = {k: (t, p[n]) for k, (t, p) in todo.items() if len(p) > n and k not in kept}
        proved = lemmas_proved(
            [lemma for _, plan in rest.values() for lemma in plan.lemmas], memory, say
        )
        ready = {
            label: (whole, plan)
            for label, (whole, plan) in rest.items()
            if all(lemma.body in proved for lemma in plan.lemmas)
        }
        texts = {label: _trial(whole, plan, todo) for label, (whole, plan) in ready.items()}
        held = memory.ask({label: text for label, text in texts.items() if text is not None})
        for label, ok in held.items():
            if ok:
                whole, plan = ready[label]
                kept[label] = {
                    "statement": stamp(whole),
                    "lemmas": "\n".join(
                        f"{lemma.text}\nProof.\n{proved[lemma.body]}\nQed." for lemma in plan.lemmas
                    ),
                    "script": plan.script,
                    "uses": list(plan.uses),
                }
        say(f"plan {n + 1}: {len(rest)} claims, {len(ready)} of all lemmas, {len(kept)} kept")
    return {"coq": version(), "claims": kept}


def lemmas_proved(
    lemmas: Iterable[Theorem], memory: Memory, say: Callable[[str], object]
) -> dict[str, str]:
    """The proofs of lemmas, by their statements."""
    jobs: dict[str, tuple[Theorem, list[str]]] = {}
    for lemma in lemmas:
        try:
            lemma.text  # noqa: B018
            jobs.setdefault(lemma.body, (lemma, list(candidates(lemma))[:MOST]))
        except (InputError, OverflowError, RecursionError, NotExportedError):
            continue  # an expression on the way grew too large
    won: dict[str, str] = {}
    bodies = list(jobs)
    for start in range(0, len(bodies), AT_ONCE):
        some = bodies[start : start + AT_ONCE]
        for n in range(MOST):
            open_ = {b: jobs[b][1][n] for b in some if b not in won and len(jobs[b][1]) > n}
            texts = {
                b: f"Theorem trial_@ :\n{b}.\nProof.\n{proof}\nQed." for b, proof in open_.items()
            }
            won |= {b: open_[b] for b, ok in memory.ask(texts).items() if ok}
        say(f"{len(won)} of {min(start + AT_ONCE, len(bodies))} lemmas of {len(bodies)}")
    return won


def _trial(
    whole: Theorem | Joint, plan: Plan, known: Mapping[str, tuple[Theorem | Joint, list[Plan]]]
) -> str | None:
    """The claim's theorem with its lemmas, and the theorems that it applies, as premises."""
    lines = ["Module Trial_@.", "Section Trial."]
    spoken: dict[str, None] = {}
    stack = [*plan.uses]
    while stack:
        label = stack.pop()
        if label not in known:
            return None
        spoken.pop(label, None)
        spoken[label] = None
        told = known[label][0]
        if isinstance(told, Joint):
            stack += [part.label for part in told.parts]
    for label in reversed(spoken):
        lines.append(f"Definition says_{stem(label)} : Prop :=\n{known[label][0].body}.")
    lines += [f"Hypothesis {name_of(label)} : says_{stem(label)}." for label in plan.uses]
    lines += [f"Hypothesis {lemma.name} :\n{lemma.body}." for lemma in plan.lemmas]
    lines += [f"Theorem trial :\n{whole.body}.\nProof.\n{plan.script}\nQed.", "End Trial."]
    lines += ["End Trial_@.", "Definition trial_@ := Trial_@.trial."]
    return "\n".join(lines)


def save(store: Mapping[str, Any]) -> None:
    """Keep the proofs beside the claims."""
    write_text(str(file_of(STORE)), json.dumps(store, indent=0, ensure_ascii=False) + "\n")
