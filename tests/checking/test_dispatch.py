"""A user's own claims: what is decided, what is refused, and that nothing false is ever proved."""

import json
import subprocess
import sys
import tracemalloc
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from random import Random

import mpmath
import pytest
import sympy
from cases import cases
from hangs import HANGS
from hypothesis import given
from hypothesis import strategies as st

import tresym
from tresym.checking import dispatch
from tresym.checking.dispatch import decide_claim
from tresym.checking.time_limited import Task, check_all, check_within
from tresym.commands import main
from tresym.commands.check import read_tasks
from tresym.dev.bench import check as check_pairs
from tresym.reals.decisions.answer import Answer
from tresym.reals.domain.conditions import Given
from tresym.reals.numbers.exact import InputError, Interval, parse_number
from tresym.reals.signs.closure import is_regular
from tresym.reals.verdict import Verdict
from tresym.report.pages.check_tables import measured

PROVED, ENCLOSED = Verdict.PROVED, Verdict.ENCLOSED
REFUTED, UNDECIDED = Verdict.REFUTED, Verdict.UNDECIDED


FALSE = cases(__file__, "FALSE")


REGULAR = cases(__file__, "REGULAR")
SINGULAR = cases(__file__, "SINGULAR")


@pytest.mark.parametrize("given", [*REGULAR, *SINGULAR])
def test_conditions_whose_points_are_limits_of_inner_ones(given: str) -> None:
    assert is_regular(Given.parse(given)) is (given in REGULAR)


