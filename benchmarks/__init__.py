"""Measurements beside peers, in one run; nothing here passes or fails by the clock."""
