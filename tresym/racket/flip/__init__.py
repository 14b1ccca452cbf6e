"""The flip defect of a freely rotating rigid body, certified to any number of digits."""

from __future__ import annotations

from collections.abc import Iterable

from tresym.racket.angle import Angle, as_angle
from tresym.racket.body import Body, Exact, NamedBody, Shape, as_shape
from tresym.racket.flip.model_selection import checked_digits, climb, follow
from tresym.racket.motion.trajectory import Start
from tresym.racket.result import Flip, Journey
from tresym.reals.numbers.exact import InputError, as_rational

__all__ = ["Flip", "Journey", "flip_angle", "flip_defect", "flip_defects"]


def flip_defect(
    a: Exact | Shape | Body | NamedBody,
    b: Exact | None = None,
    gamma: Exact = 0,
    digits: int = 50,
    *,
    rung: str | None = None,
) -> Flip:
    """The flip defect ε of the shape (a, b) at γ, as a ball with ``digits`` certified digits.

    Args:
        a: I₂/I₁ − 1 > 0; text, an integer or a fraction, like ``b`` and ``gamma``. Or a body,
            which has its ``b`` in it.
        b: 1 − I₂/I₃, in (0, 1].
        gamma: distance from the separatrix, from −b to a.
        digits: 1 to 10 000.
        rung: force one model of the ladder instead of the cheapest that will do.

    Raises:
        InputError: anything outside these ranges.

    Example:
        >>> import tresym
        >>> tresym.flip_defect("12.5372", "0.0629", digits=30).defect.str(12, radius=False)
        '0.115021432971'
    """
    return climb(as_shape(a, b), as_rational(gamma, "gamma"), digits, rung)


def flip_defects(
    shapes: Iterable[Shape | Body | NamedBody | tuple[Exact, Exact]],
    gamma: Exact = 0,
    digits: int = 50,
    *,
    rung: str | None = None,
) -> list[Flip]:
    """The flip defects of many shapes at one γ, as :func:`flip_defect` gives them, in their order.

    γ and the digits are read once. (``tresym sweep`` is for more than fit into memory.)

    Args:
        shapes: bodies, or pairs of a and b.
        gamma: distance from the separatrix, in the range of every shape.
        digits: 1 to 10 000.
        rung: force one model of the ladder.

    Raises:
        InputError: anything outside these ranges, with the place of the shape, from 1.

    Example:
        >>> import tresym
        >>> racket = tresym.Body(1210, 16380, 17480)
        >>> [found.rung for found in tresym.flip_defects([("1", "1/10"), racket])]
        ['separatrix', 'separatrix']
    """
    level, digits, found = as_rational(gamma, "gamma"), checked_digits(digits), []
    if isinstance(shapes, str | bytes) or not isinstance(shapes, Iterable):
        raise InputError("shapes: give pairs of a and b, or bodies")
    for place, given in enumerate(shapes, 1):
        try:
            one = as_shape(given) if isinstance(given, Shape | Body | NamedBody) else _pair(given)
            found.append(climb(one, level, digits, rung))
        except InputError as error:
            raise InputError(f"shape {place}: {error}") from None
    return found


def _pair(given: object) -> Shape:
    if not (isinstance(given, tuple | list) and len(given) == 2):
        raise InputError("give a pair of a and b, or a body")
    return as_shape(*given)


def flip_angle(
    a: Exact | Shape | Body | NamedBody,
    b: Exact | None = None,
    psi0: Exact | Angle = "pi/2",
    rate: Exact | None = None,
    digits: int = 50,
    *,
    theta0: Exact | Angle | None = None,
    precession: Exact | Angle = "2*pi",
    rung: str | None = None,
) -> Journey:
    """Δψ from any start, as a ball with ``digits`` certified digits, with ψ and θ at the end.

    Args:
        a: I₂/I₁ − 1 > 0; text, an integer or a fraction, like ``b``. Or a body.
        b: 1 − I₂/I₃, in (0, 1].
        psi0: ψ at the start in radians; also text such as ``"pi/2"`` or ``"-3*pi/4"``.
        rate: dψ/dφ at the start; this or ``theta0``.
        digits: 1 to 10 000.
        theta0: θ at the start in radians.
        precession: Δφ in radians; a full turn of the handle unless given.
        rung: force a model of the ladder; only ``planar`` knows starts.

    Raises:
        InputError: anything outside these ranges, or a start no body of this shape can have.

    Example:
        >>> import tresym
        >>> end = tresym.flip_angle("1", "1/10", "pi/2", theta0="2")
        >>> end.turn.str(6, radius=False)
        '-2.32688'
    """
    if (rate is None) == (theta0 is None):
        raise InputError("start: give psi0 with either a rate or theta0")
    start = Start(
        as_angle(psi0, "psi0"),
        None if rate is None else as_rational(rate, "rate"),
        None if theta0 is None else as_angle(theta0, "theta0"),
    )
    return follow(as_shape(a, b), start, as_angle(precession, "precession"), digits, rung)
