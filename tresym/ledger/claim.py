"""Claims: frozen values with a statement, conditions, and the evidence for it.

Nothing here decides anything. `tresym.ledger.judge` turns a claim into a finding, reports turn
it into LaTeX and ledger rows, and what a claim rests on is read off its evidence, so the graph
of dependencies cannot drift from the proofs.

A proof by a chain is a tuple of steps. Each step writes out the next expression and the reasons
why it equals the one before; the first step starts at the left side of what the claim says and
the last must arrive at its right side. A step may use only the reasons it names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from typing import Any, ClassVar

from flint import fmpq
from sympy import And, Basic, Derivative, Eq, Expr, Ge, Gt, Le, Lt, Subs, Symbol, Tuple, true

from tresym.ledger.axioms import Axiom
from tresym.ledger.finding import WEAKEST_FIRST, Premise, Ruling
from tresym.ledger.statements import As, ExactlyOne, Statement, together_under
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


def equal(left: Basic, right: Basic) -> Eq:
    """The equation ``left = right``, as a statement: SymPy must not evaluate it."""
    return Eq(left, right, evaluate=False)


def parts_of(says: Basic | str) -> tuple[Basic, ...]:
    """The relations a statement consists of."""
    return says.args if isinstance(says, Tuple) else (says,)


def equations(left: tuple[Basic, ...], right: tuple[Basic, ...]) -> Tuple:
    """A system of equations, side by side."""
    return Tuple(*(equal(p, q) for p, q in zip(left, right, strict=True)))


def at(e: Expr, values: Mapping[Symbol, Any]) -> Subs:
    """``e`` at these values of its symbols, written and not yet worked out.

    SymPy would work it out by itself, and leave nothing to decide.

    Raises:
        ValueError: a derivative at one value of several symbols. SymPy takes the symbols for one
            there, and two derivatives for equal that are not.
    """
    if e.has(Derivative) and len(set(values.values())) < len(values):
        raise ValueError("a derivative at equal values: put them in one after the other")
    return Subs(e, tuple(values), tuple(values.values()))


@dataclass(frozen=True)
class Place:
    """Where the paper says it: number of the display (1…58), line of the source, table cell."""

    display: int | None = None
    line: int | None = None
    cell: str | None = None


def display(number: int) -> Place:
    """A display of the paper, by its number."""
    return Place(display=number)


def line(number: int) -> Place:
    """A line of the paper's source."""
    return Place(line=number)


@dataclass(frozen=True)
class Reason:
    """Why one expression equals the next: theories that may be used, and claims it rests on."""

    name: str
    theories: frozenset[str] = frozenset()
    claims: tuple[Claim, ...] = ()
    function: str | None = None
    """For ``applying``: the one-to-one function applied to both sides of an equation."""
    expression: Expr | None = None
    """For ``changing_variable`` the new variable, for ``integrating`` the antiderivative, for
    ``cutting`` the point, for ``differentiating_integral`` the derivative of the integrand."""
    factor: Expr | None = None
    """For ``multiplying``: the non-zero factor of both sides of an equation."""
    term: Expr | None = None
    """For ``adding``: what is added to both sides of an equation."""


@dataclass(frozen=True)
class Step:
    """The next expression (or equation) of a chain, and the reasons that lead to it."""

    expression: Basic | None
    """None stands for the right side of what the claim says."""
    reasons: tuple[Reason, ...]


def step(expression: Basic, *reasons: Reason) -> Step:
    """The next link of a chain: ``expression``, because of ``reasons``."""
    return Step(expression, reasons)


def by(*reasons: Reason) -> tuple[Step, ...]:
    """A chain of one step, straight to the right side of what the claim says, or to its sign.

    Of a system it shows each part.
    """
    return (Step(None, reasons),)


manifest = by()
"""An inequality, or each of several, that the prover of signs decides as it stands."""

Chain = tuple[Step, ...]


