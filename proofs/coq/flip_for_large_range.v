intros S a b g p A B G_3 G_4 G_5 G_6 G_7.
assert (C : forall t, continuous (rate S a b g) t).
{ intros t; apply rate_continuous; trivial; pose proof (pow2_ge_0 (sin t)); nra. }
exists (RInt (rate S a b g) p (PI + p)), (RInt (rate S a b g) 0 PI); split; [| split].
- apply integral_correct; intros t _; apply C.
- apply integral_correct; intros t _; apply C.
- rewrite (integral_cut (rate S a b g) p PI (PI + p)), (integral_cut (rate S a b g) 0 p PI)
    by (intros t _; apply C).
  rewrite Rplus_comm; f_equal.
  pose proof (integral_new_variable (rate S a b g) (fun t => PI + t) (fun _ => 1) 0 p) as E.
  cbv beta in E; rewrite Rplus_0_r in E; rewrite E.
  + apply integral_under; intros t _; unfold rate.
    replace (sin (PI + t)) with (- sin t) by (rewrite Rplus_comm, neg_sin; reflexivity).
    replace ((- sin t) ^ 2) with (sin t ^ 2) by ring; ring.
  + intros t _; eapply d_eq; [derive |]; ring.
  + intros t _; apply continuous_const.
  + intros t _; apply C.
