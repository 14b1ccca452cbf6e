intros a b e A B B1 E F S C _ _ _ _ _ _ _ _ _ _; pose proof PI_RGT_0.
pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)).
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
set (x := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))).
assert (X : 0 < sinh x) by (rewrite <- sinh_0; apply sinh_lt; unfold x; nra).
rewrite (inverse_root a b A B); destruct (root_facts a b e A B) as [W [Q G]].
split; intro J.
{ assert (Y : sinh x = / sqrt (b * / a + 1) * / sin e * cos e).
  { transitivity (/ sqrt (b * / a + 1) * / tan e); [rewrite <- J | unfold tan]; field; lra. }
  set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (q := sqrt (b * / a + 1)) in *.
  assert (Z : cosh x = w * / q * / sin e).
  { apply same_square; [left; apply cosh_pos | left; positive |]; rewrite cosh_square, Y.
    transitivity ((q ^ 2 * sin e ^ 2 + cos e ^ 2) * (/ q * / sin e) ^ 2); [field; lra |].
    rewrite G; ring. }
  unfold tanh; rewrite Y, Z; field; lra. }
rewrite (sinh_at_root a b x e A B S C (eq_sym J)); unfold tan; field; lra.
