"""Decide order claims in one variable: O, o and ~, from each side of the path."""

from __future__ import annotations

from dataclasses import replace

from flint import arb, fmpq

from tresym.asymptotics.readable_terms import readable
from tresym.reals.decisions.answer import Answer, constant_ball, refuted
from tresym.reals.decisions.derivative_domains import where_real
from tresym.reals.decisions.path_regions import along
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.leading_terms import Judgement, judge_order, sign_towards
from tresym.reals.expansions.scale import T
from tresym.reals.expansions.suprema import SHORTER
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, number, substitute, symbol
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict

LONGEST = fmpq(1)
LARGEST = arb((1, 10**8))
SHOWN_AT = tuple(fmpq(1, 2**n) for n in (4, 2, 6, 3, 1, 0))
"""Where on the path both sides are shown, if they are not real where a refutation would."""

_SUCCESSES = {"o": "the ratio left/right tends to 0", "~": "the ratio left/right tends to 1"}
_FAILURES = {
    "O": "the ratio left/right is not bounded",
    "o": "the ratio left/right does not tend to 0",
    "~": "the ratio left/right does not tend to 1",
}


def decide_order(claim: Comparison, path: Path) -> Answer:
    """Decide an O, o or ~ claim in one variable.

    Sides of the path on which the differentiated functions are not real are ignored.

    Returns:
        ENCLOSED with a range and, for O, a constant; REFUTED with the true order; or UNDECIDED.
    """
    real = {side: _real_upto(claim, path, side) for side in path.sides}
    if None in real.values() or not any(real.values()):
        return Answer(
            Verdict.UNDECIDED,
            "the differentiated functions could not be shown to be real "
            "near the end of the path; a "
            "path from one side, such as x -> 0+, may help",
        )
    path = replace(path, sides=tuple(side for side in path.sides if real[side]))
    found = [_one_side(claim, path, side) for side in path.sides]
    for side, judgement in zip(path.sides, found, strict=True):
        shown = _shown_at(claim, path, side, judgement, real[side])
        if shown is not None:
            return _refutation(claim, path, side, judgement, *shown)
    if all(judgement.verdict is Verdict.ENCLOSED for judgement in found):
        sides = zip(path.sides, found, strict=True)
        if all(j.real or _is_real_somewhere(claim, path, s, j) for s, j in sides):
            return _holds(claim, path, found)
        return Answer(
            Verdict.UNDECIDED,
            "the two sides could not be shown to be real near the end of the path; "
            "a path from one side, such as x -> 0+, may help",
        )
    return Answer(
        Verdict.UNDECIDED,
        "the order could not be decided: the method expands both sides in powers, exponentials "
        "and logarithms at the end of the path, and functions that oscillate or have no such "
        "expansion are not supported",
    )


def _real_upto(claim: Comparison, path: Path, side: int) -> fmpq | None:
    """Where what is differentiated is real, 0 < t <= this; 0 if nowhere, None if that is open."""
    inside, _ = where_real(Given(), claim.differentiated, claim.by)
    if inside.names - {path.name}:
        return None
    conditions = [(c.expression, c.relation) for c in inside.conditions]
    found = [sign_towards(e, path.name, path.point, side) for e, _ in conditions]
    for beside, (_, relation) in zip(found, conditions, strict=True):
        if beside is not None and (beside[0] == 0 or (beside[0] < 0 and relation != "!=")):
            return fmpq(0)
    if None in found:
        return None
    return min([LONGEST, *(beside[1] for beside in found if beside is not None)])


def _shown_at(
    claim: Comparison, path: Path, side: int, judgement: Judgement, upto: fmpq
) -> tuple[fmpq, tuple[arb, arb]] | None:
    """Where on the path a refutation is shown, and both sides there: real, and best no tower.

    The largest ratio is shown, or for ~ the one nearest to the end.
    """
    if judgement.verdict is not Verdict.REFUTED:
        return None
    found, towers = [], []
    for t in (min(t, upto) for t in SHOWN_AT):
        values = _values(claim, path, side, t)
        if values is None:
            continue
        if not all(abs(value) < LARGEST for value in values):
            towers.append((t, values))
            continue
        found.append((t, values))
        if claim.relation == "~":
            break
    with ball_precision():
        return max(found or towers[:1], key=lambda item: _ratio(*item[1]), default=None)


def _ratio(left: arb, right: arb) -> arb:
    return abs(left / right).mid() if right != 0 else arb(0)


def _values(claim: Comparison, path: Path, side: int, t: fmpq) -> tuple[arb, arb] | None:
    """Both sides at a point of the path; None where they are not shown to be real."""
    mapping = {path.name: along(path, side)}
    with ball_precision():
        at = {T: arb(t)}
        left, right = (evaluate(substitute(e, mapping), at) for e in (claim.left, claim.right))
        return (left, right) if left.is_finite() and right.is_finite() else None


