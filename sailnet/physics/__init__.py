"""Eqs. (1) to (19): motion, costates, guidance law, extremals. Nothing here reads or writes files."""
