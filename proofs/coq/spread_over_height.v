intros v_H P.
replace ((1 / 12) * v_H ^ 2) with ((fun x : R => / v_H * (x ^ 3 / 3)) ((1 / 2) * v_H) - (fun x : R => / v_H * (x ^ 3 / 3)) (((-1) / 2) * v_H)) by (field; lra).
apply (is_RInt_derive (fun x : R => / v_H * (x ^ 3 / 3)) (fun x : R => / v_H * x ^ 2)); intros x _.
{ eapply d_eq; [derive; lra | tidy; field; lra]. }
{ continues. }
