"""Dispatch: decide every comparison of a statement by the method for its kind."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from tresym.checking.asked_for import as_asked
from tresym.checking.claim_cross_check import attack
from tresym.checking.variable_exponents import beyond_positive_bases, holds_powers
from tresym.reals.cross_check import STOPPED
from tresym.reals.decisions.answer import Answer, Decide, exact_text, refuted, worst
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.equalities import decide_equality
from tresym.reals.decisions.equations import (
    among_integers,
    decide_under_equations,
    decide_with_values,
    has_values,
)
from tresym.reals.decisions.exceptional_values import decide_with_jumps, refuted_at_jumps
from tresym.reals.decisions.identity import JUMP
from tresym.reals.decisions.rounding import of_residues, residues, without_rounding
from tresym.reals.decisions.statement import (
    Statement,
    functions,
    implied_integers,
    never_integers,
)
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.language.binders import is_infinite, outermost, total
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.compound import read_compound
from tresym.reals.language.differential_notation import without_prefix
from tresym.reals.language.expression import DOTS, ZERO, Expr, opened, replaced, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.normal.to_expression import with_closed_values
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import collecting_seldom, stage
from tresym.reals.signs.discontinuities import cases_at_jumps, jumps, zeros
from tresym.reals.verdict import Cause, Verdict

SELDOM = 20_000
"""New objects, a few megabytes of them, after which memory is searched for circles."""
LOOKED_AT = 40
"""Points of the conditions at which it is seen where a claim is defined."""
_LOOK_ALIKE = {
    "e": "not the number 2.718…, which is E",
    "Pi": "not the number pi",
    "PI": "not the number pi",
    "i": "not the imaginary unit; all variables are real",
    "j": "not the imaginary unit; all variables are real",
}


def decide_claim(claim: Any, given: Any = "", path: str | None = None) -> Answer:
    """Decide a claim, after reading it if necessary.

    Args:
        claim: text, LaTeX, a SymPy relation, or a :class:`Statement` that is read already.
        given: conditions, as for :func:`tresym.reals.decisions.claim_parsing.read`.
        path: the path of an order claim, such as ``"x -> 0+"``; None for other claims.

    Returns:
        The verdict with its reason. A chain has the weakest verdict of its comparisons.

    Raises:
        InputError: the claim cannot be read.
    """
    start = time.process_time()
    if (whole := read_compound(claim, given, path)) is not None:
        from tresym.checking.compound_claims import decide_compound

        return decide_compound(whole, decide_claim)
    with collecting_seldom(SELDOM):
        statement = claim if isinstance(claim, Statement) else read(claim, given, path)
        cases = residues(statement)
        if cases is not None:
            return _of_residues(statement, *cases)
        statement = without_rounding(statement)
        parts = [part for c in statement.comparisons for part in _asserted(c, statement)]
        answers = [_everywhere(comparison, statement) for comparison in parts]
    answer = worst(answers)
    if len(answers) > 1 and len(statement.comparisons) == 1:
        answer = _of_all_terms(answer, parts, answers)
    elif len(answers) > 1:
        broken = parts[answers.index(answer)]
        which = f"{broken.left} {broken.relation} {broken.right}: "
        answer = replace(answer, why=which + answer.why)
    if not answer:
        answer = replace(answer, why=answer.why + _mistaken(statement))
    if answer and (quoted := _quoted(statement, answer)):
        answer = replace(answer, why=f"{answer.why}; it quotes {quoted}")
    if answer and answer.region is None and statement.path is None:
        answer = replace(answer, region=_part_spoken_of(statement))
    answer = replace(
        answer,
        statement=_short(statement.text),
        given=_short(statement.under),
        read_as=statement.read_as,
        seconds=time.process_time() - start,
    )
    if answer.verdict is Verdict.REFUTED:
        from tresym.checking.euler_constant import with_euler_constant

        answer = with_euler_constant(answer, statement, decide_claim)
    return as_typed(answer) if statement.has_initial_values else answer


def _of_residues(statement: Statement, n: str, m: str, cases: list[Statement]) -> Answer:
    """Decide a statement with floors of fractions of an integer n, by the residues of n."""
    found = of_residues(n, m, list(map(decide_claim, cases)))
    return replace(
        found,
        statement=_short(statement.text),
        given=_short(statement.under),
        read_as=statement.read_as,
    )


def as_typed(answer: Answer) -> Answer:
    """Return the answer with the functions of differential equations named as they were typed."""
    return replace(
        answer,
        why=without_prefix(answer.why),
        given=without_prefix(answer.given),
        read_as=without_prefix(answer.read_as),
        region=answer.region and without_prefix(answer.region),
        witness=answer.witness and {without_prefix(n): v for n, v in answer.witness.items()},
    )


def _asserted(claim: Comparison, statement: Statement) -> list[Comparison]:
    """Return what a comparison asserts: ``f ~ a + b`` also ``f - a - b == o(a)`` and ``== o(b)``.

    An asymptotic expansion asserts every term (H. Poincaré; F. W. J. Olver, *Asymptotics and
    Special Functions*, 1974, section 1.7): its error is of smaller order than the last of them.
    So do ``f ~ c*(1 + b/a)`` and every other way to write the same terms.
    """
    path = statement.path
    if claim.relation != "~" or claim.right.hidden or path is None:
        return [claim]
    from tresym.asymptotics.lemma import asserted_terms

    found = asserted_terms(claim.right, path.name)
    if len(found) == 1:
        return [claim]
    error = claim.left - claim.right
    terms = [replace(claim, left=error, relation="o", right=term) for term in found]
    return [claim, *terms]


def _of_all_terms(answer: Answer, parts: list[Comparison], answers: list[Answer]) -> Answer:
    """Return the answer to an expansion, of which ``parts`` are the quotient and each term."""
    if answer:
        terms = ", ".join(str(part.right) for part in parts[1:])
        why = f"{answers[0].why}; the error is of smaller order than each of {terms}"
        return replace(answer, why=why, constant=None)
    broken = parts[answers.index(answer)]
    if broken.relation == "~":
        return answer
    why = f"the error, {broken.left}, is not shown to be o({broken.right}): {answer.why}"
    if answer.verdict is Verdict.REFUTED:
        why = f"the error, {broken.left}, is not o({broken.right}): {answer.why}"
    return replace(answer, why=why)


def _quoted(statement: Statement, answer: Answer) -> str:
    """Return the theorems on which expansions and signs of the special functions here rest."""
    if statement.path is None and answer.verdict is not Verdict.ENCLOSED:
        return ""
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    found = {
        theorem: None
        for node in operations(sides)
        if node.op in SPECIAL
        for theorem in TABLE[node.op].theorems
    }
    return "; ".join(sorted(found))


def _part_spoken_of(statement: Statement) -> str | None:
    """Return where both sides are defined, if that is not everywhere under the conditions."""
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    given = statement.given
    if not given.comparisons or any(e.hidden for e in (*sides, *statement.said)):
        return None
    names = sorted(frozenset().union(*map(symbols, sides)))
    missing: list[tuple[Expr, str]] = []
    with ball_precision():
        points = list(given.points(names, LOOKED_AT))
        for e, relation in needs(sides):
            values = (evaluate(e, point) for point in points) if symbols(e) else ()
            if any(value < 0 if relation != "!=" else value.is_zero() for value in values):
                missing.append((e, relation))
    links = (bound(*part) for part in missing)
    shown = ", ".join(sorted(f"{left} {relation} {right}" for left, relation, right in links))
    return f"where both sides are defined: {shown}" if missing else None


def _everywhere(comparison: Comparison, statement: Statement) -> Answer:
    statement = _with_integers(comparison, statement)
    trees = (comparison.left, comparison.right, *statement.said)
    if never := never_integers(trees, statement.integers):
        why = f"nothing is said: {', '.join(map(str, never))} are nowhere integers together"
        return Answer(Verdict.UNDECIDED, why)
    answer = _bounded(comparison, statement)
    if answer:
        answer = beyond_positive_bases(answer, comparison, statement, _bounded)
    if answer:
        from tresym.reals.decisions.definedness_check import unspoken

        missing = unspoken(comparison, statement)
        if missing is not None:
            why = f"{missing}, so there may be nothing to prove ({answer.why})"
            return Answer(Verdict.UNDECIDED, why)
    if answer and any(holds_powers(e) for e in (comparison.left, comparison.right)):
        answer = _attacked(answer, comparison, statement, anywhere=True)
    if comparison.relation == "O" and statement.path is not None:
        from tresym.asymptotics.sharp_constants import sharpened

        with stage("the smallest constant"):
            answer = sharpened(answer, comparison, statement)
        if answer.verdict is Verdict.UNDECIDED and statement.path.reach is not None:
            # What holds on a longer range holds on the one that was asked for.
            longer = replace(statement, path=replace(statement.path, reach=None))
            found = as_asked(_bounded(comparison, longer), comparison, statement)
            answer = found if found else answer
    return as_asked(answer, comparison, statement)


def _attacked(
    answer: Answer, comparison: Comparison, statement: Statement, anywhere: bool
) -> Answer:
    """Return the answer, or UNDECIDED if the independent numerical check contradicts it.

    Refutations are attacked too where they are about solutions of differential equations.
    """
    with stage("independent check of the proof"):
        against = attack(comparison, statement, answer, anywhere)
    if against is None:
        return answer
    return Answer(Verdict.UNDECIDED, STOPPED.format(against), cause=Cause.CONTRADICTED)


def _with_integers(comparison: Comparison, statement: Statement) -> Statement:
    """Return the statement with the variables that must be integers, such as ends of sums."""
    trees = (comparison.left, comparison.right, *statement.said)
    return replace(statement, integers=implied_integers(trees, statement.integers))


def _bounded(comparison: Comparison, statement: Statement) -> Answer:
    """Decide a comparison; UNDECIDED if an intermediate expression exceeds the size limit."""
    statement = _with_integers(comparison, statement)
    try:
        answer = _decide(comparison, statement)
    except InputError as error:
        why = f"an intermediate expression exceeds the size limit: {error}"
        return Answer(Verdict.UNDECIDED, why, cause=Cause.TOO_LARGE)
    if answer.verdict is Verdict.UNDECIDED and _hides(comparison):
        from tresym.reals.decisions.closed_values import decide_closed

        with stage("values of both sides"):
            answer = decide_closed(comparison, statement) or answer
    if answer.verdict is Verdict.REFUTED and statement.has_initial_values:
        return _attacked(answer, comparison, statement, anywhere=False)
    if answer.verdict is Verdict.REFUTED and statement.path is not None:
        from tresym.asymptotics.refutation_check import checked

        return checked(answer, comparison, statement)
    if answer.verdict is Verdict.REFUTED:
        from tresym.checking.point_check import confirmed

        return confirmed(answer, comparison, statement)
    if answer and comparison.derivatives and statement.path is None:
        from tresym.reals.decisions.removable_holes import at_removable_holes

        answer = at_removable_holes(answer, comparison, statement, _bounded)
    if not answer:
        return answer
    return _attacked(answer, comparison, statement, anywhere=False)


def _hides(comparison: Comparison) -> bool:
    return comparison.left.hidden or comparison.right.hidden


def decide_within_limits(comparison: Comparison, statement: Statement) -> Answer:
    """Decide a comparison as part of another decision; see :data:`Decide`."""
    return _bounded(comparison, statement)


def _decide(comparison: Comparison, statement: Statement) -> Answer:
    left, relation, right = comparison.left, comparison.relation, comparison.right
    hiding = {node.op for node in outermost(*comparison.differentiated)} - {"unknown", "root"}
    if hiding == {"integral"}:
        from tresym.reals.decisions.integral_rules import decide_by_leibniz

        return decide_by_leibniz(comparison, statement, _bounded)
    if hiding:
        return Answer(Verdict.UNDECIDED, "derivatives of sums and limits are not supported")
    if any(node.op == "lambertw" for node in operations((left, right))):
        from tresym.reals.decisions.lambert_forms import decide_without_lambert

        answer = decide_without_lambert(comparison, statement, _bounded)
        if answer is not None:
            return answer
    parts = _Parts.of(comparison, statement)
    if parts.at_integers and statement.equations and parts.unknown - {FACTORIAL}:
        from tresym.asymptotics.bounds_by_induction import decide_bound
        from tresym.asymptotics.linear_recurrences import decide_every_value
        from tresym.asymptotics.systems_of_sequences import decide_system

        with stage("recurrence"):
            answer = decide_every_value(comparison, statement, _bounded)
            if answer is None:
                answer = decide_bound(comparison, statement, _bounded)
            if answer is None:
                answer = decide_system(comparison, statement, _bounded)
        if answer is not None:
            return answer
    for procedure, applies, _ in ORDER:
        if applies(parts):
            with stage(_spoken(procedure.__name__)):
                return decide_with_jumps(procedure, comparison, statement, _bounded)
    real = comparison.differentiated, comparison.by
    if left.op == "abs" and relation in ("<", "<="):
        halves = (replace(comparison, left=side * left.args[0]) for side in (1, -1))
        answer = worst([_decide(half, statement) for half in halves])
        if answer.verdict is not Verdict.UNDECIDED or not symbols(right):
            return answer
    if relation == "==":
        with stage("equality"):
            found = decide_equality(left, right, statement.given, *real)
        if found.witness is not None and found.values is not None:
            return refuted(found.why, found.witness, *found.values)
        if found.verdict is Verdict.UNDECIDED and not comparison.derivatives:
            at_jump = refuted_at_jumps(comparison, statement, _bounded)
            if at_jump is not None:
                return at_jump
        return Answer(found.verdict, found.why, cause=found.cause)
    with stage("inequality"):
        return _decide_inequality(left, relation, right, statement.given, *real)


def _spoken(name: str) -> str:
    """Return the name of a procedure in words, for the message about a claim that is stopped."""
    return name.strip("_").removeprefix("decide_").replace("_", " ")


class _Parts(NamedTuple):
    """What a procedure is chosen by: outermost operations, functions left unknown, and the like."""

    comparison: Comparison
    statement: Statement
    nodes: frozenset[str]
    unknown: frozenset[str]
    infinite: bool

    @classmethod
    def of(cls, comparison: Comparison, statement: Statement) -> _Parts:
        """Return the parts of a comparison."""
        sides = comparison.left, comparison.right
        outer = list(outermost(*sides))
        called = (f for e in (*sides, *statement.said) for f in functions(e))
        return cls(
            comparison,
            statement,
            frozenset(node.op for node in outer),
            frozenset(f.args[0].args[0] for f in called),
            any(map(is_infinite, outer)),
        )

    @property
    def has_dots(self) -> bool:
        """Return whether a side is a sum with an ellipsis."""
        name = DOTS.args[0]
        return any(name in symbols(e) for e in (self.comparison.left, self.comparison.right))

    @property
    def finite_sums(self) -> bool:
        """Return whether sums or products are all that is beyond an elementary claim."""
        alone = self.nodes <= {"sum", "product", "unknown"} and self.statement.path is None
        return bool(self.nodes & {"sum", "product"}) and (self.unknown <= {FACTORIAL} or alone)

    @property
    def tends(self) -> bool:
        """Return whether an integral, a finite sum or a factorial stands in a claim on a path."""
        hidden = self.nodes & {"integral", "sum", "product", "coefficient"} or self.unknown == {
            FACTORIAL
        }
        known = self.nodes <= {"integral", "sum", "product", "unknown", "coefficient"}
        known = known and self.unknown <= {FACTORIAL}
        return self.statement.path is not None and known and bool(hidden)

    @property
    def is_scheme(self) -> bool:
        """Return whether an order of arbitrary functions along a path is claimed."""
        known = self.nodes <= {"unknown", "integral"} and FACTORIAL not in self.unknown
        return self.statement.path is not None and bool(self.unknown) and known

    @property
    def has_stages(self) -> bool:
        """Return whether equations with arbitrary functions stand beside a path to 0."""
        path = self.statement.path
        if path is None or path.point != ZERO or not self.unknown or FACTORIAL in self.unknown:
            return False
        return any(any(functions(e)) for pair in self.statement.equations for e in pair)

    @property
    def gammas(self) -> bool:
        """Return whether factorials, and special functions or integrals, are all that is open."""
        if self.unknown != {FACTORIAL} or not self.nodes <= {"unknown", "integral"}:
            return False
        sides = (self.comparison.left, self.comparison.right)
        if "integral" in self.nodes:  # the factorial of its variable has no integral
            return not any(node.loose for side in sides for node in functions(side))
        return any(node.op in SPECIAL for node in operations(sides))

    @property
    def at_integers(self) -> bool:
        """Return whether the claim is about integers, at points rather than along a path."""
        return bool(self.statement.integers) and self.statement.path is None

    @property
    def alternates(self) -> bool:
        """Return whether a power or angle depends on the parity of an integer."""
        from tresym.reals.decisions.integer_variables import alternates

        return self.at_integers and alternates(self.comparison, self.statement)


def _ellipses(*claim: Any) -> Answer:
    from tresym.reals.decisions.ellipsis_series import decide_dotted

    return decide_dotted(*claim)


def _is_infinite_value(e: Expr) -> bool:
    return INFINITY.args[0] in symbols(replaced(e, dict.fromkeys(outermost(e), ZERO)))


def _infinite_sums(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.series import decide_series
    from tresym.reals.decisions.power_series import decide_infinite

    left, right = comparison.left, comparison.right
    if right == -INFINITY and left.op == "sum":  # the opposite terms add up to oo
        (k,), term = opened(left, statement.given.names)
        comparison = replace(comparison, left=total("sum", -term, k, *left.args[1:]), right=-right)
    elif any(map(_is_infinite_value, (left, right))) and (right != INFINITY or left.op != "sum"):
        return Answer(Verdict.UNDECIDED, "oo is supported as the value of one sum, sum(…) == oo")
    if comparison.right == INFINITY:  # the partial sums decide
        other = decide_series(comparison, statement, decided)
        if other is not None:
            return other
        if comparison.relation == "==":
            why = "neither convergence nor divergence of the series is shown"
            return Answer(Verdict.UNDECIDED, why)
    found = decide_infinite(comparison, statement, decided)
    if found.verdict is not Verdict.UNDECIDED:
        return found
    other = decide_series(comparison, statement, decided)
    return found if other is None else other


def _roots(*claim: Any) -> Answer:
    from tresym.reals.decisions.roots import decide_roots

    return decide_roots(*claim)


def _initial_values(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.initial_values import decide_initial_values

    found = decide_initial_values(comparison, statement, decided)
    if found.verdict is Verdict.UNDECIDED and statement.path is None:
        # Without the initial values more functions are meant, so that only a proof carries over.
        other = _unknown_functions(comparison, statement, decided)
        return other if other else found
    return found


def _implicit(*claim: Any) -> Answer:
    from tresym.asymptotics.roots import decide_implicit

    return decide_implicit(*claim)


def _premises(*claim: Any) -> Answer:
    from tresym.asymptotics.premises import decide_under_premises

    return decide_under_premises(*claim)


def _schemes(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.schemes import decide_scheme

    found = decide_scheme(comparison, statement)
    if found.verdict is Verdict.UNDECIDED and statement.has_initial_values:
        return _initial_values(comparison, statement, decided)
    return found


def _peano_kernels(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.peano_kernels import decide_peano

    found = decide_peano(comparison, statement, decided)
    return _unknown_functions(comparison, statement, decided) if found is None else found


def _recurrences(*claim: Any) -> Answer:
    from tresym.asymptotics.recurrences import decide_recurrence

    return decide_recurrence(*claim)


def _coefficients(*claim: Any) -> Answer:
    from tresym.asymptotics.exact_coefficients import decide_coefficients

    return decide_coefficients(*claim)


def _nth_derivatives(*claim: Any) -> Answer:
    from tresym.reals.decisions.induction import decide_repeated

    return decide_repeated(*claim)


def _finite_sums(*claim: Any) -> Answer:
    from tresym.reals.decisions.induction import decide_totals

    return _or_by_lemmas(decide_totals, *claim)


def _or_by_lemmas(
    procedure: Procedure, comparison: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Decide by a procedure; if it is undecided, at small integers or by monotony."""
    found = procedure(comparison, statement, decided)
    if found.verdict is not Verdict.UNDECIDED:
        return found
    from tresym.asymptotics.monotone import decide_by_monotony
    from tresym.asymptotics.small_integers import refuted_at_integers

    other = refuted_at_integers(comparison, statement)
    if other is None:
        other = decide_by_monotony(comparison, statement, decided)
    if other is None and statement.path is None:
        from tresym.asymptotics.telescoping import decide_by_telescoping

        other = decide_by_telescoping(comparison, statement, decided)
    return found if other is None else other