@dataclass(frozen=True)
class Definition:
    """The claim introduces symbols: each is new, defined once, by symbols known before.

    ``assumes`` names what is put in: an equation for symbols that are defined elsewhere, or for one
    under an integral.
    """

    assumes: str = ""
    kind: ClassVar[str] = "definition"

    @property
    def expect(self) -> Premise:
        """What the claim is: a definition, or assumed."""
        return Premise.ASSUMED if self.assumes else Premise.DEFINED


@dataclass(frozen=True)
class Root:
    """The claim introduces ``symbol`` for the one root that ``unique`` shows there to be.

    It says that the function vanishes there, what is subtracted in it on the right side, and
    between which ends the root lies.
    """

    symbol: Symbol
    unique: Claim
    kind: ClassVar[str] = "definition"
    expect: ClassVar[Ruling] = Premise.DEFINED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What the definition rests on: that there is one root."""
        return (self.unique,)

    @property
    def says(self) -> Tuple:
        """The equation for the root, and the interval that it lies in."""
        root, x = self.unique.statement, self.symbol
        assert isinstance(root, ExactlyOne)
        sides = (side.xreplace({root.variable: x}) for side in root.args[3].args)
        return Tuple(
            equal(*sides), Gt(x, root.low, evaluate=False), Lt(x, root.high, evaluate=False)
        )


@dataclass(frozen=True)
class Together:
    """One chain for each part of a statement that has several."""

    chains: tuple[Chain, ...]


def together(*chains: Chain) -> Together:
    """Chains for the parts of a system of equations or inequalities, in order."""
    return Together(chains)


@dataclass(frozen=True)
class UniqueRoot:
    """An equation has exactly one root between two ends, where its sides differ in sign.

    The statement is an `ExactlyOne`; the difference of the sides of its equation is continuous and
    monotone.
    """

    derivative: Chain
    """A chain from the derivative of the difference to a form whose sign is manifest."""
    at_low: Chain
    at_high: Chain
    """Chains from the values at the ends to forms whose signs are manifest."""


@dataclass(frozen=True)
class Monotone:
    """The statement is that an equation has one root at most: left side less right side rises."""

    slope: Chain
    """A chain from the derivative of the difference to a form that is manifestly positive."""


@dataclass(frozen=True)
class ImplicitFunction:
    """The claim says what the slope of a function is that an earlier equation defines implicitly.

    ``equation`` relates ``unknown`` and ``parameter``, and its right side does not depend on them.
    Where the left side L is smooth and its derivative by the unknown is not zero, the implicit
    function theorem gives the unknown as a smooth function of the parameter, all else held; its
    slope at parameter = ``at`` is a new symbol, −L_parameter/L_unknown there.
    """

    equation: Claim
    unknown: Symbol
    parameter: Symbol
    at: Expr
    slope: Chain
    """A chain from the derivative by the unknown, at ``at``, to a form whose sign is manifest."""


@dataclass(frozen=True)
class Printed:
    """The statement is a number as the paper prints it, under its inputs as they are printed.

    It is a `Rounds`; so are the conditions on the inputs, or equations for what is exact. The
    claims say what the other symbols are, and which roots are one.
    """

    claims: tuple[Claim, ...] = ()
    kind: ClassVar[str] = "number"
    expect: ClassVar[Ruling] = Verdict.ENCLOSED


@dataclass(frozen=True)
class AllOf:
    """The statement is the conjunction of formal claims."""

    claims: tuple[Claim, ...]

    @property
    def expect(self) -> Ruling:
        """As strong as the weakest part."""
        return min((c.expect for c in self.claims), key=WEAKEST_FIRST.index, default=Verdict.PROVED)


def all_of(*claims: Claim) -> AllOf:
    """Evidence for a sentence that says what several formal claims say together."""
    return AllOf(claims)


@dataclass(frozen=True)
class Formally:
    """The relations of the statement, decided as they stand, by normal form and by proven signs.

    ``claims`` are put in. A false relation falls to an exact point at which a ball violates it.
    """

    claims: tuple[Claim, ...] = ()


def formally(*using: Claim) -> Formally:
    """Evidence without a chain, with earlier equations put in."""
    return Formally(using)


@dataclass(frozen=True)
class Counterexample:
    """An exact point under every condition of the claim at which the statement does not hold.

    ``claims`` define the symbols that have no value at the point itself.
    """

    point: Mapping[str, fmpq]
    claims: tuple[Claim, ...] = ()
    expect: ClassVar[Ruling] = Verdict.REFUTED


@dataclass(frozen=True)
class Instance:
    """What ``claim`` says with these values for its variables, where its conditions hold of them.

    ``cited`` are claims whose bounds show that.
    """

    claim: Claim
    values: tuple[tuple[Symbol, Expr], ...]
    cited: tuple[Claim, ...] = ()

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What is used."""
        return (self.claim, *self.cited)

    def put(self, relation: Basic) -> Basic:
        """A relation with the values put in, not worked out."""
        sides = (side.xreplace(dict(self.values)) for side in relation.args)
        return relation.func(*sides, evaluate=False)

    @property
    def says(self) -> Basic:
        """The instance, part by part."""
        general = self.claim.says
        if not isinstance(general, Basic):
            raise InputError(f"{self.claim.label} is said in words: it has no instance")
        parts = tuple(map(self.put, parts_of(general)))
        return Tuple(*parts) if isinstance(general, Tuple) else parts[0]


