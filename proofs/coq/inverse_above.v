intros a A N1 N2 N3 N4 N5 N6 N7 N8.
destruct (claim_above_is_an_angle a A N1) as [E [F [S C]]].
set (e := / (a + 1) + 2 * atan (exp ((-1) * PI))) in *.
assert (B : / (a + 2) > 0) by (apply Rlt_gt; positive).
assert (L : / (a + 2) <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
replace (/ a * / (a + 2)) with (/ (a + 2) * / a) in * by ring.
apply claim_inverse_by_cotangent; try assumption; lra.
