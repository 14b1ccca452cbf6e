"""How a claim, its conditions and its chain are written."""