Evidence = (
    Chain
    | Definition
    | Root
    | Instance
    | Together
    | UniqueRoot
    | Monotone
    | ImplicitFunction
    | Printed
    | AllOf
    | Formally
    | Counterexample
    | Any
)


class Fault(Enum):
    """What is wrong with a statement of the paper that is refuted."""

    THEOREM = "the remainder of the theorem, wherever it is printed"
    STATEMENT = "what is said does not hold for everything it is said of"
    REASON = "the conclusion holds; the reason given for it does not"
    ROUNDING = "near the truth, and not as near as it is printed"
    MISPRINT = "what is meant is plain from the context"


@dataclass(frozen=True)
class Claim:
    """One statement: what it says, under which conditions, and the evidence for it.

    Attributes:
        label: the paper's own ``\\label``, or a name of ours; see :func:`label_claims`.
        says: a SymPy relation, a `Tuple` of them, an `Equivalent`, or prose.
        means: for prose, and for a formula that leaves an order open, the formula that is decided.
        given: SymPy relations that hold wherever the claim is made.
        proof: the evidence; its type decides how the claim is judged.
        where: the place in the paper; None for a lemma of ours.
        expect: the verdict this claim must get, where it is not the one for which evidence of its
            type is given; of a definition, what its evidence says.
        amended_by: for a claim expected REFUTED, the claims that are true instead.
        note: one or two sentences for the reader.
        kind: identity, number, bound, order, limit, statement or definition, where the evidence
            and the form of what is said do not tell.
        shown: LaTeX for reports, where the statement written out would hide what it says.
        paper_says: what the paper prints, with all its hedges, in our words, and how that is read;
            where ``says`` is a sharper reading, which is ours.
        fault: for a claim expected REFUTED, what is wrong with the paper there.
        quotes: theorems that the evidence applies and no claim shows.
        knowing: local facts, each shown by the prover of signs under the conditions of the claim
            and by those before it; ``Under(φ, (condition, …))`` is one of what is bound.

    Example:
        >>> import tresym
        >>> tresym.verify("eq_gamma")["eq_gamma"].claim.kind
        'identity'
    """

    label: str = ""
    says: Basic | str = ""
    proof: Evidence = ()
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

    def __post_init__(self) -> None:
        object.__setattr__(self, "given", tuple(_conditions(self.given)))
        defined = isinstance(self.proof, Definition | Root)
        if defined or not self.kind:
            object.__setattr__(self, "kind", _kind(self.says, self.proof))
        if defined or self.expect is None:
            object.__setattr__(self, "expect", _expected(self.proof))

    def __hash__(self) -> int:
        if not self.label:
            raise ValueError("a claim without a label: the last line of its part gives it one")
        return hash(self.label)

    def __repr__(self) -> str:
        return in_one_line(f"Claim({self.label}: {self.says})")

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        given = ", ".join(map(str, self.given))
        rows = [("says", str(self.says)), ("given", given), ("expected", self.expect.value)]
        return html_table(self.label, [row for row in rows if row[1]])

    def _repr_latex_(self) -> str:
        """The formula that is decided; of prose alone, the prose."""
        from sympy import latex

        if self.statement is None:
            return f"$\\text{{{self.says}}}$"
        return f"${latex(self.statement)}$"

    @cached_property
    def statement(self) -> Basic | None:
        """The formula that is decided, for all values of its free symbols under ``given``.

        A conjunction means what its parts mean, each under its own conditions. None where words
        are all there is.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.statement
            Eq(gamma, a - (a + b*sin(psi)**2)*sin(theta)**2)
        """
        if self.means is not None:
            return self.means
        if isinstance(self.says, Basic):
            return self.says
        if not isinstance(self.proof, AllOf):
            return None
        parts = [(part.statement, part.given) for part in self.proof.claims]
        known = [(says, given) for says, given in parts if says is not None]
        return together_under(known) if len(known) == len(parts) else None

    @property
    def decided(self) -> Basic | str:
        """What others may put in or cite: the formula that is decided, never an order left open.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.decided
            Eq(gamma, a - (a + b*sin(psi)**2)*sin(theta)**2)
        """
        return self.says if self.means is None else self.means

    @property
    def in_formulas(self) -> bool:
        """Whether what others may put in or cite consists of relations.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.in_formulas
            True
        """
        return isinstance(self.decided, Basic) and not isinstance(self.decided, Statement)

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """All symbols that the claim and its evidence write down.

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
        """What the statement consists of; nothing where there is none.

        Example:
            >>> import tresym
            >>> len(tresym.verify("eq_Mi")["eq_Mi"].claim.parts)
            3
        """
        return () if self.statement is None else parts_of(self.statement)

    @cached_property
    def uses(self) -> tuple[Claim, ...]:
        """The claims that the evidence names, each once, in order.

        Example:
            >>> import tresym
            >>> [claim.label for claim in tresym.verify("eq_gamma")["eq_gamma"].claim.uses]
            ['d08', 'energy_of_momentum', 'eq_Mi']
        """
        return tuple(dict.fromkeys(_named(self.proof)))

    @cached_property
    def rests_on(self) -> tuple[Claim, ...]:
        """All that the claim rests on, directly or not, foundations first.

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
        """The theorems quoted by the claim or by anything that it rests on, each once.

        Example:
            >>> import tresym
            >>> tresym.verify("eq_gamma")["eq_gamma"].claim.axioms
            ()
        """
        quoted = (axiom for claim in (*self.rests_on, self) for axiom in claim.quotes)
        return tuple(dict.fromkeys(quoted))


