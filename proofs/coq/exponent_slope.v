intros a b e A B G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12; eexists; split.
- apply (exponent_derive a b e A B); lra.
- pose proof (root_above a b e A B); fold (root_of a b e); field; repeat split; lra.
