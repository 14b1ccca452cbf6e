"""How claims, conditions and derivations are typeset."""
