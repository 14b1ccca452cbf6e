intros a b c e x g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7.
assert (v1 < 0).
{ destruct (unturned b B g e) as [p [u [v [H1 [H2 [H3 P]]]]]]; try lra.
  assert (W : v1 = - plain a b g e).
  { rewrite <- (is_derive_unique _ _ _ E_1); apply is_derive_unique.
    apply (plain_by_start a b A B g u v); try lra; intros t; apply P; lra. }
  rewrite W; pose proof (reach a b A B e); specialize (P g e ltac:(lra) H2).
  assert (0 < plain a b g e) by (unfold plain; positive); lra. }
assert (v2 < 0).
{ destruct (unturned b B g e) as [p [u [v [H1 [H2 [H3 P]]]]]]; try lra.
  assert (W : v2 = RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
  { rewrite <- (is_derive_unique _ _ _ E_2); apply is_derive_unique.
    apply (plain_by_level a b A B g p u v); try lra; exact P. }
  rewrite W; apply turn_falls; try lra.
  - intros t T; apply P; lra.
  - destruct (room b e) as [t [T1 T2]]; try lra; exists t; split; lra. }
assert (/ v1 < 0) by (apply Rinv_lt_0_compat; assumption); rewrite E; nra.
