intros a A N1 N2 N3 N4 N5 N6.
pose proof (claim_floor_in_a a A N3 N2 N4 N5 N6) as F.
pose proof (claim_positive_sooner a A N4 N5 N2 N3 N6) as G.
set (T := / (/ (a + 1) + 1) * sqrt ((-1) * / ((a + 1) ^ 2) + 1) * (PI + asin (/ (a + 1) * tanh PI))) in *.
set (y := sqrt ((-1) * / ((a + 1) ^ 2) + 1) * sinh PI) in *.
replace ((-1) * / (/ (a + 1) + 1) * sqrt ((-1) * / ((a + 1) ^ 2) + 1) * (PI + asin (/ (a + 1) * tanh PI))) with ((-1) * T) in F by (unfold T; ring).
pose proof (claim_tangent_grows T (arcsinh y - T) ltac:(lra) ltac:(lra)) as H.
replace (T + (arcsinh y - T)) with (arcsinh y) in H by ring.
assert (Y : y ^ 2 = sinh PI ^ 2 * ((-1) * / ((a + 1) ^ 2) + 1)).
{ unfold y; rewrite Rpow_mult_distr, pow2_sqrt by exact N3; ring. }
assert (C : cosh (arcsinh y) = sqrt (sinh PI ^ 2 * ((-1) * / ((a + 1) ^ 2) + 1) + 1)).
{ symmetry; apply sqrt_unique; [left; apply cosh_pos |]; rewrite cosh_square, sinh_arcsinh, <- Y; ring. }
unfold tanh at 2 in H; rewrite sinh_arcsinh, C in H; unfold y, Rdiv in H.
replace (sqrt ((-1) * / ((a + 1) ^ 2) + 1) * / sqrt (sinh PI ^ 2 * ((-1) * / ((a + 1) ^ 2) + 1) + 1) * sinh PI)
  with (sqrt ((-1) * / ((a + 1) ^ 2) + 1) * sinh PI * / sqrt (sinh PI ^ 2 * ((-1) * / ((a + 1) ^ 2) + 1) + 1)) by ring.
exact H.
