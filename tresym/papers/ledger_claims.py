"""Read a file of claims as claims of the ledger.

The file ``proofs/slope.tresym`` states the claims of a part of the paper. It is written as any file
of claims (:mod:`tresym.papers.reading`), its claims are those of :mod:`tresym.ledger.claim`, and
the engine decides them (:mod:`tresym.ledger.evidence.decided`)::

    # Appendix: how the flip defect depends on γ
    use shape from conditions
    use sign_of_tilt from flip_dynamics
    use defect_per_turn from printed_formulas

    let tilt (12): S := cos(theta)/abs(cos(theta)), cos(theta)**2 > 0
    d51 (51): -1/f(epsilon) == defect_per_turn(epsilon, a, b, S) given shape using sign_of_tilt
    The derivative by F is taken at γ = 0.

This is how each line is understood:

- ``label (51): …`` stands in display 51 of the paper, ``label [line 320]: …`` on that line of its
  source, ``[line 302, cell a]`` in a cell of the table there. A claim without a place is an
  auxiliary lemma.
- ``let name: S := …, condition`` defines symbols of the ledger, under conditions. Its equations are
  put in where a claim says ``using name``. Without a definition, the line names conditions, which
  stand after ``given``.
- ``f(x) := …`` and ``u := …`` are abbreviations: they are put in wherever they stand.
- ``use x from FILE`` takes claims, conditions or expressions from another part of the paper, be it
  a file or a module of Python, and functions of formulas that programs run. Where the value of a
  function ``f(x)`` is a vector, its components are ``f_1(x)``, ``f_2(x)``, and so on.
- ``knowing x > 0, (y > 0 given 0 < y)`` names inequalities that are shown first, each with those
  before it, and are used then, those with conditions of their own for variables of integrals.
- A matrix is written row by row, ``(a, b; c, d)``, a column ``(a; b)``
  (:mod:`tresym.papers.matrices`).
- ``using label, label`` names the claims above on which a claim rests: what is an equation is put
  in, other comparisons become conditions.
- ``let name: y := root of label, condition`` defines y as the only root of which a claim ``exactly
  one x in (0, 1): …`` speaks.
- In a chain ``a == b == c`` the claim is ``a == c``, in ``a == b >= c`` it is ``a >= c``, and each
  step is decided by itself. A step may name, in brackets behind it, the claims whose equations are
  put in, and no others: ``a == b [one] == c [two]``. Other words there are printed. In ``u > 0
  [one] and v > 0 [two, three]`` each part is shown by the claims behind it.
- A step between integrals may name a rule there: ``[u = t**2]`` is a change of the variable t,
  ``[cut at 1]`` divides the interval, ``[antiderivative log(t)]`` is put in at both ends, by ``[one
  integral]`` a sum is one over one interval, and ``[inside -t**2]`` is the derivative of an
  integrand under the integral sign. What the rule requires is checked, with the bounds that the
  step names.
- ``one: two and three`` claims again what others claim.
- ``f == O(g) as x -> 0+`` is an order along a path, uniform in all other variables.
- ``given x ~= 1.21`` is a printed input, and in ``label: e ~= 0.115`` the number is printed; it is
  right to half a unit of its last place, and with ``~= 0.115 within one unit`` to a whole one.
- ``label: in words, from one, two`` stands above a sentence (``> says:``) that says more than the
  claims do on which it rests; it counts as not formal. With ``expect refuted at x == 1`` the claims
  contradict the sentence, in that case at least.
- ``shown by`` names a method where the engine needs a hint (:mod:`tresym.papers.ways_to_show`).
- ``infimum(e) == v`` says that e > v, and e < v + d somewhere for every d > 0.
- ``root(f, x, 0, 1)`` is the root whose uniqueness an earlier claim ``at most one x in (0, 1): …``
  shows.
- ``expect refuted at x == 1, y == 2 instead other`` states a falsehood, a point at which it fails,
  and what is true, for an order a curve ``at x == t, y == -t``, or ``at x == t, y < t**2``, if y is
  a root that lies below this value on the curve; ``expect enclosed`` that balls are
  needed.
- ``using general, bound with x == 1/a`` shows that a claim is what the first claim used says of
  these values of its variables; the others serve to show its conditions there.
- ``using root by slope u == v [one] > 0`` behind ``increasing(y, x)`` or ``decreasing(y, x)`` gives
  the steps from the derivative by x of the equation whose only root is y to its sign; and behind
  ``at most one x in (0, 1): f == g`` those from the derivative of f - g to ``> 0``.
- ``y > v … using root by residual u == w < 0`` gives the steps from h(v) to its sign, where y is
  the only root of h that ``root`` defines; so y lies above v or below it.
- ``f == O(g) as x -> oo … dominated by one, two`` names a bound of |f| by a multiple of a function
  of what tends to its limit, or bounds of f from above and from below.
- The lines of prose directly below a claim are its note. Those beginning with ``> says:``,
  ``> paper:``, ``> shown:``, ``> kind:``, ``> fault:``, ``> assumed:`` and ``> quotes:`` give the
  sentence whose formula the claim is, what the paper prints, the LaTeX of a formula that is hard to
  read, the kind, what is wrong with the paper, what an assumption is called, and the theorems that
  the claim rests on. ``> constant: 2 of g`` is the constant of a bound ``f <= 2*g``, and ``> rests
  on: …`` names claims that are not put in. ``> prints: …`` is the formula as the paper prints it;
  an order of which a bound is decided says how it follows from the bound, ``> prints: f == g + O(x)
  as x -> 0, with a, b fixed, where u == v``.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from tresym.ledger.axioms import Axiom
from tresym.ledger.claim import (
    Chain,
    Claim,
    Counterexample,
    Definition,
    Dominated,
    Evidence,
    Fault,
    Follows,
    Instance,
    Monotone,
    Place,
    Printed,
    Reason,
    Root,
    RootBound,
    RootMonotone,
    Step,
    in_words,
    jointly,
)
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, Charts
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.evidence.remainders import Remainder
from tresym.ledger.evidence.sign_prover import shortened
from tresym.ledger.formulas import (
    Condition,
    EqualMatrices,
    Rounded,
    Says,
    Tending,
    Under,
    in_order,
    in_trees,
    is_bound,
    is_equation,
    mapped,
    names_of,
    parts_of,
    sides_of,
    together,
)
from tresym.ledger.reasons import (
    changing_variable,
    collecting,
    cutting,
    differentiating_integral,
    integrating,
    substituting,
)
from tresym.papers.definitions import PREFIX
from tresym.papers.definitions import Definition as Abbreviation
from tresym.papers.matrices import Matrices, Matrix, MatrixFunction, entries
from tresym.papers.reading import CLAUSE, DEFINED, OwnPaper, Reader, clauses_of, near
from tresym.papers.ways_to_show import Line, way_to_show
from tresym.reals.language.brackets import closing, encloses, places, split
from tresym.reals.language.claims import Written
from tresym.reals.language.compound import (
    Count,
    Equivalent,
    Formula,
    Shape,
    Somewhere,
    Together,
    read_compound,
)
from tresym.reals.language.compound import (
    mapped as compound_mapped,
)
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    Expr,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
    trees,
)
from tresym.reals.language.formula import Compared, Relation
from tresym.reals.language.named_claims import Conserved, Equilibrium, Extremum
from tresym.reals.language.parsing import as_written, parse_claim, parse_given
from tresym.reals.language.paths import read_path
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError, parse_number
from tresym.reals.verdict import Verdict

OWN = {"E": "E_", "lambda": "lambda_"}
"""Symbols that the grammar gives another meaning, and what they are called while it reads."""
_SIGNS = ("==", "!=", "<", "<=", ">", ">=")
_COUNTED = ("exactly one", "at most one")
_SHAPES = ("increasing", "decreasing")
_EQUILIBRIA = ("stable", "unstable")
_CLAUSES = ("given", "using", "knowing", "expect", "at", "instead", "as")
_HINTS = ("with", "by slope", "by residual", "dominated by", "shown by")
"""Clauses that name the method by which a claim is shown."""
_REMARK = re.compile(
    r"(says|prints|constant|rests on|paper|shown|kind|fault|assumed|quotes)\s*:\s*(.*)",
    re.DOTALL,
)
_SIGN = r"(?<![<>=!~:])(?:==|<=|>=|!=|<|>)(?![=<>])"
_PRINTED = re.compile(r"(.*?)~=\s*([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)(\s+within\s+one\s+unit)?\s*")
_INFIMUM = re.compile(r"infimum\((.+)\)\s*==\s*([^=]+)")
_IN_WORDS = re.compile(r"in\s+words,\s+from\s+(.*)", re.DOTALL)
_ORDER = re.compile(
    r"(.*?)\s+as\s+(\w+)\s*->\s*0\s*(?:,\s*with\s+(.*?)\s+fixed)?(?:,\s*where\s+(.*))?", re.DOTALL
)
_BECAUSE = re.compile(r"(.*\S)\s+\[([^\[\]]*)\]\s*", re.DOTALL)
_RULE = re.compile(r"(?:[^\W\d]\w*\s*=(?!=)|(cut\s+at|antiderivative|inside)\b)\s*(.+)", re.DOTALL)
_RULES = {
    None: changing_variable,
    "cut": cutting,
    "antiderivative": integrating,
    "inside": differentiating_integral,
}
_ROOT = re.compile(r"root\s+of\s+([\w-]+)")
_PLACE = re.compile(r"(\d+)|(?:(line|display)\s+(\d+))?(?:(?:^|,\s*)cell\s+(.+))?")


@dataclass(frozen=True)
class Part:
    """A part of a paper that a file states; its claims are attributes, as those of a module.

    Attributes:
        title: its title.
        claims: its claims by label, in order.
        named: its conditions with a name.
        shorthands: the expressions and matrices that it abbreviates, by name.
        lines: the first and the last line of each claim in the file, by label.
    """

    title: str
    claims: Mapping[str, Claim]
    named: Mapping[str, tuple[Condition, ...]]
    lines: Mapping[str, tuple[int, int]]
    shorthands: Mapping[str, Any] = field(default_factory=dict)

    @property
    def values(self) -> Mapping[str, Any]:
        """Everything that other parts may use, by name."""
        return {**self.shorthands, **self.named, **self.claims}

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self.values[name]
        except KeyError:
            raise AttributeError(f"{self.title}: nothing is named {name}") from None


def read_part(path: Path, others: Callable[[str], Mapping[str, Any]]) -> Part:
    """Read a file as a part of a paper.

    Args:
        path: the file.
        others: returns what another part of the paper names.

    Raises:
        InputError: a line that cannot be read.

    Example:
        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Path(folder) / "squares.tresym"
        ...     _ = path.write_text("square: (a + b)**2 >= 0 given a > 0")
        ...     read_part(path, lambda name: {}).square
        Claim(square: (a + b)**2 >= 0)
    """
    text = path.read_text(encoding="utf-8")
    reader = PartReader(path, others, text)
    found = reader.read(text)
    if found.problems:
        first = found.problems[0]
        raise InputError(f"{path.name}:{first.line}:{first.column}: {first.message}")
    made = {d.name: _own(d.expression) for d in found.definitions.values() if not d.parameters}
    made |= reader.matrices.known
    return Part(found.title, reader.own, reader.named, reader.lines, made)


@dataclass
class _Waiting:
    """A claim that was read, until all the prose below it is known."""

    label: str
    end: int
    """The last line that belongs to it."""
    fields: dict[str, Any]
    note: list[str] = field(default_factory=list)


class PartReader(Reader):
    """Read each line as it is in any file, but make claims of the ledger of it."""

    clause = rf"\s(?:{'|'.join(('knowing', *_HINTS))})\s+|{CLAUSE}".replace(" ", r"\s+")

    def __init__(self, path: Path, others: Callable[[str], Mapping[str, Any]], text: str) -> None:
        super().__init__(path.name, path.parent)
        self.others = others
        self.written = text.split("\n")
        self.stated: dict[str, Claim] = {}
        """All claims that may be used here, by label."""
        self.own: dict[str, Claim] = {}
        self.named: dict[str, tuple[Condition, ...]] = {}
        self.axioms: dict[str, Axiom] = {}
        """Theorems that claims may quote."""
        self.charts: dict[str, Charts] = {}
        """Stored charts, by name."""
        self.lines: dict[str, tuple[int, int]] = {}
        self.vectors: dict[str, int] = {}
        """Functions whose value is a vector, and the number of its components."""
        self.waiting: _Waiting | None = None
        self.matrices = Matrices(self._entry)

    def read(self, text: str) -> OwnPaper:
        """Read the whole file."""
        found = super().read(text)
        self.finish()
        return found

    # How a line is read again with a change (:mod:`tresym.papers.changed_lines`)

    def state(self, line: int, text: str) -> None:
        """Read the statement that begins on a line."""
        self._statement(line, text)

    def reaches(self, line: int) -> bool:
        """Return whether a line belongs to the claim that was read last."""
        return self.waiting is not None and line <= self.waiting.end

    def finished(self, label: str) -> Claim:
        """Return the claim with this label, with all that was read below it.

        Raises:
            InputError: no claim was made of the line.
        """
        self.finish()
        if label not in self.own:
            raise InputError(f"{label} is no claim")
        return self.own[label]

    def parsed(self, text: str) -> Expr:
        """Return an expression as it stands, with the names that are used while it is read.

        Raises:
            InputError: the text is no expression.
        """
        return as_written(plain(self._called(text)))

    def printed(self, e: Expr) -> str:
        """Return an expression as text, with names as they are written in the file."""
        text = re.sub(rf"\b{PREFIX}(?=\w+\()", "", str(e))
        for name, there in OWN.items():
            text = re.sub(rf"\b{there}(?!\w)", name, text) if name in self.declared else text
        return text

    def forked(self) -> PartReader:
        """Return a reader that has read the same lines, and reads on by itself."""
        made = copy(self)
        for name, value in vars(self).items():
            if isinstance(value, dict | list | set):
                setattr(made, name, copy(value))
        made.matrices = Matrices(made._entry, dict(self.matrices.known))
        return made

    def _end(self, line: int) -> int:
        """The last line of the statement that begins on a line."""
        while line < len(self.written) and self.written[line][:1] in (" ", "\t"):
            if not self.written[line].strip():
                break
            line += 1
        return line

    # What is said of a claim beside its formula

    def _prose(self, line: int, text: str) -> None:
        waiting = self.waiting
        if waiting is None or line != waiting.end + 1:
            super()._prose(line, text)
            return
        waiting.end = self._end(line)
        first, _ = self.lines[waiting.label]
        self.lines[waiting.label] = first, waiting.end
        match = _REMARK.fullmatch(text)
        if match is None:
            waiting.note.append(text)
        elif match[1] == "says":
            means = waiting.fields.get("says")
            waiting.fields |= {"says": match[2]} | ({} if means is None else {"means": means})
        elif match[1] == "prints":
            self._prints(waiting.fields, match[2])
        elif match[1] == "rests on":
            proof = waiting.fields["proof"]
            if not isinstance(proof, Decided | Charted):
                raise InputError("'rests on' stands below a claim that the engine or charts decide")
            also = (*proof.also, *self._found(match[2]))
            waiting.fields["proof"] = replace(proof, also=also)
        elif match[1] == "constant":
            waiting.fields["proof"] = self._with_constant(waiting.fields, match[2])
        elif match[1] == "fault":
            faults = {fault.name.lower(): fault for fault in Fault}
            if match[2] not in faults:
                raise InputError(f"'{match[2]}' is not one of {', '.join(faults)}")
            waiting.fields["fault"] = faults[match[2]]
        elif match[1] == "quotes":
            waiting.fields["quotes"] = tuple(map(self._axiom, match[2].split(",")))
        elif match[1] == "assumed":
            waiting.fields["proof"] = Definition(match[2])
        else:
            waiting.fields[{"paper": "paper_says"}.get(match[1], match[1])] = match[2]

    def _prints(self, fields: dict[str, Any], text: str) -> None:
        """Take the formula that the paper prints, and how its order follows from a bound.

        Behind ``as x -> 0`` stand the symbols that do not vary, and what others mean.
        """
        if "means" in fields:
            raise InputError("the claim has a sentence or a printed formula above this line")
        match = _ORDER.fullmatch(text)
        fields |= {"says": self._says(match[1] if match else text), "means": fields["says"]}
        if match is None:
            return
        names = map(str.strip, (match[3] or "").split(","))
        held = tuple(name for name in names if name)
        meant = [self._says(part.strip()) for part in split(match[4] or "", ",") if part]
        if not all(isinstance(part, Relation) and part.sign == "==" for part in meant):
            raise InputError("what a symbol means is an equation: write where u == v")
        reading = tuple((part.left, part.right) for part in meant)
        remainder = Remainder(match[2], held, reading)
        proof = fields["proof"]
        if isinstance(proof, Boxes) and proof.meant is not None:
            fields["proof"] = replace(proof, meant=replace(proof.meant, remainder=remainder))
        elif isinstance(proof, Decided | Charted):
            fields["proof"] = replace(proof, remainder=remainder)
        else:
            raise InputError("'as' behind what is printed is for a bound that is decided")

    def _with_constant(self, fields: dict[str, Any], text: str) -> Evidence:
        """Evidence for a bound with the constant that is printed, ``2 of GAUGE``."""
        written, _, rest = text.partition(" of ")
        constant, gauge = parse_number(written), self._expression(rest) if rest else ONE
        size = in_order(number(constant) * gauge)
        proof, stated = fields["proof"], sides_of(fields.get("means", fields["says"]))
        if not isinstance(proof, Decided | Charted | Boxes) or size not in stated:
            raise InputError(f"the statement contains no bound {text}")
        if isinstance(proof, Decided):
            return replace(proof, constant=constant, gauge=gauge)
        return replace(proof, constant=constant)

    def _axiom(self, name: str) -> Axiom:
        if name.strip() not in self.axioms:
            raise InputError(f"{name.strip()} is no theorem: write use NAME from axioms")
        return self.axioms[name.strip()]

    def _state(self, line: int, label: str, place: str, fields: dict[str, Any]) -> None:
        self.waiting = _Waiting(label, self._end(line), {**fields, "where": _place(place)})
        self.lines[label] = line, self.waiting.end

    def finish(self) -> None:
        """Make a claim of what was read last."""
        if self.waiting is not None:
            waiting, self.waiting = self.waiting, None
            if "says" not in waiting.fields:
                raise InputError(f"{waiting.label} needs its sentence below it: > says: …")
            claim = Claim(waiting.label, note=" ".join(waiting.note), **waiting.fields)
            self.stated[waiting.label] = self.own[waiting.label] = claim

    def _statement(self, line: int, text: str) -> None:
        if self.waiting is not None and line > self.waiting.end + 1:
            self.finish()
        match = DEFINED.fullmatch(text)
        if match is not None and not text.startswith(">") and self.matrices.stand_in(match[3]):
            self._define_matrix(line, match[1], match[2], match[3])
            return
        super()._statement(line, text)

    # Names

    def _need_new(self, name: str) -> None:
        if name not in {*OWN, "gamma"} or name in self.declared:
            super()._need_new(name)

    def _need_known(self, names: Iterable[str], more: Iterable[str] = ()) -> None:
        own = {there for name, there in OWN.items() if name in self.declared or name == "lambda"}
        super()._need_known({*names} - own, more)

    def _called(self, text: str) -> str:
        for name, there in OWN.items():
            if name in self.declared:
                text = re.sub(rf"(?<![\w\\]){name}(?!\w)", there, text)
        for name, size in self.vectors.items():
            text = _by_components(text, name, size)
        return super()._called(text)

    def _need_new_label(self, label: str) -> None:
        self.finish()
        if label in self.lines:
            raise InputError(f"{label} is the label of line {self.lines[label][0]} already")

    def _use(self, line: int, names: Iterable[str], file: str) -> None:
        self.finish()
        known = self.others(file)
        for name in names:
            if name not in known:
                raise InputError(f"{name} is not in {file}{near(name, known)}")
            value = known[name]
            if isinstance(value, Axiom):
                self.axioms[name] = value
            elif isinstance(value, Matrix | MatrixFunction):
                self.matrices.known[name] = value
            elif isinstance(value, Charts):
                self.charts[name] = value
            elif isinstance(value, Claim):
                self.stated[name] = self.stated[value.label] = value
            elif isinstance(value, Expr):
                self._abbreviate(line, name, (), value)
            elif isinstance(value, tuple):
                self.named[name] = tuple(map(in_trees, value))
            elif callable(value):
                self._take_function(line, name, value)
            else:
                raise InputError(f"{name} of {file} is neither a claim nor an expression")

    def _abbreviate(self, line: int, name: str, parameters: tuple[str, ...], e: Expr) -> None:
        self.definitions[name] = Abbreviation(line, name, parameters, str(e), e, e)

    def _take_function(self, line: int, name: str, function: Callable[..., Any]) -> None:
        """Take a formula that programs run, as a function of the same arguments."""
        asked = [p for p in inspect.signature(function).parameters if p != "m"]
        made = function(*map(symbol, asked), **_arithmetic(function))
        if isinstance(made, tuple):
            self.vectors[name] = len(made)
            for n, part in enumerate(made, 1):
                self._abbreviate(line, f"{name}_{n}", tuple(asked), part)
        else:
            self._abbreviate(line, name, tuple(asked), made)

    def _labelled(self, *labels: str) -> tuple[Claim, ...]:
        """The claims with these labels."""
        return tuple(self._found(", ".join(labels)))

    def _found(self, names: str) -> list[Claim]:
        found = []
        for name in filter(None, map(str.strip, split(names, ","))):
            if name not in self.stated:
                raise InputError(
                    f"no claim above this line is labelled '{name}'{near(name, self.stated)}"
                )
            found.append(self.stated[name])
        return found

    def _claim_above(self, label: str) -> Claim:
        found = self._found(label)
        if len(found) != 1:
            raise InputError(f"'{label}' is not the label of one claim")
        return found[0]

    def _expression(self, text: str) -> Expr:
        return _own(self._tree(text))

    # Claims

    def _lets_in(self, clauses: dict[str, str]) -> list[Any]:
        return []

    def _let(self, line: int, label: str, place: str, written: str) -> None:
        self._need_new_label(label)
        equations: list[Relation] = []
        given: list[Condition] = []
        proof: Evidence = Definition()
        for part in map(str.strip, split(written, ",")):
            match = DEFINED.fullmatch(part)
            if match is None:
                given += self._given(part)
                continue
            if match[2] is not None:
                raise InputError(f"'{match[1]}' is a function: write it on a line of its own")
            name = OWN.get(match[1], match[1])
            if root := self._root(name, match[3]):
                proof = root
                equations += root.says.parts
            else:
                equations.append(self._relation((symbol(name), "==", self._tree(match[3]))))
        if isinstance(proof, Root) and len(equations) != len(proof.says.parts):
            raise InputError("a root is defined on a line of its own")
        if equations:
            bounds = tuple(c for c in given if isinstance(c, Relation) and c.sign != "==")
            if not isinstance(proof, Root):
                equations = [mapped(equation, partial(_short, bounds)) for equation in equations]
            fields = {"says": together(equations), "given": tuple(given), "proof": proof}
            self._state(line, label, place, fields)
        else:
            self.named[label] = tuple(given)

    def _root(self, name: str, text: str) -> Root | None:
        """What defines a root as the only one of which a claim speaks."""
        match = _ROOT.fullmatch(text)
        if match is None:
            return None
        (unique,) = self._found(match[1])
        says = unique.statement
        if not isinstance(says, Count) or says.how != "exactly one":
            raise InputError(f"{match[1]} does not say that there is exactly one root")
        return Root(_named(name), unique)

    def _claimed(
        self,
        line: int,
        label: str,
        written: str,
        text: str,
        clauses: dict[str, str],
        place: str,
        assumed: bool,
    ) -> None:
        for word in clauses:
            if word not in (*_CLAUSES, *_HINTS):
                raise InputError(f"'{word}' is not read in a paper of the ledger yet")
        uses = self._found(clauses.get("using", ""))
        given = self._given(clauses.get("given", ""))
        instead = tuple(self._found(clauses.get("instead", "")))
        expect = clauses.get("expect", "proved").lower()
        if expect not in ("proved", "refuted", "enclosed") or (assumed and "expect" in clauses):
            raise InputError(f"'{expect}': expect refuted, or expect enclosed")
        fields: dict[str, Any] = {"amended_by": instead} if instead else {}
        if match := _IN_WORDS.fullmatch(text):
            denied = expect == "refuted" and "at" in clauses
            if clauses.keys() - ({"instead", "expect", "at"} if denied else {"instead"}) or assumed:
                raise InputError(
                    "a sentence in words has no clauses but expect refuted at …: the claims behind "
                    "it do"
                )
            behind = self._found(match[1])
            proof = Denied((*behind,), _point(clauses["at"])) if denied else in_words(*behind)
            self._state(line, label, place, {"proof": proof, **fields})
            return
        parts = [part.strip() for part in split(text, r"\band\b")]
        if all(part in self.stated for part in parts):
            if given or uses:
                raise InputError("a claim of claims has their conditions, and no others")
            self._state(
                line, label, place, {**jointly(*(self.stated[part] for part in parts)), **fields}
            )
            return
        says = self._says(text)
        if "as" in clauses:
            says = self._tending(says, clauses["as"])
        steps = self._steps(self._clause_free(written), says, uses)
        given = [*self._declared_about((says, *given)), *given]
        bounds = tuple(c for c in given if isinstance(c, Relation) and c.sign != "==")
        short = partial(_short, bounds)
        if not any(isinstance(part, EqualMatrices) for part in parts_of(says)):
            says = mapped(says, short)  # what is written out stays so
        steps = tuple(
            tuple(replace(k, expression=mapped(k.expression, short)) for k in chain)
            for chain in steps
        )
        fields |= {"says": says, "given": tuple(given)}
        at = clauses.get("at", "")
        along, beside = self._along(at) if at and isinstance(says, Tending) else ({}, None)
        values = {} if along else _point(at)
        if at and expect != "refuted":
            raise InputError("'at' names a point at which a claim fails: expect refuted at x == 1")
        if assumed:
            fields["proof"] = Definition("it is assumed")
        elif along:
            fields |= {
                "proof": Asymptotics(along, beside, tuple(uses)),
                "expect": Verdict.REFUTED,
            }
        else:
            shown = self._shown(label, written, (says, *given), uses)
            if shown is not None and (values or steps):
                raise InputError("what is shown by a method has no steps, and no point")
            fields["proof"] = shown or _evidence(uses, (says, *given), steps, values)
            facts = self._facts(clauses.get("knowing", ""))
            if facts and not isinstance(fields["proof"], Decided | Monotone):
                raise InputError("'knowing' names what the engine is to show first")
            fields["knowing"] = facts
            if shown is None or "expect" in clauses:
                fields["expect"] = _expected(expect, fields["proof"], uses)
        self._state(line, label, place, fields)

    def _facts(self, text: str) -> tuple[Says, ...]:
        """Inequalities, each of which may have conditions of its own."""
        return tuple(self._says(part.strip()) for part in split(text, ",") if part.strip())

    def _clause_free(self, written: str) -> str:
        """The formula of a claim with the words in brackets behind its steps."""
        return clauses_of(written, self.clause)[0]

    def _shown(
        self, label: str, written: str, stated: tuple[Any, ...], uses: list[Claim]
    ) -> Evidence | None:
        """The evidence of a method that the claim names; None if it names none."""
        clauses = clauses_of(written, self.clause)[1]
        named = [word for word in _HINTS if word in clauses]
        if not named:
            return None
        refuted = clauses.get("expect", "").lower() == "refuted"
        if len(named) > 1 or (refuted and named[0] != "shown by"):
            raise InputError(f"'{named[-1]}' names a method: write one, of a claim that holds")
        text = clauses[named[0]]
        if named[0] == "with":
            return self._instance(text, uses)
        if named[0] == "by residual":
            return self._by_residual(text, stated[0], uses)
        if named[0] == "shown by":
            proof = _evidence(uses, stated, (), {})
            line = Line(
                label,
                tuple(uses),
                self._claim_above,
                self._expression,
                self._given,
                stated,
                proof if isinstance(proof, Decided) else Decided(),
                self.charts,
            )
            return way_to_show(text, line)
        if named[0] == "dominated by":
            return Dominated(*self._found(text))
        return self._by_slope(text, stated[0], uses)

    def _instance(self, text: str, uses: list[Claim]) -> Evidence:
        """The first claim that is used, with values for its variables; others are cited."""
        if not uses:
            raise InputError("'with' gives values to variables of a claim: write using LABEL with")
        links = [self._expanded(link) for link in parse_given(plain(self._called(text)))]
        if any(left.op != "symbol" or sign != "==" for left, sign, _ in links):
            raise InputError(f"'{text}': write with x == 1/a, y == a + b")
        values = tuple((_named(str(left)), _own(right)) for left, _, right in links)
        return Instance(uses[0], values, tuple(uses[1:]))

    def _by_slope(self, text: str, says: Says, uses: list[Claim]) -> Evidence:
        """For each part, that a root is monotone by the sign of a slope, which steps lead to."""
        if isinstance(says, Count) and says.how == "at most one":
            return Monotone(self._signed(text, says, uses))
        root = next((claim for claim in uses if isinstance(claim.proof, Root)), None)
        if root is None or not all(isinstance(part, Shape) for part in parts_of(says)):
            raise InputError("'by slope' shows that a root is increasing or decreasing; use it")
        slopes = [self._signed(part, says, uses) for part in split(text, r"\band\b")]
        found = [RootMonotone(root, slope) for slope in slopes]
        return found[0] if len(found) == 1 else Follows(tuple(found))

    def _by_residual(self, text: str, says: Says, uses: list[Claim]) -> Evidence:
        """A bound on a root by the sign of the function there, to which steps lead."""
        root = next((claim for claim in uses if isinstance(claim.proof, Root)), None)
        if root is None:
            raise InputError("'by residual' shows a bound on a root: use its definition")
        others = [claim for claim in uses if claim is not root]
        return RootBound(root, self._signed(text, says, others))

    def _signed(self, text: str, says: Says, uses: list[Claim]) -> Evidence:
        """The steps ``u == v > 0`` from an expression to its sign."""
        stages = [stage.strip() for stage in split(text, _SIGN)]
        signs = [text[a:b] for a, b in places(text, _SIGN)]
        if signs[-1:] not in ([">"], ["<"]) or {*signs[:-1]} - {"=="} or stages[-1] != "0":
            raise InputError(f"'{text}': write u == v > 0")
        chain = []
        for stage in stages[:-1]:
            shown, why = self._because(stage, uses)
            chain.append(Step(self._expression(shown), why))
        return _evidence(uses, (says,), ((*chain, Step(None, ())),), {})

    def _given(self, text: str) -> list[Condition]:
        """The conditions of a text: those with a name, printed inputs and comparisons."""
        found: list[Condition] = []
        for part in filter(None, map(str.strip, split(text, ","))):
            if part in self.named:
                found += self.named[part]
            elif (match := _PRINTED.fullmatch(part)) and not match[3]:
                found.append(Rounded(self._expression(match[1]), match[2]))
            else:
                found += map(self._relation, parse_given(plain(self._called(part))))
        return found

    def _declared_about(self, written: tuple[Any, ...]) -> list[Condition]:
        """The declared conditions about the variables of a claim, and about those of conditions."""
        names = names_of(*written)
        left = [self._relation(link) for link in self.given]
        found: list[Condition] = []
        while new := [c for c in left if names & names_of(c)]:
            names |= names_of(*new)
            left = [c for c in left if c not in new]
            found += [c for c in new if c not in written]
        return found

    def _says(self, text: str) -> Any:
        """The statement of a text; the chain ``a == b >= c`` states that a >= c."""
        if match := _PRINTED.fullmatch(text):
            return Rounded(self._expression(match[1]), match[2], 2 if match[3] else 1)
        if match := _INFIMUM.fullmatch(text):
            function, value = map(self._expression, match.groups())
            return Extremum("infimum", function, (), value, ())
        if encloses(text) and (parts := split(text[1:-1], r"\bgiven\b"))[1:]:
            return Under(self._says(parts[0].strip()), tuple(self._given(parts[1])))
        if self.matrices.stand_in(text):
            return self._of_matrices(text)
        pieces = [part.strip() for part in split(text, r"\band\b")]
        if len(pieces) > 1 and any(map(_ends_in_an_order, pieces)):
            return Together(tuple(part for each in pieces for part in parts_of(self._says(each))))
        whole = read_compound(self._called(text))
        if whole is not None:
            return self._formula_of(compound_mapped(whole.formula, self._put))
        links = [self._expanded(link) for link in parse_claim(plain(self._called(text)))]
        links = list(_derived(links))
        return together(map(self._relation, links))

    def _define_matrix(self, line: int, name: str, arguments: str | None, text: str) -> None:
        self._need_new(name)
        if name in self.matrices.known:
            raise InputError(f"{name} is a matrix already")
        if arguments is None:
            found = self.matrices.known[name] = self.matrices.read(text)
            for entry, value in entries(name, found):
                self._abbreviate(line, entry, (), value)
            return
        names = [argument.strip() for argument in arguments.split(",")]
        within = replace(self.matrices, scalar=lambda e: self._entry(e, names))
        parameters = tuple(map(_named, names))
        self.matrices.known[name] = MatrixFunction(parameters, within.read(text))

    def _entry(self, text: str, parameters: Sequence[str] = ()) -> Expr:
        """A number that stands in an expression with matrices."""
        e = as_written(plain(self._called(text)))
        self._need_known(symbols(e) - {*parameters})
        put = self._put(e)
        self._need_functions((put,))
        return _own(put)

    def _of_matrices(self, text: str) -> Any:
        """Equations of matrices, beside other claims."""
        found: list[Any] = []
        for part in map(str.strip, split(text, r"\band\b")):
            if not self.matrices.stand_in(part):
                found += parts_of(self._says(part))
                continue
            sides = [self.matrices.read(side) for side in split(part, _SIGN)]
            if len(sides) != 2 or len(split(part, "==")) != 2:
                raise InputError(f"'{part}': matrices are compared by one equation A == B")
            if sides[0].shape != sides[1].shape:
                raise InputError(f"'{part}': {sides[0].shape} and {sides[1].shape} do not fit")
            found.append(EqualMatrices(*(side.mapped(in_order).rows for side in sides)))
        return together(found)

    def _along(self, text: str) -> tuple[dict[str, Expr], Relation | None]:
        """A curve ``x == t, y == -t`` along which an order fails as t tends to 0 from above.

        The inequality ``y < t**2`` compares a root with a value on the curve.
        """
        links = [self._expanded(link) for link in parse_given(plain(self._called(text)))]
        beside = [self._relation(link) for link in links if link[1] in ("<", ">")]
        along = [link for link in links if link[1] not in ("<", ">")]
        if any(left.op != "symbol" or sign != "==" for left, sign, _ in along) or beside[1:]:
            raise InputError(f"'{text}': write at x == t, y == -t, with t -> 0+")
        return {_named(str(left)): _own(right) for left, _, right in along}, (*beside, None)[0]

    def _tending(self, says: Any, path: str) -> Tending:
        """An order along a path."""
        if not isinstance(says, Relation) or says.sign != "==":
            raise InputError("an order along a path is an equation, such as f == O(g) as x -> oo")
        read = mapped(read_path(self._called(path)), _own)
        names = tuple(map(_named, read.together))
        return Tending(says, replace(read, name=_named(read.name), together=names))

    def _steps(self, text: str, says: Any, uses: list[Claim]) -> tuple[Chain, ...]:
        """The derivations of a text, one for each part; the claims that steps name are used.

        There are none if each part has one step, and none of them names a claim.
        """
        chains: list[Chain] = []
        if isinstance(says, Equivalent):
            return self._equivalences(text, uses)
        if not all(isinstance(part, Relation | EqualMatrices) for part in parts_of(says)):
            return ()
        for part in split(text, r"\band\b"):
            _, *stages = split(part, _SIGN)
            signs = [part[a:b] for a, b in places(part, _SIGN)]
            if any(sign != "==" for sign in signs[:-1]):
                return ()
            chain = []
            for n, stage in enumerate(stages, 1):
                shown, why = self._because(stage, uses)
                last = n == len(stages)
                chain.append(Step(None if last else self._expression(shown), why))
            chains.append(tuple(chain))
        derived = any(len(chain) > 1 or any(link.reasons for link in chain) for chain in chains)
        if derived and len(chains) != len(parts_of(says)):
            raise InputError("the steps of a vector are not read: write one equation a component")
        return tuple(chains) if derived else ()

    def _because(self, stage: str, uses: list[Claim]) -> tuple[str, tuple[Reason, ...]]:
        """A step without the words in brackets behind it, and the reason that they give."""
        match = _BECAUSE.fullmatch(stage)
        if match is None:
            return stage, ()
        words = [word.strip() for word in split(match[2], ",")]
        named = [self.stated[word] for word in words if word in self.stated]
        uses += [claim for claim in named if claim not in uses]
        reasons = [substituting(*named)] if named else []
        bounds = [claim for claim in named if all(map(is_bound, claim.parts))]
        reasons += [collecting() for word in words if word == "one integral"]
        reasons += [
            _RULES[rule[1] and rule[1].split()[0]](self._expression(rule[2]), *bounds)
            for rule in map(_RULE.fullmatch, words)
            if rule is not None
        ]
        return match[1], tuple(reasons) or (Reason(match[2]),)

    def _equivalences(self, text: str, uses: list[Claim]) -> tuple[Chain, ...]:
        """The steps of a chain of equations, each of which is equivalent to the one before."""
        chain = []
        _, *stages = split(text, r"<=>|\biff\b")
        for stage in stages:
            shown, why = self._because(stage, uses)
            chain.append(Step(self._says(shown.strip()), why))
        return (tuple(chain),) if len(chain) > 1 or chain[0].reasons else ()

    def _formula_of(self, formula: Formula) -> Any:
        """A claim made of others as a statement of the ledger."""
        if isinstance(formula, Together):
            parts = (part for f in formula.parts for part in parts_of(self._formula_of(f)))
            return Together(tuple(parts))
        if isinstance(formula, Equivalent):
            first, *_, last = map(self._formula_of, formula.parts)
            return Equivalent((first, last))
        if isinstance(formula, Written):
            if formula.path is not None:
                raise InputError("a path stands at the end of a claim, for all of it")
            says = together(map(self._relation, _derived(formula.comparisons)))
            given = tuple(map(self._relation, formula.given))
            return Under(says, given) if given else says
        known = {Count: _COUNTED, Shape: _SHAPES, Equilibrium: _EQUILIBRIA}
        fits = isinstance(formula, Somewhere | Conserved) or formula.how in known.get(
            type(formula), ()
        )
        if not fits or (isinstance(formula, Count) and any(formula.closed)):
            raise InputError("this form of a claim is not read in a paper of the ledger yet")
        if isinstance(formula, Equilibrium) and formula.by is not None:
            raise InputError("a function after 'by' is not used in a paper of the ledger")
        made: Any = mapped(formula._replace(given=()), self._known)
        if isinstance(made, Count):
            made = made._replace(equation=Relation(*made.equation))
        if isinstance(made, Somewhere):
            made = made._replace(comparisons=tuple(Relation(*c) for c in made.comparisons))
        if hasattr(made, "name"):
            return made._replace(name=_named(made.name))
        return (
            made._replace(names=tuple(map(_named, made.names))) if "names" in made._fields else made
        )

    def _tree(self, text: str) -> Expr:
        e = as_written(plain(self._called(text)))
        self._need_known(symbols(e))
        self._need_functions((put := self._put(e),))
        return put

    def _known(self, e: Expr) -> Expr:
        """An expression of a statement, in the symbols of the ledger."""
        self._need_known(symbols(e))
        self._need_functions((e,))
        return _own(e)

    def _relation(self, link: Compared) -> Relation:
        left, sign, right = self._expanded(link)
        if sign not in _SIGNS:
            raise InputError(f"'{sign}' is not read in a paper of the ledger yet")
        return Relation(self._known(left), sign, self._known(right))


def _by_components(text: str, name: str, size: int) -> str:
    """The text with each value of a function as a vector of its components.

    Example:
        >>> _by_components("(x, y) == f(a, b)", "f", 2)
        '(x, y) == (f_1(a, b), f_2(a, b))'
    """
    found = ""
    while match := re.search(rf"(?<![\w\\]){name}\s*(?=\()", text):
        end = closing(text[match.end() :])
        if end is None:
            break
        inside = text[match.end() : match.end() + end + 1]
        components = ", ".join(f"{name}_{n}{inside}" for n in range(1, size + 1))
        found += f"{text[: match.start()]}({components})"
        text = text[match.end() + end + 1 :]
    return found + text


def _ends_in_an_order(text: str) -> bool:
    """Whether a text is a chain such as ``a == b >= c``."""
    first, *signs = [text[start:end] for start, end in places(text, _SIGN)] or [""]
    return first == "==" and signs[-1:] not in ([], ["=="])


def _derived(links: Sequence[Compared]) -> tuple[Compared, ...]:
    """The relation of first and last side, where all signs but the last are those of equality."""
    if any(sign != "==" for _, sign, _ in links[:-1]):
        return tuple(links)
    return ((links[0][0], links[-1][1], links[-1][2]),)


_OWN_SYMBOLS = {there: symbol(name) for name, there in OWN.items()}
_OWN_NAMES = {there: name for name, there in OWN.items()}


def _own(e: Expr) -> Expr:
    """An expression in the symbols of the ledger, its terms and factors in one order."""
    return in_order(_bound_as_named(substitute(e, _OWN_SYMBOLS)))


def _bound_as_named(e: Expr) -> Expr:
    """An expression with the names in the ledger for the variables that are bound in it."""
    if e.op in LEAVES or not e.hidden:
        return e
    args = tuple(map(_bound_as_named, e.args))
    return Expr(e.op, args, tuple(map(_named, e.names))) if e.names else rebuild(e, args)


def _short(given: tuple[Relation, ...], e: Expr) -> Expr:
    """An expression that the conditions allow to be written shorter."""
    return in_order(shortened(e, given))


def _named(name: str) -> str:
    return _OWN_NAMES.get(name, name)


def _arithmetic(function: Callable[..., Any]) -> dict[str, Any]:
    return {"m": trees} if "m" in inspect.signature(function).parameters else {}


def _place(text: str) -> Place | None:
    if not text:
        return None
    match = _PLACE.fullmatch(text)
    if match is None:
        raise InputError(f"'{text}' is not a place: write (12), [line 320] or [line 3, cell NAME]")
    if match[1] or match[2] == "display":
        return Place(display=int(match[1] or match[3]), cell=match[4])
    return Place(line=int(match[3]) if match[3] else None, cell=match[4])


def _point(text: str) -> dict[str, Any]:
    """The values of ``x == 1, y == 1/2``."""
    found = {}
    for left, sign, right in parse_given(plain(text)) if text else ():
        if left.op != "symbol" or sign != "==" or right.op != "number":
            raise InputError(f"'{text}': write at x == 1/5, y == 2")
        found[str(left.args[0])] = right.args[0]
    return found


def _evidence(
    uses: list[Claim],
    written: tuple[Any, ...],
    steps: tuple[Chain, ...],
    values: Mapping[str, Any],
) -> Evidence:
    """How a claim is judged: by a point, as a printed number, or by the engine."""
    if values:
        return Counterexample(values, tuple(uses))
    if any(isinstance(e, Rounded) for e in written):
        return Printed(tuple(uses))
    named = [[c for link in chain for r in link.reasons for c in r.claims] for chain in steps]
    single = len(steps) > 1 and all(map(len, named)) and {*map(len, steps)} == {1}
    if single and not any(map(is_equation, parts_of(written[0]))):
        rest = [c for c in uses if not any(c in claims for claims in named)]
        return Follows(tuple(_evidence([*of, *rest], written, (), {}) for of in named))
    put, cited, also = [], [], []
    for claim in uses:
        parts = claim.parts if claim.in_formulas else ()
        put += [claim] if any(map(is_equation, parts)) else []
        cited += [claim] if not all(map(is_equation, parts)) else []
        also += [] if parts else [claim]
    return Decided(tuple(put), tuple(cited), also=tuple(also), steps=steps)


def _expected(word: str, proof: Evidence, uses: list[Claim]) -> Any:
    if word == "refuted":
        return Verdict.REFUTED
    if isinstance(proof, Printed | Evaluated | Charted | Boxes) or word == "enclosed":
        return Verdict.ENCLOSED
    if isinstance(proof, Dominated):
        uses = [*uses, *proof.claims]
    enclosed = any(claim.expect is Verdict.ENCLOSED for claim in uses)
    return Verdict.ENCLOSED if enclosed else Verdict.PROVED
