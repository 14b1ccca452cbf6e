intros F S a b e D A B G_3 G_4 G_5 G_6 G_7 G_8 G_9.
replace 0 with (RInt (over S a b F e) e (1 / 2 * PI)).
- apply (integral_correct (over S a b F e)); intros t T; rewrite Rmin_left, Rmax_right in T by lra.
  apply (continuous_plus (fun _ => _) (zero_rate S a b)); [apply continuous_const |].
  apply zero_continuous; trivial; apply sin_gt_0; lra.
- rewrite over_integral by lra.
  replace (RInt (zero_rate S a b) e (1 / 2 * PI)) with F by (symmetry; exact (is_RInt_unique _ _ _ _ D)).
  over_reals; field; lra.
