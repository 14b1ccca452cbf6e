"""Words that change what a formula means leave it unread; others near them do not."""

from pathlib import Path

import pytest
from manuscripts import statuses

from tresym.commands import main

CHANGED = (
    # words, and a formula that is wrong or right by them, but not by the usual reading
    (r"All logarithms have base 2, so $\log$ is written for $\log_2$.", r"\log 64 = 6"),
    (r"Here $\log$ is the logarithm to base 2.", r"\frac{d}{dx}\log x = \frac{1}{x}"),
    (r"We use common logarithms throughout.", r"\log 1000 = 3"),
    (r"The loss is given in decibels.", r"10\log 100 = 20"),
    (r"The angle $a$ is measured in degrees.", r"\frac{d}{da}\sin a = \cos a"),
    (r"Angles are in degrees.", r"\cos 60 = \frac12"),
    (r"By the Euclidean algorithm we find the divisor.", r"(252, 105) = (105, 42)"),
    (r"In polar coordinates points have several names.", r"(2, 1) = (-2, 1 + \pi)"),
    (r"In the circuit flows a current.", r"3 + 4i = 4 + 5i"),
    (r"Derivatives by Grassmann variables are odd.", r"\frac{d}{db} ab = -a"),
    (r"Let $\sigma$ and $\tau$ be transpositions.", r"\sigma\tau = \tau\sigma"),
    (r"Let $\pi$ be a permutation of five letters.", r"\pi(4) = 5"),
    (r"The firm's profit $\pi$ is 3 in this year.", r"\pi = 3"),
    (r"Let $u$ and $v$ be words over an alphabet.", r"u v = v u"),
    (r"Let $G$ be the group with presentation", r"a^3 c = c a^{24}"),
    (r"Let $\kappa$ be an infinite cardinal.", r"\kappa + 1 > \kappa"),
    (r"In the tropical semiring we have", r"a + a = 2 a"),
    (r"All equalities are meant modulo 7.", r"3 \cdot 5 = 1"),
    (r"But $x \equiv 46 \mod{60}$, so that", r"5 \cdot 46 \equiv 50"),
    (r"We look at squares in $\mathbb{Z}_{10}$.", r"4^2 = 6"),
    (r"Find $x \in \mathbb{Z}/5$ with the square 4.", r"3^2 = 4"),
    (r"Let $A$ be a boolean ring. \subsection{Sums}", r"a^2 + ab + ba + b^2 = a + ab + ba + b"),
    (r"The map is a homomorphism because", r"3xy = 6xy + 3xy"),
    (r"For the remainders,", r"230 \equiv 50 + 60 \equiv 50 \pmod{60}"),
    (r"\section{Arithmetic modulo 7} We find", r"3 + 5 = 1"),
    (r"\section{Logarithms to base two} Then", r"\frac{d}{dx}\log x = \frac{1}{x}"),
    (r"\chapter{All angles are in degrees}\section{First} Now", r"\sin 30 = \frac12"),
    (r"In binary notation,", r"11 + 1 = 12"),
    (r"Let $\omega$ be a cube root of unity.", r"\omega^4 = \omega"),
    (r"Let $A$, $B$ and $C$ be the angles of a triangle.", r"\sin(A+B) = \sin C"),
    (r"The force $F$ varies with the time $t$.", r"\frac{d}{dt}(F t) = F"),
)


@pytest.mark.parametrize(("words", "formula"), CHANGED)
def test_words_that_change_a_formula_leave_it_unread(
    words: str, formula: str, tmp_path: Path
) -> None:
    assert statuses(tmp_path, rf"{words} \[ {formula} \]") == ["UNREAD"]


