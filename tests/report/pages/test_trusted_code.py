"""What has to be trusted: the count reaches what decides."""

import re
from pathlib import Path

import tresym
from tresym.report.pages.coq_page import STATEMENTS
from tresym.report.pages.trusted_code import ROOTS, counted, piece_of, reached, trusted

HOME = Path(tresym.__file__).parent


def test_lines_are_of_code_alone() -> None:
    assert counted({("reals.verdict", "Verdict")}) == 5


def test_what_issues_verdicts_reaches_what_decides_and_what_only_searches() -> None:
    found = reached()
    for name in (
        *ROOTS,
        "reals.normal.ring.Ring.reduce",  # a method whose name is used
        "reals.normal.ring.Fraction.__rsub__",
        "reals.expansions.gruntz.Rewritten._cbrt",  # a method that is picked by a made name
        "reals.expansions.expansions.Expansions._sin",
        "reals.signs.sign.sign_by",
        "reals.balls.branch_and_bound.Bound",
    ):
        assert piece_of(name) in found, name
    assert ("reals.decisions.answer", "Answer.as_json") not in found
    assert counted(found) == trusted()


def test_statements_for_coq_are_made_without_deciders() -> None:
    makers = {"coq.export", "coq.ledger_statements", "coq.statement", "coq.theorem_trees"}
    makers |= {"coq.implicit_statements", "coq.solution_statements", "coq.theorem_form"}
    files = {file for file, _ in reached(STATEMENTS)}
    assert {name for name in files if name.startswith("coq.")} - makers <= {"coq.coqtop"}
    others = {tuple(name.split(".")[:2]) for name in files}
    assert not others & {("reals", p) for p in ("normal", "signs", "decisions", "repair")}
    assert "ledger.judge" not in files
    assert trusted(STATEMENTS) < trusted() / 4
    for name in ("ledger_statements", "statement", "theorem_trees"):
        text = (HOME / "coq" / f"{name}.py").read_text(encoding="utf-8")
        imported = {f"coq.{m}" for m in re.findall(r"^from tresym\.coq\.(\w+)", text, re.MULTILINE)}
        assert imported <= makers
