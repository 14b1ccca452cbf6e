"""False variants of the claims: none may hold."""
