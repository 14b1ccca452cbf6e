intros l m u G_1 G_2 G_3 G_4 N_1 N_2 N_3 N_4; pose proof pi_between.
assert (S : sqrt ((-1) * m ^ 2 + 1) <= 1) by (apply above_sqrt; nra).
assert (0 <= asin m) by (destruct G_2 as [G|G]; [left; apply asin_positive; lra | rewrite G, asin_0; lra]).
assert (E : exp ((-1) * / l * (PI + u + asin m)) <= exp ((-2) * / l)).
{ apply exp_rises; assert (0 < / l) by (apply Rinv_0_lt_compat; lra); nra. }
pose proof (exp_pos ((-1) * / l * (PI + u + asin m))); pose proof (sqrt_pos ((-1) * m ^ 2 + 1)); nra.
