"""A link that follows from equations before it is proved from them; what does not follow is not."""

from pathlib import Path

import pytest
from manuscripts import read

ENERGY = r"The energy is \[ \frac12 m v^2 + m g h = E \] so that "
SLOPE = r"Here \[ y'' + x y' = y^2 \] or "
DECAY = r"Solve \[ u' + u + \epsilon u^2 = 0 \] by the series \[ u = u_0 + \epsilon u_1 + \dots \] "
ORDERS = DECAY + r"The orders are \[ u_0' + u_0 = 0, \qquad u_1' + u_1 + u_0^2 = 0 . \] "
LAYER = r"Integrate \[ Z'' + Z' = a \] once: "
WAVE = r"Put \[ w = e^{S} \] so that "
LINES = r"The system is \[ p + 2 q = 3 s \] \[ p - q = 0 \] "
ROOTS = r"The quartic \[ z^4 - 5 s^2 z^2 + 4 s^4 = 0 \] has the roots "

CASES = {
    ENERGY + r"\[ v^2 + 2 g h = \frac{2E}{m} \]": "PROVED",
    ENERGY + r"\[ v^2 + g h = \frac{2E}{m} \]": "EQUATION",
    ENERGY + r"\[ -m v^2 - 2 m g h = -2E \]": "PROVED",
    ENERGY + r"\[ h = \frac{2E - m v^2}{2 m g} \]": "PROVED",
    ENERGY + r"\[ h = \frac{E - m v^2}{2 m g} \]": "UNDECIDED",
    SLOPE + r"\[ \frac{y''}{x} + y' - \frac{y^2}{x} = 0 \]": "PROVED",
    SLOPE + r"\[ \frac{y''}{x} + y' - \frac{y}{x} = 0 \]": "EQUATION",
    # nothing follows from itself, whichever side comes first
    ENERGY + r"\[ \frac12 m v^2 + m g h = E \]": "EQUATION",
    ENERGY + r"\[ E = \frac12 m v^2 + m g h \]": "DEFINED",
    # the orders of a small parameter
    DECAY + r"The first order is \[ u_1' + u_1 + u_0^2 = 0 . \]": "PROVED",
    DECAY + r"The first order is \[ u_1' + u_1 + 2 u_0^2 = 0 . \]": "EQUATION",
    # order 2 needs a term that is left out
    DECAY + r"The second order is \[ u_2' + u_2 + 2 u_0 u_1 = 0 . \]": "EQUATION",
    DECAY + r"We get \[ (u_0' + \epsilon u_1' + \dots) + (u_0 + \epsilon u_1 + \dots)"
    r" + \epsilon (u_0 + \dots)^2 = 0 . \]": "PROVED",
    DECAY + r"We get \[ (u_0' + \epsilon u_1' + \dots) + (u_0 + \epsilon u_1 + \dots)"
    r" + 2\epsilon (u_0 + \dots)^2 = 0 . \]": "EQUATION",
    ORDERS + r"They give \[ u_0 = e^{-x} \]": "PROVED",
    ORDERS + r"They give \[ u_0 = e^{-2x} \]": "DEFINED",
    ORDERS + r"They give \[ u_0 = e^{-x} \] and \[ u_1 = e^{-2x} - e^{-x} . \]": "PROVED",
    ORDERS + r"They give \[ u_0 = e^{-x} \] and \[ u_1 = e^{-2x} - x e^{-x} . \]": "DEFINED",
    ORDERS + r"They give \[ u_0 = e^{-x} \] and \[ u_1' + u_1 = -e^{-2x} . \]": "PROVED",
    ORDERS + r"They give \[ u_0 = e^{-x} \] and \[ u_1' + u_1 = e^{-2x} . \]": "EQUATION",
    # derivatives and integrals
    WAVE + r"\[ w' = S' e^{S}, \qquad w'' = (S'' + (S')^2) e^S . \]": "PROVED",
    WAVE + r"\[ w' = S' e^{S}, \qquad w'' = (S'' + S') e^S . \]": "EQUATION",
    LAYER + r"\[ Z' + Z = a x + B \]": "PROVED",
    LAYER + r"\[ Z' + Z = 2 a x + B \]": "EQUATION",
    LAYER + r"\[ Z' + Z = a x \]": "EQUATION",
    # a constant that is there alone is not proved to be zero by its derivative
    LAYER + r"\[ Z = a x + B \] \[ a x + B = a x \]": "EQUATION",
    # a function with an argument in an integral that moves has no derivative here
    r"Put \[ w = \int_0^x \sqrt{1+s^4}\,ds + S \] so that \[ w' = S' \]": "EQUATION",
    # two equations
    LINES + r"\[ 3 p = 3 s \]": "PROVED",
    LINES + r"\[ 3 p = 4 s \]": "EQUATION",
    ROOTS + r"\[ z = 2 s \]": "PROVED",
    ROOTS + r"\[ z = 3 s \]": "REFUTED",
    # an equation that is a product may hold because of either factor
    r"Here \[ s y = 0 \] and \[ s q + s y = 0 \]": "EQUATION",
    # what is no series in the parameter has no orders
    r"Here \[ \frac{ds}{dt} = g \] with \[ g = g_0 + \epsilon g_1 + \dots \] so \[ g_1 = 0 \]": (
        "DEFINED"
    ),
    # two equations that contradict each other prove nothing
    r"Here \[ q' = -\epsilon q^3 s \] and \[ q' = -\epsilon q^3 w \] give"
    r" \[ \epsilon q s = \epsilon u \]": "EQUATION",
    # derivatives that are marked by subscripts
    r"Here \[ V_{XX} + V_X = 0 \] for \[ V = 2 + e^{-X} \]": "PROVED",
    r"Here \[ V_{XX} + V_X = 0 \] for \[ V = 2 + e^{X} \]": "DEFINED",
    r"Here \[ \epsilon V_t + V = s \] gives \[ V_0 = s \]": "DEFINED",
    # of another example nothing follows
    "\\paragraph{Example 1.} Here \\[ a y + b = c \\]\n\n\\paragraph{Example 2.} Here"
    r" \[ a y = c - b \]": "EQUATION",
}


