"""The methods that the account switches off, by area.

Each is named by the function or method that is its entry, without the leading ``tresym.``. Switched
off, it returns what it returns when it finds nothing: None, an undecided answer, False, 0 or no
items.
"""

from pathlib import Path

AREAS: dict[str, tuple[str, ...]] = {
    "reals.signs": (
        *("interior.by_signs_of_parts", "interior.sign_inside", "interior.strict_by_conditions"),
        *("polynomials.sign_of_polynomial", "concavity.sign_by_concavity"),
        *("taylor.sign_by_taylor", "absolute_value_cases.by_cases"),
        *("transformations.by_equivalents", "transformations._logarithms"),
        *("transformations._cleared", "discontinuities.cases_at_jumps"),
        *("structural.Parts._stated", "structural.Parts._by_conditions"),
        *("structural.Parts._in_half_turn", "structural.Parts._algebraic"),
        *("structural.Parts._fraction", "structural.Parts._less", "structural.Parts._polynomial"),
        *("structural.Parts._by_conjugate", "structural.Parts._at_ends"),
        *("structural.Parts._on_box", "structural.Parts._by_factors"),
        *("structural.Parts._known_part", "structural.Parts._sum_sign"),
        "structural.Parts._power_sign",
    ),
    "reals.normal": (
        *("locally_constant.equal_by_derivative", "locally_constant.nonzero_inside"),
        *("locally_constant._algebraic_walls", "locally_constant._gap", "monotone.same_sign"),
        *("constants.algebraic_zero", "constants._log_sum", "constants._atan_sum"),
        *("denesting._denested", "factors.FactoredRing._by_signs", "field.Field._special_atan"),
        *("box.sign_on_box", "box.coefficient_sign", "box.quadratic_sign"),
        *("ranges.ProvingRing._by_facts", "ranges.ProvingRing._by_discriminant"),
        *("ranges.ProvingRing._by_conjugate", "ranges.ProvingRing._by_cases"),
        *("ranges.ProvingRing._over_pi", "sign_equations.SignedRing.learn"),
        "sign_equations.SignedRing.is_mixed",
    ),
    "reals.domain": (
        *("local_search.low_points", "narrow_regions.windows", "newton.points_on"),
        "cylindrical_decomposition.sample_points",
    ),
    "reals.decisions": (
        *("identity._prove", "identity._by_constants", "identity._prove_by_branch"),
        *("identity._at_limits", "identity._at_jumps", "inverse_branches.without_inverse"),
        *("inequalities._constants", "inequalities._apart", "inequalities._sides"),
        *("inequalities._zero_between", "inequalities._at_corners", "inequalities._in_cells"),
        *("inequalities_on_regions.search", "inequalities_on_regions._Search._contact"),
        *("inequalities_on_regions._Search._piece", "variable_reduction.by_one_variable"),
        *("variable_reduction._scaled", "variable_reduction._monotone"),
        *("variable_reduction._of_one_part", "variable_reduction._by_sizes"),
        *("algebraic_witnesses.equal_at_algebraic", "algebraic_witnesses.equal_at_simple"),
        *("readable_witnesses.exact_witness", "integrals.decide_integrals"),
        *("integrals._by_identity", "integrals._infinite", "integrals._by_quadrature"),
        *("integrals._at_parameters", "integrals._without_value", "integrals._of_waves"),
        *("integration_pieces.roots_of_squares", "known_values.known_value"),
        *("integral_rules.Antiderivatives.put_in", "antiderivatives.summed"),
        "integral_rules.decide_by_leibniz",
        *("induction.decide_totals", "induction._induction"),
        *("induction._looked_at", "induction._tends", "hypergeometric.series_of"),
        *("hypergeometric.folded", "hypergeometric.summed", "known_values._from_one"),
        *("known_values._power_series", "known_values._matched"),
        *("known_values._on_both_sides", "power_series.decide_power_series"),
        *("power_series._at_points", "power_series.decide_infinite"),
        *("ellipsis_series.decide_dotted", "ellipsis_series._fitted"),
        *("ellipsis_series._inside_circle", "induction.decide_repeated"),
        *("factorials.decide_factorials",),
        *("integer_variables.decide_whole", "integer_variables._by_divisors"),
        *("integer_variables._by_residues", "integer_variables._beyond"),
        *("equations.decide_under_equations", "equations._without_variables"),
        *("equations._as_consequence", "equations._with_a_point"),
        *("equations._by_elimination", "equations._split", "equations._by_cases"),
        *("equations._with_value", "equation_solutions.solved", "ideals.follows"),
        *("unknown_functions.decide_unknown", "unknown_functions._realised"),
    ),
    "reals.decisions.asymptotics": (
        *("order_claims.decide_order", "order_claims._refutation", "path_claims.decide_tending"),
        *("path_claims._limit", "path_claims._with_parameters", "path_claims._among_integers"),
        *("path_claims._by_residues", "path_claims._at_integers", "path_claims._by_exact_limit"),
        *("path_claims._by_signs", "path_claims._from_somewhere_on"),
        *("recurring_failures.has_no_limit", "recurring_failures.failure_where_waves_return"),
        *("integral_limits.decide_integral_limits", "integral_limits._by_derivatives"),
        *("limit_values.limit_of", "limit_values._squeezed", "limit_values._without_waves"),
        *("leading_terms._leading_terms", "leading_terms._reduced"),
        *("leading_terms._fails_at_a_phase", "numerical_evidence.fails"),
    ),
    "reals.balls": ("simplest_constants.candidates",),
    "ledger": (
        *("judge._judge_chains", "judge._judge_instance", "judge._judge_relations"),
        *("judge._judge_all", "judged_roots.judge_unique_root"),
        *("judged_roots.judge_at_most_one", "judged_roots.judge_implicit_function"),
    ),
    "ledger.evidence": (
        *("asymptotics.failing_order", "asymptotics.judge_squeezed", "chart_bounds.judge_charted"),
        *("interval_evaluation.judge_evaluated", "box_bounds.Boxes.judge"),
        *("printed_numbers.judge_printed", "integrals.sign_of_integral"),
        *("refutation.denied_somewhere", "refutation.Denied.judge"),
    ),
}
"""Areas, which are packages or modules, and the functions in them."""

METHODS = tuple(f"{area}.{name}" for area, names in AREAS.items() for name in names)
"""All methods, by their full names without the leading ``tresym.``."""

_ALONE = Path(__file__).parent / "data" / "alone.txt"
ALONE = dict(
    line.split(": ", 1)
    for line in _ALONE.read_text(encoding="utf-8").splitlines()
    if not line.startswith("#")
)
"""A claim, or the label of one of the ledger, that the method alone decides."""


def reason(name: str) -> str:
    """Why a method is kept that decides fewer than five claims per hundred lines of its own."""
    claim = ALONE.get(name)
    return f"it alone decides `{claim}`" if claim else "no claim is known that it alone decides"
