"""Evidence that the engine decides the claim's own formula (`tresym.checking`).

Example: the claim ``4bε² − b sin²(2ε) > 7bε⁴/2`` for 0 < ε ≤ 3/4 needs no hand-written argument:
the dispatcher divides by b > 0 and expands at ε = 0. A claim about a symbol that is defined
elsewhere names the claims whose equations are put in for it, and the bounds that may be used; what
is handed over is then a statement about variables, for all of their values. If other variables suit
the statement better, they are named with their meaning (:class:`InVariables`).

What is checked here, before and after the engine is asked:

- A definition is unfolded only where the conditions of its claim are shown.
- Both sides are shown to be defined, since the engine decides a statement where they are.
- An order holds uniformly in all other symbols, and a defined symbol, which may change with the
  variable of the limit, must be unfolded in it.
- A statement about a symbol that is defined and was not unfolded is one for all values of that
  symbol. It may be proved, but a point that contradicts it refutes nothing. The same holds where
  equations are put in that are no definitions, since they may relate variables to one another.
- The constant that the evidence names stands in the statement; that of an order is not smaller than
  the constant that the engine found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

from flint import fmpq

from tresym.checking.compound_claims import decide_compound
from tresym.checking.dispatch import decide_claim
from tresym.ledger.claim import Chain, Claim, Definition, Reason, Step
from tresym.ledger.conversion import (
    Conditions,
    Rules,
    conditions,
    defined,
    known,
    put_in,
    put_into,
)
from tresym.ledger.evidence.asymptotics import solved_for_order
from tresym.ledger.evidence.box_bounds import decimal
from tresym.ledger.evidence.integrals import (
    RULES,
    NotShownError,
    holds_integral,
    need,
    need_integrals,
    sign_of_integral,
    with_bounds,
    without_integrals,
)
from tresym.ledger.evidence.premises import instantiated
from tresym.ledger.evidence.sign_prover import is_manifest, undefined
from tresym.ledger.evidence.whole_statements import bound_by, whole_claim
from tresym.ledger.finding import WEAKEST_FIRST, Finding, Ruling, StepFinding
from tresym.ledger.formulas import (
    EqualMatrices,
    Says,
    Tending,
    in_order,
    in_trees,
    names_of,
    parts_of,
    relations_of,
)
from tresym.ledger.reasons import citing
from tresym.ledger.refutations import need_possible
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import stated
from tresym.reals.decisions.cleared_factors import with_split_roots
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import generalised, outermost, worked_out
from tresym.reals.language.claims import Written
from tresym.reals.language.compound import Equivalent, comparisons_of, leaves
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    instantiate,
    multiply,
    number,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, Relation
from tresym.reals.language.like_terms import collected
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

ORDERINGS = ("<", "<=", ">", ">=")


@dataclass(frozen=True)
class InVariables:
    """Other variables for a statement.

    Every point of the claim must be a value of the new variables: each old variable is the stated
    function of them if they have the stated values.

    Attributes:
        values: each new variable as a function of the claim's symbols.
        old: each replaced symbol as a function of the new variables and of symbols that stay.
        where: conditions on the new variables; their values are shown to satisfy them.

    Example:
        ``InVariables({r: sqrt(b/a)}, {a: b/r**2}, (r > 0,))``
    """

    values: Mapping[Any, Any]
    old: Mapping[Any, Any]
    where: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Decided:
    """Evidence that the engine decides the statement, with definitions unfolded.

    Attributes:
        put: claims whose equations are substituted, where their conditions hold.
        cited: claims whose bounds become conditions.
        variables: other variables for the statement, or None.
        constant: the constant of a bound, whose larger side is ``constant`` times ``gauge``; of an
            order, an upper bound for the constant that the engine finds; or None.
        gauge: the gauge of a bound.
        remainder: a `Remainder`: how the order printed in the paper is interpreted; or None.
        also: further claims behind the symbols of the statement.
        steps: for each part of the statement, all of them equations, the chain that leads from its
            left to its right side. Each step is decided, with the equations put in that it names;
            all of them if it names none. A step may name rules for integrals, which replace
            integrals first.
    """

    put: tuple[Claim, ...] = ()
    cited: tuple[Claim, ...] = ()
    variables: InVariables | None = None
    constant: fmpq | None = None
    gauge: Any = ONE
    remainder: Any = None
    also: tuple[Claim, ...] = field(default=())
    steps: tuple[Chain, ...] = ()
    expect: ClassVar[Ruling] = Verdict.ENCLOSED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """The claims that the evidence uses."""
        return (*self.put, *self.cited, *self.also)

    @property
    def restricts_nothing(self) -> bool:
        """Whether what is used leaves the variables free, so that a point refutes the statement.

        Definitions do. Other equations may relate variables to one another: from u = 2x and u = 3y
        follows 2x = 3y, which fails at most points.
        """
        defined = (isinstance(c.proof, Definition) and not c.proof.assumes for c in self.put)
        return not self.cited and all(defined)

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The derivation that is printed: the steps, with the claims whose equations are put in."""
        if self.steps or not self.put:
            return self.steps
        return ((Step(None, (Reason("substituting", claims=self.put),)),),)


