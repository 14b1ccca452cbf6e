"""The ledger as files of Coq, one for each part of the proofs, and an index of what is proved.

The proofs that Coq accepted are kept in ``coq.json`` beside the claims, each with a stamp of its
statement: a statement that has changed since is written without a proof, in a comment. A proof
that applies theorems which are not proved has them among its premises, and the claim is proved in
part.
"""

from __future__ import annotations

import json
import math
import re
import signal
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from hashlib import sha256
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

from tresym.coq.dialogue import HEAD, TEXT_SECONDS, Dialogue, prelude
from tresym.coq.ledger import Joint, conditions_of, name_of, stamp, stem, theorem_of
from tresym.coq.numbers import numbers
from tresym.coq.proving import Plan, candidates, plans
from tresym.coq.search import assumptions, version
from tresym.coq.statement import NotExportedError, Theorem, comparison, term, variable
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.meaning import known
from tresym.ledger.paper import PAPER, all_claims, file_of, sections
from tresym.output import write_text
from tresym.reals.language.expression import number, symbols
from tresym.reals.numbers.exact import InputError

STORE = "coq.json"
_AND = " /\\ "
UNWRITTEN = ArithmeticError, AttributeError, RecursionError, TypeError, ValueError, NotExportedError
MOST, WRITING_SECONDS, CLAIM_SECONDS = 6, 1.5, 30
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


def entries(store: Mapping[str, Any], wanted: Iterable[str] | None = None) -> dict[str, Entry]:
    """The theorems of claims with the proofs that are stored for these very statements.

    Those that are applied are among them, and with nothing wanted all.
    """
    found: dict[str, Entry] = {}
    claims = {claim.label: claim for claim in all_claims()}
    needed, stack = set(), [*(claims if wanted is None else wanted)]
    while stack:
        label = stack.pop()
        if label in claims and label not in needed:
            needed.add(label)
            proof = claims[label].proof
            stack += store["claims"].get(label, {}).get("uses", ())
            stack += [part.label for part in proof.claims] if isinstance(proof, AllOf) else []
    for claim in (c for label, c in claims.items() if label in needed):
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
        if isinstance(whole, Joint) and len(open_) == len(whole.parts):
            found[claim.label] = Entry(whole, "", None, (), "none of its parts is proved")
            continue
        why = f"{', '.join(open_)} not proved" if open_ else ""
        found[claim.label] = Entry(whole, kept["lemmas"], kept["script"], open_, why)
    return found


class Memory:
    """What Coq said before of these very texts, kept in a file: a search can be taken up again."""

    def __init__(self, path: Path | None, seconds: float = TEXT_SECONDS, most: int = MOST) -> None:
        self.path = path
        self.seconds, self.most, self.until = seconds, most, math.inf
        self.known: dict[str, bool | str] = {}
        self.coq: Dialogue | None = None
        self.count = 0
        if path is not None and path.is_file():
            self.known = json.loads(path.read_text(encoding="utf-8"))

    def longer(self) -> None:
        """Give whole claims the time that lemmas are not worth."""
        if self.coq is not None:
            self.coq.end()
        self.coq, self.seconds = Dialogue(CLAIM_SECONDS), 4.0 * CLAIM_SECONDS

    @property
    def is_over(self) -> bool:
        """Whether the time for lemmas is over."""
        return time.monotonic() > self.until

    def ask(self, texts: Mapping[str, str]) -> dict[str, bool]:
        """Of each text, by name, whether Coq accepts it."""
        keys = {name: _hash(text) for name, text in texts.items()}
        losing = _hash(f"{prelude()}{self.seconds}")
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
            ok = self.coq.accepts(texts[name].replace("@", str(self.count)), self.seconds)
            known[name] = ok
            self.known[keys[name] if ok else losing + keys[name]] = ok
        return known

    def keep(self) -> None:
        """Write it down."""
        if self.path is not None:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self.path.write_text(json.dumps(self.known), encoding="utf-8")


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:20]


