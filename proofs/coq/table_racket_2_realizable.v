exists 1319, 14445, 16175; do 6 (split; [lra |]); intros [H _]; lra.
