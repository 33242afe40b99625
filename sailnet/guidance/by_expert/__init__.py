"""Guidance by the expert itself, flown beside the networks: what guidance could get at all."""
