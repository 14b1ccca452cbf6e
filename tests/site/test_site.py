"""The site: pages are made of the saved ledger alone, formulas need no network, links lead on."""

import json
import re
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest
from cases import cases

from tresym.ledger.verification import Report
from tresym.report.pages.numbers import numbers
from tresym.report.pages.site_data import record
from tresym.report.typesetting.finding_text import readable
from tresym.report.typesetting.markdown import finding, sentence
from tresym.report.typesetting.statements import display
from tresym.site import claims, commands, graph, links
from tresym.site.docstrings import restructured
from tresym.site.extension import share_tree

ROOT = Path(__file__).resolve().parents[2]
SOME = tuple(cases(__file__, "SOME"))
"""Of every kind one, with what is true instead of it."""


@pytest.fixture(scope="module")
def report(judged: Callable[..., Report]) -> Report:
    return judged(*SOME)


@pytest.fixture(scope="module")
def ledger(report: Report) -> claims.Record:
    found: claims.Record = json.loads(json.dumps(record(report)))
    return found


def test_every_claim_has_a_page(ledger: claims.Record) -> None:
    pages = dict(claims.pages(ledger, {}))
    assert set(pages) == {
        "index.md",
        claims.AXIOMS,
        claims.ANNOTATED,
        *(f"{label}.md" for label in ledger["claims"]),
    }
    for label, claim in ledger["claims"].items():
        page = pages[f"{label}.md"]
        assert f"# {claim['title']}\n\n" in page.replace("\\", "")
        assert f"`{claim['alias'] or label}`" in page
        assert claims.data(label, claim)["label"] == label
        assert f"[{claim['verdict']}]" in page
        for other in (*claim["uses"], *claim["used_by"], *claim["amended_by"]):
            assert f"(/claims/{other}.md)" in page, (label, other)
        assert f"(/claims/{label}.md)" in pages["index.md"]


def test_quoted_theorems_have_a_page_and_stand_on_those_of_their_claims(
    ledger: claims.Record,
) -> None:
    pages = dict(claims.pages(ledger, {}))
    page = pages[claims.AXIOMS]
    for name, axiom in ledger["axioms"].items():
        assert name[:1].upper() + name[1:] in page
        assert axiom["source"]
        assert axiom["claims"]
        for label in axiom["claims"]:
            assert f"(/claims/{label}.md)" in page
            assert sentence(axiom["source"]) in pages[f"{label}.md"]
    assert all(axiom["rule"] and axiom["source"] for axiom in ledger["rules"].values())
    for label, claim in ledger["claims"].items():
        assert all(label in ledger["axioms"][name]["claims"] for name in claim["axioms"])
    assert claims.AXIOMS in pages["index.md"]
    assert claims.AXIOMS not in pages["eq_gamma.md"]


def test_the_annotated_paper_has_what_stands_in_it_in_its_order(ledger: claims.Record) -> None:
    page = dict(claims.pages(ledger, {}))[claims.ANNOTATED]
    placed = [label for label, claim in ledger["claims"].items() if claim["place"]]
    heads = re.findall(r"^\[.*\]\{\.place\} .* \[`\w+`\]\(/claims/(\w+)\.md\)", page, re.MULTILINE)
    assert sorted(heads) == sorted(placed)
    lines = [ledger["claims"][label]["line"] for label in heads]
    assert lines == sorted(lines)
    sections = re.findall(r"^## (.*)$", page, re.MULTILINE)
    assert len(sections) == len(set(sections)) > 3


def test_previous_and_next_lead_through_every_claim_in_the_order_of_the_proofs(
    ledger: claims.Record,
) -> None:
    pages = dict(claims.pages(ledger, {}))
    order = [label for part in ledger["parts"] for label in part["claims"]]
    assert len(order) > 2
    for label, following in pairwise(order):
        assert re.search(rf"/claims/{following}\.md\) →$", pages[f"{label}.md"].rstrip())
        assert (
            f"← [{sentence(ledger['claims'][label]['title'])}](/claims/{label}.md)"
            in (pages[f"{following}.md"])
        )
    assert "←" not in pages[f"{order[0]}.md"].splitlines()[-1]
    assert "→" not in pages[f"{order[-1]}.md"].splitlines()[-1]


