"""Evaluate an expression with mpmath, with SciPy in double precision, or by a user's function.

These are what certified values are compared with; nothing is proved by them. Integrals are
``mpmath.quad`` or ``scipy.integrate.quad``, roots ``mpmath.findroot`` or ``scipy.optimize.brentq``,
series ``mpmath.nsum``. A user's function is named as ``module:function``, with a file allowed as
module (``solver.py:period``); it is called with the parameters as keywords, in double precision,
and with ``digits=N`` and exact fractions if it has such an argument.
"""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import os
import sys
from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from flint import fmpq

from tresym.reals.domain.evaluation import Walker
from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.expression import Expr, opened
from tresym.reals.numbers.exact import InputError, shortened

_NUMPY = {row.name: row.aliases[0] for row in TABLE.values() if row.branched}
_NUMPY |= {"atan2": "arctan2", "abs": "fabs"}
_RECIPROCAL = {row.name: row.reciprocal for row in TABLE.values() if row.reciprocal}
FAR = 50.0
"""The end that a root finder gets for an infinite one."""


class InMpmath(Walker):
    """Evaluate with mpmath at its working precision."""

    def _number(self, x: Any) -> Any:
        return self.m.mpf(int(x.p)) / int(x.q) if isinstance(x, fmpq) else self.m.mpf(x)

    def _computed(self, e: Expr) -> Any:
        m = self.m
        if e.op == "unknown" and e.args[0].args[0] == FACTORIAL:
            return m.factorial(self.value(e.args[1]))
        if e.op == "symbol" and e == INFINITY:
            return m.inf
        if e.names:
            (name,), body = opened(e)
            body = worked_out(body)

            def function(x: Any) -> Any:
                return type(self)(m, {**self.at, name: x}).value(body)

            low, high = (self.value(end) for end in e.args[1:3])
            if e.op == "integral":
                return m.quad(function, [low, high])
            if e.op == "root":
                ends = max(low, -FAR), min(high, FAR)
                return m.findroot(function, ends, solver="anderson")
            if e.op == "sum":
                return m.nsum(function, [low, high])
            raise InputError(f"mpmath: {e.op} is not compared")
        return super()._computed(e)

    def _apply(self, name: str, *values: Any) -> Any:
        if name == "abs":
            return self.m.fabs(*values)
        return getattr(self.m, name)(*values)


class InDoubles(Walker):
    """Evaluate with numpy and SciPy in double precision; values may be arrays."""

    def _number(self, x: Any) -> Any:
        return int(x.p) / int(x.q) if isinstance(x, fmpq) else x

    def _computed(self, e: Expr) -> Any:
        if e.op == "unknown" and e.args[0].args[0] == FACTORIAL:
            from scipy.special import gamma

            return gamma(self.value(e.args[1]) + 1)
        if e.op == "symbol" and e == INFINITY:
            return self.m.inf
        if e.names:
            return self._bound(e)
        return super()._computed(e)

    def _bound(self, e: Expr) -> Any:
        (name,), body = opened(e)
        body = worked_out(body)

        def function(x: Any) -> Any:
            return type(self)(self.m, {**self.at, name: x}).value(body)

        low, high = (self.value(end) for end in e.args[1:3])
        if e.op == "integral":
            from scipy.integrate import quad

            return quad(function, low, high, epsabs=0, epsrel=1e-13, limit=200)[0]
        if e.op == "root":
            from scipy.optimize import brentq

            return brentq(function, max(low, -FAR), min(high, FAR), xtol=1e-300, rtol=1e-15)
        raise InputError(f"SciPy: {e.op} is not compared")

    def _apply(self, name: str, *values: Any) -> Any:
        if name in _RECIPROCAL:
            return 1 / getattr(self.m, _RECIPROCAL[name])(*values)
        return getattr(self.m, _NUMPY.get(name, name))(*values)


def loaded(name: str) -> Callable[..., Any]:
    """Return the function that ``module:function`` or ``file.py:function`` names.

    Raises:
        InputError: there is none, or its module cannot be imported.
    """
    module, colon, function = name.rpartition(":")
    if not colon or not function.isidentifier():
        raise InputError(f"write module:function or file.py:function, not {name!a}")
    try:
        if module.endswith(".py"):
            path = Path(module)
            spec = importlib.util.spec_from_file_location(path.stem, path)
            if spec is None or spec.loader is None or not path.is_file():
                raise InputError(f"{module}: there is no such Python file")
            found: Any = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(found)
        else:
            sys.path.insert(0, os.getcwd())
            try:
                found = importlib.import_module(module)
            finally:
                sys.path.pop(0)
    except InputError:
        raise
    except Exception as error:
        why = shortened(" ".join(str(error).split()), 100)
        raise InputError(f"{module} cannot be imported: {why}") from None
    result = getattr(found, function, None)
    if not callable(result):
        raise InputError(f"{module} has no function {function}")
    return result


def takes_digits(function: Callable[..., Any]) -> bool:
    """Return whether a function has an argument ``digits``."""
    try:
        return "digits" in inspect.signature(function).parameters
    except (TypeError, ValueError):
        return False


def called(
    function: Callable[..., Any], at: Mapping[str, Fraction], digits: int | None = None
) -> Any:
    """Call a user's function with its parameters by name."""
    if digits is not None:
        return function(**at, digits=digits)
    return function(**{name: float(x) for name, x in at.items()})
