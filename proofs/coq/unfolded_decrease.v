intros a b c x y g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7 G_8.
assert (V : v1 = u_rate a b g x).
{ rewrite <- (is_derive_unique _ _ _ E_1); apply is_derive_unique, (u_phase_by_end a b A B g x); lra. }
assert (W : v2 = RInt (u_growth a b g) 0 x).
{ rewrite <- (is_derive_unique _ _ _ E_2); apply is_derive_unique, (u_phase_by_level a b A B g x); lra. }
pose proof (u_rate_above a b A B G_3 g x ltac:(lra) G_5 (or_intror (Rgt_lt _ _ G_8))).
pose proof (u_phase_rises a b A B G_3 g x ltac:(lra) G_5 G_6 G_7).
assert (0 < / v1) by (apply Rinv_0_lt_compat; lra); rewrite E; nra.
