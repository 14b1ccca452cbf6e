"""The reference of functions names every function, and prints all formulas."""

from tresym.reals.functions.table import TABLE
from tresym.report.pages.functions import page


def test_every_function_has_an_entry() -> None:
    text = page()
    for name, row in TABLE.items():
        if not row.internal:
            assert f"**`{name}" in text, name
            assert all(claim in text for claim in row.falsehoods)
    assert "_tail" not in text
    assert text.count("<svg") > 50
