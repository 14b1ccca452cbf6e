"""Claims: frozen values with a statement, conditions, and the evidence for it.

This module only describes claims; it decides nothing. `tresym.ledger.judge` checks the evidence
of a claim and returns a finding, and the reports print the claim in LaTeX and in the ledger. The
claims that a claim depends on are collected from its evidence, so the dependency graph always
agrees with the proofs.

Evidence may hold a derivation, a chain of steps: each states the next expression and the reasons
why it equals the previous one. The chain starts at the left side of the statement and ends at its
right side.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from typing import Any, ClassVar

from flint import fmpq

from tresym.ledger.axioms import Axiom
from tresym.ledger.finding import WEAKEST_FIRST, Premise, Ruling
from tresym.ledger.formulas import (
    Condition,
    EqualMatrices,
    Says,
    Tending,
    Under,
    all_bound,
    in_order,
    in_trees,
    is_bound,
    names_of,
    parts_of,
    together_under,
)
from tresym.reals.language.compound import Count, Equivalent
from tresym.reals.language.compound import Together as All
from tresym.reals.language.expression import substitute, symbol
from tresym.reals.language.formula import Relation
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


def equal(left: Any, right: Any) -> Relation:
    """Return the equation ``left = right``."""
    return Relation(in_trees(left), "==", in_trees(right))


def equations(left: Iterable[Any], right: Iterable[Any]) -> All:
    """Return the system of equations ``left[i] = right[i]``; both have the same length."""
    return All(tuple(equal(p, q) for p, q in zip(left, right, strict=True)))


@dataclass(frozen=True)
class Place:
    """A place in the paper: the number of a display (1…58), a line of the source, a table cell."""

    display: int | None = None
    line: int | None = None
    cell: str | None = None


def display(number: int) -> Place:
    """Return the place of the display with this number."""
    return Place(display=number)


def line(number: int) -> Place:
    """Return the place of a line of the paper's source."""
    return Place(line=number)


@dataclass(frozen=True)
class Reason:
    """Why one expression equals the next: the theories allowed and the claims used."""

    name: str
    theories: frozenset[str] = frozenset()
    claims: tuple[Claim, ...] = ()
    function: str | None = None
    """For ``applying``: the injective function that is applied to both sides of an equation."""
    expression: Any = None
    """For ``changing_variable`` the new variable, for ``integrating`` the antiderivative, for
    ``cutting`` the point where the interval is divided, for ``differentiating_integral`` the
    derivative of the integrand."""
    factor: Any = None
    """For ``multiplying``: the non-zero factor that multiplies both sides of an equation."""
    term: Any = None
    """For ``adding``: the term that is added to both sides of an equation."""

    def __post_init__(self) -> None:
        for name in ("expression", "factor", "term"):
            object.__setattr__(self, name, in_trees(getattr(self, name)))


@dataclass(frozen=True)
class Step:
    """The next expression (or equation) of a chain, and the reasons that lead to it."""

    expression: Any
    """A tree or a statement; None stands for the right side of the statement."""
    reasons: tuple[Reason, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "expression", in_trees(self.expression))


Chain = tuple[Step, ...]


@dataclass(frozen=True)
class Definition:
    """Evidence that the claim defines new symbols, each once, in terms of symbols known before.

    Attributes:
        assumes: the name of the physical assumption, if the claim is one rather than a definition:
            an equation for symbols that are defined elsewhere or that occur in an integrand.
    """

    assumes: str = ""
    kind: ClassVar[str] = "definition"

    @property
    def expect(self) -> Premise:
        """The ruling on the claim: ASSUMED if it names an assumption, else DEFINED."""
        return Premise.ASSUMED if self.assumes else Premise.DEFINED


