intros a b y g A B B1 L G Y Z N1 N2 N3.
exists (RInt (u_rate a b g) 0 y), (RInt (u_rate a b g) 0 y); split; [| split; [| reflexivity]].
- apply (u_turn_is_phase a b g); lra.
- apply integral_correct; intros x _; apply (u_rate_continuous a b); lra.
