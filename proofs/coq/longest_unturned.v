intros a b e A1 A2 B1 B2 E1 E2; pose proof pi_between as J.
pose (p := sin (261799 / 1000000) ^ 2).
pose (f := fun x : R => / sqrt (62929 / 1000000 * (125371 / 10000 * cos x ^ 2 + p * (62929 / 1000000 + 125371 / 10000 * sin x ^ 2)))
  - sqrt (62929 / 1000000 * (125371 / 10000 * cos x ^ 2 + p * (62929 / 1000000 + 125371 / 10000 * sin x ^ 2)))
    * / (31343 / 2500 + 6293 / 100000 * (sin x ^ 2 + cos x ^ 2 * (7 / 100)))).
assert (P : 66 / 1000 < p) by (unfold p; interval).
assert (S : p <= sin e ^ 2 <= 7 / 100).
{ unfold p; split; [apply pow_incr; split; [left; apply sin_gt_0; lra | apply sin_incr_1; lra] | interval]. }
assert (low : forall x : R, 0 < 62929 / 1000000 * (125371 / 10000 * cos x ^ 2 + p * (62929 / 1000000 + 125371 / 10000 * sin x ^ 2))).
{ intros x; pose proof (pow2_ge_0 (cos x)); pose proof (pow2_ge_0 (sin x)); nra. }
assert (G : (-1) * b * sin e ^ 2 < 0) by nra.
exists (RInt (u_rate a b ((-1) * b * sin e ^ 2)) 0 (1 / 2 * PI)); split.
{ eapply is_RInt_ext; [| apply integral_correct; intros x _; apply (u_rate_continuous a b ltac:(lra) ltac:(lra) _ x G)].
  intros x _; unfold u_rate, u_root, u_under, u_over; cbv beta.
  match goal with |- / sqrt ?p * / ?q * ?n = / sqrt ?r * / ?s * ?m =>
    replace p with r by ring; replace q with s by ring; replace n with m by ring; reflexivity end. }
apply Rle_lt_trans with (RInt f 0 (1 / 2 * PI)).
- apply integral_le; [lra | | |].
  + intros x _; apply (u_rate_continuous a b); lra.
  + intros x _; specialize (low x); pose proof (sqrt_lt_R0 _ low).
    pose proof (pow2_ge_0 (cos x)); pose proof (pow2_ge_0 (sin x)); unfold f; continues; nra.
  + intros x _; unfold u_rate; rewrite u_over_is; specialize (low x); unfold f; set (l := sqrt (62929 / 1000000 * _)).
    pose proof (u_root_above a b ltac:(lra) ltac:(lra) _ x G) as R0; pose proof (u_under_above a b ltac:(lra) ltac:(lra) _ x G) as Q0.
    pose proof (sqrt_lt_R0 _ R0) as S0; assert (L0 : 0 < l) by (apply sqrt_lt_R0, low); pose proof (pow2_sqrt _ (Rlt_le _ _ R0)) as E.
    assert (C : 0 <= cos x ^ 2 <= 1 /\ 0 <= sin x ^ 2 <= 1).
    { pose proof (cosine_square_at_most_one x); pose proof (sine_square_at_most_one x); lra. }
    assert (D : 0 <= p * sin x ^ 2) by (apply Rmult_le_pos; lra).
    assert (T : l <= sqrt (u_root a b ((-1) * b * sin e ^ 2) x)).
    { apply sqrt_le_1_alt; unfold u_root.
      replace ((-1) * ((-1) * b * sin e ^ 2) * (b + a * sin x ^ 2) + a * b * cos x ^ 2)
        with (b * (a * cos x ^ 2 + sin e ^ 2 * (b + a * sin x ^ 2))) by ring.
      apply Rmult_le_compat; [lra | lra | lra |]; apply Rplus_le_compat; [apply Rmult_le_compat_r; lra |].
      apply Rmult_le_compat; [lra | lra | lra |]; apply Rplus_le_compat; [lra | apply Rmult_le_compat_r; lra]. }
    set (q := 31343 / 2500 + _); assert (Q : u_under a b ((-1) * b * sin e ^ 2) x <= q).
    { unfold u_under, q; replace (a + b * sin x ^ 2 + (-1) * ((-1) * b * sin e ^ 2) * cos x ^ 2)
        with (a + b * (sin x ^ 2 + cos x ^ 2 * sin e ^ 2)) by ring.
      apply Rplus_le_compat; [lra |]; apply Rmult_le_compat; [lra | nra | lra |].
      apply Rplus_le_compat_l, Rmult_le_compat_l; lra. }
    set (r := sqrt (u_root _ _ _ _)) in *; rewrite <- E; set (u := u_under _ _ _ _) in *.
    replace (/ r * / u * (u - r ^ 2)) with (/ r - r * / u) by (field; lra).
    assert (/ r <= / l) by (apply Rinv_le_contravar; [exact L0 | exact T]).
    assert (l * / q <= r * / u); [| lra].
    apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | exact T | apply Rinv_le_contravar; lra].
- unfold f, p; measured; lra.