@dataclass(frozen=True)
class Root:
    """Evidence that the claim defines ``symbol`` as the only root of an equation.

    The claim ``unique`` proves that there is exactly one root. The defining statement consists of
    the equation at the root and of the two ends between which the root lies.
    """

    symbol: str
    unique: Claim
    kind: ClassVar[str] = "definition"
    expect: ClassVar[Ruling] = Premise.DEFINED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claim that the definition uses: that there is exactly one root."""
        return (self.unique,)

    def __post_init__(self) -> None:
        object.__setattr__(self, "symbol", str(self.symbol))

    @property
    def says(self) -> All:
        """The equation that the root satisfies, and the interval that contains it."""
        root, x = self.unique.statement, symbol(self.symbol)
        assert isinstance(root, Count)
        left, right = (in_order(substitute(side, {root.name: x})) for side in root.equation[::2])
        inside = (Relation(x, ">", root.low), Relation(x, "<", root.high))
        return All((Relation(left, "==", right), *inside))


@dataclass(frozen=True)
class Monotone:
    """Evidence that an equation has at most one root: left side minus right side is increasing."""

    slope: Any
    """Evidence that the engine decides the sign of the derivative, by steps or not."""

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The chains of the evidence."""
        found: tuple[Chain, ...] = self.slope.chains
        return found

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What the engine uses."""
        found: tuple[Claim, ...] = self.slope.claims
        return found


@dataclass(frozen=True)
class ImplicitFunction:
    """Evidence for the derivative of a function that an earlier equation defines implicitly.

    ``equation`` relates ``unknown`` and ``parameter``; its right side depends on neither. Let L be
    its left side. Where L is smooth and ∂L/∂unknown is not zero, the implicit function theorem
    gives the unknown as a smooth function of the parameter, with all other symbols fixed. The
    claim defines a new symbol for its derivative at parameter = ``at``:
    −(∂L/∂parameter)/(∂L/∂unknown).
    """

    equation: Claim
    unknown: str
    parameter: str
    at: Any

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claim with the equation."""
        return (self.equation,)

    def __post_init__(self) -> None:
        for name in ("unknown", "parameter"):
            object.__setattr__(self, name, str(getattr(self, name)))
        object.__setattr__(self, "at", in_trees(self.at))


@dataclass(frozen=True)
class Printed:
    """Evidence for a number that the paper prints, computed from inputs as the paper prints them.

    The statement is a `Rounds`. The conditions on the inputs are also `Rounds`, or equations where
    an input is exact. ``claims`` define the other symbols and prove that roots are unique.
    """

    claims: tuple[Claim, ...] = ()
    kind: ClassVar[str] = "number"
    expect: ClassVar[Ruling] = Verdict.ENCLOSED


@dataclass(frozen=True)
class AllOf:
    """Evidence for a conjunction of claims.

    If the claim states a formula, each part of it must be a part of one of ``claims`` (`all_of`).
    A sentence that says no more than its claims do has the conjunction of their formulas as its
    own. With ``words`` the sentence says more than that (`in_words`): whether it follows is left
    to the reader, and it counts neither as formal nor as proved in Coq.
    """

    claims: tuple[Claim, ...]
    words: bool = False
    kind: ClassVar[str] = "statement"

    @property
    def expect(self) -> Ruling:
        """The verdict of the weakest part."""
        return min((c.expect for c in self.claims), key=WEAKEST_FIRST.index, default=Verdict.PROVED)


def all_of(*claims: Claim) -> AllOf:
    """Return the evidence for a conjunction of ``claims``, or of some of their parts."""
    return AllOf(claims)


def jointly(*claims: Claim) -> dict[str, Any]:
    """Return statement, conditions and evidence of a claim that says what ``claims`` say together.

    Conditions that all of them have in common become those of the new claim. If each of them has
    LaTeX of its own for the reports, so does the new claim.

    Example:
        ``d11 = Claim(**jointly(range_of_shape, range_of_gamma))``
    """
    if any(claim.statement is None for claim in claims):
        raise InputError("jointly: a claim states no formula; list only claims with formulas")
    known = [(claim.statement, claim.given) for claim in claims if claim.statement is not None]
    same = {given for _, given in known}
    if len(same) == 1 and not any(
        isinstance(part, Under) for s, _ in known for part in parts_of(s)
    ):
        says = All(tuple(dict.fromkeys(part for s, _ in known for part in parts_of(s))))
        written = [claim.shown for claim in claims]
        shown = {"shown": r",\quad ".join(filter(None, written))} if all(written) else {}
        return {"says": says, "given": known[0][1], "proof": AllOf(claims), **shown}
    return {"says": together_under(known), "proof": AllOf(claims)}


def in_words(*claims: Claim) -> AllOf:
    """Return the evidence for a sentence that says more than the conjunction of ``claims``."""
    return AllOf(claims, words=True)


