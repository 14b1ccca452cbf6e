intros e l m u D G_1 G_2 G_3 G_4 N_1 N_2 N_3 N_4.
assert (S : 0 < sqrt ((-1) * m ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
assert (Q : 0 < 1 / 2 * e * / sqrt ((-1) * m ^ 2 + 1)) by positive.
replace ((-1) * / l * (PI + u + asin m)) with (ln (1 / 2 * e * / sqrt ((-1) * m ^ 2 + 1)))
  by (rewrite D; field; lra).
rewrite exp_ln by exact Q; field; lra.
