"""Tracking of the optimal extremal: a plan that Newton's method keeps at the state of the sail."""
