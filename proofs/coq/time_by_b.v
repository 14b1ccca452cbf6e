intros a b e D E F A B B1 N1 N2 N3 N4 N5 N6 N7 N8.
assert (K : 0 < a * b) by positive.
pose proof (claim_phase_by_defect _ a b e eq_refl D E F A B B1 N5 N6 N4 K) as P.
rewrite P; set (s := arcsinh _); rewrite <- (product_root a b A B) at 1.
right; field; apply Rgt_not_eq, sqrt_lt_R0; exact K.
