intros F0 S a b e x D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 N_1 N_2 N_3 N_4.
assert (0 < Rabs (sin e)) by (rewrite Rabs_pos_eq; lra).
assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B); pose proof (reach a b A B e).
assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
assert (V2 : v2 = -1).
{ rewrite <- (is_derive_unique _ _ _ E_2); apply is_derive_unique, (over_by_value S a b A B e PI); lra. }
assert (V1 : v1 = - (S * / sqrt b * / sqrt (a + b * sin e ^ 2) * / Rabs (sin e) * ((-1) * b * sin e ^ 2 + 1))).
{ rewrite <- (is_derive_unique _ _ _ E_1); apply is_derive_unique.
  eapply d_eq; [apply (over_by_end S a b A B e PI); lra | unfold zero_rate; ring]. }
rewrite E, V2, V1.
field; repeat split; lra.
