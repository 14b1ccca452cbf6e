intros P a b e Q D E F A B B1 N1 N2 N3.
pose proof (claim_share_above a b e D E F A B) as S.
rewrite Q, (turn_of_share a b e A B).
apply Rplus_lt_compat_l, atan_increasing, Rmult_lt_compat_l; [apply sqrt_lt_R0; positive |].
apply S; try assumption.
assert (0 < b * / a) by positive; pose proof (pow2_ge_0 (sin e)); nra.
