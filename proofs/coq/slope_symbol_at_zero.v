intros S a b e A B G_3 G_4 G_5 G_6 G_7.
exists (- zero_rate S a b e); apply (zero_by_start S a b A B); lra.
