intros F S a b e g D_1 D_2 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9.
rewrite <- (is_RInt_unique _ _ _ _ D_1); apply is_RInt_unique, D_2; lra.
