"""Print that a quantity is constant along every solution of a system of differential equations.

``Conserved(x² + y², (x, y), (-y, x))`` becomes a theorem about all differentiable functions, in
which a solution is followed for as long as it satisfies the conditions of the claim::

    forall (x y : R -> R) (start stop : R), start <= stop ->
    (forall time, start <= time <= stop ->
      is_derive x time ((fun x y => -y) (x time) (y time)) /\\ ...) ->
    (fun x y => x² + y²) (x stop) (y stop) = (fun x y => x² + y²) (x start) (y start)

The unknowns are functions of the time; the other symbols are numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

from tresym.coq.statement import comparison, condition, term, variable
from tresym.coq.theorem_trees import Condition, Part
from tresym.reals.language.expression import Expr, fresh, symbols


@dataclass(frozen=True)
class Along:
    """Quantities that are constant along the solutions of a system.

    Attributes:
        name: the name of the theorem.
        variables: the symbols that are numbers.
        given: the conditions on these numbers.
        unknowns: the symbols that are functions of the time.
        rates: the derivative of each unknown.
        there: the conditions on the unknowns, which hold as long as the solution is followed.
        defined: what makes the rates and the quantities defined, at every time.
        quantities: what is constant.
    """

    name: str
    variables: tuple[str, ...]
    given: tuple[Condition, ...]
    unknowns: tuple[str, ...]
    rates: tuple[Expr, ...]
    there: tuple[Condition, ...]
    defined: tuple[Part, ...]
    quantities: tuple[Expr, ...]

    @property
    def constants(self) -> tuple[Part, ...]:
        """What makes the terms defined, as far as it is about numbers alone."""
        return tuple(p for p in self.defined if symbols(p[0]).isdisjoint(self.unknowns))

    @property
    def functions(self) -> tuple[str, ...]:
        """The quantities as functions of the time."""
        return tuple(f"(fun t : R => {self.at(term(e), 't')})" for e in self.quantities)

    def at(self, text: str, when: str) -> str:
        """Return a text in the unknowns, at a time."""
        names = " ".join(map(variable, self.unknowns))
        places = " ".join(f"({variable(name)} {when})" for name in self.unknowns)
        return f"(fun {names} : R => {text}) {places}"

    @property
    def body(self) -> str:
        """The proposition as Coq text."""
        names = " ".join(map(variable, self.unknowns))
        taken = {*self.variables, *self.unknowns}
        time, start, stop = (variable(fresh(n, taken)) for n in ("time", "start", "stop"))

        there = (part for part in self.defined if part not in self.constants)
        asked = [*(comparison(*c) for c in self.there), *(condition(*part) for part in there)]
        moves = [self.at(text, time) for text in asked]
        moves += [
            f"is_derive {variable(name)} {time} ({self.at(term(rate), time)})"
            for name, rate in zip(self.unknowns, self.rates, strict=True)
        ]
        same = (f"({self.at(term(e), stop)} = {self.at(term(e), start)})" for e in self.quantities)
        lines = [f"  forall {' '.join(map(variable, self.variables))} : R,"] * bool(self.variables)
        lines += [f"  {comparison(*c)} ->  (* given *)" for c in self.given]
        lines += [f"  {condition(*part)} ->  (* defined *)" for part in self.constants]
        lines += [
            f"  forall ({names} : R -> R) ({start} {stop} : R),",
            f"  {start} <= {stop} ->",
            f"  (forall {time} : R, {start} <= {time} <= {stop} ->",
            "    " + " /\\\n    ".join(moves) + ") ->  (* solution *)",
            "  " + " /\\ ".join(same),
        ]
        return "\n".join(lines)

    @property
    def text(self) -> str:
        """The statement as a sentence of Coq."""
        return f"Theorem {self.name} :\n{self.body}."


def constancy(whole: Along) -> str:
    """Return a proof to try: the derivative of each quantity along a solution is 0.

    The derivative is worked out with those of the unknowns, and a function whose derivative is 0
    between two times has the same value at both, by the mean value theorem.
    """
    plain = " ".join(
        f"try change (fun x : R => {f} x) with {f}." for f in map(variable, whole.unknowns)
    )
    shown = (
        "{ apply K_0; intros t_0 T_0; pose proof (H_0 t_0 T_0) as S_0; cbv beta in S_0.\n"
        "repeat match goal with H : _ /\\ _ |- _ => destruct H end.\n"
        "auto_derive; [repeat split; first [eexists; eassumption | side] |].\n"
        f"{plain}\n"
        "repeat match goal with D : is_derive _ t_0 _ |- _ => "
        "rewrite ?(is_derive_unique _ _ _ D); clear D end.\n"
        "field; repeat split; side. }"
    )
    first = [f"P_{n}" for n, _ in enumerate((*whole.given, *whole.constants))]
    intros = [*map(variable, whole.variables), *first, *map(variable, whole.unknowns)]
    lines = [
        f"intros {' '.join(intros)} u_0 w_0 L_0 H_0.",
        "assert (K_0 : forall f : R -> R, (forall t : R, u_0 <= t <= w_0 -> is_derive f t 0) -> "
        "f w_0 = f u_0).",
        "{ intros f D_0; destruct (mean_value f (fun _ => 0) u_0 w_0 L_0 D_0) as [c_0 [_ E_0]]; "
        "lra. }",
        *[f"split.\n{shown.replace('K_0;', f'(K_0 {f});')}" for f in whole.functions[:-1]],
        shown.replace("K_0;", f"(K_0 {whole.functions[-1]});"),
    ]
    return "\n".join(lines)
