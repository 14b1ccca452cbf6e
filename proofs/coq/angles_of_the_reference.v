exists 1, 0, (PI / 2); rewrite sin_0, cos_0, sin_PI2; intros [H _]; lra.
