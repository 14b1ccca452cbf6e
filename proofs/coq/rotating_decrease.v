intros a b c e x g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6.
assert (v1 < 0).
{ assert (P : forall t, 0 < g + b * sin t ^ 2) by (intros t; pose proof (pow2_ge_0 (sin t)); nra).
  assert (W : v1 = - plain a b g e).
  { rewrite <- (is_derive_unique _ _ _ E_1); apply is_derive_unique.
    apply (plain_by_start a b A B g (e - 1) (PI / 2 + 1)); try lra; intros t _; apply P. }
  rewrite W; pose proof (reach a b A B e); specialize (P e).
  assert (0 < plain a b g e) by (unfold plain; positive); lra. }
assert (v2 < 0).
{ assert (P : forall q t, 0 < q -> 0 < q + b * sin t ^ 2).
  { intros q t C; pose proof (pow2_ge_0 (sin t)); nra. }
  assert (W : v2 = RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
  { rewrite <- (is_derive_unique _ _ _ E_2); apply is_derive_unique.
    apply (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra; intros q t C _; apply P, C. }
  rewrite W; apply turn_falls; try lra.
  - intros t _; apply P, G_4.
  - destruct (room b e) as [t [T1 T2]]; try lra; exists t; split; lra. }
assert (/ v1 < 0) by (apply Rinv_lt_0_compat; assumption); rewrite E; nra.
