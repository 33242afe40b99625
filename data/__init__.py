"""Generation of optimal trajectories: from a mission to an HDF5 data set."""
