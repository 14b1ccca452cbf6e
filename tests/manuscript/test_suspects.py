"""Proof-reading: misprints are accused, and nothing that is meant otherwise is."""

import json
from dataclasses import replace
from pathlib import Path

import manuscripts
import pytest
from cases import cases
from planted_errors import outcomes

from tresym.commands import main
from tresym.manuscript.deciding import Row
from tresym.manuscript.links import read_links
from tresym.manuscript.source import read_manuscript
from tresym.manuscript.suspects import failing, may_be, proofread
from tresym.reals.verdict import Cause


def read(folder: Path, text: str) -> list[Row]:
    return proofread(manuscripts.read(folder, text), 20.0, 1)


def statuses(folder: Path, text: str) -> list[str]:
    return [row.status for row in read(folder, text)]


@pytest.mark.parametrize(
    ("text", "instead"),
    cases(__file__, "a_misprint_is_suspect_with_what_is_true_instead"),
)
def test_a_misprint_is_suspect_with_what_is_true_instead(
    text: str, instead: str, tmp_path: Path
) -> None:
    (row,) = read(tmp_path, text)
    assert row.status in ("REFUTED", "SUSPECT")
    assert row.fails_at
    assert row.instead[0].verdict == "PROVED"
    assert instead in ("", row.instead[0].claim)


EQUATIONS = (
    r"Solve \[ x^2 - 5x + 6 = 0. \]",
    r"The roots of \[ \cos^2 x - \sin^2 x = 1 \]",
    r"It remains to solve \[ 2\sin x\cos x = \sin x. \]",
    r"The number satisfies \[ x^2 = x + 1. \]",
    r"The curve \[ x^2 + y^2 = 1 \]",
    r"Newton's law is \[ F = m a. \]",
    r"\[ p V = n R T \]",
    r"\[ \tan x = x \]",
    r"\[ \sin 2x = \sin x \]",
    r"\[ x = \cos x \]",
    r"\[ x^2 = 2x \]",
    r"Let \[ y = \sin x. \]",
    r"Set \[ u = x^2. \]",
    r"Assume \[ \sqrt{x^2} = x. \]",
    r"We require \[ \sin x = \cos x. \]",
    r"The constraint \[ x + y = 1 \]",
    r"The differential equation \[ \frac{dy}{dx} = -y \]",
    r"It is not true that \[ (x + y)^2 = x^2 + y^2. \]",
    r"\[ \cos^2 x - \sin^2 x = 1 \] has the solutions $x = k\pi$.",
    r"\[ \sqrt{x^2} = x \] if and only if $x \ge 0$.",
    r"For $n$ a positive integer \[ |n| = n. \]",
    r"The disc \[ x^2 + y^2 \le 1 \]",
    r"Therefore \[ x + 2 = 3x - 4. \]",
    "% tresym: solve\n" r"\[ \cos 2x = 2\cos^2 x + 1 \]",
    r"Solve \[ \sin 2x = 2\sin x. \] Solve \[ 2\sin x = \sin 2x. \]",  # two displays, no chain
    r"One has \[ \sqrt{a^2} = a. \]",  # a letter that is mostly positive
    r"The radius of it is $x$. One has \[ \sqrt{x^2} = x. \]",
    # Not the same variables on both sides, beside identities
    r"\begin{align} \sin^2 x + \cos^2 x &= 1 \\ x + \tan^5 y - 7 &= \sin x\cos x \\"
    r"\cosh^2 x - \sinh^2 x &= 1 \end{align}",
)


@pytest.mark.parametrize("text", EQUATIONS)
def test_what_is_meant_otherwise_is_not_accused(text: str, tmp_path: Path) -> None:
    assert not {"SUSPECT", "REFUTED"} & {*statuses(tmp_path, text)}


def test_true_displays_are_not_accused(tmp_path: Path) -> None:
    text = r"""\[ \cos 2x = 2\cos^2 x - 1 \] \[ \sqrt{x^2} = |x| \] For $x > 0$ \[ \sqrt{x^2} = x \]
    \[ \int_0^\pi \sin x\,dx = 2 \] \[ \sum_{k=1}^n k = \frac{n(n+1)}{2} \]"""
    assert {*statuses(tmp_path, text)} <= {"PROVED", "ENCLOSED"}


