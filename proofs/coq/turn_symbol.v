intros S a b e A B G_3 G_4 G_5 G_6 G_7.
destruct (unturned b B 0 e) as [p [u [v [H1 [H2 [H3 H4]]]]]]; try lra.
{ rewrite Rplus_0_l; positive. }
exists (RInt (rate_slope S a b 0) e (1 / 2 * PI)).
apply (turn_by_level S a b A B 0 p u v); try lra; exact H4.
