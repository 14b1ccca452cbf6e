intros a b e g A B B1 E F G K Z.
destruct (unturned b B g e B1 E ltac:(lra) ltac:(lra)) as [p [u [v [L [X [Y P]]]]]].
exists (- plain a b g e), (RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
split; [apply (plain_by_start a b A B g u v); try lra; intros t T; now apply P |].
split; [apply (plain_by_level a b A B g p u v); try lra; exact P |].
apply (turn_solution (plain a b) 1 a b g p u v e (1 / 2 * PI)); try lra; try assumption.
- intros; symmetry; apply plain_is.
- intros; ring.
- rewrite plain_is; reflexivity.
