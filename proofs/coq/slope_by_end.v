intros S a b e g F D A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 N_1 N_2.
rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
eapply d_eq; [apply (turn_by_start S a b A B g (e - 1) (PI / 2 + 1)); try lra | unfold rate; ring].
intros t _; pose proof (pow2_ge_0 (sin t)); nra.
