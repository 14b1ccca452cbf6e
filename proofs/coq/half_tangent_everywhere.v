intros a b e s D E F Ds A B B1 N1 N2 N3 N4 N5 N6 N7 N8 N9.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
pose proof (claim_leading_by_defect _ a b e s Ds D E F (fun _ _ _ _ => eq_refl) A B B1) as L.
destruct (root_facts a b e A B) as [W [Q G]]; set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *.
set (y := sqrt (a * b) * asin (sqrt (b * / a) * / (w + cos e) * sin e ^ 2)) in *.
assert (V : 0 < 1 / 2 * w + 1 / 2 * cos e) by lra; assert (U : 0 < e * / sin e) by positive.
replace ((-1) * (y + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e)))
  with (- y + (- ln (e * / sin e) + - ln (1 / 2 * w + 1 / 2 * cos e))) in L by ring.
rewrite !exp_plus, !exp_Ropp, !exp_ln in L by assumption.
pose proof (exp_pos y); rewrite L.
transitivity (sin e * / (cos e + 1)); [| field; repeat split; lra].
replace e with (2 * (1 / 2 * e)) at 2 3 by field; set (h := 1 / 2 * e) in *.
rewrite sin_2a, cos_2a_cos; unfold tan; field; split; [nra | exact N1].
