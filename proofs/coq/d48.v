intros S a b e g A B G_3 G_4 G_5 G_6 G_7 G_8 G_9.
assert (C : forall t, continuous (rate S a b g) t).
{ intros t; apply rate_continuous; trivial; pose proof (pow2_ge_0 (sin t)); nra. }
exists (RInt (rate S a b g) e (PI + (-1) * e)), (RInt (rate S a b g) e (1 / 2 * PI)); split; [| split].
- apply integral_correct; intros t _; apply C.
- apply integral_correct; intros t _; apply C.
- rewrite integral_halves; [| lra | intros t _; apply C |].
  + do 2 f_equal; field.
  + intros t _; unfold rate; replace (e + (PI + (-1) * e) - t) with (PI - t) by ring.
    rewrite sin_PI_x; reflexivity.
