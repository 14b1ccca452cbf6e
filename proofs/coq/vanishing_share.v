intros a b e A B G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10.
set (T := sqrt (a * b) * _) in *; set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *.
assert (W : w ^ 2 = b * / a * sin e ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (P : 0 < w) by (apply sqrt_lt_R0; exact N_6).
apply (Rmult_eq_reg_l (/ w * cos e + tanh T)); [| exact N_10].
rewrite <- (Rmult_assoc _ (/ _)), Rinv_r, Rmult_1_l by exact N_10.
replace ((/ w * cos e + tanh T) * ((-1) * / w * cos e + tanh T)) with (tanh T ^ 2 - cos e ^ 2 * / w ^ 2)
  by (field; lra).
assert (Z : tanh T ^ 2 = 1 + (-1) * / cosh T ^ 2).
{ unfold tanh; pose proof (cosh_square T) as C; pose proof (cosh_pos T).
  replace ((sinh T / cosh T) ^ 2) with (sinh T ^ 2 * / cosh T ^ 2) by (field; lra).
  replace (sinh T ^ 2) with (cosh T ^ 2 - 1) by lra; field; lra. }
rewrite Z, W; pose proof (sin_square e) as Q; pose proof (cosh_pos T); set (c := cos e) in *; set (s := sin e) in *.
assert (I : cos e ^ 2 = 1 - s ^ 2) by (unfold s; rewrite sin_square; ring); fold c in I; rewrite I.
pose proof (reach a b A B e) as H1; fold s in H1; field; repeat split; lra.
