destruct (defect_exists 1 (1 / 100) (125730207208601765367954883 / 10 ^ 26) (125730207208601765367954886 / 10 ^ 26))
  as [e [[L U] E]]; [lra | lra | lra | unfold turn_short; apply not_below; interval with (i_prec 300)
  | unfold turn_short; interval with (i_prec 300) |].
exists 1, (1 / 100), e; pose proof PI_RGT_0.
assert (e < 1 / 2 * PI) by (apply (Rle_lt_trans _ _ _ U); interval).
repeat split; first [exact E | lra].
