intros a A N1 N2 N3 N4 N5 N6 N7.
pose proof (claim_positive_short a A N3 N6 N4) as G.
assert (F : (-1) * arcsinh (sqrt ((-1) * / ((a + 1) ^ 2) + 1) * / (sin (/ (a + 1) + 2 * atan (exp ((-1) * PI)))) * cos (/ (a + 1) + 2 * atan (exp ((-1) * PI)))) + / (/ (a + 1) + 1) * sqrt ((-1) * / ((a + 1) ^ 2) + 1) * (PI + asin (/ (a + 1) * cos (/ (a + 1) + 2 * atan (exp ((-1) * PI))))) > 0).
{ apply claim_excess_in_a; assumption. }
set (e := / (a + 1) + 2 * atan (exp ((-1) * PI))) in *; set (r := (-1) * / ((a + 1) ^ 2) + 1) in *.
set (T := / (/ (a + 1) + 1) * sqrt r * (PI + asin (/ (a + 1) * cos e))) in *; set (y := sqrt r * / sin e * cos e) in *.
pose proof (claim_tangent_grows (arcsinh y) (T - arcsinh y) ltac:(lra) ltac:(lra)) as H.
replace (arcsinh y + (T - arcsinh y)) with T in H by ring.
assert (Y : y ^ 2 = cos e ^ 2 * / (sin e ^ 2) * r).
{ unfold y; rewrite !Rpow_mult_distr, pow2_sqrt by exact N4; field; exact N6. }
assert (C : cosh (arcsinh y) = sqrt (cos e ^ 2 * / (sin e ^ 2) * r + 1)).
{ symmetry; apply sqrt_unique; [left; apply cosh_pos |]; rewrite cosh_square, sinh_arcsinh, <- Y; ring. }
unfold tanh at 1 in H; rewrite sinh_arcsinh, C in H; unfold y, Rdiv in H; lra.
