intros Q a b e f D_1 D_2 D_3 D_4 D_5 A B G_3.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
rewrite D_1, (D_5 D_3 D_4 S C); clear D_1 D_5.
pose proof (share_below a b 0 A B) as H0; rewrite cos_0, Rmult_1_r in H0; pose proof (share_below a b e A B) as H1.
destruct (root_facts a b e A B) as [W [P F]].
pose proof (decay a b _ e A B S C D_2) as D; cbv zeta in *.
assert (T : 0 < b * / a) by positive.
set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (q := sqrt (b * / a + 1)) in *.
set (r := sqrt (b * / a)) in *.
assert (R2 : r ^ 2 = b * / a) by (apply pow2_sqrt; lra).
assert (R0 : 0 < r) by (apply sqrt_lt_R0; lra).
assert (Z : asin (sqrt (b * / (a + b))) = asin (sqrt (b * / (a + b)) * cos e) + asin (r * / (w + cos e) * sin e ^ 2)).
{ assert (V : w ^ 2 = r ^ 2 * sin e ^ 2 + 1) by (unfold w; rewrite pow2_sqrt, R2; [reflexivity | pose proof (pow2_ge_0 (sin e)); nra]).
  assert (U : 0 <= r * / (w + cos e) * sin e ^ 2 <= 1).
  { assert (I : 0 < / (w + cos e)) by positive; split; [left; positive |].
    apply (Rmult_le_reg_r (w + cos e)); [lra |].
    replace (r * / (w + cos e) * sin e ^ 2 * (w + cos e)) with (r * sin e ^ 2) by (field; lra).
    assert (r * sin e ^ 2 <= r * sin e) by (pose proof (SIN_bound e); assert (sin e ^ 2 <= sin e) by nra; nra).
    assert (r * sin e <= w) by (apply below_sqrt; rewrite Rpow_mult_distr, R2; lra); lra. }
  apply claim_turn_as_one; try assumption; try lra; fold r w; try lra.
  - left; positive.
  - unfold w; pose proof (pow2_ge_0 (sin e)); nra. }
rewrite Z, (inverse_root a b A B); fold q.
replace ((-1) * sqrt (a * b) * (PI + (asin (sqrt (b * / (a + b)) * cos e) + asin (r * / (w + cos e) * sin e ^ 2))))
  with (- (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) + (-1) * (sqrt (a * b) * asin (r * / (w + cos e) * sin e ^ 2)))
  by ring.
rewrite exp_plus, D; set (k := sqrt (a * b) * asin (r * / (w + cos e) * sin e ^ 2)).
assert (0 < e * / sin e) by positive.
replace ((-1) * (k + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e)))
  with ((-1) * k + - (ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e))) by ring.
rewrite exp_plus, exp_Ropp, exp_plus, !exp_ln by lra; field; repeat split; lra.
