intros a b x g A B C L G P T S; exists (RInt (u_growth a b g) 0 x); split.
{ apply (u_phase_by_level a b A B g x); lra. }
{ apply Rlt_gt, (u_phase_rises a b A B C g x); lra. }
