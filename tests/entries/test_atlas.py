"""The atlas: its entries are decided as stored, hold at points of mpmath, and are found by words.

A seeded sample of entries is decided in every run, and all of them at night.
"""

import json
import random
import re
from pathlib import Path

import pytest
from in_mpmath import HOLDS, is_true_at_points, value

import tresym
from tresym.commands import main
from tresym.entries.lookup import atlas, found, related
from tresym.entries.reading import (
    Decided,
    Entry,
    answers,
    entries,
    number_of,
    remainder,
    sides,
    written,
)
from tresym.reals.language.claims import parts_of
from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.numbers.arithmetic import mp_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

ENTRIES = entries()
UNKNOWN = ("factorial", "binomial", "sum(", "product(", "integral(", "diff(", "(n)", "lambertw")
"""What the reference by mpmath does not evaluate, or not on all of its domain."""


def decided(entry: Entry) -> list[Decided]:
    parts = (entry.answer, entry.neighbour, entry.bound, entry.floor)
    return [part for part in parts if part is not None]


def seconds(entry: Entry) -> float:
    return sum(part.seconds for part in decided(entry))


QUICK = sorted(ENTRIES, key=seconds)[: len(ENTRIES) // 2]
SAMPLE = random.Random(20).sample(QUICK, 12)
REST = [entry for entry in ENTRIES if entry not in SAMPLE]


def again(entry: Entry) -> None:
    """Decide all claims of an entry, and compare with what is stored."""
    for part in decided(entry):
        answer = tresym.check(part.claim, suggest=False)
        assert answer.verdict.holds == part.verdict.holds, part.claim
        assert (answer.verdict is Verdict.REFUTED) == (part.verdict is Verdict.REFUTED), part.claim
        if part.constant and answer.constant:
            low, high = map(float, part.constant)
            middle, radius = float(answer.constant.mid), float(answer.constant.rad)
            assert middle - radius <= high * 1.02, part.claim
            assert middle + radius >= low * 0.98, part.claim


@pytest.mark.slow
@pytest.mark.parametrize("entry", SAMPLE, ids=lambda entry: entry.name)
def test_an_entry_is_decided_as_stored(entry: Entry) -> None:
    again(entry)


@pytest.mark.night
@pytest.mark.parametrize("entry", REST, ids=lambda entry: entry.name)
def test_every_entry_is_decided_as_stored(entry: Entry) -> None:
    again(entry)


AT_POINTS = [
    part.claim
    for entry in ENTRIES
    for part in (entry.answer, entry.bound)
    if part and " as " not in part.claim and not any(word in part.claim for word in UNKNOWN)
]


@pytest.mark.slow
def test_inequalities_hold_at_points() -> None:
    """By mpmath: a few of them, each at a few points."""
    for claim in random.Random(20).sample(AT_POINTS, 40):
        assert is_true_at_points(claim, 60), claim


@pytest.mark.night
@pytest.mark.parametrize("claim", AT_POINTS)
def test_every_inequality_holds_at_points(claim: str) -> None:
    assert is_true_at_points(claim, 100), claim


SHARP = [
    entry
    for entry in ENTRIES
    if entry.constant and not any(word in entry.claim for word in (*UNKNOWN, "root(", " n "))
]


def largest_ratio(entry: Entry) -> float:
    """The largest |error|/|gauge| by mpmath alone, at points of the region on many scales."""
    found, parts = remainder(entry.claim), sides(entry.claim)
    assert found is not None
    assert parts is not None
    error, gauge, exact = map(parse, (*found, parts[0]))
    _, given, _, _ = parts_of(entry.claim)
    conditions = list(parse_given(", ".join(filter(None, (entry.region, given)))))
    (name,) = symbols(error) | symbols(gauge)
    sizes = [10 ** (k / 40) for k in range(-120, 101)] + [k / 100 for k in range(1, 400)]
    sizes += [end * (1 - 10**-k) for end in (0.5, 1) for k in range(3, 14)]
    best = 0.0
    with mp_precision(50) as m:
        for x in [*sizes, *(-size for size in sizes), m.pi, m.pi / 2, m.pi / 4]:
            at = {name: m.mpf(x)}
            try:
                if not all(HOLDS[r](value(m, a, at), value(m, b, at), 0) for a, r, b in conditions):
                    continue
                missed = abs(value(m, error, at))
                if missed < m.mpf(10) ** -35 * abs(value(m, exact, at)):
                    continue  # too few digits are left
                ratio = missed / abs(value(m, gauge, at))
            except (ValueError, ZeroDivisionError, OverflowError, TypeError, m.NoConvergence):
                continue
            if not isinstance(ratio, m.mpc):
                best = max(best, float(ratio))
    return best


def encloses(entry: Entry) -> None:
    assert entry.constant is not None
    low, high = map(_number, entry.constant)
    assert 0.98 * low <= largest_ratio(entry) <= high * (1 + 1e-12), entry.claim


def test_constants_enclose_the_supremum_of_mpmath() -> None:
    """The end above is no smaller, and the end below no larger, than what points show."""
    assert len(SHARP) > 60
    for entry in random.Random(71).sample(SHARP, 12):
        encloses(entry)


@pytest.mark.night
@pytest.mark.parametrize("entry", SHARP, ids=lambda entry: entry.name)
def test_every_constant_encloses_the_supremum(entry: Entry) -> None:
    encloses(entry)


def test_what_is_printed_is_decided() -> None:
    """An entry holds, its neighbour is refuted, and both ends of its constant are in claims."""
    assert len(ENTRIES) > 500
    for entry in ENTRIES:
        assert entry.answer is not None
        assert entry.neighbour is not None
        assert entry.answer.verdict.holds
        assert entry.neighbour.verdict is Verdict.REFUTED
        if entry.constant:
            assert entry.bound is not None
            assert entry.floor is not None
            low, high = map(_number, entry.constant)
            assert 0.97 * high < low < high, entry.name
            assert entry.bound.verdict.holds
            assert entry.floor.verdict is Verdict.REFUTED
            assert f"({entry.constant[1]})*" in entry.bound.claim
            assert f"({entry.constant[0]})*" in entry.floor.claim


def _number(text: str) -> float:
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)


