intros F a b e g D A B G_3 G_4 G_5 G_6.
assert (P : forall t, 0 < g + b * sin t ^ 2) by (intros t; pose proof (pow2_ge_0 (sin t)); nra).
assert (E : F = - plain a b g e).
{ rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
  apply (plain_by_start a b A B g (e - 1) (PI / 2 + 1)); try lra; intros t _; apply P. }
rewrite E; pose proof (reach a b A B e); specialize (P e).
assert (0 < plain a b g e) by (unfold plain; positive); lra.
