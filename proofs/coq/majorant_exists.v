intros a b e _ _ _ A B B1 AB _ _ _.
assert (I : 0 < / a) by positive; assert (J : a * / a = 1) by (field; lra).
assert (R0 : 0 <= b * / a <= 4) by (split; [nra |]; apply (Rmult_le_reg_r a); nra).
replace (9 * b * / a + 4) with (9 * (b * / a) + 4) by ring; set (r := b * / a) in *; clearbody r.
unfold sinh; interval with (i_bisect r).
