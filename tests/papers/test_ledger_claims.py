"""Files of claims as parts of a paper of the ledger: each line is used or refused."""

from pathlib import Path
from typing import Any

import pytest
from flint import fmpq

from tresym.ledger.claim import (
    AllOf,
    Claim,
    Definition,
    ImplicitFunction,
    Place,
    Root,
    in_words,
)
from tresym.ledger.evidence.chart_bounds import Charted, Charts, On, Shown
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.formulas import EqualMatrices, Rounded, in_order, together
from tresym.ledger.judge import judge
from tresym.ledger.paper import Paper
from tresym.ledger.verification import verify
from tresym.papers.ledger_claims import Part, read_part
from tresym.racket.bounds import charts
from tresym.reals.balls.branch_and_bound import box
from tresym.reals.language.compound import Count, Equivalent
from tresym.reals.language.expression import ZERO, number, symbol, trees
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.language.paths import Path as Along
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

x = symbol("x")


def length(x: Any, y: Any, m: Any) -> Any:
    return m.sqrt(x**2 + y**2)


def said(text: str) -> Any:
    """The relations of a text."""
    return together(
        Relation(in_order(left), sign, in_order(right)) for left, sign, right in parse_given(text)
    )


OTHERS = {"programs": {"length": length, "positive": said("a > 0, b > 0").parts, "twice": 2 * x}}


def read(folder: Path, text: str) -> Part:
    path = folder / "part.tresym"
    path.write_text(text, encoding="utf-8")
    return read_part(path, OTHERS.__getitem__)


def verdicts(part: Part) -> dict[str, str]:
    paper = Paper("some", lambda *_: ((part.title, tuple(part.claims.values())),))
    return {row.claim.label: row.finding.verdict.value for row in verify(of=paper).rows}


def test_lines_become_claims(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """# Lengths
use length, positive, twice from programs
E real

let energy (3): E := x**2/2, x > 0
Half a square.

sum (4): twice + length(a, 0) == 2*x + a == a + 2*x given positive using energy
pair [line 12]: (x, sin(y)) == (x, cos(y)) given x > 0 expect refuted at x == 1, y == 0
> says: Sine and cosine agree.
> fault: misprint
both: sum and energy
""",
    )
    assert part.title == "Lengths"
    energy, total, pair, both = part.claims.values()
    assert energy.says == Relation(symbol("E"), "==", parse("x**2/2"))
    assert energy.given == (said("x > 0"),)
    assert (energy.where, energy.note) == (Place(3), "Half a square.")
    assert energy.proof == Definition()
    assert total.says == said("2*x + sqrt(a**2 + 0**2) == a + 2*x")
    assert total.given == said("a > 0, b > 0").parts
    assert total.uses == (energy,)
    assert pair.means == said("x == x, sin(y) == cos(y)")
    assert pair.says == "Sine and cosine agree."
    assert (pair.fault.name, pair.where) == ("MISPRINT", Place(line=12))
    assert isinstance(both.proof, AllOf)
    assert part.sum is total
    assert part.lines == {"energy": (5, 6), "sum": (8, 8), "pair": (9, 11), "both": (12, 12)}


def test_what_is_declared_is_a_condition_of_what_speaks_of_it(tmp_path: Path) -> None:
    part = read(tmp_path, "x, y real; given x > y, y > 0\none: x > 0\ntwo: a**2 >= 0")
    assert part.one.given == said("x > y, y > 0").parts
    assert part.two.given == ()
    assert verdicts(part) == {"one": "PROVED", "two": "PROVED"}


