r"""What print says of a formula's symbols: ``A^T``, ``x \in \mathbb{R}^n``, ``AB`` and ``BA``."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from tresym.manuscript.kinds_in_prose import (
    COMPLEX,
    FUNCTION,
    INTEGER,
    MATRIX,
    OPERATOR,
    RANDOM,
    REAL,
    SET,
    UNKNOWN,
    VECTOR,
)
from tresym.manuscript.symbols import (
    OPENING,
    Mention,
    factors,
    group_end,
    is_lone_argument,
    is_plain_number,
)
from tresym.reals.language.latex_cursor import INDICES, is_letter
from tresym.reals.language.latex_tokens import RELATIONS

Noted = Iterator[tuple[str, Mention, str]]
_SETS = frozenset(
    ("\\cup", "\\cap", "\\setminus", "\\subset", "\\subseteq", "\\supset", "\\supseteq", "\\sqcup")
)
_OF_VECTORS = frozenset(("\\otimes", "\\oplus", "\\wedge"))
_ADJOINTS = ("\\top", "\\dagger", "\\intercal", "\\mathsf", "\\transpose", "\\ast", "\\dag")
_OF_MATRICES = frozenset(("\\det", "\\ker", "\\dim", "\\operatorname*{rank}"))
_OF_COMPLEX = frozenset(("\\Re", "\\Im", "\\arg"))
_ANGULAR = frozenset(("\\sin", "\\cos", "\\tan", "\\cot"))
"""Functions behind which i is an inclination."""
_CONJUGATE = frozenset(("star", "bar", "overline"))
LEAST_OF_WORD = 5
"""Letters in a row that are a word rather than a product."""
_TOTALS = frozenset(
    ("\\sum", "\\prod", "\\lim", "\\bigcup", "\\bigcap", "\\sup", "\\limsup", "\\liminf")
)
_ARROWS = ("\\to", "\\rightarrow", "\\longrightarrow")
_NO_DOMAIN = frozenset((*_ARROWS, *RELATIONS, "\\}", "\\lim", "\\sup", "\\inf")) - {":", "\\colon"}
"""What ends the domain behind the colon of ``f : [a, b] \\to \\mathbb{R}``; a relation says that
the colon was that of a set, as in ``\\{ x_k : k \\ge n \\}``."""
_FUNCTIONS = frozenset(("f", "g", "h", "phi", "psi", "varphi"))


def noted(
    tokens: Sequence[str],
    found: Sequence[Mention],
    display: bool,
) -> Noted:
    """Each symbol whose kind shows in how a formula uses it, and by which part of the formula."""
    for sought in (_samples, _neighbours, _followers, _transposed, _normed, _conjugates):
        yield from sought(tokens, found)
    yield from _brackets(tokens, found)
    if display:
        yield from _both_orders(tokens, found)


def declared_by_notation(
    tokens: Sequence[str], found: Sequence[Mention], intervals: Collection[str] = ()
) -> Noted:
    """Each symbol that a formula declares: as a map, or as a member of a set.

    Args:
        intervals: letters of intervals of real numbers.
    """
    yield from _maps(tokens, found, intervals)
    yield from _members(tokens, found)


def _shown(tokens: Sequence[str], start: int, end: int) -> str:
    return " ".join(tokens[max(start, 0) : end])


def _plain(tokens: Sequence[str], at: int) -> list[str]:
    """The next tokens without braces."""
    return [t for t in tokens[at : at + 14] if t not in ("{", "}")]


def _members(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """Return the kinds of symbols that are members of a set, as in ``x, y \\in \\mathbb{C}^n``."""
    return _before(tokens, found, "\\in")


def _samples(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``X \\sim N(0, 1)``."""
    return _before(tokens, found, "\\sim")


