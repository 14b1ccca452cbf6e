exists 1210, 16380, 17480, 1, 1, 0, 0, (/ 1210), 0, 0, (16380 * / 1210 + (-1)), ((-1) * 16380 * / 17480 + 1), (/ 1210), 0, 0, 0, 0, 0.
rewrite cos_0, sin_0; do 11 (split; [field |]); do 8 (split; [lra |]).
eexists; split; [integrated | estimated; interval].