def test_true_lines_hold_and_false_ones_do_not(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """let sign: S := x/abs(x), x != 0
square: S**2 == 1 given x != 0 using sign
everywhere: S**2 == 1 using sign
chain: (a + b)**2 - 2*a*b == a**2 + b**2 == b**2 + a**2
broken: a**2 == a**2 + b == a**2
squares: x**2 + y**2 - x*y == (x - y/2)**2 + 3/4*y**2 >= 0
two_bounds: (x + y)**2 + 1 == x**2 + 2*x*y + y**2 + 1 > 0 and x**2 + 1 == 1 + x**2 >= 1
not_two: (x + y)**2 + 1 == x**2 + 2*x*y + y**2 + 1 > 0 and x**2 - 1 == -1 + x**2 >= 0
no_square: x**2 + y**2 - x*y == (x - y)**2 + y**2 >= 0
not_above: x**2 - 2*x == (x - 1)**2 - 1 >= 0
bound: a**2 + 1 > 1 given a > 0
by_bound: a**2 + 2 > 2 given a > 0 using bound
too_much: a**2 > 1 given a > 0
stays: S > 0 using sign
root: sqrt(x**2) == x
slope: diff(abs(x), x) == 1
logarithm: diff(log(x), x) == 1/x
positive: diff(log(x), x) == 1/x given x > 0
value: at(diff(sqrt(x), x), x, a) == 1/(2*sqrt(a))
square_of_root: sqrt(x)**2 == x given x > 0
larger: x > 0 given x > a, a > 0
root_where_larger: sqrt(x)**2 == x given x > a, a > 0 using larger
quotient: x/x == 1 given x != 0
value_there: at(diff(sqrt(x), x), x, a) == 1/(2*sqrt(a)) given a > 0
inside: integral(x*sqrt(t)/sqrt(t), t, 0, 1) == x
twice_inside: integral(x*sqrt(t)/sqrt(t), t, 0, 1) == 2*x
""",
    )
    found = verdicts(part)
    holds = {"square", "chain", "bound", "by_bound", "squares", "positive", "value_there"}
    holds |= {"two_bounds", "square_of_root", "quotient", "larger", "root_where_larger", "inside"}
    assert part.squares.says == said("x**2 + y**2 - x*y >= 0")
    assert {label for label, verdict in found.items() if verdict == "PROVED"} == holds
    assert found["too_much"] == found["not_above"] == "REFUTED"


REFUSED = {
    "one: x > 0 as x -> oo": "an order along a path is an equation",
    "one: x > 0 on x > 1": "'on' is not read",
    "one: x > 0 given other": "other",
    "one: x > 0 using other": "no claim above this line is labelled 'other'",
    "one: x > 0\none: x > 1": "label of line 1 already",
    "let f: f(x) := x": "is a function",
    "one (a): x > 0": "is not a place",
    "one: x > 0 at x == 1": "expect refuted",
    "one: x > 0 expect something": "expect refuted",
    "x integer\none: x > 0": "'in' is not read",
    "use nothing from programs": "nothing is not in programs",
    "one: convex(x**2, x)": "is not read",
    "one: speed > 0": "speed is not declared",
    "one: x > 0\n> fault: haste": "is not one of",
    "one: x > 0\n> quotes: MOTION": "MOTION is no theorem",
    "one [line 3, row 2]: x > 0": "is not a place",
    "one: x > 0 with y == 1": "'with' gives values",
    "one: x > 0\ntwo: y > 0 using one with x**2 == y": "write with x ==",
    "one: x > 0 by residual 1 > 0": "shows a bound on a root",
    "one: x > 0\ntwo: y > 0 using one shown by derivative one from one": "the claims behind it",
    "one: x > 0 by slope 1 > 0": "shows that a root is increasing",
    "one: x > 0 dominated by other": "no claim above this line",
    "one: x > 0\ntwo: y > 0 using one with x == y expect refuted": "of a claim that holds",
    "one: x > 0 shown by magic": "'magic' is no way to show a claim",
    "one: in words, from other": "no claim above this line is labelled 'other'",
    "one: x**2 >= 0\ntwo: in words, from one": "needs its sentence below it",
    "one: x**2 >= 0\ntwo: in words, from one given x > 0": "has no clauses",
    "one: x == 1 given x ~= 1.00 within one unit": "write ~= between",
    "one: x > 0 given x > 1 expect refuted at x == 1 shown by boxes": "and no point",
    "one: stable x == 0 along x' == -x by x**2": "a function after 'by' is not used",
}