@dataclass(frozen=True)
class Follows:
    """Evidence of any kind for each part of a statement, in order.

    A part ``Under(φ, conditions)`` is judged under these conditions as well.
    """

    parts: tuple[Evidence, ...]

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims that the evidence for the parts names."""
        named = {id(c): c for part in self.parts for c in _named(part)}  # unlabelled as yet
        return tuple(named.values())

    @property
    def expect(self) -> Ruling:
        """The usual verdict for the weakest of the parts."""
        return min(map(_expected, self.parts), key=WEAKEST_FIRST.index)


def follows(*parts: Evidence) -> Follows:
    """Return the evidence for the parts of a statement, in order."""
    return Follows(parts)


@dataclass(frozen=True)
class RootBound:
    """Evidence for a bound on a root: the sign of the function at the bound.

    The claim ``root`` defines a symbol as the only zero of h between two ends, where h is strictly
    monotone. So the root lies above v exactly if h(v) has the sign that h has at the lower end.

    Example: √2 is the zero of h = x² − 2 in (1, 2), and h(7/5) < 0, so √2 > 7/5.
    """

    root: Claim
    sign: Any
    """Evidence that the engine decides h(v) < 0 or h(v) > 0, whichever is needed, by steps or not.
    """

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The chains of the evidence."""
        found: tuple[Chain, ...] = self.sign.chains
        return found

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What the engine uses, and the definition of the root."""
        return (*self.sign.claims, self.root)


@dataclass(frozen=True)
class RootMonotone:
    """Evidence that a root is strictly monotone in a parameter: the derivative by the parameter.

    The claim ``root`` defines a symbol y as the only zero of h(y, x). By the implicit function
    theorem dy/dx = −(∂h/∂x)/(∂h/∂y). If this has one sign at every zero, y is strictly monotone.

    Example: y is the zero of h = y³ + y − x. As ∂h/∂x = −1 and ∂h/∂y > 0, y increases.
    """

    root: Claim
    slope: Any
    """Evidence that the engine decides the sign of ∂h/∂x at the root; it may substitute the
    equation of the root."""

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The chains of the evidence."""
        found: tuple[Chain, ...] = self.slope.chains
        return found

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The definition of the root, and what the engine uses."""
        return (self.root, *self.slope.claims)


@dataclass(frozen=True)
class MonotoneOf:
    """Evidence that f(y) is strictly monotone in x because y is, and f in y.

    Attributes:
        inner: the claim that y is strictly monotone in x.
        bounds: claims whose bounds on y may be used for the sign of f′(y).
    """

    inner: Claim
    bounds: tuple[Claim, ...] = ()

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims used."""
        return (self.inner, *self.bounds)


@dataclass(frozen=True)
class FromTheEdge:
    """Evidence for a bound on e from the same bound at one value of x, because e is monotone in x.

    Attributes:
        monotone: the claim that e is strictly monotone in x.
        bound: the claim with the bound.
        at: the value of x at which ``bound`` is used, an expression without x.
        of: the variable x; None for any in which ``monotone`` says that e is monotone.
    """

    monotone: Claim
    bound: Claim
    at: Any
    of: Any = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "at", in_trees(self.at))
        object.__setattr__(self, "of", None if self.of is None else str(self.of))

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims used."""
        return (self.monotone, self.bound)


@dataclass(frozen=True)
class FromSlope:
    """Evidence for f > 0 where x > p: f is 0 or positive at x = p, and has a positive derivative.

    Attributes:
        slope: a claim ∂f/∂x > 0.
        start: a claim f(p) = 0, f(p) >= 0 or f(p) > 0, the left side written with `at`.
    """

    slope: Claim
    start: Claim

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims used."""
        return (self.slope, self.start)


@dataclass(frozen=True)
class InfimumBy:
    """Evidence for an infimum: the bound, and points at which it is approached.

    Attributes:
        bound: the claim e > v.
        above: a claim e < v + r.
        along: the symbols as functions of ``t``; as t → 0 from above, r tends to 0.
        claims: both, and the definitions of symbols that the path gives no value.
    """

    bound: Claim
    above: Claim
    along: tuple[tuple[str, Any], ...]
    using: tuple[Claim, ...] = ()

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims used."""
        return (self.bound, self.above, *self.using)


@dataclass(frozen=True)
class Dominated:
    """Evidence for an order as an expression t tends to a point: a bound with that very rate.

    The claims bound the difference from above and from below by multiples of an expression m, where
    m divided by the gauge depends on t only, and is O(1), or o(1), there.
    """

    above: Claim
    """A claim ``d <= m`` or ``abs(d) <= m`` (or with <), d the difference of the order."""
    below: Claim | None = None
    """A claim ``d >= -m``, such as ``d > 0``; None if ``above`` is about the absolute value."""
    expect: ClassVar[Ruling] = Verdict.ENCLOSED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims used."""
        return (self.above,) if self.below is None else (self.above, self.below)