def label_claims(names: Mapping[str, Any]) -> None:
    """Label each claim that has no label with its name among ``names``: the last line of a part."""
    for name, value in names.items():
        if isinstance(value, Claim) and not value.label:
            object.__setattr__(value, "label", name)


def saying(claim: Claim, changed: Basic) -> Claim:
    """The claim with another statement."""
    if isinstance(changed, As) and isinstance(claim.says, Basic):
        return replace(claim, says=changed.args[0], means=changed)
    meant = isinstance(claim.says, str) or claim.means is not None
    return replace(claim, means=changed) if meant else replace(claim, says=changed)


def _conditions(given: Iterable[Basic]) -> Iterator[Basic]:
    """Conditions one by one: SymPy's conjunctions are taken apart, and ``True`` is left out."""
    for condition in given:
        if isinstance(condition, And):
            yield from _conditions(condition.args)
        elif condition is not true:
            yield condition


def _kind(says: Basic | str, proof: Evidence) -> str:
    """What kind of claim it is: by its evidence, where that is for one kind, else by its form."""
    if isinstance(says, str | Statement):
        return getattr(proof, "kind", "statement")
    inequalities = all(isinstance(part, Ge | Gt | Le | Lt) for part in parts_of(says))
    return getattr(proof, "kind", "bound" if inequalities else "identity")


