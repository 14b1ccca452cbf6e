intros Q a b e f D_1 D_2 D_3 D_4 D_5 A B G_3 N_1 N_2.
rewrite (claim_leading_by_defect Q a b e f D_1 D_2 D_3 D_4 D_5 A B G_3).
pose proof (exp_pos Q); replace ((-1) * Q) with (- Q) by ring; rewrite exp_Ropp.
replace (e * / (e * / exp Q)) with (exp Q) by (field; lra); rewrite ln_exp; reflexivity.
