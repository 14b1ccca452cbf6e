cbv beta; rewrite Rmult_0_l, asin_0; ring.