def _factorials(*claim: Any) -> Answer:
    from tresym.reals.decisions.factorials import decide_factorials

    return _or_by_lemmas(decide_factorials, *claim)


def _gamma_forms(*claim: Any) -> Answer:
    from tresym.reals.decisions.gamma_forms import decide_by_gamma

    return decide_by_gamma(*claim)


def _integer_variables(*claim: Any) -> Answer:
    from tresym.reals.decisions.integer_variables import decide_whole

    return _for_every_argument(decide_whole(*claim), claim[1])


def _unknown_functions(*claim: Any) -> Answer:
    from tresym.reals.decisions.unknown_functions import decide_unknown

    return _for_every_argument(decide_unknown(*claim), claim[1])


def _for_every_argument(answer: Answer, statement: Statement) -> Answer:
    """Return an answer, but no refutation that reads an equation for a function at one point.

    ``f(n + 1) == 2*f(n)`` and ``f(x) == x**2`` are meant for every n and x: a proof from one value
    stands, but values at one point that violate the claim need not belong to such a function.
    """
    if answer.verdict is not Verdict.REFUTED:
        return answer
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    nodes = {f for e in (*sides, *statement.said) for f in functions(e)}
    for f in (f for e in statement.said for f in functions(e)):
        name = f.args[0].args[0]
        moves = name != FACTORIAL and any(symbols(arg) for arg in f.args[1:])
        if moves and any(node != f and node.args[0].args[0] == name for node in nodes):
            why = f"what is said of {name} is meant for every argument, and was used at one point"
            return Answer(Verdict.UNDECIDED, f"{why} only")
    return answer


