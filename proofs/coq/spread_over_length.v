intros v_L P.
replace ((1 / 12) * v_L ^ 2) with ((fun x : R => / v_L * (x ^ 3 / 3)) ((1 / 2) * v_L) - (fun x : R => / v_L * (x ^ 3 / 3)) (((-1) / 2) * v_L)) by (field; lra).
apply (is_RInt_derive (fun x : R => / v_L * (x ^ 3 / 3)) (fun x : R => / v_L * x ^ 2)); intros x _.
{ eapply d_eq; [derive; lra | tidy; field; lra]. }
{ continues. }
