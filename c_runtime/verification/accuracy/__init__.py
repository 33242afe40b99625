"""Accuracy of the whole command of the flight runtime, against references of higher precision."""
