intros a b d e A B B1 E0 E1 S C D A1 A2 B2 B3 E2 E3; destruct (u_longest a b d e) as [v [V W]]; try lra.
exists v; split; [exact V |]; destruct (claim_longest_unturned a b e) as [w [I K]]; try assumption.
enough (w = RInt (u_rate a b (- b * sin e ^ 2)) 0 (1 / 2 * PI)) by lra.
symmetry; apply is_RInt_unique; eapply is_RInt_ext; [| exact I].
intros x _; unfold u_rate, u_root, u_under, u_over; cbv beta.
match goal with |- / sqrt ?p * / ?q * ?n = / sqrt ?r * / ?s * ?m =>
  replace p with r by ring; replace q with s by ring; replace n with m by ring; reflexivity end.
