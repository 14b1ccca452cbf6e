"""How much of the collections Coq accepts: ``python tests/coq/coverage.py [KIND ...]``.

Of the claims that are PROVED some are drawn at random, by a seed that is fixed: inequalities,
antiderivatives, and rewritings whose sides are not the same text. For each kind it is counted how
many Coq accepts; coverage.json beside this file holds what the last run counted, and what failed.
"""

import json
import sys
import time
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from random import Random

import tresym
from tresym.coq.candidate_search import found_by
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import Dialogue
from tresym.coq.statement import NotExportedError
from tresym.dev.corpus.lists import known, pairs
from tresym.dev.corpus.rewriting import true_identity
from tresym.output import write_text
from tresym.reals.decisions.claim_parsing import read

STORE = Path(__file__).with_name("coverage.json")
SEED, EACH, SECONDS = 2027, 60, 60.0


def inequalities(random: Random) -> list[str]:
    """Inequalities that are true."""
    claims = [k.claim for k in known("inequalities") if k.truth]
    random.shuffle(claims)
    return claims


def antiderivatives(random: Random) -> list[str]:
    """Antiderivatives."""
    claims = [pair.claim for pair in pairs()]
    random.shuffle(claims)
    return claims


def rewritings(random: Random) -> list[str]:
    """Two rewritings of one expression."""
    found = (true_identity(random) for _ in range(20 * EACH))
    return list(islice((f"{x} == {y}" for x, y in found if str(x) != str(y)), 2 * EACH))


KINDS: dict[str, Callable[[Random], list[str]]] = {
    f.__name__: f for f in (inequalities, antiderivatives, rewritings)
}


def sample(kind: str, seed: int = SEED) -> list[str]:
    """Claims of one kind that are PROVED."""
    claims = KINDS[kind](Random(seed))
    return list(islice((c for c in claims if tresym.check(c).verdict.name == "PROVED"), EACH))


def accepted(claim: str, coq: Dialogue, seconds: float = SECONDS) -> str:
    """What Coq says of a claim: ``accepted``, or why it is not."""
    try:
        asked = theorems(read(claim))
    except NotExportedError as error:
        return str(error)
    deadline = time.monotonic() + seconds
    for theorem in asked:
        if found_by(theorem, coq, deadline) is None:
            return "no proof was found"
    return "accepted"


def main() -> None:
    """Count, and keep what was counted."""
    kept = json.loads(STORE.read_text(encoding="utf-8")) if STORE.is_file() else {}
    for kind in sys.argv[1:] or KINDS:
        failed, count = {}, 0
        with Dialogue() as coq:
            for claim in sample(kind):
                start = time.perf_counter()
                said = accepted(claim, coq)
                took = time.perf_counter() - start
                print(f"{kind} {took:5.1f} s  {said}  {claim}", flush=True)
                count += 1
                if said != "accepted":
                    failed[claim] = said
        kept[kind] = {
            "accepted": count - len(failed),
            "of": count,
            "seed": SEED,
            "seconds": SECONDS,
            "failed": failed,
        }
        print(f"{kind}: {count - len(failed)} of {count}", flush=True)
        write_text(STORE, json.dumps(kept, indent=1, sort_keys=True) + "\n")


if __name__ == "__main__":
    main()