def _before(tokens: Sequence[str], found: Sequence[Mention], relation: str) -> Noted:
    """The symbols before ``\\in`` or ``\\sim``, of the kind that follows."""
    for at, token in enumerate(tokens):
        if token != relation:
            continue
        own, end = [], at
        for one in reversed([one for one in found if one.end <= at]):
            if one.end != end:
                break
            own.append(one)
            before = tokens[one.start - 1] if one.start else ","
            if before not in (",", ";", ":", "&", "\\\\"):
                own.pop()
            end = one.start - 1 if before == "," else -1
        kind = _member(tokens, at + 1) if token == "\\in" else _distributed(tokens, at + 1)
        words = _shown(tokens, own[-1].start if own else at, at + 9)
        yield from ((kind, one, words) for one in own if kind)
        behind = next((one for one in found if one.start == at + 1), None)
        if token == "\\in" and behind and behind.letter[0].isupper() and not behind.accent:
            yield SET, behind, words


def _member(tokens: Sequence[str], at: int) -> str:
    """The kind of what is in the set at ``at``."""
    after = _plain(tokens, at)
    if after[:1] == ["\\mathbb"] and len(after) > 1:
        letter, more = after[1], after[2:4]
        raised = more[:1] == ["^"] and more[1:2] not in (["+"], ["*"], ["-"], ["\\times"])
        if letter in ("Z", "Q") and after[2:3] in (["["], ["("]):
            return COMPLEX
        if letter in ("Z", "N", "Q") and not raised:
            return REAL if letter == "Q" else INTEGER
        if letter == "R" and not raised:
            return REAL
        if letter == "C" and not raised:
            return COMPLEX
        return MATRIX if "\\times" in after[3:7] or letter == "H" else VECTOR
    if after[:1] in (["["], ["("], ["]"]):
        return REAL
    if after[:2] in (["M", "_"], ["G", "L"], ["S", "L"], ["S", "O"], ["S", "U"], ["O", "("]):
        return MATRIX
    if after[:1] in (["V"], ["W"]) and after[1:2] != ["_"]:
        return VECTOR
    return UNKNOWN if after[:1] in (["G"], ["H"], ["\\mathcal"], ["\\mathfrak"]) else ""


def _distributed(tokens: Sequence[str], at: int) -> str:
    """Whether what follows ``\\sim`` is the name of a distribution."""
    name = tokens[at : at + 1] and tokens[at][:1].isupper() and tokens[at + 1 : at + 2] == ["("]
    return RANDOM if name or (tokens[at : at + 1] == ["("] and _has_comma(tokens, at)) else ""


def _has_comma(tokens: Sequence[str], at: int) -> bool:
    """Whether the bracket at ``at`` holds several things: ``(x, y)``."""
    depth = 0
    for token in tokens[at + 1 : group_end(tokens, at)]:
        depth += (token in (*OPENING, "{")) - (token in (")", "]", "\\}", "}"))
        if depth == 0 and token == ",":
            return True
    return False


def _maps(tokens: Sequence[str], found: Sequence[Mention], intervals: Collection[str]) -> Noted:
    """``f \\colon [0, 1] \\to \\mathbb{R}``: a function of real values, or another map."""
    for one in found:
        if tokens[one.end : one.end + 1] not in ([":"], ["\\colon"]):
            continue
        arrow = next((n for n in range(one.end, len(tokens)) if tokens[n] in _NO_DOMAIN), None)
        if arrow is None or tokens[arrow] not in _ARROWS:
            continue
        values = _plain(tokens, arrow + 1)
        numbers = values[:1] == ["\\mathbb"] and values[1:2] and values[1] in "RQZN"
        real = numbers and values[2:3] != ["^"]
        real = real or values[:1] in (["["], ["("])
        real = real or (values[0] in intervals and values[1:2] != ["^"] if values else False)
        yield FUNCTION if real else OPERATOR, one, _shown(tokens, one.start, one.end + 16)


def _divides(tokens: Sequence[str], at: int) -> bool:
    """Whether ``m \\setminus n`` says that m divides n, which are small letters and numbers."""
    beside = (*tokens[max(at - 1, 0) : at], *tokens[at + 1 : at + 2])
    beside = tuple(token for token in beside if token not in "()")
    return bool(beside) and all(token[:1].islower() or token.isdigit() for token in beside)


