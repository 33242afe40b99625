"""Files that are whole or not there, and say where they come from."""
