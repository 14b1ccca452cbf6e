"""Order statements about one variable: O, o and ~, from each side of the path."""

from __future__ import annotations

from flint import arb, fmpq

from tresym.arithmetic import ball_precision
from tresym.checking.answer import Answer, constant_ball, refuted
from tresym.checking.formula import formula
from tresym.checking.leading import decide_smooth
from tresym.checking.statement import Comparison, Path
from tresym.claims.order import Judgement, Order, decide
from tresym.exact import fraction_text
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import Expr, number, substitute, symbol
from tresym.verdict import Verdict

PRECISION = 128
_PARAMETER = "_t"
"""The small parameter; the only symbol left once the path is put in."""


def decide_order(claim: Comparison, path: Path) -> Answer:
    """ENCLOSED with a range and, for O, a constant; REFUTED with the true order; UNDECIDED."""
    found = [_one_side(claim, path, side) for side in path.sides]
    for side, judgement in zip(path.sides, found, strict=True):
        if judgement.verdict is Verdict.REFUTED and _is_real(claim, path, side, judgement):
            return _refutation(claim, path, side, judgement)
    if all(judgement.verdict is Verdict.ENCLOSED for judgement in found):
        if all(_is_real(claim, path, *pair) for pair in zip(path.sides, found, strict=True)):
            return _holds(claim, path, found)
        return Answer(
            Verdict.UNDECIDED,
            "the two sides are not shown to be real numbers on the way to the end of the path; "
            "a path from one side, such as x -> 0+, may help",
        )
    return Answer(
        Verdict.UNDECIDED,
        "no expansion at the end of the path settles the order; "
        "a function that oscillates or has no expansion in powers, exponentials and "
        "logarithms is beyond this procedure",
    )


def _is_real(claim: Comparison, path: Path, side: int, judgement: Judgement) -> bool:
    """Whether both sides are shown to be defined at a point of the range."""
    reach = judgement.points.get("t") or judgement.upto or fmpq(1)
    mapping = {path.name: _along(path, side)}
    with ball_precision(PRECISION):
        at = {_PARAMETER: arb(reach / 3 if "t" not in judgement.points else reach)}
        return all(
            evaluate(substitute(e, mapping), at).is_finite() for e in (claim.left, claim.right)
        )


def _one_side(claim: Comparison, path: Path, side: int, upto: fmpq = fmpq(1)) -> Judgement:  # noqa: B008
    mapping = {path.name: _along(path, side)}
    left = formula(substitute(claim.left, mapping), _PARAMETER)
    right = formula(substitute(claim.right, mapping), _PARAMETER)
    try:
        found = decide(Order(claim.relation, left, right, upto=upto), PRECISION)
    except (ZeroDivisionError, OverflowError):
        found = Judgement(Verdict.UNDECIDED)
    if found.verdict is Verdict.UNDECIDED and path.point is not None and upto == 1:
        return decide_smooth(claim.relation, claim.left, claim.right, path.name, path.point, side)
    return found


def _along(path: Path, side: int) -> Expr:
    """The variable in the small parameter t."""
    t = symbol(_PARAMETER)
    return side / t if path.point is None else path.point + side * t


def _holds(claim: Comparison, path: Path, found: list[Judgement]) -> Answer:
    reach = min(judgement.upto for judgement in found if judgement.upto is not None)
    if claim.relation == "O":  # the constants must speak of one range
        found = [
            judgement if judgement.upto == reach else _one_side(claim, path, side, reach)
            for side, judgement in zip(path.sides, found, strict=True)
        ]
        reach = min([reach, *(j.upto for j in found if j.upto is not None)])
    leading = found[0]
    constant = None
    sentence = {"o": "the ratio tends to 0", "~": "the ratio tends to 1"}.get(claim.relation, "")
    if claim.relation == "O":
        if any(judgement.constant is None for judgement in found):
            return Answer(Verdict.UNDECIDED, "the range of the expansions does not settle it")
        with ball_precision(PRECISION):
            constant = arb(0)
            for judgement in found:
                constant = constant.max(judgement.constant)
            bound = constant.upper().str(6, radius=False)
        sentence = f"|left| <= C |right| with C at most about {bound}"
    if leading.true_order is not None and not leading.true_order.coefficient.is_zero():
        sentence += f"; the left side is about {_leading(path, path.sides[0], leading)}"
    return Answer(
        Verdict.ENCLOSED,
        sentence,
        constant=None if constant is None else constant_ball(constant),
        region=_region(path, reach),
    )


def _refutation(claim: Comparison, path: Path, side: int, judgement: Judgement) -> Answer:
    t = judgement.points["t"]
    with ball_precision(PRECISION):
        at = {_PARAMETER: arb(t)}
        mapping = {path.name: _along(path, side)}
        left = evaluate(substitute(claim.left, mapping), at)
        right = evaluate(substitute(claim.right, mapping), at)
    why = f"the left side is about {_leading(path, side, judgement)}"
    if judgement.ratio is not None:
        ratio = judgement.ratio.text(_small(path, side))
        why += f", and left/right about {ratio}, which for {claim.relation} it must not be"
    name, value = _witness(path, side, t)
    return refuted(why, {name: value}, left, right)


def _leading(path: Path, side: int, judgement: Judgement) -> str:
    size = judgement.true_order
    return "0" if size is None else size.text(_small(path, side))


def _small(path: Path, side: int) -> str:
    """The small parameter in words of the variable."""
    if path.point is None:
        return f"(1/{path.name})" if side > 0 else f"(-1/{path.name})"
    if path.point == number(0):
        return path.name if side > 0 else f"(-{path.name})"
    if side > 0:
        return f"({path.name} - {path.point})"
    return f"({path.point} - {path.name})"


def _witness(path: Path, side: int, t: fmpq) -> tuple[str, fmpq]:
    """The exact point on the path, or the parameter where the path ends at no rational."""
    if path.point is None:
        return path.name, side / t
    if path.point.op == "number":
        return path.name, path.point.args[0] + side * t
    return _small(path, side).strip("()"), t


def _region(path: Path, reach: fmpq) -> str:
    shown = fraction_text(reach)
    name = path.name
    if path.point is None:
        far = fraction_text(1 / reach)
        return f"{name} >= {far}" if path.sides == (1,) else f"{name} <= -{far}"
    if path.sides == (1, -1):
        size = f"|{name}|" if path.point == number(0) else f"|{name} - {path.point}|"
        return f"0 < {size} <= {shown}"
    return f"0 < {_small(path, path.sides[0]).strip('()')} <= {shown}"
