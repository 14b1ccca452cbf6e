intros S a b g q x A B G_3 G_4 G_5 G_6 N_1 N_2 N_3 N_4.
assert (P : forall t, x - 1 < t < q + 1 -> 0 < g + b * sin t ^ 2).
{ intros t _; pose proof (pow2_ge_0 (sin t)); nra. }
split.
- eapply d_eq; [apply (turn_by_start S a b A B g (x - 1) (q + 1)); try lra; exact P | unfold rate; ring].
- eapply d_eq; [apply (turn_by_end S a b A B g (x - 1) (q + 1)); try lra; exact P | reflexivity].
