intros u G_1 G_2 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8.
assert (S : 0 < (-1) * u ^ 2 + 1) by nra.
assert (D : / u + u * / (u + 1) + (-1) = / (u * (u + 1))) by (field; lra).
split; [field; lra |]; split; [| split].
- f_equal; rewrite D; field; lra.
- pose proof (sqrt_pos ((-1) * u ^ 2 + 1)); assert (0 < / (u + 1)) by positive.
  apply sqrt_unique; [apply Rmult_le_pos; lra |].
  rewrite Rpow_mult_distr, pow2_sqrt by lra; field; lra.
- apply sqrt_unique; [lra |]; rewrite D; field; lra.
