intros; match goal with H : atan _ = _ |- _ => symmetry; exact H end.
