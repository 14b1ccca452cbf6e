intros a b e _ E _ A B B1 E1; set (w := (2 * e) ^ 2).
assert (W : 0 < w <= 9 / 4) by (unfold w; nra); pose proof pi_between as J.
destruct (pre_sin_bound (2 * e) 0) as [L U]; try lra.
unfold sin_approx, sin_term in *; cbn in L, U.
assert (L' : 2 * e * (1 - w / 6) <= sin (2 * e)) by (eapply Rle_trans, L; unfold w; right; field).
assert (U' : sin (2 * e) <= 2 * e * (1 - w / 6 + w ^ 2 / 120)) by (eapply Rle_trans; [exact U |]; unfold w; right; field).
clear L U; set (s := sin (2 * e)) in *.
assert (0 < 2 * e * (1 - w / 6)) by nra.
assert (S1 : w * (1 - w / 6) ^ 2 <= s ^ 2).
{ replace (w * (1 - w / 6) ^ 2) with ((2 * e * (1 - w / 6)) ^ 2) by (unfold w; ring); nra. }
assert (S2 : s ^ 2 <= w * (1 - w / 6 + w ^ 2 / 120) ^ 2).
{ replace (w * (1 - w / 6 + w ^ 2 / 120) ^ 2) with ((2 * e * (1 - w / 6 + w ^ 2 / 120)) ^ 2) by (unfold w; ring); nra. }
assert (V : 7 / 32 * w < 1 - (1 - w / 6 + w ^ 2 / 120) ^ 2).
{ enough (7 / 32 < 1 / 3 - w * (1 / 36 + 1 / 60) + w ^ 2 / 360 - w ^ 3 / 14400) by nra.
  clear - W; interval with (i_bisect w). }
replace (e ^ 2) with (w / 4) by (unfold w; field); replace (e ^ 4) with (w ^ 2 / 16) by (unfold w; field).
assert (X : 7 / 32 * w ^ 2 < w - s ^ 2) by nra.
assert (Y : w - s ^ 2 < 3 / 8 * w ^ 2) by nra; split; nra.
