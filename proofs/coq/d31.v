destruct (defect_exists (1517 / 121) (55 / 874) (11494412656569 / 10 ^ 14) (11494412656570 / 10 ^ 14)) as [e [[L U] E]];
  [lra | lra | lra | apply not_below; unfold turn_short; interval with (i_prec 90)
  | unfold turn_short; interval with (i_prec 90) |].
exists (1517 / 121), (55 / 874), e, (1 / 10000).
split; [exact E |]; repeat (split; [numeric |]).
match goal with |- context [is_RInt _ ?q _ _] => set (x := q) end.
assert (X : 11138698651 / 10 ^ 11 <= x <= 11138698653 / 10 ^ 11) by (unfold x; split; interval with (i_prec 60)).
clearbody x; clear E; eexists; split; [integrated | measured].
apply Rlt_not_eq; interval.
