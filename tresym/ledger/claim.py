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

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import Any, ClassVar

from flint import fmpq
from sympy import And, Basic, Derivative, Eq, Expr, Ge, Gt, Le, Lt, Subs, Symbol, Tuple, true

from tresym.ledger.axioms import Axiom
from tresym.ledger.finding import WEAKEST_FIRST, Premise, Ruling
from tresym.ledger.statements import As, ExactlyOne, Statement, Under, together_under
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


def equal(left: Basic, right: Basic) -> Eq:
    """Return the equation ``left = right``, which SymPy is not allowed to evaluate."""
    return Eq(left, right, evaluate=False)


def parts_of(says: Basic | str) -> tuple[Basic, ...]:
    """Return the relations of a statement: the entries of a `Tuple`, or the statement itself."""
    return says.args if isinstance(says, Tuple) else (says,)


def equations(left: tuple[Basic, ...], right: tuple[Basic, ...]) -> Tuple:
    """Return the system of equations ``left[i] = right[i]``; both tuples have the same length."""
    return Tuple(*(equal(p, q) for p, q in zip(left, right, strict=True)))


def at(e: Expr, values: Mapping[Symbol, Any]) -> Subs:
    """Return ``e`` with its symbols replaced by ``values``, as an unevaluated `Subs`.

    If SymPy evaluated the substitution, nothing would be left to prove.

    Raises:
        ValueError: ``e`` contains a derivative and two symbols get the same value. SymPy would
            confuse the two symbols and identify different derivatives.
    """
    if e.has(Derivative) and len(set(values.values())) < len(values):
        raise ValueError(
            "two symbols get the same value inside a derivative; substitute one after the other"
        )
    return Subs(e, tuple(values), tuple(values.values()))


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
    expression: Expr | None = None
    """For ``changing_variable`` the new variable, for ``integrating`` the antiderivative, for
    ``cutting`` the point where the interval is divided, for ``differentiating_integral`` the
    derivative of the integrand."""
    factor: Expr | None = None
    """For ``multiplying``: the non-zero factor that multiplies both sides of an equation."""
    term: Expr | None = None
    """For ``adding``: the term that is added to both sides of an equation."""


@dataclass(frozen=True)
class Step:
    """The next expression (or equation) of a chain, and the reasons that lead to it."""

    expression: Basic | None
    """None stands for the right side of the statement."""
    reasons: tuple[Reason, ...]


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

    symbol: Symbol
    unique: Claim
    kind: ClassVar[str] = "definition"
    expect: ClassVar[Ruling] = Premise.DEFINED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claim that the definition uses: that there is exactly one root."""
        return (self.unique,)

    @property
    def says(self) -> Tuple:
        """The equation that the root satisfies, and the interval that contains it."""
        root, x = self.unique.statement, self.symbol
        assert isinstance(root, ExactlyOne)
        sides = (side.xreplace({root.variable: x}) for side in root.args[3].args)
        return Tuple(
            equal(*sides), Gt(x, root.low, evaluate=False), Lt(x, root.high, evaluate=False)
        )


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
    unknown: Symbol
    parameter: Symbol
    at: Expr

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claim with the equation."""
        return (self.equation,)


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
        says = Tuple(*dict.fromkeys(part for s, _ in known for part in parts_of(s)))
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
    at: Expr
    of: Symbol | None = None

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
    along: tuple[tuple[Symbol, Any], ...]
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
    values: tuple[tuple[Symbol, Expr], ...]
    cited: tuple[Claim, ...] = ()

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims that the instance uses."""
        return (self.claim, *self.cited)

    def put(self, relation: Basic) -> Basic:
        """Return ``relation`` with the values substituted, unevaluated."""
        sides = (side.xreplace(dict(self.values)) for side in relation.args)
        return relation.func(*sides, evaluate=False)

    @property
    def says(self) -> Basic:
        """The statement of the instance; a `Tuple` if the general claim is one."""
        general = self.claim.says
        if not isinstance(general, Basic):
            raise InputError(
                f"{self.claim.label} is stated in words; only a formula can be instantiated"
            )
        parts = tuple(map(self.put, parts_of(general)))
        return Tuple(*parts) if isinstance(general, Tuple) else parts[0]


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
        says: a SymPy relation, a `Tuple` of them, an `Equivalent`, or prose.
        means: the formula that is decided, if ``says`` is prose or a formula with an open order.
        given: the conditions of the claim, as SymPy relations.
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
        first: a function that raises an error if the claim may not be judged, or None. A text is
            asked here whether each of its expressions has a value where that of SymPy has one.
        knowing: local facts. The sign prover shows each from the conditions of the claim and from
            the facts before it; ``Under(φ, (condition, …))`` is a fact about a bound variable.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"].claim.kind
        'identity'
    """

    label: str = ""
    says: Basic | str = ""
    proof: Evidence = None
    kind: str = ""
    given: tuple[Basic, ...] = ()
    where: Place | None = None
    expect: Ruling = None  # type: ignore[assignment]
    amended_by: tuple[Claim, ...] = ()
    note: str = ""
    shown: str | None = None
    paper_says: str = ""
    fault: Fault = Fault.STATEMENT
    quotes: tuple[Axiom, ...] = ()
    means: Basic | None = None
    knowing: tuple[Basic, ...] = ()
    first: Callable[[], None] | None = field(default=None, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "given", tuple(_conditions(self.given)))
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
        from sympy import latex

        if self.statement is None:
            return f"$\\text{{{self.says}}}$"
        return f"${latex(self.statement)}$"

    @cached_property
    def statement(self) -> Basic | None:
        """The formula that is decided, for all values of its free symbols under ``given``.

        The formula of a conjunction combines those of its parts, each under its own conditions.
        None if the claim is prose without a formula.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.statement
            Eq(gamma, a - (a + b*sin(psi)**2)*sin(theta)**2)
        """
        if self.means is not None:
            return self.means
        if isinstance(self.says, Basic):
            return self.says
        if not isinstance(self.proof, AllOf) or self.proof.words:
            return None
        parts = [(part.statement, part.given) for part in self.proof.claims]
        known = [(says, given) for says, given in parts if says is not None]
        return together_under(known) if len(known) == len(parts) else None

    @property
    def decided(self) -> Basic | str:
        """The formula that other claims may substitute or cite; prose if there is no formula.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.decided
            Eq(gamma, a - (a + b*sin(psi)**2)*sin(theta)**2)
        """
        return self.says if self.means is None else self.means

    @property
    def in_formulas(self) -> bool:
        """Whether `decided` consists of SymPy relations (not prose and not a `Statement`).

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.in_formulas
            True
        """
        if not isinstance(self.decided, Basic):
            return False
        return not any(isinstance(part, Statement) for part in parts_of(self.decided))

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """All symbols that occur in the claim or in its evidence.

        Example:
            >>> import tresym
            >>> claim = tresym.verify("eq_gamma")["eq_gamma"].claim
            >>> {"a", "b", "gamma"} <= {symbol.name for symbol in claim.symbols}
            True
        """
        written = (e for e in expressions(self) if isinstance(e, Basic))
        return frozenset(s for e in written for s in e.atoms(Symbol))

    @property
    def parts(self) -> tuple[Basic, ...]:
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


