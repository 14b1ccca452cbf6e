intros H I1 I2 I3 L W m E_1 E_2 E_3 M P Q S T U.
pose proof (claim_spread_over_length L P); pose proof (claim_spread_over_width W Q).
pose proof (claim_spread_over_height H S).
repeat split; eexists; eexists; (split; [eassumption | split; [eassumption | lra]]).
