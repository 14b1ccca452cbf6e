intros a b g x A B B1 L G B2 N1 N2 N3 N4 N5 N6 N7 N8 N9 N10 N11 N12.
change (a + b * sin x ^ 2 + (-1) * g * cos x ^ 2) with (u_under a b g x) in *.
change ((-1) * g * (b + a * sin x ^ 2) + a * b * cos x ^ 2) with (u_root a b g x) in *.
change (cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * g) + sin x ^ 2 * (g + 1) * (a + b)) with (u_over a b g x) in *.
assert (G' : g < 0) by lra; assert (L' : - b < g) by lra.
pose proof (u_root_above a b A B g x G') as P; pose proof (u_under_above a b A B g x G') as Q.
pose proof (u_over_above a b A B B1 g x G' L' (or_introl B2)) as O.
pose proof (sqrt_lt_R0 _ P) as S; pose proof (pow2_sqrt _ (Rlt_le _ _ P)) as R2.
assert (U : 0 < b + g) by lra; assert (V : 0 < a + b) by lra.
pose proof (sqrt_lt_R0 _ U) as U0; pose proof (sqrt_lt_R0 _ V) as V0.
pose proof (pow2_sqrt _ (Rlt_le _ _ U)) as U2; pose proof (pow2_sqrt _ (Rlt_le _ _ V)) as V2.
assert (I : / u_root a b g x * sin x ^ 2 * (a + b) * (b + g) + 1 = b * u_under a b g x * / u_root a b g x).
{ rewrite <- (u_share_square a b g x A B L' G'); unfold u_share; rewrite !Rpow_mult_distr, pow_inv, U2, V2, R2; ring. }
assert (E : sqrt (/ (a + b) * (b + g)) = / sqrt (a + b) * sqrt (b + g)).
{ rewrite sqrt_mult_alt, sqrt_inv by (left; positive); reflexivity. }
assert (M : (-1) * b * / (b * u_under a b g x * / u_root a b g x) + 1 = u_over a b g x * / u_under a b g x).
{ rewrite u_over_is; field; lra. }
rewrite I, M, E in *; split.
- assert (F : (-1) * / (a + b) * cos x ^ 2 * (b + g) + 1 = u_under a b g x * / (a + b)).
  { unfold u_under; rewrite (sin_square x); field; lra. }
  assert (W : 0 < u_under a b g x * / (a + b)) by positive; rewrite F; pose proof (sqrt_lt_R0 _ W) as T.
  pose proof (pow2_sqrt _ (Rlt_le _ _ W)) as T2.
  eapply d_eq; [derive; lra |]; cbv beta.
  replace ((-1) * (/ sqrt (a + b) * sqrt (b + g) * cos x) ^ 2 + 1) with (u_under a b g x * / (a + b)).
  { set (t := sqrt (_ * / (a + b))) in *; set (v := sqrt (a + b)) in *; set (u := sqrt (b + g)) in *.
    assert (Y : u_under a b g x = t ^ 2 * v ^ 2) by (rewrite T2, V2; field; lra).
    set (q := u_under a b g x) in *; clearbody q; rewrite Y in *; field; repeat split; lra. }
  rewrite <- F, !Rpow_mult_distr, pow_inv, U2, V2; ring.
- eapply d_eq; [apply (u_angle_rate a b g x); lra |].
  assert (Y : a + b * / (b * u_under a b g x * / u_root a b g x) = / u_under a b g x * (sqrt (a + b) ^ 2 * (a - g))).
  { rewrite V2; unfold u_under, u_root in *; rewrite (sin_square x) in *; field; lra. }
  rewrite Y; field; repeat split; lra.
