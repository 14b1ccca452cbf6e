intros a b e D P Q A B B1 AB E; intros.
destruct (defect_signs a b e A B P Q) as [S [C [R0 _]]].
assert (R4 : b * / a <= 4) by (apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, Rinv_l; lra).
destruct (share_of_sum (b * / a) e R0 R4 P E) as [L U].
set (x := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) in *.
replace ((-2) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) with (- x + - x) by (unfold x; ring).
rewrite exp_plus, (decay a b _ e A B S C D); fold x.
assert (q : sqrt (b * / a + 1) ^ 2 = b * / a + 1) by (apply pow2_sqrt; lra).
set (h := sin e * _) in L, U; set (r := b * / a) in *.
replace ((-1) * (sqrt (r + 1) * / (sqrt (r * sin e ^ 2 + 1) + cos e) * sin e * (sqrt (r + 1) * / (sqrt (r * sin e ^ 2 + 1) + cos e) * sin e)))
  with ((-1) * (sqrt (r + 1) ^ 2 * h ^ 2)) by (unfold h; ring).
rewrite q; replace ((-1) * ((r + 1) * h ^ 2) + 1 / 4 * e ^ 2 * (r + 1)) with ((r + 1) * (e ^ 2 / 4 - h ^ 2)) by field.
rewrite Rabs_mult, (Rabs_pos_eq (r + 1)) by lra.
replace (23 / 50 * e ^ 4 * (r + 1)) with ((r + 1) * (23 / 50 * e ^ 4)) by ring; apply Rmult_le_compat_l; [lra |].
clearbody h; assert (V : 0 < e ^ 2 <= 1 / 16) by nra; assert (e4 : e ^ 4 = e ^ 2 * e ^ 2) by ring; rewrite e4.
assert (h0 : 0 <= (1 - 23 / 25 * e ^ 2) / 2 * e) by (apply Rmult_le_pos; lra).
assert (HL : ((1 - 23 / 25 * e ^ 2) / 2 * e) ^ 2 <= h ^ 2) by (apply pow_incr; lra).
assert (HU : h ^ 2 <= ((1 + e ^ 2 / 4) / 2 * e) ^ 2) by (apply pow_incr; lra).
rewrite Rpow_mult_distr in HL, HU; set (v := e ^ 2) in *; clearbody v; apply Rabs_le; split; nra.
