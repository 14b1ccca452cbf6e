intros a b e G_1 G_2 G_3 G_4 G_5 S C N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11.
set (T := sqrt (a * b) * _) in *.
assert (E : sqrt (a * / (a + b)) * sqrt (b * / a + 1) = 1).
{ rewrite <- sqrt_mult by assumption.
  replace (a * / (a + b) * (b * / a + 1)) with 1 by (field; lra); exact sqrt_1. }
assert (P : 0 < sqrt (a * / (a + b))) by (apply sqrt_lt_R0; positive).
set (p := sqrt (a * / (a + b))) in *; set (q := sqrt (b * / a + 1)) in *.
assert (Q : q = / p) by (apply (Rmult_eq_reg_l p); [rewrite Rinv_r; lra | lra]).
rewrite Q; unfold tan; split; intro H.
- replace (sin e) with (p * / sinh T * cos e) by (rewrite H; field; lra); field; repeat split; lra.
- replace (cos e) with (sin e * (/ p * sinh T)) by (rewrite <- H; field; lra); field; repeat split; lra.
