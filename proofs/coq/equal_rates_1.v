intros; replace (sin (PI + (-1) * psi)) with (sin psi); [reflexivity |].
replace (PI + (-1) * psi) with (PI - psi) by ring; symmetry; apply sin_PI_x.