def test_in_a_block_of_identities_what_fails_is_suspect_without_a_repair(tmp_path: Path) -> None:
    block = r"\begin{align} \sin^2 x + \cos^2 x &= 1 \\ \sin 3x &= \sin x\cos x + \tan^5 x - 7"
    block += r" \\ \cosh^2 x - \sinh^2 x &= 1 \end{align}"
    assert statuses(tmp_path, block) == ["PROVED", "SUSPECT", "PROVED"]


@pytest.mark.parametrize("words", ["and so", "Now let", "In another unit"])
def test_a_symbol_defined_anew_is_no_misprint(words: str, tmp_path: Path) -> None:
    text = rf"The energy is \[ E = m c^2. \] {words} \[ E = m c^3. \]"
    assert statuses(tmp_path, text) == ["DEFINED", "DEFINED"]


def test_each_misprint_of_several_is_suspect(tmp_path: Path) -> None:
    text = r"We have \[ \cos 2x = 2\cos^2 x + 1. \] We have \[ \cosh 2x = 2\cosh^2 x + 1. \]"
    assert statuses(tmp_path, text) == ["REFUTED", "REFUTED"]


def test_a_section_of_its_own_may_define_anew(tmp_path: Path) -> None:
    text = r"The energy is \[ E = m c^2. \] \section{B} The energy is \[ E = m c^3. \]"
    assert "SUSPECT" not in statuses(tmp_path, text)


def test_what_is_refuted_has_suggestions_in_the_symbols_of_the_author(tmp_path: Path) -> None:
    text = r"Let \[ r = \sqrt{x^2 + y^2}. \] For all $x$ and $y$ \[ r^2 = x^2 - y^2. \]"
    row = read(tmp_path, text)[-1]
    assert row.status in ("REFUTED", "SUSPECT")
    assert row.instead[0].claim == "r**2 == x**2 + y**2"


DOUBTED = r"We have the formula \[ \sin s + t = \sin s + \cos^3 t. \]"
WRONG = r"\[ \sin^2 x + \cos^2 x = 1 \] We have \[ \cos 2x = 2\cos^2 x + 1. \]"


