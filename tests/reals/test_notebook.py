"""Values in one line, and as tables for notebooks."""

from tresym.reals.notebook import LONGEST, html_table, in_one_line


def test_a_line_is_one_and_not_long() -> None:
    assert in_one_line("a\n  b") == "a b"
    assert in_one_line("x" * LONGEST) == "x" * LONGEST
    assert in_one_line("x" * 10**6) == "x" * (LONGEST - 1) + "…"


def test_a_table_holds_text_and_no_marks_of_its_own() -> None:
    found = html_table("<i>", [("x < 1", "<b>"), ("one",)])
    assert found.startswith("<b>&lt;i&gt;</b><table><tr><td style='text-align:left'>x &lt; 1</td>")
    assert found.count("<tr>") == 2
    assert "<b>" not in found.removeprefix("<b>")
