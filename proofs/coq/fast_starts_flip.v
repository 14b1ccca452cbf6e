intros a b x v -> -> X1 X2 V1 V2; pose proof pi_between as J.
assert (C : 116 / 100000 <= start_level (1517 / 121) (55 / 874) x v <= 719 / 100000) by (unfold start_level; split; interval).
split; eexists; (split; [apply start_turn; lra |]).
- eapply Rle_lt_trans; [apply (starts_below (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) (116 / 100000) _ (- (1 / 10)) _ (1 / 10)); lra |].
  unfold u_plain; estimated; interval.
- destruct (Rle_or_lt x (1 / 20)) as [H|H].
  + eapply Rlt_le_trans; [| apply (starts_above (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) _ (719 / 100000) (- (1 / 10)) _ (1 / 20)); lra].
    unfold u_plain; estimated; interval.
  + assert (D : start_level (1517 / 121) (55 / 874) x v <= 703 / 100000) by (unfold start_level; interval).
    eapply Rlt_le_trans; [| apply (starts_above (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) _ (703 / 100000) (1 / 20) _ (1 / 10)); lra].
    unfold u_plain; estimated; interval.