@pytest.mark.parametrize("claim", FALSE)
def test_planted_falsehoods_are_refuted(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is REFUTED
    assert answer.witness is not None


def test_a_refutation_shows_both_sides_apart() -> None:
    answer = tresym.check("x == x + 10**(-60)")
    assert answer.verdict is REFUTED
    assert answer.values is not None
    left, right = answer.values
    gap = abs(parse_number(left.mid) - parse_number(right.mid))
    assert gap > parse_number(left.rad) + parse_number(right.rad)


def test_an_order_comes_with_a_certified_constant_and_range() -> None:
    answer = tresym.check("sin(x) - x == O(x**3)", path="x -> 0")
    assert answer.region == "0 < |x| <= 1"
    assert answer.constant is not None
    low = parse_number(answer.constant.mid) - parse_number(answer.constant.rad)
    high = parse_number(answer.constant.mid) + parse_number(answer.constant.rad)
    assert low <= parse_number("1/6") <= high
    assert high < parse_number("0.17")


# -- soundness by trial -------------------------------------------------------------------------

COEFFICIENTS = st.integers(-6, 6)
UNITS = st.sampled_from(["exp(x)", "cos(x)", "1/(2 + x)", "sqrt(4 + x)", "(3 - x)", "cosh(x)"])
SHAPES = st.sampled_from(
    ["x", "x**2", "x**3", "sin(x)", "cos(3*x)", "exp(x)", "exp(-x**2)", "sqrt(1 + x**2)", "atan(x)"]
)


@given(
    st.lists(st.tuples(COEFFICIENTS, SHAPES), min_size=1, max_size=3),
    st.integers(-8, 8),
    st.sampled_from([">", ">=", "<", "<="]),
    st.integers(-3, 2),
    st.integers(1, 4),
)
@pytest.mark.slow
def test_random_inequalities(
    terms: list[tuple[int, str]], bound: int, relation: str, low: int, width: int
) -> None:
    """Where it holds no sample contradicts it; where it is refuted the witness does."""
    text = " + ".join(f"({c})*{shape}" for c, shape in terms)
    conditions = f"{low} <= x <= {low + width}"
    answer = tresym.check(f"{text} {relation} {bound}", given=conditions)

    def holds(x: mpmath.mpf) -> bool:
        names = {name: getattr(mpmath, name) for name in ("sin", "cos", "exp", "sqrt", "atan")}
        value = eval(text, {"x": x, **names})
        return bool(eval(f"v {relation} b", {"v": value, "b": bound}))

    with mpmath.workdps(40):
        if answer:
            for k in range(201):
                assert holds(low + mpmath.mpf(width) * k / 200) or relation in ("<=", ">=")
                assert holds(low + mpmath.mpf(width) * (k + mpmath.mpf("0.31")) / 201)
        elif answer.verdict is REFUTED:
            assert answer.witness is not None
            x = Fraction(answer.witness["x"])
            assert low <= x <= low + width
            assert not holds(mpmath.mpf(x.numerator) / x.denominator)


@given(
    st.integers(0, 4),
    st.integers(1, 4),
    UNITS,
    UNITS,
    st.integers(0, 4),
    st.sampled_from(["O", "o"]),
    st.sampled_from(["0+", "0-", "0"]),
)
def test_random_orders(
    power: int, scale: int, unit: str, other: str, gauge: int, kind: str, end: str
) -> None:
    """x**p times something that does not vanish is O(x**q) for p >= q alone."""
    function = f"{scale}*x**{power}*{unit} + x**{power + 1}*{other}"
    answer = tresym.check(f"{function} == {kind}(x**{gauge}*{other})", path=f"x -> {end}")
    truth = power >= gauge if kind == "O" else power > gauge
    assert answer.verdict in ((Verdict.PROVED, ENCLOSED) if truth else (REFUTED,))


@given(st.integers(1, 5), st.integers(1, 5), st.integers(1, 3), UNITS)
def test_random_asymptotic_equalities(power: int, scale: int, wrong: int, unit: str) -> None:
    claim = f"{scale}*x**{power}*{unit}/({unit} + x)"
    assert tresym.check(f"{claim} ~ {scale}*x**{power}", path="x -> 0+").verdict is ENCLOSED
    assert tresym.check(f"{claim} ~ {scale + wrong}*x**{power}", path="x -> 0+").verdict is REFUTED


@given(st.integers(-5, 5), st.integers(-5, 5), st.integers(1, 9), UNITS, SHAPES)
def test_random_identities(a: int, b: int, c: int, unit: str, shape: str) -> None:
    """The product rule holds, and is refuted with anything added to it."""
    left = f"diff(({a})*{unit}*({shape}) + ({b})*x, x)"
    right = f"({a})*diff({unit}, x)*({shape}) + ({a})*{unit}*diff({shape}, x) + ({b})"
    assert tresym.check(f"{left} == {right}").verdict is PROVED
    assert tresym.check(f"{left} == {right} + {c}*10**(-20)*{shape}").verdict is REFUTED


@given(st.fractions(-5, 5, max_denominator=400), st.fractions(0, 1, max_denominator=400))
def test_the_simplest_rational(low: Fraction, width: Fraction) -> None:
    pair = [parse_number(str(x)) for x in (low, low + width)]
    found = Interval(*pair).simplest()
    assert pair[0] <= found <= pair[1]
    for q in range(1, int(found.q)):
        assert (pair[0] * q).ceil() > (pair[1] * q).floor()


# -- SymPy, LaTeX, bad input ----------------------------------------------------------------------


X = sympy.Symbol("x")


@pytest.mark.parametrize("assumption", ["extended_positive", "extended_nonnegative", "positive"])
def test_sympy_assumptions_on_a_sign_are_conditions(assumption: str) -> None:
    x = sympy.Symbol("x", **{assumption: True})
    assert tresym.check(sympy.Gt(x + 1, 0, evaluate=False))


@pytest.mark.slow
def test_sympy_relations_and_assumptions() -> None:
    x = sympy.Symbol("x")
    a = sympy.Symbol("a", positive=True)
    assert tresym.check(sympy.Eq(sympy.Derivative(sympy.sin(x), x), sympy.cos(x)))
    assert tresym.check(sympy.Eq(sympy.sqrt(a**2, evaluate=False), a, evaluate=False))
    assert tresym.check(sympy.Eq(sympy.Abs(x), x, evaluate=False), given=x > 0)
    assert tresym.check(sympy.Eq(sympy.Abs(x), x, evaluate=False)).verdict is REFUTED
    same = sympy.Eq(sympy.sin(x), sympy.sin(x), evaluate=False)
    assert tresym.check(same, limit=HANGS).verdict is PROVED  # SymPy would evaluate a copy of it
    modulus = sympy.Derivative(sympy.Abs(x), x)
    assert tresym.check(sympy.Eq(modulus, sympy.sign(x), evaluate=False))
    assert tresym.check(sympy.Eq(sympy.atan2(x, a), sympy.atan(x / a)))
    assert tresym.check(sympy.Max(x, a, 1) >= sympy.Min(x, a))
    with pytest.raises(InputError, match="all values are real"):
        tresym.check(sympy.Eq(sympy.I * x, a))


@pytest.mark.parametrize(
    "claim",
    [
        sympy.true,
        sympy.Ne(sympy.Symbol("q", irrational=True), 1, evaluate=False),
        sympy.Ne(sympy.Symbol("q", rational=True) ** 2, 2, evaluate=False),
        # by another variable of the same name, and of an unknown function of a known name
        sympy.Eq(sympy.Derivative(X**2, sympy.Dummy("x")), 2 * X, evaluate=False),
        sympy.Eq(sympy.Function("sin")(X) ** 2 + sympy.cos(X) ** 2, 1, evaluate=False),
        X,
        3,
        None,
    ],
)
def test_sympy_that_is_no_claim_is_refused(claim: object) -> None:
    with pytest.raises(InputError):
        tresym.check(claim)


HOSTILE = [
    "",
    "x",
    "x = ",
    "x ==",
    "2 3 == 6",
    "x**(10**9) == 1",
    "2**2**2**2**2 == 1",
    "(" * 5000 + "x" + ")" * 5000 + " == 1",
    "x == " + "+".join(["x"] * 400_000),
    "x == " + "-" * 2000 + "x",
    "__import__('os').system('true') == 0",
    "x.y == 0",
    "x == 1 if x else 2",
    "a(x) == 1",
    "x == O(x)",
    "x == O(x) as x",
    "x == O(x) as x -> x",
    "x == O(x) given x > 0 as x -> 0",
    "x == 1 as x -> 0",
    "x == 1 given a given b",
    "x == 1 given a := 1",
    "x ~ y ~ z as x -> 0",
    "x in y",
    "1 == 1e999999999",
    "\\frac{1}{2} = \\undefinedcommand",
    "é == 1",
    "x\0 == 1",
    "I**2 == -1",
    "x < oo",
    "x == " + "1" * 29_000,
    r"\sqrt{" * 500 + "x" + "}" * 500 + " = x",
]


@pytest.mark.slow
@pytest.mark.parametrize("claim", HOSTILE, ids=range(len(HOSTILE)))
def test_bad_input_is_one_line(claim: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", claim]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("tresym: ")
    assert err.count("\n") == 1
    assert len(err) < 400


# -- the command -----------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "status"),
    [
        (["1 + 1 == 2"], 0),
        (["exp(x) >= 1 + x", "--given", "-2 <= x <= 3"], 0),
        (["sin(x) - x == O(x**3)", "--as", "x -> 0"], 0),
        (["x == x + 1"], 1),
        (["log(x) == log(x)", "--given", "x < 0"], 3),
        (["1 + 1"], 2),
        ([], 2),
        (["1 == 1", "--limit", "0"], 2),
        (["-f", "/no/such/file"], 2),
    ],
)
def test_exit_status(words: list[str], status: int) -> None:
    assert main(["check", "--limit", str(HANGS), *words]) == status


@pytest.mark.slow
def test_json_has_every_key(capsys: pytest.CaptureFixture[str]) -> None:
    main(["check", "--limit", str(HANGS), "sqrt(x**2) == x", "--json"])
    value = json.loads(capsys.readouterr().out)
    keys = {"verdict", "witness", "constant", "region", "seconds", "why", "statement", "line"}
    assert keys <= set(value)
    assert value["verdict"] == "REFUTED"
    assert Fraction(value["witness"]["x"]) < 0


@pytest.mark.slow
def test_a_file_of_claims(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "claims"
    file.write_text(
        "# three that are read, one that is not\n"
        "sin(x)**2 + cos(x)**2 == 1\n\nx ==\n"
        "sqrt(x**2) == x given x > 0   # a condition of its own\n"
        "sin(x) == O(x**2) as x -> 0\n",
        encoding="utf-8",
    )
    assert main(["check", "--limit", str(HANGS), "-f", str(file), "--json"]) == 2
    out, err = capsys.readouterr()
    rows = [json.loads(line) for line in out.splitlines()]
    assert [row["line"] for row in rows] == [2, 4, 5, 6]
    assert [row["verdict"] for row in rows] == ["PROVED", None, "PROVED", "REFUTED"]
    assert "line 4" in err


def test_a_file_of_many_lines_is_not_held_as_so_many_tasks(tmp_path: Path) -> None:
    (tmp_path / "claims").write_text("x\n" * 200_000)
    tracemalloc.start()
    try:
        tasks = read_tasks(str(tmp_path / "claims"), "", None)
        assert next(tasks).claim == "x"
        assert tracemalloc.get_traced_memory()[0] < 4_000_000
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_claims_from_standard_input() -> None:
    command = [sys.executable, "-m", "tresym", "check", "-f", "-", "--json"]
    for text, status in (("1 == 1\nx ==\n", 2), ("1 == 1", 0), ("", 2)):
        done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
        assert done.returncode == status
        assert done.stdout.count('"PROVED"') == bool(text)
        assert "Traceback" not in done.stderr


@pytest.mark.slow
def test_a_claim_that_takes_too_long_is_stopped_and_the_rest_decided() -> None:
    slow = "(sin(x*y*z) + cos(x + y))**60*(x + y + z)**50 - 1 <= 0"
    conditions = "0 <= x <= 1, 0 <= y <= 1, 0 <= z <= 1"
    tasks = [Task("1 == 1"), Task(slow, conditions), Task("2 == 2"), Task("x ==")]
    found = [answer for _, answer in check_all(tasks, 10, processes=1)]
    assert [getattr(a, "verdict", None) for a in found[::2]] == [PROVED, PROVED]
    assert isinstance(found[3], InputError)
    stopped = check_within(Task("exp(sin(x*y)) + z >= cos(x*y*z)", conditions), 1e-4)
    assert stopped.verdict is UNDECIDED
    assert "stopped after" in stopped.why


@pytest.mark.slow
def test_a_claim_that_we_fail_at_does_not_end_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(claim: str, *_: object) -> Answer:
        if claim == "fail":
            raise ZeroDivisionError("within")
        return Answer(PROVED, "")

    monkeypatch.setattr("tresym.checking.time_limited.decide_claim", fails)
    found = [answer for _, answer in check_all([Task("fail"), Task("1 == 1")], HANGS, processes=1)]
    assert [getattr(answer, "verdict", None) for answer in found] == [UNDECIDED, PROVED]
    assert "ZeroDivisionError" in getattr(found[0], "why", "")


@pytest.mark.slow
def test_a_sample_of_the_antiderivatives() -> None:
    real = [pair for pair in check_pairs.pairs() if "sqrt(-b**2)" not in pair.antiderivative]
    for pair in real[::9]:
        assert tresym.check(pair.claim).verdict is PROVED, pair


def test_a_proof_says_whether_what_is_differentiated_is_real() -> None:
    assert "the differentiated functions are real at" in tresym.check("diff(log(x), x) == 1/x").why
    for claim in ("diff(-atanh(cosh(x)), x) == csch(x)", "diff(x + log(-1), x) == 1"):
        answer = tresym.check(claim)
        assert answer.verdict is PROVED
        assert answer.why.endswith("so the proof is about formal derivatives only")


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [(sympy.Ge, PROVED), (sympy.Ne, REFUTED), (sympy.Lt, REFUTED), (sympy.Eq, PROVED)],
)
def test_derivatives_of_sympy_speak_where_their_functions_are_real(
    relation: Callable[..., sympy.Basic], verdict: Verdict
) -> None:
    x = sympy.Symbol("x", real=True)
    slope = sympy.Derivative(sympy.log(x), x)
    assert tresym.check(relation(slope, 1 / sympy.Abs(x))).verdict is verdict
    twice = sympy.Derivative(x * sympy.log(x), x, 2)
    assert tresym.check(relation(twice, 1 / sympy.Abs(x))).verdict is verdict


def test_mutants_are_false() -> None:
    pair = check_pairs.Pair("2*asin(sqrt(x))", "1/sqrt(x - x**2)")
    for seed in range(6):
        mutant = check_pairs._false_mutant(pair, Random(seed))
        claim = check_pairs.Pair(pair.antiderivative, str(mutant)).claim
        assert tresym.check(claim).verdict is REFUTED


def test_the_measurement_as_tables() -> None:
    counts = {"claims": 3, "PROVED": 2, "UNDECIDED": 1, "median": 0.0041, "p99": 0.03}
    trial = {"identities": 5, "REFUTED": 5}
    peers = {"tresym check": {"pairs": 2, "right": 2, "ratio": 1.0}}
    notes = {"pairs": counts, "mutants": counts, "peers": peers}
    notes |= {"true orders": counts | {"ENCLOSED": 1, "longest": 0.5}}
    text = measured({"notes": notes | {"trial": {"true": trial, "false": trial}}})
    assert "| random identities, false | 5 | 0 | 0 | 5 | 0 |" in text
    assert "| true orders | 3 | 2 | 1 | 0 | 1 |" in text
    assert "4.1 ms" in text
    assert "| `tresym check` | 2 | 2 | 0 | 0 | 0 | 1 × |" in text


def test_an_answer_prints_in_a_notebook() -> None:
    answer = tresym.check("x < x + 1")
    assert isinstance(answer, Answer)
    assert "PROVED" in answer._repr_html_()
    assert "&lt;" in answer._repr_html_()
    assert str(answer).startswith("PROVED")


@pytest.mark.slow
@pytest.mark.parametrize("claim", ["sin(x)**2 + cos(x)**2 == 1", "exp(x) >= 1 + x"])
def test_check_loads_flint_alone(claim: str) -> None:
    program = (
        "import sys; from tresym.commands import main; "
        f"status = main(['check', {claim!r}]); "
        "heavy = {'sympy', 'numpy', 'mpmath', 'scipy'} & set(sys.modules); "
        "sys.exit(status or bool(heavy))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_jump_that_is_not_told_apart_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    claim = "2 + sign(x) > 0"
    assert decide_claim(claim)
    monkeypatch.setattr(dispatch, "cases_at_jumps", lambda *_: iter([None]))
    assert decide_claim(claim).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("claim", "region"),
    [
        ("sqrt(x*y) == sqrt(x)*sqrt(y) given x*y > 0", "x >= 0, y >= 0"),
        ("log(x**2) == 2*log(x) given x < 5", "x > 0"),
        ("log(x**2) == 2*log(x) given x > 0", None),
        ("log(x**2) == 2*log(x)", None),  # no region was said
        ("x + x == 2*x given x > 1", None),
    ],
)
def test_the_part_of_the_region_that_a_claim_speaks_of(claim: str, region: str | None) -> None:
    found = tresym.check(claim)
    assert found
    expected = None if region is None else f"where both sides are defined: {region}"
    assert found.region == expected


@pytest.mark.parametrize("separator", ["\u2028", "\x0c", "\x85", "\x1d"])
def test_lines_are_those_of_an_editor(tmp_path: Path, separator: str) -> None:
    claims = tmp_path / "claims"
    claims.write_bytes(f"# a comment {separator} x < x\r\n1 < 2\n\n2 < 3".encode())
    assert [(task.claim, task.line) for task in read_tasks(str(claims), "", None)] == [
        ("1 < 2", 2),
        ("2 < 3", 4),
    ]
