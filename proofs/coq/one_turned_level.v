intros a b c d e A B L E F G H C C' X D D' Y.
destruct (Rtotal_order c d) as [W|[W|W]]; [exfalso | now symmetry | exfalso].
- pose proof (half_turn_rises a b A B L e E F c d ltac:(lra) W D'); unfold turned, end_turned, share_turned in *; lra.
- pose proof (half_turn_rises a b A B L e E F d c ltac:(lra) W C'); unfold turned, end_turned, share_turned in *; lra.