UNCHANGED = (
    (r"Here $\log$ is the logarithm to the base $e$.", r"\log 1 = 0"),
    (r"We use no logarithms to base 2.", r"\log 1 = 0"),
    (r"In other words, for all $x$,", r"(x+1)^2 = x^2 + 2x + 1"),
    (r"Each group of students gives a presentation.", r"(x+1)^2 = x^2 + 2x + 1"),
    (r"A ring of wire has the radius $r$, and $n \in \mathbb{Z}_+$.", r"(x+1)^2 = x^2 + 2x + 1"),
    (r"The degree of the polynomial is 2.", r"(x+1)^2 = x^2 + 2x + 1"),
    (r"Angles are in degrees. \section{Radians}", r"\sin^2 x + \cos^2 x = 1"),
    (r"The force $F$ varies with the time $t$.", r"(F + 1)^2 = F^2 + 2F + 1"),
)


@pytest.mark.parametrize(("words", "formula"), UNCHANGED)
def test_other_words_leave_a_formula_to_be_proved(words: str, formula: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, rf"{words} \[ {formula} \]") == ["PROVED"]


@pytest.mark.parametrize("formula", [r"\int_0^1 dx\, x = x", r"\int_0^2 dx\, x^3 = 2x^3"])
def test_what_follows_a_differential_is_integrated(formula: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, rf"For all $x$, \[ {formula} \] \[ \int_0^1 dx = 1 \]") == [
        "REFUTED",
        "PROVED",
    ]


GOOD = r"\[ (a+b)^2 = a^2 + 2ab + b^2 \]"
LOST = {
    "no first term": r"\[ n >> 1 \]",
    "a long display": r"\[ x = " + "x + " * 6000 + r"x \]",
    "a macro without end": r"\newcommand{\z}{1 + \z} \[ \z = 2 \]",
    "brackets spaced anew": (
        r"\let\oldleft\left \renewcommand{\left}{\mathopen{}\mathclose\bgroup\oldleft}"
        r" \[ \left(a+b\right)^2 = a^2 + 2ab + b^2 \]"
    ),
}


@pytest.mark.parametrize("name", LOST)
def test_one_part_that_is_not_understood_does_not_lose_the_rest(name: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, f"{LOST[name]}\n{GOOD}")[-1] == "PROVED"


def test_a_byte_of_latin_1_is_read_with_a_note(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_bytes(b"% caf\xe9\n" + GOOD.encode())
    assert main(["paper", str(tmp_path / "m.tex")]) == 0
    assert "read as Latin-1" in capsys.readouterr().err


def test_a_page_without_display_does_not_lose_the_others(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.md").write_text("# Nothing here\n")
    (tmp_path / "b.md").write_text("$$ 1 + 1 = 3 $$ is false; $$ x + x = 3x $$ too\n")
    (tmp_path / "c.tex").write_text("\\[ a = b")
    names = [str(tmp_path / name) for name in ("a.md", "b.md", "c.tex")]
    assert main(["paper", names[0], names[1]]) != 2
    assert main(["paper", *names]) == 2
    assert "2 displays" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("formula", "status"),
    [
        (r"0.999\ldots < 1", "UNREAD"),
        (r"0.999\ldots = 1", "UNREAD"),
        (r"1 = 0.999\cdots", "UNREAD"),
        (r"\cos 0 = 0.999\ldots", "UNREAD"),
        (r"\frac{3334}{10000} = 0.333\ldots", "UNREAD"),
        (r"a = 0.999\dots", "UNREAD"),
        (r"\pi > 3.14\ldots", "UNREAD"),
        (r"\pi = 3.14159\ldots", "ENCLOSED"),
        (r"\pi = 3.14160\ldots", "REFUTED"),
        (r"1.4142\ldots = \sqrt{2}", "ENCLOSED"),
        (r"\sum_{n=1}^{\infty} \frac{1}{n^2} = 1.6449\ldots", "ENCLOSED"),
    ],
)
def test_digits_that_go_on_are_no_exact_number(formula: str, status: str, tmp_path: Path) -> None:
    assert statuses(tmp_path, rf"We have \[ {formula}. \]") == [status]
