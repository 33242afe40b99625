"""Training of the guidance networks: HDF5 data set in, network files and histories out."""
