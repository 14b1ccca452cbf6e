intros c x G_1 G_2 G_3.
destruct (mean_value (fun t => arcsinh (c * t) - c * arcsinh t)
  (fun t => c * (/ sqrt ((c * t) ^ 2 + 1) - / sqrt (t ^ 2 + 1))) 0 x) as [u [U1 U2]].
{ lra. }
{ intros t _; eapply d_eq; [derive |]; ring. }
cbv beta in U2; rewrite Rmult_0_r, arcsinh_0 in U2.
assert (/ sqrt (u ^ 2 + 1) <= / sqrt ((c * u) ^ 2 + 1)).
{ apply Rinv_le_contravar; [apply sqrt_lt_R0; nra | apply sqrt_le_1_alt].
  assert (c ^ 2 <= 1) by nra; rewrite Rpow_mult_distr; pose proof (pow2_ge_0 u); nra. }
assert (0 <= c * (/ sqrt ((c * u) ^ 2 + 1) - / sqrt (u ^ 2 + 1))) by (apply Rmult_le_pos; lra); nra.