UNDEFINED = [
    "lost: (a/b; 1)*b == (a; b)",
    "one: sqrt(x)**2 >= 0",
    "one: x/x == 1",
    "one: exp(log(x)) == x",
    "one: diff(sqrt(x)**2, x) == 1",
    "one: integral(x*sqrt(t)/sqrt(t), t, -1, 1) == 2*x",
    "one: 0*log(x) == 0",
    "one: 1/(1/sqrt(x)) == sqrt(x) given x >= 0",
    "one: (1/sqrt(x))**(-3) == x**(3/2) given x >= 0",
    "one: x > 0 given x > 1\ntwo: sqrt(x)**2 == x using one",
]
"""Texts whose last claim holds only where both sides have a value."""


@pytest.mark.parametrize("text", UNDEFINED)
def test_sides_without_a_value_are_not_equal(text: str, tmp_path: Path) -> None:
    *before, last = read(tmp_path, text).claims.values()
    finding = judge(last, {c.label: judge(c, {}) for c in before})
    assert finding.verdict is Verdict.UNDECIDED
    assert "lies in the domain" in finding.why or "no antiderivative" in finding.why


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_not_used_is_refused(text: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=REFUSED[text].replace("(", r"\(")):
        read(tmp_path, text)


def test_a_symbol_with_two_definitions_proves_nothing(tmp_path: Path) -> None:
    part = read(tmp_path, "let one: S := 1\nlet two: S := 2\nfalse: 1 == 2 using one, two")
    found = {c.label: judge(c, {}) for c in (part.one, part.two)}
    assert judge(part.claims["false"], found).verdict is Verdict.UNDECIDED
    with pytest.raises(InputError, match="S is defined by one and by two"):
        verdicts(part)


def test_the_expression_that_is_proved_is_the_one_that_runs(tmp_path: Path) -> None:
    part = read(tmp_path, "use length from programs\none: length(3, 4*x) >= 0")
    assert part.one.says.left == in_order(length(number(3), 4 * x, trees))


def test_statements_that_are_not_comparisons_are_decided_as_a_whole(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """let square: S := x**2
bound: S >= 0 using square
circle: conserved(x**2 + y**2) along (x, y)' == (y, -x)
hyperbola: conserved(x**2 - y**2) along (x, y)' == (y, -x)
centre: stable (x, y) == (0, 0) along (x, y)' == (y, -x)
saddle: stable (x, y) == (0, 0) along (x, y)' == (y, x)
same: exp(x) == 1 <=> x == 0
other: x**2 == 1 <=> x == 1
once: exactly one x in (0, 1): x**3 == a given a > 0, a < 1
twice: exactly one x in (-1, 1): x**2 == a given a > 0, a < 1
rises: increasing(S, x) given x > 0 using square
falls: decreasing(S, x) given x > 0 using square
rises_by_bound: increasing(x + S, x) given x < 0 using bound
rises_with: increasing(x + S, x) given x < 0 using square
kept_by_bound: conserved(S) along (x, y)' == (1, 2) using bound
undefined: exactly one x in (-1, 1): sqrt(x) == 1/2
some: at some point: x**2 == 2 given x > 0
""",
    )
    found = verdicts(part)
    holds = {label for label, verdict in found.items() if verdict in ("PROVED", "ENCLOSED")}
    assert holds == {"bound", "circle", "centre", "same", "once", "rises", "some"}
    refuted = {label for label, verdict in found.items() if verdict == "REFUTED"}
    assert refuted == {"hyperbola", "saddle", "other", "falls", "twice", "rises_with"}


def test_equations_that_relate_variables_let_no_point_refute(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """u real
let double: u := 2*x
assume law: u == 3*y
> assumed: a law
follows: 2*x == 3*y using double, law
""",
    )
    assert verdicts(part) == {"double": "DEFINED", "law": "ASSUMED", "follows": "UNDECIDED"}


