"""Describe one function of real numbers as a row: all facts that the package uses about it.

A formula in a row, such as that of a derivative, is a plain function whose last argument ``m`` is
an arithmetic: a namespace with the names of the functions and ``pi``. So it is written once and is
used with expression trees, with balls, with numpy or with mpmath. For example, the derivative of
the inverse hyperbolic sine is ``lambda x, m: 1 / m.sqrt(x**2 + 1)``.

Every fact in a row is used in proofs, so that a wrong row can prove a false statement. A test
refutes ``falsehoods`` that a wrong row could prove, and compares every row with mpmath.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.numbers.exact import Interval

Formula = Callable[..., Any]
"""A formula of the arguments of a function and of an arithmetic."""
Conditions = tuple[tuple[Any, str], ...]
"""Expressions and their relations to 0: ``>``, ``>=`` or ``!=``."""


def everywhere(*_: Any) -> Conditions:
    """Return no conditions: the function is defined for all real arguments."""
    return ()


def method(name: str) -> Callable[..., Any]:
    """Return the method ``name`` of balls as a function."""
    found: Callable[..., Any] = getattr(arb, name)
    return found


@dataclass(frozen=True, eq=False, kw_only=True)
class Function:
    """A real function of real arguments.

    Only the name is required. A fact that is not stated is not used.

    Attributes:
        name: the name in the language of claims.
        family: the functions it belongs to, such as ``"hyperbolic"``.
        arity: the number of arguments.
        definition: the definition, in LaTeX.
        source: where the definition and the facts are stated.
        theory: the rules of the normal form that apply to it; empty for none.
        needs: where the function is defined, as a formula for :data:`Conditions`.
        singular: where it is analytic, if that differs from ``needs`` made strict.
        smooth: whether it has a derivative wherever it is defined.
        ends: ends of the domain that belong to the domain.
        range: an interval that contains all values.
        odd: whether f(−x) = −f(x).
        even: whether f(−x) = f(x).
        rising: whether the function increases strictly on its domain, which is an interval.
        falling: whether it decreases strictly on its domain, which is an interval.
        sign_of: a formula for an expression with the same sign, wherever the function is defined.
        vanishes_with_argument: whether f(x) = 0 exactly where x = 0.
        derivatives: the derivative with respect to each argument, None where no formula is known.
        slope: the derivative in balls, of the argument and the value; for arity 1.
        inverse: the inverse function, for a function that is one-to-one.
        image: the ends of all values for a one-to-one function (a formula of the arithmetic; None
            for infinity), and whether the function takes them.
        branch: for a periodic function the name of the inverse on a range, the sign and shift that
            yield another solution, and that range.
        by_others: the function by simpler ones, valid wherever it is defined.
        quotient: numerator and denominator, if the function is the quotient of two others.
        reciprocal: the function whose reciprocal it is.
        entire: whether it has no singularity in the complex plane.
        zeros_apart: how far from 0 the nearest other zero in the complex plane is, over π.
        poles_apart: how far from 0 the nearest pole other than 0 is, over π.
        branched: whether its singularities in the complex plane lie at distance 1 from 0.
        off_cuts: whether a complex ball avoids the branch cuts, off which it is analytic.
        power_series: the general term of its power series at 0, in ``y`` and ``k``.
        ball: the value in balls; not finite where it is not proved to exist.
        holomorphic: the value in complex balls, not finite unless holomorphic there.
        series: the composition with a power series in balls.
        rational_series: the composition with a power series of rational coefficients.
        double: the value in double precision.
        positive_where: an expression; where it is positive, so is the function.
        negative_where: an expression; where it is positive, the function is negative.
        never_zero: whether the function vanishes nowhere.
        rewritten: a rule that returns an equal expression in simpler functions, or None: a formula
            of the arguments and the arithmetic.
        shifted: the position of the argument that recurrences move.
        recurrence: the function by values at a lower argument, by steps of 1.
        raising: the same by values at a higher argument.
        base: how many neighbouring values the recurrence needs; arguments are moved to
            [start, start + base) by recurrences.
        start: the lower end of that interval.
        mirror: the function by its values at the opposite side, for arguments whose leading
            coefficient is negative.
        poles: whether it has poles at 0, −1, −2, …, off which ``raising`` leads.
        multiplied: the function of an argument n·u by the function at n arguments u + k/n.
        near: exact formulas from which the behaviour near an end is read off: at ``"oo"``,
            ``"-oo"``, above or below a rational number (``"0+"``, ``"1-"``). They consist of
            elementary functions, functions regular there, and factors such as ``erfc_tail``, whose
            power series at 0 is asymptotic.
        near_needs: what must be positive for a formula near a finite end to hold.
        taylor: the k-th coefficient of the power series at 0 in the last argument, a formula of
            the other arguments and of k.
        remainder: for a factor, a bound of |R_n(v)|/vⁿ for 0 < v ≤ s, a function of the other
            arguments, s and n.
        terms: how many terms of the series are known; 0 for all.
        internal: whether users cannot write the function.
        constant: whether the function stands for a constant; its argument is 1.
        latex: the LaTeX command or text.
        subscripted: whether the first argument is printed as a subscript.
        reads: further LaTeX commands that denote it.
        mathml: the name in MathML, if it differs from ``name``.
        aliases: further names in the language of claims.
        of_reciprocal: names for the function of the reciprocal argument, f(1/x).
        mathematica: the name in Mathematica.
        maple: the name in Maple.
        sympy: the name in SymPy.
        coq: the name in the Coq library of the package, or None.
        confused: functions that are often written by mistake instead of it.
        theorems: theorems that are quoted and not proved here, with sources.
        falsehoods: false statements close to true ones, which a test refutes.
    """

    name: str
    family: str
    arity: int = 1
    definition: str = ""
    source: str = ""
    theory: frozenset[str] = frozenset()
    needs: Callable[..., Conditions] = everywhere
    singular: Callable[..., Conditions] | None = None
    smooth: bool = True
    ends: tuple[int, ...] = ()
    range: Interval = field(default_factory=Interval)
    odd: bool = False
    even: bool = False
    rising: bool = False
    falling: bool = False
    sign_of: Formula | None = None
    vanishes_with_argument: bool = False
    derivatives: tuple[Formula | None, ...] = ()
    slope: Callable[[arb, arb], arb] | None = None
    inverse: str = ""
    image: Formula | None = None
    branch: tuple[str, tuple[int, fmpq], tuple[fmpq, fmpq]] | None = None
    by_others: Formula | None = None
    quotient: tuple[str, str] | None = None
    reciprocal: str = ""
    entire: bool = False
    zeros_apart: fmpq | None = None
    poles_apart: fmpq | None = None
    branched: bool = False
    off_cuts: Callable[[acb], bool] | None = None
    power_series: str = ""
    ball: Callable[..., arb]
    holomorphic: Callable[..., acb] | None = None
    series: Callable[..., Any] | None = None
    rational_series: Callable[[Any], Any] | None = None
    double: Callable[..., float] | None = None
    positive_where: Formula | None = None
    negative_where: Formula | None = None
    never_zero: bool = False
    rewritten: Formula | None = None
    recurrence: Formula | None = None
    raising: Formula | None = None
    base: int = 1
    start: int = 0
    shifted: int = 0
    mirror: Formula | None = None
    poles: bool = False
    multiplied: Formula | None = None
    near: dict[str, Formula] = field(default_factory=dict)
    near_needs: Formula | None = None
    taylor: Formula | None = None
    remainder: Callable[..., arb] | None = None
    terms: int = 0
    internal: bool = False
    constant: bool = False
    latex: str = ""
    subscripted: bool = False
    reads: tuple[str, ...] = ()
    mathml: str = ""
    aliases: tuple[str, ...] = ()
    of_reciprocal: tuple[str, ...] = ()
    mathematica: str = ""
    maple: str = ""
    sympy: str = ""
    coq: str | None = None
    confused: tuple[str, ...] = ()
    theorems: tuple[str, ...] = ()
    falsehoods: tuple[str, ...] = ()
