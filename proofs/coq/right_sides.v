intros a b e l m D_1 D_2 G_1 G_2 G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10; subst l m.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
replace ((-1) * sqrt (b * / (a + b)) ^ 2 + 1) with (a * / (a + b))
  by (rewrite pow2_sqrt by exact N_7; field; lra).
do 2 f_equal; field; lra.