def test_an_answer_belongs_to_its_text() -> None:
    """A stored answer is dropped when the entry is written anew, and none is left over."""
    names = {entry.name for entry in written()}
    assert set(answers()) <= names
    for entry in written():
        stored = answers().get(entry.name)
        assert stored is None or stored["answer"]["claim"] == entry.claim, entry.name
        assert stored is None or stored["neighbour"]["claim"] == entry.false, entry.name


@pytest.mark.parametrize(
    ("claim", "error", "gauge"),
    [
        ("sin(x) == x + O(x**3) as x -> 0", "sin(x) - (x)", "x**3"),
        ("f == a*(1 + 1/x + O(1/x**2)) as x -> oo", "f - (a*(1 + 1/x))", "(a)*(1/x**2)"),
        ("f == O(x)", "f", "x"),
    ],
)
def test_the_remainder_of_a_claim(claim: str, error: str, gauge: str) -> None:
    assert remainder(claim) == (error, gauge)


@pytest.mark.parametrize(
    "claim",
    [
        "f == 1 + a*(1 + O(x)) as x -> 0",  # a alone is not the factor
        "f == (1 + O(x))/a as x -> 0",
        "f == (1 + O(x))*(1 + O(y))",
        "f == O(x)*a + x",
        "f <= x",
    ],
)
def test_no_remainder_is_read_where_there_is_more(claim: str) -> None:
    assert remainder(claim) is None