def judge_decided(claim: Claim, proof: Decided) -> Finding:
    """Return what the engine finds on the statement.

    Raises:
        NotShownError: the statement is of another kind, or what it needs besides could not be
            shown.
    """
    says: Any = claim.statement
    need(says is not None, "the claim states no formula")
    need_possible(claim)
    given = with_bounds(conditions(claim.given), (citing(*proof.cited),))
    rules, meant = instantiated(proof.put, given)
    here = put_into(given, rules)
    if isinstance(says, Tending):
        return _order(claim, proof, says, rules, here)
    if proof.steps:
        by_steps = _by_steps(claim, proof, says, given)
        whole = None if by_steps.verdict.holds else judge_decided(claim, replace(proof, steps=()))
        return whole if whole is not None and whole.verdict is Verdict.REFUTED else by_steps
    if not all(isinstance(part, Relation | EqualMatrices) for part in parts_of(says)):
        return _whole(claim, proof, says, rules, meant)
    relations = list(_relations(says, rules, meant))
    need(bool(relations), "the statement contains no relation")
    if proof.constant is not None:
        size = in_order(number(proof.constant) * in_trees(proof.gauge))
        sides = (side for part in relations for side in (part.left, part.right))
        need(size in map(in_order, sides), f"the statement contains no bound {size}")
    if proof.variables is not None:
        relations, here = _in_variables(relations, proof.variables, given, here)
    asked: tuple[Compared, ...] = tuple((c.left, c.sign, c.right) for c in here)
    answers = [_decided(r, asked, meant, proof.variables is None) for r in relations]
    free = not (_names(relations) & _open_symbols(claim, rules)) and proof.variables is None
    constant = None if proof.constant is None else decimal(proof.constant)
    found = _found(answers, free and proof.restricts_nothing)
    return _with_region(replace(found, constant=constant), claim) if found.verdict.holds else found


def _whole(claim: Claim, proof: Decided, says: Says, rules: Rules, given: Conditions) -> Finding:
    """Return what the engine finds on a statement that is not made of relations alone.

    Raises:
        NotShownError: the engine decides no such statement.
    """
    plain = proof.variables is None and proof.constant is None and not proof.steps
    need(plain, "such a statement has no other variables, no constant and no steps")
    whole = whole_claim(says, lambda e: put_in(e, rules), given)
    parts = list(leaves(whole.formula))
    links = [link for part in parts for link in (*comparisons_of(part), *part.given)]
    names = frozenset().union(*(symbols(side) for link in links for side in link[::2]))
    open_ = sorted(names & _open_symbols(claim, rules))
    bound = {name for part in parts for name in bound_by(part)} & defined(claim)
    need(not bound, f"{', '.join(sorted(bound))} is defined, so it is no variable of a statement")
    moving = any(not isinstance(part, Written) for part in parts)
    need(
        not (open_ and moving),
        f"{', '.join(open_)} is defined elsewhere, and its definition is not put in",
    )
    return _found([decide_compound(whole, decide_claim)], not open_ and proof.restricts_nothing)


