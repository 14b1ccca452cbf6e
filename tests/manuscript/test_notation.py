r"""Notation of physicists, kinds that are not mistaken, and what is no longer passed by mistake.

Each case is a text with the statuses of its links; a text with a false statement has one of its
neighbours that is true beside it.
"""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import read, statuses

from tresym.manuscript.notation import plain_notation
from tresym.manuscript.suspects import proofread

READ = tuple(cases(__file__, "READ"))
"""Texts whose last link holds."""


@pytest.mark.parametrize("text", READ)
def test_the_notation_of_physicists_is_read(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status in ("PROVED", "ENCLOSED"), row.why


WRONG = tuple(cases(__file__, "WRONG"))


@pytest.mark.parametrize("text", WRONG)
def test_what_is_false_in_it_is_no_pass(text: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, text)[-1] not in ("PROVED", "ENCLOSED", "DEFINED")


@pytest.mark.parametrize("text", WRONG[2:])
def test_a_false_closed_form_or_expansion_is_refuted(text: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, text)[-1] == "REFUTED"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # an expansion of a quantity with an equation is not defined by it
        (
            r"From \[ y e^y = x \] we get for large $x$ \[ y = \ln x + 3\ln\ln x + O(1) \]",
            "REFUTED",
        ),
        (
            r"Kepler: \[ E - k\sin E = M \] Hence \[ E = M + 2k\sin M + O(k^2) \]",
            "REFUTED",
        ),
        (
            r"The root of \[ z^3 + \epsilon z = 1 \] is"
            r" \[ z \sim 1 + \epsilon \qquad (\epsilon\to 0) \]",
            "REFUTED",
        ),
        # operators that look like factors
        (r"Along the flow \[ \frac{D}{Dt}(s^2) = \frac{s^2}{t} \]", "UNREAD"),
        (r"Along the flow \[ \frac{D s}{D t} = \frac{s}{t} \]", "UNREAD"),
        (r"\[ \delta\int L\,dt = \int\delta L\,dt \]", "UNREAD"),
        (r"\[ \{u, w\} = uw - wu = 0 \]", "UNREAD"),
        (r"\[ uw - wu = 0 \]", "UNREAD"),
        # n counts, and so tends to infinity
        (r"\[ 4n^2 + 7n \in O(n) \]", "UNDECIDED"),
        (r"\[ 4n^2 + 7n = O(n) \]", "UNDECIDED"),
        # units that are not known, or rounded numbers of them
        (r"\[ \SI{5}{\celsius} = \SI{278}{\kelvin} \]", "UNREAD"),
        (r"\[ \SI{5}{\kilo\meter} = 5\,\mathrm{km} \]", "UNREAD"),
        # metres are no seconds
        (r"\[ 5\,\mathrm{km} = 5000\,\mathrm{s} \]", "UNREAD"),
        (r"\[ 5\,\mathrm{kg} \cdot 2\,\mathrm{m/s^2} = 10\,\mathrm{J} \]", "UNREAD"),
        (r"\[ 3\,\mathrm{m} + 2\,\mathrm{s} = 5\,\mathrm{m} \]", "UNREAD"),
        (r"\[ \SI{24}{\hour} = \SI{86400}{\meter} \]", "UNREAD"),
        (r"\[ \SI{2.5}{\meter} = \frac{5}{2}\,\si{\second} \]", "UNREAD"),
        (r"\[ 120\text{ seconds} = 2\text{ hours} \]", "UNREAD"),
        (r"\[ \SI{2.4}{\hour} = \SI{8700}{\second} \]", "UNREAD"),
        # what is integrated is in doubt; i is no index
        (r"\[ \int_0^1 dx\, x + 1 = \frac32 \]", "UNREAD"),
        (r"\[ \sum_{k=1}^n i k = \frac{i n(n+1)}{2} \]", "UNREAD"),
        # a value at a point is no product
        (r"The height obeys $\ddot{z} = -g$ with \[ z(0) = 0 \]", "EQUATION"),
        (r"The height obeys $\ddot{z} = -g$ with \[ \dot{z}(0) = v \]", "EQUATION"),
        # a definition proves nothing by itself
        (r"The time is \[ t_c = 7\pi\sqrt{m/k} = ? \]", "DEFINED"),
        (r"The period is \[ P = \frac{7\pi}{\dot{\phi}} = \frac{K(k_1)}{\omega_0} \]", "DEFINED"),
    ],
)
@pytest.mark.slow
def test_what_looks_true_by_its_form_does_not_pass(
    text: str, expected: str, tmp_path: Path
) -> None:
    found = statuses(tmp_path, text)
    assert "PROVED" not in found
    assert expected in found
    if "O(" in text or r"\sim" in text:
        assert "DEFINED" not in found