def _expected(proof: Evidence) -> Ruling:
    """The verdict that evidence of its type is given for; no more exact than what it rests on."""
    by_type: Ruling = getattr(proof, "expect", Verdict.PROVED)
    enclosed = any(claim.expect is Verdict.ENCLOSED for claim in _named(proof))
    return Verdict.ENCLOSED if by_type is Verdict.PROVED and enclosed else by_type


def expressions(claim: Claim) -> Iterator[Basic]:
    """Everything that the claim and its evidence write down: what is said, given, and each step."""
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


def chains_of(says: Basic, proof: Chain | Together) -> tuple[tuple[Basic, Chain], ...] | None:
    """What is said, part by part with its chain; None where the parts are not as many."""
    if isinstance(proof, Together):
        parts = parts_of(says)
        same = len(parts) == len(proof.chains)
        return tuple(zip(parts, proof.chains, strict=True)) if same else None
    alike = len(proof) == 1 and proof[0].expression is None
    return tuple((part, proof) for part in (parts_of(says) if alike else (says,)))


def _chains(proof: Evidence) -> tuple[Chain, ...]:
    """The chains that a piece of evidence consists of."""
    match proof:
        case Together(chains):
            return chains
        case UniqueRoot():
            return proof.derivative, proof.at_low, proof.at_high
        case ImplicitFunction() | Monotone():
            return (proof.slope,)
        case tuple():
            return (proof,)
        case _:
            return ()


def with_reasons(proof: Evidence, changed: Callable[[Reason], Reason], *more: Reason) -> Evidence:
    """The evidence with each reason of its chains changed, after ``more`` reasons in each step."""

    def chain(links: Chain) -> Chain:
        return tuple(Step(k.expression, (*more, *map(changed, k.reasons))) for k in links)

    match proof:
        case Together(chains):
            return Together(tuple(map(chain, chains)))
        case UniqueRoot():
            ends = chain(proof.at_low), chain(proof.at_high)
            return UniqueRoot(chain(proof.derivative), *ends)
        case ImplicitFunction() | Monotone():
            return replace(proof, slope=chain(proof.slope))
        case tuple():
            return chain(proof)
    return proof


def put_in_by(claim: Claim) -> tuple[Claim, ...]:
    """The claims that the evidence puts in: they hold here where all their conditions do."""
    if isinstance(claim.proof, Formally):
        return claim.uses
    reasons = (r for chain in _chains(claim.proof) for link in chain for r in link.reasons)
    return tuple(dict.fromkeys(c for r in reasons if r.name == "substituting" for c in r.claims))


def asked_by(claim: Claim) -> dict[str, tuple[Basic, ...]]:
    """By label, under which conditions what is said together, or is put in, holds."""
    conjoined = isinstance(claim.proof, AllOf)
    asked: dict[str, tuple[Basic, ...]] = {}
    for part in claim.uses if conjoined else put_in_by(claim):
        asked |= asked_by(part) if isinstance(part.proof, AllOf) and conjoined else {}
        asked |= {part.label: part.given} if part.given else {}
    return asked


def _named(proof: Evidence) -> Iterator[Claim]:
    """Every claim that a piece of evidence names."""
    if isinstance(proof, ImplicitFunction):
        yield proof.equation
    for chain in _chains(proof):
        for link in chain:
            for reason in link.reasons:
                yield from reason.claims
    if not isinstance(proof, tuple):
        yield from getattr(proof, "claims", ())
