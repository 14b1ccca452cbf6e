"""Decide the entries of the atlas and store what was found: ``python -m tresym.dev.atlas``.

Only entries without a stored answer are decided; with names these too, with ``--again`` all are.
For a claim with O, the supremum of |error|/|gauge| is
estimated at points of the region; the bound is then asked for with a number just above it, the
floor with one just below. Both numbers are printed only because the claims with them are decided,
however they were found.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

from flint import fmpq

from tresym.accuracy.values import certified, placed, read
from tresym.checking.time_limited import Task, check_within
from tresym.entries import reading
from tresym.entries.reading import Decided, Entry, inequality, remainder, written
from tresym.reals.decisions.answer import Answer
from tresym.reals.language.claims import parts_of
from tresym.reals.language.expression import number, symbols
from tresym.reals.language.parsing import parse_given
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import cores

CENTRAL = ("binomial(2*n, n)", "(gamma(2*n + 1)/gamma(n + 1)**2)")
"""How the evaluation at a point, for the estimate alone, reads binomial coefficients."""
LIMIT, SHORTER = 20.0, 5.0
"""Seconds of processor time for a claim, and for a bound with one number."""
SHARP = Fraction(102, 100)
"""By how much the ends of a constant may differ that is quoted without a bound."""
FILE = Path(reading.__file__).parent / "answers.json"


def kept(answer: Answer, claim: str) -> Decided:
    """Return the few words of an answer that are stored."""
    constant = answer.constant
    bounds = None
    if constant is not None:
        mid, rad = Fraction(constant.mid), Fraction(constant.rad)
        bounds = (_rounded(max(mid - rad, Fraction(0)), 4, -1), _rounded(mid + rad, 4, 1))
    witness = ", ".join(f"{name} = {value}" for name, value in (answer.witness or {}).items())
    why = answer.lemma or answer.why.partition("; ")[0]
    if why.startswith("|left| <= C |right|"):
        why = "the constant is enclosed in balls"
    return Decided(
        claim,
        answer.verdict,
        why if len(why) < 160 else why[:150] + " …",
        bounds,
        answer.region or "",
        witness if len(witness) < 120 else "",
        round(answer.seconds, 2),
    )


def _rounded(x: Fraction, digits: int, side: int) -> str:
    """Round a number that is not negative to significant digits, up or down, as a plain decimal."""
    if not x:
        return "0"
    places = digits - 1 - math.floor(math.log10(x))
    scaled = x * Fraction(10) ** places
    whole = math.ceil(scaled) if side > 0 else math.floor(scaled)
    exact = Fraction(whole) / Fraction(10) ** places
    if places <= 0:
        return str(int(exact))
    text = f"{int(exact * 10**places):0{places + 1}d}"
    return f"{text[:-places]}.{text[-places:]}".rstrip("0").rstrip(".")


def ask(claim: str, limit: float = LIMIT) -> Decided:
    """Decide one claim."""
    try:
        return kept(check_within(Task(claim), limit), claim)
    except InputError as error:
        raise SystemExit(f"{claim}: {error}") from None


def supremum(entry: Entry) -> float | None:
    """Estimate the supremum of |error|/|gauge| at points of the region."""
    found = remainder(entry.claim)
    if found is None:
        return None
    error, gauge = (read(part.replace(*CENTRAL)) for part in found)
    names = sorted({n for n in symbols(error) | symbols(gauge) if n != "oo"})
    path = parts_of(entry.claim)[2]
    name = path.split()[0] if path else ""
    if names != [name]:
        return None
    _, given, _, _ = parts_of(entry.claim)
    under = parse_given(", ".join(part for part in (entry.region, given) if part))
    largest = None
    for x in _points(name, under):
        value = number(x)
        try:
            if not all(_holds(link, name, value) for link in under):
                continue
            ratio = placed(error / gauge, {name: value})
            size = abs(float(certified(ratio, 6, 60)))
        except (InputError, ArithmeticError, ValueError, NotImplementedError):
            continue
        largest = size if largest is None else max(largest, size)
    return largest


def _holds(link: Any, name: str, value: Any) -> bool:
    left, sign, right = link
    if sign not in ("<", "<=", ">", ">="):
        return True
    gap = certified(placed(right - left, {name: value}), 6, 60)
    if sign.startswith(">"):
        gap = -gap
    return bool(gap > 0) or (sign.endswith("=") and not bool(gap < 0))


def _points(name: str, under: Any) -> Iterator[fmpq]:
    """Yield integers, if the variable is one, or points at all distances from 0 and the ends."""
    if name in ("n", "k"):
        for n in (*range(1, 9), 10, 12, 16, 20, 30, 50, 100, 200, 400):
            yield fmpq(n)
        return
    steps = [fmpq(round(1000 * 10 ** (k / 12)), 1000) for k in range(-24, 49)]
    nice = [fmpq(k, 8) for k in range(1, 64)]
    tiny = [fmpq(1, 10**k) for k in (3, 4, 5)]
    ends = []
    for side in {side for link in under for side in (link[0], link[2]) if not symbols(side)}:
        end = float(certified(placed(side, {}), 16, 60))
        ends += [
            fmpq(round(end * 10**12), 10**12) + sign * fmpq(1, 10**k)
            for k in (2, 4, 6, 9)
            for sign in (-1, 1)
        ]
    for x in sorted({*steps, *nice, *tiny, *ends}):
        yield x
        yield -x


def _simple(low: float, high: float) -> Fraction:
    """Return the fraction with the smallest denominator between two numbers."""
    for denominator in range(1, 4000):
        above = math.ceil(low * denominator)
        if above <= high * denominator:
            return Fraction(above, denominator)
    return Fraction(high)


def decide(entry: Entry) -> dict[str, Any]:
    """Decide the claim of an entry and its neighbour."""
    parts = {"answer": ask(entry.claim), "neighbour": ask(entry.false)}
    return {name: found.as_json() for name, found in parts.items()}


def bound(entry: Entry) -> dict[str, Any]:
    """Look for the number with which the bound of an entry holds; empty if none is found."""
    if inequality(entry, "1") is None:
        return {}
    try:
        size = supremum(entry)
    except (InputError, ArithmeticError, ValueError):
        return {}
    if not size:
        return {}
    near = _simple(size * (1 - 1e-7), size * 1.0005)
    above = Fraction(_rounded(Fraction(size * 1.004), 4, 1))
    tried = [str(near)] if near.denominator < 100 else []
    for constant in (*tried, _text(above)):
        found = ask(inequality(entry, constant) or "", SHORTER)
        if found.verdict.holds:
            low = _rounded(Fraction(size * 0.992), 4, -1)
            floor = ask(inequality(entry, low) or "", SHORTER)
            return {"bound": found.as_json(), "floor": floor.as_json()}
    return {}


def _text(x: Fraction) -> str:
    return _rounded(x, 6, 1)


def main(words: list[str]) -> None:
    """Decide what has no answer yet, or what is named; then look for bounds that are missing."""
    stored: dict[str, Any] = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    if words == ["--again"]:
        stored = {}
    everything = {entry.name: entry for entry in written()}
    asked = [e for e in everything.values() if _is_new(e, stored) or e.name in words]
    with ProcessPoolExecutor(cores()) as pool:
        for entry, found in zip(asked, pool.map(decide, asked), strict=True):
            stored[entry.name] = found
            print(entry.name, *(part["verdict"] for part in found.values()), flush=True)
            write({name: stored[name] for name in everything if name in stored})
        asked = [e for e in everything.values() if _needs_bound(stored[e.name])]
        for entry, found in zip(asked, pool.map(bound, asked), strict=True):
            stored[entry.name] |= found or {"bound": None}
            print(entry.name, *(part["verdict"] for part in found.values()), flush=True)
            write({name: stored[name] for name in everything})


def _needs_bound(found: dict[str, Any]) -> bool:
    """Whether no bound was looked for, and the answer itself has no sharp constant."""
    low, high = map(Fraction, found["answer"].get("constant", ("0", "1")))
    return "bound" not in found and high > SHARP * low


def _is_new(entry: Entry, stored: dict[str, Any]) -> bool:
    old = stored.get(entry.name)
    texts = (entry.claim, entry.false)
    return old is None or (old["answer"]["claim"], old["neighbour"]["claim"]) != texts


def write(stored: dict[str, Any]) -> None:
    """Write the answers, one entry a line."""
    lines = [
        f"{json.dumps(name)}: {json.dumps(found, ensure_ascii=False)}"
        for name, found in stored.items()
    ]
    aside = FILE.with_suffix(".new")
    aside.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    aside.replace(FILE)


if __name__ == "__main__":
    main(sys.argv[1:])
