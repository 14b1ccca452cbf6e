"""Taylor series for systems of differential equations: rooted trees in place of products.

For a system y′ = f(t, y) the derivatives of f are multilinear: y″ = f_t + f_y(f), and y‴ contains
both f_yy(f, f) and f_y(f_y(f)). Such a term is a tree: a derivative of f, applied to other terms,
its branches. The order of the branches does not matter, so that they are a product of variables,
and a term of a Taylor series of f(t, y + δ) is a product of variables of δ under a new root (J. C.
Butcher, *Numerical Methods for Ordinary Differential Equations*, chapter 3). Different trees are
linearly independent over all f. Scalar equations do not see the difference between some trees of
five and more vertices, and products of solutions have no meaning for systems.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tresym.asymptotics.jets import (
    PERIODIC,
    Equation,
    Jets,
    Polynomial,
    Series,
    UnreadError,
    Variable,
)
from tresym.reals.language.expression import Expr


class SystemJets(Jets):
    """Reads expressions as series in h with linear combinations of trees as coefficients."""

    def __init__(self, h: str, equations: tuple[Equation, ...] = ()) -> None:
        self._branches: dict[Variable, Polynomial] = {}
        super().__init__(h, equations)

    def _degrees(self, p: Polynomial) -> set[int]:
        """Return of how many vectors the terms of a coefficient are products."""
        vectors = [k for k, v in enumerate(self.variables) if v.orders and v.name not in PERIODIC]
        return {sum(int(m[k]) for k in vectors) for m in p.monoms()}

    def is_vector(self, series: Series) -> bool:
        """Return whether a value is a vector rather than a number."""
        degrees = set().union(*map(self._degrees, series.terms.values()))
        if degrees - {0} and degrees != {1}:
            raise UnreadError("numbers are added to vectors, or vectors multiplied")
        return degrees == {1}

    def _product(self, one: Series, other: Series) -> Series:
        if self.is_vector(one) and self.is_vector(other):
            raise UnreadError("a product of vectors has no meaning")
        return one * other

    def _reciprocal(self, series: Series, e: Expr) -> Series:
        return super()._reciprocal(self._number(series), e)

    def _elementary(self, e: Expr, bound: Mapping[str, Series]) -> Series:
        self._number(self.read(e.args[0], bound))
        return super()._elementary(e, bound)

    def _number(self, series: Series) -> Series:
        if self.is_vector(series):
            raise UnreadError("a vector stands where a number is needed")
        return series

    def _place(self, base: tuple[Polynomial, ...]) -> int | None:
        """Return which argument of a function is a vector."""
        places = [k for k, b in enumerate(base) if self.is_vector(self.constant(b))]
        if len(places) > 1:
            raise UnreadError("functions of several vectors are not read")
        return places[0] if places else None

    def _step(
        self, name: str, orders: tuple[int, ...], base: tuple[Polynomial, ...], size: Series
    ) -> Series:
        place = self._place(base)
        degrees = set().union(*map(self._degrees, size.terms.values()))
        if degrees - {0 if place is None else orders[place]}:
            raise UnreadError("numbers are added to vectors, or vectors to numbers")
        if place is None:
            return super()._step(name, orders, base, size)
        terms = {n: self._tree(name, orders, base, c) for n, c in size.terms.items()}
        return Series(terms, size.known)

    def _tree(
        self, name: str, orders: tuple[int, ...], base: tuple[Polynomial, ...], branches: Polynomial
    ) -> Polynomial:
        """Return a derivative of a function, applied to each product of vectors."""
        ring = branches.context()
        vectors = [k for k, v in enumerate(self.variables) if v.orders and v.name not in PERIODIC]
        total = ring.constant(0)
        for exponents, c in branches.terms():
            own: list[Any] = [0] * len(exponents)
            rest = list(exponents)
            for k in vectors:
                own[k], rest[k] = rest[k], 0
            product = ring.from_dict({tuple(own): 1})
            which = Variable(name, orders, (*map(str, base), str(product)))
            self._branches[which] = product
            total += ring.from_dict({tuple(rest): c}) * self._variable(which, base)
        return total

    def _derivative_at(
        self, name: str, orders: tuple[int, ...], base: tuple[Polynomial, ...]
    ) -> Polynomial:
        place = self._place(base)
        if place is None:
            return super()._derivative_at(name, orders, base)
        if orders[place] or name in self.rules:
            raise UnreadError("a derivative by a vector is a matrix")
        return self._tree(name, orders, base, self.one)

    def _slope(self, which: Variable, name: str) -> Polynomial:
        if which not in self._branches:
            return super()._slope(which, name)
        branches, base = self._branches[which], self.bases[which]
        place = self._place(base)
        total = self._tree(which.name, which.orders, base, self._differentiated(branches, name))
        for j, b in enumerate(base):
            inner = self._differentiated(b, name)
            if not inner.is_zero():
                orders = tuple(n + (i == j) for i, n in enumerate(which.orders))
                more = branches * inner if j == place else branches
                found = self._tree(which.name, orders, base, more)
                total += found if j == place else inner * found
        return total

    def _image(self, which: Variable, to: Mapping[str, Polynomial]) -> Polynomial:
        if which not in self._branches:
            return super()._image(which, to)
        base = tuple(self._moved(b, to) for b in self.bases[which])
        return self._tree(which.name, which.orders, base, self._moved(self._branches[which], to))

    @property
    def has_trees(self) -> bool:
        """Whether a function of a vector occurred."""
        return bool(self._branches)

    def spoken(self, p: Polynomial) -> str:
        """Return the first tree of a coefficient, such as f_y(f_yy(f, f))."""
        trees = [v for v in self.used(p) if v.orders]
        return self._spoken(min(trees, key=lambda v: len(v.base[-1])))

    def _spoken(self, which: Variable) -> str:
        if which not in self._branches:
            return str(self.meaning(which))
        index = "".join(x * n for x, n in zip(self.letters(which), which.orders, strict=True))
        branches = [
            self._spoken(v)
            for v, n in zip(self.variables, self._branches[which].degrees(), strict=False)
            for _ in range(max(0, n))
        ]
        head = f"{which.name}_{index}" if index else which.name
        return f"{head}({', '.join(branches)})" if branches else head
