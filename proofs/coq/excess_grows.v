intros u U V; intros; eexists; split; [derive; first [lra | interval] | tidy]; rewrite Rmult_0_l.
rewrite asin_by_atan by (split; interval).
assert (P : 863740970 / 10 ^ 10 <= 2 * atan (exp ((-1) * PI)) <= 863740971 / 10 ^ 10) by (split; interval).
set (p := 2 * atan (exp ((-1) * PI))) in *; clearbody p; clear - U V P; destruct P.
apply Rlt_gt; interval with (i_bisect u).
