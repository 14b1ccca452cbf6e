set (a := 16380 * / 1210 + (-1)); set (b := (-1) * 16380 * / 17480 + 1).
assert (A : a = 1517 / 121) by (unfold a; field); assert (B : b = 55 / 874) by (unfold b; field).
assert (A0 : a > 0) by lra; assert (B0 : b > 0) by lra.
destruct (defect_exists a b (11494 / 10 ^ 5) (11495 / 10 ^ 5)) as [e [[L U] E]];
  [lra | lra | lra | apply not_below; rewrite A, B; unfold turn_short; interval with (i_prec 90)
  | rewrite A, B; unfold turn_short; interval with (i_prec 90) |].
set (T := RInt (plain a b 1) (1 / 3) (1 / 2 * PI)).
assert (P : 0 < T) by (unfold T, plain; rewrite A, B; measured; interval).
assert (S : 0 < PI * / T) by positive.
assert (R : is_RInt (rate (PI * / T) a b 1) (1 / 3) (1 / 2 * PI) PI).
{ assert (V : PI = scal (PI * / T) T) by (change (PI = PI * / T * T); field; lra); rewrite V at 3.
  apply (is_RInt_ext (fun t => scal (PI * / T) (plain a b 1 t))).
  - intros t _; change (PI * / T * plain a b 1 t = rate (PI * / T) a b 1 t); unfold rate, plain; ring.
  - apply (is_RInt_scal (V := R_NormedModule)), integral_correct; intros t _.
    apply (plain_continuous a b A0 B0); pose proof (pow2_ge_0 (sin t)); nra. }
exists (/ 16380), (RInt (zero_rate (PI * / T) a b) (1 / 3) (1 / 2 * PI)), 1210, 16380, 17480, 1, (PI * / T).
exists a, b, (1 / 3), e, (2 * / 16380 * 16380 * / 1 ^ 2 + (-1)).
do 3 (split; [reflexivity |]); split; [exact E |]; do 2 (split; [numeric |]).
replace (2 * / 16380 * 16380 * / 1 ^ 2 + (-1)) with 1 by field; split; [exact R |]; split.
{ apply integral_correct, (zero_on (PI * / T) a b A0 B0); interval. }
clear R; rewrite A, B; clear E; repeat (split; [first [lra | numeric] |]); numeric.
