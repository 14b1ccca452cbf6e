intros n F I1 I2 I3 M S a b x e g A B G T P Q J K; intros.
assert (A1 : 12531 / 1000 <= a <= 12544 / 1000) by (rewrite A; split; interval).
assert (B1 : 6285 / 100000 <= b <= 63 / 1000) by (rewrite B; split; interval).
assert (Z : turn_short a b e = 0) by (rewrite turn_short_is by lra; lra).
assert (L : 114 / 1000 <= e).
{ apply Rnot_lt_le; intros C; enough (turn_short a b e < 0) by lra; unfold turn_short; clear - A1 B1 C P.
  destruct A1, B1; interval with (i_bisect e). }
assert (U : e <= 116 / 1000).
{ apply Rnot_lt_le; intros C; enough (0 < turn_short a b e) by lra; unfold turn_short; clear - A1 B1 C Q.
  destruct A1, B1; assert (e <= 16 / 10) by interval; interval with (i_bisect e). }
clear - A1 B1 L U; destruct A1, B1; unfold Rabs; destruct (Rcase_abs _) as [V|V].
- interval with (i_bisect a, i_bisect b, i_bisect e).
- exfalso; apply (Rlt_irrefl 0); eapply Rle_lt_trans; [apply Rge_le, V | interval with (i_bisect a, i_bisect b, i_bisect e)].
