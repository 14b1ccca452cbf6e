intros S a b e A B G_3 G_4 G_5 G_6 G_7 G_8 G_9; exists (-1), (- zero_rate S a b e); split.
- apply (over_by_value S a b A B e PI); lra.
- apply (over_by_end S a b A B e PI); lra.
