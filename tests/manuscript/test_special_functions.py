"""Special functions in manuscripts: letters that the text uses otherwise keep its meaning."""

from pathlib import Path

import pytest
from manuscripts import read

TEXTS = {
    r"\[ \Gamma(x+1) = x\Gamma(x) \]": "PROVED",
    r"\[ \zeta(2) = \frac{\pi^2}{6} \]": "PROVED",
    r"Hence \[ \zeta(2) = \frac{\pi^2}{8}. \]": "REFUTED",
    r"The damping rate is $\Gamma$. Hence \[ \Gamma(1 + x) = \Gamma + \Gamma x. \]": "UNREAD",
}


@pytest.mark.parametrize("text", TEXTS)
def test_special_functions_in_a_manuscript(text: str, tmp_path: Path) -> None:
    statuses = [row.status for row in read(tmp_path, text)]
    assert statuses[-1] == TEXTS[text]


@pytest.mark.parametrize(
    "text",
    [
        r"Let $I_1$ be the first integral. \[ I_1(x) = 2x \]",
        r"\[ K(k) = \frac{\pi}{2} \]",
        r"\[ J_0(x) = 3 \]",
    ],
)
def test_letters_that_may_mean_anything_are_not_accused(text: str, tmp_path: Path) -> None:
    assert not {row.status for row in read(tmp_path, text)} & {"REFUTED", "SUSPECT"}
