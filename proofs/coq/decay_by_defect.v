intros a b e D_1 D_2 D_3 A B G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9.
pose proof (claim_decay_once a b e D_1 D_2 D_3 A B G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9) as E.
split; [exact E |].
replace ((-2) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  with ((-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))
    + (-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) by ring.
rewrite exp_plus, E; set (q := sqrt (b * / a + 1)) in *.
assert (Q : q ^ 2 = b * / a + 1) by (apply pow2_sqrt; exact N_9).
rewrite <- Q; field; exact N_6.