def saying(claim: Claim, changed: Basic) -> Claim:
    """Return a copy of the claim that states ``changed`` instead; used to make mutants."""
    if isinstance(changed, As) and isinstance(claim.says, Basic):
        return replace(claim, says=changed.args[0], means=changed)
    meant = isinstance(claim.says, str) or claim.means is not None
    return replace(claim, means=changed) if meant else replace(claim, says=changed)


def _conditions(given: Iterable[Basic]) -> Iterator[Basic]:
    """Yield the single conditions: conjunctions are split, and ``True`` is dropped."""
    for condition in given:
        if isinstance(condition, And):
            yield from _conditions(condition.args)
        elif condition is not true:
            yield condition


def _kind(says: Basic | str, proof: Evidence) -> str:
    """Return the kind of a claim: determined by its evidence if possible, else by its form."""
    if isinstance(says, str | Statement):
        return getattr(proof, "kind", "statement")
    inequalities = all(isinstance(part, Ge | Gt | Le | Lt) for part in parts_of(says))
    return getattr(proof, "kind", "bound" if inequalities else "identity")


def _expected(proof: Evidence) -> Ruling:
    """Return the usual verdict for this type of evidence; ENCLOSED if it uses an ENCLOSED claim."""
    by_type: Ruling = getattr(proof, "expect", Verdict.PROVED)
    enclosed = any(claim.expect is Verdict.ENCLOSED for claim in _named(proof))
    return Verdict.ENCLOSED if by_type is Verdict.PROVED and enclosed else by_type


def expressions(claim: Claim) -> Iterator[Basic]:
    """Yield all expressions of the claim and its evidence: statement, conditions and steps."""
    proof = claim.proof
    yield from (e for e in (claim.says, claim.means) if isinstance(e, Basic))
    yield from claim.given
    yield from claim.knowing
    if isinstance(proof, ImplicitFunction):
        yield from (proof.unknown, proof.parameter, proof.at)
    if isinstance(proof, Instance):
        yield from (e for pair in proof.values for e in pair if isinstance(e, Basic))
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


def asked_by(claim: Claim) -> dict[str, tuple[Basic, ...]]:
    """Return the conditions of the claims that are conjoined or substituted, by label."""
    conjoined = isinstance(claim.proof, AllOf)
    asked: dict[str, tuple[Basic, ...]] = {}
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
