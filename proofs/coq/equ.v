intros e l m u G_1 G_2 G_3 G_4 G_5 N_1 N_2 N_3 N_4 N_5 N_6.
assert (S : 0 < sqrt ((-1) * m ^ 2 + 1)) by (apply sqrt_lt_R0; lra); split; intro H.
- do 2 f_equal; rewrite <- (Rplus_0_l (asin (m * cos e))), <- H; ring.
- apply Rmult_eq_reg_l in H; [| lra]; apply exp_inv in H.
  apply Rmult_eq_reg_l in H; [lra |]; apply Rmult_integral_contrapositive; split; [lra |].
  apply Rinv_neq_0_compat; lra.
