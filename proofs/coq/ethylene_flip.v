intros B1 B2 B3 I1 I2 I3 M a b e A B E P Q G_1 G_2 G_3 G_4 G_5 G_6 G_7 G_8 G_9; intros.
assert (A1 : 3628 / 1000 <= a <= 3643 / 1000).
{ replace a with (B1 * / B2 + (-1)) by (rewrite A, G_7, G_8; field; lra); split; interval. }
assert (B1' : 1719 / 10000 <= b <= 1738 / 10000).
{ replace b with (1 + (-1) * B3 * / B2) by (rewrite B, G_8, G_9; field; lra); split; interval. }
apply Rnot_le_lt; intros W; apply Rabs_le_between in W.
assert (X : 8 / 100 <= e <= 85 / 1000).
{ replace e with (2 * e * / PI * PI / 2) by (field; apply PI_neq0).
  set (w := 2 * e * / PI) in *; clearbody w.
  assert (527 / 10000 <= w <= 529 / 10000) by lra; split; interval. }
assert (Z : turn_short a b e = 0) by (rewrite turn_short_is by lra; lra).
clear - A1 B1' X Z; enough (turn_short a b e < 0) by lra; unfold turn_short.
destruct A1, B1', X; interval.