def test_each_step_uses_what_it_names(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """let one: S := x + y
let two: b := S**2
squared: b == S**2 [two] == (x + y)**2 [one] == x**2 + 2*x*y + y**2 [by the binomial formula]
other: b == S**2 [one] == (x + y)**2 [one]
wrong: b == S**3 [two] == (x + y)**2 [one] using one, two
false: b == S**2 [two] == x**2 + y**2 [one]
both: b == S**2 [two] == (x + y)**2 [one] and S == x + y [one]
""",
    )
    assert part.squared.uses == (part.two, part.one)
    assert part.squared.says == said("b == x**2 + 2*x*y + y**2")
    assert [link.reasons[0].name for link in part.squared.proof.chains[0]][2:] == [
        "by the binomial formula"
    ]
    found = verdicts(part)
    assert {label for label, verdict in found.items() if verdict == "PROVED"} == {"squared", "both"}
    assert found["false"] == found["other"] == "REFUTED"  # nothing says what b is in the other
    assert found["wrong"] == "UNDECIDED"


def test_rules_for_integrals_are_checked_where_a_step_names_them(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """f(t) := exp(-t**4)
changed: integral(f(t), t, 1, 3) == integral(f(sqrt(u))/(2*sqrt(u)), u, 1, 9) [u = t**2]
cut: integral(f(t), t, 0, 3) == integral(f(t), t, 0, 1) + integral(f(t), t, 1, 3) [cut at 1]
put_in: integral(a + f(t), t, 0, 1) == integral(a, t, 0, 1) + integral(f(t), t, 0, 1) [one integral]
  == a + integral(f(t), t, 0, 1) [antiderivative a*t]
wrong_ends: integral(f(t), t, 1, 3) == integral(f(sqrt(u))/(2*sqrt(u)), u, 1, 3) [u = t**2]
turned: integral(f(t), t, -1, 1) == integral(f(sqrt(u))/(2*sqrt(u)), u, 1, 1) [u = t**2]
outside: integral(f(t), t, 0, 1) == integral(f(t), t, 0, 3) + integral(f(t), t, 2, 1) [cut at 3]
through_a_pole: integral(1/t, t, -1, 1) == log(1) - log(-1 + 2) [antiderivative log(abs(t))]
""",
    )
    found = verdicts(part)
    true = {label for label, verdict in found.items() if verdict == "PROVED"}
    assert true == {"changed", "cut", "put_in"}


def test_what_is_known_is_shown_first(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """also: integral(1/sqrt(1 - t**2), t, -c, c) == 2*asin(c) [antiderivative asin(t)]
  given c > 0, c < 1 - a, a > 0
  knowing (1 - t**2 > 0 given (t + c)*(c - t) >= 0)
unknown: integral(1/sqrt(1 - t**2), t, 0, c) == asin(c) [antiderivative asin(t)]
  given c > 0 knowing (1 - t**2 > 0 given t*(c - t) >= 0)
false: x > 1 given x > 0 knowing x > 1
""",
    )
    found = verdicts(part)
    assert found["also"] == "PROVED"
    assert "PROVED" not in (found["unknown"], found["false"])


def test_a_sentence_is_denied_by_claims_that_hold(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """one: x**2 >= 0
wrong: x**2 > 0
denied: in words, from one expect refuted at x == -1
> says: No square of a negative number is positive.
open: in words, from wrong expect refuted at x == 0
> says: Some squares vanish.
""",
    )
    found = verdicts(part)
    assert (found["denied"], found["open"]) == ("REFUTED", "UNDECIDED")
    with pytest.raises(InputError):
        read(tmp_path, "one: x**2 >= 0\nsaid: in words, from one given x > 0\n> says: So it is.")


def test_matrices(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """Omega1, Omega2 real
about(x) := (cos(x), -sin(x); sin(x), cos(x))
v := (a; b)
turn := about(a)*about(b)
orthogonal: transposed(turn)*turn == (1, 0; 0, 1)
sum: written_out(about(a), about(b)) == about(a + b)
full: about(a + 2*pi) == about(a)
slope: transposed(turn)*diff(turn, a) == (0, -1; 1, 0) and v_1 == a
let first: Omega1 := turn_11, Omega2 := turn_21
column: about(a + b)*(1; 0) == (Omega1; Omega2) using first
wrong_sign: transposed(turn)*diff(turn, a) == (0, 1; -1, 0)
wrong_sum: written_out(about(a), about(b)) == about(a - b)
half: about(a + pi) == about(a)
wrong_column: about(a + b)*(1; 0) == (Omega2; Omega1) using first
scaled: 2*v - v == v + (0; 1)
""",
    )
    found = verdicts(part)
    true = {label for label, verdict in found.items() if verdict in ("PROVED", "DEFINED")}
    assert true == {"orthogonal", "sum", "full", "slope", "first", "column"}
    assert found["half"] == found["scaled"] == found["wrong_sign"] == "REFUTED"
    assert isinstance(part.column.says, EqualMatrices)
    for text in (
        "fits: (a; b) == (a, b)",
        "product: (a; b)*(a; b) == (a; b)",
        "order: (a; b) <= (a; b)",
        "called: inverse((a; b)) == (a; b)",
    ):
        with pytest.raises(InputError):
            read(tmp_path, text)


