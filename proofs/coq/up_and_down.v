intros a b -> -> N1 N2 N3 N4 N5; pose proof pi_between as J.
pose (F := fun m n x : R => / (sqrt (m * (1 / 2 + 10 * sin x ^ 2) + 10 * (1 / 2) * cos x ^ 2)) * / (10 + 1 / 2 * sin x ^ 2 + m * cos x ^ 2)
  * (cos x ^ 2 * ((-1) * (1 / 2) + 1) * (10 + m) + n * sin x ^ 2 * (10 + 1 / 2))).
assert (root : forall m n l h : R, 0 < m -> m < 1 / 2 -> n = 1 - m -> 0 < l -> l <= h -> h < 24 ->
  RInt (F m n) 0 l < PI < RInt (F m n) 0 h ->
  exists x, l <= x <= h /\ is_root (fun y : R => RInt (F m n) 0 y + (-1) * PI) 0 (8 * PI) x).
{ intros m n l h M M' -> l0 H h0 [U V]; assert (L : - (1 / 2) < - m) by lra; assert (G : - m < 0) by lra.
  assert (E : forall y, RInt (F m (1 - m)) 0 y = RInt (u_rate 10 (1 / 2) (- m)) 0 y).
  { intros y; apply RInt_ext; intros x _; unfold F, u_rate, u_root, u_under, u_over.
    match goal with |- / sqrt ?p * / ?q * ?n = / sqrt ?r * / ?s * ?k =>
      replace p with r by ring; replace q with s by ring; replace n with k by ring; reflexivity end. }
  destruct (root_exists (fun y => RInt (u_rate 10 (1 / 2) (- m)) 0 y + (-1) * PI) l h H) as [x [X R]].
  - intros y _; apply (continuous_plus (fun y => RInt (u_rate 10 (1 / 2) (- m)) 0 y) (fun _ => (-1) * PI)); [| apply continuous_const].
    apply (continuous_derive _ _ _ (u_phase_by_end 10 (1 / 2) ltac:(lra) ltac:(lra) (- m) y G)).
  - rewrite E in U, V; nra.
  - exists x; split; [exact X |]; split; [split; [lra | rewrite E; exact R] |]; intros y _ Y; rewrite E in Y.
    apply (u_phase_once 10 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) (- m) y x L G ltac:(lra)); lra. }
destruct (root (7 / 15) (8 / 15) (1365 / 100) (1375 / 100)) as [p [P R1]]; try lra.
{ unfold F; split; estimated; interval. }
destruct (root (19 / 60) (41 / 60) (1075 / 100) (1085 / 100)) as [q [Q R2]]; try lra.
{ unfold F; split; estimated; interval. }
destruct (root (3 / 20) (17 / 20) (77 / 10) (78 / 10)) as [r [R R3]]; try lra.
{ unfold F; split; estimated; interval. }
destruct (root (1 / 60) (59 / 60) (45 / 10) (46 / 10)) as [s [S R4]]; try lra.
{ unfold F; split; estimated; interval. }
split; [exists p, q | split; [exists r, q | exists r, s]];
  (split; [first [exact R1 | exact R3] | split; [first [exact R2 | exact R4] | apply Rminus_lt; interval]]).
