intros a b c d e A B L E G_5 C C' F D D' H.
destruct (Rtotal_order c d) as [W|[W|W]]; [exfalso | now symmetry | exfalso].
- pose proof (turn_by_rising_level a b e c d A B L E C W); unfold plain in *; lra.
- pose proof (turn_by_rising_level a b e d c A B L E D W); unfold plain in *; lra.
