intros I1 I2 I3 M M1 M2 M3 O1 O2 O3 a b p q r e f g h A B; intros.
assert (A1 : 12531 / 1000 <= a <= 12544 / 1000) by (rewrite A; split; interval).
assert (B1 : 6285 / 100000 <= b <= 63 / 1000) by (rewrite B; split; interval).
assert (e <= 1 / 2 * PI) by (subst e; interval).
pose proof (turn_by_shape a b (12531 / 1000) (6285 / 100000) (1038 / 100000) e) as U.
pose proof (turn_by_shape (12544 / 1000) (63 / 1000) a b (1032 / 100000) e) as L.
destruct (level_between a b e (1032 / 100000) (1038 / 100000)) as [c [C R]]; try lra.
{ subst e; interval. }
{ split; [eapply Rle_lt_trans; [apply U; lra |] | eapply Rlt_le_trans; [| apply L; lra]];
  subst e; clear; unfold plain; measured; interval. }
exists c; split; [exact R |]; unfold Rabs; destruct (Rcase_abs _); lra.
