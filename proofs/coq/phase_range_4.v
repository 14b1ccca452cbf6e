intros; pose proof (asin_bound (sqrt (b * / (a + b)) * cos epsilon0)); lra.
