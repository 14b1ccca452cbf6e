intros S a b e F D A B G_3 G_4 G_5 G_6 G_7 G_8 N_1 N_2 N_3.
rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
eapply d_eq; [apply (zero_by_start S a b A B); lra | unfold zero_rate; ring].
