exists 1, 7126, 8118, 1, ((-1) * 7126 * / 8118 + 1); repeat split; lra.