def _by_steps(claim: Claim, proof: Decided, says: Says, given: Conditions) -> Finding:
    """Return the finding on a derivation; a step that is false refutes nothing.

    Raises:
        NotShownError: there is not one chain for each part, or the condition of an equation that is
            put in is not shown.
    """
    parts = parts_of(says)
    answers = []
    need(len(parts) == len(proof.steps), "there must be one chain for each part of the statement")
    for part, chain in zip(parts, proof.steps, strict=True):
        alike = isinstance(part, Equivalent) and len(part.parts) == 2
        need(isinstance(part, Relation) or alike, "only a relation is derived by steps")
        left, last = part.parts if alike else (part.left, part.right)
        if alike and chain[-1].expression == left:  # SymPy has an order of its own
            left, last = last, left
        for link in chain:
            right = last if link.expression is None else link.expression
            named = tuple(c for r in link.reasons for c in r.claims if c in proof.put)
            rules, meant = instantiated(named if link.reasons else proof.put, given)
            asked = tuple((c.left, c.sign, c.right) for c in put_into(given, rules))
            if alike:
                answers.append(_equivalent(left, right, rules, meant))
                left = right
                continue
            need(isinstance(right, Expr), "the steps of a relation pass from one number to another")
            sign = part.sign if link is chain[-1] else "=="
            for r in _relations(Relation(left, sign, right), rules, meant):
                ruled = any(reason.name in RULES for reason in link.reasons)
                if ruled:
                    sides = without_integrals(r.left, r.right, link.reasons, meant)
                    r = Relation(sides[0], r.sign, sides[1])
                answers.append(_decided(r, asked, meant, True, ruled))
            left = right
        need(left == last, "a chain must end at the right side of the equation")
    return _with_region(_found(answers, False), claim)


def _with_region(found: Finding, claim: Claim) -> Finding:
    """The finding with the conditions as the region on which balls enclosed the statement."""
    if found.verdict is not Verdict.ENCLOSED:
        return found
    return replace(found, region=", ".join(map(str, claim.given)) or None)


def _equivalent(first: Says, second: Says, rules: Rules, given: Conditions) -> Answer:
    """Return what the engine finds on two equations that are said to be equivalent."""
    both = Equivalent((first, second))
    return decide_compound(whole_claim(both, lambda e: put_in(e, rules), given), decide_claim)


def _decided(
    relation: Relation,
    asked: tuple[Compared, ...],
    given: Conditions,
    defined_there: bool,
    integrals_exist: bool = False,
) -> Answer:
    """Return the answer of the engine, which is asked for normal forms and signs first.

    Args:
        relation: the statement; its sides are shown to be defined if ``defined_there``.
        asked: the conditions, with definitions put in.
        given: all that is known, as conditions.
        defined_there: whether normal forms may be compared.
        integrals_exist: whether the integrals in it are shown to exist already.
    """
    left, right = relation.left, relation.right
    worked = Relation(worked_out(left), relation.sign, worked_out(right))
    exist = defined_there and relation.sign == "=="
    if exist and _binders_exist((left, right), given, integrals_exist):
        one, other = generalised(worked.left, worked.right)
        found = decide_continuous(one, other, known(given))
        if found.verdict is Verdict.PROVED:
            return Answer(found.verdict, found.why, str(relation))
    if defined_there and relation.sign in ORDERINGS:
        if is_manifest(worked, given) and _integrals_exist((left, right), given, integrals_exist):
            why = "the sign of the difference follows from those of its parts"
            return Answer(Verdict.PROVED, why, str(relation))
        if _by_integrands(relation, given):
            why = "the signs of the integrands show that of the difference"
            return Answer(Verdict.PROVED, why, str(relation))
    return decide_claim(stated(((left, relation.sign, right),), asked))


def _by_integrands(relation: Relation, given: Conditions) -> bool:
    """Return whether an inequality follows from signs of integrals, which their integrands show.

    An integral of which a condition speaks exists.
    """
    up = relation.upward
    difference = collected(up.left - up.right)
    nodes = dict.fromkeys(outermost(difference))
    if not nodes or any(node.op != "integral" for node in nodes):
        return False
    stated_ = dict.fromkeys(node for c in given for node in outermost(c.left, c.right))
    numbers = {node: symbol(f"[{n}]") for n, node in enumerate({**nodes, **stated_})}
    shown = []
    for node in nodes:
        try:
            need_integrals(() if node in stated_ else (node,), given)
            sign = sign_of_integral(node, (), given, up.sign == ">")
        except NotShownError:
            if node not in stated_:
                return False
            continue
        if sign is not None:
            shown.append(Relation(numbers[node], ">" if sign == "+" else ">=", ZERO))
    # The conditions may speak of the same integrals, so they are renamed alike.
    renamed = [
        Relation(replaced(c.left, numbers), c.sign, replaced(c.right, numbers)) for c in given
    ]
    return is_manifest(Relation(replaced(difference, numbers), up.sign, ZERO), (*renamed, *shown))


