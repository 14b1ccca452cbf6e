"""An equation that is an earlier one times a factor is proved from it; another one is not."""

from pathlib import Path

import pytest
from cases import cases
from hangs import HANGS

from tresym.manuscript.deciding import decided
from tresym.manuscript.links import read_links
from tresym.manuscript.multiples import multiple_of
from tresym.manuscript.source import read_manuscript
from tresym.reals.language.parsing import parse_claim

ENERGY = r"The energy is \[ \frac12 m v^2 + m g h = E \] so that "


@pytest.mark.parametrize(
    ("text", "status"),
    [
        (ENERGY + r"\[ v^2 + 2 g h = \frac{2E}{m} \]", "PROVED"),
        (ENERGY + r"\[ v^2 + g h = \frac{2E}{m} \]", "EQUATION"),
        (ENERGY + r"\[ -m v^2 - 2 m g h = -2E \]", "PROVED"),
        (r"Here \[ y'' + x y' = y^2 \] or \[ \frac{y''}{x} + y' - \frac{y^2}{x} = 0 \]", "PROVED"),
        (r"Here \[ y'' + x y' = y^2 \] or \[ \frac{y''}{x} + y' - \frac{y}{x} = 0 \]", "EQUATION"),
    ],
)
def test_an_equation_follows_from_the_one_before(text: str, status: str, tmp_path: Path) -> None:
    (tmp_path / "m.tex").write_text(text)
    row = decided(read_links(read_manuscript(tmp_path / "m.tex")), HANGS, 1)[-1]
    assert row.status == status, row.why
    assert ("equation of line 1" in row.why) is (status == "PROVED")


@pytest.mark.parametrize(
    ("first", "second", "factor"),
    cases(__file__, "the_factor_is_a_product_of_powers"),
)
def test_the_factor_is_a_product_of_powers(first: str, second: str, factor: str | None) -> None:
    found = multiple_of(parse_claim(first)[0], parse_claim(second)[0])
    assert (None if found is None else str(found.factor)) == factor
