intros H; destruct (H 1 ltac:(lra)) as [n [n0 N]]; clear H; set (a := n + 100) in *.
assert (A : a >= 100) by (unfold a; lra).
assert (I : 0 < 1 * / (a + 1)) by positive; assert (I' : 0 < 1 * / a) by positive; assert (I2 : 0 < a * / (a + 1)) by positive.
destruct (claim_defect_is_one a 1) as [e [[P [Q D]] _]]; try lra.
pose proof (printed_above a e A P Q D) as G.
specialize (N a 1 e D P Q ltac:(lra) ltac:(lra) ltac:(lra) ltac:(unfold a; lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
rewrite (inverse_root a 1) in G, N by lra; set (c := / sqrt (1 * / a + 1)) in *.
replace ((-1) * 1 * c) with (- c) in N by ring.
replace ((-1) * PI * sqrt (a * 1)) with (- (PI * sqrt (a * 1))) in N by ring.
set (t := exp (- (PI * sqrt (a * 1)))) in *; set (g := exp (- c)) in *.
replace ((2 * c * g + t) * t + (-2) * c * g * t) with (t ^ 2) in N by ring.
rewrite (Rabs_pos_eq (t ^ 2)) in N by apply pow2_ge_0.
pose proof (Rle_abs (- (e + (-2) * c * g * t))) as M; rewrite Rabs_Ropp in M; lra.