def test_parts_of_claims_are_shown_by_them(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """both: x**2 >= 0 and (y > 0 given y > 1)
one: x**2 >= 0 shown by parts of both
other: y > 0 given y > 2 shown by parts of both
wider: y > 0 given y > -1 shown by parts of both
none: x > 0 shown by parts of both
""",
    )
    found = verdicts(part)
    assert found["one"] == found["other"] == "PROVED"
    assert "PROVED" not in (found["wider"], found["none"])


def test_what_an_equation_defines(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """y0, slope, fold real
one: exactly one y in (0, 2): y**3 + y == x given x > 0, x < 1
none: exactly one y in (1, 2): y**3 + y == x given x > 0, x < 1
let root: y0 := root of one, x > 0, x < 1
let other: S := root of none, x > 0, x < 1
assume curve: integral(exp(t*x), t, 0, y) == 1
assume bowl: integral(2*t*exp(t*x), t, 0, y) == 1
slope: slope == -(y**2/2)/1 shown by curve solved for y(x), x == 0
fold: fold == -y**2/3 given y > -1 shown by bowl solved for y(x), x == 0
true: slope == -y**2/2 using slope
false: slope == -y**2/3 using slope
""",
    )
    assert part.root.says == said("y0**3 + y0 == x, y0 > 0, y0 < 2")
    found = verdicts(part)
    assert found["root"] == "DEFINED"
    assert (found["slope"], found["true"]) == ("PROVED", "PROVED")
    assert (found["none"], found["other"]) == ("REFUTED", "UNDECIDED")
    assert (found["fold"], found["false"]) == ("UNDECIDED", "UNDECIDED")


def test_orders_along_paths(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """sine: sin(x) == x + O(x**3) as x -> 0
above: exp(-1/x) == o(x**10) as x -> 0+
below: exp(-1/x) == O(x) as x -> 0-
far: 1/(x + a) == O(1/x) as x -> oo given a > 0
both: x*y == O(x**2 + y**2) as (x, y) -> (0, 0)
fails: x*y == O(x**3 + y**3) as (x, y) -> (0, 0) expect refuted at x == t, y == t
holds: x*y == O(x**2 + y**2) as (x, y) -> (0, 0) expect refuted at x == t, y == t
""",
    )
    assert part.below.statement.path == Along("x", ZERO, (-1,))
    assert part.both.statement.path == Along(
        "", ZERO, (1,), together=("x", "y"), points=(ZERO, ZERO)
    )
    found = verdicts(part)
    assert found.pop("below") == found.pop("fails") == "REFUTED"
    assert found.pop("holds") == "UNDECIDED"
    assert {*found.values()} <= {"PROVED", "ENCLOSED"}


def test_equivalences_by_steps(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """root: x**2 == 4 <=> x == 2 <=> 3*x == 6 given x > 0
wrong: x == 2 <=> x**2 == 4 <=> 2*x == 4
false: x**2 == 4 <=> abs(x) == 2 <=> x == 2
""",
    )
    assert len(part.root.proof.chains[0]) == 2
    assert part.root.says == Equivalent((said("x**2 == 4"), said("3*x == 6")))
    assert verdicts(part) == {"root": "PROVED", "wrong": "UNDECIDED", "false": "REFUTED"}


