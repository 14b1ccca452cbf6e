"""Solutions are put into the equation before them: proved, refuted, or left undecided."""

from pathlib import Path

import pytest
from manuscripts import read

OSCILLATOR = r"The oscillator \[ \ddot{x} + \omega^2 x = 0 \] has the solution "
FALL = r"A ball obeys \[ \ddot{z} = -g, \qquad z(0) = h, \qquad \dot{z}(0) = v \] The solution is "
CUBIC = r"For small $\epsilon$ the cubic \[ y^3 + \epsilon y = 1 \] has the root "

QUADRATIC = r"The quadratic \[ a x^2 + 2 b x + c = 0 \] has the root "

CASES = {
    OSCILLATOR + r"\[ x = A\cos\omega t + B\sin\omega t . \]": "PROVED",
    OSCILLATOR + r"\[ x = A\cos 2\omega t . \]": "REFUTED",
    r"We know \[ \ddot{x} + \omega^2 x = 0 . \] Put \[ x = A\cos 2\omega t . \]": "UNDECIDED",
    r"The decay \[ N'(t) = -\lambda N(t) \] has the solution \[ N(t) = N_0 e^{-\lambda t} \]": (
        "PROVED"
    ),
    r"The decay \[ N'(t) = -\lambda N(t) \] has the solution \[ N(t) = N_0 e^{\lambda t} \]": (
        "REFUTED"
    ),
    r"The heat flow \[ \frac{d^2 u}{ds^2} = k^2 u \] is solved by \[ u = C e^{-ks} \]": "PROVED",
    QUADRATIC + r"\[ x = \frac{-b + \sqrt{b^2-ac}}{a} \]": "PROVED",
    QUADRATIC + r"\[ x = \frac{-b + \sqrt{b^2-ac}}{2a} \]": "REFUTED",
    FALL + r"\[ z = h + v t - \frac{g t^2}{2} \]": "PROVED",
    FALL + r"\[ z = h - v t - \frac{g t^2}{2} \]": "REFUTED",
    FALL + r"\[ z = v t - \frac{g t^2}{2} \]": "REFUTED",
    # a part of a system, and letters that mean something else, refute nothing
    r"The circle \[ p^2 + q^2 = r^2 \] is described by the solution \[ p = r\cos\varphi \]": (
        "DEFINED"
    ),
    # what was no equation is not solved
    r"Note that \[ (x+1)^2 = x^2 + 2x + 1 . \] Let \[ x = r s \]": "DEFINED",
    r"The Lagrangian is \[ L = T - U \] or \[ L = T - W . \] With $W = U$, the solution is"
    r" \[ L = T - W \]": "DEFINED",
    r"Here \[ \frac{\partial L}{\partial q} - \frac{d p}{dt} = -\frac{dp}{dt} \] with the solution"
    r" \[ L = T - U \]": "DEFINED",
    r"Here $\dot{s} = 1$ and \[ \ddot{x} = 0 \] has the solution \[ x = s^2 + t \]": "DEFINED",
    # expansions of roots
    CUBIC + r"\[ y = 1 - \frac{\epsilon}{3} + O(\epsilon^2) \]": "ENCLOSED",
    CUBIC + r"\[ y = 1 + \frac{\epsilon}{3} + O(\epsilon^2) \]": "REFUTED",
    CUBIC + r"\[ y \sim 1 - \frac{\epsilon}{3} \]": "ENCLOSED",
    r"Kepler's equation \[ E - k\sin E = M \] gives for small $k$ \[ E = M + k\sin M + O(k^2) \]": (
        "PROVED"
    ),
}


@pytest.mark.parametrize("text", CASES)
def test_a_solution_is_put_into_its_equation(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status == CASES[text], row.why
    if row.status in ("PROVED", "ENCLOSED"):
        assert "it solves the equation of line 1" in row.why


def test_the_branch_near_the_first_term_is_meant(tmp_path: Path) -> None:
    """Two roots of this cubic stay finite; without a branch the claim is not decided."""
    text = r"""For small $\epsilon$ \[ \epsilon x^3 + x^2 - 1 = 0 \] has the root
    \[ x = 1 - \frac{\epsilon}{2} + %s\epsilon^2 + O(\epsilon^3) \]"""
    assert read(tmp_path, text % r"\frac58")[-1].status == "ENCLOSED"
    assert read(tmp_path, text % r"\frac38")[-1].status == "REFUTED"


def test_a_value_drawn_from_a_constraint_does_not_prove_it(tmp_path: Path) -> None:
    text = (
        r"Matching gives \begin{align} -X\sqrt{s} &= -7A X \\ A &= \frac{\sqrt{s}}{7} \end{align}"
    )
    assert [row.status for row in read(tmp_path, text)] == ["EQUATION", "PROVED"]


def test_a_definition_is_not_put_in_for_the_variable_of_the_path(tmp_path: Path) -> None:
    """Along X -> -oo the scaled variable X = x/s stands for itself."""
    text = r"""The inner variable is \[ X = \frac{x}{s} . \] As $X \to 0$,
    \[ \sin X \sim X \]"""
    row = read(tmp_path, text)[-1]
    assert row.status in ("PROVED", "ENCLOSED")
    assert "substituted" not in row.why


DRAWN = {
    r"\[ x^2 + y^2 = r^2, \quad y = \sqrt{r^2 - x^2} \]": "EQUATION",
    r"\[ \sqrt{1 - \beta^2} = \frac1\gamma, \quad \gamma = \frac{1}{\sqrt{1-\beta^2}} \]": (
        "EQUATION"
    ),
    r"\[ x + y = 10 \] Hence \[ y = 10 - x \] \[ x + y = 10 \]": "EQUATION",
    r"\[ T = \frac{2\pi}{w} = \unreadable{x} \] \[ T = \frac{2\pi}{w} \]": "DEFINED",
    r"\[ t = \frac1a \] \[ 1 + t = \frac{a + 1}{a} \]": "PROVED",
}


@pytest.mark.parametrize("text", DRAWN)
def test_a_constraint_is_not_proved_by_what_was_drawn_from_it(text: str, tmp_path: Path) -> None:
    rows = read(tmp_path, text)
    assert (rows[0] if ", \\quad" in text else rows[-1]).status == DRAWN[text]


def test_a_link_of_a_chain_is_no_premise_of_the_next(tmp_path: Path) -> None:
    rows = read(tmp_path, r"\[ \sin 2x + 1 = 2\sin x\cos y + 1 = 1 + 2\cos x\sin x \]")
    assert [row.status for row in rows] == ["EQUATION", "EQUATION"]


def test_what_is_called_a_function_elsewhere_is_no_constant_of_a_derivative(tmp_path: Path) -> None:
    text = (
        r"\[ S = (z^2 + 1) P \qquad S' = %s \] The solution is \[ P(z) = \frac{1}{\sqrt{z^2+1}} \]"
    )
    for slope in ("2zP", "zP"):
        row = read(tmp_path, text % slope)[1]
        assert row.status != "PROVED"
