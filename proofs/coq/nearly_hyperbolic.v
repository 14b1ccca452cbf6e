intros a b e D E F A B B1 L N1 N2 N3 N4; pose proof PI_RGT_0.
destruct (claim_remark1 a b e D E F A B B1 L N1) as [U V].
rewrite (Rmult_comm PI) in U, V; set (k := sqrt (a * b)) in *.
assert (I : forall x, / PI * x = x / PI) by (intro; unfold Rdiv; ring).
repeat split.
{ rewrite I; apply Rlt_gt, (Rmult_lt_reg_r PI); [lra |]; replace (_ / PI * PI) with (ln (13 / 25 * / e)) by (field; lra).
  rewrite <- (ln_exp (k * PI)); apply ln_increasing; [positive |].
  apply (Rmult_lt_reg_l e); [lra |]; replace (e * (13 / 25 * / e)) with (13 / 25) by (field; lra); lra. }
{ rewrite I; apply (Rmult_lt_reg_r PI); [lra |]; replace (_ / PI * PI) with (ln (201 / 100 * / e)) by (field; lra).
  rewrite <- (ln_exp (k * PI)); apply ln_increasing; [apply exp_pos |].
  apply (Rmult_lt_reg_l e); [lra |]; replace (e * (201 / 100 * / e)) with (201 / 100) by (field; lra); lra. }
interval.
