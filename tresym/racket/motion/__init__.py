"""The motion: exact solutions, trajectories, and integrals."""