def test_the_command_shows_first_what_to_look_at(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "m.tex"
    path.write_text(WRONG)
    assert main(["paper", str(path), "--html", str(tmp_path / "h")]) == 1
    out = capsys.readouterr().out.splitlines()
    assert out[0].startswith("REFUTED")
    assert "m.tex:1" in out[0]
    assert any("instead  PROVED: cos(2*x) == 2*cos(x)**2 - 1" in line for line in out)
    assert out[-1].startswith("PROVED")
    page = (tmp_path / "h" / "index.html").read_text()
    assert page.index("attention") < page.index('id="display-1"')
    assert "<mark>- 1 in place of + 1</mark>" in page


@pytest.mark.parametrize(
    ("text", "words", "status"),
    [
        (WRONG, ["--no-suggest"], 0),
        (WRONG, [], 1),
        (DOUBTED, [], 0),
        (DOUBTED, ["--suspects"], 1),
        (DOUBTED, ["--strict"], 1),
    ],
)
def test_only_what_is_supported_fails_a_run(
    text: str, words: list[str], status: int, tmp_path: Path
) -> None:
    (tmp_path / "m.tex").write_text(text)
    assert main(["paper", str(tmp_path / "m.tex"), *words]) == status


def test_the_json_has_what_is_true_instead(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_text(WRONG)
    main(["paper", str(tmp_path / "m.tex"), "--json"])
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert rows[0]["instead"] == []
    assert rows[1]["instead"][0] == {
        "claim": "cos(2*x) == 2*cos(x)**2 - 1",
        "given": "",
        "edit": "- 1 in place of + 1",
        "verdict": "PROVED",
    }


@pytest.mark.parametrize(("words", "count"), [([], 1), (["--no-suggest"], 0)])
def test_check_suggests_unless_told_not_to(
    words: list[str], count: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", "sqrt(x**2) == x", *words]) == 1
    assert capsys.readouterr().out.count("given x >= 0 (given x >= 0)") == count


def test_a_term_between_equal_ends_may_be_a_substitution(tmp_path: Path) -> None:
    text = r"""We use the sine as the new variable $v$:
    \[ \int \cos^3 s\,ds = v - \frac{v^3}{3} + C = \sin s - \frac{\sin^3 s}{3} + C. \]"""
    assert not {"SUSPECT", "REFUTED"} & {*statuses(tmp_path, text)}


def test_an_identity_before_an_equation_does_not_make_that_a_misprint(tmp_path: Path) -> None:
    text = r"Solve \[ \sin 2x = 2\sin x\cos x = \cos x. \]"
    assert statuses(tmp_path, text)[0] == "PROVED"
    assert statuses(tmp_path, text)[1] != "SUSPECT"


def test_a_constant_of_integration_on_both_sides_is_no_unknown(tmp_path: Path) -> None:
    text = r"We have \[ x\sin 2x + C = 2x\sin x\sin x + C. \]"
    assert statuses(tmp_path, text) == ["REFUTED"]


@pytest.mark.parametrize(
    ("words", "status"),
    [
        (r"\small", "SUSPECT"),
        ("Using the order $dy\\,dx$ we find", "SUSPECT"),
        ("To the order $x^2$ we find", "UNDECIDED"),
        ("For small values", "UNDECIDED"),
    ],
)
def test_sizes_of_type_and_orders_of_integration_are_no_approximations(
    words: str, status: str, tmp_path: Path
) -> None:
    assert statuses(tmp_path, rf"{words} \[ \frac{{1}}{{2}} + \frac{{1}}{{3}} = 1. \]") == [status]


def test_a_symbol_whose_new_value_is_not_read_has_not_its_old_one(tmp_path: Path) -> None:
    text = r"""\begin{align*} u &= x^2 & v &= \sin x \\ du &= 2x\ dx & dv &= \cos x\ dx
    \end{align*}
    \begin{align*} u &= 2x & v &= \text{?} \\ du &= \text{?} & dv &= \sin x\ dx \end{align*}"""
    assert not {"SUSPECT", "REFUTED"} & {*statuses(tmp_path, text)}


def test_an_integral_without_a_known_value_is_suspect_if_a_neighbour_has_the_value(
    tmp_path: Path,
) -> None:
    (row,) = read(
        tmp_path, r"Hence \[ \int_0^\infty \frac{x^2}{e^x+1}\,dx = \frac{7\pi^4}{120} . \]"
    )
    assert row.status in ("SUSPECT", "REFUTED")
    assert row.instead[0].claim == "integral(x**3/(exp(x) + 1), x, 0, oo) == 7*pi**4/120"


def test_what_stopped_a_decision_says_whether_a_misprint_is_sought(tmp_path: Path) -> None:
    """An integral without a known value may be misprinted; what was stopped says nothing."""
    (tmp_path / "m.tex").write_text(r"Hence \[ \int_0^a e^{-x^2}\,dx = a^2 . \]")
    (link,) = read_links(read_manuscript(tmp_path / "m.tex"))
    row = Row(link, "UNDECIDED", "some reason in words", cause=Cause.NO_VALUE)
    assert may_be(row)
    assert may_be(replace(row, cause=Cause.NO_POINT))
    assert not may_be(replace(row, cause=Cause.STOPPED))


NOT_HIDDEN = {
    r"Pick $t$ in some interval. \[ y = (1-x)(1-t) + xt = 1 - x - t - 2xt \]": "REFUTED",
    r"Fix $x > 0$. Then \[ y = e^{1-x} + e^1 (1 - e^{x/s}) - e^1 "
    r"= e^1 (e^{-x} - e^{-x/s}) \]": "REFUTED",
    r"\[ T\frac{\eta_{i+1}-\eta_i}{h} - T\frac{\eta_i-\eta_{i-1}}{h} "
    r"= T\frac{\eta_{i+1}-\eta_{i-1}}{h} \]": "SUSPECT",
    r"\[ \sum_{k=1}^n k(k+1) = \frac{n(n+1)(n-2)}{3} \]": "REFUTED",
    r"The rate is \[ R = \frac{c^3/\sqrt{G^3 q}}{1/\sqrt{G q}} = \frac{c^3}{G} \]": "UNDECIDED",
}


@pytest.mark.parametrize("text", NOT_HIDDEN)
def test_words_hide_no_misprint(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status == NOT_HIDDEN[text]
    assert row.instead or row.holds_given


FUNCTIONAL = (
    *(r"f(x) = f(-x)", r"f(x + y) = f(x) + f(y)", r"f(x + T) = f(x)"),
    *(r"f(x) f(y) = f(x + y) + f(x-y)", r"a_{n+1} - a_n = a_n - a_{n-1}"),
    r"x_{n+1} - x_n = x_{n} - x_{n+1}",
)


@pytest.mark.parametrize("text", FUNCTIONAL)
def test_equations_for_functions_and_sequences_are_no_misprints(text: str, tmp_path: Path) -> None:
    (row,) = read(tmp_path, rf"\[ {text} \]")
    assert row.status == "EQUATION"


LISTED = {
    r"The error function \[ \int_0^x t\,dt = \frac{x^2}{3} \] is approximate.": True,
    r"For $x \ge 0$, \[ \frac{x}{x + 1} > \frac12 \]": True,
    r"Solve \[ x^2 + x = 2x. \]": False,
    r"Let $s > 0$. \[ y = \sqrt{s^2 + r^2 + 2sr} = s + r \]": False,  # it holds for r > 0
}


@pytest.mark.parametrize("text", LISTED)
def test_what_fails_somewhere_is_listed(text: str, tmp_path: Path) -> None:
    rows = read(tmp_path, text)
    told = [row for row in rows if row.status in ("REFUTED", "SUSPECT")]
    assert bool([*told, *failing(rows)]) == LISTED[text]


def test_digits_that_are_cut_off_are_within_a_unit(tmp_path: Path) -> None:
    row = read(tmp_path, r"\[ 2 \approx 1 \]")[-1]
    assert row.status not in ("PROVED", "ENCLOSED")
    row = read(tmp_path, r"\[ \frac23 \approx 0.6 \]")[-1]
    assert row.status in ("PROVED", "ENCLOSED")


def test_an_integral_that_needs_a_positive_end_is_no_misprint(tmp_path: Path) -> None:
    text = r"\[ \int_1^x \frac{1}{t^2}\,dt = \left[-\frac1t\right]_1^x = 1 - \frac1x \]"
    assert {"SUSPECT", "REFUTED"}.isdisjoint(statuses(tmp_path, text))


FAMILIES = (
    *("REFUTED", "REFUTED", "REFUTED", "SUSPECT"),  # a sum, a derivative, second terms
    *("DEFINED", "SUSPECT", "DEFINED", "SUSPECT"),  # chains beside "choose", "would", "some"
    *("PROVED", "PROVED", "PROVED", "PROVED"),  # "ring", \mathscr, a column, \simeq
    *("UNREAD", "UNREAD", "UNDECIDED"),  # a variation, D/Dt, positive constants
    *("EQUATION", "EQUATION", "DEFINED", "DEFINED", "SUSPECT"),  # an unknown, a special case
)


def test_families_of_misprints_and_of_what_is_none(tmp_path: Path) -> None:
    text = Path(__file__).parents[1].joinpath("data", "misprints.tex").read_text(encoding="utf-8")
    assert tuple(statuses(tmp_path, text)) == FAMILIES


@pytest.mark.night
@pytest.mark.parametrize(("name", "share"), [("chains", 0.85), ("expansions", 0.8)])
def test_planted_errors_are_told(name: str, share: float) -> None:
    path = Path(__file__).parents[1] / "data" / f"{name}.tex"
    found = [one.outcome for one in outcomes(path, "judged", "1", 40, 3)]
    told = sum(one.startswith(("told", "listed")) for one in found)
    assert told >= share * sum(one != "kept" for one in found)


def test_a_ratio_of_another_quantity_is_no_second_definition(tmp_path: Path) -> None:
    text = r"The Mach number is \[ M = \frac{V}{c_s} \] in the shell \[ M = \frac{w}{c_s}. \]"
    assert statuses(tmp_path, text) == ["DEFINED", "DEFINED"]


def test_an_equation_in_the_words_before_may_be_the_condition(tmp_path: Path) -> None:
    """At a fixed point y = x**y, the derivative x**y*log(x) is y*log(x)."""
    text = (
        "% tresym: let x real\n"
        + r"Take \[ f(t) = x^t . \] %s this becomes \[ f'(y) = y\log x . \]"
    )
    for words, status in (("At a point with $y = x^y$", "UNDECIDED"), ("Therefore", "SUSPECT")):
        assert read(tmp_path, text.replace("%s", words))[-1].status == status
