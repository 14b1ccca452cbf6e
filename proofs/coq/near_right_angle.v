intros a b x g A B G_3 G_4 G_5 N_1 N_2; pose proof (sin_square x) as Q; set (s := sin x) in *; set (c := cos x) in *.
assert (P : 0 < (-1) * g * (b + a * s ^ 2) + a * b * c ^ 2).
{ pose proof (pow2_ge_0 s); pose proof (pow2_ge_0 c).
  assert (0 <= (-1) * g * (a * s ^ 2)) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (0 <= a * b * c ^ 2) by (apply Rmult_le_pos; [left; positive | lra]); nra. }
set (D := (-1) * g * (b + a * s ^ 2) + a * b * c ^ 2) in *.
replace ((-1) * / g * (b + g) + (-1) * / D * s ^ 2 * (a + b) * (b + g))
  with ((b + g) * (D + g * (a + b) * s ^ 2) * (/ (- g) * / D)) by (field; lra).
apply Rle_ge, Rmult_le_pos; [apply Rmult_le_pos; [lra |] | left; apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra].
replace (D + g * (a + b) * s ^ 2) with (c ^ 2 * (b * (a + (-1) * g))) by (unfold D; rewrite Q; ring).
apply Rmult_le_pos; [apply pow2_ge_0 | apply Rmult_le_pos; lra].
