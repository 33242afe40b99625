"""Extremals through time: the canonical equations flown, with tangents and switches, and tabulated."""