def test_pages_tell_no_time_but_a_saved_one(ledger: claims.Record) -> None:
    assert "seconds" not in json.dumps(ledger)
    assert all("Judged in" not in page for _, page in claims.pages(ledger, {}))
    page = dict(claims.pages(ledger, {"eq_gamma": 0.0125}))["eq_gamma.md"]
    assert "Judged in 12.5 ms" in page


def test_the_page_of_a_chain_links_its_reasons(ledger: claims.Record) -> None:
    page = dict(claims.pages(ledger, {}))["eq_gamma.md"]
    assert "by [`eq_Mi`](/claims/eq_Mi.md)" in page
    assert "$$\n= \\frac{2I_2E}{M^2}-1\n$$" in page


def test_refuted_pages_say_what_is_true(ledger: claims.Record) -> None:
    page = dict(claims.pages(ledger, {}))["table_racket_3_b.md"]
    assert "## True instead" in page
    assert "(/claims/racket_3_third_moment.md)" in page


def test_the_page_of_a_stricter_reading_quotes_the_paper(ledger: claims.Record) -> None:
    pages = dict(claims.pages(ledger, {}))
    page = pages["hyperbolic_levels.md"]
    assert page.index(
        "The paper: “Note the hyperbolic shape of the $\\epsilon_{0}$- level curves.”"
    ) < (
        page.index(r"The level curves of $\epsilon_{0}$ are the hyperbolas $a b = \mathrm{const}$.")
    )
    assert "Sect. 7, read more strictly" in page
    assert "tresym derive --refuted hyperbolic_levels" in page
    assert "The paper: “Racket 3: 448, 7126, 1818, 14.88, 0.12”." in pages["table_racket_3_b.md"]
    assert "The paper:" not in pages["eq_gamma.md"]
    assert "tresym derive eq_gamma" in pages["eq_gamma.md"]


def test_a_constant_that_was_typed_is_shown_as_it_was() -> None:
    assert claims._ball({"mid": "0.16999999999999999998", "rad": "3e-20"}) == "0.17"
    assert claims._ball({"mid": "-0.169999", "rad": "1e-6"}) == "−0.169999, to within 1e-6"
    assert claims._ball({"mid": "0.169999", "rad": "1e-6"}) == "0.169999, to within 1e-6"
    assert claims._ball({"mid": "0.16123456789012345", "rad": "1e-17"}).endswith("within 1e-17")


def test_uses_and_used_by_are_each_other(ledger: claims.Record) -> None:
    found = ledger["claims"]
    for label, claim in found.items():
        assert all(label in found[other]["used_by"] for other in claim["uses"])
        assert all(label in found[other]["uses"] for other in claim["used_by"])


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("2 arctan e^{−π} < 1", r"$2 \arctan e^{- \pi} < 1$"),
        ("≤ 1.451 ε*^2.", r"$\le 1.451 \epsilon_{*}^{2}$."),
        ("between ψ_min and ψ_max", r"between $\psi_{\min}$ and $\psi_{\max}$"),
        ("the label eq_gamma, |x|", r"the label eq\_gamma, $\vert x\vert$"),
        ("[so](there) `code` $4", r"\[so\](there) `code` \$4"),
    ],
)
def test_sentences_read_the_same_in_markdown(text: str, shown: str) -> None:
    assert sentence(text) == shown


def test_what_was_found_in_letters() -> None:
    assert readable("violated at psi1 = -1/2, I3 = 4") == "violated at ψ₁ = −1/2, I₃ = 4"
    assert readable("12*lambda**(-2)*exp(-2/lambda)") == "12 · λ^{−2} · exp(−2/λ)"
    assert finding("t -> 0+, 2 * t^(10)") == r"$t \to 0^{+}$, $2 t^{10}$"
    assert readable("Eq(b, 55/874), gamma >= -1/500") == "b = 55/874, γ ≥ −1/500"


