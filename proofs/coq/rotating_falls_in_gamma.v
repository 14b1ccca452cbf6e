intros F a b e g D A B G_3 G_4 G_5 G_6.
assert (P : forall c t, 0 < c -> 0 < c + b * sin t ^ 2).
{ intros c t C; pose proof (pow2_ge_0 (sin t)); nra. }
assert (E : F = RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
{ rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
  apply (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra; intros c t C _; apply P, C. }
rewrite E; apply turn_falls; try lra.
- intros t _; apply P, G_4.
- destruct (room b e) as [t [T1 T2]]; try lra; exists t; split; lra.
