intros a b d e A B B1 E0 E1 S C D; destruct (u_longest a b d e) as [v [V W]]; try lra.
exists v, (RInt (u_rate a b (- b * sin e ^ 2)) 0 (1 / 2 * PI)); split; [exact V | split; [| exact W]].
assert (G : - b * sin e ^ 2 < 0) by (assert (0 < sin e ^ 2) by (apply pow_lt; lra); nra).
eapply is_RInt_ext; [| apply integral_correct; intros x _; apply (u_rate_continuous a b A B _ x G)].
intros x _; unfold u_rate, u_root, u_under, u_over; cbv beta.
match goal with |- / sqrt ?p * / ?q * ?n = / sqrt ?r * / ?s * ?m =>
  replace p with r by ring; replace q with s by ring; replace n with m by ring; reflexivity end.
