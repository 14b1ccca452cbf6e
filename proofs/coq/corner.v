intros a b A B B1 AB _ _ _.
assert (K : 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
assert (K2 : sqrt (a * b) ^ 2 = a * b) by (apply pow2_sqrt; lra).
set (k := sqrt (a * b)) in *; assert (I : 0 < / k) by positive.
assert (X : / k <= 1 / 2) by (replace (1 / 2) with (/ 2) by field; apply Rinv_le_contravar; lra).
assert (X2 : (/ k) ^ 2 = / a * / b) by (rewrite pow_inv, K2; field; lra).
assert (Y : b ^ 2 * (/ k) ^ 2 = b * / a) by (rewrite X2; field; lra).
pose proof (claim_corner_margin b (/ k) B B1 I X) as C.
rewrite Y in C; specialize (C ltac:(assert (0 < b * / a) by positive; lra)).
replace (5 / 12 * b ^ 2 * (/ k) ^ 2) with (5 / 12 * (b ^ 2 * (/ k) ^ 2)) in C by ring.
replace (1 / 4 * b ^ 2 * (/ k) ^ 2) with (1 / 4 * (b ^ 2 * (/ k) ^ 2)) in C by ring.
replace (((-1) / 4) * b ^ 2 * (/ k) ^ 2) with (((-1) / 4) * (b ^ 2 * (/ k) ^ 2)) in C by ring.
rewrite Y, X2 in C.
replace (5 / 12 * b * / a) with (5 / 12 * (b * / a)) by ring.
replace ((-1) / 4 * b * / a) with ((-1) / 4 * (b * / a)) by ring.
replace (3 / 8 * / a * / b) with (3 / 8 * (/ a * / b)) by ring; exact C.
