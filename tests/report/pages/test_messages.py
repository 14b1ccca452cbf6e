"""The list of messages has the errors, reasons and help texts of the sources, and no docstrings."""

from tresym.report.pages.messages import messages


def test_errors_help_texts_and_reasons_are_listed_and_no_docstrings() -> None:
    page = messages()
    assert "- `` check: give either one claim or -f FILE ``" in page  # an error
    assert "- `` the LaTeX source of the paper ``" in page  # a help text
    assert "## `reals/decisions/inequalities`" in page  # reasons
    assert "…" in page  # the gap of an f-string
    # Docstrings are not.
    assert "Write the page of messages" not in page
    assert "Seconds of tests" not in page