def test_each_part_of_a_statement_is_printed_with_its_own_steps(tmp_path: Path) -> None:
    from tresym.report.typesetting.chains import displays

    part = read(
        tmp_path,
        "two: (a + b)**2 == a**2 + 2*a*b + b**2 == b**2 + 2*a*b + a**2 and 2*a == a + a == a*2",
    )
    assert [len(display) for display in displays(part.two)] == [2, 2]


def of_methods(folder: Path, text: str) -> dict[str, str]:
    """The verdicts on lines that may use the only root z of z³ + z = x, for 0 < x < 3."""
    ends, cube = said("x > 0, x < 3").parts, said("y**3 + y == x")
    one = Count("exactly one", "y", ZERO, number(3), (False, False), cube, ())
    unique = Claim("unique", one, Decided(), expect=Verdict.PROVED, given=ends)
    cubic = Claim("cubic", Root("z", unique).says, Root("z", unique), given=ends)
    path = folder / "part.tresym"
    path.write_text(f"use cubic, range from programs\n{text}", encoding="utf-8")
    claims = {"cubic": cubic, "range": ends}
    part = read_part(path, lambda name: claims)
    all_of_it = {unique: None, cubic: None, **dict.fromkeys(part.claims.values())}
    paper = Paper("some", lambda *_: ((part.title, tuple(all_of_it)),))
    found = {row.claim.label: row.finding.verdict.value for row in verify(of=paper).rows}
    return {label: found[label] for label in part.claims}


def test_methods_that_a_line_names_let_nothing_false_through(tmp_path: Path) -> None:
    found = of_methods(
        tmp_path,
        """below: tanh(x) < x given x > 0
let named: S := x**2
square: x**2 == S using named
there: tanh(b**2) < b**2 given b > 0 using below with x == b**2
anywhere: tanh(b) < b given b != 0 using below with x == b
other: tanh(b) < b/2 given b > 0 using below with x == b
replaced: 9 == S using square with x == 3
rises: increasing(z, x) given range using cubic by slope -1 == -2 + 1 < 0
falls: decreasing(z, x) given range using cubic by slope -1 == -2 + 1 < 0
no_slope: increasing(z, x) given range using cubic by slope -2 < 0
at_root: increasing(z, x) given range
  using cubic by slope -1 == cos(z**3 + z) - cos(x) - 1 [cubic] < 0
bounded: abs(sin(a*b)/x**2) <= 1/x**2 given x > 0
below_one: z < 1 given range, x < 2 using cubic by residual 2 - x > 0
below_half: z < 1/2 given range, x < 2 using cubic by residual 5/8 - x > 0
other_value: z < 1 given range, x < 2 using cubic by residual 3 - x > 0
at_two: z > 9/10 given x == 2 using cubic by residual (9/10)**3 + 9/10 - 2 < 0
beyond: z > 9/10 given range, x > 2 shown by rises from x == 2 in at_two
before: z > 9/10 given range, x < 2 shown by rises from x == 2 in at_two
one_time: at most one y in (0, 2): integral(exp(t*a), t, 0, y) == b
  given a > 0 by slope exp(y*a) [inside 0] > 0
many_times: at most one y in (0, 2): integral(1 - a*t, t, 0, y) == b
  given a > 0 by slope 1 - a*y [inside 0] > 0
wrong_slope: at most one y in (0, 2): integral(exp(t*a), t, 0, y) == b
  given a > 0 by slope exp(y*a) + 1 [inside 0] > 0
faster: diff(integral(exp(t*a), t, 0, y), a)
  == integral(t*exp(t*a), t, 0, y) [inside t*exp(t*a)] > 0 given y > 0
not_faster: diff(integral(exp(t*a), t, 0, y), a)
  == integral(2*t*exp(t*a), t, 0, y) [inside 2*t*exp(t*a)] > 0 given y > 0
less: integral(exp(t*a), t, 0, y) - integral(t**2, t, 0, y) < integral(exp(t*a), t, 0, y)
  given y > 0
not_less: integral(exp(t*a), t, 0, y) - integral(t, t, -1, 0) < integral(exp(t*a), t, 0, y)
  given y > 0
double: increasing(2*z, x) given range shown by monotony of rises
turned: increasing(-2*z, x) given range shown by monotony of rises
steep: diff(x + x**3, x) > 0 given x >= 0, x <= 5
start: at(x + x**3, x, 0) == 0
right: x + x**3 > 0 given x > 0, x <= 5 shown by derivative steep from start
left: x + x**3 > 0 given x > -1, x <= 5 shown by derivative steep from start
above: 1/a > 0 given a > 0
near: 1/a < 2/a given a > 0
least: infimum(1/a) == 0 given a > 0 shown by above approached by near along a == 1/t
bounded_a: infimum(1/a) == 0 given a > 0, a < 5 shown by above approached by near along a == 1/t
too_low: infimum(1/a) == -1 given a > 0 shown by above approached by near along a == 1/t
tends: sin(a*b)/x**2 == O(1/x**2) as x -> oo given x > 0 dominated by bounded
smaller: sin(a*b)/x**2 == O(1/x**3) as x -> oo given x > 0 dominated by bounded
large: z > 1 given range using cubic expect refuted
not_large: z < 5/4 given range using cubic expect refuted
""",
    )
    assert (found.pop("large"), found.pop("not_large")) == ("REFUTED", "UNDECIDED")
    false = {
        "anywhere",
        "other",
        "replaced",
        "falls",
        "no_slope",
        "smaller",
        "bounded_a",
        "too_low",
    }
    false |= {"many_times", "wrong_slope", "not_faster", "not_less"}
    false |= {"below_half", "other_value", "before", "turned", "left"}
    assert {label for label in found if found[label] in ("PROVED", "ENCLOSED", "DEFINED")} == {
        *found
    } - false
    assert found["falls"] == "REFUTED"


