intros a b e; intros; destruct (exponent_parts a b e) as [w [W [V L]]]; try lra; rewrite L; clear L; unfold tan.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
set (m := sqrt (a * / (a + b))) in *; assert (M : 0 < m) by (apply sqrt_lt_R0; assumption).
set (t := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) in *.
assert (T : 0 < t).
{ pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)); pose proof PI_RGT_0.
  apply Rmult_lt_0_compat; lra. }
assert (S : 0 < sinh t) by (rewrite <- sinh_0; now apply sinh_lt).
set (s := sin e) in *; set (c := cos e) in *; assert (F : w = exp t <-> sinh t = m * c * / s).
{ rewrite sinh_law; pose proof (exp_pos t) as X; set (x := exp t) in *; split; intros Y; [rewrite <- Y; lra |].
  assert (E : (x - w) * (x * w + 1) = 0).
  { assert (D : x - / x = w - / w) by lra.
    replace ((x - w) * (x * w + 1)) with (x * w * ((x - / x) - (w - / w))) by (field; lra); rewrite D; ring. }
  apply Rmult_integral in E; destruct E; nra. }
split; intros Y.
- enough (w = exp t) as -> by (rewrite ln_exp; ring); apply F.
  apply (Rmult_eq_reg_r (s * / (c * sinh t))); [| apply Rgt_not_eq; positive].
  transitivity (s / c); [field; lra | rewrite <- Y; field; lra].
- assert (E : ln w = t) by lra; rewrite (proj1 F) by (now rewrite <- E, exp_ln); field; lra.
