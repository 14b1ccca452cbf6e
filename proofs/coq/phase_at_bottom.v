intros a b A B G_3 N.
assert (D : forall t, b * (b + a * sin t ^ 2) + a * b * cos t ^ 2 = b * (a + b)).
{ intros t; rewrite sin_square; ring. }
assert (K : 0 < sqrt (b * (a + b))) by (apply sqrt_lt_R0; exact N).
assert (V : forall t, / sqrt (b * (b + a * sin t ^ 2) + a * b * cos t ^ 2) * / (a + b * cos t ^ 2 + b * sin t ^ 2)
  * (cos t ^ 2 * ((-1) * b + 1) * (a + b) + sin t ^ 2 * ((-1) * b + 1) * (a + b))
  = / sqrt (b * (a + b)) * ((-1) * b + 1)).
{ intros t; rewrite D, sin_square.
  replace (a + b * cos t ^ 2 + b * (1 - cos t ^ 2)) with (a + b) by ring; field; lra. }
apply (is_RInt_ext (fun _ : R => / sqrt (b * (a + b)) * ((-1) * b + 1))).
- intros t _; symmetry; apply V.
- replace (PI * / sqrt (b * (a + b)) * ((-1) * b + 1))
    with (RInt (fun _ : R => / sqrt (b * (a + b)) * ((-1) * b + 1)) 0 PI)
    by (rewrite integral_const; over_reals; ring).
  apply integral_correct; intros t _; apply continuous_const.
