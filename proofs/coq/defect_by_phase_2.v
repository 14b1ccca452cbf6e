intros; f_equal; unfold tan; set (s := sin epsilon0) in *; set (c := cos epsilon0) in *.
assert (I : 0 < b * / a) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]).
assert (P : 0 < b * / a * s ^ 2 + 1) by nra.
assert (Q : s ^ 2 = 1 - c ^ 2) by apply sin_square.
assert (E : sqrt (-1 * / (b * / a * s ^ 2 + 1) * c ^ 2 + 1)
  = s * sqrt (b * / a + 1) * / sqrt (b * / a * s ^ 2 + 1)).
{ assert (0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  assert (0 < sqrt (b * / a * s ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
  apply sqrt_unique.
  - apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra].
  - rewrite !Rpow_mult_distr, pow_inv, !pow2_sqrt by lra.
    set (r := b * / a) in *; clearbody r; replace (c ^ 2) with (1 - s ^ 2) by lra; field; lra. }
rewrite E; field; repeat split; try lra; apply Rgt_not_eq, sqrt_lt_R0; try lra.