def _binders_exist(sides: tuple[Expr, ...], given: Conditions, integrals_exist: bool) -> bool:
    """Return whether each integral and derivative is shown to exist."""
    nodes = list(outermost(*sides))
    if not _integrals_exist(nodes, given, integrals_exist):
        return False
    return all(_differentiable(node, given) for node in nodes)


def _integrals_exist(sides: Iterable[Expr], given: Conditions, integrals_exist: bool) -> bool:
    """Return whether each integral is shown to exist."""
    try:
        need_integrals(() if integrals_exist else sides, given)
    except NotShownError:
        return False
    return True


def _differentiable(e: Expr, given: Conditions) -> bool:
    """Return whether each derivative that holds no integral is shown to exist."""
    return _derivatives_exist(
        tuple(node for node in outermost(e) if not holds_integral(node)), given
    )


def _derivatives_exist(sides: tuple[Expr, ...], given: Conditions) -> bool:
    """Return whether each differentiated function is shown to be defined where it is."""
    for node in outermost(*sides):
        if node.op != "derivative":
            inner = instantiate(node.args[0], node.args[1:]) if node.op == "at" else None
            if inner is None or not _derivatives_exist((inner, *node.args[1:]), given):
                return False
            continue
        body = instantiate(node.args[0], (node.args[1],))
        if undefined(worked_out(body), given) is not None:
            return False
        if not _derivatives_exist((body, node.args[1]), given):
            return False
    return True


def _found(answers: list[Answer], refutes: bool) -> Finding:
    """Return the finding on the parts of a statement: that of the weakest one."""
    steps = tuple(
        StepFinding(_VERDICTS.get(step.verdict, Verdict.UNDECIDED), str(step))
        for answer in answers
        for step in answer.obligations
    )
    worst = min(answers, key=lambda answer: WEAKEST_FIRST.index(answer.verdict))
    why = "; ".join(dict.fromkeys(filter(None, (_why(answer) for answer in answers))))
    if worst.verdict is Verdict.REFUTED and not refutes:
        why = (
            "as a statement about all values of its symbols, which the definitions restrict, it is "
            f"false: {worst.why}"
        )
        return Finding(Verdict.UNDECIDED, why)
    if not worst:
        return Finding(worst.verdict, worst.why, witness=_witness(worst), steps=steps)
    return Finding(worst.verdict, why, steps=steps)


_VERDICTS = {verdict.value: verdict for verdict in Verdict}


def _why(answer: Answer) -> str:
    return f"{answer.why}, by {answer.lemma}" if answer.lemma else answer.why


def _witness(answer: Answer) -> dict[str, fmpq] | None:
    """Return a witness of rational numbers, or None."""
    try:
        return {name: parse_number(text) for name, text in (answer.witness or {}).items()} or None
    except ValueError:
        return None


def _relations(says: Says, rules: Rules, given: Conditions) -> Iterator[Relation]:
    """Yield the relations of a statement with the rules put in; both sides are shown to be defined.

    It is enough that a side is as it is written: what is put in has the value of what it is put in
    for.

    Raises:
        NotShownError: a part is no relation, or a side is not shown to be defined.
    """
    for part in parts_of(says):
        if not isinstance(part, Relation | EqualMatrices):
            raise NotShownError(f"{part} is not a relation between numbers")
        for relation in relations_of(part):
            left, right = (put_in(side, rules) for side in (relation.left, relation.right))
            for side, written in ((left, relation.left), (right, relation.right)):
                gap = undefined(worked_out(side), given)
                if gap is not None and side != written:
                    gap = undefined(worked_out(written), given)
                need(gap is None, f"could not show that {gap} lies in the domain of its operation")
                exists = _differentiable(side, given) or _differentiable(written, given)
                need(exists, f"could not show that the derivatives in {written} exist")
            yield Relation(left, relation.sign, right)


def _names(relations: list[Relation]) -> frozenset[str]:
    return frozenset().union(*(symbols(r.left) | symbols(r.right) for r in relations))


def _open_symbols(claim: Claim, rules: Rules) -> frozenset[str]:
    """Return the defined symbols for which nothing is put in."""
    put = {str(left.args[0]) for left in rules if left.op == "symbol"}
    return defined(claim) - put


