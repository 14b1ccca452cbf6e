intros; do 2 f_equal; rewrite Rmult_assoc; f_equal.
replace (v_P * sqrt (a * b)) with (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos epsilon0)))
  by (subst v_P; ring).
match goal with H : tanh _ = _ |- _ => symmetry; exact H end.
