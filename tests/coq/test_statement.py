"""The printed statements, read back by a reader that shares nothing with the printer."""

import re
from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest
from coq_terms import COMMENT, Terms
from flint import arb

from tresym.coq.claim_export import theorem, theorems
from tresym.coq.ledger_statements import theorem_of
from tresym.coq.statement import NotExportedError, Theorem, formula, variable
from tresym.dev.corpus.lists import known, pairs
from tresym.dev.corpus.rewriting import changed, true_identity
from tresym.ledger.paper import all_claims
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

BITS, POINTS = 200, 4


def relation(text: str, at: dict[str, arb]) -> tuple[arb, str, arb]:
    reader = Terms(text, at)
    left, sign, right = reader.sum(), reader.take(), reader.sum()
    assert not reader.peek()
    return left, sign, right


def holds(x: arb, sign: str, y: arb) -> bool:
    """Whether balls show it, equality allowed where it may be."""
    return bool(
        {"<>": x != y, "<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y, "=": x.overlaps(y)}[sign]
    )


def parts(t: Theorem) -> tuple[list[str], str]:
    """Premises and conclusion of the printed theorem."""
    text = COMMENT.sub("", t.text)
    head, _, body = text.partition(":\n")
    assert head.split() == ["Theorem", t.name]
    assert body.endswith(".")
    if body.lstrip().startswith("forall"):
        names, _, body = body.partition(" : R,")
        assert names.split()[1:] == [variable(name) for name in t.variables]
    *premises, says = body[:-1].split("->")
    return [p.strip() for p in premises], says.strip()


DERIVATIVE = re.compile(r"is_derive \(fun (\w+) : R => (.*)\) (\w+) (\S+|\(.*\))", re.DOTALL)


def agree(t: Theorem) -> int:
    """At how many points both sides are defined; there the text has the value of the claim."""
    premises, says = parts(t)
    sides = [t.left, t.right]
    count = 0
    for point in Given(t.given).points(t.variables, 40):
        with ball_precision(BITS):
            at = {name: arb(x) for name, x in point.items()}
            values = [evaluate(e, at) for e in sides]
            needed = [evaluate(e, at) for e, _ in t.defined]
            if not all(v.is_finite() and v.rad() < 1e-20 for v in (*values, *needed)):
                continue
            if not all(
                v > 0 if sign != "!=" else v != 0
                for v, (_, sign) in zip(needed, t.defined, strict=True)
            ):
                continue
            there = {variable(name): value for name, value in at.items()}
            assert all(holds(*relation(premise, there)) for premise in premises), premises
            if t.by is None:
                left, _, right = relation(says, there)
            else:
                match = DERIVATIVE.fullmatch(says)
                assert match is not None, says
                assert match[1] == match[3] == variable(t.by)
                left, right = (Terms(match[k], there).sum() for k in (2, 4))
            assert left.overlaps(values[0]), says
            assert right.overlaps(values[1]), says
            count += 1
        if count == POINTS:
            break
    return count


def exported(claims: list[str]) -> Iterator[Theorem]:
    for claim in claims:
        try:
            yield from theorems(read(claim))
        except NotExportedError:
            continue


CLAIMS = [*(k.claim for k in known("inequalities")), *(p.claim for p in pairs())]


def test_printed_statements_have_the_values_of_the_claims() -> None:
    found = [agree(t) for t in exported(CLAIMS[::3])]
    assert len(found) > 300
    assert sum(count > 0 for count in found) > 0.9 * len(found)


def test_what_the_ledger_says_is_printed_as_it_is() -> None:
    """Relations under conditions, without integrals: at points the text has the claim's values."""
    found = []
    for claim in all_claims():
        try:
            t = theorem_of(claim)
        except NotExportedError:
            continue
        single = isinstance(t, Theorem) and isinstance(t.says, Relation)
        if single and not t.exists and not t.definitions and elementary(t.says.left, t.says.right):
            found.append(agree(t))
    assert len(found) > 80
    assert sum(count > 0 for count in found) > 0.8 * len(found)


def test_random_trees_are_printed_as_they_are() -> None:
    random = Random(4)
    found = [
        agree(theorem(Comparison(x, "==", y)))
        for x, y in (true_identity(random) for _ in range(60))
    ]
    assert sum(count > 0 for count in found) > 40


def test_a_premise_fails_where_a_part_is_not_defined() -> None:
    for text, point in [
        ("sqrt(x) == x", -1),
        ("log(x) == x", 0),
        ("1/x == x", 0),
        ("asin(x) == x", 2),
        ("acosh(x) == x", 0),
        ("atanh(x) == x", 1),
        ("x**(-1/2) == x", 0),
        ("x**x == x", 0),
        ("cot(x) == x", 0),
        ("coth(x) == x", 0),
        ("x**(1/3) == x", -1),
        ("diff(x**(3/2), x) == 3*sqrt(x)/2", 0),
        ("diff(abs(x), x) == sign(x)", 0),
        ("diff(cbrt(x), x) == 1/(3*cbrt(x)**2)", 0),
    ]:
        (t,) = theorems(read(text))
        premises, _ = parts(t)
        at = {"x": arb(point)}
        values = [relation(premise, at) for premise in premises]
        assert any(
            not x.is_finite() or not y.is_finite() or not holds(x, s, y) for x, s, y in values
        ), text


def test_a_mutant_is_another_statement() -> None:
    random = Random(5)
    seen = 0
    for t in exported(CLAIMS[::2]):
        try:
            right = changed(t.right, random)
            other = theorem(Comparison(t.left, t.relation, right), t.given)
        except InputError:
            continue
        same = theorem(Comparison(t.left, t.relation, t.right), t.given)
        if right != t.right:
            assert other.text != same.text
            seen += 1
    assert seen > 300


@pytest.mark.parametrize(
    "names", [("sin", "x"), ("R", "v_R"), ("forall", "e"), ("I1", "x1"), ("v_x", "x")]
)
def test_names_of_variables_are_apart_and_no_words_of_coq(names: tuple[str, str]) -> None:
    first, second = map(variable, names)
    assert first != second
    assert first in names or first.startswith("v_")
    assert variable("fun") == "v_fun"


def test_a_chain_is_one_theorem_a_link() -> None:
    assert [t.name for t in theorems(read("0 < x < 1 given x > 0"))] == ["claim_1", "claim_2"]


@pytest.mark.parametrize(
    "claim",
    [
        "integral(sin(t)/t, t, 0, x) == O(x) as x -> 0",
        "diff(x**2, x) > x",
        "diff(x**2, x, 2) == 2",
        "diff(x, x) + diff(x**2, x) == 1 + 2*x",
    ],
)
def test_what_has_no_statement_yet_is_said(claim: str) -> None:
    with pytest.raises(NotExportedError, match="yet"):
        theorems(read(claim))


def test_the_printer_is_short_and_imports_no_prover() -> None:
    import tresym.coq.statement as module

    text = Path(module.__file__).read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 225
    assert not re.search(
        r"import.*\b(normal|signs|balls|advocate|equations|inequalities|search)\b", text
    )


def test_brackets_follow_coq() -> None:
    def text(source: str) -> str:
        (t,) = theorems(read(f"{source} == 0"))
        return formula(t.says)

    assert text("a/(b*c)") == "a * / (b * c) = 0"
    assert text("-x**2") == "(-1) * x ^ 2 = 0"
    assert text("(-2)*x") == "(-2) * x = 0"
    assert text("(x**2)**(1/2)") == "sqrt (x ^ 2) = 0"
    assert text("x**(-3/2)") == "/ ((sqrt x) ^ 3) = 0"
    assert text("sin(-1/2 + x)") == "sin (x + (-1) / 2) = 0"
    assert isinstance(parse("x"), Expr)
    assert symbols(parse("x")) == {"x"}
