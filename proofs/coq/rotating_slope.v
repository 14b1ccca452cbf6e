intros a b e g A B B1 G E K Z.
exists (- plain a b g e), (RInt (rate_slope 1 a b g) e (1 / 2 * PI)).
assert (P : forall c t, 0 < c -> 0 < c + b * sin t ^ 2) by (intros c t C; pose proof (pow2_ge_0 (sin t)); nra).
split; [apply (plain_by_start a b A B g (e - 1) (PI / 2 + 1)); try lra; intros t _; apply P, G |].
split; [apply (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra; intros c t C _; apply P, C |].
apply (turn_solution (plain a b) 1 a b g 0 (e - 1) (PI / 2 + 1) e (1 / 2 * PI)); try lra; try assumption.
- intros; symmetry; apply plain_is.
- intros c t C _; apply P, C.
- intros; ring.
- rewrite plain_is; reflexivity.
