cbv beta; replace ((-1) * 0 ^ 2 + 1) with 1 by ring.
replace ((-1) * 0 ^ 2 * cos 0 ^ 2 + 1) with 1 by ring; rewrite sqrt_1, cos_0; field.
