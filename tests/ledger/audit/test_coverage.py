"""The audit: on a paper written for these tests, and on the real one where it is at hand."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from cases import cases
from sympy import Derivative, Function, Integer, Integral, Subs, Symbol, Tuple, cos, sin, sqrt
from sympy_statements import Rounds, equal

from tresym.commands import main
from tresym.commands.audit import show_audit
from tresym.ledger.audit.coverage import (
    Audit,
    Entry,
    Text,
    Transcription,
    audit,
    load_index,
    load_words,
)
from tresym.ledger.audit.source import scan
from tresym.ledger.audit.transcription import Reading, functions_of, unmet
from tresym.ledger.claim import (
    Claim,
    Definition,
    Place,
    Printed,
    all_of,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.latex_source import read_source
from tresym.ledger.paper import all_claims
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_author import Author
from tresym.reals.numbers.exact import InputError

PENDULUM = Path(__file__).resolve().parents[2] / "data" / "pendulum.tex"
ROOT = Path(__file__).resolve().parents[3]
INDEX = ROOT / "proofs" / "index.json"
PAPERS = sorted(ROOT.parent.glob("shared/paper/*.txt"))
DISPLAYS = 9


def real(name: str) -> Symbol:
    return Symbol(name, real=True)


h, w, q, p, S, k, T, q0 = map(real, ["h", "w", "q", "p", "S", "k", "T", "q0"])
dq_dt, dp_dt = real("dq_dt"), real("dp_dt")


def claim(label: str, display: int, *says: object, given: tuple = ()) -> Claim:
    whole = says[0] if len(says) == 1 else Tuple(*says)
    return Claim(label, whole, Definition(), given=given, where=Place(display=display))


def printed_number(label: str, term: Symbol, text: str) -> Claim:
    means = Rounds(term, text)
    return Claim(label, str(term), Printed(), where=Place(display=8), means=means)


def claims() -> tuple[Claim, ...]:
    """What a careful author would claim of the synthetic paper."""
    modulus = claim("modulus", 3, equal(k, sqrt((h + w**2) / (2 * w**2))))
    range_of_k = Claim("range_of_k", Tuple(k >= 0, k <= 1), Definition())
    return (
        claim("energy", 1, equal(h, dq_dt**2 / 2 - w**2 * cos(q))),
        claim("speed", 2, equal(dq_dt, S * sqrt(2) * sqrt(h + w**2 * cos(q)))),
        modulus,
        Claim("range", "k is in [0, 1]", all_of(range_of_k), where=Place(display=3)),
        claim("system", 4, equal(dq_dt, p), equal(-dp_dt, w**2 * sin(q)), given=(w > 0,)),
        claim("system_2", 4, equal(dp_dt, -(w**2) * sin(q))),
        claim("force", 5, equal(-dp_dt, w * sin(q) * w)),
        claim(
            "eq_period",
            6,
            equal(T / 4, Integral(1 / sqrt(2 * (h + w**2 * cos(q))), (q, 0, q0))),
            given=(q0 > 0, h > 0),
        ),
        claim("small", 7, equal(T, 6)),
        printed_number("period_printed", T, "6.28"),
        printed_number("w_printed", w, "1.5e-1"),
        claim("slope", 9, equal(Subs(Derivative(w**2 * sin(q), q), q, 0), w**2), given=(w > 0,)),
        Claim("th_period", "", all_of()),
        Claim("remark", "", all_of(), where=Place(line=41)),
        Claim("fig_pendulum", "", all_of()),
        Claim("figure2", "", all_of()),
        Claim("cell", "", all_of(), where=Place(line=51, cell="1")),
    )


def index_of(path: Path = PENDULUM) -> tuple[Entry, ...]:
    source = scan(read_source(path))
    pieces = (*source.displays, *source.others)
    entries = [Entry(p.kind, p.label, p.line, p.end, p.sha256, p.number or None) for p in pieces]
    reading = Reading(sentence="≃ is no relation", again=("T ~ 2*pi/w",))
    entries[6] = replace(entries[6], reading=reading)
    lines = [
        Entry(
            p.kind,
            p.label,
            p.line,
            p.end,
            p.sha256,
            answers=("w_printed",) if "w=1" in p.text else (),
            no_claim="" if "w=1" in p.text else "it tells of the price",
        )
        for p in source.text
    ]
    return (*entries, *lines)


def altered(tmp_path: Path, old: str, new: str) -> Path:
    text = PENDULUM.read_text(encoding="ascii")
    assert text.count(old) == 1
    path = tmp_path / "altered.tex"
    path.write_text(text.replace(old, new), encoding="ascii")
    return path


def bad(result: Audit) -> dict[str, Text | Transcription]:
    return {
        row.label: row.text if row.text is not Text.SAME else row.transcription
        for row in result.rows
        if not row.good
    }


def test_pieces_are_found_in_order_with_their_labels_and_lines() -> None:
    source = scan(read_source(PENDULUM))
    assert [(d.number, d.kind, d.label, d.line) for d in source.displays] == [
        (1, "equation", "eq_energy", 12),
        (2, "brackets", "d02", 16),
        (3, "dollars", "d03", 18),
        (4, "equation", "eq_system", 22),
        (5, "brackets", "d05", 30),
        (6, "equation", "eq_period", 36),
        (7, "brackets", "d07", 42),
        (8, "brackets", "d08", 45),
        (9, "brackets", "d09", 47),
    ]
    assert [(o.kind, o.label) for o in source.others] == [
        ("figure", "fig_pendulum"),
        ("theorem", "th_period"),
        ("remark", "remark1"),
        ("table", "tab_lengths"),
        ("figure", "figure2"),
    ]


def test_full_coverage_of_the_synthetic_paper() -> None:
    result = audit(PENDULUM, claims(), index_of())
    assert bad(result) == {}
    assert result.complete
    assert result.count() == (DISPLAYS, DISPLAYS)
    assert result.count("figure") == (2, 2)
    assert result.read == DISPLAYS - 1
    assert result.rows[6].transcription is Transcription.SENTENCE


@pytest.mark.skipif(not PAPERS, reason="the paper does not lie beside the checkout")
def test_the_sections_begin_where_the_claim_on_a_cross_reference_says() -> None:
    lines = PAPERS[0].read_text(encoding="latin-1").splitlines()
    begun = {n: line for n, line in enumerate(lines, 1) if line.startswith(r"\section")}
    assert list(begun)[1:4] == [48, 81, 113]
    assert "sec2" in begun[48]
    assert "sec3" in begun[81]


@pytest.mark.parametrize(
    "again",
    [(), ("T ~ pi/w",), ("T = 2*pi/w",), ("q ~ 2*pi/w",), ("T ~ 2*pi/w", "q ~ 0"), ("T ~ 2",)],
)
def test_what_no_claim_can_say_is_transcribed_twice(again: tuple[str, ...]) -> None:
    entries = list(index_of())
    reading = replace(entries[6].reading, again=again)
    entries[6] = replace(entries[6], reading=reading)
    result = audit(PENDULUM, claims(), entries)
    assert bad(result) == {"d07": Transcription.DIFFERS}


@pytest.mark.parametrize("label", ["energy", "force", "eq_period", "fig_pendulum", "cell"])
def test_an_uncovered_piece_is_named(label: str) -> None:
    kept = [c for c in claims() if c.label != label]
    result = audit(PENDULUM, kept, index_of())
    (row,) = [row for row in result.rows if not row.good]
    assert row.claims == ()
    assert row.note == "no claim answers it"


def test_a_line_of_the_text_has_its_claims_or_a_reason_for_none() -> None:
    rows = {row.label: row for row in audit(PENDULUM, claims(), index_of()).rows}
    assert rows["line10"].no_claim == "it tells of the price"
    assert rows["line10"].good
    assert rows["line44"].claims == ("w_printed",)
    assert set(rows) >= {"line10", "line44"}


def test_a_line_of_the_text_fails_without_its_claim() -> None:
    kept = [c for c in claims() if c.label != "w_printed"]
    (row,) = [r for r in audit(PENDULUM, kept, index_of()).rows if r.kind == "text" and not r.good]
    assert (row.label, row.note) == ("line44", "the claim w_printed on it is missing")


def test_a_line_of_the_text_that_nobody_answered_fails(tmp_path: Path) -> None:
    said = altered(tmp_path, "The derivative is\n", "The derivative at $q=0$ is\n")
    assert list(bad(audit(said, claims(), index_of())).values()) == [Text.ADDED]
    moving = audit(PENDULUM, claims(), index_of(), words=("the speed",))
    (row,) = [row for row in moving.rows if not row.good]
    assert row.note.startswith("no claim answers it")
    assert row.line == 15


def test_an_altered_line_of_the_text_is_named(tmp_path: Path) -> None:
    said = altered(tmp_path, "For $w=1$ the", "For $w=2$ the")
    assert bad(audit(said, claims(), index_of())) == {"line44": Text.ALTERED}


@pytest.mark.skipif(not PAPERS, reason="the paper does not lie beside the checkout")
def test_every_line_on_the_motion_or_with_a_formula_is_answered() -> None:
    index, words = load_index(INDEX), load_words(INDEX)
    result = audit(PAPERS[0], all_claims(), index, words=words)
    good, total = result.count("text")
    assert good == total >= 90
    lines = [entry for entry in index if entry.kind == "text"]
    assert sum(not entry.answers for entry in lines) <= 2
    less = tuple(c for c in all_claims() if c.label != "stable_e1")
    assert not audit(PAPERS[0], less, index, words=words).complete


def reading_of(label: str, reads: dict[str, str]) -> tuple[Entry, ...]:
    return tuple(
        replace(e, reading=replace(e.reading, reads=reads)) if e.label == label else e
        for e in index_of()
    )


def test_what_is_read_otherwise_than_printed_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    energy = equal(h, dq_dt**2 / 2)
    other = [replace(c, says=energy) if c.label == "energy" else c for c in claims()]
    assert bad(audit(PENDULUM, other, index_of())) == {"eq_energy": Transcription.DIFFERS}
    result = audit(PENDULUM, other, reading_of("eq_energy", {"w": "0"}))
    row = result.rows[0]
    assert row.transcription is Transcription.AS_READ
    assert row.note == "w read as 0"
    assert result.complete
    assert (result.read, result.read_otherwise) == (DISPLAYS - 1, 1)
    assert result.as_json()["read_otherwise"] == 1
    show_audit(result)
    text = capsys.readouterr().out
    assert "display 1 (eq_energy): w read as 0" in text
    assert "1 of these with something read otherwise than printed" in " ".join(text.split())


def test_a_reading_that_is_not_needed_is_not_told() -> None:
    result = audit(PENDULUM, claims(), reading_of("eq_energy", {"k": "q"}))
    assert result.rows[0].transcription is Transcription.EQUAL
    assert result.read_otherwise == 0


@pytest.mark.skipif(not PAPERS, reason="the paper does not lie beside the checkout")
def test_every_reading_of_the_index_is_needed_and_told() -> None:
    index = load_index(INDEX)
    result = audit(PAPERS[0], all_claims(), index, words=load_words(INDEX))
    told = {row.label for row in result.rows if row.transcription is Transcription.AS_READ}
    assert told == {entry.label for entry in index if entry.reading.otherwise}
    assert result.complete


SLIPS = [
    ("energy", equal(h, dq_dt**2 / 2 + w**2 * cos(q))),
    ("energy", equal(h, dq_dt**2 - w**2 * cos(q))),
    ("speed", equal(dq_dt, S * sqrt(2) * sqrt(h + w**2 * sin(q)))),
    ("speed", equal(dq_dt, sqrt(2) * sqrt(h + w**2 * cos(q)))),
    ("modulus", equal(k, sqrt((h + w**2) / w**2))),
    ("range_of_k", Tuple(k >= 0, k < 1)),
    ("range_of_k", Tuple(k >= 0)),
    ("system", equal(dq_dt, p + w)),
    ("force", equal(-dp_dt, w * sin(q))),
    ("eq_period", equal(T / 4, Integral(1 / sqrt(2 * (h - w**2 * cos(q))), (q, 0, q0)))),
    ("eq_period", equal(T / 4, Integral(1 / sqrt(2 * (h + w**2 * cos(q))), (q, 0, 2 * q0)))),
    ("eq_period", equal(T / 2, Integral(1 / sqrt(2 * (h + w**2 * cos(q))), (q, 0, q0)))),
    ("slope", equal(Subs(Derivative(w**2 * sin(q), q), q, 1), w**2)),
    ("energy", equal(h, dq_dt**2 / 2 - w**2 * cos(q) + Function("O")(w))),
]


@pytest.mark.parametrize(("label", "says"), SLIPS)
def test_a_slip_of_transcription_is_caught(label: str, says: object) -> None:
    def slipped(c: Claim) -> Claim:
        if label == "range_of_k" and c.label == "range":
            return replace(c, proof=all_of(Claim("range_of_k", says, Definition())))
        return replace(c, says=says) if c.label == label else c

    result = audit(PENDULUM, map(slipped, claims()), index_of())
    (row,) = [row for row in result.rows if not row.good]
    assert row.transcription is Transcription.DIFFERS
    assert row.note.startswith("no claim says ")


def test_a_printed_number_with_another_digit_is_caught() -> None:
    def slipped(c: Claim) -> Claim:
        return replace(c, means=Rounds(T, "6.280")) if c.label == "period_printed" else c

    result = audit(PENDULUM, map(slipped, claims()), index_of())
    assert bad(result) == {"d08": Transcription.DIFFERS}


def test_a_sentence_counts_by_its_formal_relations() -> None:
    said = Claim(
        "energy",
        "The energy",
        Decided(),
        means=equal(h, dq_dt**2 / 2 - w**2 * cos(q)),
        where=Place(display=1),
    )
    others = [c for c in claims() if c.label != "energy"]
    assert audit(PENDULUM, [said, *others], index_of()).complete


LATEX_SLIPS = cases(__file__, "LATEX_SLIPS")


def test_every_slip_in_the_latex_itself_is_caught() -> None:
    pieces = scan(read_source(PENDULUM)).displays
    functions = functions_of(piece.text for piece in pieces)
    author = Author(functions)
    slips = 0
    for piece in pieces:
        on_it = [c for c in claims() if c.where and c.where.display == piece.number]
        assert piece.label == "d07" or not unmet(read_latex(piece.text, author), on_it, functions)
        for pattern, slip in LATEX_SLIPS:
            for found in re.finditer(pattern, piece.text):
                text = found.expand(slip).join(
                    (piece.text[: found.start()], piece.text[found.end() :])
                )
                slips += 1
                left = unmet(read_latex(text, author), on_it, functions)
                assert left, text
    assert slips > 25


def test_an_altered_display_is_named_and_no_other(tmp_path: Path) -> None:
    path = altered(tmp_path, "-w^2\\cos q, %", "+w^2\\cos q, %")
    result = audit(path, claims(), index_of())
    assert bad(result) == {"eq_energy": Text.ALTERED}
    assert not result.complete


def test_an_altered_caption_is_named(tmp_path: Path) -> None:
    path = altered(tmp_path, "The phase portrait.", "A phase portrait.")
    assert bad(audit(path, claims(), index_of())) == {"figure2": Text.ALTERED}


def test_a_display_taken_out_or_put_in_is_named_and_shifts_no_other(tmp_path: Path) -> None:
    out = altered(tmp_path, "\\[g(q,w)=w^2\\sin q.\\]", "")
    result = audit(out, claims(), index_of())
    assert bad(result)["d05"] is Text.MISSING
    assert {row.text for row in result.rows} == {Text.SAME, Text.MISSING}
    put = altered(tmp_path, "The derivative is", "\\[ x=y \\] The derivative is")
    assert list(bad(audit(put, claims(), index_of())).values()) == [Text.ADDED]


def test_spacing_and_comments_are_no_alteration(tmp_path: Path) -> None:
    path = altered(tmp_path, "-w^2\\cos q, % kinetic, then potential", "\n  -w^2\\cos q, % other")
    moved = bad(audit(path, claims(), index_of()))
    assert moved == {"eq_energy": Text.ALTERED}  # a space inside a formula is a change of text
    path = altered(tmp_path, "cos q, % kinetic, then potential\n", "cos q,\n\n\n")
    assert bad(audit(path, claims(), index_of())) == {}


TEXT = PENDULUM.read_text(encoding="ascii")
ACCENTED = TEXT.replace("The plane pendulum", "Le pendule plan étudié")


@pytest.mark.parametrize(
    "data",
    [
        TEXT.replace("\n", "\r\n").encode(),
        TEXT.replace("\n", "\r").encode(),
        b"\xef\xbb\xbf" + TEXT.encode(),
        TEXT.encode("utf-16"),
        ACCENTED.encode(),
        ACCENTED.encode("latin-1"),
        ACCENTED.replace("latin1", "cp1250").encode("cp1250"),
    ],
    ids=["crlf", "cr", "bom", "utf16", "utf8", "latin1", "cp1250"],
)
def test_line_ends_and_encodings_change_nothing(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "paper.tex"
    path.write_bytes(data)
    assert audit(path, claims(), index_of()).complete


BROKEN = {
    "holds NUL bytes": TEXT.encode() + b"\0",
    "no \\begin{document} in it": b"just a letter\n",
    "no \\begin{document}": b"",
    "\\end{document} is missing": TEXT.replace("\\end{document}", "").encode(),
    "the encoding klingon is not known": ACCENTED.replace("latin1", "klingon").encode("latin-1"),
    "declares no encoding": ACCENTED.replace("[latin1]{inputenc}", "{bm}").encode("latin-1"),
    "line 8 is not ascii": ACCENTED.replace("latin1", "ascii").encode("latin-1"),
    "line 14: \\end{equation*} where \\begin{equation}, opened in line 12": TEXT.replace(
        "\\end{equation}", "\\end{equation*}", 1
    ).encode(),
    "\\[, opened in line 16, is open in line 18": TEXT.replace(
        "2h+2w^2\\cos q}. \\]", "2h}.", 1
    ).encode(),
    "$$ is closed by a single $": TEXT.replace("1.\n$$", "1.\n$", 1).encode(),
    "the formula $, opened in line 44": TEXT.replace("For $w=1$", "For $w=1").encode(),
    "\\] closes nothing": TEXT.replace("A bob", "\\] A bob").encode(),
    "\\begin{small}, opened in line 10, is not closed": TEXT.replace(
        "A bob", "\\begin{small} A bob"
    )
    .replace("\\begin{figure*}", "")
    .replace("\\end{figure*}", "")
    .encode(),
}


@pytest.mark.parametrize("why", BROKEN)
def test_bad_input_gets_one_clear_line(tmp_path: Path, why: str) -> None:
    path = tmp_path / "paper.tex"
    path.write_bytes(BROKEN[why])
    with pytest.raises(InputError) as caught:
        audit(path, claims(), index_of())
    message = str(caught.value)
    assert why in message
    assert message.startswith(str(path))
    assert "\n" not in message


def test_missing_files_and_folders(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_source(tmp_path / "nowhere.tex")
    with pytest.raises(InputError, match="cannot be read"):
        read_source(tmp_path)


def test_json_and_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    result = audit(altered(tmp_path, "\\frac{T}{4}", "\\frac{T}{2}"), claims(), index_of())
    data = json.loads(json.dumps(result.as_json()))
    assert data["complete"] is False
    assert {row["label"]: row["text"] for row in data["rows"]}["eq_period"] == "altered"
    show_audit(result)
    text = capsys.readouterr().out
    assert "display 6 (eq_period): its text is not the one" in text
    assert "8 of 9 displays" in text


def test_command_line_reports_bad_input_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["audit", str(tmp_path / "nowhere.tex")]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1


def test_command_line_writes_json_and_fails_on_another_paper(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["audit", str(PENDULUM), "--json"]) == 1
    data = json.loads(capsys.readouterr().out)
    assert data["complete"] is False
    assert {row["text"] for row in data["rows"]} <= {"altered", "missing", "added"}
    assert main(["audit", str(PENDULUM), "--json", "-o", str(tmp_path / "audit.json")]) == 1
    assert json.loads((tmp_path / "audit.json").read_text()) == data


def test_index_of_the_paper_is_whole() -> None:
    index = load_index(INDEX)
    assert [e.number for e in index if e.number] == list(range(1, 59))
    assert sum(e.kind == "figure" for e in index) == 11
    assert {e.kind for e in index} >= {"theorem", "remark", "table"}
    assert len({e.label for e in index}) == len(index)
    assert len({e.sha256 for e in index}) >= len(index) - 6  # the paper repeats some displays


@pytest.mark.skipif(not PAPERS, reason="the paper's source is not beside the checkout")
def test_the_index_fits_the_paper() -> None:
    source = scan(read_source(PAPERS[0]), words=load_words(INDEX))
    index = load_index(INDEX)
    pieces = (*source.displays, *source.others, *source.text)
    found = [(p.label, p.kind, p.line, p.sha256) for p in pieces]
    assert found == [(e.label, e.kind, e.line, e.sha256) for e in index]
    functions = functions_of(d.text for d in source.displays)
    displays = zip(source.displays, index, strict=False)
    assert all(read_latex(d.text, e.reading.author(functions)) for d, e in displays)
    assert Integer(len(source.displays)) == 58
