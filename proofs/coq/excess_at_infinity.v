cbv beta; rewrite !Rplus_0_l, Rmult_0_l, asin_0; destruct floor_angles as [F [_ P]].
replace ((-1) * 0 ^ 2 + 1) with 1 by ring; rewrite sqrt_1, <- F.
replace (1 * / sin _ * _) with (sinh PI) by (field; lra); rewrite arcsinh_sinh; field.
