intros S a b g p A B G_3 G_4 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9; cbv beta.
replace (sin ((-1) * p)) with (- sin p) by (rewrite <- sin_neg; f_equal; ring).
replace (sin (PI + p)) with (- sin p) by (rewrite Rplus_comm, neg_sin; reflexivity).
replace ((- sin p) ^ 2) with (sin p ^ 2) by ring; split; reflexivity.
