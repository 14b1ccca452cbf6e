exists (21 / 5), (1517 / 121), (55 / 874), (1 / 100), (47 / 50); do 4 (split; [lra |]); split.
{ measured; interval. }
replace (21 / 5 + 47 / 50) with (257 / 50) by lra; eexists; split; [integrated | measured; interval].
