intros a b e D E F A B B1 _ _ _ _ _ _ _ _ _ _ _.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
destruct (root_facts a b e A B) as [W [Q G]]; pose proof (decay a b _ e A B S C D) as H.
set (x := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) in *.
assert (RA : 0 < sqrt a) by (apply sqrt_lt_R0; exact A); assert (R : 0 < b * / a) by positive.
replace (a + b * sin e ^ 2) with (a * (b * / a * sin e ^ 2 + 1)) by (field; lra).
replace (a + b) with (a * (b * / a + 1)) by (field; lra).
rewrite !sqrt_mult by nra; set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (q := sqrt (b * / a + 1)) in *.
rewrite <- (ln_exp x), <- ln_mult by (first [apply exp_pos | positive]); f_equal.
replace (exp x) with (/ exp (- x)) by (rewrite exp_Ropp, Rinv_inv; reflexivity).
rewrite H; field; repeat split; lra.
