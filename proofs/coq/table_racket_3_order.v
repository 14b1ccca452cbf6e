exists 448, 7126, 1818; do 6 (split; [lra |]); intros [_ H]; lra.
