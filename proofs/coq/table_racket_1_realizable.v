exists 886, 16336, 18270; do 6 (split; [lra |]); intros [H _]; lra.