def test_sentences_that_say_more_than_the_claims_behind_them(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """one: x**2 >= 0
two: x**2 >= x
whole [line 3]: in words, from one
> says: Squares are what they are.
Told in words.
wrong: in words, from one, two
> says: Squares are large.
""",
    )
    whole = part.whole
    assert (whole.proof, whole.statement, whole.where) == (in_words(part.one), None, Place(line=3))
    assert (whole.says, whole.note) == ("Squares are what they are.", "Told in words.")
    assert verdicts(part)["whole"] == "PROVED"
    assert verdicts(part)["wrong"] == "UNDECIDED"


def test_hints_that_name_a_method(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """v, w real
bound: integral(exp(-x*t), t, 0, 1) < 1 given x >= 1/10, x <= 2 shown by boxes
false_bound: integral(exp(-x*t), t, 0, 1) < 1/2 given x >= 1/10, x <= 2 shown by boxes
turn(c) := integral(1 + c*t**2, t, 0, y)
assume area: turn(c) == 1 given c > 0, y > 0
slope: v == -diff(turn(x), x)/diff(turn(x), y) given x > 0, y > 0
  shown by area solved for y(c), c == x
false_slope: w == diff(turn(x), x)/diff(turn(x), y) given x > 0, y > 0
  shown by area solved for y(c), c == x
assume anywhere: integral(1 - c*t**2, t, 0, y) == 1 given c > 0, y > 0
no_slope: w2 == -diff(integral(1 - x*t**2, t, 0, y), x)/diff(integral(1 - x*t**2, t, 0, y), y)
  given x > 0, y > 0 shown by anywhere solved for y(c), c == x
""",
    )
    assert part.slope.proof == ImplicitFunction(part.area, "y", "c", x)
    found = verdicts(part)
    assert [found[name] for name in ("bound", "slope")] == ["ENCLOSED", "PROVED"]
    assert found["false_bound"] == "REFUTED"
    assert {found["false_slope"], found["no_slope"]} <= {"REFUTED", "UNDECIDED"}


def test_printed_roots_and_whole_units(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """unique: at most one c in (0, 3): c**2 == x given x > 0
> It grows.
printed: root(c**2 - x, c, 0, 3) ~= 1.41 given x ~= 2.00 using unique
unit: sqrt(x) ~= 1.40 within one unit given x == 2
half: sqrt(x) ~= 1.40 given x == 2
other: root(c**3 - x, c, 0, 3) ~= 1.26 given x ~= 2.00 using unique
""",
    )
    assert part.printed.says == Rounded(in_order(parse("root(c**2 - x, c, 0, 3)")), "1.41")
    assert part.unit.says == Rounded(parse("sqrt(x)"), "1.40", 2)
    found = verdicts(part)
    wanted = {"printed": "ENCLOSED", "unit": "REFUTED", "half": "REFUTED", "other": "UNDECIDED"}
    assert {name: found[name] for name in wanted} == wanted