def test_the_number_of_a_bound() -> None:
    assert number_of("abs(sin(x) - x) <= (1/6)*abs(x**3)") == "1/6"
    assert number_of("sin(x) <= x") == ""


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("erfc large", "erfc-lead"),
        ("erfc x → ∞", "erfc-next"),
        ("Mills", "mills-ratio"),
        ("Mills' ratio", "mills-gordon"),
        ("jordan", "jordan"),
        ("which bound holds for erfc(x)?", "erfc-mills"),
        ("gamma pole", "gamma-pole"),
        ("DLMF 4.18.1", "jordan"),
        ("Kepler", "kepler"),
    ],
)
def test_words_find_an_entry(words: str, name: str) -> None:
    assert name in [entry.name for entry in found(words)]


def test_an_unknown_name_is_refused_with_the_nearest() -> None:
    with pytest.raises(InputError, match="did you mean mills-ratio"):
        atlas("mills-ratios")
    assert found("zzzz qqqq") == ()
    assert found("the of") == ()


def test_the_command_shows_an_entry(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["atlas", "jordan"]) == 0
    assert "sin(x) >= 2*x/pi" in capsys.readouterr().out
    assert main(["atlas", "--search", "erfc large", "--json"]) == 0
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert any(row["name"] == "erfc-lead" and row["answer"] for row in rows)
    assert main(["atlas", "nothing-of-the-kind"]) == 2


def test_the_command_shows_an_entry_in_full(capsys: pytest.CaptureFixture[str]) -> None:
    """The conditions, the witness of the false neighbour, and lines to run."""
    assert main(["atlas", "jordan"]) == 0
    shown = capsys.readouterr().out
    neighbour = atlas("jordan").neighbour
    assert neighbour is not None
    assert "conditions 0 <= x <= pi/2" in shown
    assert neighbour.witness
    assert neighbour.witness in shown
    assert f"tresym explain '{atlas('jordan').claim}'" in shown


def test_the_command_explains_an_entry(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["atlas", "sin-small", "--explain", "--markdown"]) == 0
    assert "**Verdict.** ENCLOSED" in capsys.readouterr().out
    for wrong in (["--markdown"], ["--explain", "--json"]):
        assert main(["atlas", "sin-small", *wrong]) == 2
    assert main(["atlas", "--search", "erfc", "--explain"]) == 2
    assert "the name of one entry" in capsys.readouterr().err


def test_the_command_draws_the_error_of_an_entry(tmp_path: Path) -> None:
    """Also where it decays like exp(-x**2); a bound without O has no chart."""
    assert main(["atlas", "erfc-lead", "--chart", str(tmp_path / "erfc.svg")]) == 0
    assert "smallest constant on x &gt; 0" in (tmp_path / "erfc.svg").read_text(encoding="utf-8")
    assert main(["atlas", "jordan", "--chart", str(tmp_path / "jordan.svg")]) == 2
    assert not (tmp_path / "jordan.svg").exists()


def test_the_pages_show_every_entry() -> None:
    from tresym.site import atlas as site

    pages = dict(site.pages())
    for entry in ENTRIES:
        assert f"(atlas-{entry.name})=" in pages[f"{entry.subject}.md"]
        assert f"{entry.subject}.html#atlas-{entry.name}" in pages["index.md"]
    linked = set(re.findall(r"\(#atlas-([\w-]+)\)", "".join(pages.values())))
    assert linked <= {entry.name for entry in ENTRIES}
    shown = pages["elementary.md"].partition("(tan-small)=")[0]
    assert "<summary>What fails</summary>" in shown
    assert "it fails at x = 261/692" in shown  # the floor of sin-small


def test_related_entries_share_a_rare_function() -> None:
    assert {"erfc-lead", "erfc-next"} & {other.name for other in related(atlas("erfc-second"))}
    assert all("sin(" in other.claim for other in related(atlas("jordan")))
    assert all(entry not in related(entry) for entry in ENTRIES[:20])
