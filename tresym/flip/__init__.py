"""flip."""
