"""The points of a chart: what a symbol is there satisfies the equation that it stands for."""

from flint import arb

from tresym.racket.bounds import samples as s
from tresym.racket.formulas import stable
from tresym.racket.motion.quadrature import rigorous
from tresym.racket.notation import a, b, epsilon, epsilon0, gamma, lam, mu
from tresym.reals.numbers.arithmetic import ball_precision, balls

BENT = s.in_bent_chart()


def test_a_root_is_a_root_at_every_sample() -> None:
    with ball_precision(200):
        found = list(BENT())
        assert found
        for _, known in found:
            residual = rigorous(known[epsilon0], known[a], known[b], arb(0)) - arb.pi()
            assert residual.contains(0)
            assert residual.rad() < arb("1e-20")
            assert (known[lam] ** 2 * known[a] * known[b] - 1).contains(0)
            assert (known[mu] ** 2 * (known[a] + known[b]) - known[b]).contains(0)


def test_a_level_beside_the_separatrix_has_its_defect() -> None:
    """Not that of the tangent, and not that of the separatrix."""
    with ball_precision(400):
        for _, known in BENT():
            place = known[a], known[b], known[gamma]
            assert (rigorous(known[epsilon], *place) - arb.pi()).contains(0)
            tangent = known[epsilon0] + s.slope_at_separatrix(known) * known[gamma]
            assert not (rigorous(tangent, *place) - arb.pi()).contains(0)
            assert not known[epsilon].overlaps(known[epsilon0])


def test_the_defect_falls_with_the_level() -> None:
    with ball_precision(200):
        for _, known in BENT():
            turn = stable.turn_slope(known[epsilon0], known[a], known[b], balls)
            found = s.slope_at_separatrix(known)
            assert found < 0
            assert turn < 0