def _is_real_somewhere(claim: Comparison, path: Path, side: int, judgement: Judgement) -> bool:
    """Whether both sides are shown to be real at a point of the range."""
    upto = judgement.upto or fmpq(1)
    return any(_values(claim, path, side, upto / part) for part in (3, 5, 7, 11, 13, 17, 29, 41))


def _one_side(claim: Comparison, path: Path, side: int, upto: fmpq | None = None) -> Judgement:
    mapping = {path.name: along(path, side)}
    sides = substitute(claim.left, mapping), substitute(claim.right, mapping)
    shorter = SHORTER if path.reach is None else 0
    if upto is None:
        upto = LONGEST if path.reach is None else path.reach
    return judge_order(claim.relation, *sides, upto, _shown(path, side), shorter)


def _holds(claim: Comparison, path: Path, found: list[Judgement]) -> Answer:
    reach = min(judgement.upto for judgement in found if judgement.upto is not None)
    if claim.relation == "O":  # the constants must speak of one range
        found = [
            judgement if judgement.upto == reach else _one_side(claim, path, side, reach)
            for side, judgement in zip(path.sides, found, strict=True)
        ]
        reach = min([reach, *(j.upto for j in found if j.upto is not None)])
    if path.reach is not None and reach != path.reach:
        return Answer(
            Verdict.UNDECIDED,
            f"the order holds, but no constant was found on the region asked for; one was found on "
            f"{region(path, reach)}",
        )
    leading = found[0]
    constant = None
    sentence = _SUCCESSES.get(claim.relation, "")
    if claim.relation == "~" and leading.true_order is None:
        sentence = "(left - right) is o(right)"
    if claim.relation == "O":
        if any(judgement.constant is None for judgement in found):
            return Answer(
                Verdict.UNDECIDED,
                "the expansions hold on different ranges, and no common constant was found",
            )
        with ball_precision():
            constant = arb(0)
            for judgement in found:
                constant = constant.max(judgement.constant)
    behaves = ""
    if leading.true_order is not None:
        order = _readable(leading.true_order, path, path.sides[0])
        behaves = f"; the left side behaves like {order}"
    ball = None if constant is None else constant_ball(constant)
    answer = Answer(Verdict.ENCLOSED, sentence, constant=ball, region=region(path, reach))
    if constant is not None:
        about = f"about {constant.upper().str(6, radius=False)}"
        sentence = f"|left| <= C |right| with C {about if answer.sharp else answer.constant_text()}"
    return replace(answer, why=sentence + behaves)


def _refutation(
    claim: Comparison,
    path: Path,
    side: int,
    judgement: Judgement,
    t: fmpq,
    values: tuple[arb, arb],
) -> Answer:
    why = _FAILURES[claim.relation]
    if judgement.ratio is not None:
        why += f": it behaves like {_readable(judgement.ratio, path, side)}"
    if judgement.true_order is not None and judgement.true_order != judgement.ratio:
        why += f"; the left side behaves like {_readable(judgement.true_order, path, side)}"
    name, value = _witness(path, side, t)
    return refuted(why, {name: value}, *values)


def _readable(term: Expr, path: Path, side: int) -> Expr:
    """A leading term in a form for people; the sign of the variable is known at 0 and at ∞."""
    known = path.point is None or path.point == number(0)
    return readable(term, path.name, side if known else 0)


def _shown(path: Path, side: int) -> tuple[Expr, Expr]:
    """The small parameter in the variable, and its reciprocal."""
    x = symbol(path.name)
    if path.point is None:
        return 1 / (side * x), side * x
    small = side * (x - path.point)
    return small, 1 / small


def _small(path: Path, side: int) -> str:
    """The small parameter at a point, in words of the variable."""
    x, a = path.name, path.point
    if a == number(0):
        return x if side > 0 else f"-{x}"
    return f"{x} - {a}" if side > 0 else f"{a} - {x}"


def _witness(path: Path, side: int, t: fmpq) -> tuple[str, fmpq]:
    """The exact point on the path, or the parameter where the path ends at no rational."""
    if path.point is None:
        return path.name, side / t
    if path.point.op == "number":
        return path.name, path.point.args[0] + side * t
    return _small(path, side), t


def region(path: Path, reach: fmpq) -> str:
    """Where the small parameter is at most ``reach``, in words of the variable."""
    shown = fraction_text(reach)
    name = path.name
    if path.point is None:
        far = fraction_text(1 / reach)
        return f"{name} >= {far}" if path.sides == (1,) else f"{name} <= -{far}"
    if path.sides == (1, -1):
        return f"0 < |{_small(path, 1)}| <= {shown}"
    return f"0 < {_small(path, path.sides[0])} <= {shown}"