def _margin(t: Any, m: Any) -> Any:
    """(e^t − 1)/t − 9/10."""
    return charts.expm1_over(t) - fmpq(9, 10)


OTHERS["margins"] = {
    "growth": Charts(lambda claims: Charted((On((x,), box((0, 2)), (Shown(_margin, x),)),)))
}


def test_stored_charts_other_variables_and_printed_orders(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """use growth from margins
r, s real
grows: exp(x) - 1 > 9/10*x given x > 0, x <= 2 shown by charts growth
> constant: 9/10 of x
faster: exp(x) - 1 > 91/100*x given x > 0, x <= 2 shown by charts growth
farther: exp(x) - 1 > 9/10*x given x > 0, x <= 3 shown by charts growth
other: exp(x) - 1 > x given x > 0, x <= 2 shown by charts growth
ratio: sqrt(b/a) <= 2*b given a > 0, b > 0, a*b >= 1/4
  shown by variables r == sqrt(b/a), a == b/r**2, r > 0
small_ratio: sqrt(b/a) <= b given a > 0, b > 0, a*b >= 1/4
  shown by variables r == sqrt(b/a), a == b/r**2, r > 0
another_ratio: sqrt(b/a) <= 2*b given a > 0, b > 0, a*b >= 1/4
  shown by variables r == sqrt(b/a), a == b/r, r > 0
order: sin(x) == O(x**2) as x -> 0+ expect refuted
> prints: sin(x) == O(x**2)
cubic: abs(sin(x) - x) <= x**3 given x > 0, x <= 1
> prints: s == x + O(x**3) as x -> 0, with a fixed, where s == sin(x)
square: abs(sin(x) - x) <= x**2 given x > 0, x <= 1
> prints: sin(x) == x + O(x**3) as x -> 0
twice_x: abs(sin(x) - x) <= x**3 given x > 0, x <= 1
> prints: sin(x) == 2*x + O(x**3) as x -> 0
varying: abs(sin(x) - x) <= a*x**3 given x > 0, x <= 1, a >= 1
> prints: sin(x) == x + O(x**3) as x -> 0
""",
    )
    true = dict.fromkeys(("ratio", "cubic"), "PROVED")
    true |= {"grows": "ENCLOSED", "order": "REFUTED"}
    found = verdicts(part)
    assert {label: found[label] for label in true} == true
    assert {found[label] for label in {*found} - {*true}} <= {"REFUTED", "UNDECIDED"}
    assert part.grows.proof.constant == fmpq(9, 10)
    assert part.order.says == part.order.means.relation == said("sin(x) == O(x**2)")


@pytest.mark.parametrize(
    "text",
    [
        "grows: exp(x) - 1 > x given x > 0 shown by charts growth",
        "use growth from margins\ngrows: x > 0 given x > 1\n> constant: 2 of x",
        "one: x**2 >= 0\n> rests on: two",
        "one: x**2 >= 0\n> says: Squares.\n> prints: x**2 >= 0",
    ],
)
def test_hints_with_nothing_behind_them_are_refused(text: str, tmp_path: Path) -> None:
    with pytest.raises(InputError):
        read(tmp_path, text)


def test_each_part_is_shown_by_the_claims_behind_it(tmp_path: Path) -> None:
    part = read(
        tmp_path,
        """let u_is: u := exp(x) + 1
let v_is: v := x**2
above: u > 1 using u_is
square: v >= 0 using v_is
both: u > 0 [above] and v + 1 > 0 [square]
swapped: u > 0 [square] and v + 1 > 0 [above]
half: u > 0 [above] and v > 0 [square]
""",
    )
    assert part.both.uses == (part.above, part.square)
    found = verdicts(part)
    assert {label for label in found if found[label] == "PROVED"} == {"above", "square", "both"}
