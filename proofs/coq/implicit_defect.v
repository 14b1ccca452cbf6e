intros s a b e A B B1 B2 E F S C H Z.
destruct (unturned b B 0 e B1 E ltac:(lra) ltac:(pose proof (pow_lt _ 2 S); nra)) as [p [u [v [L [X [Y P]]]]]].
exists (- zero_rate s a b e), (RInt (rate_slope s a b 0) e (1 / 2 * PI)).
split; [apply (zero_by_start s a b A B); lra |].
split; [apply (turn_by_level s a b A B 0 p u v); try lra; exact P |].
apply (turn_solution (rate s a b) s a b 0 p u v e (1 / 2 * PI)); try lra; try assumption.
- intros; reflexivity.
- pose proof (forward b B e B2); lra.
- apply (is_RInt_ext (V := R_NormedModule)) with (2 := Z); intros t _; unfold rate; rewrite Rplus_0_l; reflexivity.
- intros; ring.
- rewrite zero_rate_is by assumption; reflexivity.
