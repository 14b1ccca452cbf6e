exists (1210), (16380), (17480), 1, 1, 0, 0, (/ 1210), 0, 0, (16380 * / 1210 + (-1)), ((-1) * 16380 * / 17480 + 1), (/ 1210), 0, 0, ((1 / 12) * PI), 0, 0, 0.
rewrite cos_0, sin_0; do 11 (split; [field |]); do 10 (split; [lra |]).
destruct (turned_level (16380 * / 1210 + (-1)) ((-1) * 16380 * / 17480 + 1) ltac:(lra) ltac:(lra) ltac:(lra)
  ((1 / 12) * PI) ltac:(interval) ltac:(interval) ((-42) / 10000) ((-415) / 100000)) as [c [C R]];
  [interval | lra | lra | unfold turned, end_turned, share_turned; split |].
- rewrite asin_by_atan by (split; interval with (i_prec 90)); measured; interval.
- rewrite asin_by_atan by (split; interval with (i_prec 90)); measured; interval.
- exists c; split; [exact R | apply Rabs_le; lra].
