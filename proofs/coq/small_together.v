intros b l G_1 G_2 N.
assert (W : 1 <= sqrt (b ^ 2 * l ^ 2 + 1)) by (apply below_sqrt; nra).
assert (I : / sqrt (b ^ 2 * l ^ 2 + 1) <= 1).
{ apply (Rmult_le_reg_r (sqrt (b ^ 2 * l ^ 2 + 1))); [lra |]; rewrite Rinv_l; lra. }
assert (0 < b * l) by positive; nra.
