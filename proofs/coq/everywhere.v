intros a b e s D E E0 E1 A B B1 _ _ _ _ _.
pose proof (stretched_within a b e A B B1 E0 ltac:(lra) E) as W.
assert (R0 : 0 < b * / a) by positive; destruct (stretched_least _ R0) as [L _].
pose proof (leading_of_defect a b e A B E0 ltac:(lra) E) as F.
pose proof (ratio_of_leading a b e _ (stretched a b) A B E0 ltac:(lra) F ltac:(unfold stretched; lra) W) as G.
rewrite <- D in G; rewrite (inverse_root a b A B) in D.
assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra); assert (Q2 : sqrt (b * / a + 1) ^ 2 = b * / a + 1) by (apply pow2_sqrt; lra).
unfold stretched in G; replace (1 + b * / a) with (b * / a + 1) in G by ring.
set (p := PI + asin (sqrt (b * / (a + b)))) in *; set (k := sqrt (a * b)) in *.
replace ((-3) * k * p) with ((-1) * k * p + ((-1) * k * p + (-1) * k * p)) by ring; rewrite !exp_plus.
pose proof (exp_pos ((-1) * k * p)) as X; set (x := exp ((-1) * k * p)) in *; set (r := b * / a + 1) in *; set (q := sqrt r) in *.
assert (S : 0 < s) by (rewrite D; positive).
replace (e + (-1) * s) with (s * (e * / s + -1)) by (field; lra); rewrite Rabs_mult, (Rabs_pos_eq s) by lra.
apply Rle_trans with (s * (5 / 12 * (r * q) * s ^ 2)); [apply Rmult_le_compat_l; lra |].
rewrite D, <- Q2; right; field; lra.
