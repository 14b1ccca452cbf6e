"""Equations between signs tell what follows, and nothing where a part may vanish on a region."""

from itertools import product
from math import prod

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import AgainError, Poly, Ring
from tresym.reals.normal.sign_equations import SignEquations
from tresym.reals.normal.sign_proofs import SignProver

N = 5


def equations_of(under: str = "") -> tuple[SignEquations, list[Poly]]:
    ring = Ring(3 * N)
    equations = SignEquations(SignProver(ring, Given.parse(under)))
    return equations, [ring.variable(ring.symbol(f"x{i}")) for i in range(N)]


equations = st.lists(
    st.tuples(st.sets(st.integers(0, N - 1), min_size=1), st.sampled_from([1, -1])), max_size=6
)


@example([False] + [True] * 4, [({0, 1}, 1), ({1, 2}, 1), ({0, 1, 2}, 1)])
@given(st.lists(st.booleans(), min_size=N, max_size=N), equations)
def test_what_is_learnt_is_what_follows(
    hidden: list[bool], rows: list[tuple[set[int], int]]
) -> None:
    """Over GF(2): of all signs that satisfy the equations, σ is the same in each or a product."""
    truth = [1 if positive else -1 for positive in hidden]
    known = [(keys, prod(truth[i] for i in keys)) for keys, _ in rows]
    system, x = equations_of()
    for _ in range(4):
        system.begin_pass()
        try:
            for keys, sign in known:
                system.require_sign([(x[i], 1) for i in sorted(keys)], sign)
        except AgainError:
            continue
        if not system.learn():
            break
    solutions = [
        s
        for s in product((1, -1), repeat=N)
        if all(prod(s[i] for i in keys) == sign for keys, sign in known)
    ]
    sigmas = [system.sigma(p) for p in x]
    for solution in solutions:
        values = {str(p): arb(s) for p, s in zip(x, solution, strict=True)}
        at = {f"x{i}": arb(s) for i, s in enumerate(solution)}
        assert len(values) == N
        for sigma, s in zip(sigmas, solution, strict=True):
            assert system.ring.ball(sigma, at) == s
    for i, sigma in enumerate(sigmas):
        follows = len({s[i] for s in solutions}) == 1
        assert sigma.is_constant() is follows


def test_a_pair_of_equal_signs_has_that_of_its_sum() -> None:
    system, x = equations_of("x0 > 0")
    a, b = x[1], x[1] - x[0]  # a − b > 0
    system.begin_pass()
    system.require_sign([(a, 1), (b, 1)], -1)
    assert system.learn()
    assert (system.signs.sign(a), system.signs.sign(b)) == (1, -1)
    system, _ = equations_of("x0 > 0")
    system.begin_pass()
    system.require_sign([(a, 1), (b, 1)], 1)  # of a + b nothing is known
    system.learn()
    assert (system.signs.sign(a), system.signs.sign(b)) == (0, 0)


def test_even_powers_and_constants_count() -> None:
    system, x = equations_of()
    system.begin_pass()
    minus = system.ring.context.constant(-3)
    system.require_sign([(x[0], 2), (x[1], 3), (minus, 1), (minus, 2)], 1)
    system.learn()
    assert system.signs.sign(x[1]) == -1
    assert system.signs.sign(x[0]) == 0


def test_a_sign_learnt_after_its_use_begins_a_new_pass() -> None:
    system, x = equations_of()
    system.begin_pass()
    sigma = system.sigma(x[0])
    assert not sigma.is_constant()
    with pytest.raises(AgainError):
        system.require_sign([(x[0], 1)], -1)
    assert system.sigma(x[0]) == -1
    assert system.ring.reduce(sigma) == -1  # what stands there already reduces to it


def test_a_learnt_sign_narrows_the_range() -> None:
    system, x = equations_of()
    system.begin_pass()
    system.require_sign([(2 * x[0] - 3, 1)], 1)
    assert system.signs.sign(x[0] - 1) == 1
    assert system.signs.sign(x[0] - 2) == 0
    assert system.signs.definite(x[0] - 1) == 0  # it holds inside the domain, not on the whole box


def test_what_divides_zero() -> None:
    """d·(1 + σ) is 0 where σ is −1: only there it is inverted, where σ is 1 and it is 2d."""
    system, x = equations_of()
    system.begin_pass()
    sigma = system.sigma(x[0])
    below = x[1] * (1 + sigma)
    with pytest.raises(AgainError):
        system.ring.make(system.ring.one_poly, below)
    assert system.signs.sign(x[0]) == 1
    assert system.signs.sign(x[1]) == 0
    assert system.ring.make(system.ring.one_poly, below).den == 2 * x[1]