def _in_variables(
    relations: list[Relation], new: InVariables, given: Conditions, here: Conditions
) -> tuple[list[Relation], Conditions]:
    """Return statement and conditions in other variables.

    Raises:
        NotShownError: the new variables occur already, an old one is not the stated function of
            them, or their values do not satisfy the conditions on them.
    """
    values = {str(name): in_trees(e) for name, e in new.values.items()}
    old = {str(name): in_trees(e) for name, e in new.old.items()}
    taken = _names(relations).union(*(symbols(c.left) | symbols(c.right) for c in (*given, *here)))
    need(not taken & {*values}, "a new variable occurs in the statement or its conditions")
    for name, e in old.items():
        need(not symbols(e) & {*old}, f"{name} is not expressed by the new variables")
        back = substitute(e, values)
        gap = undefined(back, given)
        same = gap is None and decide_continuous(back, symbol(name), known(given))
        shown = bool(same) and same.verdict is Verdict.PROVED  # type: ignore[union-attr]
        need(shown, f"could not show that {name} is {e}")
    kept: Conditions = conditions(new.where)
    for condition in kept:
        there = Relation(
            substitute(condition.left, values), condition.sign, substitute(condition.right, values)
        )
        need(is_manifest(there, given), f"could not show {there}")
    for condition in sorted(
        here, key=lambda c: bool((symbols(c.left) | symbols(c.right)) & {*old})
    ):
        moved = _moved(condition, old, kept)
        if not is_manifest(moved, kept):
            kept = (*kept, moved)
    return [_moved(relation, old, kept) for relation in relations], kept


def _moved(relation: Relation, old: Mapping[str, Expr], given: Conditions) -> Relation:
    """Return a relation, which is known to be defined, in other variables."""
    near = known(given)
    sides = (substitute(side, old) for side in (relation.left, relation.right))
    left, right = (with_split_roots(_reduced(side), near) for side in sides)
    return Relation(left, relation.sign, right)


def _reduced(e: Expr) -> Expr:
    """Return ``e`` with the rational functions of variables in it in lowest terms."""
    if e.op in LEAVES or e.names:
        return e
    if _is_rational(e):
        return in_lowest_terms(e)
    if e.op == "*":
        plain = in_lowest_terms(multiply(*filter(_is_rational, e.args)))
        return multiply(plain, *(_reduced(arg) for arg in e.args if not _is_rational(arg)))
    return rebuild(e, tuple(map(_reduced, e.args)))


def _is_rational(e: Expr) -> bool:
    """Return whether ``e`` is made of numbers and symbols by the operations of arithmetic."""
    if e.op in ("number", "symbol"):
        return True
    if e.op == "^":
        return _is_rational(e.args[0]) and e.args[1].op == "number" and e.args[1].args[0].q == 1
    return e.op in ("+", "*") and all(map(_is_rational, e.args))


def _order(claim: Claim, proof: Decided, says: Tending, rules: Rules, given: Conditions) -> Finding:
    """Return what the engine finds on an order along a path.

    Raises:
        NotShownError: the statement is not an order, or a symbol in it is not unfolded.
    """
    order = solved_for_order(says.relation)
    need(order is not None, "the statement must be an equation with one order")
    need(proof.variables is None, "an order is decided in its own variables")
    assert order is not None
    difference, gauge = (put_in(e, rules) for e in (order.left, order.right))
    path = says.path
    tending = names_of(path)
    names = symbols(difference) | symbols(gauge)
    open_ = sorted((names | tending) & _open_symbols(claim, rules))
    need(not open_, f"{', '.join(open_)} is defined elsewhere, and its definition is not put in")
    parameters = bool(names - tending)
    kind = order.relation
    need(kind == "O" or not parameters, "an order o(…) with parameters is not shown uniform")
    asked: tuple[Compared, ...] = tuple((c.left, c.sign, c.right) for c in given)
    uniformly = parameters and path.expression is None and not path.together
    link = (difference, "==", Expr(kind, (gauge,)))
    answer = decide_claim(stated((link,), asked, path, uniformly))
    found = replace(_found([answer], proof.restricts_nothing), parameter=str(path))
    if not found.verdict.holds:
        return found
    if proof.constant is not None:
        found_constant = answer.constant
        largest = found_constant and sum(map(parse_number, found_constant), fmpq(0))
        need(
            largest is not None and largest <= proof.constant,
            f"the engine's constant is not at most {proof.constant}",
        )
    constant = answer.constant
    return replace(found, constant=constant, region=answer.region if constant else None)
