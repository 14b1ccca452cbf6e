intros p a b e _ _ _ D A B B1; pose proof PI_RGT_0 as P.
assert (R0 : 0 < b * / a) by positive; assert (AB : 0 < a * b) by positive.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact AB); set (k := sqrt (a * b)) in *.
assert (Q : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact R0); set (r := sqrt (b * / a)) in *.
set (u := atan (r * tanh (PI * k))) in *; set (x := k * (PI + u)) in *; set (v := atan (r * tanh x)) in *.
assert (T : 0 < tanh (PI * k)) by (rewrite <- tanh_0; apply increasing_tanh; nra).
assert (U : 0 < u) by (apply atan_above; nra).
assert (X : PI * k < x) by (unfold x; nra).
assert (V : u < v) by (apply atan_increasing, Rmult_lt_compat_l; [exact Q | apply increasing_tanh; exact X]).
pose proof (sinh_pos x ltac:(nra)) as S; pose proof (cosh_pos x) as C.
assert (M : 0 < (-1) * b + sinh x ^ 2 * (b * / a + 1) + 1) by (assert (0 < sinh x ^ 2) by nra; nra).
assert (N : 0 < cosh x ^ 2 + b * / a * sinh x ^ 2) by nra.
assert (I := Rinv_0_lt_compat _ M); set (m := / (_ + 1)) in *; set (n := cosh x ^ 2 + _) in *.
assert (0 < m * n) by nra; assert (0 < m * n * (v - u)) by nra; pose proof pi_between; nra.