def test_long_systems_take_a_line_for_each_part() -> None:
    parts = [r"\alpha_{1}+\beta_{1} = 0", r"\gamma_{2}+\delta_{2} \ge 1", "c = d"]
    shown = display(r",\quad ".join(parts))
    assert shown.count(r"\\") == 2
    assert "gathered" in shown
    assert "gathered" not in display("a = b,\\quad c = d")


def test_every_formula_becomes_mathml(ledger: claims.Record) -> None:
    mathematics = pytest.importorskip("tresym.site.mathematics")
    pytest.importorskip("math_core")
    for claim in ledger["claims"].values():
        for formula in (*claim["given"], claim["formula"] or "0"):
            assert mathematics.mathml(formula, block=True).startswith("<math")


def test_the_font_comes_along_and_is_small() -> None:
    pytest.importorskip("fontTools")
    pytest.importorskip("ziamath")
    from tresym.site import mathematics

    style = mathematics.stylesheet(mathematics.font_file())
    assert "url(data:font/woff;base64," in style
    assert "//" not in style.split("base64,")[0]
    assert len(style) < 250_000
    assert style == mathematics.stylesheet(mathematics.font_file())


def test_the_command_reference_names_every_option() -> None:
    text = commands.reference()
    for name in ("verify", "flip", "check", "derive", "table", "figure", "docs", "bench", "sweep"):
        assert f"## tresym {name}\n" in text
    for option in ("--inertia I1 I2 I3", "--given CONDITIONS", "--mutants", "-o PATH", "--check"):
        assert f"`{option}`" in text


def test_examples_are_what_the_command_prints() -> None:
    text = commands.transcript("tresym flip --body str --digits 20")
    assert text.startswith("$ tresym flip --body str --digits 20\n")
    assert "0.11494412656569275372" in text
    assert re.search(r"\d (ms|s)\b", commands.transcript("tresym check 'x == x'")) is None
    claim = "'a**2*(b + c)**3 + a**3 >= a**3 + a**2*(b + c)**3' --given 'a > 0, b > 0, c > 0'"
    lines = commands.transcript(f"tresym check {claim}").splitlines()
    assert max(map(len, lines)) <= 84
    assert lines[1] == "    --given 'a > 0, b > 0, c > 0'"
    assert any(line.startswith("  claim      a**2") for line in lines)
    with pytest.raises(ValueError, match="refused"):
        commands.transcript("tresym flip --body nobody")
    with pytest.raises(ValueError, match="refused"):
        commands.transcript("rm -rf x")


def test_docstrings_become_fields() -> None:
    lines = [
        "Says.",
        "",
        "Args:",
        "    x: a number,",
        "        exact.",
        "",
        "Raises:",
        "    E: no.",
    ]
    found = restructured([*lines, "", "More: text."])
    assert found[found.index(":param x: a number,") + 1].strip() == "exact."
    assert ":raises E: no." in found
    assert found[-1] == "More: text."


