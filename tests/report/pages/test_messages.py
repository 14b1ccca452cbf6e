"""The list of messages has the errors, reasons and help texts of the sources, and no docstrings."""

from tresym.report.pages.messages import messages


def test_errors_help_texts_and_reasons_are_listed() -> None:
    page = messages()
    assert "- `` check: give either one claim or -f FILE ``" in page  # an error
    assert "- `` the LaTeX source of the paper ``" in page  # a help text
    assert "## `reals/decisions/inequalities`" in page  # reasons
    assert "…" in page  # the gap of an f-string


def test_docstrings_are_not_listed() -> None:
    assert "Write the page of messages" not in messages()
    assert "Seconds of tests" not in messages()
