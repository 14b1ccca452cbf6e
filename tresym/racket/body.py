"""Rigid bodies: three moments of inertia, or the two shape parameters a and b.

a = I₂/I₁ − 1 and b = 1 − I₂/I₃ are computed exactly from exact input. The named bodies have exactly
the data that the paper prints.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from numbers import Rational
from typing import NamedTuple, TypeAlias

from flint import fmpq

from tresym.reals.notebook import html_table
from tresym.reals.numbers.exact import InputError, as_rational, fraction_text, quoted

Exact: TypeAlias = str | int | Rational | fmpq
"""The types of a number in exact input; floats are refused."""


class Shape(NamedTuple):
    """The shape parameters a = I₂/I₁ − 1 > 0 and b = 1 − I₂/I₃ in (0, 1], as exact rationals."""

    a: fmpq
    b: fmpq

    @property
    def realizable(self) -> bool:
        """Whether a rigid body can have this shape: I₃ ≤ I₁ + I₂, equivalently b ≤ 1/(a + 2)."""
        return bool(self.b * (self.a + 2) <= 1)


def shape(a: Exact, b: Exact) -> Shape:
    """Return the shape with parameters ``a`` and ``b``.

    Raises:
        InputError: unless a > 0 and 0 < b ≤ 1. For a = 0 and b = 0 the message explains that the
            body is a symmetric top.

    Example:
        >>> shape("1", "1/10").realizable
        True
    """
    p, q = as_rational(a, "shape parameter a"), as_rational(b, "shape parameter b")
    if p.p > 0 and 0 < q.p <= q.q:  # comparing integers takes a third of the time
        return Shape(p, q)
    if p < 0:
        raise InputError("shape parameter a: must be positive (a = I2/I1 - 1 with I1 < I2)")
    if p == 0:
        raise InputError(
            "shape parameter a: 0 is a symmetric top (I1 = I2), which only oscillates and has no "
            "flip; a must be positive"
        )
    if q == 0:
        raise InputError(
            "shape parameter b: 0 is a symmetric top (I2 = I3), whose separatrix is all "
            "equilibria: no isolated root, the defect tends to pi/2 as b -> 0; b must be in (0, 1]"
        )
    raise InputError("shape parameter b: must be in (0, 1] (b = 1 - I2/I3 with I2 < I3)")


class Body:
    """A rigid body, given by its three principal moments of inertia, smallest first, in any unit.

    The moments are exact. A body cannot be changed, and bodies with equal moments are equal.

    Example:
        >>> import tresym
        >>> tresym.flip_defect(tresym.Body(1210, 16380, 17480), digits=3).model
        'asymptotic'
    """

    __slots__ = ("I1", "I2", "I3")

    I1: fmpq
    I2: fmpq
    I3: fmpq

    def __init__(self, I1: Exact, I2: Exact, I3: Exact) -> None:
        """Make a body of three moments of inertia.

        Args:
            I1: the smallest moment, as text (``"1210"``, ``"0.3"``, ``"1/3"``), integer or
                fraction.
            I2: the intermediate moment.
            I3: the largest moment.

        Raises:
            InputError: the moments are not positive, not in order, or those of a symmetric top.
        """
        moments = [as_rational(x, f"moment I{i}") for i, x in enumerate((I1, I2, I3), start=1)]
        for i, x in enumerate(moments, start=1):
            if x <= 0:
                raise InputError(f"moment I{i}: must be positive")
        one, two, three = moments
        if one > two or two > three:
            raise InputError(
                "moments of inertia: the expected order is I1 < I2 < I3 (smallest first); "
                f"here {_order(moments)}"
            )
        if one == two or two == three:
            equal = "I1 = I2 = I3" if one == three else "I1 = I2" if one == two else "I2 = I3"
            raise InputError(
                f"moments of inertia: {equal} is a symmetric top, which has no isolated flip "
                "(as I2 -> I3 the defect tends to pi/2); give I1 < I2 < I3"
            )
        for name, value in zip(self.__slots__, moments, strict=True):
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: object) -> None:
        """Refuse, since a body cannot be changed."""
        raise AttributeError("a Body cannot be changed")

    @property
    def shape(self) -> Shape:
        """The exact shape parameters a and b.

        Example:
            >>> print(*Body(2, 3, 4).shape)
            1/2 1/4
        """
        return Shape(self.I2 / self.I1 - 1, 1 - self.I2 / self.I3)

    @property
    def realizable(self) -> bool:
        """Whether I₃ ≤ I₁ + I₂, as for every distribution of mass.

        Example:
            >>> Body(2, 3, 4).realizable, Body(2, 3, 6).realizable
            (True, False)
        """
        return bool(self.I3 <= self.I1 + self.I2)

    def __eq__(self, other: object) -> bool:
        """Return whether all moments are equal."""
        if not isinstance(other, Body):
            return NotImplemented
        return (self.I1, self.I2, self.I3) == (other.I1, other.I2, other.I3)

    def __hash__(self) -> int:
        """Return a hash of the moments."""
        return hash((self.I1, self.I2, self.I3))

    def __repr__(self) -> str:
        """Return the expression that makes this body."""
        return f"Body('{self.I1}', '{self.I2}', '{self.I3}')"

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        moments = ((name, fraction_text(getattr(self, name))) for name in self.__slots__)
        shape = zip("ab", map(fraction_text, self.shape), strict=True)
        return html_table("Body", (*moments, *shape, ("realizable", str(self.realizable))))

    def _repr_latex_(self) -> str:
        """The moments in LaTeX."""
        moments = [f"I_{i} = {fraction_text(getattr(self, f'I{i}'))}" for i in (1, 2, 3)]
        return "$" + ",\\ ".join(moments) + "$"


def _order(moments: list[fmpq]) -> str:
    """The order of the moments as text, such as ``I2 < I1 = I3``."""
    ranked = sorted((x, f"I{i}") for i, x in enumerate(moments, start=1))
    text = ranked[0][1]
    for (x, _), (y, name) in pairwise(ranked):
        text += f" {'=' if x == y else '<'} {name}"
    return text


def shape_of_moments(I1: Exact, I2: Exact, I3: Exact) -> Shape:
    """Return the shape of a body with these moments of inertia.

    Raises:
        InputError: as for :class:`Body`.
    """
    return Body(I1, I2, I3).shape


def shape_of_rotational_constants(B1: Exact, B2: Exact, B3: Exact) -> Shape:
    """Return the shape of a molecule from its rotational constants, largest first.

    A rotational constant is inversely proportional to a moment of inertia.

    Raises:
        InputError: the constants are not positive, or as for :class:`Body`.
    """
    constants = [as_rational(x, f"constant B{i}") for i, x in enumerate((B1, B2, B3), start=1)]
    if min(constants) <= 0:
        raise InputError("rotational constants: must be positive")
    return Body(*(1 / x for x in constants)).shape


def as_shape(a: Exact | Shape | Body | NamedBody, b: Exact | None = None) -> Shape:
    """Return the shape given by two numbers, or by a body alone.

    Raises:
        InputError: as for :func:`shape`, or one number without the other.
    """
    if b is not None:
        if type(a) in (Shape, Body, NamedBody):
            raise InputError(
                "shape: a body has its b in it, so no second value is taken; name further "
                "arguments, as digits=30"
            )
        return shape(a, b)
    if isinstance(a, Shape):
        return shape(*a)
    if isinstance(a, Body | NamedBody):
        return a.shape
    raise InputError("shape: give a and b, or a body")


class NamedBody(NamedTuple):
    """A body of the paper: title, place of its data, how they determine the shape, and the data."""

    title: str
    source: str
    read: Callable[..., Shape]
    data: tuple[str, ...]

    def __repr__(self) -> str:
        return f"NamedBody({self.title}, {self.source}: {', '.join(self.data)})"

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        a, b = self.shape
        rows = [
            (self.source, ", ".join(self.data)),
            ("a", fraction_text(a)),
            ("b", fraction_text(b)),
        ]
        return html_table(self.title, rows)

    def _repr_latex_(self) -> str:
        """The shape in LaTeX."""
        a, b = (fraction_text(x) for x in self.shape)
        return f"$a = {a},\\ b = {b}$"

    @property
    def shape(self) -> Shape:
        """The exact shape computed from the printed data."""
        return self.read(*self.data)


class _Bodies(dict[str, NamedBody]):
    """Bodies by name; an alias is found too, but is not listed."""

    def __missing__(self, name: str) -> NamedBody:
        return self[ALIASES[name]]


ALIASES = {"wilson": "str"}
"""Other names of bodies."""

NAMED_BODIES: Mapping[str, NamedBody] = _Bodies(
    {
        "str": NamedBody(
            "standard tennis racket (Wilson T-2000)",
            "moments of Table 1",
            shape_of_moments,
            ("1210", "16380", "17480"),
        ),
        "t2000-printed": NamedBody(
            "Wilson T-2000", "a and b as the bibliography rounds them", shape, ("12.5372", "0.0629")
        ),
        "racket-1": NamedBody(
            "racket 1", "moments of Table 1", shape_of_moments, ("886", "16336", "18270")
        ),
        "racket-2": NamedBody(
            "racket 2", "moments of Table 1", shape_of_moments, ("1319", "14445", "16175")
        ),
        "racket-3": NamedBody("racket 3", "a and b of Table 1", shape, ("14.88", "0.12")),
        "book": NamedBody("Goldstein's book", "a and b of Table 1", shape, ("1.11", "0.31")),
        "ethylene": NamedBody(
            "ethylene molecule",
            "rotational constants of Sec. 8",
            shape_of_rotational_constants,
            ("4.64", "1.001", "0.828"),
        ),
    }
)
"""The bodies of ``tresym flip --body``, by name."""


def named_body(name: str) -> NamedBody:
    """Return the named body ``name``.

    Raises:
        InputError: there is no such body; the nearest name is suggested.

    Example:
        >>> print(*named_body("racket-3").shape)
        372/25 3/25
    """
    if name in NAMED_BODIES or name in ALIASES:
        return NAMED_BODIES[name]
    from difflib import get_close_matches

    near = get_close_matches(name.lower(), NAMED_BODIES, n=1, cutoff=0.5)
    hint = f"did you mean {near[0]}? " if near else ""
    raise InputError(f"body: {quoted(name)} is not known; {hint}known: {', '.join(NAMED_BODIES)}")
