"""The motion itself: exact solutions, trajectories and integrals of it."""
