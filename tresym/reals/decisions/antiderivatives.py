"""Antiderivatives and closed forms of sums suggested by SymPy; the caller checks them.

SymPy is imported at the first call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from tresym.reals.domain.evaluation import Walker
from tresym.reals.functions.table import CONSTANTS, TABLE
from tresym.reals.language.expression import LEAVES, Expr, apply, rebuild, symbols
from tresym.reals.language.sympy import from_sympy
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import stage, time_limit

SECONDS = 1.5
"""Of computing time that each of SymPy's procedures may take, where it can be stopped."""
MOST = 8


def suggested(f: Expr, name: str, positive: frozenset[str]) -> list[Expr]:
    """Yield candidates for antiderivatives of ``f`` in the variable ``name``.

    Args:
        positive: what is known to be positive.
    """
    import sympy
    from sympy.integrals.manualintegrate import manualintegrate

    candidates: list[Expr] = []
    values = {
        s: sympy.Symbol(s, real=True, positive=True if s in positive else None) for s in symbols(f)
    }
    x = values.setdefault(name, sympy.Symbol(name, real=True))
    try:
        integrand = _InSympy(sympy, values).value(f)
    except AttributeError:  # a function that SymPy does not know
        return []
    procedures: tuple[Callable[[], Any], ...] = (
        lambda: manualintegrate(integrand, x),
        lambda: sympy.integrate(integrand, x, meijerg=False),
        lambda: sympy.integrate(integrand.rewrite(sympy.exp), x),
    )
    for procedure in procedures:
        try:
            with stage("search for a closed form"), time_limit(SECONDS, _StoppedError):
                result = procedure()
        except Exception:  # SymPy's own faults are not ours to name
            continue
        for candidate in _branches(sympy, result):
            try:  # constant between its jumps, and the checker has limits at these
                tree = from_sympy(candidate.replace(sympy.floor, lambda _: sympy.Integer(0)))
            except (InputError, RecursionError):
                continue
            candidates += [e for e in (tree, _real_logarithms(tree)) if e not in candidates]
        if candidates:
            break
    return candidates[:MOST]


def summed(kind: str, f: Expr, name: str, low: Expr, high: Expr) -> list[Expr]:
    """Yield candidates for closed forms of the ``"sum"`` or ``"product"`` of ``f``."""
    import sympy

    k = sympy.Symbol(name, integer=True)
    names = symbols(f) | symbols(high)
    values = {s: sympy.Symbol(s, real=True) for s in names} | {name: k}
    values |= {s: sympy.Symbol(s, integer=True, positive=True) for s in symbols(high)}
    procedure = sympy.summation if kind == "sum" else sympy.product
    try:
        body, *ends = (_InSympy(sympy, values).value(e) for e in (f, low, high))
        with stage("search for a closed form"), time_limit(SECONDS, _StoppedError):
            result = procedure(body, (k, *ends))
            if result.has(sympy.RisingFactorial, sympy.factorial, sympy.binomial):
                result = sympy.combsimp(result)
        return [from_sympy(form) for form in _branches(sympy, sympy.factor(result))]
    except Exception:  # SymPy's own faults are not ours to name
        return []


class _InSympy(Walker):
    """Values in SymPy."""

    def _number(self, value: Any) -> Any:
        """A rational number; what is known already is left as it is."""
        known = hasattr(value, "free_symbols")
        return value if known else self.m.Rational(int(value.p), int(value.q))

    def _apply(self, name: str, *values: Any) -> Any:
        if name == "cbrt":
            return self.m.sign(values[0]) * abs(values[0]) ** self.m.Rational(1, 3)
        if name in CONSTANTS:
            return getattr(self.m, name)
        return getattr(self.m, TABLE[name].sympy or name)(*values)


def _branches(sympy: Any, result: Any) -> Iterator[Any]:
    """A result without the cases that it distinguishes."""
    if not result.has(sympy.Piecewise):
        yield result
        return
    folded = sympy.piecewise_fold(result)
    if isinstance(folded, sympy.Piecewise):
        for value, _ in folded.args:
            yield value


def _real_logarithms(e: Expr) -> Expr:
    """``e`` with log|u| for log u."""
    if e.op in LEAVES:
        return e
    args = tuple(map(_real_logarithms, e.args))
    return apply("log", apply("abs", args[0])) if e.op == "log" else rebuild(e, args)


class _StoppedError(Exception):
    """The time is over."""
