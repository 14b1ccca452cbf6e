intros k G_1 G_2; pose proof pi_between.
assert (M : sinh (3 / 2 * PI * k) <= k * sinh (3 / 2 * PI)).
{ assert (E : forall t, 0 <= t <= 3 / 2 * PI -> is_derive sinh t (cosh t)).
  { intros t _; apply is_derive_Reals, derivable_pt_lim_sinh. }
  destruct (mean_value sinh cosh 0 (3 / 2 * PI * k)) as [c [C1 C2]]; [nra | |].
  { intros t T; apply E; nra. }
  destruct (mean_value sinh cosh (3 / 2 * PI * k) (3 / 2 * PI)) as [d [D1 D2]]; [nra | |].
  { intros t T; apply E; nra. }
  rewrite sinh_0 in C2.
  assert (L : cosh c <= cosh d).
  { destruct (mean_value cosh sinh c d) as [u [U1 U2]]; [lra | |].
    - intros t _; apply is_derive_Reals, derivable_pt_lim_cosh.
    - assert (0 <= sinh u); [| nra].
      destruct (Rle_lt_or_eq_dec 0 u ltac:(lra)) as [P|P]; [| rewrite <- P, sinh_0; lra].
      pose proof (sinh_lt 0 u P) as Q; rewrite sinh_0 in Q; lra. }
  set (h := 3 / 2 * PI) in *; assert (Z : sinh (h * k) = cosh c * (h * k)) by lra.
  assert (Y : sinh h = sinh (h * k) + cosh d * (h - h * k)) by lra.
  rewrite Y, Z; assert (0 <= h * k * (1 - k)) by (unfold h; apply Rmult_le_pos; nra); nra. }
assert (sinh (3 / 2 * PI) <= 56) by (unfold sinh; interval); nra.