def _neighbours(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``A \\cup B`` and ``u \\otimes v``."""
    for at, token in enumerate(tokens):
        if token == "\\setminus" and _divides(tokens, at):
            continue
        if token in _SETS or token in _OF_VECTORS:
            for one in found:
                image = one.letter in _FUNCTIONS and tokens[one.end : one.end + 1] == ["("]
                if one.end == at or (one.start == at + 1 and not image):
                    kind = SET if token in _SETS else VECTOR
                    yield kind, one, _shown(tokens, at - 1, at + 2)


def _followers(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``\\det A``, ``\\Re z``, ``\\nabla f`` and ``\\nabla\\cdot F``."""
    for one in found:
        before, earlier = tokens[max(one.start - 1, 0)], tokens[max(one.start - 2, 0)]
        words = _shown(tokens, one.start - 2, one.end)
        entry = tokens[one.end : one.end + 1] == ["&"]  # of a matrix that is written out
        if before in _OF_MATRICES and len(one.subscript) < 2 and not entry:
            yield MATRIX, one, words
        elif before in _OF_COMPLEX:
            yield COMPLEX, one, words
        elif before == "\\nabla":
            yield FUNCTION, one, words
        elif earlier == "\\nabla" and before in ("\\cdot", "\\times"):
            yield VECTOR, one, words


def _transposed(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``A^T`` where T stands in exponents alone, ``A^\\dagger``, ``(AB)^\\top``."""
    elsewhere = any(
        one.letter == "T"
        and tokens[one.start - 1 : one.start] != ["^"]
        and not _alone_above(tokens, one)
        for one in found
    )
    for at, token in enumerate(tokens):
        after = _plain(tokens, at + 1)[:2]
        adjoint = after[:1] and (after[0] in _ADJOINTS or after[0] == "T")
        inner = tokens[at + 1 : group_end(tokens, at + 1) + 1] if tokens[at + 1 : at + 2] else []
        lone = len([t for t in inner if t not in ("{", "}", "T", *_ADJOINTS)]) == 0
        if token != "^" or not adjoint or not lone or (after[0] == "T" and elsewhere):
            continue
        opening = next(
            (n for n in range(at) if group_end(tokens, n) == at - 1 and tokens[n] in OPENING), at
        )
        if opening < at and _has_comma(tokens, opening):
            continue  # a column of numbers
        for one in found:
            lower = one.letter[0].islower() and not one.accent
            if lower and after[0] == "T" and not _is_factor(tokens, at):
                continue  # one that stands alone: "a^T" is a at another time, or a power
            if one.end == at or opening < one.start < at:
                yield MATRIX, one, _shown(tokens, one.start, at + 4)


def _is_factor(tokens: Sequence[str], at: int) -> bool:
    """Whether what has the exponent at ``at`` is multiplied from the right: ``v^T A``."""
    end = group_end(tokens, at + 1) if tokens[at + 1 : at + 2] == ["{"] else at + 1
    return is_letter("".join(tokens[end + 1 : end + 2])) or tokens[end + 1 : end + 2] == ["\\cdot"]


def _brackets(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``[A, B] = AB - BA`` and ``\\{q, p\\} = qp - pq``: operators."""
    products = {frozenset((one.name, other.name)) for one, other in factors(tokens, found)}
    for at, token in enumerate(tokens):
        if token not in ("[", "\\{") or not _has_comma(tokens, at):
            continue
        end = group_end(tokens, at)
        inside = [one for one in found if at < one.start < end]
        if len(inside) == 2 and frozenset(one.name for one in inside) in products:
            for one in inside:
                yield OPERATOR, one, _shown(tokens, at, end + 1)


def _alone_above(tokens: Sequence[str], one: Mention) -> bool:
    return list(tokens[max(one.start - 2, 0) : one.start]) == ["^", "{"] and tokens[one.end] == "}"


def _normed(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``\\|x\\|`` and ``\\langle u, v\\rangle``."""
    for one in found:
        around = tokens[one.start - 1 : one.start], tokens[one.end : one.end + 1]
        words = _shown(tokens, one.start - 1, one.end + 1)
        norm = around[0] == around[1] == ["\\|"]
        product = around in ((["\\langle"], [","]), ([","], ["\\rangle"]))
        if one.start and (norm or product):
            yield FUNCTION if one.letter in _FUNCTIONS else VECTOR, one, words


def _conjugates(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``\\bar z``, ``z^*`` and ``z = x + iy``."""
    for one in found:
        if one.accent in ("bar", "overline", "star") and one.letter in ("z", "w"):
            bare = one._replace(accent="")
            yield COMPLEX, bare, f"\\{one.accent} {one.letter}"
            yield COMPLEX, one, f"\\{one.accent} {one.letter}"
    for pair in factors(tokens, found):
        accents = {m.accent for m in pair}
        mean = bool(pair[0].subscript) != bool(pair[1].subscript)  # x_i beside \bar x
        alike = pair[0].letter == pair[1].letter and not mean
        if alike and "" in accents and accents & _CONJUGATE:
            yield from ((COMPLEX, m, f"{pair[0].shown} beside {pair[1].shown}") for m in pair)
    imaginary = any(
        one.letter == "i" and not one.subscript and not _in_word(tokens, one.start) for one in found
    )
    imaginary = imaginary and not any("i" in one.subscript for one in found)  # there i is an index
    angle = any(
        one.letter == "i" and any(t in _ANGULAR for t in tokens[max(one.start - 4, 0) : one.start])
        for one in found
    )
    imaginary = imaginary and not angle
    counts = {"\\sum", "\\ldots"} & {*tokens}
    heads = len(found) > 1 and found[0].start == 0 and tokens[found[0].end] == "="
    if imaginary and heads and not counts and found[0].letter != "i":
        yield COMPLEX, found[0], _shown(tokens, 0, found[0].end + 8)


def _in_word(tokens: Sequence[str], at: int) -> bool:
    """Whether a letter stands in a word that is written as letters: ``\\frac{opposite}{x}``."""
    start = stop = at
    while start and len(tokens[start - 1]) == 1 and tokens[start - 1].isalpha():
        start -= 1
    while stop < len(tokens) and len(tokens[stop]) == 1 and tokens[stop].isalpha():
        stop += 1
    return stop - start >= LEAST_OF_WORD


def _both_orders(tokens: Sequence[str], found: Sequence[Mention]) -> Noted:
    """``AB`` and ``BA`` in one display, or ``xy - yx``: the product does not commute."""
    pairs = {(one.name, other.name): (one, other) for one, other in factors(tokens, found)}
    for (one, other), both in pairs.items():
        capitals = all(m.letter[0].isupper() or m.accent for m in both)
        telling = capitals and not any(m.subscript for m in both)
        reverse = pairs.get((other, one))
        compared = (["-"], ["="]) if capitals else (["-"],)
        differ = reverse is not None and any(
            [*tokens[first[1].end : second[0].start]] in compared
            for first, second in ((both, reverse), (reverse, both))
        )
        if one != other and reverse is not None and (telling or differ):
            for m in both:
                yield f"{UNKNOWN}, as both {one} {other} and {other} {one} stand there", m, ""


def indices(tokens: Sequence[str], found: Sequence[Mention]) -> set[str]:
    """The letters that sums, products and limits bind, or that number terms."""
    below = {t for one in found if one.is_index for t in one.subscript if t in INDICES}
    return (_bound(tokens) | below) & INDICES


def _bound(tokens: Sequence[str]) -> set[str]:
    """The letters under sums, products and limits."""
    bound: set[str] = set()
    for at, token in enumerate(tokens):
        if token in _TOTALS and tokens[at + 1 : at + 2] == ["_"]:
            under = tokens[at + 2 : group_end(tokens, at + 2) + 1]
            bound |= {t for t in under[:4] if len(t) == 1 and t.isalpha()}
    return bound


def sequences(tokens: Sequence[str], found: Sequence[Mention]) -> Iterator[tuple[str, str]]:
    """Letters whose subscripts number terms, and by which print."""
    bound = _bound(tokens)
    numbered = {one.letter for one in found if one.subscript and one.subscript[0].isdigit()}
    dots = any(t in ("\\ldots", "\\dots", "\\cdots") for t in tokens)
    for one in found:
        if not one.is_index or one.accent:
            continue
        under = bound & {*one.subscript}
        moved = any(t in ("+", "-") or t.isdigit() for t in one.subscript)
        around = tokens[max(one.start - 1, 0) : one.start], tokens[one.end : one.end + 1]
        listed = around in ((["\\{"], ["\\}"]), (["("], [")"]))
        if under or moved or listed or (dots and one.letter in numbered):
            yield one.letter, _shown(tokens, one.start - 2, one.end + 2)


def applied_and_bare(tokens: Sequence[str], found: Sequence[Mention]) -> tuple[set[str], set[str]]:
    """The names before a bracket that holds an argument, and those before none."""
    applied, bare = set(), set()
    for one in found:
        after = tokens[one.end] if one.end < len(tokens) else ""
        if one.letter == "pi":
            continue
        if after not in OPENING:
            bare.add(one.name)
        elif is_lone_argument(tokens, one.end):
            applied.add(one.name)
    return applied, bare


def doubts(
    tokens: Sequence[str], found: Sequence[Mention], is_real: Callable[[Mention], bool]
) -> str:
    """What in a formula's print may be no operation of numbers; else nothing."""
    ends = {one.end: one for one in found}
    starts = {one.start: one for one in found}
    bars = any("|" in token for token in tokens)
    if why := _operators(tokens):
        return why
    for at, token in enumerate(tokens):
        one, other = ends.get(at), starts.get(at + 1)
        letters = one is not None and other is not None and not (is_real(one) and is_real(other))
        near = _shown(tokens, at - 1, at + 2)
        if token == "\\times" and letters:
            return f"{near} may be a vector product or a product of sets"
        if token == "\\cdot" and letters and bars:
            return f"{near} beside a bar may be a scalar product of vectors"
        around = tokens[max(at - 1, 0) : at + 2]
        numbers = is_plain_number(around[0])
        starred = at and tokens[at - 1] not in ("_", "^", "{")
        if token == "*" and starred and not numbers:
            return f"{near} may be a convolution: write a product without the star"
        if token == "^" and _plain(tokens, at + 1)[:2] == ["-", "1"] and at:
            inside = [one] if one is not None else []
            if tokens[at - 1] in (")", "]"):
                opening = max(n for n in range(at) if group_end(tokens, n) >= at - 1)
                inside = [m for m in found if opening < m.start < at]
            for m in inside:
                if _may_be_inverted(m) and not is_real(m):
                    return f"{m.shown}^{{-1}} may be an inverse matrix or function, or 1/{m.shown}"
    return ""


def _operators(tokens: Sequence[str]) -> str:
    """Derivatives and variations that look like factors: ``D/Dt`` and ``\\delta \\int``."""
    bare = [token for token in tokens if token not in ("{", "}", "\\left", "\\right")]
    for at, token in enumerate(bare):
        after = bare[at + 1 : at + 3]
        if token == "D" and after[:1] and is_letter(after[0]) and _is_below(bare, at):
            return f"D/D{after[0].removeprefix(chr(92))} may be a derivative along the motion"
        if token == "\\delta" and after[:1] in (["\\int"], ["\\iint"]):
            return "\\delta before an integral may be a variation"
        if token == "\\delta" and after[:1] and is_letter(after[0]):
            if after[1:] == ["("]:
                return f"\\delta before {after[0]}( may be a variation"
            varied = bare[at - 1 : at] not in (["d"], ["^"], ["_"])
            by = {bare[n + 1] for n, t in enumerate(bare[:-1]) if t == "d"}
            if "\\int" in bare[:at] and varied and after[0] not in by:
                return f"\\delta before {after[0]} under an integral may be a variation"
    return ""


def _is_below(bare: Sequence[str], at: int) -> bool:
    """Whether the D at ``at`` is that below a line, after another D: ``\\frac{D r}{D t}``, D/Dt."""
    earlier = [*bare[max(at - 8, 0) : at]]
    return "D" in earlier and ("/" in earlier[-2:] or "\\frac" in earlier)


def _may_be_inverted(one: Mention) -> bool:
    letter = one.letter
    return letter[0].isupper() or letter in ("f", "g", "h")
