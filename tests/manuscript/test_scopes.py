"""How far definitions and conditions of a manuscript reach."""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import read, statuses

CLAIM = r"Now \[ w^2 = x^4 \]"
"""It is true where w stands for x²."""

WITHIN = (
    r"\begin{theorem} Let $w = x^2$. \end{theorem} %s",
    r"\begin{thm} Let $w = x^2$. \end{thm} %s",
    r"\newtheorem{satz}{Theorem} \begin{satz} Let $w = x^2$. \end{satz} %s",
    r"\begin{proof} Let $w = x^2$. \end{proof} %s",
    r"\begin{example} Let $w = x^2$. \end{example} %s",
    r"\begin{eg} Let $w = x^2$. \end{eg} %s",
    "\n\\textbf{Example 1.} Let $w = x^2$.\n\n\\textbf{Example 2.} %s",
    "\n{\\bf Example} Let $w = x^2$.\n\n{\\bf Remark} %s",
    "\n\\emph{Case 1:} Let $w = x^2$.\n\n\\emph{Case 2:} %s",
    "\nCase 1. Let $w = x^2$.\n\nCase 2. %s",
    "In the first example let $w = x^2$.\nThe second example is simpler. %s",
    r"\begin{enumerate} \item Let $w = x^2$. \item %s \end{enumerate}",
    r"\begin{itemize} \item Let $w = x^2$. \end{itemize} %s",
    r"\begin{proof} \begin{enumerate} \item a \item Let $w = x^2$. \end{proof} %s",
    r"\chapter{A} Let $w = x^2$. \chapter{B} %s",
    r"Let $w = x^2$. And let $w = x^3$. %s",
    r"Let $w = x^2$. It is $w = x^3$. %s",
)


@pytest.mark.parametrize("text", WITHIN)
def test_a_definition_ends_with_its_scope(text: str, tmp_path: Path) -> None:
    assert read(tmp_path, text % CLAIM)[-1].status not in ("PROVED", "REFUTED")


BEYOND = (
    r"Let $w = x^2$. %s",
    r"\section{A} Let $w = x^2$. \section{B} %s",
    r"Let $w = x^2$. \begin{proof} Let $w = x^3$. \end{proof} %s",
    r"\begin{proof} Let $w = x^2$. %s \end{proof}",
    r"\begin{theorem} Let $w = x^2$. \end{theorem} \begin{proof} %s \end{proof}",
    r"\begin{exercise} Let $w = x^2$. \end{exercise} \begin{solution} %s \end{solution}",
    r"\begin{enumerate} \item Let $w = x^2$. %s \end{enumerate}",
    r"\begin{definition} Let $w = x^2$. \end{definition} %s",
    r"Let $w = x^3$. With $w = x^2$, we have \[ w^2 = x^4 \]",
    "In our next example let $w = x^2$. As in the first example, %s",
    "Problem solved: let $w = x^2$.\n\nCases differ. %s",
)


@pytest.mark.parametrize("text", BEYOND)
def test_and_not_before(text: str, tmp_path: Path) -> None:
    text = text % CLAIM if "%s" in text else text
    assert read(tmp_path, text)[-1].status == "PROVED"


@pytest.mark.parametrize(
    "text",
    cases(__file__, "a_condition_at_a_point_or_a_hypothesis_defines_nothing"),
)
def test_a_condition_at_a_point_or_a_hypothesis_defines_nothing(text: str, tmp_path: Path) -> None:
    assert read(tmp_path, text)[-1].status not in ("PROVED", "REFUTED")


def test_the_solution_of_an_exercise_has_its_definitions(tmp_path: Path) -> None:
    text = (
        r"\section{Exercise 1} Let $h(t) = e^{2t}$. \subsection{Solution} Then \[ h'(t) = 2 h(t) \]"
    )
    assert read(tmp_path, text)[-1].status == "PROVED"


@pytest.mark.parametrize(
    "text",
    [
        r"Suppose we want $x > 0$. In general \[ |x| = x \]",
        r"We need to find $x$ where $x > 0$. First \[ |x| = x \]",
        r"Suppose for contradiction that $x > 0$. In general \[ \sqrt{x^2} = x \]",
        r"\begin{itemize} \item Let $x > 0$. \item In general \end{itemize} \[ |x| = x \]",
        r"\begin{theorem} Let $x > 0$. \end{theorem} In general \[ |x| = x \]",
        "\n\\textbf{Case 1.} Let $x > 0$.\n\n\\textbf{Case 2.} Here \\[ |x| = x \\]",
    ],
)
def test_a_condition_ends_with_its_scope(text: str, tmp_path: Path) -> None:
    assert read(tmp_path, text)[-1].status not in ("PROVED", "REFUTED")


@pytest.mark.parametrize(
    "text",
    [
        r"Let $A = 2x$. \[ A = \lim_{k\to\infty} \frac{kx}{k+1} \]",
        r"\[ u = x^3 \] \[ u = \int x\,dx \]",
        r"\[ L := \frac{1}{x} \]",
        r"\[ A = \lim_{k\to\infty} |a_{k+1}/a_k| \]",
    ],
)
def test_a_lone_symbol_on_the_left_is_no_falsehood(text: str, tmp_path: Path) -> None:
    assert read(tmp_path, text)[-1].status in ("DEFINED", "UNREAD", "UNDECIDED")


@pytest.mark.parametrize("words", ["For", "Für", r"F\"ur", "Pour", "Para"])
def test_conditions_are_read_behind_words_of_other_languages(words: str, tmp_path: Path) -> None:
    text = rf"{words} $x %s 0$: \[ x^3 + x \ge 0 \]"
    assert statuses(tmp_path, text % r"\ge") == ["PROVED"]
    assert statuses(tmp_path, text % r"\le") != ["PROVED"]
