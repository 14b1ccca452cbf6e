exists (51 / 5000); do 2 (split; [lra |]); do 2 eexists; do 2 (split; [integrated |]).
measured; interval.
