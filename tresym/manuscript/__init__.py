"""A manuscript of one's own: its displays, what kind each link of them is, and its status."""
