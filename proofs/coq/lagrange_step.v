intros H1 H2 W1 W2 n p q G N_1 N_2.
assert (0 < p + 0 * W1 * p * q) by lra.
exists ((Rpower p n * n * W1 * q) * H1 * W1 + Rpower p n * (H2 * W1 * p) * W1 + Rpower p n * H1 * (W2 * p + q * W1 ^ 2)),
  ((Rpower p n * n * W1 * q) * H1 * W1 + Rpower p n * (H2 * W1 * p) * W1 + Rpower p n * H1 * (W2 * p + q * W1 ^ 2)).
assert (X : Rpower p (n + 1) = p * Rpower p n) by (rewrite Rpower_plus, Rpower_1 by lra; ring).
split; [| split]; [| | reflexivity].
- eapply d_eq; [derive; lra |]; cbv beta; rewrite !Rmult_0_r, !Rmult_0_l, !Rplus_0_r; field; lra.
- eapply d_eq; [derive; lra |]; cbv beta; rewrite !Rmult_0_r, !Rmult_0_l, !Rplus_0_r, X; field; lra.
