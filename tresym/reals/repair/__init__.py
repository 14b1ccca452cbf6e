"""What is true instead of a refuted claim: a repair by one edit, a condition, or the right value."""
