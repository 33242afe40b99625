"""Guidance that tracks the optimal extremal: a plan that Newton's method keeps at the state of the sail."""

TRACKER = "tracker"
"""Its name on the command line."""