def test_the_checker_sees_what_is_planted(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    good = '<p id="x"><a href="a/b.html#y">b</a><a href="https://e.org">e</a><a href="#x">x</a>'
    (tmp_path / "index.html").write_text(good)
    (tmp_path / "a" / "b.html").write_text('<p id="y"><a href="../index.html">up</a>')
    (tmp_path / "s.css").write_text("a { background: url(data:image/png;base64,//x) }")
    assert list(links.faults(tmp_path)) == []
    assert links.main([str(tmp_path)]) == 0
    planted = [
        '<a href="c.html">c</a>',
        '<a href="a/b.html#z">z</a>',
        '<script src="https://cdn.e.org/x.js"></script>',
        '<link rel="stylesheet" href="//e.org/x.css">',
        '<img src="index.html">',
    ]
    for piece in planted:
        (tmp_path / "index.html").write_text(good + piece)
        assert len(list(links.faults(tmp_path))) == 1, piece
    (tmp_path / "index.html").write_text(good)
    (tmp_path / "s.css").write_text("@import 'https://e.org/f.css';")
    assert len(list(links.faults(tmp_path))) == 1
    assert links.main([str(tmp_path)]) == 1
    assert links.main([str(tmp_path / "nowhere")]) == 2


_ASIDE = re.compile(r"```.*?```|`[^`]*`|\{\{.*?\}\}|\]\([^)]*\)|\$\$.*?\$\$", re.DOTALL)
"""What is not prose: directives and examples, code, substitutions, targets of links, formulas."""


def test_no_result_is_typed_into_the_prose(report: Report) -> None:
    """Numbers with three digits or more stand in pages as includes, examples or substitutions."""
    allowed = {"3.11", "1.14", "338", "2017", "1606.08237", "000"}
    for path in sorted((ROOT / "docs").glob("**/*.md")):
        if path.parent.name in ("generated", "_pages", "tables", "claims", "reference", "atlas"):
            continue
        text = _ASIDE.sub("", path.read_text(encoding="utf-8"))
        found = set(re.findall(r"(?<![\w.])\d[\d.]*\d\d(?!\w)|(?<![\w.])\d+\.\d+(?!\w)", text))
        assert found <= allowed, (path.name, found - allowed)
    assert numbers(report)["claims"] == str(len(report.rows))


def test_the_picture_of_a_claim_has_its_neighbours(ledger: claims.Record) -> None:
    found = ledger["claims"]
    for label, claim in found.items():
        shown = graph.picture(label, found)
        assert bool(shown) == bool(claim["uses"] or claim["used_by"])
        if not shown:
            continue
        boxes = re.findall(r'<a href="(\w+)\.html">', shown)
        assert boxes.count(label) == 1
        assert len(set(boxes)) == len(boxes)
        cut = sum(map(int, re.findall(r"and (\d+) more", shown)))
        assert set(claim["uses"]) <= set(boxes) or cut
        ElementTree.fromstring(shown)


def test_a_sentence_is_one_text_over_its_lines() -> None:
    nodes = pytest.importorskip("docutils.nodes")
    pytest.importorskip("sphinx")
    from tresym.site.extension import join_lines

    lines = [
        nodes.Text("that a"),
        nodes.Text("\n"),
        nodes.Text("proof has"),
        nodes.literal("", "x"),
    ]
    paragraph = nodes.paragraph("", "", *lines)
    join_lines(paragraph)
    first, second = paragraph.children
    assert str(first) == "that a\nproof has"
    assert second.astext() == "x"
    assert first.parent is paragraph


def test_long_commands_fit_the_boxes_of_the_site() -> None:
    from tresym.site.commands import COLUMNS, on_lines

    long = "tresym chart error 'elliptic_k(m)' 'pi/2*(1 + m/4)' 'pi/2*(1 + m/4 + 9*m**2/64)' "
    long += "'pi/2*(1 + m/4 + 9*m**2/64 + 25*m**3/256)' --as 'm -> 0+' --on '0 < m <= 1/2'"
    lines = on_lines(long).split("\n")
    assert all(len(line) <= COLUMNS for line in lines)
    assert " ".join(line.rstrip("\\").strip() for line in lines) == long


def test_the_tree_of_pages_is_resolved_once_for_a_folder_of_claims() -> None:
    asked: list[str] = []
    kept: dict[object, str] = {}
    app = SimpleNamespace(env=SimpleNamespace(toctree_includes={"index": ["claims/index"]}))

    def beside(page: str, **options: bool) -> str:
        context: dict[str, Any] = {"toctree": lambda **_: asked.append(page) or f"{page} {options}"}
        share_tree(kept, app, page, "page.html", context)  # type: ignore[arg-type]
        return str(context["toctree"](**options))

    assert beside("claims/a") == beside("claims/b")
    assert beside("claims/index") != beside("claims/a")  # its own entry is marked
    assert beside("atlas/a") != beside("claims/a")  # links lead from another folder
    assert beside("search") != beside("index")
    assert beside("claims/a", collapse=True) != beside("claims/a")
    assert asked.count("claims/b") == 0
