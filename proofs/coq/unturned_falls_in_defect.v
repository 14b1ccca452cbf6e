intros F a b e g D A B G_3 G_4 G_5 G_6 G_7.
destruct (unturned b B g e) as [p [u [v [H1 [H2 [H3 P]]]]]]; try lra.
assert (E : F = - plain a b g e).
{ rewrite <- (is_derive_unique _ _ _ D); apply is_derive_unique.
  apply (plain_by_start a b A B g u v); try lra; intros t; apply P; lra. }
rewrite E; pose proof (reach a b A B e); specialize (P g e ltac:(lra) H2).
assert (0 < plain a b g e) by (unfold plain; positive); lra.
