exists (1210), (16380), (17480), 1, 1, 0, 0, (/ 1210), 0, 0, (16380 * / 1210 + (-1)), ((-1) * 16380 * / 17480 + 1), (/ 1210), 0, 0, (0), 0, 0, 0.
rewrite cos_0, sin_0; do 11 (split; [field |]); do 13 (split; [lra |]).
destruct (level_between (16380 * / 1210 + (-1)) ((-1) * 16380 * / 17480 + 1) (0) (3203 / 1000000) (32045 / 10000000))
  as [c [C R]]; try lra; [interval | split; unfold plain; measured; interval |].
exists c; split; [exact R | apply Rabs_le; lra].
