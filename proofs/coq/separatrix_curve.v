intros S a b p t D A B G_3 G_4 N.
assert (0 < Rabs (cos t)) by (apply Rabs_pos_lt; intro Z; rewrite Z in G_4; lra).
assert (E : S ^ 2 = 1).
{ rewrite D, Rpow_mult_distr, pow_inv, pow2_abs, Rinv_l; lra. }
rewrite E; ring.
