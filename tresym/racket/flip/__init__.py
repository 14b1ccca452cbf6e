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
    model: str | None = None,
    rung: str | None = None,
) -> Flip:
    """Compute the flip defect ε of a body as a ball with ``digits`` certified digits.

    Args:
        a: I₂/I₁ − 1 > 0, as text, integer or fraction; or a body, which determines ``b`` as well.
        b: 1 − I₂/I₃, in (0, 1].
        gamma: the level γ from −b to a; 0 is the separatrix.
        digits: 1 to 10 000.
        model: the model to use, ``asymptotic``, ``separatrix``, ``carlson`` or ``planar``; None
            selects the cheapest that delivers the digits.
        rung: the old name of ``model``.

    Returns:
        The defect and the flip Δψ = π − 2ε in radians, and the model that was used.

    Raises:
        InputError: an argument outside these ranges, or a model that cannot deliver the digits.

    Example:
        >>> import tresym
        >>> tresym.flip_defect("12.5372", "0.0629", digits=30).defect.str(12, radius=False)
        '0.115021432971'
    """
    return climb(as_shape(a, b), as_rational(gamma, "gamma"), digits, model or rung)


def flip_defects(
    shapes: Iterable[Shape | Body | NamedBody | tuple[Exact, Exact]],
    gamma: Exact = 0,
    digits: int = 50,
    *,
    model: str | None = None,
    rung: str | None = None,
) -> list[Flip]:
    """Compute the flip defects of many bodies at one γ, in the given order.

    For more bodies than fit into memory use ``tresym sweep``.

    Args:
        shapes: bodies, or pairs of a and b.
        gamma: the level γ, which must be in the range of every shape.
        digits: 1 to 10 000.
        model: the model to use; None selects the cheapest for each body.
        rung: the old name of ``model``.

    Returns:
        A result for each body, as from :func:`flip_defect`.

    Raises:
        InputError: an argument outside these ranges; the message names the shape, counted from 1.

    Example:
        >>> import tresym
        >>> racket = tresym.Body(1210, 16380, 17480)
        >>> [found.model for found in tresym.flip_defects([("1", "1/10"), racket])]
        ['separatrix', 'separatrix']
    """
    level, digits, found = as_rational(gamma, "gamma"), checked_digits(digits), []
    if isinstance(shapes, str | bytes) or not isinstance(shapes, Iterable):
        raise InputError("shapes: give pairs of a and b, or bodies")
    for place, given in enumerate(shapes, 1):
        try:
            one = as_shape(given) if isinstance(given, Shape | Body | NamedBody) else _pair(given)
            found.append(climb(one, level, digits, model or rung))
        except InputError as error:
            raise InputError(f"shape {place}: {error}") from None
    return found


def _pair(given: object) -> Shape:
    """The shape given by a pair of a and b."""
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
    model: str | None = None,
    rung: str | None = None,
) -> Journey:
    """Compute Δψ from any start, with ψ and θ at the end, as balls with certified digits.

    Args:
        a: I₂/I₁ − 1 > 0, as text, integer or fraction; or a body, which determines ``b`` as well.
        b: 1 − I₂/I₃, in (0, 1].
        psi0: ψ at the start in radians; also text such as ``"pi/2"`` or ``"-3*pi/4"``.
        rate: dψ/dφ at the start; give either this or ``theta0``.
        digits: certified digits, 1 to 10 000.
        theta0: θ at the start in radians.
        precession: Δφ in radians; one full turn of the handle by default.
        model: the model to use; only ``planar`` computes motions from a start.
        rung: the old name of ``model``.

    Returns:
        Δψ, ψ and θ at the end in radians, and γ of the orbit.

    Raises:
        InputError: an argument outside these ranges, or a start that no such body can have.

    Example:
        >>> import tresym
        >>> end = tresym.flip_angle("1", "1/10", "pi/2", theta0="2")
        >>> end.flip.str(6, radius=False)
        '-2.32688'
    """
    if (rate is None) == (theta0 is None):
        raise InputError("start: give psi0 with either a rate or theta0")
    start = Start(
        as_angle(psi0, "psi0"),
        None if rate is None else as_rational(rate, "rate"),
        None if theta0 is None else as_angle(theta0, "theta0"),
    )
    return follow(as_shape(a, b), start, as_angle(precession, "precession"), digits, model or rung)
