intros a b e s D E E0 E1 A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (ratio_of_leading a b e s (117 / 250)); [lra | lra | lra | lra | exact D | lra |].
ratio_part (117 / 250) a b e E 5 (25010580 / 100000000) 1 (454864 / 10000000) (206922 / 100000000) (466873 / 1000000) (90376 / 1000000).
ratio_rest_part (117 / 250) a b e 5 (25010580 / 100000000) (119987 / 1000000) (90267 / 10000000).