def search(
    claims: Sequence[Claim],
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
    every = [lemma for _, options in todo.values() for plan in options for lemma in plan.lemmas]
    every.sort(key=lambda lemma: lemma.relation == "==")
    proved = lemmas_proved(every, memory, say)
    memory.longer()
    kept: dict[str, Any] = {}
    for label, (whole, options) in todo.items():
        for plan in options:
            text = _trial(whole, plan, todo)
            if text is None or any(lemma.body not in proved for lemma in plan.lemmas):
                continue
            if memory.ask({label: text})[label]:
                kept[label] = _row_of(whole, plan, proved)
                break
    memory.keep()
    say(f"{len(kept)} of {len(todo)} claims")
    return {"coq": version(), "claims": kept, "possible": witnesses(claims, memory)}


def _row_of(whole: Theorem | Joint, plan: Plan, proved: Mapping[str, str]) -> dict[str, Any]:
    """What is stored of a claim."""
    lemmas = (f"{t.text}\nProof.\n{proved[t.body]}\nQed." for t in plan.lemmas)
    return {
        "statement": stamp(whole),
        "lemmas": "\n".join(lemmas),
        "script": plan.script,
        "uses": list(plan.uses),
    }


def witnesses(claims: Iterable[Claim], memory: Memory) -> dict[str, Any]:
    """A point for each set of conditions, and the proof that they hold there."""
    found: dict[str, Any] = {}
    for claim in claims:
        try:
            given = tuple(conditions_of(claim.given))
        except InputError:
            continue
        if any(c.sign == "==" for c in given):
            continue  # the point is given
        names = sorted(frozenset().union(*(symbols(c.left) | symbols(c.right) for c in given)))
        body = " /\\\n".join(f"  {comparison(*c)}" for c in given)
        body = f"  exists {' '.join(map(variable, names))} : R,\n{body}"
        key = _hash(body)
        if not names or key in found:
            continue
        point = known(given).satisfying_point()
        if point is None:
            continue
        script = f"exists {', '.join(f'({term(number(point[name]))})' for name in names)}. "
        script += "repeat split; numeric."
        if memory.ask({key: f"Theorem trial_@ :\n{body}.\nProof.\n{script}\nQed."})[key]:
            found[key] = {"name": f"possible_{len(found) + 1}", "body": body, "script": script}
    return found


def _found_soon(proofs: Iterator[str]) -> Iterator[str]:
    """The proofs that are written in a few seconds of the processor each."""

    def late(*_: object) -> None:
        raise OverflowError("a proof takes too long to write")

    before = signal.signal(signal.SIGVTALRM, late)
    try:
        while True:
            signal.setitimer(signal.ITIMER_VIRTUAL, WRITING_SECONDS)
            proof = next(proofs, None)
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            if proof is None:
                return
            yield proof
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def lemmas_proved(
    lemmas: Iterable[Theorem], memory: Memory, say: Callable[[str], object]
) -> dict[str, str]:
    """The proofs of lemmas, by their statements."""
    won: dict[str, str] = {}
    asked: dict[str, None] = {}
    for lemma in lemmas:
        try:
            body = lemma.body
            if body in asked:
                continue
            asked[body] = None
            key = "lemma " + _hash(body)
            lost = f"{key} {memory.seconds} {memory.most} {_hash(prelude())}"
            if key in memory.known:
                won[body] = str(memory.known[key])
            if key in memory.known or lost in memory.known or memory.is_over:
                continue
            for proof in islice(_found_soon(candidates(lemma)), memory.most):
                text = f"Theorem trial_@ :\n{body}.\nProof.\n{proof}\nQed."
                if memory.ask({body: text})[body]:
                    won[body] = memory.known[key] = proof
                    break
            else:
                memory.known[lost] = False
        except (
            ArithmeticError,
            AttributeError,
            RecursionError,
            TypeError,
            ValueError,
            NotExportedError,
        ):
            continue  # an expression on the way grew too large
        if len(asked) % 10 == 0:
            memory.keep()
            say(f"{len(won)} of {len(asked)} lemmas; last {lemma.name}")
    memory.keep()
    return won


def _trial(
    whole: Theorem | Joint, plan: Plan, known: Mapping[str, tuple[Theorem | Joint, list[Plan]]]
) -> str | None:
    """The claim's theorem with its lemmas, and the theorems that it applies, as premises."""

    def whole_of(told: Theorem | Joint) -> str:
        if isinstance(told, Theorem):
            return f"({told.body})"
        return f"({_AND.join(whole_of(known[part.label][0]) for part in told.parts)})"

    try:
        used = [whole_of(known[label][0]) for label in plan.uses]
        says = whole_of(whole)
    except KeyError:
        return None
    premises = [*used, *(f"({lemma.body})" for lemma in plan.lemmas)]
    names = [*map(name_of, plan.uses), *(lemma.name for lemma in plan.lemmas)]
    lines = ["Theorem trial_@ :", " ->\n".join([*premises, says]) + ".", "Proof."]
    lines += [f"intros {' '.join(names)}."] if names else []
    return "\n".join([*lines, plan.script, "Qed."])


def save(store: Mapping[str, Any]) -> None:
    """Keep the proofs beside the claims."""
    write_text(str(file_of(STORE)), json.dumps(store, indent=0, ensure_ascii=False) + "\n")


def write(folder: Path, labels: Iterable[str], store: Mapping[str, Any]) -> dict[str, Any]:
    """Write the files into ``folder``; returns the index.

    ``Statements.v`` holds what the claims say, the files of the parts their proofs, each from the
    theorems that it applies, and ``Ledger.v`` puts these together.

    Raises:
        InputError: an unknown label, or a folder that cannot be written.
    """
    wanted = set(labels)
    claims = {claim.label: claim for claim in all_claims()}
    if wanted - claims.keys():
        raise InputError(f"no claim is called {', '.join(sorted(wanted - claims.keys()))}")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be made ({error.strerror})") from None
    found = entries(store)
    wanted = _behind(wanted, found, store) if wanted else set(claims)
    chosen = {label: e for label, e in found.items() if label in wanted}
    files = {
        "Tresym.v": prelude(),
        "Statements.v": statements(chosen),
        "Numbers.v": numbers(),
        "Possible.v": possible(store),
    }
    names = dict.fromkeys(chosen, "")
    for part, (title, stated) in zip(_parts(), sections(), strict=True):
        name = part.title().replace("_", "") + ".v"
        texts = [_text(c.label, chosen[c.label], store) for c in stated if c.label in chosen]
        if any(texts):
            files[name] = f"(* {title} *)\n\n{HEAD}Require Import Statements.\n\n" + "\n".join(
                texts
            )
        names |= {claim.label: name for claim in stated if claim.label in chosen}
    parts = [name.removesuffix(".v") for name in files if name != "Tresym.v"]
    files["Ledger.v"] = closed(chosen, parts, store)
    files["_CoqProject"] = "\n".join(['-Q . ""', *(n for n in files if n.endswith(".v"))]) + "\n"
    files["Makefile"] = MAKEFILE
    index = {label: _row(label, e, names[label], store) for label, e in chosen.items()}
    files["index.json"] = json.dumps(index, indent=1, ensure_ascii=False) + "\n"
    for name, text in files.items():
        write_text(str(folder / name), text)
    return index


def _parts() -> tuple[str, ...]:
    found: tuple[str, ...] = import_module(PAPER).PARTS
    return found


def _behind(wanted: set[str], found: Mapping[str, Entry], store: Mapping[str, Any]) -> set[str]:
    """The claims and all whose theorems they apply or speak of."""
    whole, stack = set(), [*wanted]
    while stack:
        label = stack.pop()
        if label not in whole:
            whole.add(label)
            entry = found[label]
            stack += store["claims"].get(label, {}).get("uses", ()) if entry.script else ()
            if isinstance(entry.theorem, Joint):
                stack += [part.label for part in entry.theorem.parts]
    return whole


def statements(chosen: Mapping[str, Entry]) -> str:
    """What every claim says, proved or not."""
    lines = [f"(* What the claims say. *)\n\n{HEAD}"]
    for label, entry in chosen.items():
        if entry.theorem is not None:
            lines.append(f"Definition says_{stem(label)} : Prop :=\n{entry.theorem.body}.\n")
    return "\n".join(lines)


def _text(label: str, entry: Entry, store: Mapping[str, Any]) -> str:
    """The lemmas of a claim, and its theorem from those that it applies."""
    if entry.script is None:
        return ""
    uses = store["claims"][label]["uses"]
    says = " -> ".join(f"says_{stem(name)}" for name in (*uses, label))
    taken = f"intros {' '.join(map(name_of, uses))}.\n" if uses else ""
    unfold = "" if isinstance(entry.theorem, Joint) else f"unfold says_{stem(label)}.\n"
    name = f"from_{stem(label)}" if uses else name_of(label)
    lemmas = f"{entry.lemmas}\n" if entry.lemmas else ""
    return f"{lemmas}Theorem {name} :\n  {says}.\nProof.\n{taken}{unfold}{entry.script}\nQed.\n"


def closed(chosen: Mapping[str, Entry], parts: Iterable[str], store: Mapping[str, Any]) -> str:
    """The theorems whose premises are all proved, put together, and what each rests on."""
    lines = [f"(* The theorems put together. *)\n\n{HEAD}Require Import {' '.join(parts)}.\n"]
    for label, entry in chosen.items():
        if entry.script is None:
            continue
        uses = store["claims"][label]["uses"]
        if uses and not entry.premises:
            whole = " ".join([f"from_{stem(label)}", *map(name_of, uses)])
            lines.append(
                f"Theorem {name_of(label)} : says_{stem(label)}.\nProof.\nexact ({whole}).\nQed."
            )
        lines.append(f"Print Assumptions {_theorem(label, entry)}.")
    return "\n".join(lines) + "\n"


def assumed(folder: Path, said: str) -> dict[str, str]:
    """What each theorem rests on, by name, from what Coq printed when it read Ledger.v."""
    asked = re.findall(
        r"^Print Assumptions (\w+)\.", (folder / "Ledger.v").read_text(), re.MULTILINE
    )
    blocks = re.split(r"^(?=Axioms:|Closed under)", said, flags=re.MULTILINE)[1:]
    blocks = blocks[-len(asked) :]  # Ledger.v is read last
    if len(asked) != len(blocks):
        raise InputError(f"Coq says of {len(blocks)} theorems what they rest on, not {len(asked)}")
    return {name: assumptions(block) for name, block in zip(asked, blocks, strict=True)}


def _theorem(label: str, entry: Entry) -> str:
    return f"from_{stem(label)}" if entry.premises else name_of(label)


def possible(store: Mapping[str, Any]) -> str:
    """A point for each set of conditions, so that nothing is said of no point."""
    lines = [f"(* Points at which the conditions of the claims hold. *)\n\n{HEAD}"]
    for row in store.get("possible", {}).values():
        lines.append(f"Theorem {row['name']} :\n{row['body']}.\nProof.\n{row['script']}\nQed.\n")
    return "\n".join(lines)


def _row(label: str, entry: Entry, file: str, store: Mapping[str, Any]) -> dict[str, Any]:
    """The claim in the index."""
    told = entry.theorem
    return {
        "file": file if entry.script else "",
        "theorem": None if told is None else told.name,
        "statement": None if told is None else stamp(told),
        "status": entry.status,
        "premises": list(entry.premises),
        "assumptions": store["claims"][label].get("assumptions") if entry.script else None,
        "why": entry.why,
    }
