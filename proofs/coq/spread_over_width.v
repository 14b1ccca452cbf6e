intros v_W P.
replace ((1 / 12) * v_W ^ 2) with ((fun x : R => / v_W * (x ^ 3 / 3)) ((1 / 2) * v_W) - (fun x : R => / v_W * (x ^ 3 / 3)) (((-1) / 2) * v_W)) by (field; lra).
apply (is_RInt_derive (fun x : R => / v_W * (x ^ 3 / 3)) (fun x : R => / v_W * x ^ 2)); intros x _.
{ eapply d_eq; [derive; lra | tidy; field; lra]. }
{ continues. }
