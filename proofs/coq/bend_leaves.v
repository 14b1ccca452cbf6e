intros a b e D P Q A B B1 E; intros.
destruct (small_sine e) as [[S1 S2] _]; try lra; rewrite sin_2a.
set (v := e ^ 2); assert (V : 0 < v <= 9 / 16) by (unfold v; nra).
replace (e ^ 4) with (v ^ 2) in * by (unfold v; ring); fold v in S1, S2.
assert (s0 : 0 < sin e) by (apply sin_gt_0; pose proof pi_between; lra).
replace ((2 * sin e * cos e) ^ 2) with (4 * (sin e ^ 2 * (1 - sin e ^ 2)))
  by (pose proof (sin_square e) as W; rewrite W; ring_simplify; replace (sin e ^ 2) with (1 - cos e ^ 2) by lra; ring).
set (A1 := (1 - v / 6) ^ 2); set (A2 := (1 - v / 6 + v ^ 2 / 120) ^ 2).
assert (L : v * A1 <= sin e ^ 2).
{ replace (v * A1) with ((e * (1 - v / 6)) ^ 2) by (unfold A1, v; ring); apply pow_incr; split; [apply Rmult_le_pos; lra | exact S1]. }
assert (U : sin e ^ 2 <= v * A2).
{ replace (v * A2) with ((e * (1 - v / 6 + v ^ 2 / 120)) ^ 2) by (unfold A2, v; ring); apply pow_incr; lra. }
set (w := sin e ^ 2) in *; clearbody w v; clear S1 S2 s0.
assert (H1 : v * A2 <= 1 / 2) by (unfold A2; interval with (i_bisect v)).
assert (G1 : w * (1 - w) <= v * A2 * (1 - v * A2)) by nra.
assert (G2 : v * A1 * (1 - v * A1) <= w * (1 - w)) by nra.
assert (C1 : 0 < 4 * (1 / 6 - v / 120) * (2 - v / 6 + v ^ 2 / 120) + 4 * A2 ^ 2 - 7 / 2) by (unfold A2; interval with (i_bisect v)).
assert (C2 : 0 < 6 - 2 / 3 * (2 - v / 6) - 4 * A1 ^ 2) by (unfold A1; interval with (i_bisect v)).
assert (v2 : 0 < v ^ 2) by nra.
assert (F1 : 4 * (v * A2 * (1 - v * A2)) = 4 * v - v ^ 2 * (4 * (1 / 6 - v / 120) * (2 - v / 6 + v ^ 2 / 120) + 4 * A2 ^ 2))
  by (unfold A2; field).
assert (F2 : 4 * (v * A1 * (1 - v * A1)) = 4 * v - v ^ 2 * (2 / 3 * (2 - v / 6) + 4 * A1 ^ 2)) by (unfold A1; field).
assert (O1 : 7 / 2 * v ^ 2 < 4 * v - 4 * (w * (1 - w))) by nra.
assert (O2 : 4 * v - 4 * (w * (1 - w)) < 6 * v ^ 2) by nra.
split; nra.
