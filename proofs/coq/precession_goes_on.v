intros a b g y A B G_3 G_4 G_5 G_6 G_7 G_8; split.
- assert (0 <= y * ((g + 1) * (a + b))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (0 <= (1 - y) * (((-1) * b + 1) * (a + (-1) * g))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  destruct (Rle_lt_or_eq_dec 0 y ltac:(lra)) as [Y|Y].
  + assert (0 < y * ((g + 1) * (a + b))) by positive; lra.
  + subst y; assert (0 < ((-1) * b + 1) * (a + (-1) * g)) by positive; lra.
- assert (0 < (-1) * g * b) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (-1) * g * (a * y)) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (0 <= a * b * ((-1) * y + 1)) by (apply Rmult_le_pos; [left; positive | lra]); lra.
