"""Campaigns: thousands of flights from a TOML file, into an HDF5 file, resumable."""
