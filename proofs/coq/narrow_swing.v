intros a b e g A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10 N_1 N_2 N_3 N_4.
assert (0 < / b) by positive.
assert (L : sin e < sqrt ((-1) * g * / b)).
{ rewrite <- (sqrt_pow2 (sin e)) by lra; apply sqrt_lt_1_alt; split; [apply pow2_ge_0 |].
  replace (sin e ^ 2) with (b * sin e ^ 2 * / b) by (field; lra); apply Rmult_lt_compat_r; lra. }
pose proof (asin_rises (sin e) _ ltac:(pose proof (SIN_bound e); lra) L ltac:(lra)) as M.
rewrite asin_sin in M by lra; lra.
