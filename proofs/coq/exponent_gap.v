intros a b e; intros; destruct (exponent_parts a b e) as [w [W [V L]]]; try lra; rewrite arcsinh_law.
set (x := sqrt (a * / (a + b)) * / sin e * cos e) in *.
assert (C : sqrt (x ^ 2 + 1) = (w + / w) / 2).
{ pose proof (Rinv_0_lt_compat w W); apply sqrt_unique; [lra |].
  replace x with ((w - / w) / 2) by (rewrite V; unfold x; field; lra); field; lra. }
rewrite C; replace (x + (w + / w) / 2) with w by (replace x with ((w - / w) / 2)
  by (rewrite V; unfold x; field; lra); field; lra); lra.
