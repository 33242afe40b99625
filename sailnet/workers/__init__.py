"""Processes and clusters that share work, and what Ctrl-C does to them."""
