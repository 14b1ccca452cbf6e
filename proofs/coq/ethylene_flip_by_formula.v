intros B1 B2 B3 I1 I2 I3 M a b f D_1 D_2 D_3 G_1 G_2 G_3 G_4 G_5 G_6 G_7 G_8 G_9; intros.
assert (A : a = B1 * / B2 + (-1)) by (rewrite D_1, G_7, G_8; field; lra).
assert (B : b = 1 + (-1) * B3 * / B2) by (rewrite D_2, G_8, G_9; field; lra).
assert (A1 : 3628 / 1000 <= a <= 3643 / 1000) by (rewrite A; split; interval).
assert (B1' : 1719 / 10000 <= b <= 1738 / 10000) by (rewrite B; split; interval).
rewrite D_3; clear - A1 B1'; destruct A1 as [A1 A2], B1' as [C1 C2].
interval with (i_bisect a, i_bisect b, i_depth 20).
