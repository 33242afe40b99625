"""Shooting where no guess is near: from far away, and from many random starts."""