@dataclass(frozen=True)
class Counterexample:
    """Evidence against a statement: an exact point that satisfies the conditions and violates it.

    ``claims`` define the symbols that the point gives no value.
    """

    point: Mapping[str, fmpq]
    claims: tuple[Claim, ...] = ()
    expect: ClassVar[Ruling] = Verdict.REFUTED


@dataclass(frozen=True)
class Instance:
    """Evidence that the statement is ``claim`` with ``values`` substituted for its variables.

    The values must satisfy the conditions of ``claim``; bounds from ``cited`` may be used to show
    that.
    """

    claim: Claim
    values: tuple[tuple[str, Any], ...]
    cited: tuple[Claim, ...] = ()

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims that the instance uses."""
        return (self.claim, *self.cited)

    def __post_init__(self) -> None:
        values = tuple((str(name), in_trees(e)) for name, e in self.values)
        object.__setattr__(self, "values", values)

    def put(self, relation: Relation) -> Relation:
        """Return ``relation`` with the values substituted."""
        values = dict(self.values)
        left, right = (in_order(substitute(e, values)) for e in (relation.left, relation.right))
        return Relation(left, relation.sign, right)

    @property
    def says(self) -> Any:
        """The statement of the instance; a conjunction if the general claim is one."""
        general = self.claim.says
        if isinstance(general, str):
            raise InputError(
                f"{self.claim.label} is stated in words; only a formula can be instantiated"
            )
        parts = tuple(map(self.put, parts_of(general)))
        return All(parts) if isinstance(general, All) else parts[0]


Evidence = (
    Definition
    | Root
    | Instance
    | Monotone
    | ImplicitFunction
    | Printed
    | AllOf
    | Counterexample
    | Any
)


class Fault(Enum):
    """What is wrong with a statement of the paper that is refuted."""

    THEOREM = "the remainder of the theorem, wherever it is printed"
    STATEMENT = "the statement does not hold in all the cases that it covers"
    REASON = "the conclusion holds; the reason given for it does not"
    ROUNDING = "the printed number is close, but not correct to all its digits"
    MISPRINT = "a misprint: the intended formula is clear from the context"


@dataclass(frozen=True)
class Claim:
    """One statement: what it says, under which conditions, and the evidence for it.

    Attributes:
        label: the paper's own ``\\label``, or a name given in proofs/; see :func:`label_claims`.
        says: a statement of :mod:`tresym.ledger.formulas`, or prose. Here, and in every expression
            of the evidence, one of SymPy is converted.
        means: the formula that is decided, if ``says`` is prose or a formula with an open order.
        given: the conditions of the claim.
        proof: the evidence; its type determines how the claim is judged.
        where: the place in the paper; None for an auxiliary lemma.
        expect: the verdict that this claim must get; by default, the usual verdict for its type of
            evidence. For a definition it is always taken from the evidence.
        amended_by: for a claim expected to be REFUTED, the true claims that replace it.
        note: one or two sentences for the reader.
        kind: identity, number, bound, order, limit, statement or definition; by default, derived
            from the evidence and from the form of the statement.
        shown: LaTeX for the reports, if the written-out statement would be hard to read.
        paper_says: what the paper prints, with its qualifications, and how it is read here; used
            if ``says`` is a stricter reading than the paper's.
        fault: for a claim expected to be REFUTED, what is wrong with the paper.
        quotes: theorems that the evidence applies and that no claim proves.
        knowing: local facts. The sign prover shows each from the conditions of the claim and from
            the facts before it; ``Under(φ, (condition, …))`` is a fact about a bound variable.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"].claim.kind
        'identity'
    """

    label: str = ""
    says: Any = ""
    proof: Evidence = None
    kind: str = ""
    given: tuple[Any, ...] = ()
    where: Place | None = None
    expect: Ruling = None  # type: ignore[assignment]
    amended_by: tuple[Claim, ...] = ()
    note: str = ""
    shown: str | None = None
    paper_says: str = ""
    fault: Fault = Fault.STATEMENT
    quotes: tuple[Axiom, ...] = ()
    means: Any = None
    knowing: tuple[Any, ...] = ()

    def __post_init__(self) -> None:
        for name in ("says", "means"):
            object.__setattr__(self, name, in_trees(getattr(self, name)))
        object.__setattr__(self, "given", tuple(_conditions(map(in_trees, self.given))))
        object.__setattr__(self, "knowing", tuple(map(in_trees, self.knowing)))
        defined = isinstance(self.proof, Definition | Root)
        if defined or not self.kind:
            object.__setattr__(self, "kind", _kind(self.says, self.proof))
        if defined or self.expect is None:
            object.__setattr__(self, "expect", _expected(self.proof))

    def __hash__(self) -> int:
        if not self.label:
            raise ValueError(
                "the claim has no label; call label_claims at the end of its module in proofs/"
            )
        return hash(self.label)

    def __repr__(self) -> str:
        return in_one_line(f"Claim({self.label}: {self.says})")

    def _repr_html_(self) -> str:
        """Return a small HTML table for notebooks."""
        given = ", ".join(map(str, self.given))
        rows = [("says", str(self.says)), ("given", given), ("expected", self.expect.value)]
        return html_table(self.label, [row for row in rows if row[1]])

    def _repr_latex_(self) -> str:
        """Return LaTeX of the formula that is decided, or the prose if there is no formula."""
        from tresym.reals.language.typesetting import to_latex

        if self.statement is None:
            return f"$\\text{{{self.says}}}$"
        parts = self.parts
        if not all(isinstance(part, Relation) for part in parts):
            return f"$\\text{{{self.statement}}}$"
        return f"${to_latex(parts)}$"

    @cached_property
    def statement(self) -> Says | None:
        """The formula that is decided, for all values of its free symbols under ``given``.

        The formula of a conjunction combines those of its parts, each under its own conditions.
        None if the claim is prose without a formula.

        Example:
            >>> import tresym
            >>> print(tresym.verify("eq_gamma")["eq_gamma"].claim.statement)
            gamma == a - sin(theta)**2*(a + b*sin(psi)**2)
        """
        if self.means is not None:
            return self.means
        if not isinstance(self.says, str):
            return self.says
        if not isinstance(self.proof, AllOf) or self.proof.words:
            return None
        parts = [(part.statement, part.given) for part in self.proof.claims]
        known = [(says, given) for says, given in parts if says is not None]
        return together_under(known) if len(known) == len(parts) else None

    @property
    def decided(self) -> Says | str:
        """The formula that other claims may substitute or cite; prose if there is no formula.

        Example:
            >>> import tresym
            >>> print(tresym.verify("eq_gamma")["eq_gamma"].claim.decided)
            gamma == a - sin(theta)**2*(a + b*sin(psi)**2)
        """
        return self.says if self.means is None else self.means

    @property
    def in_formulas(self) -> bool:
        """Whether `decided` consists of relations and equivalences.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.in_formulas
            True
        """
        if isinstance(self.decided, str):
            return False
        parts = parts_of(self.decided)
        return all(isinstance(part, Relation | EqualMatrices | Equivalent) for part in parts)

    @cached_property
    def symbols(self) -> frozenset[str]:
        """The names of all symbols that occur in the claim or in its evidence.

        Example:
            >>> import tresym
            >>> claim = tresym.verify("eq_gamma")["eq_gamma"].claim
            >>> {"a", "b", "gamma"} <= claim.symbols
            True
        """
        written = tuple(expressions(self))
        return names_of(*written).union(*map(all_bound, written))

    @property
    def parts(self) -> tuple[Any, ...]:
        """The relations of the statement; empty if there is no formula.

        Example:
            >>> import tresym
            >>> len(tresym.verify("eq_Mi")["eq_Mi"].claim.parts)
            3
        """
        return () if self.statement is None else parts_of(self.statement)

    @cached_property
    def uses(self) -> tuple[Claim, ...]:
        """The claims that the evidence names, in order and without repetition.

        Example:
            >>> import tresym
            >>> [claim.label for claim in tresym.verify("eq_gamma")["eq_gamma"].claim.uses]
            ['d08', 'energy_of_momentum', 'eq_Mi']
        """
        return tuple(dict.fromkeys(_named(self.proof)))

    @cached_property
    def rests_on(self) -> tuple[Claim, ...]:
        """All claims that this claim depends on, directly or indirectly, dependencies first.

        Example:
            >>> import tresym
            >>> claim = tresym.verify("eq_gamma")["eq_gamma"].claim
            >>> "energy" in [each.label for each in claim.rests_on]
            True
        """
        order: dict[Claim, None] = {}
        for claim in self.uses:
            order.update(dict.fromkeys((*claim.rests_on, claim)))
        return tuple(order)

    @cached_property
    def axioms(self) -> tuple[Axiom, ...]:
        """The theorems quoted by the claim or by any claim that it depends on, each once.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.axioms
            ()
        """
        quoted = (axiom for claim in (*self.rests_on, self) for axiom in claim.quotes)
        return tuple(dict.fromkeys(quoted))


def label_claims(names: Mapping[str, Any]) -> None:
    """Give each unlabelled claim in ``names`` the name of its variable as its label.

    Every module of proofs/ ends with ``label_claims(globals())``.
    """
    for name, value in names.items():
        if isinstance(value, Claim) and not value.label:
            object.__setattr__(value, "label", name)


def saying(claim: Claim, changed: Any) -> Claim:
    """Return a copy of the claim that states ``changed`` instead; used to make mutants."""
    changed = in_trees(changed)
    if isinstance(changed, Tending) and not isinstance(claim.says, str):
        return replace(claim, says=changed.relation, means=changed)
    meant = isinstance(claim.says, str) or claim.means is not None
    return replace(claim, means=changed) if meant else replace(claim, says=changed)


def _conditions(given: Iterable[Any]) -> Iterator[Condition]:
    """Yield the single conditions: conjunctions are split."""
    for condition in given:
        if isinstance(condition, All):
            yield from _conditions(condition.parts)
        else:
            yield condition


def _kind(says: Any, proof: Evidence) -> str:
    """Return the kind of a claim: determined by its evidence if possible, else by its form."""
    if not isinstance(says, Relation | All | Equivalent | EqualMatrices):
        return getattr(proof, "kind", "statement")
    inequalities = all(is_bound(part) and part.sign != "!=" for part in parts_of(says))
    return getattr(proof, "kind", "bound" if inequalities else "identity")


def _expected(proof: Evidence) -> Ruling:
    """Return the usual verdict for this type of evidence; ENCLOSED if it uses an ENCLOSED claim."""
    by_type: Ruling = getattr(proof, "expect", Verdict.PROVED)
    enclosed = any(claim.expect is Verdict.ENCLOSED for claim in _named(proof))
    return Verdict.ENCLOSED if by_type is Verdict.PROVED and enclosed else by_type


def expressions(claim: Claim) -> Iterator[Any]:
    """Yield all expressions of the claim and its evidence: statement, conditions and steps."""
    proof = claim.proof
    yield from (e for e in (claim.says, claim.means) if not isinstance(e, str | None))
    yield from claim.given
    yield from claim.knowing
    if isinstance(proof, ImplicitFunction):
        yield from (symbol(proof.unknown), symbol(proof.parameter), proof.at)
    if isinstance(proof, Instance):
        yield from (e for name, value in proof.values for e in (symbol(name), value))
    for chain in _chains(proof):
        for link in chain:
            reasons = ((r.expression, r.factor, r.term) for r in link.reasons)
            written = (link.expression, *(e for three in reasons for e in three))
            yield from (e for e in written if e is not None)


def _chains(proof: Evidence) -> tuple[Chain, ...]:
    """Return the chains that the evidence contains."""
    found: tuple[Chain, ...] = getattr(proof, "chains", ())
    return found


def put_in_by(claim: Claim) -> tuple[Claim, ...]:
    """Return the claims whose equations are substituted; their conditions must hold here."""
    reasons = (r for chain in _chains(claim.proof) for link in chain for r in link.reasons)
    return tuple(dict.fromkeys(c for r in reasons if r.name == "substituting" for c in r.claims))


def asked_by(claim: Claim) -> dict[str, tuple[Any, ...]]:
    """Return the conditions of the claims that are conjoined or substituted, by label."""
    conjoined = isinstance(claim.proof, AllOf)
    asked: dict[str, tuple[Any, ...]] = {}
    for part in claim.uses if conjoined else put_in_by(claim):
        asked |= asked_by(part) if isinstance(part.proof, AllOf) and conjoined else {}
        asked |= {part.label: part.given} if part.given else {}
    return asked


def _named(proof: Evidence) -> Iterator[Claim]:
    """Yield every claim that the evidence names."""
    for chain in _chains(proof):
        for link in chain:
            for reason in link.reasons:
                yield from reason.claims
    yield from getattr(proof, "claims", ())
