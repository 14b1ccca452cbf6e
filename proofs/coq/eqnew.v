intros a b e D P Q A B B1 AB E; intros.
destruct (defect_signs a b e A B P Q) as [S [C [R0 _]]].
assert (R4 : b * / a <= 4) by (apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, Rinv_l; lra).
destruct (share_of_sum (b * / a) e R0 R4 P E) as [L U].
rewrite (inverse_root a b) by lra.
replace ((-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  with (- (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))) by ring.
rewrite (decay a b _ e A B S C D); assert (q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
set (h := sin e * _) in L, U.
replace (e + (-2) * / sqrt (b * / a + 1) * (sqrt (b * / a + 1) * / (sqrt (b * / a * sin e ^ 2 + 1) + cos e) * sin e))
  with (e - 2 * h) by (unfold h; field; split; [pose proof (root_above a b e A B) as W; unfold root_of in W; lra | lra]).
clearbody h; apply Rabs_le; assert (0 < e ^ 3) by (apply pow_lt; lra); split; nra.