@pytest.mark.parametrize("text", CASES)
def test_a_link_follows_from_those_before_it(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status == CASES[text], row.why
    assert "line 1" in row.why or row.status != "PROVED"


@pytest.mark.parametrize(("second", "status"), [("s", "PROVED"), ("2s", "DEFINED")])
def test_the_unknowns_of_a_system_are_put_in_together(
    second: str, status: str, tmp_path: Path
) -> None:
    """The second pair solves the first equation, but not the other."""
    text = r"\[ p_1 + p_2 = 3 s, \qquad p_1 - p_2 = s \] give \[ p_1 = %s, \qquad p_2 = %s \]"
    first = "2s" if second == "s" else "s"
    assert read(tmp_path, text % (first, second))[-1].status == status


def test_two_variables_of_a_function_are_kept_apart(tmp_path: Path) -> None:
    text = r"Here \[ \frac{dy}{dx} + y = 0 \] and \[ \frac{dy}{ds} = -y \]"
    assert read(tmp_path, text)[-1].status == "EQUATION"


def test_values_at_points_determine_constants(tmp_path: Path) -> None:
    text = r"""Solve \[ Y'' + Y' = 0 \] with $x$ as the variable. The values are \[ Y(0) = 1 . \]
    The solution is \[ Y = c_1 + c_2 e^{-x} \] and the value at the end gives \[ 1 = %s \]"""
    assert read(tmp_path, text % "c_1 + c_2")[-1].status == "PROVED"
    assert read(tmp_path, text % "c_1 - c_2")[-1].status == "EQUATION"


@pytest.mark.night
def test_an_integral_on_both_sides_may_have_any_value(tmp_path: Path) -> None:
    text = r"\[ \frac{2}{2\pi}\int_a^b \sin(q + r^3)\,dr = %s\int_a^b\sin(q + r^3)\,dr \]"
    assert read(tmp_path, text % r"\frac1\pi")[-1].status == "PROVED"
    assert read(tmp_path, text % r"\frac2\pi")[-1].status not in ("PROVED", "ENCLOSED")


def test_definedness_implies_the_sign_in_the_gaussian_integral(tmp_path: Path) -> None:
    text = r"\[ \int_{-\infty}^{\infty} e^{-s t^2}\,dt = %s \]"
    assert read(tmp_path, text % r"\sqrt{\frac{\pi}{s}}")[-1].status == "PROVED"
    assert read(tmp_path, text % r"\sqrt{\frac{\pi}{2 s}}")[-1].status == "REFUTED"


DIVIDED = r"Inserting gives \[ r^4 (g'' + (g')^2) + 2 r^3 g' - 1 = 0 \] %s \[ %s = 0 \]"


@pytest.mark.parametrize(
    ("words", "equation", "status"),
    [
        ("or, after division,", r"g'' + (g')^2 + \frac{2}{r^2} g' - \frac{1}{r^4}", "SUSPECT"),
        ("or, after division,", r"g'' + (g')^2 + \frac{2}{r} g' - \frac{1}{r^4}", "PROVED"),
        # two terms differ, another symbol stands in one, or the text announces nothing
        ("or, after division,", r"g'' + (g')^2 + \frac{2}{r^2} g' - \frac{1}{r^3}", "EQUATION"),
        ("or, after division,", r"g'' + (g')^2 + \frac{2}{r} g' - \frac{a}{r^4}", "EQUATION"),
        ("Another one is", r"g'' + (g')^2 + \frac{2}{r^2} g' - \frac{1}{r^4}", "EQUATION"),
    ],
)
def test_the_term_that_differs_is_told(
    words: str, equation: str, status: str, tmp_path: Path
) -> None:
    row = read(tmp_path, DIVIDED % (words, equation))[-1]
    assert row.status == status, row.why
    if status == "SUSPECT":
        assert "times r**(-4), the term 2*r**(-2)*g_prime should be 2/r*g_prime" in row.why
