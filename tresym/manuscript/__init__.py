"""Read a LaTeX manuscript and give every link of its displays a status."""
