intros d S a b e g p q D_1 D_2 D_3 D_4 A B G_3 G_4; subst; exact D_3.
