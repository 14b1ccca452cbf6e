intros F0 S a b e g u k x y D_1 [v1 [v2 [E_1 [E_2 E]]]] D_3 D_4 D_5 D_6 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10.
rewrite (claim_inverse_of_slope F0 S a b e u x D_5 D_6 D_4 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10).
rewrite E, <- (is_derive_unique _ _ _ E_1), (is_derive_unique _ _ _ D_4).
rewrite <- (is_derive_unique _ _ _ E_2), (is_derive_unique _ _ _ D_3); ring.
