"""What the paper prints and does not hold: each finding once, the weightiest first.

A finding consists of a quotation from the paper and the labels of the claims that state it; the
first label is the main one. The fault of that claim says what is wrong, and ``amended_by`` lists
the true claims that replace it.
"""

from tresym.ledger.paper import Correction

CORRECTIONS = (
    Correction(
        "The remainder of ε₀",
        "ε₀ = e^{−√(ab)π}(2√(a/(a + b)) e^{−b/√(1 + b/a)} + o(e^{−√(ab)π}))",
        ("d24", "eps0", "prop1"),
        "The appendix replaces arcsin(μ)/λ in the exponent by μ/λ. The next term, μ³/(6λ), is of "
        "the order of λ² = 1/(ab): algebraic, and not exponentially small. On the path of the "
        "witness the omitted term is −t²/(3e) times the printed factor.",
    ),
    Correction(
        "The slope of ε at γ = 0",
        "ε(γ) = ε₀ − γ/(4bε₀) + O(γ²)",
        ("eq_pavao", "remark1_speed", "d58", "remainder_constant", "prop1"),
        "−1/(4bε₀) is the leading term of dε/dγ for large ab, and not dε/dγ itself: with it the "
        "remainder is of the order of γ. The appendix gives the derivative up to O(1), and its "
        "summary omits this term.",
    ),
    Correction(
        "The symmetric motion does not always flip most",
        "for a variation of 2π of the angle φ, the maximum of variation of ψ is given by the "
        "symmetric motion where ψ_f = π − ψ₀",
        ("symmetric_maximum",),
        "Where the symmetric flip exceeds π, it is the smallest of all. The paper uses such γ "
        "itself.",
    ),
    Correction(
        "A larger product ab does not imply a smaller ε₀",
        "the larger the product ab is, the smaller the parameter ε₀ is",
        ("larger_ab_smaller_eps0", "formula_shows_larger_ab"),
        "ε₀ decreases in a and in b, but it is not a function of ab. The statement holds if one of "
        "the two is fixed.",
    ),
    Correction(
        "Nor does it imply a less robust effect",
        "the larger the term ab is, the less robust is the effect",
        ("larger_ab_less_robust",),
        "The slope is of the order of 1/(bε₀), and b may decrease while ab increases. At fixed b "
        "the statement holds.",
    ),
    Correction(
        "The flip along the separatrix is not zero",
        "the variation of the flip angle is approximately zero on the separatrix",
        ("zero_on_separatrix",),
        "The symmetric start, ψ₀ = ε₀, flips by π − 2ε₀. The flip is small only for starts at an "
        "unstable point or running into one.",
    ),
    Correction(
        "The formula takes one ε₀ at two values of a",
        "each value of ε₀ is associated with one value of a through the equation of ε₀",
        ("each_eps0_one_a",),
        "At b = 0.1 the formula first increases and then decreases in a, so that it takes some "
        "values twice. The exact ε₀ does not.",
    ),
    Correction(
        "dψ/dφ is not the angular velocity along the handle",
        "(dψ/dφ)₀ is the initial angular velocity of the racket along the handle",
        ("initial_rate_is_angular_velocity",),
        "The angular velocity along the handle also has a part from the precession, with the "
        "factor cos θ.",
    ),
    Correction(
        "No rigid body has the moments of rackets 1, 2 and 3",
        "Racket 1: 886, 16336, 18270; Racket 2: 1319, 14445, 16175; Racket 3: 448, 7126, 1818",
        ("table_racket_1_realizable", "table_racket_2_realizable", "table_racket_3_realizable"),
        "The largest moment of a rigid body is at most the sum of the other two. With 8118 "
        "for 1818 in the last row this is still violated.",
    ),
    Correction(
        "b is never large",
        "The case where a ≫ 1 and b ≫ 1 gives the constraint I₁ ≪ I₂ ≪ I₃",
        ("a_and_b_large",),
    ),
    Correction(
        "A spherical top has no unstable axis",
        "the motion is unstable around the e₂- axis. This behavior can be observed for any "
        "three-dimensional rigid body",
        ("any_rigid_body_is_unstable",),
        "True if the three moments are different. A body with three equal moments rotates "
        "uniformly about any axis.",
    ),
    Correction(
        "Flat and smooth at the origin from one side only",
        "f(s) = e^{−1/s}, for s ≠ 0 and f(0) = 0 is of class C^{∞}, infinitely flat at the origin",
        ("flat_function", "eps0_smooth", "G_is_smooth"),
        "For s < 0 the function is unbounded, and so is what is built from it for λ < 0. The "
        "argument needs only λ ≥ 0, where everything is smooth.",
    ),
    Correction(
        "∂μ/∂λ is not zero at the origin",
        "Since ∂G/∂λ(0, 0, 0) = 0, we deduce that ∂μ/∂λ = 0",
        ("dmu_dlambda_zero",),
    ),
    Correction(
        "dε/dγ of the standard racket",
        "dε/dγ|_{γ = 0} = −34.5",
        ("d27",),
        "Read as the derivative of ε(γ), to which the paper equates it; the number is that of its "
        "leading term, −1/(4bε₀).",
    ),
    Correction(
        "The levels at which the flip is off by π/6",
        "γ|_{ε = −π/12} = 1.09 × 10^{−2}, γ|_{ε = π/12} = −4.2 × 10^{−3}",
        ("d29",),
        "Read as levels of ε(γ), like the slope before; the numbers are those of the linear "
        "formula.",
    ),
    Correction(
        "An equation without its higher orders",
        "ε₀ = 2√(1 − μ²) e^{−(π + arcsin(μ cos ε₀))/λ}",
        ("equation",),
        "Eq. (A.2), which it is said to repeat, has “+ hot” on its left side. The higher orders "
        "are one part in a thousand for the standard racket.",
    ),
    Correction(
        "a of racket 3",
        "Racket 3: 448, 7126, 1818, 14.88",
        ("table_racket_3_a",),
        "The moments that are printed with it give a = 14.91.",
    ),
    Correction(
        "The third moment of racket 3",
        "Racket 3: 448, 7126, 1818, 14.88, 0.12",
        ("table_racket_3_b", "table_racket_3_order"),
        "Two digits are exchanged: 8118 for 1818 puts the moments in order and gives b = 0.1222.",
    ),
    Correction(
        "The flip of ethylene",
        "this leads to a classical flip of Δψ = π(1 − 0.0528)",
        ("ethylene_flip", "ethylene_flip_by_formula"),
        "The number is (2/π) e^{−π√(ab)}: the formula without the factor before the exponential.",
    ),
    Correction(
        "A missing comma",
        "G(u, λ, μ) := u + arcsin μ − arcsin(μ cos(ε₀(u, λμ))) + hot = 0",
        ("defect_of_a_product",),
    ),
    Correction(
        "Where the square root is real",
        "is positive only if sin²ψ_min = sin²ψ_max = |γ|/b",
        ("positive_only_if",),
    ),
    Correction(
        "A moment that may be zero", "we will assume that 0 ≤ I₁ ≤ I₂ ≤ I₃", ("ordered_moments",)
    ),
    Correction(
        "A cross reference",
        "we only consider the case θ ∈ [0, π/2] (see Sec. 2)",
        ("reference_to_section_2",),
        "The restriction is stated in Sect. 3.",
    ),
    Correction(
        "The unit of the moments",
        "The moments of inertia are expressed in kg.mm^{−1}.s^{−2}",
        ("table_units",),
    ),
)
