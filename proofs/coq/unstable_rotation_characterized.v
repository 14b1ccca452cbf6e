intros a b p A B G N; pose proof (forward b B p G); pose proof (reach a b A B p); apply Rlt_gt; positive.
