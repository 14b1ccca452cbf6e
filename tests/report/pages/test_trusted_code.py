"""What has to be trusted: the count reaches what decides, and leaves out only what it names."""

import re
from pathlib import Path

import pytest

import tresym
from tresym.report.pages.coq_page import STATEMENTS
from tresym.report.pages.trusted_code import (
    ENCLOSING,
    LEDGER,
    RECHECKED,
    ROOTS,
    Count,
    counted,
    piece_of,
    reached,
    trusted,
)

HOME = Path(tresym.__file__).parent


@pytest.fixture(scope="module")
def counts() -> tuple[Count, Count]:
    return trusted()


def test_what_is_named_is_there() -> None:
    for name in (*ROOTS, *ENCLOSING, *(n for names in RECHECKED.values() for n in names)):
        path = HOME.joinpath(*name.split("."))
        if not (path.is_dir() or path.with_suffix(".py").is_file()):
            assert counted({piece_of(name)}).total > 0, name


def test_the_normal_form_is_trusted_and_the_advocate_is_not(counts: tuple[Count, Count]) -> None:
    proved, enclosed = counts
    assert {"reals.normal.ring", "reals.signs.sign", "ledger.judge"} <= {*proved.lines}
    assert {"reals.balls.branch_and_bound", "reals.expansions.series_arithmetic"} <= {
        *enclosed.lines
    }
    assert not {"reals.cross_check", "reals.language.latex"} & {*proved.lines, *enclosed.lines}
    assert not any(name.startswith("reals.balls.") for name in proved.lines)


def test_lines_are_of_code_alone() -> None:
    found = counted({("reals.verdict", "Verdict")})
    assert found.lines == {"reals.verdict": 5}


def test_a_method_is_reached_with_its_class_where_its_name_is_used() -> None:
    found = reached(())
    assert {("reals.normal.ring", "Ring"), ("reals.normal.ring", "Ring.reduce")} <= found
    assert ("reals.normal.ring", "Fraction.__rsub__") in found
    assert ("reals.decisions.answer", "Answer.as_json") not in found
    assert reached({"reals.normal.ring.Ring.reduce"}) < found


def test_libraries_are_named(counts: tuple[Count, Count]) -> None:
    proved, _ = counts
    assert {"arb", "fmpz_mpoly", ".factor"} <= {*proved.flint}
    assert "Integral" in proved.sympy


def test_the_ledger_reaches_the_normal_form_and_the_dispatcher() -> None:
    proved, _ = trusted(LEDGER)
    assert "reals.decisions.identity" in proved.lines  # the normal form
    assert "checking.dispatch" in proved.lines  # of claims that the general lemmas decide


def test_methods_that_are_picked_by_a_name_that_is_made_are_reached() -> None:
    found = reached(())
    assert ("reals.expansions.gruntz", "Rewritten._cbrt") in found
    assert ("reals.expansions.expansions", "Expansions._sin") in found


def test_exact_limits_prove_and_their_bounds_enclose(counts: tuple[Count, Count]) -> None:
    proved, enclosed = counts
    assert {"reals.expansions.expansions", "reals.expansions.gruntz"} <= {*proved.lines}
    assert "reals.expansions.series_arithmetic" in enclosed.lines


def test_statements_for_coq_are_made_without_provers_and_deciders() -> None:
    count = trusted(STATEMENTS)[0]
    print(f"statements for Coq: {count.total}")
    makers = {"coq.export", "coq.ledger_statements", "coq.statement", "coq.theorem_trees"}
    makers |= {"coq.implicit_statements", "coq.solution_statements"}
    assert {name for name in count.lines if name.startswith("coq.")} - makers <= {"coq.coqtop"}
    others = {tuple(name.split(".")[:2]) for name in count.lines} - {("coq", m) for m in makers}
    assert not others & {
        ("reals", package) for package in ("normal", "signs", "balls", "decisions", "repair")
    }
    assert "ledger.judge" not in count.lines
    for name in ("ledger_statements", "statement", "theorem_trees"):
        text = (HOME / "coq" / f"{name}.py").read_text(encoding="utf-8")
        imported = {f"coq.{m}" for m in re.findall(r"^from tresym\.coq\.(\w+)", text, re.MULTILINE)}
        assert imported <= makers
