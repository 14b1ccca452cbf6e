intros F a b e g D A B G_3 G_4 G_5 G_6 G_7.
destruct (unturned b B g e) as [p [u [v [H1 [H2 [H3 P]]]]]]; try lra.
assert (E : F = RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
{ rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
  apply (plain_by_level a b A B g p u v); try lra; exact P. }
rewrite E; apply turn_falls; try lra.
- intros t T; apply P; lra.
- destruct (room b e) as [t [T1 T2]]; try lra; exists t; split; lra.
