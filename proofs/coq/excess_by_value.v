intros S a b e F D A B G_3 G_4 G_5 G_6 G_7 G_8 G_9; rewrite <- (is_derive_unique _ _ _ D).
apply is_derive_unique, (over_by_value S a b A B e PI); lra.
