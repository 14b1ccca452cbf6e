intros a b x v -> -> X1 X2 V1 V2; pose proof pi_between as J.
assert (C : 16 / 100000 <= start_level (1517 / 121) (55 / 874) x v <= 180 / 100000) by (unfold start_level; split; interval).
split; eexists; (split; [apply start_turn; lra |]).
- destruct (Rle_or_lt x (1 / 20)) as [H|H].
  + assert (D : 63 / 100000 <= start_level (1517 / 121) (55 / 874) x v) by (unfold start_level; interval).
    eapply Rle_lt_trans; [apply (starts_below (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) (63 / 100000) _ (- (1 / 20)) _ (1 / 20)); lra |].
    unfold u_plain; estimated; interval.
  + eapply Rle_lt_trans; [apply (starts_below (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) (16 / 100000) _ (1 / 20) _ (1 / 10)); lra |].
    unfold u_plain; estimated; interval.
- eapply Rlt_le_trans; [| apply (starts_above (1517 / 121) (55 / 874) ltac:(lra) ltac:(lra) ltac:(lra) _ (180 / 100000) (- (1 / 20)) _ (1 / 10)); lra].
  unfold u_plain; estimated; interval.
