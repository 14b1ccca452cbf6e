"""Guards of the special functions: each false claim passes where its guard is missing."""

import pytest
from flint import arb

from tresym.reals.decisions import equal_by_limit, identity
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.functions.enclosures import factor
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import ZERO
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

Patch = pytest.MonkeyPatch


def test_a_constant_difference_needs_its_value(monkeypatch: Patch) -> None:
    """Without the limit, a zero derivative proves W(J₀, Y₀) x = 1/π as well."""
    left = parse("besselj(1, x)*bessely(0, x) - besselj(0, x)*bessely(1, x)")
    wrong = parse("1/(pi*x)")
    assert equal_by_limit.equal_by_limit(left, parse("2/(pi*x)"), Given())
    assert equal_by_limit.equal_by_limit(left, wrong, Given()) is None
    monkeypatch.setattr(equal_by_limit, "_place", lambda *_: "somewhere")
    assert equal_by_limit.equal_by_limit(left, wrong, Given())


def test_every_interval_of_the_domain_needs_its_value(monkeypatch: Patch) -> None:
    """sign(x) is constant on both sides of 0: the limit at one end alone proves nothing."""
    claim = (parse("erf(x) + erfc(x) + sign(x)"), parse("2"), Given())
    assert equal_by_limit.equal_by_limit(*claim) is None
    monkeypatch.setattr(equal_by_limit, "_pieces", lambda *_: [(parse("0").args[0], None)])
    assert equal_by_limit.equal_by_limit(*claim)


def test_an_order_may_be_exceptional() -> None:
    """J_ν(x) is like (x/2)^ν/Γ(ν + 1) at 0 but for ν = −1, −2, …."""
    e = parse("besselj(nu, x)/besselj(nu, 2*x)")
    assert limit_of(e, "x", ZERO, 1, Given()) is None
    assert limit_of(e, "x", ZERO, 1, Given.parse("nu > -1")) is not None


def test_a_series_is_enveloping_only_from_some_index() -> None:
    """ln x − ψ(x) exceeds 1/(2x), its first term that is not 0."""
    row = TABLE["digamma_tail"]
    assert row.taylor is not None
    assert row.remainder is not None
    with ball_precision():
        v = arb("0.5")
        value, bound = abs(row.ball(v)), row.remainder(v, 0)
        assert value <= bound
        careless = factor("careless", lambda k: row.taylor(k, None), None)  # type: ignore[misc]
        assert careless.remainder is not None
        assert not value <= careless.remainder(v, 0)


def test_the_prover_uses_the_module_under_test() -> None:
    assert identity.equal_by_limit is equal_by_limit.equal_by_limit
