intros b x B B1 X X1 N.
assert (Y : 0 <= b ^ 2 * x ^ 2) by (rewrite <- Rpow_mult_distr; apply pow2_ge_0).
set (s := sqrt (b ^ 2 * x ^ 2 + 1)).
assert (S2 : s ^ 2 = b ^ 2 * x ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (S1 : 1 <= s) by (apply below_sqrt; lra).
assert (C : 1 + 3 / 2 * (b ^ 2 * x ^ 2) <= s * (b ^ 2 * x ^ 2 + 1)).
{ replace (b ^ 2 * x ^ 2) with (s ^ 2 - 1) by lra; assert (0 <= (s - 1) ^ 2 * (2 * s + 1)) by (apply Rmult_le_pos; [apply pow2_ge_0 | lra]); lra. }
assert (P : 0 <= (1 - b) * (1 - 3 / 4 * (x ^ 2 * (1 + b)))).
{ assert (x ^ 2 <= 1 / 4) by nra; apply Rmult_le_pos; [lra |]; assert (0 <= x ^ 2) by nra; nra. }
lra.
