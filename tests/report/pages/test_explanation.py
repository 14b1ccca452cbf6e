"""A verdict is explained with its lemma, its steps, its constant and a table of both sides."""

import mpmath
import pytest

from tresym.commands import main
from tresym.reals.verdict import Verdict
from tresym.report.pages.explanation import explain


def test_each_step_of_a_lemma_has_its_own_reason() -> None:
    found = explain("integral(exp(-x*t)/(1 + t), t, 0, oo) == 1/x + O(1/x**2) as x -> oo")
    assert found.answer.verdict is Verdict.PROVED
    assert [step.verdict for step in found.steps] == ["PROVED"] * len(found.steps)
    assert any(step.why for step in found.steps)
    text = found.markdown()
    for part in ("**Lemma.** Watson's lemma (Olver 1974", "**Constant.** at most", r"$x > 0$"):
        assert part in text


@pytest.mark.parametrize(
    ("claim", "ratio"),
    [
        ("sin(x) ~ x - x**3/4 as x -> 0", "-1/3"),
        ("exp(x) == 1 + O(x) as x -> 0+", "1"),
        ("log(x) == O(1) as x -> oo", None),
    ],
)
def test_the_table_shows_where_the_ratio_goes(claim: str, ratio: str | None) -> None:
    head, *rows = explain(claim).compared
    assert head[-1] == "left/right"
    last = [abs(mpmath.mpf(row[-1])) for row in rows]
    if ratio is None:
        assert last == sorted(last)
        assert last[-1] > 6
    else:
        assert abs(last[-1] - abs(mpmath.mpf(fraction(ratio)))) < 1e-2


def fraction(text: str) -> mpmath.mpf:
    top, _, bottom = text.partition("/")
    return mpmath.mpf(top) / mpmath.mpf(bottom or 1)


def test_the_command_tells_a_refutation(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "(1 + 1/n)**n -> 3 as n -> oo"]) == 1
    text = capsys.readouterr().out
    assert "True instead. (1/n + 1)**n -> E" in text
    assert "256  2.71299" in text
    assert main(["explain", "x +"]) == 2


def test_the_page_has_the_table_and_a_picture_within_the_region() -> None:
    pytest.importorskip("matplotlib")
    text = explain("exp(x) == 1 + O(x) as x -> 0+ on x <= 1").html()
    assert "<table>" in text
    assert "<svg" in text
    assert "1.71828" in text


def test_points_without_a_value_are_left_out() -> None:
    """At eps = 1 the logarithm has no value."""
    _, *rows = explain("log(1/(1 - x)) == x + O(x**2) as x -> 0+").compared
    assert [row[0] for row in rows][:2] == ["1/4", "1/16"]
    assert "Counterexample" not in explain("x -> 3 as x -> 0+").text()


def test_the_claim_stands_as_it_was_typed_unless_it_was_read_otherwise() -> None:
    found = explain("(1 + 1/n)**n -> E as n -> oo")
    assert found.text().startswith("Claim. (1 + 1/n)**n -> E as n -> oo\n")
    assert found.markdown().startswith(r"**Claim.** $\left(1 + \frac{1}{n}\right)^{n} \to e")
    assert "E**x" in explain("e**x -> 1 as x -> 0").text().splitlines()[0]
    assert "x**2 == 4 <=> x == 2" in explain("x^2 = 4 <=> x = 2").text().splitlines()[0]
