intros P a b g A B G_3 G_4 G_5 G_6 N.
assert (K : forall t, 0 < g + b * sin t ^ 2) by (intros t; pose proof (pow2_ge_0 (sin t)); nra).
assert (C : forall t, continuous (plain a b g) t) by (intros t; apply plain_continuous; trivial).
exists (RInt (plain a b g) 0 P); split; [apply integral_correct; intros t _; apply C |].
replace (P * / sqrt (a * g)) with (RInt (fun _ : R => / sqrt (a * g)) 0 P)
  by (rewrite integral_const; over_reals; ring).
apply integral_le; [lra | intros t _; apply C | intros t _; apply continuous_const |].
intros t _; unfold plain; pose proof (reach a b A B t); specialize (K t).
rewrite sqrt_mult, Rinv_mult by lra.
assert (L : forall c, 0 < c -> 0 < / sqrt (c + b * sin t ^ 2) <= / sqrt c).
{ intros c Q; pose proof (pow2_ge_0 (sin t)); split.
  - apply Rinv_0_lt_compat, sqrt_lt_R0; nra.
  - apply Rinv_le_contravar; [apply sqrt_lt_R0; lra | apply sqrt_le_1_alt; nra]. }
pose proof (L a A); pose proof (L g G_4); pose proof (SIN_bound t).
assert (0 <= (-1) * b * sin t ^ 2 + 1 <= 1) by (split; nra).
assert (/ sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2) <= / sqrt a * / sqrt g)
  by (apply Rmult_le_compat; lra).
assert (0 < / sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2)) by positive; nra.
