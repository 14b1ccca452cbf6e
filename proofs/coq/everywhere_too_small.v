destruct (defect_exists 1600 1
  (1957204157227700711187195148732972866155089723234412734194748261827178197706731398566196904794380585751854194652097792688357539051590246 / 10 ^ 190)
  (1957204157227700711187195148732972866155089723234412734194748261827178197706731398566196904794380585751854194652097792688357539051590247 / 10 ^ 190)) as [e [[L U] E]];
  [lra | lra | lra | apply not_below; unfold turn_short; interval with (i_prec 1000)
  | unfold turn_short; interval with (i_prec 1000) |].
exists 1600, 1, e, (2 * sqrt (1600 * / (1600 + 1)) * exp ((-1) * sqrt (1600 * 1) * (PI + asin (sqrt (1 * / (1600 + 1)))))).
split; [exact E |]; repeat (split; [first [reflexivity | numeric] |]); inverse_sines.
apply above; interval with (i_prec 1000).
