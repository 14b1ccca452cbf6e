intros a b l D G_1 G_2 G_3 N_1 N_2 N_3; subst l.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (K2 : sqrt (a * b) ^ 2 = a * b) by (apply pow2_sqrt; positive).
set (k := sqrt (a * b)) in *.
assert (W : 0 < sqrt (b ^ 2 * (/ k) ^ 2 + 1)) by (apply sqrt_lt_R0; exact N_3).
assert (W2 : sqrt (b ^ 2 * (/ k) ^ 2 + 1) ^ 2 = b ^ 2 * (/ k) ^ 2 + 1) by (apply pow2_sqrt; lra).
apply sqrt_unique; [left; positive |]; rewrite !Rpow_mult_distr, (pow_inv (sqrt _)), W2, !pow_inv, K2.
field; split; nra.
