intros a A _ _ _ _ _; assert (I : 0 < / (a + 1)) by positive.
assert (J : / (a + 1) * (a + 1) = 1) by (field; lra); rewrite <- pow_inv; set (u := / (a + 1)) in *.
assert (U : u < 1) by nra; assert (T : -1 < tanh PI < 1) by (split; interval).
apply claim_floor_candidate; try lra; nra.