def test_what_divides_zero_where_the_sign_is_positive() -> None:
    system, x = equations_of()
    system.begin_pass()
    sigma = system.sigma(x[0])
    with pytest.raises(AgainError):
        system.ring.make(system.ring.one_poly, x[1] * (1 - sigma))
    assert system.signs.sign(x[0]) == -1


def test_a_negative_factor_is_a_fact_with_its_sign() -> None:
    system, x = equations_of()
    system.begin_pass()
    system.require_sign([(x[0] - x[1], 1)], -1)
    assert system.signs.sign(x[1] - x[0] + 1) == 1
    assert system.signs.sign(x[0] - x[1] + 1) == 0


def test_a_sign_proved_later_settles_its_generator() -> None:
    system, x = equations_of()
    system.begin_pass()
    sigma = system.sigma(x[0] + x[1])
    assert not sigma.is_constant()
    for p in x[:2]:
        system.require_sign([(p, 1)], 1)
    system.begin_pass()
    assert system.ring.reduce(sigma) == 1


CARDANO = "(x^3 + y*x)/2", "sqrt((x^3 + y*x)^2/4 + y^3/27)"
MIXED = [
    # zero on a region and not zero in the normal form
    "1 + sign(x)",
    "x + abs(x)",
    "pi/2 - atan(x) - atan(1/x)",
    "atan(x) + atan((1 - x)/(1 + x)) - pi/4",
    "2*atan(x) - asin(2*x/(1 + x^2))",
    "acos(cos(x)) - x",
    "x + atan(cot(x)) - pi/2",
    "log(2 + sign(x)) - log(3)",
    "sqrt(x - 2*sqrt(x - 1)) - sqrt(x - 1) + 1",
    "4*atan(1/2) + 4*atan(1/3) - pi",
    "x*(4*atan(1/2) + 4*atan(1/3) - pi)",
    "log(exp(x) + sqrt(exp(2*x) - 1)) + log(exp(x) - sqrt(exp(2*x) - 1))",
    "cos(2*(x + atan(cot(x)))/3) + 1",
    "sqrt(2 + sqrt(2)) - 2*cos(pi/8)",
    "cbrt({0} + {1}) + cbrt({0} - {1}) - x".format(*CARDANO),
    "log(x - cbrt(2)) + log(x^2 + cbrt(2)*x + cbrt(2)^2) - log(x^3 - 2)",
]
FREE = cases(__file__, "FREE")


@pytest.mark.parametrize("text", MIXED)
def test_may_vanish_on_a_region(text: str) -> None:
    field = Field(Given(), size=48)
    (value,) = field.normal(parse(text))
    assert value.num.is_zero() or field.ring.is_mixed(value.num)


def test_roots_within_roots_may_vanish_together() -> None:
    """Cardano's formula where it has one real root: zero, and no sign in it."""
    field = Field(Given.parse("x > 0, y > 0"), size=48)
    (value,) = field.normal(parse("({0} + {1})**(1/3) - ({1} - {0})**(1/3) - x".format(*CARDANO)))
    assert value.num.is_zero() or field.ring.is_mixed(value.num)


@pytest.mark.parametrize("text", FREE)
def test_vanishes_on_no_region(text: str) -> None:
    field = Field(Given())
    (value,) = field.normal(parse(text))
    assert not field.ring.is_mixed(value.num)


@pytest.mark.parametrize("text", ["x + abs(x)", "1 + sign(x)", "pi/2 - atan(x) - atan(1/x)"])
@pytest.mark.parametrize(("strict", "expected"), [(False, 0), (True, 1)])
def test_a_part_that_may_vanish_tells_nothing_unless_the_product_is_strict(
    text: str, strict: bool, expected: int
) -> None:
    field = Field(Given())
    (value, other) = field.normal(parse(text), parse("y"))
    mixed = value.num
    field.equations.begin_pass()
    field.equations.require_sign([(mixed, 2), (other.num, 1)], 1, strict)
    field.equations.learn()
    assert field.signs.sign(other.num) == expected


def test_an_opaque_value_says_nothing_of_the_others() -> None:
    field = Field(Given(), frozenset())
    (value,) = field.normal(parse("sin(x) - sin(y)"))
    assert field.ring.is_mixed(value.num)
    (x,) = field.normal(parse("x - y"))
    assert field.ring.ball(x, {"x": arb(2), "y": arb(fmpq(1, 2))}) > 1
