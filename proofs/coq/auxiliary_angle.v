intros T k r G_1 G_2 G_3 G_4 N_1 N_2 N_3 N_4 N_5 N_6.
pose proof (atan_bound (r * tanh T)) as B; rewrite <- (asin_sin (atan (r * tanh T))) by lra.
f_equal; rewrite sin_atan; unfold Rsqr, tanh.
assert (S : 0 < sinh T) by (rewrite <- sinh_0; now apply sinh_lt).
assert (C2 : cosh T ^ 2 = 1 + sinh T ^ 2).
{ rewrite sinh_law, cosh_law; pose proof (exp_pos T); field; lra. }
pose proof (cosh_pos T) as C; set (s := sinh T) in *; set (c := cosh T) in *.
set (p := sqrt (r ^ 2 + 1)); set (q := sqrt (_ + 1)); set (w := sqrt (1 + _)).
assert (W0 : 0 < 1 + r * (s / c) * (r * (s / c))).
{ pose proof (Rle_0_sqr (r * (s / c))) as U; unfold Rsqr in U; lra. }
assert (p ^ 2 = r ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (q ^ 2 = / (r ^ 2 + 1) * / s ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (w ^ 2 = 1 + r * (s / c) * (r * (s / c))) by (apply pow2_sqrt; lra).
assert (0 < p) by (apply sqrt_lt_R0; exact N_6).
assert (0 < q) by (apply sqrt_lt_R0; exact N_3).
assert (0 < w) by (apply sqrt_lt_R0; exact W0).
assert (V : p * q * s = w * c).
{ apply same_square; [left; positive | left; positive |]; rewrite !Rpow_mult_distr, H, H0, H1, C2.
  replace (1 + s ^ 2) with (c ^ 2) by lra.
  apply (eq_trans (y := s ^ 2 * (r ^ 2 + 1) + 1)); [field; lra |].
  apply (eq_trans (y := c ^ 2 + r ^ 2 * s ^ 2)); [rewrite C2; ring | field; lra]. }
apply (Rmult_eq_reg_r (p * q * w * c)); [| apply Rgt_not_eq, Rlt_gt; positive].
apply (eq_trans (y := r * (w * c))); [field; lra |].
apply (eq_trans (y := r * (p * q * s))); [rewrite V; reflexivity | field; lra].
