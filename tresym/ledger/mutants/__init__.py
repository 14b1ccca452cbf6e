"""False variants of the claims, none of which may pass."""
