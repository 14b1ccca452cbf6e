intros a A _ _ _ _ _ _; assert (I : 0 < / (a + 1)) by positive.
assert (J : / (a + 1) <= / 8) by (apply Rinv_le_contravar; lra); rewrite <- pow_inv; set (u := / (a + 1)) in *.
pose proof claim_excess_at_infinity as Z; cbv beta in Z.
set (f := fun u : R => (-1) * arcsinh (sqrt ((-1) * u ^ 2 + 1) * / (sin (u + 2 * atan (exp ((-1) * PI)))) * cos (u + 2 * atan (exp ((-1) * PI)))) + / (u + 1) * sqrt ((-1) * u ^ 2 + 1) * (PI + asin (u * cos (u + 2 * atan (exp ((-1) * PI)))))) in *.
assert (M : / 100 <= 2 * atan (exp ((-1) * PI)) <= / 10) by (split; interval).
assert (P : 3 < PI) by interval.
assert (D : forall t, 0 <= t <= u -> is_derive f t (Derive f t) /\ 0 < Derive f t).
{ intros t T; assert (S : 0 < sin (t + 2 * atan (exp ((-1) * PI)))) by (apply sin_gt_0; lra).
  pose proof (COS_bound (t + 2 * atan (exp ((-1) * PI)))) as C.
  destruct (claim_excess_grows t) as [v [V W]]; try lra; try nra.
  rewrite (is_derive_unique f t v V); split; [exact V | exact W]. }
change (f u > 0); apply Rlt_gt, (from_left_gt f (Derive f) 0 u I); [| | right; symmetry; exact Z].
{ intros t T; apply (proj1 (D t T)). }
intros t T; apply D; lra.
