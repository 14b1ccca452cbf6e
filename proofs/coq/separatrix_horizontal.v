intros; cbv beta; rewrite sqrt_0; ring.