def _integrals(*claim: Any) -> Answer:
    from tresym.reals.decisions.integrals import decide_integrals

    return _or_by_lemmas(decide_integrals, *claim)


def _lemmas(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.cancelled_functions import decide_cancelled
    from tresym.asymptotics.integral_limits import decide_integral_limits
    from tresym.asymptotics.lemma_claims import decide_by_lemmas

    path = statement.path
    outer = list(outermost(comparison.left, comparison.right))
    moving = path is not None and any(path.name in symbols(node) for node in outer)
    if any(map(is_infinite, outer)) and not moving:
        return _infinite_sums(comparison, statement, decided)
    cancelled = decide_cancelled(comparison, statement, decided)
    if cancelled is not None:
        return cancelled
    found = decide_by_lemmas(comparison, statement, decided)
    nodes = {node.op for node in outermost(comparison.left, comparison.right)}
    if found.verdict is Verdict.UNDECIDED and nodes == {"integral"}:
        other = decide_integral_limits(comparison, statement, decided)
        return found if other.verdict is Verdict.UNDECIDED else other
    return found


def _paths(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    from tresym.asymptotics.cancelled_functions import decide_cancelled
    from tresym.asymptotics.path_claims import decide_tending

    cancelled = decide_cancelled(comparison, statement, decided)
    if cancelled is not None:
        return cancelled
    found = decide_tending(comparison, statement, decided)
    if comparison.relation != "O":
        return found
    from tresym.asymptotics.uniformity import with_uniformity

    return with_uniformity(found, comparison, statement, decided)


def _beside_conditions(*claim: Any) -> Answer:
    from tresym.asymptotics.roots import decide_beside_conditions

    return decide_beside_conditions(*claim)


def _without_path(*claim: Any) -> Answer:
    from tresym.asymptotics.orders_without_path import decide_without_path

    return decide_without_path(*claim)


def _together(*claim: Any) -> Answer:
    from tresym.asymptotics.uniformity import decide_together

    return decide_together(*claim)


Procedure = Callable[[Comparison, Statement, Decide], Answer]
"""Decides a claim by simpler ones, which it hands to its last argument."""
ORDER: tuple[tuple[Procedure, Callable[[_Parts], bool], str], ...] = (
    (_ellipses, lambda p: p.has_dots, "its general term must be found before it is a sum"),
    (
        _without_path,
        lambda p: p.comparison.relation in ("O", "Theta") and p.statement.path is None,
        "an order without a path is one for all values of the parameters",
    ),
    (
        _together,
        lambda p: p.statement.path is not None and bool(p.statement.path.together),
        "a point of several variables is a distance times a direction",
    ),
    (
        _premises,
        lambda p: bool(p.statement.premises),
        "what is claimed of all functions of an order is claimed of none that is known",
    ),
    (
        _schemes,
        lambda p: p.has_stages,
        "beside h -> 0 equations give the derivatives and stages of a method",
    ),
    (
        _recurrences,
        lambda p: bool(p.statement.recurrences),
        "a recurrence determines a sequence, of which limit and rate are found",
    ),
    (
        _initial_values,
        lambda p: p.statement.has_initial_values,
        "differential equations and initial values determine a function",
    ),
    (
        _implicit,
        lambda p: p.statement.implicit,
        "an equation with the variable of the path determines a root",
    ),
    (
        decide_with_values,
        lambda p: "root" in p.nodes and has_values(p.comparison, p.statement),
        "balls enclose a root only where every parameter has its value",
    ),
    (
        _schemes,
        lambda p: p.is_scheme,
        "differences and quadratures of functions left unknown have Taylor expansions",
    ),
    (_roots, lambda p: "root" in p.nodes, "a root becomes a variable under its equation"),
    (
        _lemmas,
        lambda p: p.tends,
        "explicit functions and their errors stand for integrals and sums",
    ),
    (
        _coefficients,
        lambda p: "coefficient" in p.nodes and p.statement.path is None,
        "explicit functions of n stand for coefficients",
    ),
    (_infinite_sums, lambda p: p.infinite, "its value is a limit, or that of a known series"),
    (_nth_derivatives, lambda p: "nth" in p.nodes, "induction on n leaves ordinary derivatives"),
    (_finite_sums, lambda p: p.finite_sums, "induction leaves a claim without sums"),
    (_gamma_forms, lambda p: p.gammas, "n! is gamma(n + 1) beside integrals and gammas"),
    (_factorials, lambda p: FACTORIAL in p.unknown, "a recurrence leaves no factorials"),
    (
        _peano_kernels,
        lambda p: p.statement.bounds_derivatives,
        "a bound of a derivative at all points is none of values at the points that occur",
    ),
    (_integer_variables, lambda p: bool(p.unknown) and p.at_integers, "f(n) is one value a case"),
    (_unknown_functions, lambda p: bool(p.unknown), "values of a function become variables"),
    (
        decide_under_equations,
        lambda p: bool(among_integers(p.statement)),
        "solutions are found before cases modulo M",
    ),
    (_integer_variables, lambda p: p.alternates, "(-1)**n must be a number to solve equations"),
    (
        decide_under_equations,
        lambda p: bool(p.statement.equations),
        "solving them leaves free variables",
    ),
    (
        _beside_conditions,
        lambda p: p.statement.path is not None and p.statement.path.name in p.statement.given.names,
        "conditions on what tends must hold near the end of the path",
    ),
    (_paths, lambda p: p.statement.path is not None, "limits need expansions, at integers too"),
    (_integrals, lambda p: "integral" in p.nodes, "antiderivatives leave no integrals"),
    (_integer_variables, lambda p: p.at_integers, "cases modulo M and real variables are last"),
)
"""The procedures in the order in which they are asked, when, and why there: each removes what the
later ones cannot handle. What none applies to is an elementary claim at points."""


def _decide_inequality(
    left: Expr,
    relation: str,
    right: Expr,
    given: Given,
    differentiated: tuple[Expr, ...],
    by: frozenset[str],
) -> Answer:
    """Decide an inequality, and separately at the points where sign and atan2 jump."""
    from tresym.reals.decisions.inequalities import decide_inequality

    left, right = with_closed_values(left), with_closed_values(right)
    nodes = jumps((left, right), given)
    apart = Given(tuple((u, "!=", ZERO) for node in nodes for u in zeros(node.args[0], given)))
    answer = decide_inequality(left, relation, right, given & apart, differentiated, by)
    answers = [replace(answer, region=str(given) or None) if nodes and answer.region else answer]
    for case in cases_at_jumps((left, right), given) if nodes else ():
        if case is None:
            answers.append(Answer(Verdict.UNDECIDED, JUMP))
            continue
        real = tuple(map(case.of, differentiated))
        found = _decide_inequality(case.of(left), relation, case.of(right), case.given, real, by)
        at = case.point(_exact(found.witness))
        if found.verdict is Verdict.REFUTED and at is None:
            found = replace(found, verdict=Verdict.UNDECIDED)
        shown = at and {name: exact_text(value) for name, value in at.items()}
        why = f"{case}: {found.why}"
        answers.append(replace(found, why=why, witness=shown, region=str(given) or None))
    return worst(answers)


def _exact(witness: Mapping[str, str] | None) -> dict[str, Expr] | None:
    """Return the witness as expressions, or None if it is not an exact point."""
    try:
        return None if witness is None else {name: parse(v) for name, v in witness.items()}
    except InputError:  # intervals between whose ends the sign changes
        return None


def _mistaken(statement: Statement) -> str:
    """Return a remark on variables such as e and i that may have been meant as constants."""
    names = frozenset().union(*(symbols(c.left) | symbols(c.right) for c in statement.comparisons))
    remarks = [
        f"; {name} is read as a variable, {other}"
        for name, other in _LOOK_ALIKE.items()
        if name in names
    ]
    return "".join(remarks)


def _short(text: str) -> str:
    """Return ``text`` on one line, abbreviated in the middle if it is very long."""
    line = " ".join(text.split())
    return line if len(line) <= 400 else f"{line[:200]} … {line[-100:]}"