def test_an_unknown_between_equal_terms_and_a_special_case_are_no_misprints(tmp_path: Path) -> None:
    text = r"""Both are known: \begin{align} 0.36 + 0.64 &= s^2 \\ &= 1 \end{align}
    At a distance $r$ from the axis \[ a = \frac{v^2}{r} \] and at the surface
    \[ a = \frac{v^2}{r_{s}} . \]"""
    assert "SUSPECT" not in {row.status for row in proofread(read(tmp_path, text), 1.0, 1)}


def test_one_bad_display_does_not_stop_the_file(tmp_path: Path) -> None:
    text = r"\[ (a + b^2 \} = { \] We have \[ (a+b)^2 = a^2 + 2ab + b^2 \]"
    rows = read(tmp_path, text)
    assert [row.status for row in rows] == ["UNREAD", "PROVED"]
    assert "braces" in rows[0].why


@pytest.mark.parametrize(
    "text", [r"\lim_{x \to 0^+} x", r"x^{+\infty}", r"x^{-1}", r"\mathbb{R}^+", r"A_{e}", r"2^{+3}"]
)
def test_other_notation_stays(text: str) -> None:
    assert plain_notation(text) == text


def test_symbols_without_letters_are_compared_as_well(tmp_path: Path) -> None:
    """Dots and infinity are symbols to the reader, and a second definition is compared."""
    text = r"\[ s = 1 + x + \dots \] and later \[ s = 1 - x + \dots \] and \[ s = 2 + x + \dots \]"
    assert len(proofread(read(tmp_path, text), 1.0, 1)) == 3


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (r"y_0(x)_\mathrm{out}", "y_{0out}(x)"),
        (r"Y(X)_{\mathrm{inn}}", "Y_{inn}(X)"),
        ("y'_1", "y_1'"),
        (r"\tau^\ast_1", r"\tau_{1star}"),
        (r"a_{i+\frac{1}{2}}", "a_{i+1/2}"),
        (r"Y(X=0)", "Y(0)"),
        (r"\cancelto{1}{w} y", " w y"),
        (r"(1 + x \dots)", r"(1 + x + \dots)"),
        (r"x_1 x_2 \dots x_n", r"x_1 x_2 \dots x_n"),  # a product
        (r"1, 2, \dots", r"1, 2, \dots"),
        (r"O(\epsilon^0): \quad & a = b", r"  \quad & a = b"),
        (r"f = O(\epsilon) : g", r"f = O(\epsilon) : g"),
    ],
)
def test_notation_of_expansions(text: str, plain: str) -> None:
    assert " ".join(plain_notation(text).split()) == " ".join(plain.split())


def test_a_prime_behind_a_function_of_two_variables_is_unread(tmp_path: Path) -> None:
    r"""By which one f'(0, t) is differentiated, it does not say; the line after it is judged."""
    text = r"\[ \int_0^1 f(s) ds + f'(0, t) = f(0, t) \] Also \[ (x + 1)^2 = x^2 + 2x + 1 \]"
    first, second = read(tmp_path, text)
    assert (first.status, second.status) == ("UNREAD", "PROVED")
    assert "several arguments" in first.why
