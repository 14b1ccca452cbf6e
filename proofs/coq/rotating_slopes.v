intros a b e g A B G_3 G_4 G_5 G_6.
assert (P : forall c t, 0 < c -> e - 1 < t < PI / 2 + 1 -> 0 < c + b * sin t ^ 2).
{ intros c t C _; pose proof (pow2_ge_0 (sin t)); nra. }
exists (- plain a b g e), (RInt (rate_slope 1 a b g) e (1 / 2 * PI)); split.
- apply (plain_by_start a b A B g (e - 1) (PI / 2 + 1)); try lra; intros t; apply P; lra.
- apply (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra; exact P.
